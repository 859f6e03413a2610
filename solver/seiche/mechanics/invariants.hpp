/// A ledger of what must not change: mass, momenta, energy, volumes, with the defect of each step and of the whole run.
///
/// Works with anything that gives numbers; InvariantsWatch reads them off a mechanical model by itself. What enters
/// through boundaries is booked and subtracted, summed with compensation so that the ledger adds no drift of its own.
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/model.hpp"
#include "seiche/samples.hpp"

namespace seiche::mechanics {

class InvariantsLedger {
 public:
  struct Entry {
    std::string name;
    double initial = 0;
    double value = 0;
    double defect = 0;       ///< value - initial - booked
    double step_defect = 0;  ///< change of the defect in the last step
    /// max |defect| and max |step_defect| so far: NaN before the first record, and once a value was not a number.
    double largest_defect = std::numeric_limits<double>::quiet_NaN();
    double largest_step_defect = std::numeric_limits<double>::quiet_NaN();
    CompensatedSum booked = {};
  };

  /// Starts to watch a quantity; returns its index.
  std::size_t watch(std::string name, double initial);
  /// What entered from outside since the last record: work, impulse, inflow.
  void book(std::size_t index, double amount) { entries_.at(index).booked.add(amount); }
  /// To the first entry of that name. Throws std::invalid_argument where there is none.
  void book(const std::string& name, double amount);
  /// One value per entry, in the order of watch, after a step. Throws std::invalid_argument when their number differs.
  void record(Input values);

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// Throws std::invalid_argument listing the names there are.
  [[nodiscard]] const Entry& entry(const std::string& name) const;
  /// Largest over the entries whose name begins so: "momentum" covers momentum_x, momentum_y, ...
  [[nodiscard]] double largest_defect(const std::string& begins) const;
  [[nodiscard]] long records() const { return records_; }

 private:
  std::vector<Entry> entries_;
  long records_ = 0;
};

/// Watches of a model whatever it offers:
///
///     mass()                                      mass
///     momentum(q, u), angular_momentum(q, u)      arrays: momentum_x, ...; angular_momentum_x, ... (a single one: _z)
///     kinetic_energy(q, u), potential_energy(q)   energy
///     constraint_values(q, f)                     volume_total = sum f, volume_worst = max |f|
template <ConstrainedModel Model>
class InvariantsWatch {
 public:
  /// Takes the state as the beginning.
  InvariantsWatch(const Model& model, const State& state) : model_(model) {
    observe(state, [&](const std::string& name, double value) {
      ledger_.watch(name, name == "volume_worst" || name == "volume_total" ? 0.0 : value);
    });
  }

  /// After a step.
  void record(const State& state) {
    values_.clear();
    observe(state, [&](const std::string&, double value) { values_.push_back(value); });
    ledger_.record(values_);
  }

  /// As they are now, whether there is a record of it or not.
  [[nodiscard]] std::vector<Invariant> invariants(const State& state) const {
    std::vector<Invariant> now;
    observe(state, [&](const std::string& name, double value) {
      now.push_back({.name = name, .value = value, .booked = ledger_.entries()[now.size()].booked.value()});
    });
    return now;
  }

  [[nodiscard]] InvariantsLedger& ledger() { return ledger_; }
  [[nodiscard]] const InvariantsLedger& ledger() const { return ledger_; }

 private:
  template <class Keep>
  void observe(const State& state, const Keep& keep) const {
    const Input q = state.q;
    const Input u = state.u;
    if constexpr (requires { model_.mass(); }) keep("mass", model_.mass());
    if constexpr (requires { model_.momentum(q, u); }) vector("momentum", model_.momentum(q, u), keep, 0);
    if constexpr (requires { model_.angular_momentum(q, u); }) {
      const auto moments = model_.angular_momentum(q, u);
      vector("angular_momentum", moments, keep, moments.size() == 1 ? 2 : 0);
    }
    if constexpr (requires { model_.kinetic_energy(q, u) + model_.potential_energy(q); }) {
      keep("energy", model_.kinetic_energy(q, u) + model_.potential_energy(q));
    }
    if constexpr (HasConstraintValues<Model>) {
      std::vector<double> constraints(constraint_count(model_));
      model_.constraint_values(q, constraints);
      CompensatedSum total;
      for (const double defect : constraints) total.add(defect);
      keep("volume_total", total.value());
      keep("volume_worst", constraints.empty() ? 0 : worst(constraints));
    }
  }

  template <class Vector, class Keep>
  static void vector(const std::string& name, const Vector& values, const Keep& keep, std::size_t first_axis) {
    for (std::size_t i = 0; i < values.size(); ++i) keep(name + "_" + "xyz"[first_axis + i], values[i]);
  }

  const Model& model_;
  InvariantsLedger ledger_;
  std::vector<double> values_;
};

/// Velocity of the water at a place; empty: at rest.
using VelocityAt = std::function<Point(Point place)>;

/// State, momenta and energy of point masses in a plane, q = (x of all, y of all), u = (velocities along x, along y).
/// @tparam Model  derives from it and gives masses() [kg/m], the places given() and, where walls hold some, freedom()
template <class Model>
class PointMasses {
 public:
  [[nodiscard]] std::size_t coordinates() const { return 2 * model().masses().size(); }
  [[nodiscard]] std::size_t rates() const { return coordinates(); }
  [[nodiscard]] double place(std::size_t rate) const { return model().given().x[rate % model().masses().size()]; }
  /// Where the masses were given, with these velocities without what walls forbid; not projected.
  [[nodiscard]] State state(const VelocityAt& velocity = {}, double time = 0) const {
    const auto [x, y] = model().given();
    const std::size_t n = x.size();
    State state{.q = {x.begin(), x.end()}, .u = std::vector<double>(2 * n), .time = time};
    state.q.insert(state.q.end(), y.begin(), y.end());
    for (std::size_t k = 0; velocity && k < n; ++k) {
      Point u = velocity({x[k], y[k]});
      if constexpr (requires { model().freedom(); }) u = model().freedom()[k](u);
      state.u[k] = u.x;
      state.u[n + k] = u.y;
    }
    return state;
  }
  [[nodiscard]] double mass() const {  ///< [kg/m]
    return sum([](std::size_t, std::size_t) { return 1.0; });
  }
  [[nodiscard]] std::array<double, 2> momentum(Input /*q*/, Input u) const {  ///< along x and y [kg/s]
    return {sum([&](std::size_t k, std::size_t) { return u[k]; }),
            sum([&](std::size_t k, std::size_t n) { return u[n + k]; })};
  }
  [[nodiscard]] std::array<double, 1> angular_momentum(Input q, Input u) const {  ///< about the origin [kg m/s]
    return {sum([&](std::size_t k, std::size_t n) { return q[k] * u[n + k] - q[n + k] * u[k]; })};
  }
  [[nodiscard]] double kinetic_energy(Input /*q*/, Input u) const {  ///< [J/m]
    return sum([&](std::size_t k, std::size_t n) { return 0.5 * (u[k] * u[k] + u[n + k] * u[n + k]); });
  }

 private:
  [[nodiscard]] const Model& model() const { return static_cast<const Model&>(*this); }
  /// Of mass times term(node, nodes).
  template <class Term>
  [[nodiscard]] double sum(const Term& term) const {
    const std::span<const double> masses = model().masses();
    CompensatedSum all;
    for (std::size_t k = 0; k < masses.size(); ++k) all.add(masses[k] * term(k, masses.size()));
    return all.value();
  }
};

}  // namespace seiche::mechanics
