#include "seiche/exact/wall_load.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>

#include "seiche/exact/wall_runup.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

static_assert(ReferenceSolution<WallLoad>);

std::shared_ptr<const WallCollision> fallen(double amplitude, double depth, std::size_t markers, double tolerance) {
  auto collision = std::make_shared<WallCollision>(amplitude, depth, markers, tolerance);
  const double runup = ow::view(collision->highest().state).y[collision->wall()] * collision->length();
  collision->advance_until_below(0.5 * runup);
  return collision;
}

/// Over a time: of the force on the wall less that on the opposite one, and of the pressure at the foot without its
/// value at rest.
struct TimeIntegrals {
  double thrust = 0;
  double foot = 0;
};

TimeIntegrals integrate_loads(const ow::Evolution& motion, double begin, double end, double depth,
                              ow::SurfaceVelocity& equation) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  constexpr int parts = 10;
  const double half = 0.5 * (end - begin) / parts;
  TimeIntegrals sums;
  for (int part = 0; part < parts; ++part) {
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double side : {-1.0, 1.0}) {
        const double time = begin + half * (2 * part + 1 + side * Rule::abscissa()[i]);
        const ow::WallColumn water(motion.at(time), depth, equation);
        sums.thrust += half * Rule::weights()[i] * (water.force() - water.opposite_force());
        sums.foot += half * Rule::weights()[i] * (water.pressure(-depth) - depth);
      }
    }
  }
  return sums;
}

}  // namespace

WallLoad::WallLoad(double amplitude, double depth, std::size_t markers, double tolerance)
    : amplitude_(amplitude),
      depth_(depth),
      markers_(markers),
      tolerance_(tolerance),
      collision_(fallen(amplitude, depth, markers, tolerance)) {
  ow::SurfaceVelocity equation(markers_, collision_->wavenumber());
  for (const ow::Moment& moment : collision_->motion().moments()) {
    if (moment.time > 0.5 * collision_->crossing()) history_.push_back(load(moment, equation));
  }
  still_ = largest(&Load::still);
  bottom_ = largest(&Load::bottom);
  force_ = largest(&Load::force);
}

WallLoad::Load WallLoad::load(const ow::Moment& moment, ow::SurfaceVelocity& equation) const {
  const double length = collision_->length();
  const ow::WallColumn water(moment, collision_->wavenumber(), equation);
  return {.time = moment.time / std::sqrt(collision_->wavenumber()),
          .level = water.level() * length,
          .still = water.level() > 0 ? water.pressure(0) * length : 0,
          .bottom = water.pressure(-collision_->wavenumber()) * length,
          .force = water.force() * length * length};
}

WallLoad::Load WallLoad::at(double time) const {
  ow::SurfaceVelocity equation(markers_, collision_->wavenumber());
  return load(collision_->motion().at(time * std::sqrt(collision_->wavenumber())), equation);
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

double WallLoad::bottom_series(double amplitude, double depth) {
  const double a = WallCollision::checked_ratio(amplitude, depth);
  return depth * (1 + 2 * a - a * a);
}

double WallLoad::force_series(double amplitude, double depth) {
  const double a = WallCollision::checked_ratio(amplitude, depth);
  return depth * depth * (0.5 + 2 * a + 1.5 * a * a);
}

double WallLoad::uncertainty() const {
  const std::size_t fewer = std::max<std::size_t>(128, markers_ / 3 * 2);
  const WallLoad coarser(amplitude_, depth_, fewer, 10 * tolerance_);
  Worst change;
  change.add(coarser.still_.value / still_.value - 1);
  change.add(coarser.bottom_.value / bottom_.value - 1);
  change.add(coarser.force_.value / force_.value - 1);
  return change.value();
}

SelfTest WallLoad::self_test() const {
  const ow::Evolution& motion = collision_->motion();
  const double k = collision_->wavenumber();
  ow::SurfaceVelocity equation(markers_, k);
  const double begin = 0.5 * collision_->crossing();
  const ow::Moment& highest = collision_->highest();
  const ow::WallColumn before(motion.at(begin), k, equation);
  const ow::WallColumn after(highest, k, equation);
  const TimeIntegrals sums = integrate_loads(motion, begin, highest.time, k, equation);
  const double energy = highest.invariants.energy() / motion.moments().front().invariants.energy() - 1;
  constexpr double steps = 300;
  // Of the elevation, relative to the amplitude.
  const double integration = steps * std::pow(tolerance_ * depth_ / amplitude_, 1.2);
  const std::string reason =
      "about 300 steps whose errors of fourth order are kept at the tolerance and add up, over the amplitude; the "
      "solution of fifth order that is carried on errs less by a step, the fifth root of the tolerance";
  return {{"the force on the wall less that on the opposite one adds up to the change of the momentum",
           std::abs(sums.thrust - before.impulse() + after.impulse()) / before.impulse(), 2 * integration,
           reason + "; twice, once in the force and once in the momentum"},
          {"the pressure at the foot of the wall adds up to the change of the potential there",
           std::abs(sums.foot + after.foot_potential() - before.foot_potential()) / std::abs(sums.foot),
           2 * integration, reason + "; twice, once in the pressure and once in the potential"},
          {"energy is conserved until the water at the wall is highest", std::abs(energy), 2 * integration,
           reason + "; twice as much of a square"}};
}

Provenance WallLoad::provenance() {
  return {
      "Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980) 509; Fenton & Rienecker, "
      "A Fourier method for solving nonlinear water-wave problems, J. Fluid Mech. 118 (1982) 411; Cooker, Weidman & "
      "Bale, Reflection of a high-amplitude solitary wave at a vertical wall, J. Fluid Mech. 342 (1997) 141",
      "two mirrored solitary waves of the Euler equations moved by Cauchy's integral; p = -phi_t - v^2/2 - g y at the "
      "wall"};
}

}  // namespace seiche::exact
