/// Rates of change (2)-(4), (6) of all particles: the pair loops in their order, with what they need of each other;
/// internal to Flow.
#pragma once

#include <cstddef>
#include <vector>

#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

/// Rates of change, in the order of the particles. Walls have the density's only, the others are zero.
struct Rates {
  std::vector<double> dx, dz, du, dw, ddensity;
};

class RightHandSide {
 public:
  /// @param spacing  dx, the filter width Delta of the turbulence model
  RightHandSide(const Settings& settings, double spacing);

  void resize(std::size_t particles);
  /// Rates at the records of the stage; with `limited` also the limit of the step.
  void evaluate(Stage& stage, const Neighbours& neighbours, bool limited);

  [[nodiscard]] const Rates& rates() const { return rates_; }
  [[nodiscard]] Rates& rates() { return rates_; }
  /// Largest (c + sigma)/h of the last evaluation with `limited` [1/s].
  [[nodiscard]] double largest_limit() const { return largest_limit_; }
  /// A particle beside it: the first of the cluster that has it.
  [[nodiscard]] std::size_t most_limited() const { return most_limited_; }
  /// Factor of the sound speed in records.
  [[nodiscard]] double sound_scale() const { return sound_scale_; }
  /// Whether stresses of unresolved eddies are among the forces.
  [[nodiscard]] bool turbulent() const { return friction_ == Friction::turbulent; }

 private:
  const PairLoops* loops_;
  Friction friction_ = Friction::none;
  double gravity_;
  double xsph_;
  double sound_scale_ = 1;
  double kinematic_viscosity_ = 0;
  double eddy_factor_ = 0;
  double isotropic_factor_ = 0;
  Rates rates_;
  std::vector<double> limit_;  ///< of each cluster
  std::size_t most_limited_ = 0;
  double largest_limit_ = 0;
};

}  // namespace seiche::wcsph
