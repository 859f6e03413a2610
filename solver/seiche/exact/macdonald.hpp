/// Steady flow with friction over a bed made to fit a chosen depth (MacDonald's channels).
///
/// Choose h(x), discharge q and Manning's n; the momentum equation then gives the slope of the bed,
///
///     z' = (q^2/(g h^3) - 1) h' - n^2 q^2/h^(10/3),
///
/// integrated by Gauss quadrature to 1e-12 of the bed's range (checked against Gauss-Kronrod in the constructor).
/// z = 0 at x = length.
///
/// When not to use it: depths that pass through critical (the formula holds, but the profile must be smooth there).
///
/// References: MacDonald et al., Analytic benchmark solutions for open-channel flows, J. Hydraul. Eng. 123 (1997) 1041;
/// Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269, section 3.2.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

class MacDonald {
 public:
  /// @param depth, slope  h(x) [m] > 0 and dh/dx [1] on [0, length]
  /// @param discharge     q [m^2/s];  @param manning  n [s/m^(1/3)];  @param length  [m]
  /// Throws std::invalid_argument, also when the bed cannot be integrated to 1e-12.
  MacDonald(double gravity, std::function<double(double)> depth, std::function<double(double)> slope, double discharge,
            double manning, double length);

  /// h = (q^2/g)^(1/3) (1 + crest exp(-16 (x/length - 1/2)^2)): subcritical for a crest above 0.
  static MacDonald smooth_rise(double gravity, double discharge = 2, double manning = 0.033, double length = 1000,
                               double crest = 0.5);

  /// State at x in [0, length]; steady, so t is ignored.
  [[nodiscard]] shallow_water::State at(double x, double t = 0) const;
  /// Bed z(x) [m], its primitive from x = 0 [m^2] and its slope z' [1]. Continue smoothly beyond the ends.
  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double primitive(double x) const;
  [[nodiscard]] double bed_slope(double x) const;
  [[nodiscard]] Bed bed() const;
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double manning() const { return manning_; }

  /// See ReferenceSolution.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;
  static Provenance provenance();

 private:
  struct Table {  // values at the panels' left ends
    std::vector<double> elevation;
    std::vector<double> primitive;
  };
  [[nodiscard]] std::size_t panel_of(double x) const;

  double gravity_;
  std::function<double(double)> depth_;
  std::function<double(double)> slope_;
  double discharge_;
  double manning_;
  double length_;
  std::shared_ptr<const Table> table_;
};

}  // namespace seiche::exact
