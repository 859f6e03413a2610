// A disc that is stretched into an ellipse: free particles against Dirichlet's solution.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/gauss_pressure.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_drop_test {

using namespace gauss_particles;
using namespace mechanics;
using exact::StretchingDrop;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 6.3; Dirichlet (1860)";

struct Errors {
  double rms, largest, surface;
};

/// Distances from the exact places at t = 2; the disc has radius 1, u = (x, -y).
template <template <class> class Step>
Errors errors(const Particles& particles, std::unique_ptr<FieldSpace> space, double tau) {
  const StretchingDrop drop(1, 1, 1);
  Model model(particles, std::move(space), {.gravity = 0, .penalty = 0});
  State state = model.state([](Point r) { return Point{r.x, -r.y}; });
  Step<Model> step(model);
  for (long k = 0; k < std::lround(2 / tau); ++k) step.step(state, tau);
  Mean inside;
  Worst largest, surface;
  for (std::size_t k = 0; k < model.size(); ++k) {
    const double distance = std::hypot(state.q[k] - drop.semi_axis(2) * particles.x[k],
                                       state.q[model.size() + k] - drop.other_axis(2) * particles.y[k]);
    if (particles.mass[k] > 0) {
      inside.add(distance, particles.mass[k]);
      largest.add(distance);
    } else {
      surface.add(distance);
    }
  }
  return {inside.rms(), largest.value(), surface.value()};
}

Particles four() {
  Particles particles;
  for (int k = 0; k < 4; ++k) {
    const double angle = 0.3 + k * std::numbers::pi / 2;
    particles.add(std::cos(angle), std::sin(angle), 1);
  }
  return particles;
}

TEST_CASE("particles with all linear fields follow Dirichlet's ellipse, however few", "[manufactured]") {
  Check check("gauss_particles_linear_fields", "Free particles with linear fields: Dirichlet's ellipse",
              "With the five linear solenoidal fields and isotropic second moments the particles move on the exact "
              "paths but for the error in time: of second order with the conservative scheme, for 300 particles and "
              "for 4, of first order with Frank's projection scheme.",
              source);
  const auto order = [](double theory) {
    return Order{theory, 0.01,
                 "nothing else errs, and the next term is tau (projection scheme) or tau^2 of the first: 0.01 of an "
                 "order over this range"};
  };
  refine(check, {"step", {0.04, 0.02, 0.01, 0.005}},
         {{"conservative", "Conservative scheme, 300 particles: second order.", order(2)},
          {"four-particles", "Conservative scheme, 4 particles: second order.", order(2)},
          {"projection-scheme", "Frank's projection scheme converges at first order in the step.", order(1)}},
         [](double tau) {
           const auto space = [] { return std::make_unique<PolynomialSpace>(); };
           return std::array{errors<OneStep>(disc(1, 10), space(), tau).largest,
                             errors<OneStep>(four(), space(), tau).largest,
                             errors<ProjectedStep>(disc(1, 10), space(), tau).largest};
         });
}

TEST_CASE("a stretched disc on splines with cut cells", "[manufactured]") {
  Check check(
      "gauss_particles_ellipse", "Free particles on splines: the stretched disc",
      "The same disc with cubic splines on cells of 0.4 by 0.2, most of them cut by the surface. The fields are in the "
      "space, so that the splines add nothing but the error of sums over particles: with enough of these what is left "
      "is the error of the steps, which is that of the five linear fields. The markers stay on the surface.");
  constexpr double tau = 0.01;
  const Errors steps = errors<OneStep>(disc(1, 20, 64), std::make_unique<PolynomialSpace>(), tau);
  for (const std::size_t rings : {20, 40, 80}) {
    const Particles particles = disc(1, rings, 64);
    const Errors e =
        errors<OneStep>(particles,
                        std::make_unique<SplineSpace>(LatticePlan{.degree = 3, .cell_x = 0.4, .cell_y = 0.2},
                                                      SplineSpace::Settings{.inner_fraction = 0.4}),
                        tau);
    check.holds(fmt::format("{} rings: the markers stay on the surface.", rings), {e.surface},
                Bound{0.01 / static_cast<double>(rings),
                      "a hundredth of the spacing of the rings, below which particles do not tell where a surface is; "
                      "splines that are not continued at cut cells err by a third of the spacing and more"});
    if (rings == 20) continue;  // sums over 30 particles to a cell err by as much as the steps and more
    check.holds(fmt::format("The error of the splines is below the error of the steps ({} rings).", rings),
                {e.rms / steps.rms},
                Bound{2, "as much again: an error budget of which steps and splines have equal parts"});
  }
}

TEST_CASE("the pressure at the middle of a stretched disc", "[manufactured]") {
  Check check("gauss_particles_pressure", "Free particles: the pressure of the stretched disc",
              "The reactions of the step about t = 1 are fitted by (1 - x^2/a^2 - y^2/b^2) times a quadratic "
              "polynomial: the pressure at the middle against Dirichlet's.");
  const StretchingDrop drop(1, 1, 1);
  for (const int degree : {3, 2}) {
    constexpr double tau = 0.005;
    Model model(disc(1, 20),
                std::make_unique<SplineSpace>(LatticePlan{.degree = degree, .cell_x = 0.4, .cell_y = 0.2},
                                              SplineSpace::Settings{.inner_fraction = 0.4}),
                {.gravity = 0, .penalty = 0});
    State state = model.state([](Point r) { return Point{r.x, -r.y}; });
    OneStep<Model> step(model);
    for (int k = 0; k < 200; ++k) step.step(state, tau);
    const double time = state.time - tau / 2;
    const double a = drop.semi_axis(time);
    const double b = drop.other_axis(time);
    const PressureFit fit(
        model, tau,
        [=](Point r) {
          return Level{1 - r.x * r.x / (a * a) - r.y * r.y / (b * b), {-2 * r.x / (a * a), -2 * r.y / (b * b)}};
        },
        2);
    const double exact = drop.at(time).central_pressure;
    check.holds(fmt::format("Splines of degree {}: the pressure at the middle.", degree),
                {fit.pressure({0, 0}) / exact - 1},
                Bound{0.1 / std::sqrt(1200.0),
                      "what a lattice leaves in the gradients, up to a tenth of them, is of either sign: a mean over "
                      "1200 particles"});
  }
}

}  // namespace seiche::verification::gauss_particles_drop_test
