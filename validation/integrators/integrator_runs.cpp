#include "validation/integrators/integrator_runs.hpp"

#include <cmath>

#include "seiche/divergence.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation {

namespace {

using mechanics::State;
using rigid_chain::RigidChain;

/// run(chain, state) from the start, once to measure the error, then for the time.
template <class Run>
void measure(WorkPrecision& result, const ChainProblem& problem, const State& truth, const Run& run) {
  RigidChain chain = problem.chain;
  State state = problem.start;
  const long before = chain.solves();
  run(chain, state);
  result.error.push_back(distance(state, truth));
  result.solves.push_back(static_cast<double>(chain.solves() - before));
  Smallest shortest;
  for (int batch = 0; batch < 5; ++batch) {
    int runs = 0;
    const double begin = processor_seconds();
    do {
      state = problem.start;
      run(chain, state);
      ++runs;
    } while (processor_seconds() - begin < 0.003);
    shortest.add((processor_seconds() - begin) / runs);
  }
  result.cpu.push_back(shortest.value());
}

/// Largest change of f_s - (tau^2/8) u.f_s''u since the first call.
class ModifiedLinks {
 public:
  ModifiedLinks(const RigidChain& chain, double tau)
      : chain_(chain), tau_(tau), links_(chain.constraints()), bending_(links_.size()) {}

  void record(const State& state) {
    chain_.constraint_values(state.q, links_);
    chain_.curvature(state.u, state.u, bending_);
    for (std::size_t s = 0; s < links_.size(); ++s) links_[s] -= tau_ * tau_ / 8 * bending_[s];
    if (first_.empty()) first_ = links_;
    for (std::size_t s = 0; s < links_.size(); ++s) largest_.add(links_[s] - first_[s]);
  }
  [[nodiscard]] double largest() const { return largest_.value(); }

 private:
  const RigidChain& chain_;
  double tau_;
  std::vector<double> links_, bending_, first_;
  Worst largest_;
};

}  // namespace

double distance(const State& a, const State& b) {
  Worst largest;
  for (std::size_t i = 0; i < a.q.size(); ++i) largest.add(a.q[i] - b.q[i]);
  return largest.value();
}

State adaptive_state(const ChainProblem& problem, double time, double tolerance) {
  RigidChain chain = problem.chain;
  State state = problem.start;
  mechanics::integrate_adaptive(mechanics::AdaptiveMethod::fehlberg_78, chain, state, time, tolerance);
  return state;
}

WorkPrecision work_and_precision(const ChainProblem& problem, mechanics::Integrator integrator,
                                 const std::vector<long>& steps, double time, const State& truth) {
  WorkPrecision result;
  for (const long count : steps) {
    const double tau = time / static_cast<double>(count);
    result.tau.push_back(tau);
    measure(result, problem, truth, [&](RigidChain& chain, State& state) {
      const mechanics::StepFunction step = make_integrator(integrator, chain);
      for (long n = 0; n < count; ++n) step(state, tau);
    });
  }
  return result;
}

WorkPrecision work_and_precision(const ChainProblem& problem, mechanics::AdaptiveMethod method,
                                 const std::vector<double>& tolerances, double time, const State& truth) {
  WorkPrecision result;
  for (const double tolerance : tolerances) {
    measure(result, problem, truth, [&](RigidChain& chain, State& state) {
      mechanics::integrate_adaptive(method, chain, state, time, tolerance);
    });
  }
  return result;
}

double error_at(const WorkPrecision& curve, double solves) {
  std::size_t right = 1;
  while (right + 1 < curve.solves.size() && curve.solves[right] < solves) ++right;
  const double from = std::log(curve.solves[right - 1]);
  const double weight = (std::log(solves) - from) / (std::log(curve.solves[right]) - from);
  return std::exp((1 - weight) * std::log(curve.error[right - 1]) + weight * std::log(curve.error[right]));
}

std::optional<std::size_t> KeptInvariants::last_until(double until) const {
  constexpr double rounding = 1e-9;
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < time.size() && time[k] <= until * (1 + rounding); ++k) last = k;
  const bool lasted = broken_down.empty() || (!time.empty() && time.back() >= until * (1 - rounding));
  return lasted ? last : std::nullopt;
}

KeptInvariants kept_invariants(const ChainProblem& problem, mechanics::Integrator integrator, double tau, long steps,
                               bool pinned, const std::function<void(double)>& progress) {
  KeptInvariants result;
  RigidChain chain = problem.chain;
  State state = problem.start;
  mechanics::InvariantsWatch watch(chain, state);
  ModifiedLinks modified(chain, tau);
  modified.record(state);
  const mechanics::StepFunction step = make_integrator(integrator, chain);
  const mechanics::InvariantsLedger& ledger = watch.ledger();
  rigid_chain::Scales scales;
  const auto keep = [&] {
    result.time.push_back(state.time);
    result.energy.push_back(ledger.largest_defect("energy"));
    result.momentum.push_back(ledger.largest_defect("momentum"));
    result.angular_momentum.push_back(ledger.largest_defect(pinned ? "angular_momentum_z" : "angular_momentum"));
    result.scales.push_back(scales);
    result.links.push_back(ledger.largest_defect("volume_worst"));
  };
  const double growth = std::pow(10.0, 0.05);
  double next = 1;
  try {
    for (long n = 1; n <= steps; ++n) {
      step(state, tau);
      watch.record(state);
      modified.record(state);
      scales.include(scales_of(chain, state));
      if (static_cast<double>(n) < next && n < steps) continue;
      keep();
      const double later = next * growth;
      next = later < next + 1 ? next + 1 : later;
      progress(static_cast<double>(n) / static_cast<double>(steps));
    }
  } catch (const Divergence& divergence) {
    result.broken_down = divergence.what();
  } catch (const linear::NotPositiveDefinite& error) {
    result.broken_down = error.what();
  }
  result.modified_links = modified.largest();
  return result;
}

}  // namespace seiche::validation
