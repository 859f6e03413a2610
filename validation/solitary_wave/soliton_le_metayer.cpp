/*
A solitary wave of the Green-Naghdi equations, $a/h_0 = 0.21$ on $h_0 = 10$ m of water with $g = 10$ m/s², travels a
distance of $32\,h_0$ in 29.2 s through a channel 700 m long. Le Métayer, Gavrilyuk and Hank (2010) proposed the test;
Basilisk (S. Popinet) includes it in the tests of its Green-Naghdi solver and publishes the errors.

**What is compared.** The largest elevation error over the amplitude, each method at its own points: nodes here, cell
centres there; as a function of the number of cells, of the work (nodes times solves; a step of the one-step scheme is
one solve) and of the processor time, from the initial nodes to the last step. For the one-step scheme also the error
between its nodes, where the surface is straight.

**How long the steps are.** Work is inverse to $h\tau$. With errors $Sh^2$ in space and $B\tau^p$ in time it is least
where $Sh^2 = \tfrac{p}{2} B\tau^p$: equal for $p = 2$, also where both have opposite signs and cancel. Both are
measured first, on cells of `pilot`, for every scheme; $\tau$ follows for every $h$. Each scheme is thus at its best for
this wave; another wave has another $S/B$. No stage of a step is longer than half the longest stable one; orders are
claimed where that does not bind.

**What to look at.** The one-step scheme is the most efficient: one solve per step, and a time error that cancels much
of the spatial error. Fourth order in time pays only against the plain conservative scheme: the remaining spatial error
is second-order. Suzuki's composition shows the cost of the wave without that cancellation. Basilisk's error with 1024
cells needs about a ninth of them here, or a fifth if the straight lines between nodes count. Processor times depend on
the machine and are not claimed: Basilisk's point comes from another machine.
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "seiche/exact/model_waves.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation::cases::soliton_le_metayer {

using dispersive_shallow_water_1d::Flow;
using dispersive_shallow_water_1d::Scheme;
using dispersive_shallow_water_1d::TimeComposition;

/// Serre's solitary wave in a channel of constant depth.
struct SerreWave {
  static constexpr double begin = -200;  ///< ends of the channel [m]
  static constexpr double end = 500;

  double amplitude;  ///< [m]
  double depth;      ///< [m]
  double gravity;    ///< [m/s^2]
  double time;       ///< how long it is followed, from x = 0 [s]

  [[nodiscard]] exact::SerreSolitary exact() const { return exact::SerreSolitary(amplitude, depth, gravity); }
  /// Width at rest of so many cells of equal volume [m]: the channel's length and what the wave adds to it.
  [[nodiscard]] double spacing(long cells) const {
    const exact::SerreSolitary wave = exact();
    const double excess = wave.excess_up_to(end) - wave.excess_up_to(begin);
    return (end - begin + excess / depth) / static_cast<double>(cells);
  }
};

/// Largest error of a marker's elevation over the amplitude.
double largest_error(const Flow& flow, const SerreWave& wave) {
  const exact::SerreSolitary exact = wave.exact();
  const auto off = [&](std::size_t i) {
    return (flow.y()[i] - exact.elevation(flow.x()[i] - exact.speed() * flow.time())) / wave.amplitude;
  };
  return over<Worst>(indices(flow.x().size()), off).value();
}

/// Largest error of the surface over the amplitude, also between the markers, where it is straight.
double largest_surface_error(const Flow& flow, const SerreWave& wave) {
  constexpr int parts = 8;  // of a cell
  const exact::SerreSolitary exact = wave.exact();
  Worst largest;
  for (std::size_t i = 0; i + 1 < flow.x().size(); ++i) {
    for (int k = 0; k <= parts; ++k) {
      const double w = static_cast<double>(k) / parts;
      const double x = (1 - w) * flow.x()[i] + w * flow.x()[i + 1];
      const double y = (1 - w) * flow.y()[i] + w * flow.y()[i + 1];
      largest.add(y - exact.elevation(x - exact.speed() * flow.time()));
    }
  }
  return largest.value() / wave.amplitude;
}

/// The flow at wave.time, on markers `spacing` apart when at rest, by equal steps of at most tau.
Flow followed(const SerreWave& wave, double spacing, double tau, Scheme scheme) {
  const dispersive_shallow_water_1d::Channel channel{.bottom = std::make_shared<LevelBottom>(wave.depth),
                                                     .gravity = wave.gravity};
  Flow flow(channel,
            solitary_markers(channel, wave.begin, wave.end, spacing,
                             {.amplitude = wave.amplitude, .crest = 0, .depth = wave.depth}),
            scheme);
  march(flow, wave.time, tau);
  return flow;
}

const std::string peer_source = "S. Popinet, Basilisk, test of the Green-Naghdi solver, src/test/soliton.ref";
struct PeerPoint {
  int cells;
  double error;
};
constexpr PeerPoint peer[] = {{128, 0.170965}, {256, 0.0534504}, {512, 0.0125835}, {1024, 0.00298458}};
constexpr double peer_seconds = 0.49;  // for 1024 cells, about 2.3e6 cell-steps a second, on a core like ours

struct Contender {
  const char* id;
  const char* name;
  Scheme scheme;
};
constexpr auto implicit = dispersive_shallow_water_1d::Stepping::conservative;
constexpr Contender contenders[] = {
    {"one_step", "one-step", {}},
    {"conservative", "conservative", {.stepping = implicit}},
    {"conservative_3_sweeps", "conservative, 3 sweeps", {.stepping = implicit, .fixed_sweeps = 3}},
    {"one_step_triple_jump", "one-step, triple jump", {.composition = TimeComposition::triple_jump}},
    {"one_step_suzuki", "one-step, Suzuki", {.composition = TimeComposition::suzuki}},
    {"conservative_triple_jump",
     "conservative, triple jump",
     {.stepping = implicit, .composition = TimeComposition::triple_jump}},
    {"conservative_suzuki", "conservative, Suzuki", {.stepping = implicit, .composition = TimeComposition::suzuki}},
};

int order_in_time(Scheme scheme) {
  return scheme.composition == TimeComposition::none ? 2 : 4;
}

/// In units of the step.
double longest_stage(Scheme scheme) {
  return scheme.composition == TimeComposition::none          ? 1
         : scheme.composition == TimeComposition::triple_jump ? worst(mechanics::triple_jump_weights())
                                                              : worst(mechanics::suzuki_weights());
}

SerreWave wave_of(const Values& values) {
  return {.amplitude = values.real("amplitude"),
          .depth = values.real("depth"),
          .gravity = values.real("gravity"),
          .time = values.real("time")};
}

/// Errors on the pilot's cells: in space with steps that hardly count, in time against it.
class StepLength {
 public:
  StepLength(const SerreWave& wave, double pilot)
      : wave_(wave),
        pilot_(pilot),
        tau_(pilot / std::sqrt(wave.gravity * wave.depth)),
        limit_(followed(wave, pilot, tau_ / 4, {.composition = TimeComposition::suzuki})),
        space_(largest_error(limit_, wave)) {}

  /// Error in time of a scheme for steps of half the time in which a long wave crosses a cell.
  [[nodiscard]] double time_error(Scheme scheme) const {
    const Flow flow = followed(wave_, pilot_, tau_ / 2, scheme);
    const auto off = [&](std::size_t i) { return (flow.y()[i] - limit_.y()[i]) / wave_.amplitude; };
    return over<Worst>(indices(flow.y().size()), off).value();
  }

  /// tau(h) = factor h^(2/p) with the least work.
  [[nodiscard]] double best(Scheme scheme, double time_error, double spacing) const {
    const int p = order_in_time(scheme);
    const double space = space_ * std::pow(spacing / pilot_, 2);
    return tau_ / 2 * std::pow(space / (0.5 * p * time_error), 1.0 / p);
  }

  /// The step whose longest stage is half the longest stable one.
  [[nodiscard]] double longest(Scheme scheme) const { return 0.5 * limit_.stable_step() / longest_stage(scheme); }

  [[nodiscard]] double space_error() const { return space_; }

 private:
  SerreWave wave_;
  double pilot_;
  double tau_;  ///< in which a long wave crosses a cell
  Flow limit_;
  double space_;
};

/// One entry per refinement.
struct Curve {
  std::vector<double> cells, spacing, tau, error, surface_error, work, seconds;
  std::vector<bool> bound_by_stability;
};

Curve measured(const SerreWave& wave, Scheme scheme, const StepLength& steps, long coarsest, long levels) {
  Curve curve;
  const double time_error = steps.time_error(scheme);
  for (long k = 0; k < levels; ++k) {
    const long cells = coarsest << k;
    const double spacing = wave.spacing(cells);
    const double tau = std::min(steps.best(scheme, time_error, spacing), steps.longest(scheme));
    curve.bound_by_stability.push_back(tau == steps.longest(scheme));
    std::optional<Flow> flow;
    curve.seconds.push_back(shortest_time([&] { flow.emplace(followed(wave, spacing, tau, scheme)); }));
    curve.cells.push_back(static_cast<double>(cells));
    curve.spacing.push_back(spacing);
    curve.tau.push_back(tau);
    curve.error.push_back(largest_error(*flow, wave));
    curve.surface_error.push_back(largest_surface_error(*flow, wave));
    curve.work.push_back(static_cast<double>(flow->solves()) * static_cast<double>(flow->x().size()));
  }
  return curve;
}

/// Cost at which the errors fall to `error`, between its points in logarithms; empty beyond them.
std::optional<double> cost_at(const std::vector<double>& errors, const std::vector<double>& cost, double error) {
  for (std::size_t k = 0; k + 1 < errors.size(); ++k) {
    if (errors[k] < error || errors[k + 1] > error) continue;
    const double part = std::log(error / errors[k]) / std::log(errors[k + 1] / errors[k]);
    return cost[k] * std::pow(cost[k + 1] / cost[k], part);
  }
  return std::nullopt;
}

/// The wave on one of its meshes, at the end.
struct Picture {
  double tau = 0;
  std::vector<double> x, y;
};

struct Results {
  double tail;         ///< what the walls cut off the exact wave, over the amplitude
  double space_error;  ///< of the pilot
  std::vector<Curve> curves = {};
  Picture picture = {};
};

double tail_at_walls(const SerreWave& wave) {
  return std::max(wave.exact().elevation(wave.begin), wave.exact().elevation(wave.end, wave.time)) / wave.amplitude;
}

Results compute(const Run& run) {
  const SerreWave wave = wave_of(run);
  const StepLength steps(wave, run.real("pilot"));
  Results r{.tail = tail_at_walls(wave), .space_error = steps.space_error()};
  for (const Contender& contender : contenders) {
    const Curve& curve =
        r.curves.emplace_back(measured(wave, contender.scheme, steps, run.integer("coarsest"), run.integer("levels")));
    if (r.curves.size() == 1) {
      const Flow flow = followed(wave, curve.spacing[1], curve.tau[1], contender.scheme);
      r.picture = {curve.tau[1], {flow.x().begin(), flow.x().end()}, {flow.y().begin(), flow.y().end()}};
    }
    run.progress(static_cast<double>(r.curves.size()) / std::size(contenders));
  }
  return r;
}

/// Along the best steps, but for the coarsest cells, which are a depth wide.
evidence::ObservedOrder order_of(const Curve& curve, double floor) {
  std::vector<double> spacing, error;
  for (std::size_t k = 1; k < curve.error.size(); ++k) {
    if (curve.bound_by_stability[k]) continue;
    spacing.push_back(curve.spacing[k]);
    error.push_back(curve.error[k]);
  }
  return evidence::observed_order(spacing, error, floor);
}

/// Largest ratio of the errors to the peer's on as many cells.
double against_peer(const Curve& curve) {
  Largest ratio;
  for (const PeerPoint& point : peer) {
    const auto found = std::ranges::find(curve.cells, point.cells);
    ratio.add(found == curve.cells.end()
                  ? nan
                  : curve.error[static_cast<std::size_t>(found - curve.cells.begin())] / point.error);
  }
  return ratio.value();
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SerreWave wave = wave_of(values);
  const bool peers_wave = wave.amplitude == 2.1 && wave.depth == 10 && wave.gravity == 10 && wave.time == 29.2 &&
                          values.integer("coarsest") == 64;
  for (std::size_t k = 0; k < std::size(contenders); ++k) {
    const auto& [key, name, scheme] = contenders[k];
    const Claims<Curve> curve = claims.of(&Results::curves).entry(k);
    std::string id = key;
    std::ranges::replace(id, '_', '-');
    // A composition's best steps shrink like the root of the cells' width, the longest stable ones like the width.
    curve.only_if(order_in_time(scheme) == 2, "its optimal steps exceed half the longest stable one")
        .check(
            "order-" + id,
            fmt::format("The largest error converges at second order along the optimal steps ({}).", name),
            "observed order of the largest error",
            [floor = 3 * tail_at_walls(wave)](const Curve& c) { return order_of(c, floor); },
            Order{2, 0.15, "cells from half a depth, where the next order still reduces the order by 0.13"});
    curve.at("128 .. 1024 cells")
        .only_if(peers_wave, "the errors of the comparison scheme belong to the default wave on 128 .. 1024 cells")
        .from(peer_source)
        .check("against-peer-" + id,
               fmt::format("The error of {} is smaller than Basilisk's with the same number of cells.", name),
               "largest error ratio", against_peer, Bound{.limit = 1, .reason = "comparison with current practice"});
  }
}

/// What the peer's error costs.
void show_costs(evidence::Exhibit& exhibit, const std::string& id, const Curve& curve) {
  const auto keep = [&](const std::string& quantity, const std::vector<double>& errors) {
    if (const auto seconds = cost_at(errors, curve.seconds, peer[3].error)) {
      exhibit.measure("seconds_at_peer_" + quantity + "_" + id, *seconds);
      exhibit.measure("peer_seconds_over_own_" + quantity + "_" + id, peer_seconds / *seconds);
    }
    if (const auto work = cost_at(errors, curve.work, peer[3].error)) {
      exhibit.measure("marker_solves_at_peer_" + quantity + "_" + id, *work);
    }
  };
  keep("error", curve.error);
  keep("error_between_markers", curve.surface_error);
  exhibit.measure("error_" + id, curve.error.back());
}

void draw_wave(evidence::Exhibit& exhibit, const SerreWave& wave, const Picture& picture) {
  const exact::SerreSolitary exact = wave.exact();
  const std::vector<double> x = evenly(wave.begin, wave.end, 701);
  auto& panel =
      add_panel(exhibit, "wave", "Initial and final wave",
                fmt::format("One-step scheme, {} cells, steps of {:.3g} s.", picture.x.size() - 1, picture.tau),
                {.x = "x [m]", .y = "elevation [m]"});
  panel.line("exact", x, each(x, [&](double at) { return exact.elevation(at, wave.time); }), Role::exact);
  panel.line("initial", x, each(x, [&](double at) { return exact.elevation(at); }), Role::guide);
  panel.points("markers", picture.x, picture.y, Role::computed);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("tail_at_walls", r.tail);
  exhibit.measure("pilot_space_error", r.space_error);
  auto& by_time = add_panel(
      exhibit, "work_precision", "Error against processor time",
      "Largest error of the elevation over the amplitude after 32 h. Basilisk's time is from another machine.",
      {.x = "processor time [s]", .y = "error/a", .log_x = true, .log_y = true});
  auto& figure =
      exhibit.figure("cells_and_work", "Error against cells and work", "The same, independent of the machine.");
  auto& by_cells = figure.panel({.x = "cells", .y = "error/a", .log_x = true, .log_y = true});
  auto& by_work = figure.panel({.x = "nodes x solves", .y = "error/a", .log_x = true, .log_y = true});
  evidence::Table& table = add_table(
      exhibit, "runs", "Runs", "Steps of least work for each scheme; processor time of this machine.",
      {"scheme", "cells", "tau [s]", "error/a [1]", "between nodes [1]", "nodes x solves", "processor time [s]"});
  const auto draw = [&](const std::string& label, const Curve& curve, const std::vector<double>& error) {
    by_cells.line(label, curve.cells, error, Role::computed);
    by_work.line(label, curve.work, error, Role::computed);
    by_time.line(label, curve.seconds, error, Role::computed);
  };
  for (std::size_t i = 0; i < r.curves.size(); ++i) {
    const std::string name = contenders[i].name;
    const Curve& curve = r.curves[i];
    show_costs(exhibit, contenders[i].id, curve);
    draw(name, curve, curve.error);
    if (i == 0) draw(name + ", between nodes", curve, curve.surface_error);
    for (std::size_t k = 0; k < curve.cells.size(); ++k) {
      table.rows.push_back({name, curve.cells[k], curve.tau[k], curve.error[k], curve.surface_error[k], curve.work[k],
                            curve.seconds[k]});
    }
    if (i == 0) slope_guide(by_cells, -2, curve.cells, 0.4 * curve.error.back());
  }
  draw_wave(exhibit, wave_of(values), r.picture);
  by_cells.points("Basilisk", each(peer, &PeerPoint::cells), each(peer, &PeerPoint::error), Role::peer);
  by_time.points("Basilisk", std::vector{peer_seconds}, std::vector{peer[3].error}, Role::peer);
}

void soliton_le_metayer(Case& c) {
  c.title = "Solitary wave over 32 h: cost of accuracy";
  c.source =
      "O. Le Metayer, S. Gavrilyuk, S. Hank, A numerical scheme for the Green-Naghdi model, J. Comput. Phys. 229 "
      "(2010) 2034, section 6.1; S. Popinet, Basilisk, src/test/soliton.c";
  c.tiers = {Tier::full};
  c.parameters = {
      real("amplitude", 2.1, "m", {0.01, 8}, "crest above still water"),
      real("depth", 10.0, "m", {1, 20}, "of still water"),
      real("gravity", 10.0, "m/s^2", {0.1, 100}, "acceleration of gravity"),
      real("time", 29.2, "s", {1, 40}, "time at which the error is evaluated"),
      real("pilot", 3.0, "m", {0.5, 10}, "cell width at which the optimal steps are determined"),
      integer("coarsest", 64L, {32, 512}, "smallest number of cells"),
      integer("levels", {5, 6, 7}, {5, 8}, "number of resolutions, each twice the one before"),
  };
  c.study = Study(claims, compute, show, "Frank (1994), chapter 3");
}

}  // namespace seiche::validation::cases::soliton_le_metayer
