#include "seiche/exact/overturning/wall_runup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>

#include "seiche/divergence.hpp"
#include "seiche/exact/entry.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

/// Of one wave under the crest of the other at the start, relative to its amplitude. Superposition errs by products of
/// the two elevations, which are nowhere larger.
constexpr double negligible = 1e-13;
/// Of a collision, about.
constexpr double steps_of_collision = 300;

/// amplitude/depth of a wave that the method resolves. Throws std::invalid_argument.
double checked_ratio(double amplitude, double depth) {
  require_all_positive({{"depth", depth}, {"amplitude", amplitude}});
  require_within("amplitude/depth", amplitude / depth, 0.05, 0.6 * (1 + 1e-12));
  return amplitude / depth;
}

/// The waves a quarter of the channel from the wall. Units of depth and sqrt(depth/g) for the wave, of period/2 pi for
/// the motion: lengths times k, potentials times k^(3/2), times times sqrt(k).
ow::State start(std::size_t markers, const SolitaryWave& wave, double distance, double k) {
  const auto sum_of_waves = [&](const auto& of_right_going) {
    return [&, of_right_going](double x) {
      const double from_wall = (x - std::numbers::pi) / k;
      return of_right_going(from_wall + distance) + of_right_going(-from_wall + distance);
    };
  };
  return ow::from_functions(markers, sum_of_waves([&](double x) { return k * wave.elevation(x); }),
                            sum_of_waves([&](double x) { return std::pow(k, 1.5) * wave.surface_potential(x); }));
}

const std::vector<Parameter> wall_parameters{
    {"amplitude", "m", 0.3, 1e-9, 1e6, "of the incident wave, 0.05 to 0.6 depth"},
    depth_parameter(1, 1e6),
    {"markers", "1", 384, 128, 4096, "markers of the computation, even"}};

}  // namespace

WallRunup::WallRunup(double amplitude, double depth, std::size_t markers, double tolerance, double fall)
    : amplitude_(amplitude), depth_(depth), markers_(markers), wall_(markers / 2), tolerance_(tolerance) {
  const SolitaryWave wave(checked_ratio(amplitude, depth));
  require_at_least("markers", static_cast<long>(markers), 128);
  require_positive("tolerance", tolerance);
  require_within("markers modulo 2", static_cast<double>(markers % 2), 0, 0);
  const double distance = -0.5 * std::log(negligible) / wave.decay_rate();
  k_ = 2 * std::numbers::pi / (4 * distance);
  separation_ = distance * depth;
  crossing_ = std::sqrt(k_) * distance / wave.speed();
  auto motion = std::make_shared<ow::Evolution>(start(markers, wave, distance, k_), k_, k_ * tolerance);
  motion_ = motion;
  // Moves the waves on, by shares of the crossing, for as long as the condition holds at the wall.
  const auto advance_while = [&](double share, const auto& condition) {
    while (motion->ending() == ow::Ending::none && condition(motion->now())) {
      motion->advance_to(motion->now().time + share * crossing_);
    }
    if (motion->ending() == ow::Ending::none) return;
    throw Divergence(fmt::format("{} (markers = {} are too few, or the wave breaks)", motion->ending_reason(), markers),
                     motion->now().time / std::sqrt(k_), static_cast<long>(motion->moments().size() - 1),
                     motion->ending_place() / k_ * depth_);
  };
  const auto rise = [&](const ow::Moment& moment) {
    return moment.time < 0.5 * crossing_ ? 1.0 : ow::view(moment.rate).y[wall_];
  };
  motion->advance_to(0.9 * crossing_);
  advance_while(0.1, [&](const ow::Moment& now) { return rise(now) > 0 && now.time < 2 * crossing_; });
  highest_ = motion->at(motion->first_zero(rise, 1e-10).value());
  if (fall == 1) return;
  advance_while(0.02, [&](const ow::Moment& now) { return ow::view(now.state).y[wall_] * length() > fall * runup(); });
}

double WallRunup::su_mirie(double amplitude, double depth) {
  const double a = checked_ratio(amplitude, depth);
  return depth * (2 * a + a * a / 2 + 3 * a * a * a / 4);
}

double WallRunup::byatt_smith(double amplitude, double depth) {
  const double a = checked_ratio(amplitude, depth);
  return depth * (2 * a + a * a / 2);
}

double WallRunup::uncertainty() const {
  return departure(coarser<WallRunup>().runup(), runup());
}

