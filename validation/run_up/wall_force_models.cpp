/*
Which model suits the force of a wave on a wall? A high solitary wave meets a vertical wall, computed with seven models:
shallow water, dispersive shallow water, the Lagrangian mesh, Gauss-principle particles, Dirichlet cells, variable-mass
particles, and weakly compressible SPH. The reference is fully nonlinear potential flow by the boundary-integral method.

**Set-up.** Depth, gravity and density are 1. The wave starts from its exact surface and velocities, at a distance where
it is less than 0.0002 of its height at the wall; the dispersive model starts from the solitary wave of its own
equations. In SPH the mirror image of the water replaces the wall. Each model is refined in space and time together.

**What is compared.** Force per unit width on the wall, obtained in the same way from all models: the hydrostatic force
on the opposite wall minus the gain of the water's momentum over intervals of 0.1; the exact force is averaged over the
same intervals. The water level at the wall is read at the end of each. The error is the rms from the time at which the
undisturbed crest would be at a distance of 4 from the wall until the level there has fallen to half of its maximum,
over the largest force in excess of the hydrostatic one.

**What to look at.** Above H/h of some 0.4 the force has two maxima, with a dip between them at the time of the highest
level, when the water at the wall is nearly in free fall (Cooker, Weidman and Bale 1997). Gauss-principle particles and
the mesh show both; the force of cells with stabilised pressures fluctuates by as much as the dip, in SPH by a fifth of
the maximum. Dispersive shallow water has one maximum, 3 % too high, and its run-up is 7 % too low; in plain shallow
water the wave becomes a bore. With `heights` the models meet waves of H/h = 0.1 to 0.6 at the quick tier's resolutions:
the force error of dispersive shallow water grows from 1 to 12 % of the maximum force; the errors of Gauss-principle
particles, mesh, Dirichlet cells and variable-mass particles stay below 0.6 % up to H/h = 0.4. The mesh breaks down at
0.5, the other three at 0.6. The error of SPH with seven particles over the depth is 9 to 21 %.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <span>

#include <fmt/format.h>

#include "seiche/exact/overturning/wall_runup.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/side_by_side/tank_wave.hpp"

namespace seiche::validation::cases::wall_force_models {

using exact::SolitaryWave;

const std::string source = "Cooker, Weidman and Bale (1997); exact flow";
constexpr double interval = 0.1;  ///< over which forces are means
constexpr double at_rest = 0.5;   ///< force of still water
constexpr TankSizes coarse{.particles = 4, .mesh = 16, .cells = 6, .sph = 7, .markers = 32};  ///< of the quick tier
constexpr double first_look = 4;  ///< distance of the crest from the wall, from which forces count [depth]

using Curve = std::vector<double>;  ///< of one interval after another

/// What the wall feels: force less that at rest, and level above it.
struct Felt {
  Curve force, level;
};

/// How much lower the force is between its two largest maxima than at the lower of them; 0 with one maximum.
double dip(const Curve& force) {
  Largest deepest;
  deepest.add(0);
  for (std::size_t k = 1; k + 1 < force.size(); ++k) {
    const std::span all(force);
    deepest.add(std::min(std::ranges::max(all.first(k)), std::ranges::max(all.subspan(k))) - force[k]);
  }
  return deepest.value();
}

/// The exact force on the wall of a tank, over the intervals of a run.
struct Wall {
  SolitaryWave wave;
  double start = 0;       ///< of the crest, from the wall at the left; as far from the other
  std::size_t first = 0;  ///< interval from which forces count
  Felt felt;
  double largest = 0;      ///< force
  double uncertainty = 0;  ///< of the largest, relative

  explicit Wall(const SolitaryWave& incident)
      : wave(incident), start(std::ceil(-std::log(5e-5) / incident.decay_rate())) {
    const exact::WallLoad load(wave.amplitude());
    const double earlier = (load.separation() - start) / wave.speed();  // its clock began before
    first = static_cast<std::size_t>(std::ceil((start - first_look) / wave.speed() / interval));
    const auto intervals = static_cast<long>((load.history().back().time - earlier) / interval);
    for (long k = 0; k < intervals; ++k) {
      const auto at = [&](double part) {
        return load.at(earlier + interval * (static_cast<double>(k) + part)).force - at_rest;
      };
      felt.level.push_back(load.at(earlier + interval * static_cast<double>(k + 1)).level);
      felt.force.push_back((at(0) + 4 * at(0.25) + 2 * at(0.5) + 4 * at(0.75) + at(1)) / 12);  // Simpson's rule
    }
    largest = std::ranges::max(felt.force);
    uncertainty = load.uncertainty();
  }
  [[nodiscard]] double end() const { return interval * static_cast<double>(felt.force.size()); }
};

Racer start_shallow_water(const Wall& wall, long cells) {
  using namespace shallow_water_finite_volume;
  const double length = 2 * wall.start;
  const auto count = static_cast<std::size_t>(std::lround(length * static_cast<double>(cells)));
  std::vector<double> depth, discharge;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(cells);
    const double elevation = wall.wave.elevation(x - wall.start);
    depth.push_back(1 + elevation);
    discharge.push_back(wall.wave.speed() * elevation);  // a wave of permanent form
  }
  const auto flow =
      std::make_shared<FiniteVolumeFlow>(FiniteVolumeFlow::Settings{.gravity = 1}, 0, length, depth, discharge);
  return {[flow](double time) { march(*flow, time); },
          [flow, cells] {
            double energy = 0;
            for (std::size_t i = 0; i < flow->cells(); ++i) {
              const double h = flow->depth()[i];
              energy += h * flow->velocity()[i] * flow->velocity()[i] / 2 + (h - 1) * (h - 1) / 2;
            }
            return Sight{.off = {flow->depth().back() - 1}, .energy = energy / static_cast<double>(cells)};
          },
          [flow] { return flow->momentum(); }};
}

/// What is off is the force, of the intervals so far. `felt` keeps what the last start gives, the finest.
Contender by_force(Contender one, const Wall& wall, Felt& felt) {
  one.start = [start = std::move(one.start), &wall, &felt](long n) {
    const auto racer = std::make_shared<Racer>(start(n));
    const auto momentum = std::make_shared<double>(racer->momentum());
    felt = {};
    const auto advance = [racer, momentum, &felt](double time) {
      while (interval * (static_cast<double>(felt.force.size()) + 0.5) < time) {
        racer->advance_to(interval * static_cast<double>(felt.force.size() + 1));
        const double before = std::exchange(*momentum, racer->momentum());
        felt.force.push_back((before - *momentum) / interval);
        const Sight at_wall = racer->look();
        felt.level.push_back(at_wall.off.empty() ? nan : at_wall.off.back());
      }
    };
    const auto look = [racer, &wall, &felt] {
      Sight sight{.energy = racer->look().energy};
      for (std::size_t k = wall.first; k < felt.force.size(); ++k) {
        sight.off.push_back((felt.force[k] - wall.felt.force[k]) / wall.largest);
      }
      return sight;
    };
    return Racer{advance, look};
  };
  return one;
}

/// All models against one wave.
struct Meeting {
  double amplitude;
  Wall wall;
  Contest contest = {};
  std::map<std::string, Felt> felt = {};  ///< by the model's id, on its finest resolution
};

struct Results : Meeting {
  std::vector<Meeting> heights;  ///< lower and higher waves, on the quick tier's sizes
};

double highest(const Felt& felt) {
  return felt.level.empty() ? 0 : std::ranges::max(felt.level);
}

/// Root mean square of the level's error over the exact run-up, as long as the model goes on.
double error_of_level(const Felt& felt, const Meeting& r) {
  Mean off;
  for (std::size_t k = r.wall.first; k < felt.level.size(); ++k) off.add(felt.level[k] - r.wall.felt.level[k], 1);
  return off.rms() / highest(r.wall.felt);
}

void claims(const Values& values, const Claims<Results>& claims) {
  const Claims<Results> all = claims.at("the finest");
  const auto contest = all.of(&Results::contest);
  const auto high = all.only_if(values.real("amplitude") >= 0.45, "lower waves have one maximum, or a small dip");
  const std::string share = "dip over the dip of the exact force";
  const auto dip_of = [](const std::string& id) {
    return [id](const Results& r) { return dip(r.felt.at(id).force) / dip(r.wall.felt.force); };
  };
  const auto two_maxima = [&](const Claims<Results>& list, const Named& model) {
    list.check(model.id + "-dip", fmt::format("The force has two maxima with a dip between them ({}).", model.name),
               share, dip_of(model.id),
               Bound{.limit = 0.5,
                     .reason = "a force with one maximum is in error by the whole dip; the limit is half of it",
                     .expected = 1});
  };
  two_maxima(high, {"particles", "Gauss particles"});
  two_maxima(high, {"mesh", "the Lagrangian mesh"});
  const auto noisy = high.fails(
      {.width = std::numeric_limits<double>::infinity(),
       .reason =
           "forces of cells with stabilised pressures fluctuate by as much as the dip, with six rows and with twelve"});
  two_maxima(noisy, {"dirichlet", "Dirichlet cells"});
  two_maxima(noisy, {"variable-mass", "particles of variable mass"});
  high.check(
      "shallow-water-one-maximum", "The hydrostatic force of shallow water has a single maximum.", share,
      dip_of("shallow-water"),
      Bound{.limit = 0.5,
            .reason = "hydrostatic pressure excludes vertical acceleration; the limit is half of the exact dip"});
  claims_of(contest, "mesh")
      .only_if(values.real("amplitude") == 0.5, "lower waves do not tangle the mesh, higher ones do so earlier")
      .fails({.width = std::numeric_limits<double>::infinity(),
              .reason = "no force restores the shape of a Lagrangian cell: as the water falls along the wall, the mesh "
                        "tangles below the surface"})
      .check(
          "mesh-lasts", "The run reaches the end time (the Lagrangian mesh).", "fraction of the requested time",
          [](const Entry& entry) { return entry.finest().lasted / entry.finest().asked; },
          Bound{.limit = 1e-9, .reason = "the requested time", .expected = 1});
  const std::string nearly_long = "the equations of the dispersive model are accurate for lower waves";
  contest.only_if(values.real("amplitude") >= 0.3, nearly_long)
      .check(
          "particles-force",
          "The force error of Gauss-principle particles is below 0.1 of the error of dispersive shallow water.",
          "rms error of the force over the error of the dispersive model",
          [](const Contest& c) { return error_of_finest(c.of("particles")) / error_of_finest(c.of("dispersive")); },
          Bound{.limit = 0.1,
                .reason = "the error of equations without vertical structure of the acceleration does not fall with "
                          "resolution; an error ten times smaller shows that the structure is resolved"});
  all.only_if(values.real("amplitude") >= 0.3, nearly_long)
      .check(
          "particles-run-up",
          "The run-up error of Gauss-principle particles is below 0.2 of the error of dispersive shallow water.",
          "rms error of the level at the wall over the error of the dispersive model",
          [](const Results& r) {
            return error_of_level(r.felt.at("particles"), r) / error_of_level(r.felt.at("dispersive"), r);
          },
          Bound{.limit = 0.2,
                .reason = "the level is the acceleration integrated twice: the error of the equations is smaller in it "
                          "than in the force, where the limit is 0.1"});
  const auto by_height = all.only_if(values.toggle("heights"), "a single wave height is computed");
  by_height.check(
      "dispersive-grows", "The force error of dispersive shallow water grows with the wave height.",
      "error at H/h = 0.2 to 0.6 above the error at the height before",
      [](const Results& r) {
        const auto error = [](const Meeting& met) { return error_of_finest(met.contest.of("dispersive")); };
        const auto not_above = [&](const Meeting& a, const Meeting& b) { return !(error(b) > error(a)); };
        return std::ranges::adjacent_find(r.heights, not_above) == r.heights.end() ? 1.0 : 0.0;
      },
      Qualitative{.detector = "errors at two neighbouring heights compared",
                  .reason = "the equations neglect terms of the vertical acceleration that grow with the height"});
  by_height.check(
      "lowest-two-maxima", "The smallest wave height with two maxima of the exact force is about H/h = 0.4.",
      "least height with a dip [depth]",
      [](const Results& r) {
        const auto two =
            std::ranges::find_if(r.heights, [](const Meeting& met) { return dip(met.wall.felt.force) > 0; });
        return two == r.heights.end() ? nan : two->amplitude;
      },
      Bound{.limit = 0.1, .reason = "heights at intervals of 0.1; the source states some 0.4", .expected = 0.4});
  claim_dissipates(claims_of(contest, "sph"), {"sph", "SPH"},
                   "artificial viscosity acts on approaching pairs only and is dissipative", source);
}

Meeting meet(const Run& run, double amplitude, const TankSizes& sizes) {
  Meeting met{amplitude, Wall(SolitaryWave(amplitude))};
  const Wall& wall = met.wall;
  TankWave tank = solitary_tank(wall.wave, wall.start, 2 * wall.start, 4 * wall.start);
  tank.surface = [](double, double) { return 0.0; };
  tank.amplitude = 1;
  tank.part = [end = tank.length](double) { return TankWave::Part{end - 0.5, end + 1e-9}; };  // its last point counts
  const auto dispersive = [&](double spacing) {
    using namespace dispersive_shallow_water_1d;
    const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
    return Flow(channel, solitary_markers(channel, 0, tank.length, spacing,
                                          {.amplitude = wall.wave.amplitude(), .crest = wall.start}));
  };
  std::vector<Contender> contenders = tank_contenders(tank, dispersive, sizes);
  contenders.push_back({.id = "shallow-water",
                        .name = "shallow water, finite volumes",
                        .size_of = "cell size",
                        .role = Role::data,
                        .resolutions = ladder_to(sizes.markers, {0.5, 1}),
                        .size = [](long n) { return 1 / static_cast<double>(n); },
                        .start = [&wall](long n) { return start_shallow_water(wall, n); }});
  for (Contender& one : contenders) one = by_force(std::move(one), wall, met.felt[one.id]);
  met.contest = contest(run, contenders,
                        {.end = wall.end(),
                         .last = wall.end(),
                         .looks = 4,
                         .useless = 1,
                         .useless_in_words = "the force error exceeds the largest force",
                         .energy_scale = wall.wave.kinetic_energy(),
                         .reference_uncertainty = wall.uncertainty});
  return met;
}

Results compute(const Run& run) {
  Results results{meet(run, run.real("amplitude"), tank_sizes(run))};
  if (run.toggle("heights")) {
    for (const double amplitude : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
      results.heights.push_back(meet(run, amplitude, coarse));
    }
  }
  return results;
}

/// Error of the force, and the dip, over the height of the wave: a curve of each model.
void draw_heights(const Results& r, evidence::Exhibit& exhibit) {
  const Curve heights = each(r.heights, &Meeting::amplitude);
  const std::string sizes = "Over the largest exact force, at the quick tier's resolutions.";
  auto& errors = add_panel(exhibit, "heights", "Error of the force over the height of the wave", sizes,
                           {.x = "height of the wave [depth]", .y = "rms error / largest force", .log_y = true});
  auto& dips = add_panel(exhibit, "dips", "Dip between two maxima of the force over the height of the wave", sizes,
                         {.x = "height of the wave [depth]", .y = "dip / largest force", .y_min = 0, .y_max = 0.2});
  const auto exact = [](const Meeting& met) { return dip(met.wall.felt.force) / met.wall.largest; };
  dips.line("exact", heights, each(r.heights, exact), Role::exact);
  for (const Entry& entry : r.contest.entries()) {
    const Role role = entry.role == Role::data ? Role::peer : entry.role;
    const auto error = [&](const Meeting& met) { return error_of_finest(met.contest.of(entry.id)); };
    errors.line(entry.name, heights, each(r.heights, error), role);
    const auto own = [&](const Meeting& met) {
      return std::isfinite(error(met)) ? dip(met.felt.at(entry.id).force) / met.wall.largest : nan;
    };
    dips.line(entry.name, heights, each(r.heights, own), role);
  }
}

/// One figure: a curve of the exact flow and of each model that came so far.
void draw(const Results& r, Curve Felt::*what, double shift, evidence::Panel& panel) {
  const auto line = [&](const std::string& name, const Curve& all, Role role) {
    if (all.size() <= r.wall.first) return;
    const std::span those = std::span(all).subspan(r.wall.first);
    const auto time = [&](std::size_t k) { return interval * (static_cast<double>(r.wall.first + k) + shift); };
    panel.line(name, each(indices(those.size()), time), those, role);
  };
  line("exact", r.wall.felt.*what, Role::exact);
  for (const Entry& entry : r.contest.entries()) {
    // Data's black line is the exact one's.
    line(entry.name, r.felt.at(entry.id).*what, entry.role == Role::data ? Role::peer : entry.role);
  }
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const std::string caption = fmt::format("H/h = {:g}, each model at its finest resolution.", r.amplitude);
  draw(r, &Felt::force, 0.5,
       add_panel(exhibit, "force", "Force on the wall", caption,
                 {.x = "t [sqrt(depth/g)]", .y = "force - 1/2 [rho g depth^2]"}));
  draw(r, &Felt::level, 1,
       add_panel(exhibit, "run-up", "Run-up on the wall", caption,
                 {.x = "t [sqrt(depth/g)]", .y = "level at the wall [depth]"}));
  evidence::Table& table = add_table(exhibit, "force", "Largest force, the dip between two maxima, and the run-up",
                                     "Forces are means over a tenth of sqrt(depth/g), beyond the force at rest.",
                                     {"model", "largest force [1]", "over the exact [1]", "dip [1]", "run-up [depth]",
                                      "rms error of the level over the run-up [1]"});
  const auto row = [&](const std::string& name, const Felt& felt) {
    const double largest = felt.force.empty() ? 0 : std::ranges::max(felt.force);
    table.rows.push_back({name, largest, largest / r.wall.largest, dip(felt.force) / r.wall.largest, highest(felt),
                          error_of_level(felt, r)});
  };
  if (!r.heights.empty()) draw_heights(r, exhibit);
  row("exact", r.wall.felt);
  for (const Entry& entry : r.contest.entries()) row(entry.name, r.felt.at(entry.id));
  r.contest.show(exhibit, {.size = "depth", .error = "largest force", .time = "sqrt(depth/g)"});
}

void wall_force_models(Case& c) {
  c.title = "Model comparison: force and run-up of a solitary wave on a wall";
  c.source =
      "M. J. Cooker, P. D. Weidman, D. S. Bale, Reflection of a high-amplitude solitary wave at a vertical wall, J. "
      "Fluid Mech. 342 (1997) 141";
  c.parameters = {
      real("amplitude", 0.5, "depth", {0.1, 0.6}, "crest above still water"),
      integer("particles", {coarse.particles, 8, 8}, {2, 16},
              "cells of the Gauss-principle particles per depth, finest of three"),
      integer("mesh", {coarse.mesh, 32, 32}, {8, 64}, "rows of the Lagrangian mesh, finest of four"),
      integer("cells", {coarse.cells, 12, 12}, {6, 32}, "rows of Dirichlet cells and variable masses, the finest"),
      integer("markers", {coarse.markers, 64, 64}, {8, 512},
              "nodes or cells of dispersive and plain shallow water per depth, finest"),
      integer("sph", {coarse.sph, 16, 16}, {6, 96}, "SPH particles over the depth, finest of three"),
      toggle("heights", {false, true, true}, "also H/h = 0.1 to 0.6"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wall_force_models
