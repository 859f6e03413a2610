#include "seiche/exact/affine_ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

using Eigen::Matrix3d;

/// A and A', in units of strength.
using Phase = std::vector<double>;
using Part = Eigen::Map<Matrix3d>;
using ConstPart = Eigen::Map<const Matrix3d>;
constexpr std::size_t entries = 9;

constexpr double step_tolerance = 1e-14;

double pressure_factor(const Matrix3d& deformation, const Matrix3d& rate) {
  const Matrix3d inverse = deformation.inverse();
  const Matrix3d gradient = rate * inverse;
  return (gradient * gradient).trace() / inverse.squaredNorm();
}

Matrix3d antisymmetric(const Matrix3d& m) {
  return m - m.transpose();
}

}  // namespace

AffineEllipsoid::AffineEllipsoid(const Matrix3d& velocity_gradient, double radius)
    : gradient_(velocity_gradient), radius_(radius), strength_(velocity_gradient.norm()) {
  require_positive("radius", radius);
  require_finite("norm of the velocity gradient", strength_);
  require_within("trace of the velocity gradient", velocity_gradient.trace(), -1e-14 * strength_, 1e-14 * strength_);
  if (strength_ == 0) strength_ = 1;
}

AffineEllipsoid::Instant AffineEllipsoid::from(const Matrix3d& deformation, const Matrix3d& rate, double t) const {
  namespace odeint = boost::numeric::odeint;
  Phase phase(2 * entries);
  Part(phase.data()) = deformation;
  Part(phase.data() + entries) = rate / strength_;
  const auto motion = [](const Phase& now, Phase& change, double) {
    const Matrix3d a = ConstPart(now.data());
    const Matrix3d v = ConstPart(now.data() + entries);
    Part(change.data()) = v;
    Part(change.data() + entries) = pressure_factor(a, v) * a.inverse().transpose();
  };
  const double end = t * strength_;
  if (end != 0) {
    odeint::integrate_adaptive(
        odeint::make_controlled(step_tolerance, step_tolerance, odeint::runge_kutta_fehlberg78<Phase>()), motion, phase,
        0.0, end, std::copysign(std::min(0.02, std::abs(end)), end));
  }
  Instant instant{.deformation = Part(phase.data()), .rate = strength_ * Part(phase.data() + entries)};
  instant.central_pressure = 0.5 * radius_ * radius_ * pressure_factor(instant.deformation, instant.rate);
  return instant;
}

AffineEllipsoid::Instant AffineEllipsoid::at(double t) const {
  require_finite("t", t);
  return from(Matrix3d::Identity(), gradient_, t);
}

Eigen::Vector3d AffineEllipsoid::semi_axes(const Instant& instant) const {
  return radius_ * Eigen::JacobiSVD<Matrix3d>(instant.deformation).singularValues();
}

Provenance AffineEllipsoid::provenance() {
  return {"Dirichlet, J. reine angew. Math. 58 (1861) 181; Dedekind, ibid. 217",
          "x = A(t) X, A'' = pressure_factor A^-T, pressure_factor = tr[(A' A^-1)^2]/tr[A^-1 A^-T], p = "
          "(pressure_factor/2) rho (1 - |X|^2)"};
}

double AffineEllipsoid::uncertainty() const {
  return 1e-12;
}

SelfTest AffineEllipsoid::self_test() const {
  const double end = 2 / strength_;
  const Instant later = at(end);
  const Matrix3d& a = later.deformation;
  const Matrix3d& v = later.rate;
  const std::string reason =
      "steps that keep their errors of seventh order at 1e-14, which last 2 all together; rounded in about 30 steps; "
      "growing at most as the deformation, threefold";
  const double limit = 3 * (2 * step_tolerance + 4 * std::numeric_limits<double>::epsilon() * std::sqrt(30));
  const Instant turned = AffineEllipsoid(gradient_.transpose(), radius_).at(end);
  const Instant back = from(a, v, -end);
  return {
      {"the volume is constant", std::abs(a.determinant() - 1), limit, reason},
      {"the kinetic energy is constant", std::abs(v.squaredNorm() - gradient_.squaredNorm()) / (strength_ * strength_),
       limit, reason},
      {"the angular momentum is constant", antisymmetric(a * v.transpose() - gradient_.transpose()).norm() / strength_,
       limit, reason},
      {"the circulations are constant", antisymmetric(a.transpose() * v - gradient_).norm() / strength_, limit, reason},
      {"the transposed gradient makes the transposed motion", (turned.deformation - a.transpose()).norm(), 2 * limit,
       "two motions"},
      {"the motion can be run back", (back.deformation - Matrix3d::Identity()).norm(), 4 * limit,
       "twice as many steps; the way back amplifies an error in the rate by the elapsed time"}};
}

static_assert(ReferenceSolution<AffineEllipsoid>);

}  // namespace seiche::exact
