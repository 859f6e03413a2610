#include "seiche/exact/shallow_water/riemann.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

SelfTest jump_identities(const std::string& name, double gravity, sw::State left, sw::State right, double speed,
                         double largest) {
  const auto mass = [&](sw::State s) { return s.depth * (s.velocity - speed); };
  const auto momentum = [&](sw::State s) { return mass(s) * (s.velocity - speed) + sw::thrust(gravity, s.depth); };
  // The fluxes are differences of velocities: their rounding is that of depth times the largest velocity.
  const double velocity = std::max({std::abs(left.velocity), std::abs(right.velocity), std::abs(speed), largest});
  const double depth = std::max(left.depth, right.depth);
  const auto conserved = [&](const std::string& what, auto flux, double scale) {
    return Identity{what + " is conserved across " + name, std::abs(flux(left) - flux(right)) / scale, 32 * epsilon,
                    "about ten roundings on each side, and those of depth, velocity and speed themselves"};
  };
  return {conserved("mass", mass, depth * velocity),
          conserved("momentum", momentum, depth * velocity * velocity + sw::thrust(gravity, depth))};
}

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
  require_that(wet_left || wet_right, "left_depth and right_depth are both 0: one must be positive");
  if (!wet_left) left_.velocity = 0;
  if (!wet_right) right_.velocity = 0;
  // A celerity of less than a rounding of the largest speed is lost beside it, and three depths are multiplied.
  const double square = std::max(left_.velocity * left_.velocity, right_.velocity * right_.velocity);
  const double largest = std::max({left_.depth, right_.depth, square / gravity});
  const double least = std::max(1e-100, std::pow(epsilon, 2) * largest);
  for (const auto& [name, depth] : {std::pair("left_depth", left_.depth), std::pair("right_depth", right_.depth)}) {
    require_that(
        depth == 0 || depth >= least,
        "{} = {:.17g} is out of range: must be 0 (dry) or at least {:.2g} here, for its waves not to be lost in "
        "the rounding of the larger ones",
        name, depth, least);
  }

  if (wet_left && wet_right) star_ = sw::star_state(gravity, left_, right_);
  // The wave beside a state, seen along x (side = -1, left) or against it, as (outer, inner) end.
  const auto wave = [&](double side, State own, State other) {
    const double c = sw::celerity(gravity, own.depth);
    const auto ends = [&](Kind kind, double outer, double inner) {
      return side < 0 ? Wave{kind, outer, inner} : Wave{kind, inner, outer};
    };
    if (own.depth == 0) {  // carries no wave of its own: the front of the other fan bounds it
      const double front = other.velocity + side * 2 * sw::celerity(gravity, other.depth);
      return ends(Kind::dry, front, front);
    }
    if (star_.depth > own.depth) {
      const double speed = own.velocity + side * sw::jump_mass_flux(gravity, own.depth, star_.depth) / own.depth;
      return ends(Kind::jump, speed, speed);
    }
    const double outer = own.velocity + side * c;
    const double inner =
        star_.depth > 0 ? star_.velocity + side * sw::celerity(gravity, star_.depth) : own.velocity - side * 2 * c;
    return ends(star_.depth == own.depth ? Kind::none : Kind::fan, outer,
                side < 0 ? std::max(inner, outer) : std::min(inner, outer));
  };
  left_wave_ = wave(-1, left_, right_);
  right_wave_ = wave(1, right_, left_);
}

Riemann::State Riemann::sample(double speed) const {
  if (speed < left_wave_.slowest) return left_;
  if (speed > right_wave_.fastest) return right_;
  // u + 2c is constant across the left fan and u - c = x/t; mirrored on the right.
  const auto fan = [&](double side, State own) {
    const double still = 2 * sw::celerity(gravity_, own.depth);
    const double c = (side < 0 ? own.velocity + still - speed : speed - own.velocity + still) / 3;
    return State{c * c / gravity_, c > 0 ? speed - side * c : 0.0};
  };
  if (left_wave_.kind == Kind::fan && speed <= left_wave_.fastest) return fan(-1, left_);
  if (right_wave_.kind == Kind::fan && speed >= right_wave_.slowest) return fan(1, right_);
  return star_;
}

Riemann::State Riemann::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  if (t == 0) return x < jump_ ? left_ : right_;
  return sample((x - jump_) / t);
}

std::vector<double> Riemann::breakpoints(double t) const {
  require_not_negative("t", t);
  if (t == 0) return {jump_};
  return {jump_ + left_wave_.slowest * t, jump_ + left_wave_.fastest * t, jump_ + right_wave_.slowest * t,
          jump_ + right_wave_.fastest * t};
}

