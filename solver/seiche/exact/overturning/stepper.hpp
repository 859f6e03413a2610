/// One step of the surface's motion, dz/dt = conj f, dphi/dt = |f|^2/2 - y - p, by the pair of Dormand & Prince 5(4).
///
/// p(x, t) is a pressure on the surface, none if it is not given. The outward normal is n ds = (-y_s, x_s) ds, and
/// u.n ds = -psi_s ds: p does the work int p psi_s ds and pushes forward with int p y_s ds, which the step integrates
/// with the motion.
///
/// Seven stages, of which the last is the first of the next step: six integral equations per step. Each starts from
/// psi_s extrapolated in time from the moments before, plus what that missed in the same stage of the last step.
///
/// References: Dormand & Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19;
/// Longuet-Higgins & Cokelet, Proc. R. Soc. Lond. A 350 (1976) 1 (pressure).
#pragma once

#include <array>
#include <functional>
#include <utility>

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "seiche/exact/overturning/surface_velocity.hpp"

namespace seiche::exact::overturning {

/// p(x, t) on the surface, continuous in time and of period 2 pi in x.
using SurfacePressure = std::function<double(double x, double t)>;

/// The surface at one time, with what the next step needs.
struct Moment {
  double time = 0;
  State state;
  State rate;             ///< d state/dt
  Eigen::VectorXd psi_s;  ///< slope of the stream function
  Invariants invariants;
};

/// Change of the energy that the work of the pressure does not account for, relative to the larger of both energies.
double energy_error(const Moment& start, const Moment& now);

class Stepper {
 public:
  Stepper(std::size_t markers, double depth, SurfacePressure pressure = {})
      : velocity_(markers, depth), pressure_(std::move(pressure)) {}

  /// The surface at a time with its rate; the first guess of psi_s is zero.
  Moment begin(double time, State state);

  struct Result {
    Moment moment;
    double error = 0;  ///< largest difference of the fifth- and fourth-order results
  };
  /// A step from the last of the moments, which are in the order of time.
  Result step(std::span<const Moment> past, double duration);

 private:
  void rate(const State& state, double time, State& rate, Eigen::VectorXd& psi_s);
  void add_pressure(const State& state, double time, State& rate, const Eigen::VectorXd& psi_s) const;

  SurfaceVelocity velocity_;
  SurfacePressure pressure_;
  boost::numeric::odeint::runge_kutta_dopri5<State> pair_;
  /// By how much psi_s of each stage differed from the extrapolation in the last step, and how long that was.
  std::array<Eigen::VectorXd, 6> departures_;
  double last_duration_ = 0;
};

}  // namespace seiche::exact::overturning
