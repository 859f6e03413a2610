#include "seiche/models/shallow_water_particles/self_similar_start.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::shallow_water_particles {

using shallow_water::celerity;
using shallow_water::State;
using shallow_water::thrust;

SelfSimilarStart::SelfSimilarStart(double gravity, std::optional<State> left, std::optional<State> right,
                                   std::size_t edge, std::size_t first, std::size_t last)
    : gravity_(gravity), edge_(edge), first_(first), last_(last) {
  if (left && right) {
    star_ = shallow_water::star_state(gravity, *left, *right);
  } else if (left) {
    star_ = {0, left->velocity + 2 * celerity(gravity, left->depth)};
  } else {
    star_ = {0, right->velocity - 2 * celerity(gravity, right->depth)};
  }
  const auto wave = [&](std::optional<State> outer, double sign) {
    Wave w{};
    w.present = outer.has_value();
    if (!outer) return w;
    w.outer = {outer->depth, sign * outer->velocity};
    w.inner = {star_.depth, sign * star_.velocity};
    w.fan = star_.depth < outer->depth;
    constexpr double negligible = 1e-9;  // the other side of a lone jump moves by round-off only
    if (std::abs(star_.depth - outer->depth) <= negligible * outer->depth) w.present = false;
    w.head = w.fan ? outer->depth * celerity(gravity, outer->depth)
                   : shallow_water::jump_mass_flux(gravity, outer->depth, star_.depth);
    w.tail = w.fan ? star_.depth * celerity(gravity, star_.depth) : w.head;
    return w;
  };
  right_ = wave(right, 1);
  left_ = wave(left, -1);
}

bool SelfSimilarStart::lone_jump() const {
  return !(left_.present && right_.present) && !(left_.present && left_.fan) && !(right_.present && right_.fan);
}

bool SelfSimilarStart::over(const Array& mass, double time, int particles) const {
  bool fan = false;
  bool wide_enough = true;
  bool at_end = false;
  for (const bool to_right : {false, true}) {
    const Wave& wave = to_right ? right_ : left_;
    if (!wave.present) continue;
    double swept = 0;
    int inside = 0;
    std::size_t k = edge_;
    const std::size_t last = to_right ? last_ : first_;
    while (k != last && swept < wave.head * time) {
      swept += mass[to_right ? k : k - 1];
      inside += swept > wave.tail * time;
      k = to_right ? k + 1 : k - 1;
    }
    at_end = at_end || k == last;
    if (wave.fan) {
      fan = true;
      wide_enough = wide_enough && inside >= particles;
    }
  }
  // Two jumps are left to themselves when they have swept that many particles.
  if (!fan) wide_enough = right_.head * time > particles * mass[edge_];
  return at_end || wide_enough;
}

EdgeState SelfSimilarStart::average(const Wave& wave, double mass, double from, double to) const {
  const double g = gravity_;
  const double arrival = mass / wave.head;
  const double passage = wave.tail > 0 ? mass / wave.tail : to;
  EdgeState sum{0, 0};
  const auto uniform = [&](State s, double start, double stop) {
    if (!(stop > start)) return;
    sum.velocity += (stop - start) * s.velocity;
    sum.thrust += (stop - start) * thrust(g, s.depth);
  };
  uniform(wave.outer, from, std::min(to, arrival));
  uniform(wave.inner, std::max(from, passage), to);
  const double start = std::max(from, arrival);
  const double stop = std::min(to, passage);
  if (stop > start) {
    // In the fan h c = mass/t, hence c^3 = g mass/t, and away from the wave u = u_outer - 2(c_outer - c).
    const double a = std::cbrt(g * mass);
    const double c_time = 1.5 * a * (std::cbrt(stop * stop) - std::cbrt(start * start));
    const double c4_time = 3 * a * a * a * a * (1 / std::cbrt(start) - 1 / std::cbrt(stop));
    sum.velocity += (stop - start) * (wave.outer.velocity - 2 * celerity(g, wave.outer.depth)) + 2 * c_time;
    sum.thrust += c4_time / (2 * g);
  }
  return {sum.velocity / (to - from), sum.thrust / (to - from)};
}

void SelfSimilarStart::replace(const Array& mass, double time, double tau, Array& velocity, Array& edge_thrust) const {
  velocity[edge_] = star_.velocity;
  edge_thrust[edge_] = thrust(gravity_, star_.depth);
  for (const bool to_right : {false, true}) {
    const Wave& wave = to_right ? right_ : left_;
    if (!wave.present) continue;
    double swept = 0;
    std::size_t k = edge_;
    const std::size_t last = to_right ? last_ : first_;
    while (k != last) {
      swept += mass[to_right ? k : k - 1];
      k = to_right ? k + 1 : k - 1;
      if (swept > wave.head * (time + tau)) break;
      const EdgeState e = average(wave, swept, time, time + tau);
      velocity[k] = to_right ? e.velocity : -e.velocity;
      edge_thrust[k] = e.thrust;
    }
  }
}

}  // namespace seiche::shallow_water_particles
