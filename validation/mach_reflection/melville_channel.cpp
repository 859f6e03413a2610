/*
The early stage of Mach reflection, in the geometry of Melville's (1980) experiment: a solitary wave runs along a
channel into a wall that turns by the angle $\psi$. Melville measured stem amplitudes below twice the incident one and
doubted Miles's (1977) theory, which predicts up to four times. Frank (1994, section 4.3) replied that the stem in the
tank is in its early growth. Lengths are over the depth, times over $\sqrt{\text{depth}/g}$.

**Set-up.** A channel 34 wide. Its wall $y = 0$ turns inwards at $x = 45$. The wave, $a = 0.1$, starts with its crest at
$x = 20$. The mesh follows the wall: equal columns, each with equal rows from wall to wall. The column at the bend is
fixed, because the flow stagnates there. Steps are half the spacing `h`.

**What is compared.** The crest amplitude at the turned wall as a function of the distance from the bend, over the crest
amplitude at the other wall when it passes the bend. Water columns and two layers of hexahedra. The limits for infinite
time: theory for finite angles.

**What to look at.** At 20 degrees theory predicts a stem of 2.9 times the incident wave. After $x/h = 40$, longer than
the tank, the amplification has covered a third of the way from 1 to that value. At 35 degrees reflection is finally
regular, with 2.26 at the wall; it too stays below 2 up to $x/h = 30$. Neither curve indicates an approach to a limit.
The stem of the hexahedra is 1 % lower.
*/
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/fine_limit.hpp"
#include "validation/instruments/plan/oblique_wave.hpp"
#include "validation/instruments/plan/row_crests.hpp"
#include "validation/mach_reflection/reflection_run.hpp"
#include "validation/mach_reflection/surface_part.hpp"

namespace seiche::validation::cases::melville_channel {

using dispersive_shallow_water_2d::Flow;
using dispersive_shallow_water_2d::Lattice;

const std::string source = "Melville (1980); Frank (1994), section 4.3";
constexpr double width = 34;                               // of the channel
constexpr double start = 20;                               // of the crest
constexpr double bend = 45;                                // of the wall
constexpr double farthest = 43;                            // along the turned wall
constexpr double tank = 30;                                // how far from the bend Melville measured
constexpr std::size_t layers = 2;                          // of hexahedra
const std::vector<double> factors{1.0, 1.4, 2.0};          // spacings of columns over h
const std::vector<double> layered_factors{1.4, 1.7, 2.0};  // and of hexahedra

struct Channel {
  double amplitude;
  double angle;  ///< [rad]
  double spacing;
  WaveModel model = WaveModel::plan;

  [[nodiscard]] double wall(double x) const { return x > bend ? (x - bend) * std::tan(angle) : 0; }
  /// Room ahead of the crest at the end of the run, but never so much that the channel closes.
  [[nodiscard]] double end() const {
    const double closes = bend + 0.93 * width / std::tan(angle);
    return std::min(bend + farthest * std::cos(angle) + 20, closes);
  }
};

/// The bend falls on a column.
Lattice lattice_of(const Channel& channel, const ObliqueWave& wave) {
  const double h = bend / std::ceil(bend / channel.spacing);
  Lattice lattice;
  lattice.shape = {.columns = static_cast<std::size_t>(std::floor(channel.end() / h)),
                   .rows = static_cast<std::size_t>(std::lround(width / channel.spacing))};
  for (std::size_t j = 0; j <= lattice.shape.rows; ++j) {
    for (std::size_t i = 0; i <= lattice.shape.columns; ++i) {
      const double x = h * static_cast<double>(i);
      const double share = static_cast<double>(j) / static_cast<double>(lattice.shape.rows);
      lattice.x.push_back(x);
      lattice.y.push_back(std::lerp(channel.wall(x), width, share));
      lattice.z.push_back(wave.elevation(x, lattice.y.back(), 0));
    }
  }
  return lattice;
}

/// The same water in two layers of hexahedra, with velocities as in layered_reflection_flow.
lagrangian_mesh_3d::Flow layered_flow(const Channel& channel, const ObliqueWave& wave) {
  const Lattice lattice = lattice_of(channel, wave);
  const lagrangian_mesh_3d::Layer layer{.begin = 0,
                                        .end = lattice.x[lattice.shape.columns],
                                        .north = width,
                                        .columns = lattice.shape.columns,
                                        .rows = lattice.shape.rows,
                                        .layers = layers,
                                        .elevation = [&](double x, double y) { return wave.elevation(x, y, 0); },
                                        .south_wall = [&](double x) { return channel.wall(x); }};
  const auto velocity = [&](plan_lattice::Place at) {
    const auto top = wave.velocity(at.x, at.y, 0);
    const double share = (1 + at.z) / (1 + wave.elevation(at.x, at.y, 0));
    return lagrangian_mesh_3d::Vector{top.u, top.v, share * top.w};
  };
  return lagrangian_mesh_3d::Flow(layer_mesh(layer), velocity, {}, {.tolerance = 1e-6});
}

/// The stem along the turned wall.
struct Growth {
  Channel channel;
  std::optional<double> incident = {};  ///< height of the crest on the other wall as it passes the bend
  std::vector<double> distance, ratio;
  SurfacePart surface;  ///< at the end

