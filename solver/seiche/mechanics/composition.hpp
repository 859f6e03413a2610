/// Symmetric compositions: a step of order four from steps of order two, with every invariant that each of them keeps.
///
///     triple jump   w = g, 1 - 2g, g         g = 1/(2 - 2^(1/3))
///     Suzuki        w = g, g, 1 - 4g, g, g   g = 1/(4 - 4^(1/3)), error about 60 times smaller
///
/// For tau -> 0 one step of the constrained scheme is a reflection, not the identity. `paired` composes pairs of half
/// steps, which are near the identity for any initial velocity; without it the velocity must be projected.
///
/// References: Yoshida, Construction of higher order symplectic integrators, Phys. Lett. A 150 (1990) 262; Suzuki,
/// Fractal decomposition of exponential operators, Phys. Lett. A 146 (1990) 319; Hairer, Lubich & Wanner, Geometric
/// Numerical Integration, 2nd ed. (2006), II.4.
#pragma once

#include <concepts>
#include <utility>
#include <vector>

#include "seiche/mechanics/state.hpp"

namespace seiche::mechanics {

template <class Step>
concept Stepper = requires(Step& stepper, State& state, double tau) {
  stepper.substep(state, tau);
};

enum class Stages { single, paired };

/// Lengths of the stages in units of the step; their sum is 1.
std::vector<double> triple_jump_weights(Stages stages = Stages::paired);
std::vector<double> suzuki_weights(Stages stages = Stages::paired);

template <Stepper Step>
class Composition {
 public:
  /// @param base  must outlive the composition
  Composition(Step& base, std::vector<double> weights) : base_(base), weights_(std::move(weights)) {}

  /// Throws what the base throws; the state is then as before the step.
  void step(State& state, double tau) {
    require_step(tau);
    next_ = state;
    for (const double weight : weights_) base_.substep(next_, weight * tau);
    next_.time = state.time + tau;
    ++next_.steps;
    std::swap(state, next_);
  }

 private:
  Step& base_;
  std::vector<double> weights_;
  State next_;
};

}  // namespace seiche::mechanics
