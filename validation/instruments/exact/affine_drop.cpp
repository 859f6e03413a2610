#include "validation/instruments/exact/affine_drop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double tolerance = 1e-14;

/// A and A' row by row, in units of size and strength.
using Phase = std::vector<double>;

double lambda(const Matrix2d& deformation, const Matrix2d& rate) {
  const Matrix2d inverse = deformation.inverse();
  const Matrix2d gradient = rate * inverse;
  return (gradient * gradient).trace() / inverse.squaredNorm();
}

using RowMajor = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;

Matrix2d matrix(const Phase& phase, std::size_t first) {
  return Eigen::Map<const RowMajor>(phase.data() + first);
}

void put(const Matrix2d& m, Phase& phase, std::size_t first) {
  Eigen::Map<RowMajor>(phase.data() + first) = m;
}

/// Accuracy of an integrated motion that lasts so long, in units of its strength.
double integrated(double duration) {
  return 3 * (duration * tolerance + 4 * epsilon * std::sqrt(30));
}
const std::string steps_of_drop =
    "steps that keep their errors of seventh order at 1e-14; the solution of eighth order that is carried on errs less "
    "by the step; rounded in about 30 steps; growing at most as the deformation, threefold";

}  // namespace

Ellipse outline_of(const DropInstant& instant) {
  const Eigen::JacobiSVD<Matrix2d> svd(instant.deformation, Eigen::ComputeFullU);
  const Vector2d axis = svd.matrixU().col(0);
  double tilt = std::atan2(axis.y(), axis.x());
  if (tilt > 0.5 * std::numbers::pi) tilt -= std::numbers::pi;
  if (tilt <= -0.5 * std::numbers::pi) tilt += std::numbers::pi;
  return {svd.singularValues()(0), svd.singularValues()(1), tilt};
}

AffineDrop::AffineDrop(const Matrix2d& deformation, const Matrix2d& velocity_gradient, double density)
    : deformation_(deformation), rate_(velocity_gradient * deformation), density_(density) {
  require_all_positive({{"density", density}, {"determinant of the deformation", deformation.determinant()}});
  strength_ = velocity_gradient.norm();
  require_finite("norm of the velocity gradient", strength_);
  require_within("trace of the velocity gradient", velocity_gradient.trace(), -1e-14 * strength_, 1e-14 * strength_);
  if (strength_ == 0) strength_ = 1;
  size_ = std::sqrt(deformation.determinant());
}

DropInstant AffineDrop::at(double t) const {
  require_finite("t", t);
  namespace odeint = boost::numeric::odeint;
  Phase phase(8);
  put(deformation_ / size_, phase, 0);
  put(rate_ / (size_ * strength_), phase, 4);
  const auto motion = [](const Phase& now, Phase& change, double) {
    const Matrix2d a = matrix(now, 0);
    const Matrix2d v = matrix(now, 4);
    put(v, change, 0);
    put(lambda(a, v) * a.inverse().transpose(), change, 4);
  };
  const double end = t * strength_;
  if (end != 0) {
    odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<Phase>()),
                               motion, phase, 0.0, end, std::copysign(std::min(0.02, std::abs(end)), end));
  }
  DropInstant instant{.deformation = size_ * matrix(phase, 0), .rate = size_ * strength_ * matrix(phase, 4)};
  instant.central_pressure = 0.5 * density_ * lambda(instant.deformation, instant.rate);
  return instant;
}

Vector2d AffineDrop::carried(double x0, double y0, double t) const {
  const DropInstant start{.deformation = deformation_, .rate = rate_};
  static_cast<void>(start.velocity(x0, y0));  // throws outside the drop
  return at(t).deformation * (deformation_.inverse() * Vector2d(x0, y0));
}

AffineDrop::Invariants AffineDrop::invariants(const DropInstant& instant) const {
  using std::numbers::pi;
  const Matrix2d& a = instant.deformation;
  const Matrix2d& v = instant.rate;
  const double mass = density_ * pi * a.determinant();
  const Matrix2d moment = a * v.transpose();
  const Matrix2d flow = v.transpose() * a;
  return {pi * a.determinant(), mass / 8 * v.squaredNorm(), mass / 4 * (moment(0, 1) - moment(1, 0)),
          pi * (flow(0, 1) - flow(1, 0))};
}

SelfTest AffineDrop::self_test() const {
  const double end = 3 / strength_;
  const DropInstant later = at(end);
  const Invariants before = invariants(at(0));
  const Invariants after = invariants(later);
  const double speed = rate_.norm();
  const auto constant = [&](const std::string& name, double Invariants::*member, double scale) {
    return Identity{name + " is constant", std::abs(after.*member - before.*member) / scale, integrated(3),
                    steps_of_drop};
  };
  const Matrix2d gradient = later.rate * later.deformation.inverse();
  const AffineDrop back(later.deformation, gradient - 0.5 * gradient.trace() * Matrix2d::Identity(), density_);
  return {constant("area", &Invariants::area, before.area),
          constant("kinetic energy", &Invariants::kinetic_energy,
                   std::max(before.kinetic_energy, density_ * std::pow(size_, 4) * strength_ * strength_ / 8)),
          constant("angular momentum", &Invariants::angular_momentum,
                   before.area * density_ * deformation_.norm() * std::max(speed, size_ * strength_)),
          constant("circulation", &Invariants::circulation, before.area * std::max(strength_, speed / size_)),
          {"the motion can be run back", (back.at(-end).deformation - deformation_).norm() / deformation_.norm(),
           4 * integrated(3), "twice as many steps; the way back amplifies an error in the rate by the elapsed time"}};
}

}  // namespace seiche::exact
