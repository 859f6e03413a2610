#include "seiche/models/wcsph/engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/wcsph/input_checks.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

/// Neighbours beyond this many times those of a lattice are a clump.
constexpr double clump = 8;

double mean_spacing(const Particles& particles, double density) {
  double mass = 0;
  double count = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::fluid) continue;
    mass += particles.mass[i];
    count += 1;
  }
  return std::sqrt((count > 0 ? mass / count : particles.mass.front()) / density);
}

/// Where particles may fly without slowing down the search: the box of the beginning and as much around it.
Box expected_box(const Particles& particles) {
  const auto [left, right] = std::minmax_element(particles.x.begin(), particles.x.end());
  const auto [bottom, top] = std::minmax_element(particles.z.begin(), particles.z.end());
  const double margin = std::max(*right - *left, *top - *bottom);
  return {*left - margin, *right + margin, *bottom - margin, *top + margin};
}

Particles checked(Particles particles, const Settings& settings, double spacing, std::span<const Paddle> paddles) {
  validate(settings);
  require_positive("spacing", spacing);
  check_period(settings, settings.smoothing * spacing);
  check_particles(particles, paddles);
  return particles;
}

}  // namespace

Flow::Engine::Engine(Particles particles, double spacing, const Settings& settings, std::vector<Paddle> paddles)
    : settings_(settings),
      spacing_(spacing),
      fluid_(settings.density, settings.sound_speed, settings.exponent),
      smoothing_(settings.smoothing * spacing),
      paddles_(std::move(paddles)),
      particles_(checked(std::move(particles), settings, spacing, paddles_)),
      reference_x_(paddles_.empty() ? std::vector<double>{} : particles_.x),
      reference_z_(paddles_.empty() ? std::vector<double>{} : particles_.z),
      mean_spacing_(mean_spacing(particles_, settings.density)),
      walls_(settings.kernel, fluid_),
      rates_(settings, spacing),
      shifting_(settings.kernel, spacing),
      stage_(fluid_, smoothing_, rates_.sound_scale(), rates_.turbulent(), settings.storage),
      neighbours_(mean_spacing_, expected_box(particles_), settings.period,
                  settings.storage == Storage::mixed ? pair_loops().mixed.lanes : pair_loops().full.lanes),
      reserve_(settings.skin * support * smoothing_),
      listed_reserve_(reserve_) {
  rates_.resize(particles_.size());
  const PaddlePoses poses = paddles_at(0);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::paddle) continue;
    const PointMotion motion = carried_by_paddle(i, poses);
    particles_.x[i] = motion.x;
    particles_.z[i] = motion.z;
    particles_.u[i] = motion.u;
    particles_.w[i] = motion.w;
  }
  sort(reserve_);
  check_start();
}

void Flow::Engine::check_start() const {
  if (const auto* laminar = std::get_if<LaminarSps>(&settings_.viscosity)) {
    const double highest = viscous_courant * smoothing_ * settings_.sound_speed / (shortest_step * settings_.courant);
    if (laminar->kinematic_viscosity > highest) {
      throw std::invalid_argument(fmt::format(
          "kinematic viscosity nu0 = {:.17g} m^2/s is out of range: must be in [0, {:g}], or a stable step, 0.125 "
          "h^2/nu0, is below a thousandth of the acoustic one",
          laminar->kinematic_viscosity, highest));
    }
  }
  check_distances(particles_, neighbours_.images(), neighbours_.clusters(), spacing_);
}

/// Whether mixed records resolve the places of all particles: not those of one that flew off.
void Flow::Engine::check_extent() const {
  const auto [left, right] = std::minmax_element(particles_.x.begin(), particles_.x.end());
  const auto [bottom, top] = std::minmax_element(particles_.z.begin(), particles_.z.end());
  const double extent = std::max(*right - *left, *top - *bottom);
  if (extent <= widest_mixed_domain * smoothing_) return;
  const std::string what = fmt::format(
      "particles over {:g} m, {:.3g} smoothing lengths, with storage = mixed: must be at most {:g}, or full", extent,
      extent / smoothing_, widest_mixed_domain);
  if (steps_ == 0) throw std::invalid_argument(what);
  const bool up = *top - *bottom > *right - *left;
  const auto farthest = up ? top - particles_.z.begin() : right - particles_.x.begin();
  throw Divergence(what, time_, steps_, particles_.x[static_cast<std::size_t>(farthest)]);
}

