#include "validation/studies/shallow_water/contest.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "validation/case/claims.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

using evidence::Role;

Contestant contest(const FlowProblem& problem, const Discretisation& discretisation, double time, const Front* front) {
  Contestant c;
  c.scheme = discretisation.scheme;
  try {
    const std::unique_ptr<Flow> flow = make_flow(problem, discretisation);
    flow->advance_to(time);
    c.profile = flow->profile();
    c.seconds = flow->seconds();
    c.steps = flow->steps();
  } catch (const Divergence& breakdown) {
    c.failure = breakdown.what();
    return c;
  }
  c.errors = profile_errors(c.profile, problem, time);
  if (front != nullptr) {
    c.front_error = front_position(c.profile, *front) - front->position;
    c.width = front_width(c.profile, *front);
  }
  return c;
}

std::vector<Contestant> contest_all(const FlowProblem& problem, const Discretisation& discretisation,
                                    const std::vector<std::string>& schemes, double time, const Front* front,
                                    const std::function<void(double)>& progress) {
  std::vector<Contestant> contestants;
  for (const std::string& scheme : schemes) {
    Discretisation d = discretisation;
    d.scheme = scheme;
    contestants.push_back(contest(problem, d, time, front));
    if (progress) progress(static_cast<double>(contestants.size()) / static_cast<double>(schemes.size()));
  }
  return contestants;
}

const Contestant& by_scheme(const std::vector<Contestant>& contestants, const std::string& scheme) {
  return contestants.at(
      static_cast<std::size_t>(std::ranges::find(contestants, scheme, &Contestant::scheme) - contestants.begin()));
}

void report_contest(evidence::Exhibit& exhibit, const FlowProblem& problem, double time,
                    const std::vector<Contestant>& contestants, const std::vector<std::string>& atlas) {
  evidence::Table& table = add_table(
      exhibit, "schemes", "Comparison of the schemes",
      fmt::format("Errors at t = {:g} s, means over the water: of cell means, of the method's own reconstruction, of "
                  "the piecewise constant profile. The width of the jump counts cells between 5 % and 95 % of it.",
                  time),
      {"scheme", "cell L1(h) [m]", "reconstructed L1(h) [m]", "constant L1(h) [m]", "constant L2(h) [m]",
       "constant max(h) [m]", "cell L1(u) [m/s]", "width [cells]", "front error [m]"});
  auto& figure = exhibit.figure("schemes", "Comparison of the schemes",
                                fmt::format("Depth at t = {:g} s by each scheme at the same resolution.", time), atlas);
  for (const Contestant& c : contestants) {
    if (!c.finished()) {
      table.rows.push_back({c.scheme, c.failure, "", "", "", "", "", "", ""});
      continue;
    }
    table.rows.push_back({c.scheme, c.errors.cell.depth.l1, c.errors.reconstructed.depth.l1, c.errors.constant.depth.l1,
                          c.errors.constant.depth.l2, c.errors.constant.depth.linf, c.errors.cell.velocity.l1, c.width,
                          c.front_error});
    const ProfileCurve exact = exact_curve(problem, c.profile, time);
    auto& panel = figure.panel({.x = "x [m]", .y = "depth h [m]", .title = c.scheme});
    panel.line("exact", exact.x, exact.depth, Role::exact);
    const bool particles = std::find(peer_schemes.begin(), peer_schemes.end(), c.scheme) == peer_schemes.end();
    panel.steps(particles ? "particles" : "cells", c.profile.edges, means_of(c.profile).depth,
                particles ? Role::computed : Role::peer);
  }
}

}  // namespace seiche::validation
