#include "seiche/models/wcsph/flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

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

/// A period of at least three supports with their reserve: a particle meets one image of another at most.
void check_period(const Settings& settings, double smoothing_length) {
  const double shortest = 3 * support * smoothing_length * (1 + skin);
  for (const auto& [name, period] :
       {std::pair{"period.x", settings.period.x}, std::pair{"period.z", settings.period.z}}) {
    require_that(period >= shortest, "{} = {:.17g} is out of range: must be at least three supports, {:g}", name,
                 period, shortest);
  }
}

/// No two fluid particles in one place, none in a wall.
void check_distances(const Particles& particles, std::span<const Image> images, std::span<const Cluster> clusters,
                     double spacing) {
  const std::size_t count = particles.size();
  // A lattice that stands exactly at the limit is all right.
  const double nearest_wall = 0.5 * spacing * (1 - 1e-9);
  const double nearest_fluid = 1e-6 * spacing;
  for (const Cluster& cluster : clusters) {
    for (std::int32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
      const auto a = static_cast<std::size_t>(i);
      if (particles.kind[a] != Kind::fluid) continue;
      for (const std::int32_t* j = cluster.begin; j != cluster.end; ++j) {
        const auto record = static_cast<std::size_t>(*j);
        const Image other = record < count ? Image{*j, 0, 0} : images[record - count];
        const auto b = static_cast<std::size_t>(other.source);
        if (b == a) continue;
        const double x = particles.x[b] + other.shift_x;
        const double z = particles.z[b] + other.shift_z;
        const double distance = std::hypot(particles.x[a] - x, particles.z[a] - z);
        const bool wall = particles.kind[b] != Kind::fluid;
        if (distance >= (wall ? nearest_wall : nearest_fluid)) continue;
        throw std::invalid_argument(fmt::format(
            "particles {} at ({:.9g}, {:.9g}) and {} at ({:.9g}, {:.9g}) are {:.3g} apart: {}", particles.identity[a],
            particles.x[a], particles.z[a], particles.identity[b], x, z, distance,
            wall ? fmt::format("fluid must keep {:g}, half a spacing, from walls", 0.5 * spacing)
                 : fmt::format("two fluid particles must keep {:g}, a millionth of the spacing", nearest_fluid)));
      }
    }
  }
}

Particles checked(Particles particles, const Settings& settings, double spacing, std::span<const Paddle> paddles) {
  validate(settings);
  require_positive("spacing", spacing);
  check_period(settings, settings.smoothing * spacing);
  check_particles(particles, paddles);
  return particles;
}

