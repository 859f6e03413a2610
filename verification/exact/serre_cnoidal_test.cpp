#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/model_waves.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::serre_cnoidal_test {

using exact::SerreCnoidal;
using validation::each;
using validation::evenly;

constexpr double pi = std::numbers::pi;
const std::string source = "Serre, Houille Blanche 8 (1953) 374; El, Grimshaw and Smyth, Phys. Fluids 18 (2006) 027104";

/// Residual of Serre's equations h_t + (hu)_x = 0, h (u_t + u u_x + g h_x) + (h^2 D^2 h/3)_x = 0 at x, t = 0, by nested
/// differences in space and time, for which the wave need not be steady: D = d/dt + u d/dx.
double residual(const SerreCnoidal& wave, double x, double span) {
  const double step = span / wave.phase_speed();
  const auto h = [&](double p, double t) { return wave.depth() + wave.elevation(p, t); };
  const auto u = [&](double p, double t) { return wave.depth_averaged_velocity(p - wave.phase_speed() * t); };
  const auto carried = [&](const auto& f, double p, double t) {
    return difference([&](double d) { return f(p, t + d); }, step) +
           u(p, t) * difference([&](double d) { return f(p + d, t); }, span);
  };
  const auto rate = [&](double p, double t) { return carried(h, p, t); };
  const auto dynamic = [&](double p) { return h(p, 0) * h(p, 0) * carried(rate, p, 0) / 3; };
  const double mass = rate(x, 0) + h(x, 0) * difference([&](double d) { return u(x + d, 0); }, span);
  const double momentum =
      h(x, 0) * (carried(u, x, 0) + wave.gravity() * difference([&](double d) { return h(x + d, 0); }, span)) +
      difference([&](double d) { return dynamic(x + d); }, span);
  return std::hypot(mass, momentum);
}

/// Mean over a wavelength of u - (h^3 u_x)_x/(3h), by nested differences.
double mean_along_surface(const SerreCnoidal& wave, double span) {
  const auto h = [&](double x) { return wave.depth() + wave.elevation(x); };
  const auto strain = [&](double x) {
    return std::pow(h(x), 3) * difference([&](double d) { return wave.depth_averaged_velocity(x + d); }, span);
  };
  Mean mean;
  constexpr int points = 64;
  for (int i = 0; i < points; ++i) {
    const double x = wave.wavelength() * i / points;
    mean.add(wave.depth_averaged_velocity(x) - difference([&](double d) { return strain(x + d); }, span) / (3 * h(x)));
  }
  return mean.value();
}

void draw(Check& check) {
  auto& panel = check
                    .figure("waves", "Cnoidal waves of Serre's equations",
                            "The crest width of waves of length 10 h falls with their height.")
                    .panel({.x = "x/depth", .y = "elevation/height"});
  for (const double height : {0.02, 0.1, 0.4}) {
    const SerreCnoidal wave(height, 10, 1, 1);
    const std::vector<double> x = evenly(-5, 5, 401);
    panel.line("height " + std::to_string(height).substr(0, 4), x,
               each(x, [&](double at) { return wave.elevation(at) / height; }), Role::exact);
  }
}

TEST_CASE("cnoidal waves satisfy Serre's equations, between linear and solitary ones", "[exact]") {
  Check check("exact_serre_cnoidal", "Periodic waves of Serre's equations",
              "Residual of the equations in space and time; the speed of low waves, the shape of long ones; the "
              "integral of the elevation.",
              source);
  const SerreCnoidal wave(0.8, 14, 2, 9.81);
  const Order fourth{4, 0.2, "fourth-order differences of an analytic solution"};
  refine(
      check,
      {.axis = "width of the differences", .sizes = falling(0.8, 6, std::numbers::sqrt2), .title = {}, .floor = 1e-10},
      {{"serre", "The mass and momentum balances of Serre's equations hold at fixed positions.", fourth},
       {"frame", "The speed agrees at fourth order with the frame without mean velocity along the surface.", fourth},
       {"derivatives",
        "Excess, elevation and slope are derivatives of each other: the difference falls at fourth order.", fourth}},
      [&](double span) {
        Worst equations, derivatives;
        for (double x = 0.2; x < 14; x += 0.5) {
          equations.add(residual(wave, x, span));
          derivatives.add(difference([&](double d) { return wave.excess_up_to(x + d); }, span) - wave.elevation(x));
          derivatives.add(difference([&](double d) { return wave.elevation(x + d); }, span) - wave.elevation_slope(x));
        }
        return std::array{equations.value(), std::abs(mean_along_surface(wave, span)), derivatives.value()};
      });
  const exact::RationalDispersion linear = exact::RationalDispersion::green_naghdi(1, 1);
  refine(check, {.axis = "height", .sizes = falling(0.2, 7, std::numbers::sqrt2), .title = {}},
         {{"low",
           "The speed of low waves agrees with linear theory.",
           {2, 0.1, "the speed is even in the amplitude; the next term is a few (H/d)^2 of the first"}}},
         [&](double height) { return SerreCnoidal(height, 2 * pi, 1, 1).phase_speed() - linear.phase_speed(1); });
  // Its trough is the still water of solitary waves.
  const SerreCnoidal train(0.3, 30, 1, 1);
  const double trough = train.elevation(15);
  const exact::SerreSolitary solitary(0.3, 1 + trough, 1);
  Worst apart;
  for (double x = 0; x <= 15; x += 0.1) apart.add(train.elevation(x) - trough - solitary.elevation(x));
  const double decay = std::sqrt(0.75 * 0.3 / (1.3 + trough)) / (1 + trough);
  check.that("long", "Long waves are trains of Serre's solitary waves.",
             "largest difference of the elevations over the height",
             {.value = apart.value() / 0.3, .resolution = "wavelength 30 h"},
             Bound{16 * std::exp(-decay * 30),
                   "halfway to the next crest sech^2 is 4 exp(-kappa L) of each neighbour, by which the trough is not "
                   "still water: twice, for shape and depth"});
  draw(check);
}

}  // namespace seiche::verification::serre_cnoidal_test
