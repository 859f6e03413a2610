#include "seiche/exact/linear_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/depth_profile.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<AiryWave>);

AiryWave::AiryWave(double amplitude, double wavelength, double depth, double gravity)
    : law_(gravity, depth), amplitude_(amplitude) {
  require_positive("wavelength", wavelength);
  require_positive("amplitude", amplitude);
  wavenumber_ = 2 * std::numbers::pi / wavelength;
  frequency_ = law_.frequency(wavenumber_);
  require_within("amplitude", amplitude, 0, 0.071 * wavelength * std::tanh(wavenumber_ * depth));
}

double AiryWave::elevation(double x, double t) const {
  require_finite("x", x);
  require_finite("t", t);
  return amplitude_ * std::cos(wavenumber_ * x - frequency_ * t);
}

void AiryWave::require_inside(double x, double y, double t) const {
  const double top = std::max(0.0, elevation(x, t));
  if (!(y >= -law_.depth() && y <= top)) {
    throw OutsideFluid(fmt::format("y = {:.17g} is outside the fluid: must be in [{:g}, {:.17g}] at x = {:g}, t = {:g}",
                                   y, -law_.depth(), top, x, t));
  }
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

double AiryWave::period() const {
  return 2 * std::numbers::pi / frequency_;
}

Provenance AiryWave::provenance() {
  return {"Airy, Tides and waves (1845); Lamb, Hydrodynamics (1932), sections 228-230",
          "eta = a cos(kx - omega t), omega^2 = g k tanh(k h), u - i v from phi = (g a/omega) cosh(k(y + h))/cosh(k h) "
          "sin(kx - omega t)"};
}

double AiryWave::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest AiryWave::self_test() const {
  const double wavelength = 2 * std::numbers::pi / wavenumber_;
  Largest kinematic;
  Largest dynamic;
  for (int i = 0; i < 16; ++i) {
    const double x = wavelength * i / 16;
    const double rise = amplitude_ * frequency_ * std::sin(wavenumber_ * x);  // eta_t at t = 0
    kinematic.add(std::abs(velocity(x, 0, 0).v - rise) / (amplitude_ * frequency_));
    dynamic.add(std::abs(pressure(x, 0, 0) / law_.gravity() - elevation(x, 0)) / amplitude_);
  }
  // Kinetic energy of a column averaged over x: the squares of cosine and sine average to 1/2.
  const double bottom = -std::min(law_.depth(), 6 * wavelength);  // below, less than exp(-24 pi) of it
  double kinetic = 0;
  constexpr int layers = 32;
  for (int i = 0; i < layers; ++i) {
    kinetic += boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double y) {
          const double u = velocity(0, y, 0).u;
          const double v = velocity(0.25 * wavelength, y, 0).v;
          return 0.25 * (u * u + v * v);
        },
        bottom * (i + 1) / layers, bottom * i / layers);
  }
  const double quarter = 0.25 * law_.gravity() * amplitude_ * amplitude_;
  return {{"v = eta_t at y = 0", kinematic.value(), 4e-15, "18 ulp for 15 roundings"},
          {"p = g eta at y = 0", dynamic.value(), 2e-15, "9 ulp for 5 roundings"},
          {"kinetic energy = g a^2/4", std::abs(kinetic / quarter - 1),
           4 * std::numeric_limits<double>::epsilon() * std::sqrt(90),
           "32 layers of 15 points resolve the profile to round-off; 90 roundings: 47 additions, those of the "
           "velocities, doubled by their squares, and of the frequency"}};
}

}  // namespace seiche::exact
