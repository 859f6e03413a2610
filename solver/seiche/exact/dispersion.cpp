#include "seiche/exact/dispersion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

AiryDispersion::AiryDispersion(double gravity, double depth) : gravity_(gravity), depth_(depth) {
  require_positive("gravity", gravity);
  if (depth != infinite) require_positive("depth", depth);
}

double AiryDispersion::frequency(double k) const {
  require_positive("wavenumber", k);
  return std::sqrt(gravity_ * k * std::tanh(k * depth_));
}

double AiryDispersion::phase_speed(double k) const {
  require_positive("wavenumber", k);
  return std::sqrt(gravity_ / k * std::tanh(k * depth_));
}

double AiryDispersion::group_speed(double k) const {
  const double twice = 2 * k * depth_;
  const double ratio = twice > 700 ? 0 : twice / std::sinh(twice);  // sinh overflows; the ratio is below 1e-300
  return 0.5 * (1 + ratio) * phase_speed(k);
}

double AiryDispersion::wavenumber(double omega) const {
  require_positive("frequency", omega);
  const double deep = omega * omega / gravity_;
  if (depth_ == infinite) return deep;
  const double nu = deep * depth_;
  double kappa = nu / std::sqrt(std::tanh(nu));  // within 5 %: four steps square that below round-off
  for (int step = 0; step < 4; ++step) {
    const double t = std::tanh(kappa);
    kappa -= (kappa * t - nu) / (t + kappa * (1 - t) * (1 + t));
  }
  return kappa / depth_;
}

double AiryDispersion::wavenumber_of(const WaveScale& wave) const {
  if (const auto* length = std::get_if<Wavelength>(&wave)) {
    require_positive("wavelength", length->value);
    return 2 * std::numbers::pi / length->value;
  }
  return wavenumber(frequency_of(wave));
}

double AiryDispersion::frequency_of(const WaveScale& wave) const {
  if (const auto* period = std::get_if<Period>(&wave)) {
    require_positive("period", period->value);
    return 2 * std::numbers::pi / period->value;
  }
  if (const auto* omega = std::get_if<AngularFrequency>(&wave)) {
    require_positive("frequency", omega->value);
    return omega->value;
  }
  return frequency(wavenumber_of(wave));
}

SelfTest AiryDispersion::self_test() const {
  const double scale = depth_ == infinite ? 1 : depth_;
  SelfTest identities{wavenumber_identity(*this, 1e-4 / scale, 1e3 / scale)};
  // Over infinite depth the group speed is singular at k = 0, out of reach of quadrature: there c_g = c/2.
  if (depth_ == infinite) {
    identities.push_back({"group speed = half the phase speed", std::abs(2 * group_speed(1) / phase_speed(1) - 1),
                          1e-15, "four roundings"});
  } else {
    identities.push_back(group_speed_identity(*this, 6 / scale));
  }
  return identities;
}

RationalDispersion::RationalDispersion(double gravity, double depth, double numerator, double denominator)
    : gravity_(gravity), depth_(depth), numerator_(numerator), denominator_(denominator) {
  require_all_positive({{"gravity", gravity}, {"depth", depth}, {"denominator", denominator}});
  require_within("numerator", numerator, 0, denominator);
}

RationalDispersion RationalDispersion::green_naghdi(double gravity, double depth, double alpha) {
  require_positive("alpha", alpha);
  return {gravity, depth, 0, alpha};
}

RationalDispersion RationalDispersion::nwogu(double gravity, double depth, double a) {
  require_within("A", a, -0.5, -1.0 / 3);
  return {gravity, depth, -(a + 1.0 / 3), -a};
}

RationalDispersion RationalDispersion::madsen_sorensen(double gravity, double depth, double b) {
  require_not_negative("B", b);
  return {gravity, depth, b, b + 1.0 / 3};
}

double RationalDispersion::phase_speed(double k) const {
  require_positive("wavenumber", k);
  const double square = k * depth_ * k * depth_;
  return std::sqrt(gravity_ * depth_ * (1 + numerator_ * square) / (1 + denominator_ * square));
}

double RationalDispersion::group_speed(double k) const {
  const double c = phase_speed(k);
  const double square = k * depth_ * k * depth_;
  // d ln omega/d ln k = 1 + n kappa^2/(1 + n kappa^2) - d kappa^2/(1 + d kappa^2)
  return c * (1 - (denominator_ - numerator_) * square / ((1 + numerator_ * square) * (1 + denominator_ * square)));
}

double RationalDispersion::highest_frequency() const {
  return numerator_ > 0 ? infinite : std::sqrt(gravity_ / (denominator_ * depth_));
}

