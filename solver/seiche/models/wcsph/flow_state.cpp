#include "seiche/models/wcsph/flow_state.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include "seiche/models/wcsph/engine.hpp"
#include "seiche/models/wcsph/input_checks.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {

namespace {

/// What of particles never changes, by identity.
auto lasting(const Particles& p) {
  std::vector<std::tuple<std::int32_t, Kind, std::int32_t, double>> all;
  for (std::size_t i = 0; i < p.size(); ++i) all.emplace_back(p.identity[i], p.kind[i], p.body[i], p.mass[i]);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

FlowState Flow::state() const {
  return engine_->state();
}

void Flow::resume(const FlowState& state) {
  engine_->resume(state);
}

std::vector<std::pair<std::string, double>> Flow::Engine::parameters(double time) const {
  // All that there are: with one more this does not compile.
  const auto& [kernel, smoothing, gravity, density, sound_speed, exponent, viscosity, xsph, filter_every, diffusion,
               shifting, walls, courant, limit_by_viscosity, period, storage, skin] = settings_;
  std::vector<std::pair<std::string, double>> all{{"spacing", spacing_},
                                                  {"kernel", static_cast<double>(kernel)},
                                                  {"smoothing", smoothing},
                                                  {"gravity", gravity},
                                                  {"density", density},
                                                  {"sound_speed", sound_speed},
                                                  {"exponent", exponent},
                                                  {"xsph", xsph},
                                                  {"filter_every", filter_every},
                                                  {"density_diffusion", diffusion},
                                                  {"particle_shifting", shifting ? 1 : 0},
                                                  {"walls", static_cast<double>(walls)},
                                                  {"courant", courant},
                                                  {"limit_by_viscosity", limit_by_viscosity ? 1 : 0},
                                                  {"period.x", period.x},
                                                  {"period.z", period.z},
                                                  {"storage", static_cast<double>(storage)},
                                                  {"skin", skin},
                                                  {"viscosity", static_cast<double>(viscosity.index())},
                                                  {"number of paddles", static_cast<double>(paddles_.size())}};
  if (const auto* artificial = std::get_if<ArtificialViscosity>(&viscosity)) {
    all.emplace_back("alpha", artificial->alpha);
  } else if (const auto* sps = std::get_if<LaminarSps>(&viscosity)) {
    all.emplace_back("kinematic_viscosity", sps->kinematic_viscosity);
    all.emplace_back("smagorinsky", sps->smagorinsky);
    all.emplace_back("isotropic", sps->isotropic);
  }
  const PaddlePoses poses = paddles_at(time);
  for (std::size_t k = 0; k < paddles_.size(); ++k) {
    const auto add = [&](const char* name, double value) {
      all.emplace_back(fmt::format("{} of paddle {}", name, k), value);
    };
    add("hinge_x", paddles_[k].hinge_x);
    add("hinge_z", paddles_[k].hinge_z);
    add("displacement", poses.pose[k].displacement);
    add("angle", poses.pose[k].angle);
    add("rate of displacement", poses.rate[k].displacement);
    add("rate of angle", poses.rate[k].angle);
  }
  return all;
}

FlowState Flow::Engine::state() const {
  std::vector<double> values;
  for (const auto& [name, value] : parameters(time_)) values.push_back(value);
  return {.parameters = std::move(values),
          .particles = particles_,
          .reference_x = reference_x_,
          .reference_z = reference_z_,
          .listed = {stage_.base().x, stage_.base().z, stage_.base().density, listed_reserve_},
          .half_travel = half_travel_,
          .time = time_,
          .steps = steps_,
          .extremes = extremes_};
}

void Flow::Engine::check_state(const FlowState& state) const {
  require_not_negative("time of the state", state.time);
  const auto mine = parameters(state.time);
  for (std::size_t k = 0; k < mine.size(); ++k) {
    const auto& [name, value] = mine[k];
    if (k < state.parameters.size() && state.parameters[k] == value) continue;
    throw std::invalid_argument(fmt::format("state of a flow with {} = {}: must be {}, as of this one", name,
                                            k < state.parameters.size() ? state.parameters[k] : std::nan(""), value));
  }
  check_particles(state.particles, paddles_);
  if (state.particles.size() != particles_.size()) {
    throw std::invalid_argument(fmt::format("state of {} particles: must be of {}, as the flow has",
                                            state.particles.size(), particles_.size()));
  }
  const auto theirs = lasting(state.particles);
  const auto own = lasting(particles_);
  if (const auto found = std::mismatch(own.begin(), own.end(), theirs.begin()); found.first != own.end()) {
    throw std::invalid_argument(
        fmt::format("state of other particles: kind, body or mass of particle {} are not those of this flow's",
                    std::get<0>(*found.first)));
  }
  for (const auto* values : {&state.listed.x, &state.listed.z, &state.listed.density}) {
    if (values->size() != particles_.size()) {
      throw std::invalid_argument(
          fmt::format("state with lists of {} particles: must be of {}", values->size(), particles_.size()));
    }
  }
  if (state.reference_x.size() != reference_x_.size() || state.reference_z.size() != reference_z_.size()) {
    throw std::invalid_argument(fmt::format("state with {} places that paddles carry: must be {}",
                                            state.reference_x.size(), reference_x_.size()));
  }
}

void Flow::Engine::resume(const FlowState& state) {
  check_state(state);
  const FlowState before = this->state();
  try {
    adopt(state);
  } catch (...) {
    adopt(before);
    throw;
  }
}

void Flow::Engine::adopt(const FlowState& state) {
  particles_ = state.particles;
  reference_x_ = state.reference_x;
  reference_z_ = state.reference_z;
  time_ = state.time;
  steps_ = state.steps;
  // Lists as they were, of the places then; what is in order stays in order.
  particles_.x = state.listed.x;
  particles_.z = state.listed.z;
  particles_.density = state.listed.density;
  sort(state.listed.reserve);
  if (!std::is_sorted(neighbours_.order().begin(), neighbours_.order().end())) {
    throw std::invalid_argument("state of a flow of other settings: its particles are in another order");
  }
  particles_.x = state.particles.x;
  particles_.z = state.particles.z;
  particles_.density = state.particles.density;
  half_travel_ = state.half_travel;
  extremes_ = state.extremes;
}

}  // namespace seiche::wcsph
