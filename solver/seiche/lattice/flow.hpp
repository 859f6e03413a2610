/// What the flows of lattices of water share: stepping by one of the schemes, and what their nodes have.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/lattice/water.hpp"
#include "seiche/mechanics/model_flow.hpp"
#include "seiche/mechanics/scheme.hpp"

namespace seiche::lattice {

/// @tparam Model  a Water with the energies that mechanics::ModelFlow asks for
template <class Model>
class Flow : public mechanics::ModelFlow<Model> {
 public:
  /// No shorter step of the one-step scheme is unstable on the first lattice: 2/omega of a mode as fast as any of its.
  [[nodiscard]] double stable_step() const { return stable_step_; }

  [[nodiscard]] std::span<const double> x() const { return axis(state_.q, 0); }
  [[nodiscard]] std::span<const double> y() const { return axis(state_.q, 1); }
  [[nodiscard]] std::span<const double> z() const requires(Model::axes == 3) { return axis(state_.q, 2); }
  [[nodiscard]] std::span<const double> u() const { return axis(state_.u, 0); }
  [[nodiscard]] std::span<const double> v() const { return axis(state_.u, 1); }
  [[nodiscard]] std::span<const double> w() const requires(Model::axes == 3) { return axis(state_.u, 2); }
  /// Multipliers of the cells at the middle of the last step [Pa]: dynamic pressure. Single values alternate.
  [[nodiscard]] std::span<const double> multipliers() const { return state_.multipliers; }

  /// Shape of the worst corner: 1 at the beginning for equal boxes, 0 where the lattice inverts; a warning below 0.2.
  [[nodiscard]] Corner worst_corner() const { return model_->worst_corner(state_.q); }

 protected:
  using mechanics::ModelFlow<Model>::model_, mechanics::ModelFlow<Model>::state_;

  explicit Flow(mechanics::Scheme scheme) : scheme_(scheme) {}
  /// Throws mechanics::Infeasible, and then changes nothing; std::invalid_argument for the scheme.
  void begin(std::unique_ptr<Model> model, mechanics::State state, double stable_step) {
    auto stepper = std::make_unique<mechanics::SchemeStepper<Model>>(*model, scheme_);
    mechanics::ModelFlow<Model>::begin(std::move(model), std::move(state));
    stepper_ = std::move(stepper);
    stable_step_ = stable_step;
    fresh_ = true;
  }
  /// The same at the very beginning. Throws std::invalid_argument for velocities that cannot be projected.
  /// @param smooth_start  only for the one-step scheme without composition, and where no side is driven
  void begin_at_first(std::unique_ptr<Model> model, mechanics::State state, double stable_step, bool smooth_start) {
    smooth_start_ = smooth_start && scheme_.stepping != mechanics::Stepping::conservative &&
                    scheme_.composition == mechanics::TimeComposition::none;
    mechanics::ModelFlow<Model>::begin_at_first(std::move(model), std::move(state));
    stepper_ = std::make_unique<mechanics::SchemeStepper<Model>>(*model_, scheme_);
    stable_step_ = stable_step;
  }
  void step(double tau) {
    if (fresh_ && smooth_start_) {
      mechanics::smooth_step(*model_, *stepper_, state_, tau);
    } else {
      stepper_->step(state_, tau);
    }
    fresh_ = false;
  }

 private:
  [[nodiscard]] std::span<const double> axis(const std::vector<double>& values, std::size_t index) const {
    const std::size_t n = state_.u.size() / Model::axes;
    return {values.data() + index * n, n};
  }

  std::unique_ptr<mechanics::SchemeStepper<Model>> stepper_;
  mechanics::Scheme scheme_;
  bool smooth_start_ = true;
  bool fresh_ = true;  // no step yet since it began
  double stable_step_ = 0;
};

}  // namespace seiche::lattice
