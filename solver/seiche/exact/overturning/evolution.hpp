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
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "seiche/exact/overturning/stepper.hpp"

namespace seiche::exact::overturning {

enum class Ending { none, step_collapse, energy, spectral_tail };

class Evolution {
 public:
  /// @param depth      k h, may be infinite
  /// @param tolerance  of one step, absolute
  /// @param pressure   on the surface; where it is not smooth in time, advance_to that time first
  Evolution(State initial, double depth, double tolerance, SurfacePressure pressure = {});

  /// Steps until `time` is reached exactly, or something ends the motion before.
  void advance_to(double time);

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

  double depth_;
  double tolerance_;
  SurfacePressure pressure_;
  Stepper stepper_;
  linear::Fourier fourier_;
  std::vector<std::complex<double>> coefficients_;
  std::vector<Moment> moments_;
  double duration_ = 1e-3;
  double tail_ = 0;
  double energy_error_ = 0;
  Ending ending_ = Ending::none;
};

}  // namespace seiche::exact::overturning
