#include "seiche/exact/overturning_wave.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include <gsl/gsl_sf_bessel.h>

#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/initial.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

static_assert(ReferenceSolution<OverturningWave>);

const OverturningWave::Parameters& checked(const OverturningWave::Parameters& p) {
  require_positive("amplitude", p.amplitude);
  require_positive("wavelength", p.wavelength);
  require_positive("gravity", p.gravity);
  require_positive("tolerance", p.tolerance);
  require_at_least("markers", static_cast<long>(p.markers), 64);
  require_within("markers modulo 2", static_cast<double>(p.markers % 2), 0, 0);
  if (p.last_time) require_positive("last_time", *p.last_time);
  const double steepest = p.wavelength / (2 * std::numbers::pi);
  if (std::isinf(p.depth) && p.depth > 0) {
    require_within("amplitude", p.amplitude, 0, steepest);
  } else {
    require_positive("depth", p.depth);
    require_within("amplitude", p.amplitude, 0, std::min(steepest, 0.99 * p.depth));
  }
  return p;
}

}  // namespace

OverturningWave::OverturningWave(const Parameters& parameters)
    : MovingSurface(checked(parameters).wavelength, parameters.gravity), parameters_(parameters) {
  const double depth = parameters_.depth / length();
  const double last_time =
      parameters_.last_time.value_or(2 * std::numbers::pi / std::sqrt(std::tanh(depth)) * time_unit());
  auto motion = std::make_shared<ow::Evolution>(
      ow::sinusoidal_wave(parameters_.markers, parameters_.amplitude / length(), depth), depth, parameters_.tolerance);
  motion->advance_to(last_time / time_unit());
  keep(std::move(motion), last_time, [](double tangent) { return 0.25 * tangent; });
}

double OverturningWave::uncertainty() const {
  return uncertainty(well_resolved_until());
}

double OverturningWave::uncertainty(double t) const {
  Parameters coarser = parameters_;
  coarser.markers = std::max<std::size_t>(64, parameters_.markers * 3 / 8 * 2);
  coarser.tolerance = 10 * parameters_.tolerance;
  coarser.last_time = std::max(t, time_unit() * 1e-3);
  return distance_from(OverturningWave(coarser), t) / parameters_.amplitude;
}

SelfTest OverturningWave::self_test() const {
  const double a = parameters_.amplitude / length();
  const double exact = 0.5 * std::numbers::pi * a * a * gsl_sf_bessel_I0(2 * a);
  const double start = evolution().moments().front().invariants.kinetic_energy;
  SelfTest identities{
      {"kinetic energy at t = 0 is (pi/2) A^2 I_0(2A)", std::abs(start / exact - 1), 1e-13,
       "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; sum over the markers"}};
  std::ranges::move(balances(parameters_.amplitude, parameters_.tolerance), std::back_inserter(identities));
  return identities;
}

Provenance OverturningWave::provenance() {
  return {
      "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) "
      "1; "
      "Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123 (1982) "
      "477",
      "dz/dt = conj f, dphi/dt = |f|^2/2 - g y, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; "
      "eta = A cos kx, phi = (A g/w) cosh(k(y + h))/cosh(kh) sin kx at t = 0"};
}

}  // namespace seiche::exact
