/*
Run-up and wall pressure of solitary waves as functions of their height, as in figures 2 and 3 of Frank's thesis: every
wave on several meshes of his two-dimensional Lagrangian model.

**Set-up.** As in `wall_run_up_mesh`. Each mesh has columns twice as wide as its rows are high, and steps of a tenth of
the column width; the first is Frank's $h_1 = H$, $h_2 = H/2$. A wave whose mesh tangles before its maximum run-up has
no point. High waves also run on meshes with rezoned columns (`run_up_mesh_rezoned`).

**What is compared.** Run-up and loads with exact values of the Euler equations and with the series $R = 2A + \tfrac12
A^2 + \tfrac34 A^3$ of Su and Mirie, from which $p(0) = R\,(1 - 3A^2)$. The thesis gives its own points, experiments and
other computations in the figures only.

**What to look at.** The error of two rows is below 3 % up to $A = 0.2$. Higher waves need more rows: at $A = 0.5$ the
coarse mesh is 15 % low, the fine one 2 %; $A = 0.6$ needs a rezoned mesh. The pressure depends far less on the mesh,
because it integrates over the whole water column. The thesis does not define its level $y = 0$; here it is the
still-water level, where the pressure begins like the elevation.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/exact/overturning/wall_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/mesh_climb.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases::wall_run_up_mesh_figures {

const std::string source = "Frank (1994), section 2.2, figures 2 and 3";
constexpr double lowest_compared = 0.1;       // of the loads
constexpr double highest_claimed = 0.5;       // beyond, fine meshes tangle
constexpr double largest_uncertainty = 0.05;  // of a value, that still says something
const std::string counted_text = "5 % of the value counts";

struct Climbed : ClimbMaxima {
  double amplitude;
};

/// What one mesh makes of the waves that it carries to their largest run-up.
struct Curve {
  long rows = 0;
  std::vector<Climbed> points = {};
  bool rezoned = false;

  [[nodiscard]] const Climbed* at(double amplitude) const {
    const auto found = std::ranges::find_if(
        points, [&](const Climbed& point) { return std::abs(point.amplitude - amplitude) < 1e-9; });
    return found == points.end() ? nullptr : &*found;
  }
  /// NaN where the mesh tangles.
  [[nodiscard]] double value(double amplitude, double Climbed::*member) const {
    const Climbed* point = at(amplitude);
    return point == nullptr ? nan : point->*member;
  }
  [[nodiscard]] std::string name() const {
    const double h2 = 1 / static_cast<double>(rows);
    return fmt::format("{} h1 = {:g}, {} rows", rezoned ? "rezoned" : "mesh", 2 * h2, rows);
  }
};

/// 2, 4, 8, ... rows.
std::vector<long> meshes_of(const Values& values) {
  std::vector<long> meshes;
  for (long rows = 2; rows <= values.integer("rows"); rows *= 2) meshes.push_back(rows);
  return meshes;
}

struct Results {
  std::vector<Curve> curves;   ///< of Frank's model, from coarse to fine
  std::vector<Curve> rezoned;  ///< high waves on meshes whose columns are put upright again, from coarse to fine
};

/// Of the rezoned meshes, in eighths of the finest one's rows.
constexpr std::array<long, 4> rezoned_parts{4, 5, 6, 8};
constexpr double lowest_rezoned = 0.4;

void climb_on(Curve& curve, const exact::SolitaryWave& wave, const Run& run, double rezone) {
  MeshClimb climb = MeshClimb::with_rows(wave, curve.rows);
  climb.stepping = mechanics::stepping_named(run.text("scheme"));
  climb.settings.hourglass = run.real("hourglass");
  climb.rezone = rezone;
  const MeshRun up = climb_on_mesh(climb);
  if (up.fell) curve.points.push_back({up.highest, wave.amplitude()});
}

Results compute(const Run& run) {
  Results r;
  for (const long rows : meshes_of(run)) r.curves.push_back({.rows = rows});
  for (const long part : rezoned_parts) {
    r.rezoned.push_back({.rows = run.integer("rows") * part / rezoned_parts.back(), .rezoned = true});
  }
  constexpr int waves = 12;  // A = 0.05 to 0.6
  for (int k = 1; k <= waves; ++k) {
    const exact::SolitaryWave wave(0.05 * k);
    for (Curve& curve : r.curves) climb_on(curve, wave, run, 0);
    if (wave.amplitude() > lowest_rezoned - 1e-9) {
      for (Curve& curve : r.rezoned) climb_on(curve, wave, run, 0.2);
    }
    run.progress(static_cast<double>(k) / waves);
  }
  return r;
}

/// A maximum with its exact values, by the height of the wave.
struct Known {
  std::string id, name;
  double Climbed::*of;
  std::vector<double> amplitude, exact;
};

/// The run-up, then the loads.
std::vector<Known> known_maxima(const Values& values) {
  const io::Table runup = values.table("wall_runup_exact");
  const io::Table loads = values.table("wall_load_exact");
  std::vector<Known> known{{"exact", "run-up", &Climbed::level, runup.column("a"), runup.column("R")}};
  for (const LoadMaximum& load : load_maxima) {
    known.push_back({load.id, load.name, load.of, loads.column("A"), loads.column(load.column)});
  }
  return known;
}

/// Of the values that all meshes give for one wave, as half-width for the finest; NaN where one of them tangles.
double mesh_uncertainty(const std::vector<Curve>& curves, double amplitude, double Climbed::*of) {
  const auto size = each(curves, [](const Curve& curve) { return 1 / static_cast<double>(curve.rows); });
  const auto value = each(curves, [&](const Curve& curve) { return curve.value(amplitude, of); });
  return std::isnan(worst(value)) ? nan : evidence::grid_convergence(size, value, 2).uncertainty;
}

/// Largest difference of the finest mesh's value from the exact one over its uncertainty, and that of the exact value,
/// of waves between two heights; of the former no more than `largest_uncertainty` of the exact value counts.
auto off_exact(const Known& known, double lowest, double highest, double of_exact) {
  return [=](const std::vector<Curve>& curves) {
    Worst off;
    for (const std::size_t k : indices(known.amplitude.size())) {
      const double amplitude = known.amplitude[k];
      if (amplitude < lowest - 1e-9 || amplitude > highest + 1e-9) continue;
      const double own = mesh_uncertainty(curves, amplitude, known.of);
      const double most = largest_uncertainty * known.exact[k];
      off.add(
          (curves.back().value(amplitude, known.of) - known.exact[k]) / std::hypot(own > most ? most : own, of_exact),
          amplitude);
    }
    return off;
  };
}

void claims(const Values& values, const Claims<Results>& all) {
  const std::vector<Known> maxima = known_maxima(values);
  const Bound within{.limit = 1,
                     .reason = "the uncertainty is the 95 % half-width of the finest mesh, limited to " + counted_text};
  const auto rezoned =
      all.of(&Results::rezoned).where("A = {:g}").at(Curve{.rows = values.integer("rows"), .rezoned = true}.name());
  const auto finest = all.of(&Results::curves).where("A = {:g}").at(Curve{.rows = meshes_of(values).back()}.name());
  for (const Known& one : maxima) {
    rezoned.check("rezoned-" + one.id,
                  fmt::format("The {1} from A = {0:g} to 0.6 on rezoned meshes agrees with the Euler equations within "
                              "the uncertainty of the finest mesh.",
                              lowest_rezoned, (one.id == "exact" ? "" : "largest ") + one.name),
                  "largest difference over the mesh uncertainty", off_exact(one, lowest_rezoned, 1, 0), within);
  }
  finest.check(
      "exact",
      "Maximum run-up up to A = 0.5 agrees with the Euler equations within the uncertainty of the finest mesh.",
      "largest difference over the mesh uncertainty", off_exact(maxima.front(), 0, highest_claimed, 0), within);
  for (const Known& load : maxima | std::views::drop(1)) {
    finest.check(
        "exact-" + load.id,
        fmt::format(
            "The maximum {} up to A = 0.5 agrees with the Euler equations within the uncertainty of the finest mesh.",
            load.name),
        "largest difference over the uncertainty, A = 0.1 to 0.5",
        off_exact(load, lowest_compared, highest_claimed, 1e-10),
        Bound{.limit = 1,
              .reason = "the 95 % half-width from the change between meshes, limited to " + counted_text +
                        ", and column u of the exact values, at most 1e-10"});
  }
}

void tabulate(const std::vector<Curve>& curves, const Known& runup, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "runup", "Maximum run-up on a vertical wall",
                "Empty where the mesh tangles earlier; high waves also on a rezoned mesh. Series: 2A + A^2/2 + 3A^3/4.",
                {"A [depth]"});
  for (const Curve& curve : curves) table.columns.emplace_back(curve.name(), "depth");
  table.columns.insert(table.columns.end(), {{"exact", "depth"}, {"series", "depth"}});
  for (const std::size_t k : indices(runup.amplitude.size())) {
    const double amplitude = runup.amplitude[k];
    std::vector<Cell>& row = table.rows.emplace_back(1, amplitude);
    for (const Curve& curve : curves) {
      const Climbed* point = curve.at(amplitude);
      row.push_back(point ? rounded(point->level) : curve.rezoned && amplitude < lowest_rezoned ? "" : "tangles");
    }
    row.insert(row.end(), {rounded(runup.exact[k]), rounded(exact::WallRunup::su_mirie(amplitude))});
  }
}

void draw(const std::vector<Curve>& curves, const std::vector<Known>& maxima, evidence::Exhibit& exhibit) {
  const auto points_on = [&](evidence::Panel& panel, const Known& one, bool over_height = false) -> evidence::Panel& {
    const auto points = [&](const std::string& name, const std::vector<double>& amplitude,
                            const std::vector<double>& value, Role role) {
      panel.points(name, amplitude, over_height ? quotients(value, amplitude) : value, role);
    };
    points("Euler equations", one.amplitude, one.exact, Role::exact);
    for (const Curve& curve : curves) {
      points(curve.name(), each(curve.points, &Climbed::amplitude), each(curve.points, one.of),
             &curve == &curves.back() ? Role::computed : Role::peer);
    }
    return panel;
  };
  const std::vector<double> fine = evenly(0.05, 0.6, 56);
  const std::vector<double> series = each(fine, [](double a) { return exact::WallRunup::su_mirie(a); });
  auto& runup =
      exhibit.figure("runup", "Maximum run-up on a vertical wall",
                     "Solitary waves on meshes of Frank's model, high ones on a rezoned mesh, exact values of the "
                     "Euler equations, and the series of Su and Mirie; right: relative to the wave height.",
                     {"frank-fig-2"});
  points_on(runup.panel({.x = "A [depth]", .y = "R [depth]"}), maxima[0])
      .line("2A + A^2/2 + 3A^3/4", fine, series, Role::guide);
  points_on(runup.panel({.x = "A [depth]", .y = "R/A"}), maxima[0], true)
      .line("2A + A^2/2 + 3A^3/4", fine, quotients(series, fine), Role::guide);
  auto& loads = exhibit.figure("pressure", "Largest pressure on the wall",
                               "At y = 0, taken as the still-water level, and at the bottom, where it is 1 at rest; "
                               "exact values of the Euler equations.",
                               {"frank-fig-3"});
  points_on(loads.panel({.x = "A [depth]", .y = "pressure at y = 0 [rho g depth]"}), maxima[1])
      .line("R(1 - 3A^2), third order", fine, each(fine, [](double a) { return exact::WallLoad::still_series(a); }),
            Role::guide);
  points_on(loads.panel({.x = "A [depth]", .y = "pressure at the bottom [rho g depth]"}), maxima[2]);
  points_on(add_panel(exhibit, "force", "Largest force on the wall", "Hydrostatic pressure included: 0.5 at rest.",
                      {.x = "A [depth]", .y = "force [rho g depth^2]"}),
            maxima[3]);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const std::vector<Known> maxima = known_maxima(values);
  std::vector<Curve> shown = r.curves;
  shown.push_back(r.rezoned.back());
  tabulate(shown, maxima.front(), exhibit);
  draw(shown, maxima, exhibit);
}

void wall_run_up_mesh_figures(Case& c) {
  c.former_names = {"wall_run_up_2d_figures"};
  c.title = "Run-up and pressure on a vertical wall against wave height";
  c.source = literature::frank + ", section 2.2, figures 2 and 3; " + literature::su_mirie;
  c.parameters = joined({{integer("rows", {8, 16, 16}, {8, 64}, "of the finest mesh; coarser ones have 2, 4, 8, ...")},
                         mesh_method_parameters()});
  c.published = {{.tiles = {"frank-fig-2", "frank-fig-3"}, .stated = {"scheme"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wall_run_up_mesh_figures
