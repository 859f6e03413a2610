/*
Dam breaks over a dry bed and over water of $h_0/h_1 = 0.1$ and $0.5$, refined: dam at $x = 20$ m in $[0, 50]$ m, $t =
6$ s, Courant number 0.4. Corners of rarefactions and bores limit **every** scheme to first order in the mean; schemes
differ in the constant.

**What is compared.** The mean error of cell depths, and the processor time, for the particle method with equal masses
(recommended) and equal widths, its first-order variant, and the comparison schemes. A given $N$ is the same initial
width for all; over a dry bed the particles cover only the water.

**What to look at.** The second figure: processor time for a given error.
*/
#include <algorithm>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "validation/studies/shallow_water/contest.hpp"

namespace seiche::validation::cases::dam_break_convergence {

struct Contender {
  const char* label;
  const char* id;  ///< in names of measurements and claims
  const char* scheme;
  bool equal_masses;
  double theta;
  Role role;
  bool over_dry;
};
constexpr Contender contenders[] = {
    {"H2, equal masses", "h2_masses", "H2", true, 2, Role::computed, true},
    {"H2, equal widths", "h2_widths", "H2", false, 1.5, Role::computed, true},
    {"G1", "g1", "G1", false, 1.5, Role::computed, true},
    {"MUSCL-HLL", "muscl", "muscl", false, 1.5, Role::peer, true},
    {"Roe", "roe", "roe", false, 1.5, Role::peer, true},
    {"Lax-Friedrichs", "lax_friedrichs", "lax_friedrichs", false, 1.5, Role::peer, true},
    {"MacCormack", "maccormack", "maccormack", false, 1.5, Role::peer, false}};

constexpr double time = 6;
constexpr double ratios[] = {0, 0.1, 0.5};

std::string id_of(double ratio) {
  return fmt::format("ratio-{:02.0f}", 10 * ratio);
}
std::string name_of(double ratio) {
  return ratio == 0 ? "Dry bed" : fmt::format("h0/h1 = {:g}", ratio);
}

/// Numbers of cells, each twice the one before.
std::vector<long> counts_of(const Values& values) {
  std::vector<long> counts;
  for (long k = 0; k < values.integer("levels"); ++k) counts.push_back(values.integer("coarsest") << k);
  return counts;
}

/// One contender at one depth ratio, refined.
struct Refined {
  double ratio;
  const Contender* contender;
  std::vector<double> counts = {};
  std::vector<double> errors = {};  ///< cell L1(h)
  std::vector<double> seconds = {};
  evidence::ObservedOrder order = {};

  [[nodiscard]] double finest() const { return errors.back(); }
};

struct Results {
  std::vector<Refined> all;

