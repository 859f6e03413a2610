#include "seiche/exact/solitary_wave.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/exact/section_flux.hpp"
#include "seiche/exact/solitary_surface.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<SolitaryWave>);

namespace {

void require_medium(double depth, double gravity, Resolution resolution) {
  require_positive("depth", depth);
  require_positive("gravity", gravity);
  require_within("resolution.refinement", resolution.refinement, 0.5, 2);
  require_within("resolution.clustering", resolution.clustering, 0.25, 4);
}

double scaled_amplitude(double amplitude, double depth, double gravity, Resolution resolution) {
  require_medium(depth, gravity, resolution);
  require_finite("amplitude", amplitude);
  require_within("amplitude/depth", amplitude / depth, 0.001, 0.8331);
  return amplitude / depth;
}

}  // namespace

SolitaryWave::SolitaryWave(double amplitude, double depth, double gravity, Resolution resolution)
    : SolitaryWave(std::make_shared<const SolitarySurface>(
                       SolitaryCrest{scaled_amplitude(amplitude, depth, gravity, resolution), {}}, resolution),
                   depth, gravity) {}

SolitaryWave::SolitaryWave(std::shared_ptr<const SolitarySurface> surface, double depth, double gravity)
    : surface_(std::move(surface)), depth_(depth), gravity_(gravity), celerity_(std::sqrt(gravity * depth)) {}

SolitaryWave SolitaryWave::from_crest_speed(double crest_speed, double depth, double gravity, Resolution resolution) {
  require_medium(depth, gravity, resolution);
  require_within("crest_speed", crest_speed, 3e-4, 0.999);
  return {std::make_shared<const SolitarySurface>(SolitaryCrest{{}, crest_speed}, resolution), depth, gravity};
}

double SolitaryWave::amplitude() const {
  return depth_ * surface_->amplitude();
}
double SolitaryWave::speed() const {
  return celerity_ * froude();
}
double SolitaryWave::froude() const {
  return surface_->froude();
}
double SolitaryWave::crest_speed() const {
  return surface_->crest_speed();
}
double SolitaryWave::decay_rate() const {
  return surface_->decay_rate() / depth_;
}
double SolitaryWave::mass() const {
  return depth_ * depth_ * surface_->integrals().mass;
}
double SolitaryWave::kinetic_energy() const {
  return gravity_ * std::pow(depth_, 3) * surface_->integrals().kinetic_energy;
}
double SolitaryWave::potential_energy() const {
  return gravity_ * std::pow(depth_, 3) * surface_->integrals().potential_energy;
}
double SolitaryWave::circulation() const {
  return celerity_ * depth_ * surface_->integrals().circulation;
}
double SolitaryWave::impulse() const {
  return speed() * mass();
}
double SolitaryWave::crest_velocity() const {
  return speed() * (1 - crest_speed());
}
double SolitaryWave::half_width() const {
  return depth_ * surface_->half_width();
}
double SolitaryWave::maximum_slope() const {
  return surface_->maximum_slope();
}

double SolitaryWave::elevation(double x) const {
  require_finite("x", x);
  return depth_ * surface_->elevation(x / depth_);
}

double SolitaryWave::surface_potential(double x) const {
  require_finite("x", x);
  return celerity_ * depth_ * surface_->potential(x / depth_);
}

Velocity SolitaryWave::velocity(double x, double y) const {
  require_finite("x", x);
  require_finite("y", y);
  const Velocity scaled = surface_->velocity(x / depth_, y / depth_);
  return {celerity_ * scaled.u, celerity_ * scaled.v};
}

Provenance SolitaryWave::provenance() {
  return {
      "Longuet-Higgins & Fenton, On the mass, momentum, energy and circulation of a solitary wave II, Proc. R. Soc. A "
      "340 (1974) 471; Hunter & Vanden-Broeck, Accurate computations for steep solitary waves, J. Fluid Mech. 136 "
      "(1983) 63; Dutykh & Clamond, Efficient computation of steady solitary gravity waves, Wave Motion 51 (2014) 86",
      "theta(phi) = 1/2 PV int tau(phi')/sinh(pi (phi - phi')/2) dphi', y = F^2 (1 - q^2)/2, dy/dphi = sin(theta)/q, "
      "q = exp(tau); f = F (1 - dW/dz) inside by a quotient of Cauchy sums"};
}

double SolitaryWave::uncertainty() const {
  // Long waves balance up to the square of their amplitude; q^2 = 1 - 2 y/F^2 is a difference near the limiting wave,
  // and its rounding is divided by 2 q.
  constexpr double rounding = 1e-14;
  const double small = 0.1 / std::min(0.1, surface_->amplitude());
  const double steep = std::max(1.0, 0.5 / crest_speed());
  return rounding * small * steep;
}

SelfTest SolitaryWave::self_test() const {
  const auto& integrals = surface_->integrals();
  const double f = froude();
  const double impulse = f * integrals.mass;
  const double sum_limit = 5 * uncertainty();
  const std::string sum_reason = "sums of about 500 terms of values good to the stated uncertainty";
  const double twice_kinetic = 2 * integrals.kinetic_energy;
  const double thrice_potential = 3 * integrals.potential_energy;
  const double flux = section_flux([&](double y) { return surface_->velocity(0, y).u; }, -1, surface_->amplitude());
  // I - C = O(a^(3/2)) is a difference of terms O(a^(1/2)).
  return {{"2 T = F (I - C)", std::abs(twice_kinetic - f * (impulse - integrals.circulation)) / twice_kinetic,
           sum_limit * std::max(1.0, impulse / twice_kinetic), sum_reason},
          {"3 V = (F^2 - 1) M", std::abs(thrice_potential - (f - 1) * (f + 1) * integrals.mass) / thrice_potential,
           sum_limit, sum_reason},
          {"volume flux through the crest section = c a", std::abs(flux / (f * surface_->amplitude()) - 1),
           5 * uncertainty(), "280 Gauss points of velocities good to the stated uncertainty"}};
}

}  // namespace seiche::exact
