#include "seiche/exact/gerstner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/tools/roots.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace {

using std::numbers::pi;

}  // namespace

GerstnerWave::GerstnerWave(double wavelength, double gravity, double top) : gravity_(gravity), top_(top) {
  require_all_positive({{"wavelength", wavelength}, {"gravity", gravity}});
  require_within("top", top, -std::numeric_limits<double>::max(), 0);
  wavenumber_ = 2 * pi / wavelength;
  frequency_ = std::sqrt(gravity * wavenumber_);
}

void GerstnerWave::require_below_top(Label label) const {
  require_finite("a", label.a);
  require_that<OutsideFluid>(label.b <= top_,
                             "label b = {:.17g} is outside the fluid: must be at most {:g}, that of the surface",
                             label.b, top_);
}

GerstnerWave::Vector GerstnerWave::turned(Label label, double t, double size) const {
  require_below_top(label);
  const double phase = wavenumber_ * label.a - frequency_ * t;
  return {size * std::sin(phase), size * std::cos(phase)};
}

GerstnerWave::Vector GerstnerWave::position(Label label, double t) const {
  const auto [sine, cosine] = turned(label, t, radius(label.b));
  return {label.a - sine, label.b + cosine};
}

Velocity GerstnerWave::velocity(Label label, double t) const {
  const auto [sine, cosine] = turned(label, t, frequency_ * radius(label.b));
  return {cosine, sine};
}

GerstnerWave::Vector GerstnerWave::acceleration(Label label, double t) const {
  const auto [sine, cosine] = turned(label, t, gravity_ * std::exp(wavenumber_ * label.b));
  return {sine, -cosine};
}

double GerstnerWave::pressure(Label label) const {
  require_below_top(label);
  // (e^{2kb} - e^{2k top})/(2k) without its cancellation near the surface
  const double fall = std::exp(2 * wavenumber_ * top_) * std::expm1(2 * wavenumber_ * (label.b - top_));
  return gravity_ * (top_ - label.b + 0.5 * fall / wavenumber_);
}

double GerstnerWave::area_factor(Label label) const {
  require_below_top(label);
  return -std::expm1(2 * wavenumber_ * label.b);
}

double GerstnerWave::phase_at(double x, double b, double t) const {
  // Kepler's equation p - e sin p = m with eccentricity e = e^{kb} <= 1; the root lies in [m, m + e] for 0 <= m <= pi.
  const double mean = std::remainder(wavenumber_ * x - frequency_ * t, 2 * pi);
  const double e = std::exp(wavenumber_ * b);
  const double m = std::abs(mean);
  const double guess = std::min(pi, m + e * std::sin(m) / (1 - std::sin(m + e) + std::sin(m)));
  const double highest = m + e + epsilon * (1 + m);  // deep down e is below the rounding of m
  const double p = boost::math::tools::newton_raphson_iterate(
      [&](double q) { return std::pair(q - e * std::sin(q) - m, 1 - e * std::cos(q)); }, std::clamp(guess, m, highest),
      m, highest, std::numeric_limits<double>::digits);
  return std::copysign(p, mean);
}

double GerstnerWave::elevation(double x, double t) const {
  require_finite("x", x);
  require_finite("t", t);
  return top_ + radius(top_) * std::cos(phase_at(x, top_, t));
}

GerstnerWave::Label GerstnerWave::label(double x, double y, double t) const {
  const double surface = elevation(x, t);
  // A surface particle's own place must not fail for the rounding of x and of the phase, whatever the slope.
  const double rounding = 8 * epsilon * (std::abs(x) + phase_speed() * std::abs(t) + 1 / wavenumber_ + std::abs(top_));
  const auto outside = [&] {
    return !(y <= std::max({surface, elevation(x - rounding, t), elevation(x + rounding, t)}) + rounding);
  };
  require_that<OutsideFluid>(
      y <= surface || !outside(),
      "y = {:.17g} is outside the fluid: must be at most {:.17g}, the surface at x = {:g}, t = {:g}", y, surface, x, t);
  double b = top_;
  if (y < surface) {
    // y grows with b at fixed x: dy/db = J/(1 - e^{kb} cos p).
    const double lowest = y - radius(std::min(top_, y + 1 / wavenumber_)) - 4 * epsilon * std::abs(y);
    b = boost::math::tools::newton_raphson_iterate(
        [&](double trial) {
          const double phase = phase_at(x, trial, t);
          const double e = std::exp(wavenumber_ * trial);
          const double slope =
              -std::expm1(2 * wavenumber_ * trial) / std::max(1 - e * std::cos(phase), epsilon);  // 0/0 at the cusp
          return std::pair(trial + radius(trial) * std::cos(phase) - y, slope);
        },
        std::clamp(y, lowest, top_), lowest, top_, std::numeric_limits<double>::digits);
  }
  return {x + radius(b) * std::sin(phase_at(x, b, t)), b};
}