SelfTest Riemann::self_test() const {
  SelfTest tests;
  // The velocity between the waves is the mean of those beside them and of two changes.
  const double largest = std::max(std::abs(left_.velocity), std::abs(right_.velocity));
  const auto add = [&](const Wave& wave, const State& outer, double side, const std::string& name) {
    if (wave.kind == Kind::jump) {
      std::ranges::move(jump_identities(name, gravity_, outer, star_, wave.slowest, largest),
                        std::back_inserter(tests));
    } else if (wave.kind == Kind::fan) {
      const auto invariant = [&](const State& s) { return s.velocity - side * 2 * sw::celerity(gravity_, s.depth); };
      const double edge = side < 0 ? wave.fastest : wave.slowest;
      // On a dry bed the edge has no depth, and the velocity there is 0 by definition: the middle of the fan has both.
      const State inner = sample(star_.depth > 0 ? edge : 0.5 * (wave.slowest + wave.fastest));
      tests.push_back({fmt::format("u {} 2c is constant through {}", side < 0 ? "+" : "-", name),
                       std::abs(invariant(inner) - invariant(outer)) /
                           (std::abs(outer.velocity) + 2 * sw::celerity(gravity_, outer.depth)),
                       32 * epsilon, "about ten roundings in each invariant"});
    }
  };
  add(left_wave_, left_, -1, "the left wave");
  add(right_wave_, right_, 1, "the right wave");
  return tests;
}

namespace {

double checked_wall(const Bore& incident, double wall) {
  require_finite("wall", wall);
  require_that(incident.ahead().velocity == 0,
               "velocity ahead of the bore = {:.17g} is out of range: must be 0 at a wall", incident.ahead().velocity);
  require_that(wall > incident.position(0), "wall = {:.17g} is out of range: must lie beyond the bore's start = {:g}",
               wall, incident.position(0));
  return wall;
}

}  // namespace

Bore::Bore(double gravity, double ahead, double behind, double ahead_velocity, double start)
    : gravity_(gravity), ahead_{ahead, ahead_velocity}, start_(start) {
  require_positive("gravity", gravity);
  require_finite("velocity ahead of the bore", ahead_velocity);
  require_finite("start", start);
  require_all_positive({{"depth ahead of the jump", ahead}, {"depth behind the jump", behind}});
  require_that(behind > ahead,
               "depth behind the jump = {:.17g} is out of range: must exceed the depth ahead = {:g} (a jump loses "
               "energy)",
               behind, ahead);
  flux_ = sw::jump_mass_flux(gravity, ahead, behind);
  behind_ = {behind, ahead_velocity + sw::velocity_change(gravity, behind, ahead)};
}

Bore Bore::from_velocity(double gravity, double behind, double behind_velocity, double start) {
  require_all_positive(
      {{"gravity", gravity}, {"depth behind the jump", behind}, {"velocity behind the jump", behind_velocity}});
  // u1 falls from infinity to 0 as the depth ahead grows from 0 to h1; (h1/h0)(g h1/2) > u1^2 bounds the root below
  // within a factor that the bracket covers by halving.
  const auto excess = [&](double ahead) { return sw::velocity_change(gravity, behind, ahead) - behind_velocity; };
  double low = behind;
  do {
    low *= 0.5;
  } while (excess(low) < 0 && low > 1e-300);
  return {gravity, root_at_end(excess, low, behind), behind, 0, start};
}

sw::State Bore::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  return x < position(t) ? behind_ : ahead_;
}

CollidingBores::CollidingBores(double gravity, double left, double middle, double right, double left_start,
                               double right_start)
    : left_(gravity, middle, left, 0, left_start),
      right_(gravity, middle, right, 0, -right_start),
      time_((right_start - left_start) / (left_.speed() + right_.speed())),
      after_(gravity, left_.behind(), {right, -right_.behind_velocity()}, left_.position(time_)) {
  require_that(right_start > left_start, "right_start = {:.17g} is out of range: must exceed left_start = {:g}",
               right_start, left_start);
}

sw::State CollidingBores::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  if (t >= time_) return after_.at(x, t - time_);
  if (x < left_.position(t)) return after_.left();
  return x > -right_.position(t) ? after_.right() : left_.ahead();
}

std::vector<double> CollidingBores::breakpoints(double t) const {
  if (t >= time_) return after_.breakpoints(t - time_);
  return {left_.position(t), -right_.position(t)};
}

BoreReflection::BoreReflection(const Bore& incident, double wall)
    : wall_(checked_wall(incident, wall)),
      with_image_(incident.gravity(), incident.behind().depth, incident.ahead().depth, incident.behind().depth,
                  incident.position(0), 2 * wall - incident.position(0)) {}

double BoreReflection::position(double t) const {
  require_not_negative("t", t);
  return t < reflection_time() ? incident().position(t) : wall_ + reflected_speed() * (t - reflection_time());
}

sw::State BoreReflection::at(double x, double t) const {
  require_finite("x", x);
  require_that(x <= wall_, "x = {:.17g} is out of range: the wall is at {:g}", x, wall_);
  return with_image_.at(x, t);
}