Identity WallRunup::within_steps(const std::string& name, double defect) const {
  return kept_by_steps(name, defect, steps_of_collision, tolerance_ * depth_ / amplitude_, 2);
}

SelfTest WallRunup::identities(double ratio, std::size_t markers, double tolerance) {
  constexpr double stages = 6;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {kept_by_steps("volume is conserved", unknown, steps_of_collision, tolerance / ratio),
          kept_by_steps("energy is conserved until the water at the wall is highest", unknown, steps_of_collision,
                        tolerance / ratio, 2),
          {"the collision is symmetric", unknown,
           4 * epsilon * std::sqrt(steps_of_collision * stages * static_cast<double>(markers)),
           "nothing but round-off tells left from right: about 300 steps of six surfaces, each moved by sums over all "
           "markers"}};
}

SelfTest WallRunup::self_test() const {
  const ow::Invariants& start = motion_->moments().front().invariants;
  const auto y = ow::view(highest_.state).y;
  Worst asymmetry;
  for (std::size_t j = 1; j < wall_; ++j) asymmetry.add((y[wall_ + j] - y[wall_ - j]) * length() / runup());
  SelfTest test = identities(amplitude_ / depth_, markers_, tolerance_);
  test[0].defect = departure(highest_.invariants.volume, start.volume);
  test[1].defect = departure(highest_.invariants.energy(), start.energy());
  test[2].defect = asymmetry.value();
  return test;
}

WallLoad::WallLoad(double amplitude, double depth, std::size_t markers, double tolerance)
    : WallRunup(amplitude, depth, markers, tolerance, 0.5) {
  ow::SurfaceVelocity equation(markers, k_);
  for (const ow::Moment& moment : motion_->moments()) {
    if (moment.time > 0.5 * crossing_) history_.push_back(load(moment, equation));
  }
  still_ = largest(&Load::still);
  bottom_ = largest(&Load::bottom);
  force_ = largest(&Load::force);
}

WallLoad::Load WallLoad::load(const ow::Moment& moment, ow::SurfaceVelocity& equation) const {
  const ow::WallColumn water(moment, k_, equation);
  return {.time = moment.time / std::sqrt(k_),
          .level = water.level() * length(),
          .still = water.level() > 0 ? water.pressure(0) * length() : 0,
          .bottom = water.pressure(-k_) * length(),
          .force = water.force() * length() * length()};
}

WallLoad::Load WallLoad::at(double time) const {
  const double last = motion_->now().time / std::sqrt(k_);
  require_that<std::out_of_range>(time >= 0 && time <= last,
                                  "t = {:.17g} is outside [0, {:.6g}], until the water at the wall has fallen to half "
                                  "its height",
                                  time, last);
  ow::SurfaceVelocity equation(markers_, k_);
  return load(motion_->at(time * std::sqrt(k_)), equation);
}

WallLoad::Peak WallLoad::largest(double Load::*member) const {
  const auto top = std::ranges::max_element(history_, {}, member);
  const auto before = top == history_.begin() ? top : top - 1;
  const auto after = top + 1 == history_.end() ? top : top + 1;
  constexpr int bits = 26;  // of the time: the value at a maximum is known to twice as many
  const auto [time, value] = boost::math::tools::brent_find_minima([&](double t) { return -(at(t).*member); },
                                                                   before->time, after->time, bits);
  return {-value, time};
}

double WallLoad::still_series(double amplitude, double depth) {
  const double a = amplitude / depth;
  return WallRunup::su_mirie(amplitude, depth) - depth * 6 * a * a * a;
}

double WallLoad::uncertainty() const {
  const auto other = coarser<WallLoad>();
  return seiche::worst(std::array{other.still_.value / still_.value - 1, other.bottom_.value / bottom_.value - 1,
                                  other.force_.value / force_.value - 1});
}

