/*
A high solitary wave rises at a vertical wall as a thin sheet. Surface particles crowd together there, and the cells of
the Lagrangian mesh become so thin that they tangle: a corner inverts while areas, energy and pressure are still
correct. The case shows where the model ends and which variants extend it.

**Set-up.** As in `wall_run_up_mesh`. Every variant runs with increasing wave height until the mesh tangles before the
maximum run-up. The variants: the conservative scheme; fewer rows; wider or narrower columns at the wall; a start from
an impulse at the surface, which gives the mesh no vorticity; the hourglass potential, which resists the node pattern
that changes no area; a barrier potential that keeps cell corners open; rezoned columns (`run_up_mesh_rezoned`).

**What is compared.** The run-up with the exact values of the Euler equations for $A = 0.5$ and $0.6$; the largest
height that reaches its run-up; the largest whose reflection completes.

**What to look at.** Frank's own model carries waves up to $A = 0.56$ to their run-up. At $A = 0.5$ it tangles
afterwards, when the sheet falls, for every scheme and column width. At $A = 0.6$ it tangles earlier, in the top row
only, whose surface nodes slide towards the wall faster than the row beneath. The barrier lets $A = 0.5$ complete and
does not change the run-up. The hourglass potential brings $A = 0.6$ to its run-up, within 0.5 % on 16 rows; with
barrier and wide columns it completes, but the run-up is then too low. No force tried here carries $A = 0.7$ on fine
meshes. With rezoning every wave completes, with a run-up as accurate as on the meshes that last.
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <ranges>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/mesh_climb.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::wall_run_up_mesh_limit {

const std::string source = "Frank (1994), chapter 2";

/// Exact waves by height: each takes a tenth of a second.
using Waves = std::map<double, exact::SolitaryWave>;

struct Variant {
  std::string name;
  std::string title;
  std::function<void(MeshClimb&)> change;
};

std::vector<Variant> variants() {
  using Climb = MeshClimb;
  return {
      {"frank", "Frank's model", [](Climb&) {}},
      {"conservative", "conservative scheme", [](Climb& c) { c.stepping = mechanics::Stepping::conservative; }},
      {"half_rows", "half as many rows", [](Climb& c) { c.rows /= 2; }},
      {"coarse", "mesh twice as coarse", [](Climb& c) { c = c.refined(0.5); }},
      {"impulse", "start from an impulse", [](Climb& c) { c.surface_impulse = true; }},
      {"narrow", "columns half as wide at the wall", [](Climb& c) { c.wall_columns = 0.5; }},
      {"wide", "columns twice as wide at the wall", [](Climb& c) { c.wall_columns = 2; }},
      {"hourglass_0.1", "hourglass 0.1", [](Climb& c) { c.settings.hourglass = 0.1; }},
      {"hourglass_0.3", "hourglass 0.3", [](Climb& c) { c.settings.hourglass = 0.3; }},
      {"hourglass_0.6", "hourglass 0.6", [](Climb& c) { c.settings.hourglass = 0.6; }},
      {"hourglass_1", "hourglass 1", [](Climb& c) { c.settings.hourglass = 1; }},
      {"barrier", "corner barrier 1", [](Climb& c) { c.settings.corner_barrier = 1; }},
      {"barrier_hourglass", "corner barrier 1, hourglass 0.6",
       [](Climb& c) {
         c.settings.corner_barrier = 1;
         c.settings.hourglass = 0.6;
       }},
      {"all", "barrier 1, hourglass 1, columns three times as wide, impulse",
       [](Climb& c) {
         c.settings.corner_barrier = 1;
         c.settings.hourglass = 1;
         c.wall_columns = 3;
         c.surface_impulse = true;
       }},
      {"rezoned", "rezoned columns", [](Climb& c) { c.rezone = 0.2; }},
  };
}

/// One wave by one variant.
struct Fate {
  double amplitude = 0;
  double runup = 0;      ///< NaN unless the water fell after it
  bool reached = false;  ///< its largest run-up
  bool through = false;  ///< the whole reflection
  bool barrier = false;
  std::optional<MeshRun::Tangle> tangle;
};

struct Told {
  Variant variant;
  std::vector<Fate> fates = {};

  /// Null where it was not tried.
  [[nodiscard]] const Fate* at(double amplitude) const {
    const auto found =
        std::ranges::find_if(fates, [&](const Fate& fate) { return std::abs(fate.amplitude - amplitude) < 1e-9; });
    return found == fates.end() ? nullptr : &*found;
  }
  /// Up to which all waves are so; none if the first is not.
  [[nodiscard]] std::optional<double> largest(bool Fate::*is) const {
    std::optional<double> amplitude;
    for (const Fate& fate : fates | std::views::take_while(is)) amplitude = fate.amplitude;
    return amplitude;
  }
};

std::vector<Told> tell(const Run& run, Waves& waves) {
  constexpr double lowest = 0.5;
  constexpr double enough = 0.6;         // all variants are tried up to there
  constexpr double energy_limit = 0.01;  // a mesh that has crumpled against the barrier is no run-up
  const double step = 0.1 / run.number("heights");
  std::vector<Told> all;
  const std::vector<Variant> tried = variants();
  for (const Variant& variant : tried) {
    Told told{.variant = variant};
    for (int k = 0;; ++k) {
      const double amplitude = lowest + k * step;
      if (amplitude > run.real("highest") + 1e-9) break;
      MeshClimb climb =
          MeshClimb::with_rows(waves.try_emplace(amplitude, amplitude).first->second, run.integer("rows"));
      variant.change(climb);
      const MeshRun up = climb_on_mesh(climb);
      told.fates.push_back({.amplitude = amplitude,
                            .runup = up.runup(),
                            .reached = up.fell && up.energy_defect.value() < energy_limit,
                            .through = !up.tangle,
                            .barrier = climb.settings.corner_barrier > 0,
                            .tangle = up.tangle});
      if (!told.fates.back().reached && amplitude > enough - 1e-9) break;
    }
    all.push_back(std::move(told));
    run.progress(0.9 * static_cast<double>(all.size()) / static_cast<double>(tried.size()));
  }
  return all;
}

/// A wave of the article's heights, before its mesh tangles and with the hourglass potential at the same time.
struct Tangled {
  double amplitude;
  lagrangian_mesh_2d::Flow plain, held;
};

Tangled tangled(Waves& waves, double amplitude, long rows) {
  const MeshClimb plain = MeshClimb::with_rows(waves.try_emplace(amplitude, amplitude).first->second, rows);
  MeshClimb held = plain;
  held.settings.hourglass = 0.6;
  Tangled both{amplitude, climb_on_mesh(plain).flow, held.start()};
  try {
    march(both.held, both.plain.time(), held.tau);
  } catch (const Divergence&) {  // drawn as far as it comes
  }
  return both;
}

struct Results {
  std::vector<Told> all;
  std::vector<Tangled> drawn = {};
};

const Told& find(const std::vector<Told>& all, const std::string& name) {
  return *std::ranges::find_if(all, [&](const Told& one) { return one.variant.name == name; });
}

void tabulate(const std::vector<Told>& all, const io::Table& exact, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(
      exhibit, "fates", "Limits of variants of the method",
      "Run-up minus exact run-up [%], and completion of the reflection or time and position of tangling; then the "
      "largest heights tried up to which the run-up is reached and the reflection completes.",
      {"variant", "A = 0.5 [%]", "its end", "A = 0.6 [%]", "its end ", "run-up [depth]", "reflection [depth]"});
  for (const Told& told : all) {
    std::vector<Cell>& row = table.rows.emplace_back(1, told.variant.title);
    for (const double amplitude : {0.5, 0.6}) {
      const Fate* fate = told.at(amplitude);
      if (fate == nullptr || !fate->reached) {
        row.emplace_back("not reached");
      } else {
        const double exactly = entry_where(exact, {{"a", amplitude}}, "R").value_or(nan);
        const double error = fate->runup / exactly - 1;
        row.push_back(rounded(100 * error, 100));
        exhibit.measure(fmt::format("{}_a_{:g}_over_exact_less_1", told.variant.name, amplitude), error);
      }
      row.emplace_back(fate == nullptr ? std::string("not tried")
                       : fate->through ? std::string("through")
                                       : fate->tangle->where());
    }
    for (const auto& [what, is] : {std::pair{"run_up", &Fate::reached}, std::pair{"reflection", &Fate::through}}) {
      const std::optional<double> largest = told.largest(is);
      row.push_back(largest ? rounded(*largest) : "none");
      if (largest) exhibit.measure(fmt::format("{}_largest_{}", told.variant.name, what), *largest);
    }
  }
}

void draw_runup(const std::vector<Told>& all, const io::Table& exact, evidence::Exhibit& exhibit) {
  auto& panel = add_panel(exhibit, "runup", "Run-up of the variants",
                          "Up to the first height that does not reach its maximum run-up; exact values of the Euler "
                          "equations end at A = 0.6.",
                          {.x = "A [depth]", .y = "R/A", .x_min = 0.38});
  const std::vector<double>& a = exact.column("a");
  panel.points("Euler equations", a, quotients(exact.column("R"), a), Role::exact);
  const std::vector<std::string> shown{"frank", "coarse", "hourglass_1", "barrier_hourglass", "all", "rezoned"};
  for (const std::string& name : shown) {
    const Told& told = find(all, name);
    auto reached = told.fates | std::views::take_while(&Fate::reached);
    if (!reached.empty()) {
      panel.points(told.variant.title, each(reached, &Fate::amplitude),
                   each(reached, [](const Fate& fate) { return fate.runup / fate.amplitude; }),
                   name == "frank" ? Role::computed : Role::peer);
    }
  }
}

void draw_meshes(const std::vector<Tangled>& drawn, evidence::Exhibit& exhibit) {
  const MeshWindow window{.begin = -1.2, .end = 0.05};
  const auto axes = [&](const std::string& title) {
    evidence::Axes above = mesh_axes(title, window);
    above.y_min = 0;
    return above;
  };
  auto& figure = exhibit.figure("tangles", "The mesh at the wall",
                                "Upper half of the water: Frank's model before the step of tangling, and with the "
                                "hourglass potential, kappa_0 = 0.6, at the same time.");
  for (const Tangled& one : drawn) {
    draw_mesh(figure.panel(axes(fmt::format("A = {:g}, t = {:.2f}", one.amplitude, one.plain.time()))), "mesh",
              one.plain, window);
    draw_mesh(figure.panel(axes("with the potential")), "mesh", one.held, window);
  }
}

/// 1 or 0, and where the mesh tangles. All variants are tried at A = 0.5 and 0.6.
auto fate_of(const std::string& variant, double amplitude, bool Fate::*is) {
  return [=](const Results& r) -> Measurement {
    const Fate* fate = find(r.all, variant).at(amplitude);
    if (fate == nullptr) throw std::logic_error(fmt::format("A = {:g} was not tried", amplitude));
    Measurement so{.value = fate->*is ? 1.0 : 0.0};
    if (fate->tangle) so.where = fate->tangle->where();
    return so;
  };
}

void claims(const Values& values, const Claims<Results>& all) {
  const long rows = values.integer("rows");
  // The mesh does not depend on the wave.
  const Claims<Results> claims = all.at(MeshClimb::with_rows(exact::SolitaryWave(0.1), rows).resolution());
  const Qualitative reaches{
      .detector =
          "the contact point falls again before any corner inverts and before 1 % of the energy is lost or gained",
      .reason = "the Euler equations have such a solution"};
  const Qualitative goes{.detector = "no corner inverts until the crest has returned half of the way",
                         .reason = "the Euler equations have such a solution"};
  struct Fated {
    std::string id, text, variant;
    double amplitude;
    bool Fate::*is;
    std::string failure = {};  ///< why it is not so
  };
  const std::vector<Fated> fates{
      {"frank-run-up", "The run of Frank's model at A = 0.5 reaches its maximum run-up.", "frank", 0.5, &Fate::reached},
      {"frank-reflection", "The run of Frank's model at A = 0.5 completes the reflection.", "frank", 0.5,
       &Fate::through,
       "the sheet at the wall falls freely and tangles; no force resists node motions that change no area"},
      {"frank-high", "The run of Frank's model at A = 0.6 reaches its maximum run-up.", "frank", 0.6, &Fate::reached,
       "a surface node feels the pressure half a cell below it; in the thin sheet that lets the node next to the wall "
       "cross the wall's line"},
      {"barrier", "The run with the corner barrier at H/h = 0.5 completes without mesh tangling.", "barrier", 0.5,
       &Fate::through},
      {"hourglass", "The run with the hourglass potential, kappa_0 = 1, at H/h = 0.6 reaches its maximum run-up.",
       "hourglass_1", 0.6, &Fate::reached},
      {"all", "The run with barrier, hourglass potential and wide columns at the wall at H/h = 0.6 completes.", "all",
       0.6, &Fate::through},
      {"rezoned", "The run with rezoned columns at H/h = 0.6 completes.", "rezoned", 0.6, &Fate::through},
      {"rezoned-run-up", "The run with rezoned columns at H/h = 0.6 reaches its maximum run-up.", "rezoned", 0.6,
       &Fate::reached}};
  const Claims<Results> own = claims.from("not in the thesis");
  constexpr long coarsest_known = 8;  // on coarser meshes nothing is known beforehand
  for (const Fated& one : fates) {
    (one.variant == "frank" ? claims : own)
        .fails({.value = 0, .width = 0, .reason = one.failure}, !one.failure.empty() && rows >= coarsest_known)
        .check(one.id, one.text, "it does", fate_of(one.variant, one.amplitude, one.is),
               one.is == &Fate::reached ? reaches : goes);
  }
  own.check(
      "barrier-neutral", "The run-up at A = 0.5 is the same with and without the corner barrier.",
      "difference of run-ups [depth]",
      [](const Results& r) {
        return std::abs(find(r.all, "barrier").at(0.5)->runup - find(r.all, "frank").at(0.5)->runup);
      },
      Bound{.limit = 0, .reason = "no corner falls below the activation shape of the barrier until the water falls"});
  claims.check(
      "stated",
      "The failure message of a stopped run without the barrier gives time and position, before the mesh leaves the "
      "tank.",
      "fraction of the stopped runs",
      [](const Results& r) {
        Count inside;
        for (const Told& one : r.all) {
          for (const Fate& fate : one.fates) {
            if (fate.barrier || !fate.tangle) continue;
            inside.add(fate.tangle->place, [](double x) { return std::abs(x) < 2 * MeshClimb::distance; });
          }
        }
        return inside.value() / static_cast<double>(inside.samples());
      },
      Qualitative{.detector = "the failure position is in the tank", .reason = "a failure must not pass as a result"});
}

Results compute(const Run& run) {
  Waves waves;
  Results r{.all = tell(run, waves)};
  for (const double amplitude : {0.5, 0.6}) r.drawn.push_back(tangled(waves, amplitude, run.integer("rows")));
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const io::Table exact = values.table("wall_runup_exact");
  tabulate(r.all, exact, exhibit);
  draw_runup(r.all, exact, exhibit);
  draw_meshes(r.drawn, exhibit);
  for (const double amplitude : {0.5, 0.6}) {
    const Fate* fate = find(r.all, "frank").at(amplitude);
    if (fate == nullptr || !fate->tangle) continue;
    exhibit.measure(fmt::format("tangle_time_a_{:g}", amplitude), fate->tangle->time);
    exhibit.measure(fmt::format("tangle_place_a_{:g}", amplitude), fate->tangle->place);
  }
}

void wall_run_up_mesh_limit(Case& c) {
  c.former_names = {"wall_run_up_2d_limit"};
  c.title = "Limit of the Lagrangian mesh: high solitary waves at a vertical wall";
  c.source = literature::frank + ", chapter 2";
  c.tiers = {Tier::full};
  c.parameters = {
      integer("rows", {8, 16, 16}, {4, 32}, "of the mesh; columns are twice as wide as rows are high"),
      integer("heights", {2, 5, 5}, {1, 10}, "wave heights tried per 0.1 h from 0.5 h on"),
      real("highest", 0.7, "depth", {0.6, 0.8}, "of the heights tried"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wall_run_up_mesh_limit
