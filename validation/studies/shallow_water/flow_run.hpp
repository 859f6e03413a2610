/// A flow computed to a few times: what every shallow-water case measures, claims and draws of it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/study.hpp"
#include "validation/studies/shallow_water/contest.hpp"
#include "validation/studies/shallow_water/flow.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

/// A flow at the times shown, the last of which is judged.
struct FlowRun {
  struct Frame {
    double time = 0;
    long steps = 0;
    Profile profile;
  };

  FlowProblem problem;
  Discretisation discretisation;
  std::vector<Frame> frames;
  ProfileErrors errors;  ///< at the last time
  double mass = 0;       ///< of all water at the last time [m^2]
  double mass_defect = 0;
  double momentum_defect = 0;
  double momentum_scale = 0;
  double max_courant = 0;

  [[nodiscard]] const Profile& profile() const { return frames.back().profile; }
  [[nodiscard]] double time() const { return frames.back().time; }
  [[nodiscard]] long steps() const { return frames.back().steps; }
};

/// Runs a flow through the given times. @param progress  told the share of the time that is done
FlowRun compute_flow(const FlowProblem& problem, const Discretisation& discretisation, const std::vector<double>& times,
                     const std::function<void(double)>& progress);

/// Whether the rearrangement is also computed as its authors wrote it, which is what their figures show; the hand-over
/// always is.
Parameter rearrangement();
/// The flow by the rearrangement as written; without frames where the parameter leaves it out.
FlowRun compute_as_written(const Values& values, const FlowProblem& problem, const Discretisation& discretisation,
                           const std::vector<double>& times);
/// Conservation, mean depths and, where there is one, the place and width of the jump by the rearrangement as written;
/// ids with the suffix "_as_written". @param range  of depths [m]  @param misses  what is measured by claims, without
/// the suffix, that the figure's run is known to miss
void claim_as_written(const Claims<FlowRun>& claims, const Values& values, const std::string& tile,
                      const FlowProblem& problem, const Discretisation& discretisation, double time, double range,
                      const Front* front, const std::map<std::string, double>& misses = {});

/// More steps than a run to `time` takes, which shows at most ten times: the largest number of operations that counts.
double most_steps(const FlowProblem& problem, const Discretisation& discretisation, double time);

/// Mass and momentum (less what passed the ends) are conserved to round-off; ids "mass" and "momentum" with the suffix.
/// @param time  end of the run
void claim_conservation(const Claims<FlowRun>& claims, const FlowProblem& problem, const Discretisation& discretisation,
                        double time, const std::string& suffix = "");

/// The jump lies inside a single particle; id "width".
void claim_single_particle(const Claims<FlowRun>& claims, const Front& front);

/// The method's own profile is the exact one to round-off; for flows of uniform states and jumps, at a fixed step.
/// @param deepest  depth that is rounded [m]
void claim_exact_profile(const Claims<FlowRun>& claims, double deepest, const Discretisation& discretisation,
                         double time);

/// No mean depth leaves [lowest, highest] but by round-off; id "range". At a fixed step.
/// @param source  why the exact solution stays inside
void claim_range(const Claims<FlowRun>& claims, double lowest, double highest, const Discretisation& discretisation,
                 double time, const std::string& source);

/// What a figure of the particle method's paper shows: the hand-over, the rearrangement as written where the parameters
/// have it, and other schemes at the same resolution.
struct ParticleFigure {
  FlowRun flow;
  FlowRun as_written;
  Front front;
  std::vector<Contestant> contestants;
};
ParticleFigure compute_figure(const Run& run, const FlowProblem& problem, const Discretisation& discretisation,
                              const std::vector<double>& times, const Front& front,
                              const std::vector<std::string>& schemes = all_schemes);
/// Profiles, which are the tiles, and numbers.
void show_figure(const ParticleFigure& figure, evidence::Exhibit& exhibit, const std::string& title,
                 const std::vector<std::string>& atlas);

/// Two panels, depth and velocity, of the exact solution at one of the times.
void draw_exact(evidence::Figure& figure, const FlowProblem& problem, double time, const std::string& title = "");
/// A row of two panels, depth and velocity, at one of the times: the exact curve, the particles as rectangles and dots;
/// and a snapshot for ParaView. @param beside  the same time by another method, before the flow's own
void draw_frame(evidence::Figure& figure, evidence::Exhibit& exhibit, const FlowRun& flow, const FlowRun::Frame& frame,
                const std::string& title, const FlowRun::Frame* beside = nullptr);
/// A figure with such a row at each of the times; with the rearrangement as written, where it was computed.
void draw_flow(const FlowRun& flow, evidence::Exhibit& exhibit, const std::string& title,
               const std::vector<std::string>& atlas, const FlowRun& literal = {});

}  // namespace seiche::validation
