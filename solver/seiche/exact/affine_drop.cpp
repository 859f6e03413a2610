#include "seiche/exact/affine_drop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// A and A' row by row, in units of size and strength.
using Phase = std::vector<double>;

constexpr double tolerance = 1e-14;
/// |X|^2 of a surface point that carries round-off of a few maps.
constexpr double outermost = 1 + 1e-12;

double lambda(const Matrix2d& deformation, const Matrix2d& rate) {
  const Matrix2d inverse = deformation.inverse();
  const Matrix2d gradient = rate * inverse;
  return (gradient * gradient).trace() / inverse.squaredNorm();
}

Matrix2d matrix(const Phase& phase, std::size_t first) {
  Matrix2d m;
  m << phase[first], phase[first + 1], phase[first + 2], phase[first + 3];
  return m;
}

void put(const Matrix2d& m, Phase& phase, std::size_t first) {
  phase[first] = m(0, 0);
  phase[first + 1] = m(0, 1);
  phase[first + 2] = m(1, 0);
  phase[first + 3] = m(1, 1);
}

}  // namespace

Vector2d DropInstant::label(double x, double y) const {
  require_finite("x", x);
  require_finite("y", y);
  Vector2d particle = deformation.inverse() * Vector2d(x, y);
  if (!(particle.squaredNorm() <= outermost)) {
    // The range of y inside the drop at this x, from the quadratic |A^-1 (x, y)|^2 = 1.
    const Matrix2d form = (deformation * deformation.transpose()).inverse();
    const double middle = -form(0, 1) / form(1, 1) * x;
    const double reach = (1 - form.determinant() / form(1, 1) * x * x) / form(1, 1);
    throw OutsideFluid(reach < 0 ? fmt::format("x = {:.17g} is outside the drop: must be in [{:g}, {:g}]", x,
                                               -std::sqrt(form(1, 1) / form.determinant()),
                                               std::sqrt(form(1, 1) / form.determinant()))
                                 : fmt::format("y = {:.17g} is outside the drop at x = {:g}: must be in [{:g}, {:g}]",
                                               y, x, middle - std::sqrt(reach), middle + std::sqrt(reach)));
  }
  return particle;
}

bool DropInstant::contains(double x, double y) const {
  return (deformation.inverse() * Vector2d(x, y)).squaredNorm() <= outermost;
}

Vector2d DropInstant::velocity(double x, double y) const {
  return rate * label(x, y);
}

double DropInstant::pressure(double x, double y) const {
  return central_pressure * (1 - label(x, y).squaredNorm());
}

DropInstant::Ellipse DropInstant::outline() const {
  const Eigen::JacobiSVD<Matrix2d> svd(deformation, Eigen::ComputeFullU);
  const Vector2d axis = svd.matrixU().col(0);
  double tilt = std::atan2(axis.y(), axis.x());
  if (tilt > 0.5 * std::numbers::pi) tilt -= std::numbers::pi;
  if (tilt <= -0.5 * std::numbers::pi) tilt += std::numbers::pi;
  return {svd.singularValues()(0), svd.singularValues()(1), tilt};
}

AffineDrop::AffineDrop(const Matrix2d& deformation, const Matrix2d& velocity_gradient, double density)
    : deformation_(deformation), rate_(velocity_gradient * deformation), density_(density) {
  require_positive("density", density);
  require_positive("determinant of the deformation", deformation.determinant());
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

Provenance AffineDrop::provenance() {
  return {
      "Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; Longuet-Higgins, A class of exact, "
      "time-dependent, free-surface flows, J. Fluid Mech. 55 (1972) 529",
      "x = A(t) X, A'' = lambda A^-T, lambda = tr[(A' A^-1)^2]/tr[A^-1 A^-T], p = (lambda/2) rho (1 - |X|^2)"};
}

double AffineDrop::uncertainty() const {
  return 1e-12;
}

SelfTest AffineDrop::self_test() const {
  const double end = 3 / strength_;
  const DropInstant later = at(end);
  const Invariants before = invariants(at(0));
  const Invariants after = invariants(later);
  const std::string reason =
      "steps that keep their errors of seventh order at 1e-14; the solution of eighth order that is carried on errs "
      "less by the step, and all steps together last 3; rounded in about 30 steps; growing at most as the "
      "deformation, threefold";
  const double limit = 3 * (3 * tolerance + 4 * std::numeric_limits<double>::epsilon() * std::sqrt(30));
  const double speed = rate_.norm();
  const double angular_scale = before.area * density_ * deformation_.norm() * std::max(speed, size_ * strength_);
  const double circulation_scale = before.area * std::max(strength_, speed / size_);
  const double energy = std::max(before.kinetic_energy, density_ * std::pow(size_, 4) * strength_ * strength_ / 8);
  const AffineDrop back(later.deformation,
                        later.rate * later.deformation.inverse() -
                            0.5 * (later.rate * later.deformation.inverse()).trace() * Matrix2d::Identity(),
                        density_);
  return {
      {"area is constant", std::abs(after.area / before.area - 1), limit, reason},
      {"kinetic energy is constant", std::abs(after.kinetic_energy - before.kinetic_energy) / energy, limit, reason},
      {"angular momentum is constant", std::abs(after.angular_momentum - before.angular_momentum) / angular_scale,
       limit, reason},
      {"circulation is constant", std::abs(after.circulation - before.circulation) / circulation_scale, limit, reason},
      {"the motion can be run back", (back.at(-end).deformation - deformation_).norm() / deformation_.norm(), 4 * limit,
       "twice as many steps; the way back amplifies an error in the rate by the elapsed time"}};
}

static_assert(ReferenceSolution<AffineDrop>);

}  // namespace seiche::exact
