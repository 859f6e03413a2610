/*
A river reach with friction: choose the depth, $h = (4/g)^{1/3}\left(1 + \tfrac12 e^{-16 (x/L - 1/2)^2}\right)$, the
discharge $q = 2$ m²/s and Manning's $n = 0.033$; the momentum equation then says what the bed must be (MacDonald),

$$z' = \left(\frac{q^2}{g h^3} - 1\right) h' - \frac{n^2 q^2}{h^{10/3}}.$$

Bed, friction and the two ends act together over $L = 1000$ m.

**What is compared.** Depth and discharge after the flow has settled, for several numbers of particles.

**What to look at.** The order away from the ends, and the first particle behind the inlet: the fixed section through
which the water enters is only first-order accurate, and with the ends included it decides the mean error.
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/macdonald.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
namespace particles = shallow_water_particles;

constexpr double discharge = 2;

/// The particles that lie between two places.
Profile inner_part(const Profile& whole, double from, double to) {
  Profile part;
  for (std::size_t i = 0; i < whole.means.size(); ++i) {
    if (whole.edges[i] < from || whole.edges[i + 1] > to) continue;
    if (part.edges.empty()) part.edges.push_back(whole.edges[i]);
    part.edges.push_back(whole.edges[i + 1]);
    part.means.push_back(whole.means[i]);
  }
  return part;
}

void run(Running& run) {
  const double gravity = run.real("gravity");
  const double time = run.real("time");
  const exact::MacDonald channel = exact::MacDonald::smooth_rise(gravity, discharge);
  const double length = channel.length();
  const long n = run.integer("particles");
  std::vector<double> widths;
  std::vector<double> errors;
  std::vector<double> inner_errors;
  Profile finest;
  double mass_defect = 0;
  long steps = 0;
  evidence::Table table{.id = "resolutions",
                        .title = "Refinement",
                        .caption = "Mean errors after the flow has settled.",
                        .columns = {{"N", ""}, {"L1(h)", "m"}, {"L1(h) 100 m off the ends", "m"}, {"L1(q)/q", ""}}};
  for (long k = 0; k < 4; ++k) {
    const auto count = static_cast<std::size_t>(n << k);
    // Starts from a flow of the right discharge and twice the rise of depth: the rise has to be found.
    const auto depth = [&](double x) { return channel.at(x).depth * (1 + 0.1 * std::sin(3.14159 * x / length)); };
    particles::ParticleFlow flow(
        particles::particles_from_profile(particles::equal_width_edges(0, length, count), depth,
                                          [&](double x) { return discharge / depth(x); }),
        {.left = particles::Open{.discharge = [](double) { return discharge; }, .depth = {}},
         .right = particles::Open{.discharge = {}, .depth = [h = channel.at(length).depth](double) { return h; }}},
        {.gravity = gravity, .bed = channel.bed(), .manning = channel.manning()});
    while (flow.time() < time * (1 - 1e-12)) {
      flow.advance(std::min(flow.largest_step().tau, time - flow.time()));
      run.progress((static_cast<double>(k) + flow.time() / time) / 4);
    }
    finest = flow.measured_profile();
    mass_defect = flow.mass_defect();
    steps = flow.steps();
    widths.push_back(length / static_cast<double>(count));
    errors.push_back(shallow_water::cell_error(finest, [&](double x) { return channel.at(x); }).depth.l1);
    inner_errors.push_back(shallow_water::cell_error(inner_part(finest, 100, length - 100), [&](double x) {
                             return channel.at(x);
                           }).depth.l1);
    double spread = 0;
    for (const State& s : finest.means)
      spread += std::abs(s.depth * s.velocity / discharge - 1) / static_cast<double>(finest.means.size());
    table.rows.push_back({static_cast<double>(count), errors.back(), inner_errors.back(), spread});
    run.record.measure("relative_discharge_error", spread);
  }
  run.record.table(std::move(table));
  run.record.measure("cell_l1_h", errors.back());
  run.record.measure("cell_l1_h_inner", inner_errors.back());
  run.record.measure("order_with_ends", evidence::observed_order(widths, errors).order);
  run.record.measure("mass_defect", mass_defect);
  run.record.check(
      {.id = "order",
       .text = "Away from the ends the depth converges at second order with bed and friction.",
       .quantity = "observed order of cell L1(h), 100 m off the ends",
       .source = "MacDonald et al. (1997)"},
      evidence::observed_order(widths, inner_errors),
      evidence::Order{
          2, 0.5, "second order; particles enter at their own rhythm, which scatters single errors by a few tenths"});
  run.record.check(
      {.id = "mass",
       .text = "Mass is what it was, plus inflow, less outflow.",
       .quantity = "mass less the booked mass",
       .unit = "m^2",
       .source = "conservation law of mass"},
      {.value = mass_defect, .resolution = fmt::format("N = {}", n << 3)},
      evidence::Roundoff{.operations = static_cast<double>(steps),
                         .scale = 2 * discharge * time + length,
                         .reason = "every step books what enters and leaves; of the size of all that passed"});
  std::vector<double> x;
  std::vector<double> surface;
  std::vector<double> bed;
  for (int k = 0; k <= 400; ++k) {
    x.push_back(length * k / 400);
    bed.push_back(channel.elevation(x.back()));
    surface.push_back(bed.back() + channel.at(x.back()).depth);
  }
  const Means means = means_of(finest);
  std::vector<double> level;
  for (std::size_t i = 0; i < means.centre.size(); ++i)
    level.push_back(means.depth[i] + channel.elevation(means.centre[i]));
  auto& figure = run.record.figure("profile", "A river reach with friction", "Bed and surface; depth.");
  auto& top = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  top.fill("water", x, surface, Role::water);
  top.fill("bed", x, bed, Role::bed);
  top.points("particles", means.centre, level, Role::computed);
  std::vector<double> exact;
  for (const double at : x) exact.push_back(channel.at(at).depth);
  auto& bottom = figure.panel({.x = "x [m]", .y = "depth h [m]"});
  bottom.line("exact", x, exact, Role::exact);
  bottom.points("particles", means.centre, means.depth, Role::computed);
}

}  // namespace

Case macdonald_channel() {
  Case c;
  c.title = "A river reach with friction";
  c.source =
      "I. MacDonald et al., Analytic benchmark solutions for open-channel flows, J. Hydraul. Eng. 123 (1997) 1041";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("particles", {25, 50, 100}, {8, 1e4}, "coarsest number of particles; 2, 4 and 8 times as many run too"),
      real("time", {1000, 3000, 6000}, "s", {1, 1e6}, "time in which the flow settles"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
