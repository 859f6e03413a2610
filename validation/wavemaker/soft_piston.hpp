/// A piston that starts softly, and the elevation that linear theory gives it.
///
///     d(t) = (S/2) r(t) sin(omega t),   r: from 0 to 1 over the first period, three times differentiable.
///
/// The elevation is Duhamel's integral over the exact response s to a piston that suddenly moves on with velocity 1:
///
///     eta(x, t) = int_0^t d''(t') s(x, t - t') dt'.
///
/// Depth and gravity are 1.
#pragma once

#include <vector>

namespace seiche::validation {

class SoftPiston {
 public:
  /// @param sudden  r = 1: the velocity jumps at t = 0
  SoftPiston(double frequency, double stroke, bool sudden);

  [[nodiscard]] double place(double t) const;
  [[nodiscard]] double velocity(double t) const;
  [[nodiscard]] double acceleration(double t) const;
  /// Elevation at x at the times interval, 2 interval, ...; the integral has `parts` panels in each.
  [[nodiscard]] std::vector<double> elevation(double x, double interval, long samples, long parts = 4) const;

 private:
  struct Ramp {
    double value, rate, acceleration;
  };
  [[nodiscard]] Ramp ramp(double t) const;

  double frequency_;
  double half_stroke_;
  bool sudden_;
};

}  // namespace seiche::validation