  [[nodiscard]] double at(double place) const {
    if (!(place > distance.front() && place <= distance.back())) {
      throw std::runtime_error(fmt::format("the stem was followed from {:g} to {:g} h from the bend, not to {:g}",
                                           distance.front(), distance.back(), place));
    }
    return linear_at({distance, ratio}, place);
  }
};

template <class Flow>
Growth grow(const Channel& channel, Flow flow) {
  Growth growth{.channel = channel};
  double distance = 0;
  while (distance < farthest) {
    flow.advance(0.5 * channel.spacing);
    const SurfaceLattice surface = surface_of(flow);
    const std::vector<Crest> other = row_crests(surface, surface.rows, 0.5 * channel.amplitude);
    if (other.empty()) throw std::runtime_error("the wave has left the channel");
    if (!growth.incident && other.front().x >= bend) {
      growth.incident = five_node_height(surface, other.front(), surface.rows);
    }
    const Crest crest = wall_crest(surface, 0.5 * channel.amplitude);
    distance = (crest.x - bend) / std::cos(channel.angle);
    if (distance <= 1 || !growth.incident) continue;
    growth.distance.push_back(distance);
    growth.ratio.push_back(five_node_height(surface, crest, 0) / *growth.incident);
    if (distance >= farthest) growth.surface = part_of(surface, {10, channel.end(), width + 1});
  }
  return growth;
}

Growth grow(const Channel& channel) {
  const ObliqueWave wave(channel.amplitude, 0, start);
  if (channel.model == WaveModel::hexahedra) return grow(channel, layered_flow(channel, wave));
  const auto velocity = [&](double x, double y) { return wave.velocity(x, y, 0); };
  return grow(channel, Flow(lattice_of(channel, wave), velocity, {}, {.tolerance = 1e-7}));
}

/// One angle and one model on several lattices, the finest first.
using Ladder = std::vector<Growth>;

/// Columns of water at both angles, then hexahedra.
using Results = std::vector<Ladder>;

std::vector<double> angles_of(const Values& values) {
  const std::vector<double> angles{values.real("angle"), values.real("second_angle")};
  if (angles[0] == angles[1]) throw std::invalid_argument("second_angle must differ from angle");
  return angles;
}

Measurement ratio_at(const Ladder& ladder, double distance) {
  const std::vector<double> sizes = each(ladder, [](const Growth& growth) { return growth.channel.spacing; });
  const std::vector<double> values = each(ladder, [&](const Growth& growth) { return growth.at(distance); });
  return {.value = values.front(), .uncertainty = fine_limit(sizes, values).uncertainty};
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<double> angles = angles_of(values);
  const double h = values.real("h");
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double angle = angles[k];
    claims.at(fmt::format("h = {:g}, tau = {:g}", h, 0.5 * h))
        .entry(k)
        .check(
            "early-" + id_of(angle),
            fmt::format("The stem amplitude at {:g} deg within {:g} h of the bend stays between 1 and 2 times the "
                        "incident amplitude.",
                        angle, tank),
            "a_w/a_i there", [](const Ladder& ladder) { return ratio_at(ladder, tank); },
            Bound{.limit = 0.5, .reason = "between 1 and 2: measured by Melville", .expected = 1.5});
    claims.check(
        "models-" + id_of(angle),
        fmt::format("The stem growth at {:g} deg, {:g} h from the bend, agrees between hexahedra and columns.", angle,
                    tank),
        "a_w/a_i - 1 there over the same of the columns, minus 1",
        [columns = k, hexahedra = angles.size() + k](const Results& r) -> Measurement {
          const Measurement plain = ratio_at(r.at(columns), tank);
          const Measurement layered = ratio_at(r.at(hexahedra), tank);
          return {.value = (layered.value - 1) / (plain.value - 1) - 1,
                  .uncertainty = std::hypot(plain.half_width(), layered.half_width()) / (plain.value - 1)};
        },
        Bound{.limit = values.real("amplitude"),
              .reason = "the two differ by terms of the order of the amplitude over the depth"});
  }
}