/// Of a parameter of Flow::parameters().
std::string name_of(std::size_t parameter) {
  std::istringstream names(
      "spacing kernel smoothing gravity density sound_speed xsph filter_every density_diffusion "
      "particle_shifting walls courant period.x period.z lanes viscosity alpha "
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

Flow::Flow(Particles particles, double spacing, Settings settings, std::vector<Paddle> paddles)
    : settings_(settings),
      spacing_(spacing),
      fluid_(settings.density, settings.sound_speed),
      smoothing_(settings.smoothing * spacing),
      paddles_(std::move(paddles)),
      particles_(checked(std::move(particles), settings, spacing, paddles_)),
      reference_x_(paddles_.empty() ? std::vector<double>{} : particles_.x),
      reference_z_(paddles_.empty() ? std::vector<double>{} : particles_.z),
      mean_spacing_(mean_spacing(particles_, settings.density)),
      rates_(settings, spacing),
      corrections_(settings, spacing),
      stage_(fluid_, smoothing_, rates_.turbulent(), settings.walls == WallPressure::extrapolated),
      neighbours_(mean_spacing_, expected_box(particles_), settings.period,
                  pair_loops(settings.kernel, settings.lanes).lanes),
      reserve_(skin * support * smoothing_),
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

void Flow::check_start() const {
  if (const auto* laminar = std::get_if<LaminarSps>(&settings_.viscosity)) {
    const double highest = viscous_courant * smoothing_ * settings_.sound_speed / (shortest_step * settings_.courant);
    require_that(
        laminar->kinematic_viscosity <= highest,
        "kinematic viscosity nu0 = {:.17g} m^2/s is out of range: must be in [0, {:g}], or a stable step, 0.125 "
        "h^2/nu0, is below a thousandth of the acoustic one",
        laminar->kinematic_viscosity, highest);
  }
  check_distances(particles_, neighbours_.images(), neighbours_.clusters(), spacing_);
}

void Flow::list(double reserve, double used) {
  const double lowest = *std::min_element(particles_.density.begin(), particles_.density.end());
  neighbours_.arrange(particles_, smoothing_ * std::max(1.0, std::sqrt(settings_.density / lowest)), reserve);
  stage_.adopt(particles_, neighbours_.images(), used);
  neighbours_.list(stage_.records(), pair_loops(settings_.kernel, settings_.lanes).search, reserve);
  listed_reserve_ = reserve;
  listed_pairs_ = neighbours_.pairs();
}

void Flow::sort(double reserve) {
  neighbours_.sort(particles_);
  if (!paddles_.empty()) {
    std::vector<double> scratch;
    neighbours_.reorder(reference_x_, scratch);
    neighbours_.reorder(reference_z_, scratch);
  }
  list(reserve, 0);
  ++extremes_.rebuilds;

  const double usual = std::numbers::pi * std::pow(support * smoothing_ / mean_spacing_, 2);
  if (neighbours_.most_neighbours() > clump * usual) {
    throw Divergence(
        fmt::format("{:.0f} neighbours of a particle, {:.0f} are usual", neighbours_.most_neighbours(), usual), time_,
        steps_, particles_.x[neighbours_.most_crowded()]);
  }
}

void Flow::refresh_lists() {
  if (stage_.used() + half_travel_ > reserve_) sort(reserve_);
}

void Flow::evaluate(double time, bool limited) {
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
    corrections_.extrapolate(felt_gravity, stage_, neighbours_);
  }
  rates_.evaluate(stage_, neighbours_, limited);
  std::vector<double>& ddensity = rates_.rates().ddensity;
  if (settings_.walls == WallPressure::extrapolated) {
    std::fill(ddensity.begin() + static_cast<std::ptrdiff_t>(neighbours_.fluid()), ddensity.end(), 0.0);
  }
  corrections_.add_diffusion(stage_, neighbours_, ddensity);
  extremes_.interactions += listed_pairs_;
}

void Flow::evaluate_level(bool limited) {
  evaluate(time_, limited);
  if (settings_.walls != WallPressure::extrapolated) return;
  for (std::size_t i = neighbours_.fluid(); i < particles_.size(); ++i) {
    particles_.density[i] = stage_.records()[i].density;
  }
}

Rates Flow::rates() {
  refresh_lists();
  evaluate_level(false);
  return rates_.rates();
}

Flow::PaddlePoses Flow::paddles_at(double time) const {
  PaddlePoses poses;
  for (const Paddle& paddle : paddles_) {
    poses.pose.push_back(paddle.pose(time));
    poses.rate.push_back(paddle.rate(time));
  }
  return poses;
}

PointMotion Flow::carried_by_paddle(std::size_t i, const PaddlePoses& poses) const {
  const auto body = static_cast<std::size_t>(particles_.body[i]);
  const Paddle& paddle = paddles_[body];
  return carried(poses.pose[body], poses.rate[body], paddle.hinge_x, paddle.hinge_z, reference_x_[i], reference_z_[i]);
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

std::vector<Invariant> Flow::invariants() const {
  const Totals sums = totals();
  return {{"mass", sums.mass, 0},
          {"momentum_x", sums.momentum[0], 0},
          {"momentum_z", sums.momentum[1], 0},
          {"angular_momentum", sums.angular_momentum, 0},
          {"energy", sums.energy(), 0}};
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

std::vector<double> Flow::parameters(double time) const {
  // All settings that there are: with one more this does not compile.
  const auto& [kernel, smoothing, gravity, density, sound_speed, viscosity, xsph, filter_every, diffusion, shifting,
               walls, courant, period, lanes] = settings_;
  const auto* artificial = std::get_if<ArtificialViscosity>(&viscosity);
  const auto* given = std::get_if<LaminarSps>(&viscosity);
  const LaminarSps sps = given != nullptr ? *given : LaminarSps{0, 0, 0};
  std::vector<double> all;
  const auto add = [&](auto... values) { (all.push_back(static_cast<double>(values)), ...); };
  add(spacing_, kernel, smoothing, gravity, density, sound_speed, xsph, filter_every, diffusion, shifting, walls,
      courant, period.x, period.z, lanes, viscosity.index(), artificial != nullptr ? artificial->alpha : 0,
      sps.kinematic_viscosity, sps.smagorinsky, sps.isotropic, paddles_.size());
  const PaddlePoses at = paddles_at(time);
  for (std::size_t k = 0; k < paddles_.size(); ++k) {
    add(paddles_[k].hinge_x, paddles_[k].hinge_z, at.pose[k].displacement, at.pose[k].angle, at.rate[k].displacement,
        at.rate[k].angle);
  }
  return all;
}

FlowState Flow::state() const {
  return {.parameters = parameters(time_),
          .particles = particles_,
          .reference_x = reference_x_,
          .reference_z = reference_z_,
          .listed = {listed_reserve_, stage_.used(), listed_pairs_},
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
  require_that(state.reference_x.size() == reference_x_.size() && state.reference_z.size() == reference_z_.size(),
               "state with other arrays than of {} particles: must be as state() gave it", n);
  const auto& kinds = state.particles.kind;
  require_that(std::is_partitioned(kinds.begin(), kinds.end(), [](Kind kind) { return kind == Kind::fluid; }),
               "state with its particles in another order than state() gave: fluid must come first");
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
  // Lists may be made of later places than at the last sorting: sums run in the order of the particles all the same.
  list(state.listed.reserve, state.listed.used);
  listed_pairs_ = state.listed.pairs;
  level_known_ = false;
  half_travel_ = state.half_travel;
  extremes_ = state.extremes;
}

}  // namespace seiche::wcsph
