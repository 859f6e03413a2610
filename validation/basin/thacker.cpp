/*
Water oscillates in a parabolic basin without breaking (Thacker 1981): its surface stays plane, and every water particle
has the same displacement,

$$z = h_0\left(\frac{(x - L/2)^2}{a^2} - 1\right), \qquad \xi(t) = -b \cos\omega t, \qquad \omega = \frac{\sqrt{2 g
h_0}}{a}.$$

Both shorelines move over the dry bed with the velocity of the water behind them. For particles the edges have an exact
solution: $X_k(t) = X_k(0) + \xi(t) - \xi(0)$.

**What is compared.** Both shorelines and all particle edges with the exact motion, over several periods; beside them a
fixed-grid scheme with hydrostatic reconstruction, whose shoreline is the last cell with a depth above $h_0/1000$.

**What to look at.** The particle method tracks the shoreline itself; no depth threshold is needed.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/thacker.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"

namespace seiche::validation::cases::thacker {

namespace particles = shallow_water_particles;

constexpr double pi = std::numbers::pi;

/// Shorelines over time, and the state at the end.
struct Motion {
  std::vector<double> time, left, right;
  Worst edge_error;      ///< at the end, particles only [m]
  Worst velocity_error;  ///< at the end, particles only [m/s]
  double mass_defect = 0;
  std::vector<double> edges, depth;
};

/// Steps to the end, after each of which the shorelines are noted. @param step  the longest of the flow
template <class Flow, class Step, class Shorelines>
void run_to(double end, Flow& flow, Motion& motion, Step step, Shorelines shorelines, const Run& run) {
  const auto note = [&] {
    const auto [left, right] = shorelines();
    motion.time.push_back(flow.time());
    motion.left.push_back(left);
    motion.right.push_back(right);
  };
  note();
  while (flow.time() < end * (1 - 1e-12)) {
    flow.advance(std::min(step(), end - flow.time()));
    note();
    run.progress(flow.time() / end);
  }
  motion.mass_defect = flow.mass_defect();
}

Motion by_particles(const exact::Thacker& bowl, double end, particles::Level level, const Run& run) {
  const auto depth = [&](double x) { return bowl.at(x, 0).depth; };
  particles::ParticleFlow flow(
      particles::particles_from_profile(
          particles::equal_width_edges(bowl.left_shoreline(0), bowl.right_shoreline(0), run.count("particles")), depth,
          [](double) { return 0.0; }),
      {.left = particles::Vacuum{}, .right = particles::Vacuum{}}, {.gravity = run.real("gravity"), .bed = bowl.bed()},
      {.level = level});
  const particles::Array start = flow.particles().edge;
  Motion motion;
  run_to(
      end, flow, motion, [&] { return flow.largest_step().tau; },
      [&] { return std::pair(flow.particles().edge.front(), flow.particles().edge.back()); }, run);
  const auto& now = flow.particles();
  for (std::size_t k = 0; k < start.size(); ++k) {
    motion.edge_error.add(now.edge[k] - bowl.carried(start[k], end), start[k]);
  }
  for (const double u : now.velocity) motion.velocity_error.add(u - bowl.velocity(end));
  motion.edges.assign(now.edge.begin(), now.edge.end());
  for (std::size_t i = 0; i < now.size(); ++i) motion.depth.push_back(now.depth(i));
  return motion;
}

/// From the first to the last cell that is deeper than this; NaN if there is none, or if a depth is not a number.
std::pair<double, double> wet_stretch(std::span<const double> edges, std::span<const double> depth, double wet_depth) {
  std::pair<double, double> stretch{nan, nan};
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (std::isnan(depth[i])) return {nan, nan};
    if (depth[i] <= wet_depth) continue;
    if (std::isnan(stretch.first)) stretch.first = edges[i];
    stretch.second = edges[i + 1];
  }
  return stretch;
}

/// The channel is a little longer than the water ever reaches.
double channel_length(const Values& values) {
  return 2 * (values.real("radius") + values.real("displacement")) * 1.25;
}

Motion by_cells(const exact::Thacker& bowl, double end, const Run& run) {
  const double length = channel_length(run);
  const std::vector<double> edges = evenly(0, length, static_cast<int>(run.integer("particles")) + 1);
  const std::vector<double> depth =
      each(validation::cell_averages(bowl, edges, 0), [&](const validation::CellMean& mean) { return mean.depth; });
  shallow_water_finite_volume::FiniteVolumeFlow::Settings settings;
  settings.gravity = run.real("gravity");
  shallow_water_finite_volume::FiniteVolumeFlow flow(settings, 0, length, depth, std::vector<double>(depth.size()),
                                                     bowl.bed());
  Motion motion;
  run_to(
      end, flow, motion, [&] { return 0.4 / flow.courant_number(1.0); },
      [&] { return wet_stretch(edges, flow.depth(), 1e-3 * run.real("depth")); }, run);
  motion.edges = edges;
  motion.depth.assign(flow.depth().begin(), flow.depth().end());
  return motion;
}

exact::Thacker bowl_of(const Values& values) {
  return {values.real("gravity"), values.real("radius"), values.real("depth"), channel_length(values),
          values.real("displacement")};
}

double end_of(const Values& values) {
  return values.real("periods") * bowl_of(values).period();
}

struct Shoreline {
  std::string side;
  std::vector<double> Motion::*computed;
  double (exact::Thacker::*exact)(double t) const;

  [[nodiscard]] Worst error(const Motion& motion, const exact::Thacker& bowl) const {
    Worst distance;
    for (std::size_t k = 0; k < motion.time.size(); ++k) {
      distance.add((motion.*computed)[k] - (bowl.*exact)(motion.time[k]), motion.time[k]);
    }
    return distance;
  }
};

const std::array shorelines{Shoreline{"left", &Motion::left, &exact::Thacker::left_shoreline},
                            Shoreline{"right", &Motion::right, &exact::Thacker::right_shoreline}};

void claims(const Values& values, const Claims<Motion>& claims) {
  const exact::Thacker bowl = bowl_of(values);
  const std::string& scheme = values.text("scheme");
  const double displacement = values.real("displacement");
  const long n = values.integer("particles");
  // Particles share the water, cells the whole bowl.
  const double length = scheme == "muscl" ? channel_length(values) : 2 * values.real("radius");
  const double cell = length / values.number("particles");
  const auto at = claims.at(fmt::format("{}, N = {}", scheme, n));
  // The deepest water at its fastest, at a tenth of the Courant number 0.4.
  const double fastest =
      std::sqrt(values.real("gravity") * values.real("depth")) + bowl.angular_frequency() * displacement;
  const double most_steps = end_of(values) * fastest / (0.04 * cell);
  at.check(
      "mass", "The water volume is conserved to round-off at the moving shorelines.", "change of mass [m^2]",
      [](const Motion& motion) -> Measurement {
        const auto updates = static_cast<double>(motion.depth.size() * motion.time.size());
        return {.value = motion.mass_defect, .told = {.operations = updates}};
      },
      Roundoff{.operations = Amount::told_by_run(static_cast<double>(n) * most_steps),
               .scale = bowl.area() / static_cast<double>(n),
               .reason = "one rounded update of every cell and step, of the size of its share of the water"});
  // A half-wave across the water, by differences of second order: omega is off by the part (k w)^2/24, k = pi/(2 a).
  const double periods = values.real("periods") < 1 ? 1 : values.real("periods");
  const double phase = 2 * pi * periods * std::pow(0.5 * pi * cell / values.real("radius"), 2) / 24;
  const bool first_order = scheme == "muscl" || scheme == "G1";
  for (const Shoreline& shoreline : shorelines) {
    at.where("t = {:g} s")
        .from("Thacker (1981)")
        .check(
            fmt::format("shoreline-{}", shoreline.side),
            fmt::format("The {} shoreline follows the exact one at all times.", shoreline.side), "largest distance [m]",
            [shoreline, bowl](const Motion& motion) { return shoreline.error(motion, bowl); },
            Bound{.limit = first_order ? 4 * cell : phase * displacement,
                  .reason = "second order: the displacement by the phase error (k w)^2/24 of a half-wave across the "
                            "water, over all periods; fixed-grid and first-order schemes: four cells"});
  }
}

Motion compute(const Run& run) {
  const std::string& scheme = run.text("scheme");
  if (scheme == "muscl") return by_cells(bowl_of(run), end_of(run), run);
  const particles::Level level = scheme == "G1"   ? particles::Level::godunov
                                 : scheme == "M2" ? particles::Level::muscl
                                                  : particles::Level::hand_over;
  return by_particles(bowl_of(run), end_of(run), level, run);
}

void draw_shorelines(evidence::Exhibit& exhibit, const Motion& motion, const exact::Thacker& bowl,
                     const std::string& scheme, Role role) {
  auto& panel = add_panel(exhibit, "shorelines", "The two shorelines", "Against time, with the exact motion.",
                          {.x = "t [s]", .y = "x [m]"});
  for (const Shoreline& shoreline : shorelines) {
    panel.line(shoreline.side == "left" ? "exact" : "", motion.time,
               each(motion.time, [&](const double t) { return (bowl.*shoreline.exact)(t); }), Role::exact);
  }
  for (const Shoreline& shoreline : shorelines) {
    panel.points(shoreline.side == "left" ? scheme : "", motion.time, motion.*shoreline.computed, role);
  }
}

void draw_bowl(evidence::Exhibit& exhibit, const Motion& motion, const exact::Thacker& bowl, const Values& values,
               Role role) {
  const std::vector<double> x = evenly(0, channel_length(values), 201);
  const auto bed = [&](double at) { return bowl.elevation(at); };
  const auto surface = [&](double at) { return bowl.at(at, end_of(values)).depth + bed(at); };
  auto& panel = add_panel(exhibit, "bowl", "The bowl at the end", "Bed, exact water, and the computed mean surface.",
                          {.x = "x [m]", .y = "elevation [m]"});
  panel.fill("water", x, each(x, surface), Role::water);
  panel.fill("bed", x, each(x, bed), Role::bed);
  std::vector<double> centre, level;
  const Bed bowl_bed = bowl.bed();
  for (std::size_t i = 0; i < motion.depth.size(); ++i) {
    if (motion.depth[i] <= 1e-3 * values.real("depth")) continue;
    const double a = motion.edges[i];
    const double b = motion.edges[i + 1];
    centre.push_back(0.5 * (a + b));
    level.push_back(motion.depth[i] + (bowl_bed.primitive(b) - bowl_bed.primitive(a)) / (b - a));
  }
  panel.points(values.text("scheme"), centre, level, role);
}

void show(const Motion& motion, const Values& values, evidence::Exhibit& exhibit) {
  const exact::Thacker bowl = bowl_of(values);
  exhibit.measure("edge_error", motion.edge_error.value());
  exhibit.measure("velocity_error", motion.velocity_error.value());
  exhibit.measure("period", bowl.period());
  exhibit.measure("angular_frequency", bowl.angular_frequency());
  const Role role = values.text("scheme") == "muscl" ? Role::peer : Role::computed;
  draw_shorelines(exhibit, motion, bowl, values.text("scheme"), role);
  draw_bowl(exhibit, motion, bowl, values, role);
}

/// Gauges in the middle and half-way to either shoreline at rest, and the shorelines as series.
std::vector<WantedTable> wanted(const Values& values) {
  const exact::Thacker bowl = bowl_of(values);
  const double middle = channel_length(values) / 2;
  const double radius = values.real("radius");
  const double period = bowl.period();
  const std::vector<double> times = evenly(0, values.real("periods") * period, 101);
  const auto points = [times](double) { return times; };
  const std::string source = "Thacker (1981)";
  const auto shoreline = [&](const Column& column, const auto& reference) {
    Mean position;
    for (const double t : times) position.add(reference({0, t}));
    return WantedQuantity{
        .column = column,
        .reference = reference,
        .requirements = {
            {.measure = Measure::relative_l2,
             .criterion = Bound{.limit = 2 * radius / 50 / position.rms(),
                                .reason = "a cell of a grid of fifty across the water, in the root mean square"},
             .text = fmt::format("Position of the {} agrees with the exact motion.", column.meaning),
             .source = source}}};
  };
  return {
      {.name = "shorelines",
       .kind = WantedTable::Kind::series,
       .abscissa = Column{"t", "s", "time"},
       .quantities = {shoreline({"left", "m", "left shoreline"},
                                [bowl](Place p) { return bowl.left_shoreline(p.abscissa); }),
                      shoreline({"right", "m", "right shoreline"},
                                [bowl](Place p) { return bowl.right_shoreline(p.abscissa); })},
       .points = points},
      {.name = "gauges",
       .kind = WantedTable::Kind::series,
       .group = Column{"x", "m", "position of the gauge"},
       .abscissa = Column{"t", "s", "time"},
       .quantities = {{.column = {"h", "m", "depth"},
                       .reference = [bowl](Place p) { return bowl.at(p.group, p.abscissa).depth; },
                       .requirements =
                           {{.measure = Measure::shift,
                             .criterion = Bound{.limit = period / 50, .reason = "2 % of the period"},
                             .text =
                                 "The phase of the oscillation agrees with the exact motion within 2 % of the period.",
                             .source = source},
                            within_tolerance(Measure::relative_l2, values,
                                             "Depth at the gauge agrees with the exact motion.", source)}}},
       .groups = {middle - radius / 2, middle, middle + radius / 2},
       .points = points,
       .exact = {fmt::format("seiche exact thacker --set "
                             "radius={},depth={},displacement={},gravity={},length={} --grid "
                             "x={}:{}:3,t=0:{}:{}",
                             radius, values.real("depth"), values.real("displacement"), values.real("gravity"),
                             channel_length(values), middle - radius / 2, middle + radius / 2, times.back(),
                             times.size())}}};
}

void thacker(Case& c) {
  c.title = "Oscillation of water in a parabolic basin";
  c.source =
      "W. C. Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981) "
      "499";
  c.parameters = {
      real("radius", 1.0, "m", {1e-3, 1e6}, "half-width of the water"),
      real("depth", 0.5, "m", {1e-3, 1e6}, "depth of the bowl"),
      real("displacement", 0.5, "m", {1e-6, 1e6}, "amplitude of the motion"),
      integer("particles", {100, 400, 1600}, {8, 1e5}, "particles in the water; cells over the whole bowl for muscl"),
      real("periods", 3.0, "1", {0.01, 1000}, "length of the run in periods"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      choice("scheme", "H2", {"G1", "M2", "H2", "muscl"}, "level of the particle method, or the comparison scheme"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show, "conservation law of mass");
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::thacker
