/*
A breakwater whose front and rear walls are pushed at different times bears less than a plain wall (Frank 1994, section
2.3). Waves cross a berm, which is the front wall of the structure, and reach the rear wall half a period later. The
thesis gives no geometry; this one is made up.

**Set-up.** Depth, gravity and density are 1. The rear wall is at $x = 0$. A berm of width 2 lies before it in a depth
of 0.4; its front face is a smooth step, $y_b = -1 + 0.3\,[1 + \tanh((x + 2)/0.21)]$. The basin ends at a wall at
$x = -14$. Nodes at the bottom slide along it. Forces are those of the dynamic pressure, towards the land: on the front
face, the sum of $\lambda\,\Delta y$ over the edges of the bottom; on the rear wall, over its own.

**What is compared.** The standing waves of the basin when they are small, from the eigenvalues of the linearised model.
Their forces, over the height of the wave at the far wall, stand beside those of an independent program, and beside the
force $\tanh(kH)/k$ on a plain wall. Basins of other lengths fill in the wavelengths between. Then one of the waves runs
in time, small and high. Multipliers of single steps alternate; forces are from means of two steps. The high wave needs
the hourglass potential: without it the mesh folds at the edge of the berm, for $0.02$ at the far wall within two
periods.

**What to look at.** The berm is half a wave wide for waves of about six depths. There, and on both sides of that
length, front and rear are pushed in opposite directions with nearly the same force: the structure bears less than a
tenth of what a plain wall does. Waves much longer push on both together. In the high wave the forces are no longer
sinusoidal, and the total, a small difference, has twice the frequency.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/breakwater/berm_history.hpp"
#include "validation/breakwater/berm_load.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/breakwater/surface_modes.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;
using lagrangian_mesh_2d::Flow;

const std::string source = "Frank (1994), section 2.3";
const std::string independent = "computed once by an independent implementation, two resolutions";
constexpr double shortest = 3;

struct Printed {
  double wavelength, front, rear, relative;
};
/// On 112 x 6 cells, signs as when the rear wall is pushed.
constexpr std::array<Printed, 7> printed{{{14.85, .202, .577, .825},
                                          {10.21, -.229, .515, .321},
                                          {7.60, -.403, .387, .020},
                                          {5.98, -.404, .333, .096},
                                          {4.93, -.330, .332, .003},
                                          {4.22, -.203, .345, .235},
                                          {3.30, .064, .304, .733}}};

struct Resolution {
  double columns_per_depth;
  std::size_t rows;
  [[nodiscard]] std::size_t columns(const Berm& berm) const {
    return static_cast<std::size_t>(std::lround(columns_per_depth * berm.length));
  }
  [[nodiscard]] Resolution times(double factor) const {
    return {columns_per_depth * factor, static_cast<std::size_t>(std::lround(factor * static_cast<double>(rows)))};
  }
  [[nodiscard]] std::string name(const Berm& berm) const { return fmt::format("{} x {} cells", columns(berm), rows); }
};

std::vector<StandingLoad> loads_of(const Berm& berm, const Resolution& mesh) {
  return standing_loads(berm, mesh.columns(berm), mesh.rows, shortest);
}

/// Larger of the differences of both forces.
double difference(const StandingLoad& a, const StandingLoad& b) {
  return std::max(std::abs(a.force.front - b.force.front), std::abs(a.force.rear - b.force.rear));
}

/// Of the same wave on another mesh: the one of nearly that length.
const StandingLoad& nearest(const std::vector<StandingLoad>& loads, double wavelength) {
  return *std::ranges::min_element(loads, {},
                                   [&](const StandingLoad& one) { return std::abs(one.wavelength - wavelength); });
}

void claim_independent(evidence::Record& record) {
  const std::vector<StandingLoad> loads = standing_loads(Berm{}, 112, 6, shortest);
  const std::vector<StandingLoad> coarse = standing_loads(Berm{}, 80, 4, shortest);
  evidence::Table table{.id = "forces",
                        .title = "Forces of small standing waves",
                        .caption =
                            "Over the height of the wave at the far wall, when the rear wall is pushed; the "
                            "total over the force on a plain wall. In brackets: an independent program.",
                        .columns = {{"wavelength", "depth"},
                                    {"front", "rho g depth"},
                                    {"(front)", "rho g depth"},
                                    {"rear", "rho g depth"},
                                    {"(rear)", "rho g depth"},
                                    {"total/plain wall", "1"},
                                    {"(total/plain wall)", "1"}},
                        .rows = {},
                        .atlas = {"frank-breakwater"}};
  double worst = 0;
  double between_meshes = 0;
  for (const Printed& row : printed) {
    const StandingLoad& one = nearest(loads, row.wavelength);
    worst = std::max({worst, std::abs(one.force.front - row.front), std::abs(one.force.rear - row.rear),
                      std::abs(one.relative() - row.relative)});
    between_meshes = std::max(between_meshes, difference(one, nearest(coarse, row.wavelength)));
    table.rows.push_back(
        {one.wavelength, one.force.front, row.front, one.force.rear, row.rear, one.relative(), row.relative});
  }
  record.table(std::move(table));
  record.check({.id = "independent",
                .text = "The forces are those of an independent program on 112 x 6 cells.",
                .quantity = "largest difference of front, rear and relative total",
                .unit = "rho g depth",
                .source = independent},
               {.value = worst, .resolution = "112 x 6 cells"},
               Bound{.limit = 0.02,
                     .reason = "by which that program's own values differ between 80 x 4 and 112 x 6 cells; nodes on "
                               "the face of the berm may lie elsewhere there"});
  record.check({.id = "coarse",
                .text = "80 x 4 cells give the same forces.",
                .quantity = "largest difference of front and rear",
                .unit = "rho g depth",
                .source = independent},
               {.value = between_meshes, .resolution = "80 x 4 and 112 x 6 cells"},
               Bound{.limit = 0.02, .reason = "what the independent program finds"});
}

/// Largest change of a force when the mesh becomes finer, from half the resolution on.
void claim_refinement(evidence::Record& record, const Berm& berm, const Resolution& mesh, std::size_t meshes) {
  constexpr double longer_than = 4;
  std::vector<double> changes;
  std::vector<StandingLoad> coarse;
  Resolution finest = mesh;
  for (std::size_t n = 0; n < meshes; ++n) {
    finest = mesh.times(0.5 * std::pow(2, static_cast<double>(n)));
    const std::vector<StandingLoad> fine = loads_of(berm, finest);
    double change = 0;
    for (std::size_t m = 0; m < std::min(coarse.size(), fine.size()); ++m) {
      if (fine[m].wavelength >= longer_than) change = std::max(change, difference(coarse[m], fine[m]));
    }
    if (n > 0) {
      record.measure(fmt::format("change_by_refinement_to_{}_columns", finest.columns(berm)), change);
      changes.push_back(change);
    }
    coarse = fine;
  }
  record.check({.id = "refinement",
                .text = "The forces converge with the mesh, for waves longer than four depths.",
                .quantity = "largest change by the last halving over that by the one before",
                .source = source},
               {.value = changes.back() / changes[changes.size() - 2], .resolution = "up to " + finest.name(berm)},
               Bound{.limit = 0.5,
                     .reason = "1/4 for the model's second order, which needs a mesh that resolves the "
                               "face of the berm, 0.2 depths; 1/2 for the first"});
}

void claim_band(evidence::Record& record, const std::vector<StandingLoad>& all, const std::string& mesh) {
  const auto calm = [](const StandingLoad& one) { return one.relative() < 0.1; };
  const auto first = std::ranges::find_if(all, calm);
  const auto past = std::find_if_not(first, all.end(), calm);
  record.measure("band_begin", first->wavelength);
  record.measure("band_end", (past - 1)->wavelength);
  std::vector<StandingLoad> band;
  std::ranges::copy_if(all, std::back_inserter(band),
                       [](const StandingLoad& one) { return one.wavelength >= 4.5 && one.wavelength <= 8; });
  const double worst = std::ranges::max(band, {}, &StandingLoad::relative).relative();
  record.known_failure(
      {.id = "band",
       .text = "Waves of 4.5 to 8 depths load the structure with less than a tenth of the force on a plain wall.",
       .quantity = "largest |total|/plain wall",
       .source = source},
      {.value = worst, .resolution = mesh}, Bound{.limit = 0.1, .reason = "a tenth"},
      "the shortest wave of the tank in that range, 4.51 depths, exceeds it; the measured band begins a little later "
      "(band_begin)");
  record.check(
      {.id = "antiphase",
       .text = "Front and rear are then pushed in opposite directions.",
       .quantity = "all of these waves do so",
       .source = source},
      {.value = std::ranges::all_of(band, [](const StandingLoad& one) { return one.force.front < 0; }) ? 1. : 0.,
       .resolution = mesh},
      evidence::Qualitative{.detector = "sign of the force on the front when the rear is pushed",
                            .reason = "the berm is about half a wave wide"});
}

void draw_forces(evidence::Record& record, const std::vector<StandingLoad>& all, bool as_given) {
  std::vector<double> length, front, rear, total, relative;
  for (const StandingLoad& one : all) {
    length.push_back(one.wavelength);
    front.push_back(one.force.front);
    rear.push_back(one.force.rear);
    total.push_back(one.force.total());
    relative.push_back(one.relative());
  }
  auto& figure = record.figure("forces", "Forces on a structure loaded in antiphase",
                               "Small standing waves: force on the front, on the rear and on both, over the height at "
                               "the far wall, at the moment when the rear is pushed; then the total over the force on "
                               "a plain wall. Circles: an independent program.",
                               {"frank-breakwater"});
  auto& forces = figure.panel({.x = "wavelength [depth]", .y = "force/height [rho g depth]"});
  forces.line("front", length, front, Role::computed);
  forces.line("rear", length, rear, Role::peer);
  forces.line("total", length, total, Role::exact);
  auto& relation = figure.panel({.x = "wavelength [depth]", .y = "|total|/plain wall"});
  relation.line("total", length, relative, Role::exact);
  relation.line("a tenth", std::vector{length.front(), length.back()}, std::vector{0.1, 0.1}, Role::guide);
  if (!as_given) return;
  std::vector<double> x, f, r, t;
  for (const Printed& row : printed) {
    x.push_back(row.wavelength);
    f.push_back(row.front);
    r.push_back(row.rear);
    t.push_back(row.relative);
  }
  forces.points("front, independent", x, f, Role::data);
  forces.points("rear, independent", x, r, Role::data);
  relation.points("independent", x, t, Role::data);
}

void draw_history(evidence::Panel& panel, const BermHistory& history) {
  panel.line("front", history.time, history.front, Role::computed);
  panel.line("rear", history.time, history.rear, Role::peer);
  panel.line("total", history.time, history.total, Role::exact);
}

/// Water without a wave, one step.
void claim_rest(evidence::Record& record, const Berm& berm, const Resolution& mesh, double tau) {
  Flow rest(berm.mesh(mesh.columns(berm), mesh.rows));
  rest.advance(tau);
  double fastest = 0;
  for (const double u : rest.state().u) fastest = std::max(fastest, std::abs(u));
  record.check({.id = "rest",
                .text = "Water at rest stays at rest over the berm.",
                .quantity = "largest acceleration",
                .unit = "g",
                .source = "Frank (1994), formula 7"},
               {.value = fastest / tau, .resolution = mesh.name(berm)},
               Bound{.limit = 1e-15,
                     .reason = "the forces vanish without rounding: the surface is at y = 0, and the bottom does not "
                               "enter the potential energy"});
}

/// The small wave against the eigenvalues.
void claim_small_wave(evidence::Record& record, const BermHistory& history, const SurfaceMode& mode,
                      const StandingLoad& load, const BermRunSettings& settings, const std::string& resolution) {
  const double sign = mode.multipliers.back() * mode.elevation.front() > 0 ? 1 : -1;
  double off = 0;
  for (std::size_t k = 0; k < history.time.size(); ++k) {
    const double phase = sign * std::cos(mode.frequency * history.time[k]);
    off = std::max({off, std::abs(history.front[k] - load.force.front * phase),
                    std::abs(history.rear[k] - load.force.rear * phase)});
  }
  const double clock = std::pow(mode.frequency * settings.tau, 2) / 24;
  record.check({.id = "in-time",
                .text = "A small wave that runs in time has the forces of the eigenvalues.",
                .quantity = "largest difference in a period over the force on the front",
                .source = source},
               {.value = off / std::abs(load.force.front), .resolution = resolution},
               Bound{.limit = (2 * std::numbers::pi + 1) * clock + 10 * settings.height,
                     .reason = "the scheme's clock, (omega tau)^2/24 of a phase of 2 pi and of the forces; and ten "
                               "times the height for what is not linear: the depth over the berm is 0.4"});
}

void run_in_time(Running& run, const Berm& berm, const Resolution& mesh, const std::vector<StandingLoad>& loads) {
  lagrangian_mesh_2d::Model model(berm.mesh(mesh.columns(berm), mesh.rows));
  const StandingLoad& load = nearest(loads, run.real("wavelength"));
  const SurfaceMode mode = surface_modes(model)[static_cast<std::size_t>(&load - loads.data())];
  const double period = 2 * std::numbers::pi / mode.frequency;
  const double tau = run.real("tau");
  const auto compute = [&](const BermRunSettings& settings) {
    return run_berm_wave(berm, mesh.columns(berm), mesh.rows, mode, settings);
  };
  const BermRunSettings small{.height = 1e-4, .time = period, .tau = tau};
  const BermHistory gentle = compute(small).history;
  claim_small_wave(run.record, gentle, mode, load, small, fmt::format("{}, tau = {:g}", mesh.name(berm), tau));

  const double height = run.real("amplitude");
  const BermWave wave =
      compute({.height = height, .time = run.real("periods") * period, .tau = tau, .hourglass = run.real("hourglass")});
  const auto peak = [](const std::vector<double>& values) {
    return std::max(std::ranges::max(values), -std::ranges::min(values));
  };
  run.record.measure("wavelength", load.wavelength);
  run.record.measure("period", period);
  run.record.measure("front_peak", peak(wave.history.front));
  run.record.measure("rear_peak", peak(wave.history.rear));
  run.record.measure("total_peak_over_plain_wall", peak(wave.history.total) / load.plain_wall);
  run.record.measure("worst_corner", wave.flow.worst_corner().shape);
  auto& figure = run.record.figure("history", "Forces over time",
                                   fmt::format("A standing wave of {:.3g} depths, small and of height {:g} at the far "
                                               "wall.",
                                               load.wavelength, height),
                                   {"frank-breakwater"});
  draw_history(figure.panel({.x = "t [sqrt(depth/g)]", .y = "force/height [rho g depth]", .title = "small"}), gentle);
  draw_history(figure.panel({.x = "t [sqrt(depth/g)]", .y = "force/height [rho g depth]", .title = "high"}),
               wave.history);
  const MeshWindow window{-berm.width - 2.5, 0.1};
  draw_mesh(run.record.figure("mesh", "The mesh over the berm", "At the end of the high wave's run.")
                .panel(mesh_axes("", window)),
            "mesh", wave.flow, window);
}

void run(Running& run) {
  const Berm berm{.rise = 1 - run.real("berm_depth"), .width = run.real("berm_width")};
  const Resolution mesh{run.real("columns_per_depth"), static_cast<std::size_t>(run.integer("rows"))};
  const bool as_given = berm.rise == Berm{}.rise && berm.width == Berm{}.width;
  if (as_given) claim_independent(run.record);
  claim_refinement(run.record, berm, mesh, run.tier() == Tier::quick ? 3 : 4);
  claim_rest(run.record, berm, mesh, run.real("tau"));
  run.progress(0.3);
  const std::vector<StandingLoad> all = loads_by_wavelength(berm, mesh.columns_per_depth, mesh.rows, shortest, 17);
  if (as_given) claim_band(run.record, all, mesh.name(berm));
  draw_forces(run.record, all, as_given);
  run.progress(0.5);
  run_in_time(run, berm, mesh, loads_of(berm, mesh));
}

}  // namespace

Case breakwater() {
  Case c;
  c.title = "A breakwater whose front and rear are loaded in antiphase";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 2.3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("berm_depth", 0.4, "depth", {0.2, 0.9}, "of still water over the berm"),
      real("berm_width", 2.0, "depth", {0.5, 6}, "from the middle of the front face to the rear wall"),
      real("columns_per_depth", 8.0, "1", {4, 32}, "columns of cells per depth"),
      integer("rows", 6, {2, 24}, "rows of cells"),
      real("wavelength", 6.0, "depth", {3.5, 30}, "of the wave that runs in time: the nearest in the basin"),
      real("amplitude", 0.05, "depth", {1e-6, 0.2}, "height of the high wave at the far wall"),
      real("periods", 3.0, "1", {1, 20}, "periods that the high wave runs"),
      real("tau", 0.02, "sqrt(depth/g)", {1e-3, 0.2}, "time step"),
      real("hourglass", 0.1, "1", {0, 2}, "kappa_0 of the hourglass potential of the high wave"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
