#include "seiche/models/wcsph/flow_state.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::wcsph {

namespace {

template <class... Values>
std::vector<double> numbers(Values... values) {
  return {static_cast<double>(values)...};
}

/// Of a parameter of Flow::parameters().
std::string name_of(std::size_t parameter) {
  std::istringstream names(
      "spacing kernel smoothing gravity density sound_speed exponent xsph filter_every density_diffusion "
      "particle_shifting walls courant period.x period.z viscosity alpha "
      "kinematic_viscosity smagorinsky isotropic paddles");
  std::string name;
  for (std::size_t k = 0; k <= parameter; ++k) {
    if (!(names >> name)) return "hinge, pose or rate of a paddle";
  }
  return name;
}

/// What of particles never changes, by identity.
auto lasting(const Particles& p) {
  std::vector<std::tuple<std::int32_t, Kind, std::int32_t, double>> all;
  for (std::size_t i = 0; i < p.size(); ++i) all.emplace_back(p.identity[i], p.kind[i], p.body[i], p.mass[i]);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

std::vector<double> Flow::parameters(double time) const {
  // All settings that there are: with one more this does not compile.
  const auto& [kernel, smoothing, gravity, density, sound_speed, exponent, viscosity, xsph, filter_every, diffusion,
               shifting, walls, courant, period] = settings_;
  const auto* artificial = std::get_if<ArtificialViscosity>(&viscosity);
  const auto* given = std::get_if<LaminarSps>(&viscosity);
  const LaminarSps sps = given != nullptr ? *given : LaminarSps{0, 0, 0};
  std::vector<double> all = numbers(spacing_, kernel, smoothing, gravity, density, sound_speed, exponent, xsph,
                                    filter_every, diffusion, shifting, walls, courant, period.x, period.z,
                                    viscosity.index(), artificial != nullptr ? artificial->alpha : 0,
                                    sps.kinematic_viscosity, sps.smagorinsky, sps.isotropic, paddles_.size());
  const PaddlePoses at = paddles_at(time);
  for (std::size_t k = 0; k < paddles_.size(); ++k) {
    for (const double value : numbers(paddles_[k].hinge_x, paddles_[k].hinge_z, at.pose[k].displacement,
                                      at.pose[k].angle, at.rate[k].displacement, at.rate[k].angle))
      all.push_back(value);
  }
  return all;
}

FlowState Flow::state() const {
  return {.parameters = parameters(time_),
          .particles = particles_,
          .reference_x = reference_x_,
          .reference_z = reference_z_,
          .listed = {stage_.base().x, stage_.base().z, stage_.base().density, listed_reserve_},
          .half_travel = half_travel_,
          .time = time_,
          .steps = steps_,
          .extremes = extremes_};
}

void Flow::check_state(const FlowState& state) const {
  require_not_negative("time of the state", state.time);
  const std::vector<double> mine = parameters(state.time);
  const auto& theirs = state.parameters;
  if (const auto found = std::mismatch(mine.begin(), mine.end(), theirs.begin(), theirs.end());
      found.first != mine.end()) {
    throw std::invalid_argument(fmt::format("state of a flow with {} = {}: must be {}, as of this one",
                                            name_of(static_cast<std::size_t>(found.first - mine.begin())),
                                            found.second == theirs.end() ? std::nan("") : *found.second, *found.first));
  }
  check_particles(state.particles, paddles_);
  const std::size_t n = particles_.size();
  require_that(lasting(state.particles) == lasting(particles_),
               "state of {} particles: must be the {} of this flow, of their kind and mass", state.particles.size(), n);
  const auto& [x, z, density, reserve] = state.listed;
  require_that(x.size() == n && z.size() == n && density.size() == n &&
                   state.reference_x.size() == reference_x_.size() && state.reference_z.size() == reference_z_.size(),
               "state with other arrays than of {} particles: must be as state() gave it", n);
}

void Flow::resume(const FlowState& state) {
  check_state(state);
  const FlowState before = this->state();
  try {
    adopt(state);
  } catch (...) {
    adopt(before);
    throw;
  }
}

void Flow::adopt(const FlowState& state) {
  particles_ = state.particles;
  reference_x_ = state.reference_x;
  reference_z_ = state.reference_z;
  time_ = state.time;
  steps_ = state.steps;
  // Lists as they were, of the places then; what is in order stays in order.
  particles_.x = state.listed.x;
  particles_.z = state.listed.z;
  particles_.density = state.listed.density;
  require_that(sort(state.listed.reserve), "state of a flow of other settings: its particles are in another order");
  particles_.x = state.particles.x;
  particles_.z = state.particles.z;
  particles_.density = state.particles.density;
  level_known_ = false;
  half_travel_ = state.half_travel;
  extremes_ = state.extremes;
}

}  // namespace seiche::wcsph
