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
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/macdonald.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "validation/case/case.hpp"
#include "validation/steady_flow/open_ends.hpp"
#include "validation/studies/shallow_water/profile_curves.hpp"

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

constexpr std::array<long, 4> refinements{1, 2, 4, 8};

/// A flow that has settled, at one resolution.
struct Settled {
  Profile profile;
  double error = 0;            ///< mean of the depth [m]
  double inner_error = 0;      ///< the same 100 m off the ends [m]
  double discharge_error = 0;  ///< mean, relative
  double mass_defect = 0;
};

struct Results {
  std::vector<double> widths;
  std::vector<Settled> settled;

  [[nodiscard]] const Settled& finest() const { return settled.back(); }
  [[nodiscard]] evidence::ObservedOrder order(double Settled::*error) const {
    std::vector<double> errors;
    for (const Settled& s : settled) errors.push_back(s.*error);
    return evidence::observed_order(widths, errors);
  }
};

exact::MacDonald channel_of(const Values& values) {
  return exact::MacDonald::smooth_rise(values.real("gravity"), discharge);
}

Settled settle(const exact::MacDonald& channel, const Values& values, std::size_t count,
               const Run::Progress& progress) {
  const double length = channel.length();
  const double time = values.real("time");
  // Starts from a flow of the right discharge and twice the rise of depth: the rise has to be found.
  const auto depth = [&](double x) { return channel.at(x).depth * (1 + 0.1 * std::sin(3.14159 * x / length)); };
  particles::ParticleFlow flow(
      particles::particles_from_profile(particles::equal_width_edges(0, length, count), depth,
                                        [&](double x) { return discharge / depth(x); }),
      {.left = particles::Open{.discharge = [](double) { return discharge; }, .depth = {}},
       .right = particles::Open{.discharge = {}, .depth = [h = channel.at(length).depth](double) { return h; }}},
      {.gravity = values.real("gravity"), .bed = channel.bed(), .manning = channel.manning()});
  while (flow.time() < time * (1 - 1e-12)) {
    flow.advance(std::min(flow.largest_step().tau, time - flow.time()));
    progress(flow.time() / time);
  }
  const auto exact = [&](double x) { return channel.at(x); };
  Settled settled{.profile = flow.measured_profile(), .mass_defect = flow.mass_defect()};
  settled.error = shallow_water::cell_error(settled.profile, exact).depth.l1;
  settled.inner_error = shallow_water::cell_error(inner_part(settled.profile, 100, length - 100), exact).depth.l1;
  for (const State& s : settled.profile.means) {
    settled.discharge_error +=
        std::abs(s.depth * s.velocity / discharge - 1) / static_cast<double>(settled.profile.means.size());
  }
  return settled;
}

void claims(const Values& values, const Claims<Results>& claims) {
  const exact::MacDonald channel = channel_of(values);
  const long finest = refinements.back() * values.integer("particles");
  claims.check(
      {.id = "order",
       .text = "Away from the ends the depth converges at second order with bed and friction.",
       .quantity = "observed order of cell L1(h), 100 m off the ends",
       .source = "MacDonald et al. (1997)"},
      [](const Results& r) { return r.order(&Settled::inner_error); },
      evidence::Order{
          2, 0.5, "second order; particles enter at their own rhythm, which scatters single errors by a few tenths"});
  const State inflow = channel.at(0);
  claims.at(fmt::format("N = {}", finest))
      .check(
          {.id = "mass",
           .text = "Mass is what it was, plus inflow, less outflow.",
           .quantity = "mass less the booked mass",
           .unit = "m^2",
           .source = "conservation law of mass"},
          [](const Results& r) { return r.finest().mass_defect; },
          open_ends_roundoff({.length = channel.length(),
                              .depth = channel.at(channel.length()).depth,
                              .discharge = discharge,
                              .celerity = std::sqrt(values.real("gravity") * inflow.depth)},
                             finest, values.real("time")));
}

Results compute(const Run& run) {
  const exact::MacDonald channel = channel_of(run);
  Results r;
  for (std::size_t k = 0; k < refinements.size(); ++k) {
    const long count = refinements[k] * run.integer("particles");
    r.widths.push_back(channel.length() / static_cast<double>(count));
    r.settled.push_back(settle(channel, run, static_cast<std::size_t>(count), [&](double done) {
      run.progress((static_cast<double>(k) + done) / static_cast<double>(refinements.size()));
    }));
  }
  return r;
}

void draw(evidence::Exhibit& exhibit, const exact::MacDonald& channel, const Means& means) {
  std::vector<double> x;
  std::vector<double> surface;
  std::vector<double> bed;
  std::vector<double> exact;
  for (int k = 0; k <= 400; ++k) {
    x.push_back(channel.length() * k / 400);
    bed.push_back(channel.elevation(x.back()));
    exact.push_back(channel.at(x.back()).depth);
    surface.push_back(bed.back() + exact.back());
  }
  std::vector<double> level;
  for (std::size_t i = 0; i < means.centre.size(); ++i) {
    level.push_back(means.depth[i] + channel.elevation(means.centre[i]));
  }
  auto& figure = exhibit.figure("profile", "A river reach with friction", "Bed and surface; depth.");
  auto& top = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  top.fill("water", x, surface, Role::water);
  top.fill("bed", x, bed, Role::bed);
  top.points("particles", means.centre, level, Role::computed);
  auto& bottom = figure.panel({.x = "x [m]", .y = "depth h [m]"});
  bottom.line("exact", x, exact, Role::exact);
  bottom.points("particles", means.centre, means.depth, Role::computed);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  evidence::Table table{.id = "resolutions",
                        .title = "Refinement",
                        .caption = "Mean errors after the flow has settled.",
                        .columns = {{"N", ""}, {"L1(h)", "m"}, {"L1(h) 100 m off the ends", "m"}, {"L1(q)/q", ""}}};
  for (std::size_t k = 0; k < r.settled.size(); ++k) {
    const Settled& s = r.settled[k];
    table.rows.push_back(
        {static_cast<double>(refinements[k] * values.integer("particles")), s.error, s.inner_error, s.discharge_error});
  }
  exhibit.table(std::move(table));
  exhibit.measure("relative_discharge_error", r.finest().discharge_error);
  exhibit.measure("cell_l1_h", r.finest().error);
  exhibit.measure("cell_l1_h_inner", r.finest().inner_error);
  exhibit.measure("order_with_ends", r.order(&Settled::error).order);
  exhibit.measure("mass_defect", r.finest().mass_defect);
  draw(exhibit, channel_of(values), means_of(r.finest().profile));
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
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
