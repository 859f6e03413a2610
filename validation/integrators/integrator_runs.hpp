/// What an integrator costs, how exact it is, and what it conserves, on chains of rigid links.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "validation/instruments/reference_integrators.hpp"
#include "validation/instruments/rigid_chain.hpp"

namespace seiche::validation {

/// A chain and the state it starts from.
struct ChainProblem {
  rigid_chain::RigidChain chain;
  mechanics::State start;
};

/// Largest difference of a coordinate.
double distance(const mechanics::State& a, const mechanics::State& b);

/// State at `time` by the adaptive Fehlberg method 7(8).
mechanics::State adaptive_state(const ChainProblem& problem, double time, double tolerance);

/// One entry per refinement.
struct WorkPrecision {
  std::vector<double> tau;
  std::vector<double> error;   ///< largest coordinate error at the end
  std::vector<double> solves;  ///< with A = J M^-1 J^T
  std::vector<double> cpu;     ///< s, shortest mean of five batches of runs that fill 3 ms
};
/// Steps of constant length, `steps` of them.
WorkPrecision work_and_precision(const ChainProblem& problem, mechanics::Integrator integrator,
                                 const std::vector<long>& steps, double time, const mechanics::State& truth);
/// The adaptive methods, one entry per tolerance; tau stays empty.
WorkPrecision work_and_precision(const ChainProblem& problem, mechanics::AdaptiveMethod method,
                                 const std::vector<double>& tolerances, double time, const mechanics::State& truth);
/// Error that the method would have for so many solves: a straight line between its points in logarithms.
double error_at(const WorkPrecision& curve, double solves);

/// Largest defects so far at times in geometric progression.
struct KeptInvariants {
  std::vector<double> time;
  std::vector<double> energy;
  std::vector<double> momentum;             ///< largest component
  std::vector<double> angular_momentum;     ///< of a pinned chain the vertical component, else the largest
  std::vector<double> links;                ///< |f_s|
  double modified_links = 0;                ///< largest change of f_s - (tau^2/8) u.f_s''u
  std::vector<rigid_chain::Scales> scales;  ///< largest magnitudes so far of what is rounded
  std::string broken_down;                  ///< why the run ended early; empty if it did not

  /// The last entry that is not after a time; empty where the run broke down before.
  [[nodiscard]] std::optional<std::size_t> last_until(double until) const;
};
KeptInvariants kept_invariants(const ChainProblem& problem, mechanics::Integrator integrator, double tau, long steps,
                               bool pinned, const std::function<void(double)>& progress);

}  // namespace seiche::validation
