/*
A breakwater whose front and rear walls are loaded in antiphase bears a smaller total force than a plain wall (Frank
1994, section 2.3). Waves cross a berm, the front wall of the structure, and reach the rear wall half a period later.
The thesis states no geometry; the one used here is an assumption.

**Set-up.** Depth, gravity and density are 1. The rear wall is at $x = 0$. A berm 2 wide, under water of depth 0.4, lies
before it; its front face is a smooth step, $y_b = -1 + 0.3\,[1 + \tanh((x + 2)/0.21)]$. The basin ends at a wall at $x
= -14$. Bed nodes slide along the bed. Forces are integrals of the dynamic pressure, positive landwards: on the front
face, the sum of $\lambda\,\Delta y$ over the bed edges; on the rear wall, over its own edges.

**What is compared.** Small standing waves of the basin, from the eigenvalues of the linearised model: their forces per
wave height at the far wall, beside the force $\tanh(kH)/k$ on a plain wall. Basins of other lengths give intermediate
wavelengths. One of the waves is also run in time, at small height. Multipliers of single steps alternate; forces are
means over two steps. The case `breakwater_high_wave` runs the wave at large height, `breakwater_periodic` generates
waves with a paddle.

**What to look at.** The berm is half a wavelength wide for $L/h$ of about 6. There, and for longer and shorter waves
around it, the forces on front and rear are opposite and nearly equal: the structure bears less than a tenth of the
force on a plain wall. Much longer waves load both walls in phase.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/breakwater/berm_history.hpp"
#include "validation/breakwater/berm_load.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::breakwater {

using lagrangian_mesh_2d::Flow;

const std::string source = "Frank (1994), section 2.3";
constexpr double shortest = 3;
constexpr double small_height = 1e-4;

/// What the parameters decide.
struct SetUp {
  Berm berm;
  BermResolution mesh;
  double tau;
  std::size_t meshes;  ///< of the refinement, from half the resolution on

  explicit SetUp(const Values& values)
      : berm(berm_of(values)),
        mesh(berm_mesh_of(values)),
        tau(values.real("tau")),
        meshes(values.tier() == Tier::quick ? 3 : 4) {}
  [[nodiscard]] BermResolution refined(std::size_t n) const {
    return mesh.times(0.5 * std::pow(2, static_cast<double>(n)));
  }
};

/// A wave that runs in time, small.
struct SmallWave : BasinWave {
  BermHistory history;

  /// Largest difference from the forces of the eigenvalues.
  [[nodiscard]] Worst difference() const {
    Worst off;
    for (std::size_t k = 0; k < history.time.size(); ++k) {
      const double phase = sense() * std::cos(mode.frequency * history.time[k]);
      off.add(history.front[k] - load.force.front * phase, history.time[k]);
      off.add(history.rear[k] - load.force.rear * phase, history.time[k]);
    }
    return off;
  }
};

/// The scheme's clock, (omega tau)^2/24 of a phase of 2 pi and of the forces; and what is not linear.
double in_time_limit(double frequency, double tau) {
  return (2 * std::numbers::pi + 1) * std::pow(frequency * tau, 2) / 24 + 10 * small_height;
}

struct Results {
  std::vector<double> changes;  ///< of forces by each halving of the cells
  Worst rest = {};              ///< accelerations of water without a wave
  std::vector<StandingLoad> loads = {};
  SmallWave gentle = {};
};

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s(values);
  claims.at("up to " + s.refined(s.meshes - 1).name(s.berm))
      .check(
          "refinement",
          "The change of the forces by the last halving of the cells is at most half of that by the halving before, "
          "for L/h > 4.",
          "largest change by the last halving over that by the one before",
          [](const Results& r) { return r.changes.back() / r.changes[r.changes.size() - 2]; },
          Bound{.limit = 0.5,
                .reason = "1/4 for the second order of the model, on meshes that resolve the face of the berm, 0.2 h; "
                          "1/2 for the first"});
  claims.at(s.mesh.name(s.berm))
      .from("Frank (1994), formula 7")
      .check("rest", "The acceleration of water at rest over the berm is zero, without rounding errors.",
             "largest acceleration [g]", &Results::rest,
             Bound{.limit = 0,
                   .reason = "the forces vanish without rounding: the surface is at y = 0, and the bottom does not "
                             "enter the potential energy"});
  claims.only_if(s.berm.usual(), "for the berm of the default parameters")
      .at(s.mesh.name(s.berm))
      .check(
          "antiphase", "The forces on front and rear have opposite signs for waves of L/h = 4.5 to 8.",
          "fraction of these waves with opposite forces",
          [](const Results& r) {
            Count opposite;
            for (const StandingLoad& one : r.loads) {
              if (one.wavelength < 4.5 || one.wavelength > 8) continue;
              opposite.add(one.force.front, [](double f) { return f < 0; });
            }
            return opposite.value() / static_cast<double>(opposite.samples());
          },
          Qualitative{.detector = "sign of the force on the front at the maximum force on the rear",
                      .reason = "the berm is about half a wavelength wide"});
  const double shortest_wavenumber = 2 * std::numbers::pi / shortest;
  const double fastest = std::sqrt(shortest_wavenumber * std::tanh(shortest_wavenumber));
  claims.at(fmt::format("{}, tau = {:g}", s.mesh.name(s.berm), s.tau))
      .check(
          "in-time",
          "The forces of a small wave run in time agree with its eigenmode within the clock error of the steps and 10 "
          "wave heights.",
          "largest difference in a period over the larger force",
          [s](const Results& r) -> Measurement {
            const Worst off = r.gentle.difference();
            return {.value = off.value() / worst(std::array{r.gentle.load.force.front, r.gentle.load.force.rear}),
                    .where = fmt::format("t = {:.3g}", off.where()),
                    .told = {.limit = in_time_limit(r.gentle.mode.frequency, s.tau)}};
          },
          Bound{.limit = Amount::told_by_run(in_time_limit(fastest, s.tau)),
                .reason = "the clock error of the scheme, (omega tau)^2/24 of a phase of 2 pi and of the forces; and "
                          "ten times the height for nonlinearity: the depth over the berm is 0.4. For basin waves of "
                          "L/h > 3 omega is at most its value at L/h = 3"});
}

/// Largest change of a force by each halving of the cells.
std::vector<double> changes_by_refinement(const SetUp& s) {
  constexpr double longer_than = 4;
  std::vector<double> changes;
  std::vector<StandingLoad> coarse = standing_loads(s.berm, s.refined(0), shortest);
  for (std::size_t n = 1; n < s.meshes; ++n) {
    std::vector<StandingLoad> fine = standing_loads(s.berm, s.refined(n), shortest);
    Worst change;
    for (std::size_t m = 0; m < std::min(coarse.size(), fine.size()); ++m) {
      if (fine[m].wavelength < longer_than) continue;
      change.add(coarse[m].force.front - fine[m].force.front);
      change.add(coarse[m].force.rear - fine[m].force.rear);
    }
    changes.push_back(change.value());
    coarse = std::move(fine);
  }
  return changes;
}

Results compute(const Run& run) {
  const SetUp s(run);
  Results r{.changes = changes_by_refinement(s)};
  // Accelerations in one step of water without a wave.
  Flow flow(s.mesh.mesh(s.berm));
  flow.advance(s.tau);
  r.rest = over<Worst>(flow.state().u, [&](double u) { return u / s.tau; });
  run.progress(0.3);
  r.loads = loads_by_wavelength(s.berm, s.mesh, shortest, 17);
  run.progress(0.7);
  const BasinWave wave = basin_wave(s.berm, s.mesh, run.real("wavelength"));
  const BermRunSettings settings{.height = small_height, .time = wave.period(), .tau = s.tau};
  r.gentle = {wave, run_berm_wave(s.berm, s.mesh, wave.mode, settings).history};
  return r;
}

void draw_forces(const std::vector<StandingLoad>& all, evidence::Exhibit& exhibit) {
  const std::vector<double> length = each(all, &StandingLoad::wavelength);
  auto& figure = exhibit.figure("forces", "Forces on a structure loaded in antiphase",
                                "Small standing waves: force on front, rear and both, over the height at the far wall, "
                                "at the maximum force on the rear; then the total over the force on a plain wall.",
                                {"frank-breakwater"});
  auto& forces = figure.panel({.x = "wavelength [depth]", .y = "force/height [rho g depth]"});
  draw_forces(forces, BermHistory{length, each(all, [](const StandingLoad& one) { return one.force.front; }),
                                  each(all, [](const StandingLoad& one) { return one.force.rear; }),
                                  each(all, [](const StandingLoad& one) { return one.force.total(); })});
  auto& relation = figure.panel({.x = "wavelength [depth]", .y = "|total|/plain wall"});
  relation.line("total", length, each(all, &StandingLoad::relative), Role::exact);
  relation.line("a tenth", std::vector{length.front(), length.back()}, std::vector{0.1, 0.1}, Role::guide);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp s(values);
  for (std::size_t n = 1; n < s.meshes; ++n) {
    exhibit.measure(fmt::format("change_by_refinement_to_{}_columns", s.refined(n).columns(s.berm)), r.changes[n - 1]);
  }
  if (s.berm.usual()) {
    const auto calm = [](const StandingLoad& one) { return one.relative() < 0.1; };
    const auto first = std::ranges::find_if(r.loads, calm);
    if (first != r.loads.end()) {
      exhibit.measure("band_begin", first->wavelength);
      exhibit.measure("band_end", (std::find_if_not(first, r.loads.end(), calm) - 1)->wavelength);
    }
  }
  draw_forces(r.loads, exhibit);
  const StandingLoad& load = r.gentle.load;
  exhibit.measure("wavelength", load.wavelength);
  exhibit.measure("period", r.gentle.period());
  auto& panel = add_panel(exhibit, "history", "Forces over time",
                          fmt::format("A small standing wave, L/h = {:.3g}.", load.wavelength),
                          {.x = "t [sqrt(depth/g)]", .y = "force/height [rho g depth]"}, {"frank-breakwater"});
  draw_forces(panel, r.gentle.history);
}

void breakwater(Case& c) {
  c.title = "A breakwater whose front and rear are loaded in antiphase";
  c.source = literature::frank + ", section 2.3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("berm_depth", 0.4, "depth", {0.2, 0.9}, "of still water over the berm"),
      real("berm_width", 2.0, "depth", {0.5, 6}, "from the middle of the front face to the rear wall"),
      real("columns_per_depth", 8.0, "1", {4, 32}, "columns of cells per depth"),
      integer("rows", 6, {2, 24}, "rows of cells"),
      real("wavelength", 6.0, "depth", {3.5, 30}, "of the wave run in time: the nearest mode of the basin"),
      real("tau", 0.02, "sqrt(depth/g)", {1e-3, 0.2}, "time step"),
  };
  c.published = {{.tiles = {"frank-breakwater"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::breakwater