double RationalDispersion::wavenumber(double omega) const {
  require_positive("frequency", omega);
  const double nu = omega * omega * depth_ / gravity_;
  if (numerator_ == 0) {
    const double r = omega / highest_frequency();
    require_that(r < 1, "frequency = {:.17g} is out of range: must be below {:.17g}, the limit of short waves", omega,
                 highest_frequency());
    return std::sqrt(nu / ((1 - r) * (1 + r))) / depth_;
  }
  // n s^2 + (1 - d nu) s - nu = 0 for s = kappa^2, in the form without cancellation for either sign of 1 - d nu.
  const double linear = 1 - denominator_ * nu;
  const double root = std::sqrt(linear * linear + 4 * numerator_ * nu);
  const double square = linear >= 0 ? 2 * nu / (linear + root) : (root - linear) / (2 * numerator_);
  return std::sqrt(square) / depth_;
}

AiryWave::AiryWave(double amplitude, const WaveScale& wave, const Water& water)
    : law_(water.gravity, water.depth),
      amplitude_(amplitude),
      wavenumber_(law_.wavenumber_of(wave)),
      frequency_(law_.frequency(wavenumber_)) {
  require_positive("amplitude", amplitude);
  const double wavelength = 2 * std::numbers::pi / wavenumber_;
  require_within("amplitude", amplitude, 0, 0.071 * wavelength * std::tanh(wavenumber_ * water.depth));
}

double AiryWave::elevation(double x, double t) const {
  require_finite("x", x);
  require_finite("t", t);
  return amplitude_ * std::cos(wavenumber_ * x - frequency_ * t);
}

void AiryWave::require_inside(double x, double y, double t) const {
  const double top = std::max(0.0, elevation(x, t));
  require_that<OutsideFluid>(y >= -law_.depth() && y <= top,
                             "y = {:.17g} is outside the fluid: must be in [{:g}, {:.17g}] at x = {:g}, t = {:g}", y,
                             -law_.depth(), top, x, t);
}

Velocity AiryWave::velocity(double x, double y, double t) const {
  require_inside(x, y, t);
  const double phase = wavenumber_ * x - frequency_ * t;
  const double scale = law_.gravity() * wavenumber_ * amplitude_ / frequency_;  // = a omega/tanh(k h)
  return {scale * cosh_profile(wavenumber_, y, law_.depth()) * std::cos(phase),
          scale * sinh_profile(wavenumber_, y, law_.depth()) * std::sin(phase)};
}

double AiryWave::pressure(double x, double y, double t) const {
  require_inside(x, y, t);
  return law_.gravity() * (elevation(x, t) * cosh_profile(wavenumber_, y, law_.depth()) - y);
}

SelfTest RationalDispersion::self_test() const {
  return {wavenumber_identity(*this, 1e-4 / depth_, 30 / depth_), group_speed_identity(*this, 6 / depth_)};
}

SelfTest AiryWave::self_test() const {
  const double wavelength = 2 * std::numbers::pi / wavenumber_;
  const double kinematic = worst(0, 15, [&](int i) {
    const double rise = amplitude_ * frequency_ * std::sin(wavenumber_ * (wavelength * i / 16));  // eta_t at t = 0
    return (velocity(wavelength * i / 16, 0, 0).v - rise) / (amplitude_ * frequency_);
  });
  const double dynamic = worst(0, 15, [&](int i) {
    const double x = wavelength * i / 16;
    return (pressure(x, 0, 0) / law_.gravity() - elevation(x, 0)) / amplitude_;
  });
  // Kinetic energy of a column averaged over x: the squares of cosine and sine average to 1/2.
  const double bottom = -std::min(law_.depth(), 6 * wavelength);  // below, less than exp(-24 pi) of it
  const auto kinetic_density = [&](double y) {
    const double u = velocity(0, y, 0).u;
    const double v = velocity(0.25 * wavelength, y, 0).v;
    return 0.25 * (u * u + v * v);
  };
  const double kinetic = integral<15>(kinetic_density, bottom, 0, 32);
  const double quarter = 0.25 * law_.gravity() * amplitude_ * amplitude_;
  return {{"v = eta_t at y = 0", kinematic, 4e-15, "18 ulp for 15 roundings"},
          {"p = g eta at y = 0", dynamic, 2e-15, "9 ulp for 5 roundings"},
          {"kinetic energy = g a^2/4", std::abs(kinetic / quarter - 1), 4 * epsilon * std::sqrt(90),
           "32 layers of 15 points resolve the profile to round-off; 90 roundings: 47 additions, those of the "
           "velocities, doubled by their squares, and of the frequency"}};
}

