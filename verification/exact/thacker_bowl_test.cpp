#include <array>
#include <cmath>
#include <functional>

#include "seiche/exact/shallow_water/thacker.hpp"
#include "seiche/samples.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::thacker_bowl_test {

using namespace exact;

const std::string source = "Thacker, J. Fluid Mech. 107 (1981) 499; Delestre et al., SWASHES (2013), section 4.2.2";

/// Largest residual of continuity and of both momentum equations at (x, y, t), g = 1, by fourth-order central
/// differences of half-widths `span` in time and 0.02 in space.
template <class Bowl>
double residual(const Bowl& bowl, double x, double y, double t, double span) {
  constexpr double space = 0.02;
  const auto along_x = [&](const auto& f) {
    return difference([&](double d) { return std::invoke(f, bowl.at(x + d, y, t)); }, space);
  };
  const auto along_y = [&](const auto& f) {
    return difference([&](double d) { return std::invoke(f, bowl.at(x, y + d, t)); }, space);
  };
  const auto in_time = [&](const auto& f) {
    return difference([&](double d) { return std::invoke(f, bowl.at(x, y, t + d)); }, span);
  };
  const BowlState s = bowl.at(x, y, t);
  const auto flux_x = [](const BowlState& q) { return q.depth * q.u; };
  const auto flux_y = [](const BowlState& q) { return q.depth * q.v; };
  const double bed_x = difference([&](double d) { return bowl.bed(x + d, y); }, space);
  const double bed_y = difference([&](double d) { return bowl.bed(x, y + d); }, space);
  const double mass = in_time(&BowlState::depth) + along_x(flux_x) + along_y(flux_y);
  const auto carried = [&](auto f) { return in_time(f) + s.u * along_x(f) + s.v * along_y(f); };
  const double momentum_x = carried(&BowlState::u) + along_x(&BowlState::depth) + bed_x;
  const double momentum_y = carried(&BowlState::v) + along_y(&BowlState::depth) + bed_y;
  return worst(std::array{mass, momentum_x, momentum_y});
}

/// Largest distance between a particle carried by the closed form and one carried by Runge-Kutta with the velocity.
template <class Bowl>
double path_error(const Bowl& bowl, exact::PlanePoint start, double end, int steps) {
  exact::PlanePoint p = start;
  const double tau = end / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = n * tau;
    const BowlState a = bowl.at(p.x, p.y, t);
    const BowlState b = bowl.at(p.x + 0.5 * tau * a.u, p.y + 0.5 * tau * a.v, t + 0.5 * tau);
    const BowlState c = bowl.at(p.x + 0.5 * tau * b.u, p.y + 0.5 * tau * b.v, t + 0.5 * tau);
    const BowlState d = bowl.at(p.x + tau * c.u, p.y + tau * c.v, t + tau);
    p.x += tau / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
    p.y += tau / 6 * (a.v + 2 * b.v + 2 * c.v + d.v);
  }
  const exact::PlanePoint there = bowl.carried(start, end);
  return std::hypot(p.x - there.x, p.y - there.y);
}

template <class Bowl>
void claim_residual(Check& check, const std::string& id, const Bowl& bowl) {
  refine(check, {.axis = "time difference", .sizes = falling(1, 5), .title = {}, .floor = 1e-13},
         {{"residual-" + id,
           "The residual of continuity and both momentum equations falls at fourth order in the time difference.",
           {4, 0.2, "fourth-order differences; those in x and y are exact for the solution's polynomials"}}},
         [&](double span) {
           Largest largest;
           for (double t = 0.2; t < bowl.period(); t += 0.9) {
             for (const double x : {-0.3, 0.1, 0.25}) {
               for (const double y : {-0.2, 0.15}) largest.add(residual(bowl, x, y, t, span));
             }
           }
           return largest.value();
         });
}

template <class Bowl>
void claim_paths(Check& check, const std::string& id, const Bowl& bowl) {
  refine(check, {.axis = "step", .sizes = widths(1, {40, 80, 160, 320, 640}), .title = {}, .floor = 1e-14},
         {{"paths-" + id,
           "The closed form of the particle paths agrees at fourth order with Runge-Kutta paths.",
           {4, 0.2, "classical Runge-Kutta of a smooth velocity"}}},
         [&](double step) {
           return path_error(bowl, {0.3, -0.2}, 0.8 * bowl.period(), static_cast<int>(cells_of(1, step)));
         });
}

TEST_CASE("water oscillates in a bowl in 2DH, radially and as a rotating disc", "[exact]") {
  Check check(
      "exact_thacker_bowl", "Oscillations in a paraboloidal bowl",
      "Residual of continuity and momentum on the curved bed by "
      "differences of halving width; volume and energy; particle paths in closed form against the integrated velocity.",
      source);
  const ThackerRadialBowl radial(1, 1, 0.1, 0.8);
  const ThackerPlanarBowl planar(1, 1, 0.1, 0.5);
  claim_residual(check, "radial", radial);
  claim_residual(check, "planar", planar);
  claim_paths(check, "radial", radial);
  claim_paths(check, "planar", planar);
  CHECK(std::abs(radial.shoreline(0) - std::sqrt(0.8)) < 1e-15);
  CHECK(radial.at(0, radial.shoreline(0.7) + 1e-9, 0.7).depth == 0);
  CHECK(planar.at(0.5 + 1 - 1e-9, 0, 0).depth > 0);
  CHECK(planar.at(0.5 + 1 + 1e-9, 0, 0).depth == 0);
}

}  // namespace seiche::verification::thacker_bowl_test
