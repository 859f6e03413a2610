#include "seiche/models/variable_mass/convection.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/samples.hpp"

namespace seiche::variable_mass {

namespace {

constexpr double settled = 1e-15;   // change of an iteration over the largest velocity
constexpr double rounding = 1e-11;  // below it a change that no longer falls is rounding

}  // namespace

void Convection::begin(std::span<const double> masses, std::span<const Exchange> exchanges, Places at) {
  exchanges_.assign(exchanges.begin(), exchanges.end());
  next_.assign(masses.begin(), masses.end());
  for (const auto& [to, from, mass] : exchanges_) {
    next_[static_cast<std::size_t>(to)] += mass;
    next_[static_cast<std::size_t>(from)] -= mass;
  }
  const std::size_t n = masses.size();
  root_.resize(n);
  next_root_.resize(n);
  mean_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!(next_[k] > 0)) {
      const Point r = at[static_cast<int>(k)];
      throw mechanics::Infeasible(
          fmt::format("the mass of node {} at ({:g}, {:g}) becomes {:g}; allowed: positive", k, r.x, r.y, next_[k]),
          r.x);
    }
    root_[k] = std::sqrt(masses[k]);
    next_root_[k] = std::sqrt(next_[k]);
    const double sum = root_[k] + next_root_[k];
    mean_[k] = sum * sum / 2;
  }
}

void Convection::momenta(std::span<const double> u, std::span<const double> mean, std::vector<double>& out) const {
  const std::size_t n = root_.size();
  out.resize(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const double factor = root_[k] * (root_[k] + next_root_[k]);
    out[k] = factor * u[k];
    out[n + k] = factor * u[n + k];
  }
  for (const auto& [to, from, mass] : exchanges_) {
    const auto i = static_cast<std::size_t>(to);
    const auto j = static_cast<std::size_t>(from);
    out[i] += mass / 2 * mean[j];
    out[j] -= mass / 2 * mean[i];
    out[n + i] += mass / 2 * mean[n + j];
    out[n + j] -= mass / 2 * mean[n + i];
  }
}

int Convection::settle(std::span<const double> u, const Respond& respond, double kicks, std::vector<double>& mean) {
  double last = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= most_iterations; ++k) {
    momenta(u, mean, iterate_);
    respond(iterate_);
    Worst change;
    Worst size;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      change.add(iterate_[i] - mean[i]);
      size.add(iterate_[i]);
    }
    mean.swap(iterate_);
    const double now = std::abs(change.value());
    const double scale = std::abs(size.value()) + kicks;
    if (now <= settled * scale || (now >= last && now <= rounding * scale)) return k;
    last = now;
  }
  throw mechanics::Infeasible(
      fmt::format("the convective term does not settle in {} iterations: the control is too strong for the step",
                  most_iterations),
      0);
}

void Convection::finish(std::span<const double> u, std::span<const double> mean, std::vector<double>& next) const {
  const std::size_t n = root_.size();
  next.resize(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const std::size_t k = i % n;
    next[i] = ((root_[k] + next_root_[k]) * mean[i] - root_[k] * u[i]) / next_root_[k];
  }
}

}  // namespace seiche::variable_mass
