// What each scheme of the dispersive shallow-water model conserves: a solitary wave in a periodic channel, run-up and
// run-down on plane slopes, and channels of every kind.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_shallow_water_test {

using namespace dispersive_shallow_water_1d;

/// Largest defects over a run.
struct Defects {
  double energy = 0;        ///< over the energy of the start
  double momentum = 0;      ///< over the momentum of the start
  double volume = 0;        ///< of the worst cell [m^2]
  double total_volume = 0;  ///< [m^2]
  double steps = 0;
};

Defects defects_of(const mechanics::InvariantsLedger& ledger) {
  return {.energy = ledger.largest_defect("energy") / ledger.entry("energy").initial,
          .momentum = ledger.largest_defect("momentum") / ledger.entry("momentum_x").initial,
          .volume = ledger.largest_defect("volume_worst"),
          .total_volume = ledger.largest_defect("volume_total"),
          .steps = static_cast<double>(ledger.records())};
}

/// Runs to `end` with steps of at most tau and `courant` times the longest stable one; `after_step` is called after
/// each.
Defects defects_until(
    Flow& flow, double end, double tau, double courant = 0.3, const std::function<void()>& after_step = [] {}) {
  march(flow, end, stable_steps(flow, tau, courant), [&] {
    flow.observe();
    after_step();
  });
  return defects_of(flow.ledger());
}

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 3";
constexpr double length = 60, spacing = 0.25, end = 100;
const Channel periodic_channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = length};

Markers solitary() {
  return solitary_markers(periodic_channel, 0, length, spacing, {.amplitude = 0.3, .crest = 30});
}

Defects solitary_defects(const Scheme& scheme, double tau) {
  Flow flow(periodic_channel, solitary(), scheme);
  return defects_until(flow, end, tau);
}

/// One-step scheme whose velocity is projected on constant volumes after each step.
Defects projected_defects(double tau) {
  Model model(periodic_channel, solitary());
  mechanics::State state = model.state_of(solitary());
  mechanics::Start start(model);
  start.project(state);
  mechanics::OneStep<Model> scheme(model);
  mechanics::InvariantsWatch watch(model, state);
  for (long n = 0; n < std::lround(end / tau); ++n) {
    scheme.step(state, tau);
    start.project(state);
    watch.record(state);
  }
  return defects_of(watch.ledger());
}

constexpr Scheme one_step{}, feedback{.stepping = Stepping::one_step_feedback},
    conservative{.stepping = Stepping::conservative};
constexpr Scheme conservative_feedback{.stepping = Stepping::conservative, .drift_feedback = true};

/// Two digits of the defects of the energy and of the worst cell's volume.
Defects known(Check& check, const std::string& scheme, const Defects& d, double energy, double volume) {
  check.holds(scheme + ": energy.", {d.energy},
              Bound{0.1,
                    "two digits are printed (5 %), and 240 cells of about 0.25 instead of 246 would change the energy "
                    "errors by 5 to 10 %",
                    energy, true});
  check.holds(scheme + ": volume of the worst cell.", {d.volume / spacing},
              Bound{0.05, "two digits are printed", volume, true});
  return d;
}