  /// @throws std::invalid_argument where there is none
  [[nodiscard]] const Refined& of(double ratio, const std::string& id) const {
    for (const Refined& one : all) {
      if (one.ratio == ratio && one.contender->id == id) return one;
    }
    throw std::invalid_argument(fmt::format("{} was not run at h0/h1 = {:g}", id, ratio));
  }
};

void claims(const Values& values, const Claims<Results>& claims) {
  const auto finest = claims.at(fmt::format("N = {}", counts_of(values).back()));
  for (const double ratio : ratios) {
    const std::string id = id_of(ratio);
    const std::string name = name_of(ratio);
    for (const Contender& one : contenders) {
      if (one.scheme != std::string("H2")) continue;
      claims.check(
          fmt::format("order-{}-{}", id, one.id), fmt::format("{}: {} converges at first order.", name, one.label),
          "observed order of cell L1(h)", [ratio, who = one.id](const Results& r) { return r.of(ratio, who).order; },
          Order{1, 0.2, "first order; single errors scatter by 10 to 20 % with the position of jumps within cells"});
    }
    const auto quotient = [ratio](const char* who, const char* whose) {
      return [=](const Results& r) { return r.of(ratio, who).finest() / r.of(ratio, whose).finest(); };
    };
    finest.from("this comparison")
        .check("against-peer-" + id,
               fmt::format("{}: the error with equal masses is at most 1 times the error of MUSCL-HLL with equal N.",
                           name),
               "error over the error of MUSCL-HLL", quotient("h2_masses", "muscl"),
               Bound{.limit = 1, .reason = "comparison with current practice"});
  }
}

Refined refine(const FlowProblem& problem, double ratio, const Contender& one, const std::vector<long>& counts) {
  Refined refined{.ratio = ratio, .contender = &one};
  std::vector<double> widths;
  for (const long count : counts) {
    const Contestant c = contest(
        problem, {.scheme = one.scheme, .particles = count, .equal_masses = one.equal_masses, .theta = one.theta}, time,
        nullptr);
    refined.counts.push_back(static_cast<double>(count));
    widths.push_back(problem.length() / refined.counts.back());
    refined.errors.push_back(c.errors.cell.depth.l1);
    refined.seconds.push_back(c.seconds);
  }
  refined.order = evidence::observed_order(widths, refined.errors);
  return refined;
}

Results compute(const Run& run) {
  Results r;
  for (const double ratio : ratios) {
    const double gravity = run.real("gravity");
    using End = FlowProblem::End;
    const FlowProblem problem =
        ratio == 0 ? problem_of(exact::Ritter(gravity, 1, 20), gravity, 0, 50, {20}, End::wall, End::dry)
                   : problem_of(exact::Stoker(gravity, 1, ratio, 20), gravity, 0, 50, {20});
    for (const Contender& one : contenders) {
      if (ratio == 0 && !one.over_dry) continue;
      r.all.push_back(refine(problem, ratio, one, counts_of(run)));
      run.progress(static_cast<double>(r.all.size()) / 20.0);
    }
  }
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const std::vector<long> counts = counts_of(values);
  for (const double ratio : ratios) {
    const std::string id = id_of(ratio);
    auto& figure = exhibit.figure(id, name_of(ratio),
                                  "Mean error of cell depths against the number of cells and against processor time.");
    auto& by_number = figure.panel({.x = "N", .y = "cell L1(h) [m]", .log_x = true, .log_y = true});
    auto& by_time = figure.panel({.x = "processor time [s]", .y = "cell L1(h) [m]", .log_x = true, .log_y = true});
    evidence::Table& table = add_table(exhibit, id, name_of(ratio), "Cell L1(h) at t = 6 s.", {"scheme"});
    for (const long count : counts) table.columns.emplace_back(fmt::format("N = {}", count), "m");
    table.columns.emplace_back("order", "");
    for (const Refined& one : r.all) {
      if (one.ratio != ratio) continue;
      auto& row = table.rows.emplace_back();
      row.emplace_back(one.contender->label);
      row.insert(row.end(), one.errors.begin(), one.errors.end());
      row.emplace_back(one.order.order);
      by_number.points(one.contender->label, one.counts, one.errors, one.contender->role);
      // Clocks do not resolve less than 1e-5 s.
      by_time.points(one.contender->label, each(one.seconds, [](const double s) { return std::max(s, 1e-5); }),
                     one.errors, one.contender->role);
    }
    const std::vector<double> guide{static_cast<double>(counts.front()), static_cast<double>(counts.back())};
    by_number.line("order 1", guide, std::vector<double>{0.1 * 50 / guide[0], 0.1 * 50 / guide[1]}, Role::guide);
  }
}

void dam_break_convergence(Case& c) {
  c.title = "Convergence of dam breaks";
  c.source = "exact solutions of Ritter (1892) and Stoker (1957)";
  c.parameters = {
      integer("coarsest", {50, 50, 100}, {10, 10000}, "smallest number of cells"),
      integer("levels", {5, 6, 7}, {4, 10}, "number of resolutions, each twice the one before"),
      real("gravity", 9.81, "m/s^2", {0.1, 1e3}, "acceleration of gravity"),
  };
  c.study = Study(claims, compute, show, "corners and jumps limit every scheme");
}

}  // namespace seiche::validation::cases::dam_break_convergence
