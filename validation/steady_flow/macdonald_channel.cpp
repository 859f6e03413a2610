/*
A river reach with friction: for the depth $h = (4/g)^{1/3}\left(1 + \tfrac12 e^{-16 (x/L - 1/2)^2}\right)$, the
discharge $q = 2$ m²/s and Manning's $n = 0.033$, the momentum equation determines the bed (MacDonald),

$$z' = \left(\frac{q^2}{g h^3} - 1\right) h' - \frac{n^2 q^2}{h^{10/3}}.$$

Bed, friction and the two ends act together over $L = 1000$ m.

**What is compared.** Depth and discharge of the settled flow, for several numbers of particles. Particles enter at
their own rhythm, and instants differ: errors are means over the last fifth of the time.

**Your solver.** `seiche exact macdonald` prints the bed z; the inflow is 2 m²/s at x = 0, the depth at 1000 m is the
template's reference. Depth and velocity of the settled flow are evaluated by the depth and by the discharge.

**What to look at.** The order away from the ends, and the first particle behind the inlet: the fixed inflow section is
only first-order accurate, and with the ends included it dominates the mean error. At a single instant the errors
scatter too much for an order.
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/steady_flow/judged_steady_flow.hpp"
#include "validation/steady_flow/settled_flow.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation::cases::macdonald_channel {

constexpr double discharge = 2;
constexpr double off_ends = 100;  // [m]

/// Of a flow at one resolution.
struct Errors {
  Mean depth;      ///< L1 over the settled instants [m]
  Mean inner;      ///< the same off the ends [m]
  Mean discharge;  ///< L1, relative
};

struct Results {
  std::vector<double> widths = {};
  std::vector<Errors> errors = {};
  Settled finest = {};

  [[nodiscard]] evidence::ObservedOrder order(Mean Errors::*error) const {
    return evidence::observed_order(widths, each(errors, [&](const Errors& e) { return (e.*error).value(); }));
  }
};

exact::MacDonald channel_of(const Values& values) {
  return exact::MacDonald::smooth_rise(values.real("gravity"), discharge);
}

/// The depth at the outflow everywhere is what a flow without the rise would have.
JudgedSteadyFlow judged_flow(const Values& values) {
  const exact::MacDonald channel = channel_of(values);
  const double length = channel.length();
  return {.source = "MacDonald et al. (1997)",
          .exact = [channel](double x) { return channel.at(x); },
          .level_water = [depth = channel.at(length).depth](double) { return depth; },
          .discharge = discharge,
          .length = length,
          .tolerance = values.real("tolerance"),
          .command =
              fmt::format("seiche exact macdonald --set discharge={:g},gravity={}", discharge, values.real("gravity"))};
}

void claims(const Values& values, const Claims<Results>& claims) {
  const exact::MacDonald channel = channel_of(values);
  const long finest = numbers_of_particles(values.integer("particles")).back();
  claims.check(
      "order", "The depth error 100 m off the ends converges at second order with bed and friction.",
      "observed order of cell L1(h), 100 m off the ends", [](const Results& r) { return r.order(&Errors::inner); },
      Order{2, 0.5, "second order; particles enter at their own rhythm, which scatters single orders by a few tenths"});
  claims
      .only_if(values.integer("particles") >= 70,
               "below 70 particles the rise of the depth, not the inlet, dominates the error")
      .check(
          "discharge",
          "The discharge converges to a uniform value at an order from 1, at the inlet, to 2, in the rest of the "
          "channel.",
          "observed order of L1(q)", [](const Results& r) { return r.order(&Errors::discharge); },
          Order{1.5, 0.5, "between first order of the inlet section and second order of the rest"});
  claim_steady_flow(claims.at(fmt::format("N = {}", finest)).of(&Results::finest), judged_flow(values),
                    {.particles = finest,
                     .time = values.real("time"),
                     .depth = channel.at(channel.length()).depth,
                     .celerity = std::sqrt(values.real("gravity") * channel.at(0).depth)});
}

Results compute(const Run& run) {
  const exact::MacDonald channel = channel_of(run);
  const double length = channel.length();
  const auto exact = [&](double x) { return channel.at(x); };
  // Starts from a flow of the right discharge and twice the rise of depth: the rise has to be found.
  const OpenReach reach{
      .length = length,
      .discharge = discharge,
      .outflow_depth = channel.at(length).depth,
      .start_depth = [&](double x) { return channel.at(x).depth * (1 + 0.1 * std::sin(3.14159 * x / length)); },
      .forcing = {.gravity = run.real("gravity"), .bed = channel.bed(), .manning = channel.manning()}};
  Results r;
  for (const long count : numbers_of_particles(run.integer("particles"))) {
    const auto done = static_cast<double>(r.errors.size());
    Errors errors;
    r.finest = settle(
        reach, count, run.real("time"), [&](double part) { run.progress((done + part) / numbers_of_resolutions); },
        [&](const Profile& now) {
          const Profile inner = part_of(now, off_ends, length - off_ends);
          errors.depth.add(shallow_water::cell_error(now, exact).depth.l1);
          errors.inner.add(shallow_water::cell_error(inner, exact).depth.l1);
          errors.discharge.add(mean_discharge_error(now, discharge));
        });
    r.widths.push_back(length / static_cast<double>(count));
    r.errors.push_back(errors);
  }
  return r;
}

void draw(evidence::Exhibit& exhibit, const exact::MacDonald& channel, const ProfileCurve& means) {
  const std::vector<double> x = evenly(0, channel.length(), 401);
  const auto bed_at = [&](double at) { return channel.elevation(at); };
  const auto depth_at = [&](double at) { return channel.at(at).depth; };
  std::vector<double> level = each(means.x, bed_at);
  for (std::size_t i = 0; i < level.size(); ++i) level[i] += means.depth[i];
  auto& figure = exhibit.figure("profile", "A river reach with friction", "Bed and surface; depth.");
  auto& top = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  top.fill("water", x, each(x, [&](double at) { return bed_at(at) + depth_at(at); }), Role::water);
  top.fill("bed", x, each(x, bed_at), Role::bed);
  top.points("particles", means.x, level, Role::computed);
  auto& bottom = figure.panel({.x = "x [m]", .y = "depth h [m]"});
  bottom.line("exact", x, each(x, depth_at), Role::exact);
  bottom.points("particles", means.x, means.depth, Role::computed);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(exhibit, "resolutions", "Refinement", "Mean errors after the flow has settled.",
                                     {"N", "L1(h) [m]", "L1(h) 100 m off the ends [m]", "L1(q)/q"});
  const std::vector<long> numbers = numbers_of_particles(values.integer("particles"));
  for (std::size_t k = 0; k < r.errors.size(); ++k) {
    const auto& [depth, inner, flow] = r.errors[k];
    table.rows.push_back({static_cast<double>(numbers[k]), depth.value(), inner.value(), flow.value()});
  }
  exhibit.measure("order_with_ends", r.order(&Errors::depth).order);
  draw(exhibit, channel_of(values), means_of(r.finest.profile));
}

void macdonald_channel(Case& c) {
  c.title = "A river reach with friction";
  c.source =
      "I. MacDonald et al., Analytic benchmark solutions for open-channel flows, J. Hydraul. Eng. 123 (1997) 1041";
  c.parameters = {
      integer("particles", {25, 70, 100}, {8, 1e4}, "smallest number of particles; up to 8 times as many run too"),
      real("time", {1000, 3000, 6000}, "s", {1, 1e6}, "settling time of the flow"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      level_tolerance_parameter(),
  };
  c.study = Study(claims, compute, show, "MacDonald et al. (1997)");
  c.submission = submission_of(judged_flow);
}

}  // namespace seiche::validation::cases::macdonald_channel