TEST_CASE("a solitary wave of dispersive shallow water: conservation by each scheme", "[conservation]") {
  Check check(
      "dispersive_solitary_conservation", "Dispersive shallow water: conservation by each scheme",
      "Solitary wave of amplitude 0.3 in a periodic channel of depth 1 and length 60, cells of 0.25, $t \\le 100$, "
      "almost two rounds. Energies are relative to the wave's, momenta too. Momentum is exact with every scheme. The "
      "one-step scheme errs in energy and volumes by $O(\\tau^2)$, with bounds. Feedback of the volumes makes their "
      "error $O(\\tau^3)$. The fully conservative scheme conserves everything to round-off. The one-step energy is "
      "$c\\tau^2 - d\\tau^4$ with $c = 2.3\\times10^{-4}$, $d = 0.011$: at $\\tau = 0.1$ the second term is half of "
      "the first, so that the ratio 4 under halving of the step is seen below $\\tau = 0.05$ only.",
      source);
  std::vector<Defects> halved;
  for (const auto& [tau, energy, volume, total] :
       {std::tuple{0.1, 1.3e-6, 1.5e-5, 6e-9}, {0.05, 5.2e-7, 3.7e-6, 2e-9}, {0.025, 1.4e-7, 9.4e-7, 6e-10}}) {
    const std::string scheme = fmt::format("One-step, step {:g}", tau);
    halved.push_back(known(check, scheme, solitary_defects(one_step, tau), energy, volume));
    check.holds(
        scheme + ": total volume.", {halved.back().total_volume / length},
        Bound{0.5 * std::pow(10.0, std::floor(std::log10(total))), "half a unit of the one printed digit", total});
  }
  halved.push_back(solitary_defects(one_step, 0.0125));
  for (std::size_t k = 2; k < halved.size(); ++k) {
    check.holds(fmt::format("The energy error falls to a quarter with half the step {:g} (one-step scheme).",
                            0.1 / std::pow(2.0, static_cast<double>(k - 1))),
                {halved[k - 1].energy / halved[k].energy}, Bound{1, "the remainder due to the fourth-order term", 4});
  }
  const Defects c = solitary_defects(conservative, 0.05), held = solitary_defects(conservative_feedback, 0.05);
  Largest momentum;
  for (const Defects& d :
       {halved[0], halved[1], halved[2], halved[3], c, held,
        known(check, "Feedback, step 0.05", solitary_defects(feedback, 0.05), 1.4e-6, 1.5e-7),
        known(check, "Feedback, step 0.025", solitary_defects(feedback, 0.025), 1.3e-7, 1.8e-8),
        known(check, "Velocity projected after each step", projected_defects(0.05), 1.6e-6, 3.8e-6)}) {
    momentum.add(d.momentum);
  }
  check.at("tau = 0.05");
  check.that("conservative-energy", "Energy is conserved to round-off (conservative scheme).",
             "largest relative energy error", {c.energy}, Roundoff{c.steps, 1, "one rounded energy per step"});
  // Rounding a place between 32 and 60 errs by ulp/sqrt(12) = 2e-15; two markers, 2000 steps: 1.3e-13.
  check.that("conservative-volume",
             "The volume of every cell is conserved within the 1e-12 of its rounding (conservative scheme).",
             "largest volume error [depth^2]", {c.volume},
             Bound{1e-12,
                   "positions up to 60 are rounded by 2e-15 rms; two of them times the depth in 2000 steps walk "
                   "1.3e-13, and the largest of 246 cells at all times goes to five of it"});
  check.that("conservative-feedback-energy",
             "Energy is conserved within the 1e-13 of its rounding (conservative scheme with feedback).",
             "largest relative energy error", {held.energy},
             Bound{1e-13,
                   "the feedback does the work of lambda, about 0.2 under the wave, on volumes rounded by 3e-15 in "
                   "some 20 cells: 1e-14 of the wave's 0.3, which the next rounding returns; ten times that"});
  check.that("conservative-feedback-volume", "Volumes do not accumulate rounding (conservative scheme with feedback).",
             "largest volume error [depth^2]", {held.volume}, Roundoff{2, 60, "the positions of two nodes, up to 60"});
  check.at({});
  check.that("momentum", "Momentum is conserved within the 1e-14 of a random walk of roundings with every scheme.",
             "largest relative momentum error", {momentum.value()},
             Bound{1e-14,
                   "rates up to 0.26 of some 40 nodes of mass 0.25 under the wave, each rounded by 3e-17 rms in up to "
                   "8000 steps, walk 4e-15, beside the wave's momentum of 1.6"});
}

