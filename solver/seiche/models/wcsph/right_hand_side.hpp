/// Rates of change (2)-(4), (6) of all particles: the pair loops in their order, with what they need of each other;
/// internal to Flow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/wcsph/density_diffusion.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

class RightHandSide {
 public:
  /// @param spacing  dx, the filter width Delta of the turbulence model
  RightHandSide(const Settings& settings, double spacing);

  void resize(std::size_t particles);
  /// Rates at the records of the stage; with `limited` also the limit of the step.
  void evaluate(Stage& stage, const Neighbours& neighbours, bool limited);

  // Walls have the density's only, the others are zero.
  std::vector<double> dx, dz, du, dw, ddensity;

  /// Largest (c + sigma)/h of the last evaluation with `limited` [1/s].
  [[nodiscard]] double largest_limit() const;
  /// The particle that has it.
  [[nodiscard]] std::size_t most_limited() const;
  /// Factor of the sound speed in records.
  [[nodiscard]] double sound_scale() const { return work_.sound_scale; }
  /// Whether stresses of unresolved eddies are among the forces.
  [[nodiscard]] bool turbulent() const { return friction_ == Friction::turbulent; }

 private:
  KernelName kernel_;
  Friction friction_ = Friction::none;
  DensityDiffusion diffusion_;
  bool frozen_walls_;
  PairWork work_{};
  std::vector<double> limit_;
};

}  // namespace seiche::wcsph
