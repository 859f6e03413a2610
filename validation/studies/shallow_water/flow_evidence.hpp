/// What every shallow-water case says of a computed flow: the claims, curves and table rows they share.
#pragma once

#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/studies/shallow_water/flow.hpp"

namespace seiche::validation {

/// The three measures of a profile's distance from the exact one; which is which: error_measures.hpp.
struct ProfileErrors {
  shallow_water::ProfileError cell;
  shallow_water::ProfileError reconstructed;
  shallow_water::ProfileError constant;
};

/// Errors at time t. Means are taken over the length of the profile.
ProfileErrors profile_errors(const Profile& profile, const FlowProblem& problem, double t);

/// The largest mean depth above `highest` or below `lowest`; 0 if there is none.
double excursion(const Profile& profile, double lowest, double highest);

/// Claims that mass and momentum (less what passed the ends) are conserved to round-off; ids "mass" and "momentum" with
/// the suffix.
void claim_conservation(evidence::Record& record, const Flow& flow, const std::string& suffix = "");

/// A jump whose position and width are judged.
struct Front {
  double behind = 0;    ///< depth behind it, to its left [m]
  double ahead = 0;     ///< depth ahead of it [m]
  double position = 0;  ///< exact [m]
  double reach = 0;     ///< the profile is searched this far on either side [m]
};
/// Number of cells between 5 % and 95 % of the jump.
long front_width(const Profile& profile, const Front& front);
/// Where the profile crosses the mid-depth of the jump: at the jump inside a cell if the method keeps one there, else
/// where the means cross it, by linear interpolation between centres; NaN if they do not.
double front_position(const Profile& profile, const Front& front);

/// Claim that the jump lies inside a single particle; measures "front_width".
void claim_single_particle(evidence::Record& record, const Flow& flow, const Front& front);

/// Claim that the method's own profile is the exact one to round-off, with mean errors as measurements. For flows of
/// uniform states and jumps.
void claim_exact_profile(evidence::Record& record, const Flow& flow, const FlowProblem& problem, double deepest);

/// Exact curves of depth and velocity on [from, to], sampled densely and at both sides of every breakpoint.
struct ExactCurve {
  std::vector<double> x;
  std::vector<double> depth;
  std::vector<double> velocity;
};
ExactCurve exact_curve(const FlowProblem& problem, double from, double to, double t);

/// The method's own curve: its reconstruction, sampled within every cell.
ExactCurve computed_curve(const Profile& profile);

/// Centres and mean values as arrays, for drawing.
struct Means {
  std::vector<double> centre;
  std::vector<double> depth;
  std::vector<double> velocity;
};
Means means_of(const Profile& profile);

/// Adds two panels, depth and velocity, with the exact curve and the particles as rectangles (depth) and dots
/// (velocity).
void draw_profile(evidence::Figure& figure, const FlowProblem& problem, const Flow& flow, const std::string& title);

/// Runs a flow through the given times, drawing a row of two panels at each; returns the flow at the last of them.
/// @param progress  told the share of the time that is done
std::unique_ptr<Flow> run_and_draw(evidence::Record& record, const FlowProblem& problem,
                                   const Discretisation& discretisation, const std::vector<double>& times,
                                   const std::string& title, const std::vector<std::string>& atlas,
                                   const std::function<void(double)>& progress);

/// Claims that an error is what an independent implementation of the same algorithm measured, within 10 %: a larger one
/// means that something got worse, a smaller one that the number stated here is out of date.
void claim_reproduced(evidence::Record& record, const std::string& id, const std::string& quantity,
                      const std::string& text, double measured, double stated, const std::string& unit,
                      const std::string& resolution);

/// One scheme of a comparison, at the end of its run.
struct Contestant {
  std::string scheme;
  Profile profile;
  ProfileErrors errors;
  double front_error = 0;  ///< NaN without a front
  long width = 0;
  double seconds = 0;
  std::string failure;  ///< why it did not finish; empty if it did
};

/// Runs a scheme to `time`; a breakdown is kept as the contestant's failure.
Contestant contest(const FlowProblem& problem, const Discretisation& discretisation, double time, const Front* front);

/// The same for several schemes, each with the discretisation's other values.
std::vector<Contestant> contest_all(const FlowProblem& problem, const Discretisation& discretisation,
                                    const std::vector<std::string>& schemes, double time, const Front* front,
                                    const std::function<void(double)>& progress = {});

/// Adds a table of errors, widths and front errors, and a figure with a panel of depth per scheme.
void report_contest(evidence::Exhibit& record, const FlowProblem& problem, double time,
                    const std::vector<Contestant>& contestants, const std::vector<std::string>& atlas = {});

/// Keeps errors as measurements, each name with the suffix.
void measure_errors(evidence::Exhibit& record, const ProfileErrors& errors, const std::string& suffix = "");

/// Adds the profile as a snapshot for ParaView.
void add_snapshot(evidence::Record& record, const Flow& flow);

}  // namespace seiche::validation