SelfTest GerstnerWave::self_test() const {
  const double wavelength = 2 * pi / wavenumber_;
  const double t = 0.3 / frequency_;
  constexpr std::array below{0.0, 0.03, 0.1, 0.4};
  const auto over_particles = [&](auto defect) {
    return worst(0, 95, [&](int i) {
      const Label particle{wavelength * (i / 4) / 24, top_ - below[static_cast<std::size_t>(i % 4)] * wavelength};
      return defect(particle, position(particle, t));
    });
  };
  const double bernoulli = over_particles([&](Label particle, Vector place) {
    const Velocity flow = velocity(particle, t);
    // Steady in the frame of the wave: q^2/2 + g y + p is constant along b, and known.
    const double relative = flow.u - phase_speed();
    const double head = 0.5 * (relative * relative + flow.v * flow.v) + gravity_ * place.y;
    const double expected =
        gravity_ * particle.b + 0.5 * gravity_ / wavenumber_ * (1 + std::exp(2 * wavenumber_ * particle.b));
    return (head - expected) / (gravity_ * wavelength);
  });
  const double inverse = over_particles([&](Label, Vector place) {
    const Vector back = position(label(place.x, place.y, t), t);
    return std::hypot(back.x - place.x, back.y - place.y) / wavelength;
  });
  // Area between two lines of particles: shoelace over equally spaced labels, exact for trigonometric polynomials.
  const double lower = top_ - 0.25 * wavelength;
  const auto area_above_axis = [&](double b) {
    constexpr int points = 16;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const Label particle{wavelength * i / points, b};
      const double x_a = 1 - wavenumber_ * (position(particle, t).y - b);
      sum += position(particle, t).y * x_a;
    }
    return sum * wavelength / points;
  };
  const double area = area_above_axis(top_) - area_above_axis(lower);
  const double labels = wavelength * (top_ - lower +
                                      0.5 / wavenumber_ * std::exp(2 * wavenumber_ * top_) *
                                          std::expm1(2 * wavenumber_ * (lower - top_)));
  const double reach = 1 + std::abs(top_) / wavelength;
  // The line below lies at top - L/4, the mean of y x_a up to L/(4 pi) under the labels of either.
  const double area_limit = 4 * epsilon * std::sqrt(32.0 / 3 + 10) * (1.0 / 3 + std::abs(top_) / wavelength);
  return {
      {"Bernoulli's head along a line of particles", bernoulli, 4e-15 * reach, "18 ulp for 15 roundings"},
      {"position(label(x, y)) = (x, y)", inverse, 4e-15 * reach, "Newton's method ends within a few ulp of x and y"},
      {"area between two lines of particles = integral of J", std::abs(area - labels) / (wavelength * wavelength),
       area_limit,
       "two sums of 16 terms that grow to L (L/3 + |top|), the mean square of their sizes a third of that; 10 "
       "roundings of the difference and the closed form"}};
}

ExactSolution gerstner_entry() {
  return Entry<GerstnerWave>{
      .name = "gerstner",
      .title = "Gerstner's rotational wave in deep water: every particle moves on a circle",
      .citation = "Gerstner, Theorie der Wellen (1804); Lamb, Hydrodynamics (1932), section 251",
      .formula =
          "x = a - e^{kb} sin(ka - omega t)/k, y = b + e^{kb} cos(ka - omega t)/k, omega^2 = g k, p = g (b0 - b) + g "
          "(e^{2kb} - e^{2k b0})/(2k)",
      .parameters = {wavelength_parameter(),
                     gravity_parameter(),
                     {"top", "m", -0.5, -1e6, 0, "label b of the surface; 0 is the cusped wave"}},
      .inputs = {position_x, height_y, time_t},
      .outputs = {surface_eta,
                  velocity_u,
                  velocity_v,
                  pressure_p,
                  {"a", "m", "label: centre of the particle's circle, along x"},
                  {"b", "m", "label: centre of the particle's circle, along y"}},
      .scalars = {{"c", "m/s", "phase speed", &GerstnerWave::phase_speed},
                  {"omega", "1/s", "angular frequency", &GerstnerWave::frequency},
                  {"height", "m", "crest above trough", &GerstnerWave::height}},
      .make = from<GerstnerWave>("wavelength", "gravity", "top"),
      .row = [](const GerstnerWave& wave, At at) {
        const double eta = wave.elevation(at[0], at[2]);
        const auto label = wave.label(at[0], std::isnan(at[1]) ? eta : at[1], at[2]);
        const auto velocity = wave.velocity(label, at[2]);
        return Row{eta, velocity.u, velocity.v, wave.pressure(label), label.a, label.b};
      }};
}

}  // namespace seiche::exact
