#include "seiche/models/shallow_water_particles/collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace seiche::shallow_water_particles {

using shallow_water::jump_mass_flux;
using shallow_water::star_state;
using shallow_water::thrust;
using shallow_water::two_rarefaction_depth;

Collision::Collision(double gravity, const InteriorJump& right_going, const InteriorJump& left_going, const Array& mass)
    : gravity_(gravity),
      left_(right_going.behind),
      right_(left_going.behind),
      track_{},
      origin_(right_going.particle),
      left_particle_(right_going.particle),
      right_particle_(left_going.particle) {
  const double right_edge = edge_mass(right_particle_ + 1, mass);
  const State a = right_going.ahead;
  const State b = left_going.ahead;
  track_ = {right_going.behind_by_volume * mass[left_particle_],
            right_edge - left_going.behind_by_volume * mass[right_particle_],
            right_going.mass_flux,
            -left_going.mass_flux,
            {0.5 * (a.depth + b.depth), 0.5 * (a.velocity + b.velocity)}};
}

double Collision::edge_mass(std::size_t edge, const Array& mass) const {
  double position = 0;
  for (std::size_t i = origin_; i < edge; ++i) position += mass[i];
  for (std::size_t i = edge; i < origin_; ++i) position -= mass[i];
  return position;
}

double Collision::fastest_mass_flux() const {
  const double now = std::max(std::abs(track_.left_speed), std::abs(track_.right_speed));
  if (met_) return now;
  const Track later = after_meeting(0);
  return std::max({now, std::abs(later.left_speed), later.right_speed});
}

Collision::Track Collision::after_meeting(double position) const {
  const State between = star_state(gravity_, left_, right_);
  return {position, position, -jump_mass_flux(gravity_, left_.depth, between.depth),
          jump_mass_flux(gravity_, right_.depth, between.depth), between};
}

Structure Collision::structure(std::size_t particle, const Array& mass) const {
  const double start = edge_mass(particle, mass);
  const double end = start + mass[particle];
  const double first = std::clamp(track_.left, start, end);
  const double second = std::clamp(track_.right, start, end);
  Structure s;
  s.particle = particle;
  const auto add = [&](State state, double from, double to) {
    if (to > from) s.layers[static_cast<std::size_t>(s.count++)] = {state, (to - from) / mass[particle]};
  };
  add(left_, start, first);
  add(track_.between, first, second);
  add(right_, second, end);
  return s;
}

EdgeState Collision::average(std::size_t edge, const Array& mass, double tau, EdgeState base) const {
  struct Passage {
    double time;
    State after;
  };
  std::array<Passage, 4> passages{};
  std::size_t count = 0;
  const double position = edge_mass(edge, mass);
  // Passages of one jump that starts at `from` with `speed` at time `begin` and moves until `end`.
  const auto pass = [&](double from, double speed, double begin, double end, State after) {
    const double time = begin + (position - from) / speed;
    if (position == from || !(time > begin && time <= end)) return;
    std::size_t place = count++;  // kept in order of time
    for (; place > 0 && passages[place - 1].time > time; --place) passages[place] = passages[place - 1];
    passages[place] = {time, after};
  };
  const double meeting = met_ ? 2 * tau : (track_.right - track_.left) / (track_.left_speed - track_.right_speed);
  const double first_phase = std::min(meeting, tau);
  // Before the meeting jumps bring the outer states to an edge; after it they bring the state between them.
  pass(track_.left, track_.left_speed, 0, first_phase, met_ ? track_.between : left_);
  pass(track_.right, track_.right_speed, 0, first_phase, met_ ? track_.between : right_);
  if (meeting < tau) {
    const Track later = after_meeting(track_.left + meeting * track_.left_speed);
    pass(later.left, later.left_speed, meeting, tau, later.between);
    pass(later.right, later.right_speed, meeting, tau, later.between);
  }
  if (count == 0) return base;
  EdgeState sum = {base.velocity * passages[0].time, base.thrust * passages[0].time};
  for (std::size_t k = 0; k < count; ++k) {
    const double span = (k + 1 < count ? passages[k + 1].time : tau) - passages[k].time;
    sum.velocity += span * passages[k].after.velocity;
    sum.thrust += span * thrust(gravity_, passages[k].after.depth);
  }
  return {sum.velocity / tau, sum.thrust / tau};
}