Results compute(const Run& run) {
  const std::vector<double> angles = angles_of(run);
  Results all;
  struct Task {
    Channel channel;
    Growth* result;
  };
  std::vector<Task> tasks;
  for (const WaveModel model : {WaveModel::plan, WaveModel::hexahedra}) {
    const std::vector<double>& sizes = model == WaveModel::plan ? factors : layered_factors;
    for (const double angle : angles) {
      Ladder& ladder = all.emplace_back(sizes.size());
      Channel channel{.amplitude = run.real("amplitude"), .angle = radians(angle), .model = model};
      for (std::size_t rung = 0; rung < sizes.size(); ++rung) {
        channel.spacing = sizes[rung] * run.real("h");
        tasks.push_back({channel, &ladder[rung]});
      }
    }
  }
  on_threads(run, tasks.size(), [&](std::size_t k) { *tasks[k].result = grow(tasks[k].channel); });
  return all;
}

void show(const Results& all, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const ReflectionRun example{.amplitude = all.front().front().channel.amplitude, .angle = radians(20)};
  auto& figure =
      exhibit.figure("growth", "Stem in a channel with a turned wall",
                     fmt::format("a = {:g}, h = {:g}. Thin: limit of the theory for small waves and finite angles.",
                                 example.amplitude, all.front().front().channel.spacing),
                     {"frank-melville"});
  auto& panel =
      figure.panel({.x = "distance from the bend along the wall [depth]", .y = "a_w/a_i", .y_min = 1, .y_max = 4});
  auto& map =
      exhibit.figure("surface", "The channel from above", "When the crest on the turned wall is 43 h from the bend.");
  for (const Ladder& ladder : all) {
    const Growth& finest = ladder.front();
    const double angle = degrees(finest.channel.angle);
    const bool layered = finest.channel.model == WaveModel::hexahedra;
    exhibit.measure(fmt::format("a_i_{:g}{}", angle, layered ? "_hexahedra" : ""), finest.incident.value());
    if (layered) {
      panel.line(fmt::format("{:g} deg, hexahedra", angle), finest.distance, finest.ratio, Role::peer);
      continue;
    }
    panel.line(fmt::format("{:g} deg", angle), finest.distance, finest.ratio);
    panel.line(fmt::format("{:g} deg, h = {:g}", angle, ladder.back().channel.spacing), ladder.back().distance,
               ladder.back().ratio, Role::peer);
    const exact::MachReflection theory(finest.channel.amplitude, finest.channel.angle,
                                       exact::MachReflection::Theory::kodama_yeh);
    panel.line("after infinite time", std::vector{0.0, farthest}, std::vector(2, theory.wall_ratio()), Role::guide);
    map.panel({.x = "x [depth]", .y = "y [depth]", .z = "elevation [depth]", .title = fmt::format("{:g} deg", angle)})
        .plan("elevation", finest.surface.lattice());
  }
}

void melville_channel(Case& c) {
  c.title = "Early growth of a Mach stem in a channel with a turned wall";
  c.source = "W. K. Melville, On the Mach reflexion of a solitary wave, J. Fluid Mech. 98 (1980) 285; " +
             literature::frank + ", section 4.3";
  c.parameters = {
      real("amplitude", 0.1, "depth", {0.05, 0.4}, "of the wave"),
      real("angle", 20.0, "deg", {10, 40}, "angle by which the wall turns"),
      real("second_angle", 35.0, "deg", {10, 40}, "the same in a second channel"),
      real("h", {0.6, 0.4, 0.4}, "depth", {0.1, 0.7},
           "initial grid spacing; also 1.4 and 2 times that; finer ones than 0.4 may tangle at the bend"),
  };
  c.published = {{.tiles = {"frank-melville"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::melville_channel