TEST_CASE("each sweep of the conservative step gains digits of energy and volume", "[conservation]") {
  Check check("dispersive_solitary_sweeps", "Dispersive shallow water: fixed numbers of sweeps",
              "Solitary wave as before, step 0.1: errors of energy and volumes after 1 to 4 sweeps per step.");
  std::vector<double> count{1, 2, 3, 4}, energy, volume;
  for (const auto& [sweeps, known_energy, known_volume] :
       {std::tuple{1, 7.6e-4, 1.0e-5}, {2, 1.3e-6, 2.2e-8}, {3, 1.6e-8, 9.3e-11}, {4, 6.2e-11, 0.0}}) {
    const Defects d = solitary_defects({.stepping = Stepping::conservative, .fixed_sweeps = sweeps}, 0.1);
    energy.push_back(d.energy);
    volume.push_back(d.volume / spacing);
    const std::string text = fmt::format("{} sweep{}", sweeps, sweeps > 1 ? "s" : "");
    if (sweeps < 4) {
      known(check, text, d, known_energy, known_volume);
      continue;
    }
    check.holds(text + ": energy.", {d.energy}, Bound{0.1, "two digits are printed", known_energy, true});
    check.holds(text + ": the volume of the worst cell is at round-off.", {d.volume},
                Bound{1e-12,
                      "positions up to 60 are rounded by 2e-15 rms; two of them in 1000 steps walk 1e-13, the largest "
                      "of 246 cells at all times goes to five of it; the sweeps leave as much"});
  }
  auto& panel = check.figure("sweeps", "Defects against sweeps", "Largest errors until t = 100.")
                    .panel({.x = "sweeps per step", .y = "relative defect", .log_y = true});
  panel.points("energy", count, energy);
  panel.points("volume of the worst cell", count, volume);
}

TEST_CASE("histories of energy and volumes of a solitary wave", "[conservation]") {
  Check check("dispersive_solitary_histories", "Dispersive shallow water: histories of energy and volumes",
              "Solitary wave as before, step 0.05. The one-step scheme errs while the wave settles and then no more; "
              "with feedback its energy does drift, slowly. The fully conservative scheme stays at round-off.",
              source);
  auto& figure = check.figure("histories", "Energy and volumes in time",
                              "Relative error of the energy, with one-step schemes and the fully conservative one, and "
                              "largest relative error of a cell's volume.");
  auto& energies = figure.panel({.x = "t", .y = "energy defect", .title = "energy, one-step"});
  auto& fine = figure.panel({.x = "t", .y = "energy defect", .title = "energy, fully conservative"});
  auto& volumes = figure.panel({.x = "t", .y = "volume defect", .title = "worst cell", .log_y = true});
  for (const auto& [name, scheme, role] :
       {std::tuple{"one-step", one_step, Role::computed}, std::tuple{"with feedback", feedback, Role::peer},
        std::tuple{"fully conservative", conservative, Role::exact}}) {
    Flow flow(periodic_channel, solitary(), scheme);
    const double first = flow.energy();
    std::vector<double> time, energy, volume;
    defects_until(flow, end, 0.05, 0.3, [&] {
      if (flow.steps() % 8 != 0) return;
      time.push_back(flow.time());
      energy.push_back((flow.energy() - first) / first);
      volume.push_back(flow.ledger().entry("volume_worst").value / spacing);
    });
    (scheme.stepping == Stepping::conservative ? fine : energies).line(name, time, energy, role);
    volumes.line(name, time, volume, role);
    if (scheme.stepping != Stepping::one_step) continue;
    const auto sum = [&, quarter = energy.size() / 4](std::size_t number) {
      const auto part = std::span(energy).subspan(number * quarter, quarter);
      return std::accumulate(part.begin(), part.end(), 0.0);
    };
    check.that("bounded", "The energy error does not drift once the wave has settled (one-step scheme).",
               "mean error for t > 75 over the mean for 50 < t < 75", {sum(3) / sum(2)},
               Bound{0.05, "ripples of 3 % from waves shed at the start; the drift with feedback makes it 1.4", 1});
  }
}

struct Beach {
  double cotangent, amplitude, spacing, end;
};

/// A solitary wave on its way to a plane slope; the crest starts where the wave's front reaches the toe (Synolakis, J.
/// Fluid Mech. 185 (1987) 523), between a wall and the shore at x = 0.
Flow beach_flow(const Beach& beach, const Scheme& scheme) {
  const double front = std::acosh(std::sqrt(20.0)) / std::sqrt(0.75 * beach.amplitude);
  const double crest = -beach.cotangent - front, wall = crest - front - 5;
  const Channel channel{
      .bottom = std::make_shared<PiecewiseLinearBottom>(std::vector{wall - 10, -beach.cotangent, 10 * beach.cotangent},
                                                        std::vector{-1.0, -1.0, 10.0}),
      .left = End::wall,
      .right = End::tip};
  return Flow(channel,
              solitary_markers(channel, wall, 0, beach.spacing, {.amplitude = beach.amplitude, .crest = crest}),
              scheme);
}