void Flow::Engine::sort(double reserve) {
  const double lowest = *std::min_element(particles_.density.begin(), particles_.density.end());
  const double widest = smoothing_ * std::max(1.0, std::sqrt(settings_.density / lowest));
  if (settings_.storage == Storage::mixed) check_extent();
  neighbours_.sort(particles_, widest, reserve);
  if (!paddles_.empty()) {
    std::vector<double> scratch;
    neighbours_.reorder(reference_x_, scratch);
    neighbours_.reorder(reference_z_, scratch);
  }
  stage_.adopt(particles_, neighbours_.images());
  if (settings_.storage == Storage::mixed) {
    list<MixedRecord>(reserve);
  } else {
    list<Record>(reserve);
  }
  listed_reserve_ = reserve;
  ++extremes_.rebuilds;

  const double usual = std::numbers::pi * std::pow(support * smoothing_ / mean_spacing_, 2);
  if (neighbours_.most_neighbours() > clump * usual) {
    throw Divergence(
        fmt::format("{:.0f} neighbours of a particle, {:.0f} are usual", neighbours_.most_neighbours(), usual), time_,
        steps_, particles_.x[neighbours_.most_crowded()]);
  }
}

template <class SomeRecord>
void Flow::Engine::list(double reserve) {
  const Units& units = stage_.units();
  const SearchWork<SomeRecord> work{.records = stage_.held<SomeRecord>().records.data(),
                                    .skin = reserve * units.per_length,
                                    .place_unit = units.place * units.per_length};
  const CandidateSearch<SomeRecord> search = rate_loops<SomeRecord>().search;
  neighbours_.list(particles_, [&](const Cluster& cluster, std::span<const IndexRange> ranges, std::int32_t* to) {
    return search(work, cluster, ranges.data(), ranges.size(), to);
  });
}

void Flow::Engine::fill_level() {
  const double used = stage_.fill(particles_);
  if (used + half_travel_ > reserve_) sort(reserve_);
}

void Flow::Engine::evaluate(double time, bool limited) {
  if (settings_.walls == WallPressure::extrapolated) {
    // Paddles' accelerations: means over the time that sound takes for h before and after, from time 0 on.
    const double shift = smoothing_ / settings_.sound_speed;
    const PaddlePoses before = paddles_at(std::max(time - shift, 0.0));
    const PaddlePoses after = paddles_at(time + shift);
    const double between = std::min(2 * shift, time + shift);
    const auto felt_gravity = [&](std::size_t i) {
      std::array<double, 2> gravity{0, -settings_.gravity};
      if (particles_.kind[i] == Kind::paddle) {
        const PointMotion from = carried_by_paddle(i, before);
        const PointMotion to = carried_by_paddle(i, after);
        gravity[0] -= (to.u - from.u) / between;
        gravity[1] -= (to.w - from.w) / between;
      }
      return gravity;
    };
    walls_.apply(felt_gravity, stage_, neighbours_);
  }
  rates_.evaluate(stage_, neighbours_, limited);
  extremes_.interactions += neighbours_.pairs();
}

void Flow::Engine::evaluate_level(bool limited) {
  evaluate(time_, limited);
  if (settings_.walls != WallPressure::extrapolated) return;
  for (std::size_t i = neighbours_.fluid(); i < particles_.size(); ++i) {
    particles_.density[i] = stage_.records()[i].density;
  }
}

Rates Flow::Engine::rates() {
  fill_level();
  evaluate_level(false);
  return rates_.with_rates([](const auto& rates) {
    const auto copy = [](const auto& values) { return std::vector<double>(values.begin(), values.end()); };
    return Rates{.dx = copy(rates.dx),
                 .dz = copy(rates.dz),
                 .du = copy(rates.du),
                 .dw = copy(rates.dw),
                 .ddensity = copy(rates.ddensity)};
  });
}

Flow::Engine::PaddlePoses Flow::Engine::paddles_at(double time) const {
  PaddlePoses poses;
  for (const Paddle& paddle : paddles_) {
    poses.pose.push_back(paddle.pose(time));
    poses.rate.push_back(paddle.rate(time));
  }
  return poses;
}

PointMotion Flow::Engine::carried_by_paddle(std::size_t i, const PaddlePoses& poses) const {
  const auto body = static_cast<std::size_t>(particles_.body[i]);
  const Paddle& paddle = paddles_[body];
  return carried(poses.pose[body], poses.rate[body], paddle.hinge_x, paddle.hinge_z, reference_x_[i], reference_z_[i]);
}

}  // namespace seiche::wcsph
