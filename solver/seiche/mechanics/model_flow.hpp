/// What flows of all mechanical models share: a model, its state and a ledger.
#pragma once

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/model.hpp"

namespace seiche::mechanics {

template <class Model>
class ModelFlow {
 public:
  virtual ~ModelFlow() = default;
  ModelFlow(ModelFlow&&) noexcept = default;
  ModelFlow& operator=(ModelFlow&&) noexcept = default;

  /// One step of length tau > 0. A step that fails leaves the state as it was.
  virtual void advance(double tau) = 0;
  void arrive(double time) { state_.time = time; }

  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] long steps() const { return state_.steps; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const State& state() const { return state_; }
  /// Mean multipliers of the last two steps: dynamic pressure at the beginning of the last step, of the cells [Pa].
  [[nodiscard]] std::vector<double> dynamic_pressure() const { return state_.nodal_multipliers(); }
  /// Kinetic and potential, zero for still water.
  [[nodiscard]] double energy() const {
    return model_->kinetic_energy(state_.q, state_.u) + model_->potential_energy(state_.q);
  }
  /// Mass, momenta, energy, constraints since the beginning, with what was booked. Costs several passes: `observe`
  /// takes a record.
  void observe() { watch_->record(state_); }
  [[nodiscard]] std::vector<Invariant> invariants() const { return watch_->invariants(state_); }
  [[nodiscard]] const InvariantsLedger& ledger() const { return watch_->ledger(); }

 protected:
  ModelFlow() = default;
  /// Projects the first velocities on the constraints. Throws Infeasible, and then changes nothing.
  void begin(std::unique_ptr<Model> model, State state) {
    Start(*model).project(state);
    take(std::move(model), std::move(state));
  }
  /// The same at the very beginning. Throws std::invalid_argument for velocities that cannot be projected.
  void begin_at_first(std::unique_ptr<Model> model, State state) {
    try {
      begin(std::move(model), std::move(state));
    } catch (const Infeasible& failure) {
      throw std::invalid_argument(failure.what());
    }
  }
  /// Velocities that are not to be projected.
  void take(std::unique_ptr<Model> model, State state) {
    auto watch = std::make_unique<InvariantsWatch<Model>>(*model, state);
    watch_ = std::move(watch);
    model_ = std::move(model);
    state_ = std::move(state);
  }

  std::unique_ptr<Model> model_;
  State state_;
  std::unique_ptr<InvariantsWatch<Model>> watch_;
};

}  // namespace seiche::mechanics