constexpr Beach synolakis{.cotangent = 19.85, .amplitude = 0.0185, .spacing = 0.25, .end = 75};

/// `refine` divides the longest step and the Courant number.
Defects synolakis_defects(const Scheme& scheme, double refine = 1) {
  Flow flow = beach_flow(synolakis, scheme);
  return defects_until(flow, synolakis.end, synolakis.spacing / 4 / refine, 0.3 / refine);
}

void check_round_off(Check& check, const std::string& id, const std::string& text, const Defects& defects,
                     double length) {
  check.holds(id + "-energy: " + text + ": energy to round-off.", {defects.energy},
              Roundoff{defects.steps, 1, "one rounded energy per step"});
  check.holds(
      id + "-volume: " + text + ": the volume of every cell to round-off.", {defects.volume},
      Roundoff{defects.steps, length, "one position, up to the channel's length, rounded per step, times the depth"});
}

TEST_CASE("run-up and full run-down on a mild slope: conservation by each scheme", "[conservation]") {
  Check check("dispersive_beach_conservation", "Dispersive shallow water: conservation on a beach",
              "Solitary wave of H/h = 0.0185 on a slope 1:19.85, run-up and run-down until $t = 75$; cells of 0.25, "
              "steps of at most 1/16 and 0.3 of the longest stable one. The one-step scheme's errors are made at the "
              "largest draw-down, $67 < t < 70$, where a thin layer runs back under a steep front; until then its "
              "energy errs by $1.4\\times10^{-6}$.",
              source);
  const auto order = [](double theory) { return Order{theory, 0.1, "four halvings of all steps"}; };
  refine(check, {"longest step", widths(synolakis.spacing / 4, {1, 2, 4, 8})},
         {{"one-step-energy-order", "The energy error on the beach is second-order in the step (one-step scheme).",
           order(2)},
          {"one-step-volume-order", "The volume error on the beach is second-order in the step (one-step scheme).",
           order(2)},
          {"feedback-energy-order", "The energy error with feedback is second-order in the step.", order(2)},
          {"feedback-volume-order", "The volume error with feedback is third-order in the step.", order(3)}},
         [&](double step) {
           const double fineness = synolakis.spacing / 4 / step;
           const Defects a = synolakis_defects({}, fineness);
           const Defects b = synolakis_defects({.stepping = Stepping::one_step_feedback}, fineness);
           return std::array{a.energy, a.volume, b.energy, b.volume};
         });
  check_round_off(check, "conservative", "Fully conservative", synolakis_defects({.stepping = Stepping::conservative}),
                  82);
}

TEST_CASE("conservation holds when nodes cross the toe of a slope", "[conservation]") {
  Check check("dispersive_corner_conservation", "Dispersive shallow water: nodes that cross a corner of the bottom",
              "Steep slopes: nodes near the toe go back and forth over it, and the frame of a node in the middle of "
              "its step may flip from one sweep of the implicit step to the next. The frames are held from the fourth "
              "sweep on. Energy and volumes do not depend on them, and stay exact.");
  for (const Beach& beach :
       {Beach{1, 0.5, 0.25, 40}, Beach{1, 0.5, 0.125, 40}, Beach{3.732, 0.1, 0.25, 40}, Beach{3.732, 0.1, 0.125, 40}}) {
    Flow flow = beach_flow(beach, {.stepping = Stepping::conservative});
    const double length = flow.x().back() - flow.x().front();
    const Defects defects = defects_until(flow, beach.end, beach.spacing / 4);
    const std::string id = fmt::format("cot-{:.0f}-cells-{:.0f}", beach.cotangent, 1 / beach.spacing);
    const std::string text =
        fmt::format("cot {:g}, amplitude {:g}, cells of {:g}", beach.cotangent, beach.amplitude, beach.spacing);
    check_round_off(check, id, text, defects, length);
  }
}

struct Basin {
  std::string text;
  Channel channel;
  TimeComposition composition = TimeComposition::none;
  double end = 60;
};

