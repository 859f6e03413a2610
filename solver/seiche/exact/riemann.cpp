#include "seiche/exact/riemann.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/jump_identities.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

Riemann::Riemann(double gravity, State left, State right, double jump)
    : gravity_(gravity), left_(left), right_(right), jump_(jump) {
  require_positive("gravity", gravity);
  require_not_negative("left depth", left.depth);
  require_not_negative("right depth", right.depth);
  require_finite("left velocity", left.velocity);
  require_finite("right velocity", right.velocity);
  require_finite("jump", jump);
  const bool wet_left = left.depth > 0;
  const bool wet_right = right.depth > 0;
  if (!wet_left && !wet_right)
    throw std::invalid_argument("left_depth and right_depth are both 0: one must be positive");
  if (!wet_left) left_.velocity = 0;
  if (!wet_right) right_.velocity = 0;
  // A celerity of less than a rounding of the largest speed is lost beside it, and three depths are multiplied.
  const double square = std::max(left_.velocity * left_.velocity, right_.velocity * right_.velocity);
  const double largest = std::max({left_.depth, right_.depth, square / gravity});
  const double least = std::max(1e-100, std::pow(std::numeric_limits<double>::epsilon(), 2) * largest);
  for (const auto& [name, depth] : {std::pair("left_depth", left_.depth), std::pair("right_depth", right_.depth)}) {
    if (depth > 0 && depth < least) {
      throw std::invalid_argument(
          fmt::format("{} = {:.17g} is out of range: must be 0 (dry) or at least {:.2g} here, "
                      "for its waves not to be lost in the rounding of the larger ones",
                      name, depth, least));
    }
  }

  const double cl = sw::celerity(gravity, left_.depth);
  const double cr = sw::celerity(gravity, right_.depth);
  if (wet_left && wet_right) star_ = sw::star_state(gravity, left_, right_);
  const bool wet_star = star_.depth > 0;
  const double cs = sw::celerity(gravity, star_.depth);

  if (!wet_left) {
    // A dry side carries no wave of its own: the front of the other fan bounds it.
    left_wave_ = {Kind::dry, right_.velocity - 2 * cr, right_.velocity - 2 * cr};
  } else if (star_.depth > left_.depth) {
    const double speed = left_.velocity - sw::jump_mass_flux(gravity, left_.depth, star_.depth) / left_.depth;
    left_wave_ = {Kind::jump, speed, speed};
  } else {
    const double last = wet_star ? star_.velocity - cs : left_.velocity + 2 * cl;
    const Kind kind = star_.depth == left_.depth ? Kind::none : Kind::fan;
    left_wave_ = {kind, left_.velocity - cl, std::max(last, left_.velocity - cl)};
  }
  if (!wet_right) {
    right_wave_ = {Kind::dry, left_.velocity + 2 * cl, left_.velocity + 2 * cl};
  } else if (star_.depth > right_.depth) {
    const double speed = right_.velocity + sw::jump_mass_flux(gravity, right_.depth, star_.depth) / right_.depth;
    right_wave_ = {Kind::jump, speed, speed};
  } else {
    const double first = wet_star ? star_.velocity + cs : right_.velocity - 2 * cr;
    const Kind kind = star_.depth == right_.depth ? Kind::none : Kind::fan;
    right_wave_ = {kind, std::min(first, right_.velocity + cr), right_.velocity + cr};
  }
}

Riemann::State Riemann::sample(double speed) const {
  if (speed < left_wave_.slowest) return left_;
  if (speed > right_wave_.fastest) return right_;
  if (left_wave_.kind == Kind::fan && speed <= left_wave_.fastest) {
    // u + 2c is constant across the fan and u - c = x/t.
    const double c = (left_.velocity + 2 * sw::celerity(gravity_, left_.depth) - speed) / 3;
    return {c * c / gravity_, c > 0 ? speed + c : 0.0};
  }
  if (right_wave_.kind == Kind::fan && speed >= right_wave_.slowest) {
    const double c = (speed - right_.velocity + 2 * sw::celerity(gravity_, right_.depth)) / 3;
    return {c * c / gravity_, c > 0 ? speed - c : 0.0};
  }
  return star_;
}

Riemann::State Riemann::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  if (t == 0) return x < jump_ ? left_ : right_;
  return sample((x - jump_) / t);
}

double Riemann::discharge_at_jump() const {
  const State state = sample(0);
  return state.depth * state.velocity;
}

std::vector<double> Riemann::breakpoints(double t) const {
  require_not_negative("t", t);
  if (t == 0) return {jump_};
  return {jump_ + left_wave_.slowest * t, jump_ + left_wave_.fastest * t, jump_ + right_wave_.slowest * t,
          jump_ + right_wave_.fastest * t};
}

// Closed formulas of some ten roundings each; the depth between the waves is iterated to its last digit.
double Riemann::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest Riemann::self_test() const {
  SelfTest tests;
  const auto add = [&](const Wave& wave, const State& outer, double side, const std::string& name) {
    if (wave.kind == Kind::jump) {
      // The velocity between the waves is the mean of those beside them and of two changes.
      const double largest = std::max(std::abs(left_.velocity), std::abs(right_.velocity));
      const auto both = side < 0 ? jump_identities(name, gravity_, outer, star_, wave.slowest, largest)
                                 : jump_identities(name, gravity_, star_, outer, wave.slowest, largest);
      tests.insert(tests.end(), both.begin(), both.end());
    } else if (wave.kind == Kind::fan) {
      const auto invariant = [&](const State& s) { return s.velocity - side * 2 * sw::celerity(gravity_, s.depth); };
      const double edge = side < 0 ? wave.fastest : wave.slowest;
      // On a dry bed the edge has no depth, and the velocity there is 0 by definition: the middle of the fan has both.
      const State inner = sample(star_.depth > 0 ? edge : 0.5 * (wave.slowest + wave.fastest));
      tests.push_back({"u " + std::string(side < 0 ? "+" : "-") + " 2c is constant through " + name,
                       std::abs(invariant(inner) - invariant(outer)) /
                           (std::abs(outer.velocity) + 2 * sw::celerity(gravity_, outer.depth)),
                       32 * std::numeric_limits<double>::epsilon(), "about ten roundings in each invariant"});
    }
  };
  add(left_wave_, left_, -1, "the left wave");
  add(right_wave_, right_, 1, "the right wave");
  return tests;
}

Provenance Riemann::provenance() {
  return {"Toro, Shock-capturing methods for free-surface shallow flows (2001), ch. 5-6; Stoker, Water Waves (1957)",
          "f(h*, hL) + f(h*, hR) + uR - uL = 0; f = 2 (c* - cK) in a fan, (h* - hK) sqrt(g (h* + hK)/(2 h* hK)) in a "
          "jump; fans: c = (uL + 2 cL - x/t)/3, c = (x/t - uR + 2 cR)/3"};
}

static_assert(ReferenceSolution<Riemann>);

}  // namespace seiche::exact
