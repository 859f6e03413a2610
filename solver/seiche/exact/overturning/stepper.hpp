/// One step of the surface's motion, dz/dt = conj f, dphi/dt = |f|^2/2 - y, by the pair of Dormand & Prince 5(4).
///
/// Seven stages, of which the last is the first of the next step: six integral equations per step. Each starts from
/// psi_s extrapolated in time from the moments before, plus what that missed in the same stage of the last step.
///
/// Reference: Dormand & Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19.
#pragma once

#include <array>

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "seiche/exact/overturning/surface_velocity.hpp"

namespace seiche::exact::overturning {

/// The surface at one time, with what the next step needs.
struct Moment {
  double time = 0;
  State state;
  State rate;             ///< d state/dt
  Eigen::VectorXd psi_s;  ///< slope of the stream function
  Invariants invariants;
};

class Stepper {
 public:
  Stepper(std::size_t markers, double depth) : velocity_(markers, depth) {}

  /// The surface at a time with its rate; the first guess of psi_s is zero.
  Moment begin(double time, State state);

  struct Result {
    Moment moment;
    double error = 0;  ///< largest difference of the fifth- and fourth-order results
  };
  /// A step from the last of the moments, which are in the order of time.
  Result step(std::span<const Moment> past, double duration);

 private:
  void rate(const State& state, State& rate, Eigen::VectorXd& psi_s);

  SurfaceVelocity velocity_;
  boost::numeric::odeint::runge_kutta_dopri5<State> pair_;
  /// By how much psi_s of each stage differed from the extrapolation in the last step, and how long that was.
  std::array<Eigen::VectorXd, 6> departures_;
  double last_duration_ = 0;
};

}  // namespace seiche::exact::overturning