std::vector<Basin> basins() {
  const auto level = std::make_shared<LevelBottom>(1.0);
  const auto wavy = std::make_shared<CosineBottom>(1.0, 0.2, 2 * std::numbers::pi / 10);
  // Slopes 1:5 down to depth 1, shores at -20 and 20.
  const Channel shores{.bottom = std::make_shared<PiecewiseLinearBottom>(std::vector{-30.0, -15.0, 15.0, 30.0},
                                                                         std::vector{2.0, -1.0, -1.0, 2.0}),
                       .left = End::tip,
                       .right = End::tip};
  Channel consistent = shores, shores_gn = shores;
  consistent.tip_mass = TipMass::consistent;
  shores_gn.kinetics = Kinetics::green_naghdi;
  constexpr TimeComposition none = TimeComposition::none;
  std::vector<Basin> all{
      {"walls", {.bottom = level}},
      {"free ends", {.bottom = level, .left = End::free, .right = End::free}, none, 10},
      {"a free end and a wall over an uneven bottom", {.bottom = wavy, .left = End::free}, none, 3},
      {"walls on an uneven bottom", {.bottom = wavy}},
      {"walls on an uneven bottom, Green-Naghdi", {.bottom = wavy, .kinetics = Kinetics::green_naghdi}},
      {"two shores", shores},
      {"two shores with consistent masses", consistent},
      {"two shores, Green-Naghdi", shores_gn},
      {"periodic over an uneven bottom", {.bottom = wavy, .period = 40}},
      {"periodic over an uneven bottom, Green-Naghdi",
       {.bottom = wavy, .period = 40, .kinetics = Kinetics::green_naghdi}},
      {"periodic, energy of the cells' slope halved", {.bottom = level, .period = 40, .slope_energy = 1.0 / 6}},
      {"periodic, Suzuki's composition", {.bottom = level, .period = 40}, TimeComposition::suzuki}};
  for (const double power : {0.0, 2.0 / 3, 1.0, 2.0}) {
    all.push_back({fmt::format("improved dispersion, depth to the power {:.2g}, walls on an uneven bottom", power),
                   {.bottom = wavy, .alpha = 0.4, .gamma = 1.0 / 15, .depth_power = power, .reference_depth = 0.9}});
  }
  return all;
}

TEST_CASE("discrete gradients conserve energy and volumes in every kind of channel", "[conservation]") {
  Check check("dispersive_discrete_gradients", "Dispersive shallow water: energy in every kind of channel",
              "Still water of length 40 h gets the velocity $0.1\\,e^{-(x/4)^2}$, made compatible with constant "
              "volumes. The waves run to the ends and back, $t \\le 60$; water with a free end collapses there like "
              "one behind a dam, $t \\le 10$ and 3. Cells of 0.25, steps of at most 0.1. The fully conservative scheme "
              "has discrete gradients of every part of the energy: of gravity, of improved dispersion with any power "
              "of the depth, of the bottom under moving ends. Energy must be conserved to round-off with walls, shores "
              "and free ends, over level and uneven bottoms, for either kinetic energy.");
  for (const Basin& basin : basins()) {
    Markers markers = still_markers(basin.channel, equal_labels(basin.channel, -20, 20, 160));
    for (std::size_t i = 0; i < markers.size(); ++i) {
      markers.u[i] = 0.1 * std::exp(-markers.x[i] * markers.x[i] / 16);
    }
    Flow flow(basin.channel, markers, {.stepping = Stepping::conservative, .composition = basin.composition});
    const double energy = flow.energy();
    Largest kinetic;
    const Defects defects = defects_until(
        flow, basin.end, 0.1, 0.3, [&] { kinetic.add(flow.model().kinetic_energy(flow.state().q, flow.state().u)); });
    const double stages = basin.composition == TimeComposition::suzuki ? 5 : 1;
    check.holds(
        fmt::format("Energy is conserved to round-off ({}).", basin.text), {defects.energy},
        Roundoff{4 * stages * defects.steps, std::max(1.0, kinetic.value() / energy),
                 "kinetic and potential energy, and the work of the multipliers on two volumes, rounded per step, or "
                 "per stage of a composition; collapsing water turns more than it began with into motion"});
    check.holds(fmt::format("Volumes are conserved to round-off ({}).", basin.text), {defects.volume},
                Roundoff{defects.steps, 40, "one position up to 40 h rounded per step"});
  }
}

}  // namespace seiche::verification::dispersive_shallow_water_test
