/// One way to run a shallow-water flow by any scheme of the library, so that a case can put them side by side.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "seiche/shallow_water/relations.hpp"
#include "validation/instruments/error_measures.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"

namespace seiche::validation {

using Profile = shallow_water::MeasuredProfile;
using shallow_water::State;

/// A flow on a flat bed with a known solution.
struct FlowProblem {
  /// What is beyond an end: a wall, the uniform stream that is there at t = 0 (for particles a piston moving with it),
  /// or dry bed.
  enum class End { wall, stream, dry };

  double gravity = 9.81;
  double start = 0;           ///< [m]
  double end = 1;             ///< [m]
  std::vector<double> jumps;  ///< initial discontinuities, where an edge is placed
  End left = End::wall;
  End right = End::wall;
  std::function<State(double x, double t)> exact;
  std::function<std::vector<double>(double t)> breakpoints;

  [[nodiscard]] double length() const { return end - start; }
};

/// Names of the schemes as users write them: the three levels of the particle method, then its peers.
inline const std::vector<std::string> particle_schemes{"G1", "M2", "H2"};
inline const std::string as_written = "as_written";  ///< the particle method's rearrangement in its authors' words
inline const std::vector<std::string> peer_schemes{"lax_friedrichs", "maccormack", "roe", "muscl"};
inline const std::vector<std::string> all_schemes{"G1", "M2", "H2", "lax_friedrichs", "maccormack", "roe", "muscl"};

struct Discretisation {
  std::string scheme = "H2";
  long particles = 100;       ///< over the whole of [start, end]; a dry part of it holds none of them
  bool equal_masses = false;  ///< instead of equal widths; particles only
  double time_step = 0;       ///< [s]; 0: from the Courant number
  double courant = 0.4;
  double theta = 2;  ///< generalised minmod

  /// "N = 100, tau = 0.05 s".
  [[nodiscard]] std::string text() const;
};

/// A flow being computed.
class Flow {
 public:
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;
  Flow(Flow&&) = delete;
  Flow& operator=(Flow&&) = delete;
  virtual ~Flow() = default;

  /// Steps until `time`, the last step shortened if need be. @throws Divergence
  void advance_to(double time, const std::function<void(double)>& after_step = {});

  [[nodiscard]] virtual double time() const = 0;
  [[nodiscard]] virtual Profile profile() const = 0;
  [[nodiscard]] virtual double mass_defect() const = 0;
  [[nodiscard]] virtual double momentum_defect() const = 0;
  [[nodiscard]] virtual double max_courant() const = 0;
  /// Sum of m (|u| + c): what one step's rounding errors are relative to [m^3/s].
  [[nodiscard]] double momentum_scale() const;
  [[nodiscard]] long steps() const { return steps_; }
  /// Processor time spent in steps [s].
  [[nodiscard]] double seconds() const { return seconds_; }

 protected:
  Flow(Discretisation discretisation, double gravity) : discretisation_(std::move(discretisation)), gravity_(gravity) {}

 private:
  virtual void step(double tau) = 0;
  [[nodiscard]] virtual double largest_step(double courant) const = 0;

  Discretisation discretisation_;
  double gravity_ = 0;
  long steps_ = 0;
  double seconds_ = 0;
};

/// @throws std::invalid_argument naming the parameter when the problem or the discretisation makes no sense
std::unique_ptr<Flow> make_flow(const FlowProblem& problem, const Discretisation& discretisation);

/// The problem of an exact solution of the library.
template <validation::ShallowWaterSolution S>
FlowProblem problem_of(const S& solution, double gravity, double start, double end, std::vector<double> jumps,
                       FlowProblem::End left = FlowProblem::End::wall,
                       FlowProblem::End right = FlowProblem::End::wall) {
  return {.gravity = gravity,
          .start = start,
          .end = end,
          .jumps = std::move(jumps),
          .left = left,
          .right = right,
          .exact = [solution](double x, double t) { return solution.at(x, t); },
          .breakpoints = [solution](double t) { return solution.breakpoints(t); }};
}

}  // namespace seiche::validation