ExactSolution airy_entry() {
  return Entry<AiryWave>{
      .name = "airy",
      .title = "Progressive wave of small amplitude",
      .citation = "Airy, Tides and waves (1845); Lamb, Hydrodynamics (1932), sections 228-230",
      .formula =
          "eta = a cos(kx - omega t), omega^2 = g k tanh(k h), u - i v from phi = (g a/omega) cosh(k(y + h))/cosh(k h) "
          "sin(kx - omega t)",
      .parameters = {{"amplitude", "m", 0.01, 1e-12, 1e6, "half the height"},
                     {"wavelength", "m", 2 * std::numbers::pi, 0, 1e9, "wavelength; 0: it follows from the period"},
                     {"period", "s", 0, 0, 1e9, "period, where wavelength is 0"},
                     depth_parameter(1, infinite),
                     gravity_parameter()},
      .inputs = {position_x, height_y, time_t},
      .outputs = {surface_eta, velocity_u, velocity_v, pressure_p},
      .scalars = {{"omega", "1/s", "angular frequency", &AiryWave::frequency},
                  {"period", "s", "period", &AiryWave::period},
                  {"wavenumber", "1/m", "2 pi/wavelength", &AiryWave::wavenumber},
                  {"wavelength", "m", "wavelength",
                   [](const AiryWave& wave) { return 2 * std::numbers::pi / wave.wavenumber(); }},
                  {"phase_speed", "m/s", "omega/k", &AiryWave::phase_speed},
                  {"group_speed", "m/s", "d omega/d k", &AiryWave::group_speed}},
      .make = made_by(
          [](double amplitude, double length, double period, double depth, double g) {
            const WaveScale wave = length > 0 ? WaveScale(Wavelength{length}) : Period{period};
            return AiryWave(amplitude, wave, {.gravity = g, .depth = depth});
          },
          "amplitude", "wavelength", "period", "depth", "gravity"),
      .row = [](const AiryWave& wave, At at) {
        const double eta = wave.elevation(at[0], at[2]);
        const double y = std::isnan(at[1]) ? eta : at[1];
        const auto [u, v] = wave.velocity(at[0], y, at[2]);
        return Row{eta, u, v, wave.pressure(at[0], y, at[2])};
      }};
}

namespace {

/// Any of the continuous laws, and the wavenumber that is meant where none is given.
struct Law {
  std::variant<AiryDispersion, RationalDispersion> law;
  double wavenumber;

  [[nodiscard]] Row row(double given) const {
    const double k = std::isnan(given) ? wavenumber : given;
    return std::visit([k](const auto& l) { return Row{l.frequency(k), l.phase_speed(k), l.group_speed(k)}; }, law);
  }
  [[nodiscard]] double uncertainty() const {
    return std::visit([](const auto& l) { return l.uncertainty(); }, law);
  }
  [[nodiscard]] SelfTest self_test() const {
    return std::visit([](const auto& l) { return l.self_test(); }, law);
  }
};

Law law_from(int law, double length, double depth, double g, double alpha, double nwogu_a, double madsen_b) {
  const double k = 2 * std::numbers::pi / length;
  if (law == 0) return {AiryDispersion(g, depth), k};
  if (law == 1) return {RationalDispersion::green_naghdi(g, depth, alpha), k};
  if (law == 2) return {RationalDispersion::nwogu(g, depth, nwogu_a), k};
  return {RationalDispersion::madsen_sorensen(g, depth, madsen_b), k};
}

}  // namespace

ExactSolution dispersion_entry() {
  return Entry<Law>{
      .name = "dispersion",
      .title = "Linear dispersion laws of water waves and of Boussinesq-type models",
      .citation =
          "Airy, Tides and waves, Encyclopaedia Metropolitana (1845); Peregrine (1967); Green and Naghdi (1976); "
          "Madsen and Sorensen (1992); Nwogu (1993)",
      .formula =
          "omega^2 = g k tanh(k H); omega^2 = g H k^2 (1 + n (kH)^2)/(1 + d (kH)^2): n = 0, d = 1/3 (Green-Naghdi); n "
          "= B, d = B + 1/3 (Madsen-Sorensen); n = -(A + 1/3), d = -A (Nwogu)",
      .parameters = {{"law", "1", 0, 0, 3, "whose law", {"airy", "green_naghdi", "nwogu", "madsen_sorensen"}},
                     wavelength_parameter(),
                     depth_parameter(1, infinite),
                     gravity_parameter(),
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "Green-Naghdi: factor of the vertical kinetic energy"},
                     {"nwogu_a", "1", -0.39, -0.5, -1.0 / 3, "Nwogu: z (z/2 + 1) of the reference level"},
                     {"madsen_b", "1", 1.0 / 15, 0, 10, "Madsen-Sorensen: coefficient B"}},
      .inputs = {wavenumber_k},
      .outputs = {{"omega", "1/s", "angular frequency"},
                  {"phase_speed", "m/s", "omega/k"},
                  {"group_speed", "m/s", "d omega/d k"}},
      .scalars = {{"omega", "1/s", "angular frequency of the wavelength",
                   [](const Law& law) { return law.row(none_given)[0]; }},
                  {"phase_speed", "m/s", "its phase speed", [](const Law& law) { return law.row(none_given)[1]; }},
                  {"group_speed", "m/s", "its group speed", [](const Law& law) { return law.row(none_given)[2]; }}},
      .make = made_by(&law_from, "law", "wavelength", "depth", "gravity", "alpha", "nwogu_a", "madsen_b"),
      .row = [](const Law& law, At at) { return law.row(at[0]); }};
}

}  // namespace seiche::exact
