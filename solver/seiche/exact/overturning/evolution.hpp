/// One step of the surface's motion, dz/dt = conj f, dphi/dt = |f|^2/2 - y - p, by the pair of Dormand & Prince 5(4).
///
/// p(x, t) is a pressure on the surface, none if it is not given. The outward normal is n ds = (-y_s, x_s) ds, and
/// u.n ds = -psi_s ds: p does the work int p psi_s ds and pushes forward with int p y_s ds, which the step integrates
/// with the motion. Over bars (bars.hpp) the state is that of zeta, and z_zeta divides the velocity:
/// dzeta/dt = conj w_zeta/|z_zeta|^2.
///
/// Seven stages, of which the last is the first of the next step: six integral equations per step. Each starts from
/// psi_s extrapolated in time from the moments before, plus what that missed in the same stage of the last step.
///
/// References: Dormand & Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19;
/// Longuet-Higgins & Cokelet, Proc. R. Soc. Lond. A 350 (1976) 1 (pressure).
///
/// The motion of a free surface from a given shape and potential, step by step, until a given time, touch-down, or loss
/// of resolution.
///
/// Every accepted step is kept: the surface at any time in between is one Dormand-Prince step from the moment before
/// it, so that its error is that of the computation, not of an interpolation. After each step the coefficients of x -
/// s, y and phi are multiplied by exp(-36 (|k|/k_max)^28): weak enough for the upper modes of a thin jet, strong enough
/// to stop the growth of rounding errors there, which the power 36 of Hou & Li does not for a surface that contracts
/// towards its jet.
///
/// When not to use it: after touch-down; surfaces with corners.
///
/// References: Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350
/// (1976) 1; Baker, Meiron & Orszag, J. Fluid Mech. 123 (1982) 477; Hou & Li, J. Comput. Phys. 226 (2007) 379 (filter).
///
/// Surfaces to start from, in units of 1/k and sqrt(1/(g k)); labels uniform in x.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "seiche/exact/overturning/surface_velocity.hpp"
#include "seiche/exact/reference_solution.hpp"

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
  Stepper(std::size_t markers, double depth, SurfacePressure pressure, Bars bars)
      : velocity_(markers, depth), pressure_(std::move(pressure)), bars_(bars) {}

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

  SurfaceVelocity velocity_;
  SurfacePressure pressure_;
  Bars bars_;
  boost::numeric::odeint::runge_kutta_dopri5<State> pair_;
  /// By how much psi_s of each stage differed from the extrapolation in the last step, and how long that was.
  std::array<Eigen::VectorXd, 6> departures_;
  double last_duration_ = 0;
};

enum class Ending { none, step_collapse, energy, spectral_tail };

class Evolution {
 public:
  /// @param depth      k h, may be infinite
  /// @param tolerance  of one step, absolute
  /// @param pressure   on the surface; where it is not smooth in time, advance_to that time first
  Evolution(State initial, double depth, double tolerance, SurfacePressure pressure = {}, Bars bars = {});

  /// Steps until `time` is reached exactly, or something ends the motion before.
  void advance_to(double time);

  /// Over bars their states are those of zeta.
  [[nodiscard]] const std::vector<Moment>& moments() const { return moments_; }
  [[nodiscard]] const Moment& now() const { return moments_.back(); }
  [[nodiscard]] bool forced() const { return static_cast<bool>(pressure_); }
  [[nodiscard]] Ending ending() const { return ending_; }
  /// Why the motion ended, where.
  [[nodiscard]] std::string ending_reason() const;
  [[nodiscard]] double ending_place() const;

  /// The moment at a time within the motion. Throws std::out_of_range outside it.
  [[nodiscard]] Moment at(double time) const;
  /// First time at which g(moment), positive at the start, is zero, found by regula falsi with a step of its own for
  /// each trial; none if g stays positive.
  [[nodiscard]] std::optional<double> first_zero(const std::function<double(const Moment&)>& g, double accuracy) const;

 private:
  void filter(State& state);
  /// The state and its rate in the place of those of zeta.
  [[nodiscard]] Moment in_space(Moment moment) const;

  double depth_, tolerance_;
  SurfacePressure pressure_;
  Bars bars_;
  Stepper stepper_;
  linear::Fourier fourier_;
  std::vector<std::complex<double>> coefficients_;
  std::vector<Moment> moments_;
  double duration_ = 1e-3;
  double tail_ = 0;
  double energy_error_ = 0;
  Ending ending_ = Ending::none;
};

/// Elevation A cos x with the potential of the linear wave of that amplitude at the surface itself,
///
///     phi = (A/w) cosh(y + h)/cosh(h) sin x,  w = sqrt(tanh h)   (A e^y sin x in infinitely deep water).
///
/// Its kinetic energy is (pi/2) A^2 I_0(2A) at any depth. Steep enough, it overturns towards +x.
State sinusoidal_wave(std::size_t markers, double amplitude, double depth);

/// Any elevation and surface potential of period 2 pi.
State from_functions(std::size_t markers, const std::function<double(double)>& elevation,
                     const std::function<double(double)>& potential);

}  // namespace seiche::exact::overturning