SelfTest BoreReflection::self_test() const {
  SelfTest tests = jump_identities("the incident bore", incident().gravity(), incident().behind(), incident().ahead(),
                                   incident().speed());
  std::ranges::move(jump_identities("the reflected bore", incident().gravity(), incident().behind(),
                                    {reflected_depth(), 0}, reflected_speed()),
                    std::back_inserter(tests));
  return tests;
}

ExactSolution riemann_entry() {
  return Entry<Riemann>{
      .name = "riemann",
      .title = "Two uniform states of shallow water meet: dam breaks, bores, dry fronts",
      .citation =
          "Toro, Shock-capturing methods for free-surface shallow flows (2001), ch. 5-6; Stoker, Water Waves (1957)",
      .formula =
          "f(h*, hL) + f(h*, hR) + uR - uL = 0; f = 2 (c* - cK) in a fan, (h* - hK) sqrt(g (h* + hK)/(2 h* hK)) in a "
          "jump; fans: c = (uL + 2 cL - x/t)/3, c = (x/t - uR + 2 cR)/3",
      .parameters = {{"left_depth", "m", 1, 0, 1e6, "depth on the left; 0 is dry"},
                     {"left_velocity", "m/s", 0, -1e6, 1e6, "velocity on the left"},
                     {"right_depth", "m", 0.1, 0, 1e6, "depth on the right; 0 is dry"},
                     {"right_velocity", "m/s", 0, -1e6, 1e6, "velocity on the right"},
                     gravity_parameter(),
                     {"jump", "m", 0, -1e9, 1e9, "position of the discontinuity at t = 0"}},
      .inputs = {position_x, time_t},
      .outputs = {depth_h, {"u", "m/s", "velocity, 0 where dry"}},
      .scalars =
          {{"star_depth", "m", "depth between the waves, 0 if dry", &Riemann::star, &sw::State::depth},
           {"star_velocity", "m/s", "velocity between the waves, 0 if dry", &Riemann::star, &sw::State::velocity},
           {"left_wave_slowest", "m/s", "left end of the left wave", &Riemann::left_wave, &Riemann::Wave::slowest},
           {"left_wave_fastest", "m/s", "right end of the left wave, equal for a jump", &Riemann::left_wave,
            &Riemann::Wave::fastest},
           {"right_wave_slowest", "m/s", "left end of the right wave", &Riemann::right_wave, &Riemann::Wave::slowest},
           {"right_wave_fastest", "m/s", "right end of the right wave, equal for a jump", &Riemann::right_wave,
            &Riemann::Wave::fastest},
           {"discharge_at_jump", "m^2/s", "h u where the states met, t > 0",
            [](const Riemann& solution) { return solution.sample(0).depth * solution.sample(0).velocity; }}},
      .make = made_by(
          [](double g, double left, double u_left, double right, double u_right, double jump) {
            return Riemann(g, {left, u_left}, {right, u_right}, jump);
          },
          "gravity", "left_depth", "left_velocity", "right_depth", "right_velocity", "jump"),
      .row = state_row<Riemann>};
}

ExactSolution bore_reflection_entry() {
  return Entry<BoreReflection>{
      .name = "bore_reflection",
      .title = "A bore runs into still water and reflects from a wall",
      .citation =
          "Stoker, Water Waves (1957), section 10.7; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves "
          "by the particle method, section 5",
      .formula = "u1 = (h2 - h1) sqrt(g (h2 + h1)/(2 h1 h2)), a- = -u1 h1/(h2 - h1)",
      .parameters = {{"behind_depth", "m", 1, 1e-9, 1e6, "depth behind the incident bore"},
                     {"behind_velocity", "m/s", 1.3, 1e-9, 1e6, "velocity behind the incident bore"},
                     gravity_parameter(),
                     {"start", "m", 5, -1e9, 1e9, "position of the bore at t = 0"},
                     {"wall", "m", 10, -1e9, 1e9, "position of the wall, beyond start"}},
      .inputs = {position_x, time_t},
      .outputs = {depth_h, {"u", "m/s", "velocity"}},
      .scalars = {{"ahead_depth", "m", "depth of the still water", &BoreReflection::incident, &Bore::ahead,
                   &sw::State::depth},
                  {"incident_speed", "m/s", "velocity of the incident bore", &BoreReflection::incident, &Bore::speed},
                  {"reflection_time", "s", "when the bore meets the wall", &BoreReflection::reflection_time},
                  {"reflected_depth", "m", "depth at the wall afterwards", &BoreReflection::reflected_depth},
                  {"reflected_speed", "m/s", "velocity of the reflected jump", &BoreReflection::reflected_speed}},
      .make = made_by(&BoreReflection::from_velocity, "gravity", "behind_depth", "behind_velocity", "start", "wall"),
      .row = state_row<BoreReflection>};
}

}  // namespace seiche::exact
