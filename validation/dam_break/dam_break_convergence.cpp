/*
Dam breaks over a dry bed and over water of $h_0/h_1 = 0.1$ and $0.5$, refined: dam at $x = 20$ m in $[0, 50]$ m, $t =
6$ s, Courant number 0.4. Corners of fans and jumps limit **every** scheme to first order in the mean; what differs is
the constant.

**What is compared.** The mean error of cell depths, and the processor time it takes, for the particle method with equal
masses (recommended) and equal widths, its first-order level, and the peers. A given $N$ means the same initial width
for all; over a dry bed the particles cover only the water.

One entry has help that no peer has: the exact waves of the first moments of the dam break, until their fan spans eight
particles.

**What to look at.** The second picture: how long one has to wait for a given error.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/dam_break.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;

struct Contender {
  const char* label;
  const char* id;  ///< in names of measurements and claims
  const char* scheme;
  bool equal_masses;
  double theta;
  Role role;
  bool over_dry;
  bool exact_start = false;
};
constexpr Contender contenders[] = {
    {"H2, equal masses", "h2_masses", "H2", true, 2, Role::computed, true},
    {"H2, equal widths", "h2_widths", "H2", false, 1.5, Role::computed, true},
    {"G1", "g1", "G1", false, 1.5, Role::computed, true},
    {"MUSCL-HLL", "muscl", "muscl", false, 1.5, Role::peer, true},
    {"Roe", "roe", "roe", false, 1.5, Role::peer, true},
    {"Lax-Friedrichs", "lax_friedrichs", "lax_friedrichs", false, 1.5, Role::peer, true},
    {"MacCormack", "maccormack", "maccormack", false, 1.5, Role::peer, false},
    {"H2, equal masses, exact first moments", "h2_exact_start", "H2", true, 2, Role::computed, false, true}};

FlowProblem problem_for(double gravity, double ratio) {
  using End = FlowProblem::End;
  if (ratio == 0) return problem_of(exact::Ritter(gravity, 1, 20), gravity, 0, 50, {20}, End::wall, End::dry);
  return problem_of(exact::Stoker(gravity, 1, ratio, 20), gravity, 0, 50, {20});
}

void run(Running& run) {
  const double gravity = run.real("gravity");
  const double time = 6;
  const long coarsest = run.integer("coarsest");
  const long levels = run.integer("levels");
  int job = 0;
  for (const double ratio : {0.0, 0.1, 0.5}) {
    const FlowProblem problem = problem_for(gravity, ratio);
    const std::string id = fmt::format("ratio-{:02.0f}", 10 * ratio);
    const std::string name = ratio == 0 ? "Dry bed" : fmt::format("h0/h1 = {:g}", ratio);
    auto& figure = run.record.figure(
        id, name, "Mean error of cell depths against the number of cells and against processor time.");
    auto& by_number = figure.panel({.x = "N", .y = "cell L1(h) [m]", .log_x = true, .log_y = true});
    auto& by_time = figure.panel({.x = "processor time [s]", .y = "cell L1(h) [m]", .log_x = true, .log_y = true});
    evidence::Table table{.id = id, .title = name, .caption = "Cell L1(h) at t = 6 s.", .columns = {{"scheme", ""}}};
    for (long k = 0; k < levels; ++k) table.columns.push_back({fmt::format("N = {}", coarsest << k), "m"});
    table.columns.emplace_back("order", "");
    double best_peer = 0;
    double recommended = 0;
    for (const Contender& one : contenders) {
      if (ratio == 0 && !one.over_dry) continue;
      std::vector<double> counts;
      std::vector<double> widths;
      std::vector<double> errors;
      std::vector<double> seconds;
      std::vector<std::variant<double, std::string>> row{std::string(one.label)};
      for (long k = 0; k < levels; ++k) {
        const Discretisation d{.scheme = one.scheme,
                               .particles = coarsest << k,
                               .equal_masses = one.equal_masses,
                               .theta = one.theta,
                               .exact_start = one.exact_start};
        const Contestant c = contest(problem, d, time, nullptr);
        counts.push_back(static_cast<double>(d.particles));
        widths.push_back(problem.length() / counts.back());
        errors.push_back(c.errors.cell.depth.l1);
        seconds.push_back(std::max(c.seconds, 1e-5));
        row.emplace_back(errors.back());
      }
      const evidence::ObservedOrder order = evidence::observed_order(widths, errors);
      row.emplace_back(order.order);
      table.rows.push_back(row);
      by_number.points(one.label, counts, errors, one.role);
      by_time.points(one.label, seconds, errors, one.role);
      run.record.measure(fmt::format("cell_l1_h_{}_{}", id, one.id), errors.back());
      if (one.scheme == std::string("muscl")) best_peer = errors.back();
      if (one.id == std::string("h2_masses")) recommended = errors.back();
      if (one.exact_start) {
        run.record.check({.id = "exact-start-" + id,
                          .text = fmt::format("{}: the exact waves of the first moments lower the error.", name),
                          .quantity = "error over that of equal masses alone",
                          .source = "this comparison"},
                         {.value = errors.back() / recommended, .resolution = fmt::format("N = {:g}", counts.back())},
                         evidence::Bound{.limit = 1, .reason = "an option that costs something has to help"});
      } else if (one.scheme == std::string("H2")) {
        // Not of the exact start: eight particles are a large share of the fan on the coarse rows.
        run.record.check(
            {.id = fmt::format("order-{}-{}", id, one.id),
             .text = fmt::format("{}: {} converges at first order.", name, one.label),
             .quantity = "observed order of cell L1(h)",
             .source = "corners and jumps limit every scheme"},
            order,
            evidence::Order{1, 0.2,
                            "first order; the position of jumps within cells makes single errors scatter by 10 to "
                            "20 % about it"});
      }
      run.progress(++job / 22.0);
    }
    std::vector<double> guide_x{static_cast<double>(coarsest), static_cast<double>(coarsest << (levels - 1))};
    by_number.line("order 1", guide_x, std::vector<double>{0.1 * 50 / guide_x[0], 0.1 * 50 / guide_x[1]}, Role::guide);
    run.record.table(std::move(table));
    run.record.check(
        {.id = "against-peer-" + id,
         .text = fmt::format("{}: equal masses are at least as accurate as today's scheme at the same N.", name),
         .quantity = "error over that of MUSCL-HLL",
         .source = "this comparison"},
        {.value = recommended / best_peer, .resolution = fmt::format("N = {}", coarsest << (levels - 1))},
        evidence::Bound{.limit = 1, .reason = "a method that is worse than current practice has to say so"});
  }
}

}  // namespace

Case dam_break_convergence() {
  Case c;
  c.title = "Dam breaks refined";
  c.source = "exact solutions of Ritter (1892) and Stoker (1957)";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("coarsest", {50, 50, 100}, {10, 10000}, "smallest number of cells"),
      integer("levels", {5, 6, 7}, {4, 10}, "how often it is doubled, plus one"),
      real("gravity", 9.81, "m/s^2", {0.1, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