void Collision::renumber(bool more) {
  for (std::size_t* particle : {&origin_, &left_particle_, &right_particle_}) more ? ++*particle : --*particle;
}

void Collision::advance(double tau, const Array& mass) {
  const double meeting = met_ ? 2 * tau : (track_.right - track_.left) / (track_.left_speed - track_.right_speed);
  double rest = tau;
  if (meeting < tau) {
    track_ = after_meeting(track_.left + meeting * track_.left_speed);
    met_ = true;
    rest = tau - meeting;
  }
  track_.left += rest * track_.left_speed;
  track_.right += rest * track_.right_speed;
  const auto locate = [&](double position, std::size_t particle) {
    while (particle > 0 && position < edge_mass(particle, mass)) --particle;
    while (particle + 1 < mass.size() && position > edge_mass(particle + 1, mass)) ++particle;
    return particle;
  };
  left_particle_ = locate(track_.left, left_particle_);
  right_particle_ = locate(track_.right, right_particle_);
}

double InteriorJump::size() const {
  return std::abs(behind.depth - ahead.depth);
}

bool InteriorJump::inside() const {
  constexpr double guard = 1e-9;
  const auto holds = [](double fraction) { return fraction > guard && fraction < 1 - guard; };
  return holds(behind_by_volume) && holds(behind_by_momentum);
}

Structure structure_of(const InteriorJump& jump) {
  Structure s;
  s.particle = jump.particle;
  s.count = 2;
  const double behind = jump.behind_by_volume;
  const std::size_t first = jump.facing == Facing::right ? 0 : 1;
  s.layers[first] = {jump.behind, behind};
  s.layers[1 - first] = {jump.ahead, 1 - behind};
  return s;
}

std::optional<InteriorJump> jump_between(double gravity, State left, State mean, State right, double threshold) {
  if (!(left.velocity > right.velocity)) return std::nullopt;
  // The Hugoniot curve lies above the curve of simple waves: the two-wave depth bounds the middle depth from above,
  // and most compressions are dismissed without an iteration.
  const double bound = two_rarefaction_depth(gravity, left, right);
  if (bound - right.depth <= threshold * right.depth && bound - left.depth <= threshold * left.depth) {
    return std::nullopt;
  }
  const State star = star_state(gravity, left, right);
  const double rise_right = star.depth - right.depth;
  const double rise_left = star.depth - left.depth;
  InteriorJump jump;
  jump.behind = star;
  if (rise_right > threshold * right.depth && rise_right > rise_left) {
    jump.facing = Facing::right;
    jump.ahead = right;
  } else if (rise_left > threshold * left.depth && rise_left > rise_right) {
    jump.facing = Facing::left;
    jump.ahead = left;
  } else {
    return std::nullopt;
  }
  const State a = jump.ahead;
  const State b = jump.behind;
  jump.behind_by_volume = (1 / a.depth - 1 / mean.depth) / (1 / a.depth - 1 / b.depth);
  jump.behind_by_momentum = (mean.velocity - a.velocity) / (b.velocity - a.velocity);
  if (!jump.inside()) return std::nullopt;
  jump.mass_flux = jump_mass_flux(gravity, a.depth, b.depth);
  return jump;
}

void hand_over(double gravity, const InteriorJump& jump, double mass, double tau, double& velocity,
               double& edge_thrust) {
  const double by_volume = (1 - jump.behind_by_volume) * mass / jump.mass_flux;
  const double by_momentum = (1 - jump.behind_by_momentum) * mass / jump.mass_flux;
  // Of a value that another one takes the place of once the jump has passed.
  const auto average = [tau](double passes, double ahead, double behind, double& value) {
    if (passes < tau) value = (ahead * passes + behind * (tau - passes)) / tau;
  };
  if (jump.leaves_through_wall) {
    // The wall keeps its velocity; behind the reflected jump the pressure is that of the reflected state.
    return average(by_momentum, thrust(gravity, jump.ahead.depth), thrust(gravity, jump.reflected.depth), edge_thrust);
  }
  average(by_volume, velocity, jump.behind.velocity, velocity);
  average(by_momentum, edge_thrust, thrust(gravity, jump.behind.depth), edge_thrust);
}

}  // namespace seiche::shallow_water_particles