SelfTest WallLoad::self_test() const {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  ow::SurfaceVelocity equation(markers_, k_);
  const double begin = 0.5 * crossing_;
  const ow::WallColumn before(motion_->at(begin), k_, equation);
  const ow::WallColumn after(highest_, k_, equation);
  // Over the time: of the force on the wall less that on the opposite one, and of the pressure at the foot without its
  // value at rest.
  double thrust = 0;
  double foot = 0;
  constexpr int parts = 10;
  const double half = 0.5 * (highest_.time - begin) / parts;
  for (int part = 0; part < parts; ++part) {
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double side : {-1.0, 1.0}) {
        const ow::WallColumn water(motion_->at(begin + half * (2 * part + 1 + side * Rule::abscissa()[i])), k_,
                                   equation);
        thrust += half * Rule::weights()[i] * (water.force() - water.opposite_force());
        foot += half * Rule::weights()[i] * (water.pressure(-k_) - k_);
      }
    }
  }
  return {within_steps("the force on the wall less that on the opposite one adds up to the change of the momentum",
                       std::abs(thrust - before.impulse() + after.impulse()) / before.impulse()),
          within_steps("the pressure at the foot of the wall adds up to the change of the potential there",
                       std::abs(foot + after.foot_potential() - before.foot_potential()) / std::abs(foot)),
          WallRunup::self_test()[1]};
}

ExactSolution wall_load_entry() {
  return Entry<WallLoad>{
      .name = "wall_load",
      .title = "Pressure and force of an exact solitary wave on a vertical wall",
      .citation =
          "Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980) 509; Fenton & "
          "Rienecker, A Fourier method for solving nonlinear water-wave problems, J. Fluid Mech. 118 (1982) 411; "
          "Cooker, Weidman & Bale, Reflection of a high-amplitude solitary wave at a vertical wall, J. Fluid Mech. 342 "
          "(1997) 141",
      .formula =
          "two mirrored solitary waves of the Euler equations moved by Cauchy's integral; p = -phi_t - v^2/2 - g y at "
          "the wall",
      .parameters = wall_parameters,
      .inputs = {{"t", "1", 0, "time since the crest was the separation from the wall, times sqrt(g/depth)"}},
      .outputs = {{"level", "m", "elevation of the water at the wall"},
                  {"still", "m", "pressure over rho g at the undisturbed level"},
                  {"bottom", "m", "pressure over rho g at the foot of the wall"},
                  {"force", "m^2", "force over rho g per unit width"}},
      .scalars = {{"largest_still", "m", "largest pressure over rho g at the undisturbed level",
                   &WallLoad::largest_still, &WallLoad::Peak::value},
                  {"largest_bottom", "m", "largest pressure over rho g at the foot of the wall",
                   &WallLoad::largest_bottom, &WallLoad::Peak::value},
                  {"largest_force", "m^2", "largest force over rho g per unit width", &WallLoad::largest_force,
                   &WallLoad::Peak::value},
                  {"time_of_still", "1", "when the pressure at the undisturbed level is largest, times sqrt(g/depth)",
                   &WallLoad::largest_still, &WallLoad::Peak::time},
                  {"time_of_bottom", "1", "when the pressure at the foot is largest, times sqrt(g/depth)",
                   &WallLoad::largest_bottom, &WallLoad::Peak::time},
                  {"time_of_force", "1", "when the force is largest, times sqrt(g/depth)", &WallLoad::largest_force,
                   &WallLoad::Peak::time},
                  {"separation", "m", "distance of the crest from the wall at t = 0", &WallLoad::separation}},
      .make = from<WallLoad>("amplitude", "depth", "markers"),
      .row = [](const WallLoad& wall, At at) {
        const auto [time, level, still, bottom, force] = wall.at(at[0]);
        return Row{level, still, bottom, force};
      }};
}

ExactSolution wall_runup_entry() {
  return Entry<WallRunup>{
      .name = "wall_runup",
      .title = "Run-up of an exact solitary wave on a vertical wall",
      .citation =
          "Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980) 509; Cooker, Weidman "
          "& Bale, Reflection of a high-amplitude solitary wave at a vertical wall, J. Fluid Mech. 342 (1997) 141",
      .formula = "two mirrored solitary waves of the Euler equations moved by Cauchy's integral; R = max y at the wall",
      .parameters = wall_parameters,
      .inputs = {},
      .outputs = {{"runup", "m", "highest elevation at the wall"}},
      .scalars = {{"su_mirie", "m", "series 2 a + a^2/2 + 3 a^3/4 of Su and Mirie, in depths",
                   [](const WallRunup& wall) { return WallRunup::su_mirie(wall.wave_amplitude(), wall.depth()); }},
                  {"byatt_smith", "m", "series 2 a + a^2/2 of Byatt-Smith, in depths",
                   [](const WallRunup& wall) { return WallRunup::byatt_smith(wall.wave_amplitude(), wall.depth()); }}},
      .make = from<WallRunup>("amplitude", "depth", "markers"),
      .row = [](const WallRunup& wall, At) { return Row{wall.runup()}; }};
}

}  // namespace seiche::exact
