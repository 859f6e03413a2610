#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/model_waves.hpp"
#include "seiche/samples.hpp"
#include "verification/self_test_claims.hpp"

namespace serre_cnoidal_test {

using namespace seiche;
using exact::SerreCnoidal;
using namespace seiche::verification;

constexpr double pi = std::numbers::pi;
const std::string source = "Serre, Houille Blanche 8 (1953) 374; El, Grimshaw and Smyth, Phys. Fluids 18 (2006) 027104";

/// f'(0) by fourth-order central differences of half-width `span`.
template <class F>
double difference(const F& f, double span) {
  return (8 * (f(0.5 * span) - f(-0.5 * span)) - (f(span) - f(-span))) / (6 * span);
}

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
                            "Of one length, 10 depths: the higher, the "
                            "narrower the crest.")
                    .panel({.x = "x/depth", .y = "elevation/height"});
  for (const double height : {0.02, 0.1, 0.4}) {
    const SerreCnoidal wave(height, 10, 1, 1);
    std::vector<double> x;
    std::vector<double> y;
    for (int i = -200; i <= 200; ++i) {
      x.push_back(0.025 * i);
      y.push_back(wave.elevation(x.back()) / height);
    }
    panel.line("height " + std::to_string(height).substr(0, 4), x, y, Role::exact);
  }
}

TEST_CASE("cnoidal waves satisfy Serre's equations, between linear and solitary ones", "[exact]") {
  Check check("exact_serre_cnoidal", "Periodic waves of Serre's equations",
              "Residual of the equations in space and time; the speed of low waves, the shape of long "
              "ones; the integral of the elevation.");
  check.source(source);
  const SerreCnoidal wave(0.8, 14, 2, 9.81);
  std::vector<double> spans;
  std::vector<double> residuals;
  for (double span = 0.8; span > 0.13; span /= std::numbers::sqrt2) {
    Worst largest;
    for (double x = 0.2; x < 14; x += 0.5) largest.add(residual(wave, x, span));
    spans.push_back(span);
    residuals.push_back(largest.value());
  }
  check.that({.id = "serre",
              .text = "Mass and momentum of Serre's equations balance at fixed places.",
              .quantity = "order of the residual in the width of the differences"},
             observed_order(spans, residuals, 1e-10),
             Order{4, 0.2, "fourth-order differences of an analytic solution"});
  std::vector<double> frames;
  for (const double span : spans) frames.push_back(std::abs(mean_along_surface(wave, span)));
  check.that({.id = "frame",
              .text = "The speed agrees with the frame without mean velocity along the surface.",
              .quantity = "order of the mean in the width of the differences"},
             observed_order(spans, frames, 1e-10), Order{4, 0.2, "fourth-order differences of an analytic solution"});
  const exact::RationalDispersion linear = exact::RationalDispersion::green_naghdi(1, 1);
  Convergence excess;
  for (double height = 0.2; height > 0.02; height /= std::numbers::sqrt2) {
    excess.add(height, SerreCnoidal(height, 2 * pi, 1, 1).phase_speed() - linear.phase_speed(1));
  }
  check.that({.id = "low",
              .text = "The speed of low waves agrees with linear theory.",
              .quantity = "order of the difference in the height"},
             excess.order(),
             Order{2, 0.1, "the speed is even in the amplitude; the next term is a few (H/d)^2 of the first"});
  // Its trough is the still water of solitary waves.
  const SerreCnoidal train(0.3, 30, 1, 1);
  const double trough = train.elevation(15);
  const exact::SerreSolitary solitary(0.3, 1 + trough, 1);
  Worst apart;
  for (double x = 0; x <= 15; x += 0.1) apart.add(train.elevation(x) - trough - solitary.elevation(x));
  const double decay = std::sqrt(0.75 * 0.3 / (1.3 + trough)) / (1 + trough);
  check.that({.id = "long",
              .text = "Long waves are trains of Serre's solitary waves.",
              .quantity = "largest difference of the elevations over the height"},
             {.value = apart.value() / 0.3, .resolution = "wavelength 30 depths"},
             Bound{16 * std::exp(-decay * 30),
                   "halfway to the next crest sech^2 is 4 exp(-kappa L) of each neighbour, by which "
                   "the trough is not still water: twice, for shape and depth"});
  std::vector<double> differences;
  for (const double span : spans) {
    Worst largest;
    for (double x = 0.3; x < 14; x += 0.7) {
      largest.add(difference([&](double d) { return wave.excess_up_to(x + d); }, span) - wave.elevation(x));
      largest.add(difference([&](double d) { return wave.elevation(x + d); }, span) - wave.elevation_slope(x));
    }
    differences.push_back(largest.value());
  }
  check.that({.id = "derivatives",
              .text = "Excess, elevation and slope are derivatives of each other.",
              .quantity = "order of the difference in the width of the differences"},
             observed_order(spans, differences, 1e-12),
             Order{4, 0.2, "fourth-order differences of analytic functions"});
  self_test_holds(check, "steep", wave);
  self_test_holds(check, "train", train);
  CHECK_THROWS_AS(SerreCnoidal(0.2, 2 * pi, 1, 0), std::invalid_argument);
  CHECK_THROWS_AS(SerreCnoidal(0.2, 80, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(SerreCnoidal(1.1, 2 * pi, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(SerreCnoidal(std::nan(""), 2 * pi, 1, 1), std::invalid_argument);
  draw(check);
}

}  // namespace serre_cnoidal_test
