#include "seiche/models/wcsph/flow.hpp"

#include <cmath>
#include <utility>

#include "seiche/models/wcsph/engine.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {

Flow::Flow(Particles particles, double spacing, Settings settings, std::vector<Paddle> paddles)
    : engine_(std::make_unique<Engine>(std::move(particles), spacing, settings, std::move(paddles))) {}
Flow::Flow(Flow&&) noexcept = default;
Flow& Flow::operator=(Flow&&) noexcept = default;
Flow::~Flow() = default;

double Flow::advance() {
  return engine_->advance_at_most(std::numeric_limits<double>::infinity());
}

double Flow::advance(double tau) {
  require_positive("tau", tau);
  engine_->advance_by(tau);
  return tau;
}

void Flow::advance_to(double time, const std::function<void()>& after_step) {
  require_finite("time", time);
  while (engine_->time() < time) {
    const double remaining = time - engine_->time();
    if (engine_->advance_at_most(remaining) == remaining) engine_->set_time(time);
    if (after_step) after_step();
  }
}

double Flow::time() const {
  return engine_->time();
}
long Flow::steps() const {
  return engine_->steps();
}
double Flow::spacing() const {
  return engine_->spacing();
}
double Flow::smoothing_length() const {
  return engine_->smoothing_length();
}
const Settings& Flow::settings() const {
  return engine_->settings();
}
const TaitFluid& Flow::fluid() const {
  return engine_->fluid();
}
const Particles& Flow::particles() const {
  return engine_->particles();
}
const Extremes& Flow::extremes() const {
  return engine_->extremes();
}
Rates Flow::rates() {
  return engine_->rates();
}

std::vector<double> Flow::pressure() const {
  std::vector<double> values;
  values.reserve(particles().size());
  for (const double density : particles().density) values.push_back(fluid().pressure(density));
  return values;
}

Totals Flow::totals() const {
  // Long sums: what they are used for is as small as the rounding of short ones.
  long double mass = 0, momentum_x = 0, momentum_z = 0, angular = 0, absolute = 0, kinetic = 0, elastic = 0,
              potential = 0;
  const Particles& p = particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.kind[i] != Kind::fluid) continue;
    const long double m = p.mass[i];
    const long double u = p.u[i];
    const long double w = p.w[i];
    mass += m;
    momentum_x += m * u;
    momentum_z += m * w;
    angular += m * (p.x[i] * w - p.z[i] * u);
    absolute += m * std::hypot(p.u[i], p.w[i]);
    kinetic += m * (u * u + w * w) / 2;
    elastic += m * fluid().elastic_energy(p.density[i]);
    potential += m * settings().gravity * p.z[i];
  }
  const auto rounded = [](long double value) { return static_cast<double>(value); };
  return {.mass = rounded(mass),
          .momentum = {rounded(momentum_x), rounded(momentum_z)},
          .angular_momentum = rounded(angular),
          .absolute_momentum = rounded(absolute),
          .kinetic = rounded(kinetic),
          .elastic = rounded(elastic),
          .potential = rounded(potential)};
}

long Flow::outside(double left, double right, double bottom, double top) const {
  const Particles& p = particles();
  long count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool inside = p.x[i] >= left && p.x[i] <= right && p.z[i] >= bottom && p.z[i] <= top;
    if (p.kind[i] == Kind::fluid && !inside) ++count;
  }
  return count;
}

}  // namespace seiche::wcsph
