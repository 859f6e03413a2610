/// Steady flow over a parabolic bump: subcritical, transcritical, and transcritical with a hydraulic jump behind the
/// crest.
///
/// Bed z = height (1 - ((x - crest)/half_width)^2) on the bump, 0 elsewhere. Bernoulli away from the jump,
///
///     h^3 - (E - z) h^2 + q^2/(2 g) = 0,
///
/// roots by the trigonometric Cardano formula (upper: subcritical, middle: supercritical); at the jump
/// q^2/h + g h^2/2 is continuous.
///
/// When not to use it: friction, or flow that has not settled.
///
/// References: Goutal and Maurel, Proc. 2nd workshop on dam-break wave simulation (1997); Delestre et al., SWASHES,
/// Int. J. Numer. Meth. Fluids 72 (2013) 269, section 3.1.
///
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

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

/// Bump of the published cases: z = 0.2 - 0.05 (x - 10)^2 on 8 < x < 12, channel 0 < x < 25 [m].
struct ParabolicBump {
  double height = 0.2, crest = 10, half_width = 2, length = 25;
};

class SteadyBump {
 public:
  using Bump = ParabolicBump;
  enum class Regime { subcritical, transcritical, with_jump };

  /// Flow without a jump whose depth at the outflow is `outflow_depth`, or with one, whichever exists.
  ///
  /// @param discharge      q [m^2/s], positive
  /// @param outflow_depth  [m], above the critical depth
  /// Throws std::invalid_argument when no steady state exists: outflow supercritical, or a jump that would be swept off
  /// the bump.
  SteadyBump(double gravity, double discharge, double outflow_depth, Bump bump = {});

  /// Subcritical upstream, critical on the crest, supercritical downstream.
  static SteadyBump transcritical(double gravity, double discharge, Bump bump = {}) {
    return {gravity, discharge, bump};
  }

  /// State at x; steady, so t is ignored.
  [[nodiscard]] shallow_water::State at(double x, double t = 0) const;
  [[nodiscard]] std::vector<double> breakpoints(double t = 0) const;

  [[nodiscard]] Regime regime() const { return regime_; }
  [[nodiscard]] double discharge() const { return discharge_; }
  /// Critical depth (q^2/g)^(1/3) [m].
  [[nodiscard]] double critical_depth() const { return critical_; }
  /// Place of the jump [m]; NaN without one.
  [[nodiscard]] double jump() const { return jump_; }
  /// Depths just before and after the jump [m]; NaN without one.
  [[nodiscard]] double depth_before_jump() const {
    return regime_ == Regime::with_jump ? depth_from_excess(drop_from_crest(jump_), Branch::supercritical) : jump_;
  }
  [[nodiscard]] double depth_after_jump() const;
  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] Bed bed() const;
  [[nodiscard]] Bump bump() const { return bump_; }

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  SteadyBump(double gravity, double discharge, Bump bump);

  enum class Branch { subcritical, supercritical };
  [[nodiscard]] double depth_from_excess(double excess, Branch branch) const;
  [[nodiscard]] double drop_from_crest(double x) const;

  double gravity_, discharge_;
  Bump bump_;
  double critical_;
  Regime regime_ = Regime::transcritical;
  // Specific energy above the crest in excess of the critical 1.5 h_c, upstream and downstream of a jump.
  double upstream_excess_ = 0;
  double downstream_excess_ = 0;
  double jump_ = std::numeric_limits<double>::quiet_NaN();
};

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

  [[nodiscard]] double uncertainty() const { return 1e-12; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  struct Table {  // values at the panels' left ends
    std::vector<double> elevation;
    std::vector<double> primitive;
  };
  struct Panel {
    std::size_t number;
    double begin;
  };
  [[nodiscard]] Panel panel_of(double x) const;

  double gravity_;
  std::function<double(double)> depth_;
  std::function<double(double)> slope_;
  double discharge_, manning_, length_;
  std::shared_ptr<const Table> table_;
};

}  // namespace seiche::exact
