/*
Water flows over a parabolic bump, $z = 0.2 - 0.05 (x - 10)^2$ on $8 < x < 12$ m, in a channel of 25 m, until nothing
changes any more. Bernoulli's law gives the depth,

$$\frac{q^2}{2 g h^2} + h + z = E,$$

in three regimes: subcritical ($q = 4.42$ m²/s, depth 2 m at the outflow), transcritical without a jump (1.53) and with
one (0.18, 0.33 m).

The ends are fixed sections: the water comes in at $q$ and goes out at the given depth (or freely, where it leaves
supercritical), so particles are born at one end and leave at the other.

**What is compared.** Depth, and the discharge, which a steady state has the same everywhere; the fixed-grid peer with
hydrostatic reconstruction beside it.

**What to look at.** The discharge: it shows what the depth hides.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "seiche/exact/steady_bump.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "validation/case/case.hpp"
#include "validation/steady_flow/open_ends.hpp"
#include "validation/studies/shallow_water/profile_curves.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
namespace particles = shallow_water_particles;

/// A regime: its exact solution, discharge, and the depth given at the outflow (none where it is supercritical).
struct Regime {
  exact::SteadyBump flow;
  std::optional<double> outflow_depth;
  double start_level;  ///< surface at t = 0, upstream of the crest at least [m]
  std::optional<double> start_depth_downstream;

  /// Depth at t = 0. A supercritical outflow gives nothing to the flow that could pull it down: it has to start so.
  [[nodiscard]] double start_depth(double x) const {
    if (start_depth_downstream && x > flow.bump().crest) return *start_depth_downstream;
    return start_level - flow.elevation(x);
  }
};

Regime regime_from(const std::string& name, double gravity) {
  if (name == "subcritical") return {exact::SteadyBump(gravity, 4.42, 2.0), 2.0, 2.0, {}};
  if (name == "transcritical") {
    const exact::SteadyBump flow = exact::SteadyBump::transcritical(gravity, 1.53);
    return {flow, {}, flow.at(0).depth, 0.8 * flow.critical_depth()};
  }
  return {exact::SteadyBump(gravity, 0.18, 0.33), 0.33, 0.33, {}};
}

/// A settled profile: depth and discharge at cell centres.
struct Settled {
  Profile profile;
  std::vector<double> discharge;
  double mass_defect = 0;
  double momentum_defect = 0;
};

Settled by_particles(const Regime& regime, double gravity, long n, double time, const Run::Progress& progress) {
  const double q = regime.flow.discharge();
  const auto depth = [&](double x) { return regime.start_depth(x); };
  particles::Open inflow{.discharge = [q](double) { return q; }};
  particles::Open outflow;
  if (regime.outflow_depth) outflow.depth = [h = *regime.outflow_depth](double) { return h; };
  const double length = regime.flow.bump().length;
  particles::ParticleFlow flow(
      particles::particles_from_profile(particles::equal_width_edges(0, length, static_cast<std::size_t>(n)), depth,
                                        [&](double x) { return q / depth(x); }),
      {.left = inflow, .right = outflow}, {.gravity = gravity, .bed = regime.flow.bed()});
  while (flow.time() < time * (1 - 1e-12)) {
    flow.advance(std::min(flow.largest_step().tau, time - flow.time()));
    progress(flow.time() / time);
  }
  Settled settled{.profile = flow.measured_profile(),
                  .discharge = {},
                  .mass_defect = flow.mass_defect(),
                  .momentum_defect = flow.momentum_defect()};
  for (const State& s : settled.profile.means) settled.discharge.push_back(s.depth * s.velocity);
  return settled;
}

Settled by_cells(const Regime& regime, double gravity, long n, double time) {
  const double length = regime.flow.bump().length;
  std::vector<double> depth;
  std::vector<double> discharge(static_cast<std::size_t>(n), regime.flow.discharge());
  for (long i = 0; i < n; ++i) {
    depth.push_back(regime.start_depth(length * (static_cast<double>(i) + 0.5) / static_cast<double>(n)));
  }
  shallow_water_finite_volume::FiniteVolumeFlow::Settings settings;
  settings.gravity = gravity;
  // The exact end states are held: the weakest way to err at the ends.
  settings.left = shallow_water_finite_volume::End::inflow(regime.flow.at(0));
  settings.right = shallow_water_finite_volume::End::inflow(regime.flow.at(length));
  shallow_water_finite_volume::FiniteVolumeFlow flow(settings, 0, length, depth, discharge, regime.flow.bed());
  flow.advance_to(time);
  Settled settled;
  settled.profile.edges = flow.edges();
  for (std::size_t i = 0; i < flow.cells(); ++i) settled.profile.means.push_back({flow.depth()[i], flow.velocity()[i]});
  settled.discharge.assign(flow.discharge().begin(), flow.discharge().end());
  return settled;
}

double depth_error(const Settled& settled, const exact::SteadyBump& exact) {
  return shallow_water::cell_error(
             settled.profile, [&](double x) { return exact.at(x); }, exact.breakpoints())
      .depth.l1;
}

double discharge_spread(const Settled& settled, double q) {
  double sum = 0;
  for (const double value : settled.discharge) sum += std::abs(value - q);
  return sum / static_cast<double>(settled.discharge.size()) / q;
}

constexpr std::array<long, 4> refinements{1, 2, 4, 8};

/// Mean errors after the flow has settled.
struct Errors {
  long particles = 0;
  double depth = 0;
  double discharge = 0;  ///< relative
  double peer_depth = 0;
  double peer_discharge = 0;
};

struct Results {
  std::vector<Errors> errors;
  Settled finest;
  Settled peer;
};

evidence::ObservedOrder order_of(const Results& r) {
  std::vector<double> widths;
  std::vector<double> errors;
  for (const Errors& e : r.errors) {
    widths.push_back(25.0 / static_cast<double>(e.particles));
    errors.push_back(e.depth);
  }
  return evidence::observed_order(widths, errors);
}

void claims(const Values& values, const Claims<Results>& claims) {
  const double gravity = values.real("gravity");
  const Regime regime = regime_from(values.text("regime"), gravity);
  const long finest = refinements.back() * values.integer("particles");
  const bool smooth = values.text("regime") != "jump";
  claims.check(
      {.id = "order",
       .text = "The depth converges to the steady state at the order of the method.",
       .quantity = "observed order of cell L1(h)",
       .source = "Delestre et al. (2013), section 3.1"},
      order_of,
      evidence::Order{
          smooth ? 2.0 : 1.0, 0.5,
          smooth ? "second order; the bump's corners, and particles that enter at their own rhythm, scatter it by a "
                   "few tenths"
                 : "first order at a jump; its place between particles scatters single errors by a few tenths"});
  const double depth = regime.start_depth(0);
  claims.at(fmt::format("N = {}", finest))
      .check(
          {.id = "mass",
           .text = "Mass is what it was, plus inflow, less outflow.",
           .quantity = "mass less the booked mass",
           .unit = "m^2",
           .source = "conservation law of mass"},
          [](const Results& r) { return r.finest.mass_defect; },
          open_ends_roundoff({.length = regime.flow.bump().length,
                              .depth = depth,
                              .discharge = regime.flow.discharge(),
                              .celerity = std::sqrt(gravity * depth)},
                             finest, values.real("time")));
}

Results compute(const Run& run) {
  const double gravity = run.real("gravity");
  const Regime regime = regime_from(run.text("regime"), gravity);
  const double q = regime.flow.discharge();
  const double time = run.real("time");
  Results r;
  for (std::size_t k = 0; k < refinements.size(); ++k) {
    const long count = refinements[k] * run.integer("particles");
    r.finest = by_particles(regime, gravity, count, time,
                            [&](double done) { run.progress(0.25 * (static_cast<double>(k) + 0.8 * done)); });
    r.peer = by_cells(regime, gravity, count, time);
    r.errors.push_back({.particles = count,
                        .depth = depth_error(r.finest, regime.flow),
                        .discharge = discharge_spread(r.finest, q),
                        .peer_depth = depth_error(r.peer, regime.flow),
                        .peer_discharge = discharge_spread(r.peer, q)});
  }
  return r;
}

void draw(evidence::Exhibit& exhibit, const Results& r, const exact::SteadyBump& flow) {
  std::vector<double> x;
  std::vector<double> surface;
  std::vector<double> bed;
  for (int k = 0; k <= 500; ++k) {
    x.push_back(25.0 * k / 500);
    bed.push_back(flow.elevation(x.back()));
    surface.push_back(flow.at(x.back()).depth + bed.back());
  }
  auto& figure =
      exhibit.figure("profile", "Steady flow over a bump", "Surface and discharge after the flow has settled.");
  auto& top = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  const Means means = means_of(r.finest.profile);
  std::vector<double> level;
  for (std::size_t i = 0; i < means.centre.size(); ++i) {
    level.push_back(means.depth[i] + flow.elevation(means.centre[i]));
  }
  top.fill("bed", x, bed, Role::bed);
  top.line("exact surface", x, surface, Role::exact);
  top.points("particles", means.centre, level, Role::computed);
  auto& bottom = figure.panel({.x = "x [m]", .y = "discharge q [m²/s]"});
  const double q = flow.discharge();
  bottom.line("exact", std::vector<double>{0, 25}, std::vector<double>{q, q}, Role::exact);
  bottom.points("particles", means.centre, r.finest.discharge, Role::computed);
  bottom.points("MUSCL-HLL", means_of(r.peer.profile).centre, r.peer.discharge, Role::peer);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  evidence::Table table{.id = "resolutions",
                        .title = "Refinement",
                        .caption = "Mean errors after the flow has settled.",
                        .columns = {{"N", ""},
                                    {"particles: L1(h)", "m"},
                                    {"particles: L1(q)/q", ""},
                                    {"cells: L1(h)", "m"},
                                    {"cells: L1(q)/q", ""}}};
  for (const Errors& e : r.errors) {
    table.rows.push_back({static_cast<double>(e.particles), e.depth, e.discharge, e.peer_depth, e.peer_discharge});
  }
  exhibit.table(std::move(table));
  exhibit.measure("cell_l1_h", r.errors.back().depth);
  exhibit.measure("relative_discharge_error", r.errors.back().discharge);
  exhibit.measure("cell_l1_h_muscl", r.errors.back().peer_depth);
  exhibit.measure("relative_discharge_error_muscl", r.errors.back().peer_discharge);
  exhibit.measure("mass_defect", r.finest.mass_defect);
  exhibit.measure("momentum_defect", r.finest.momentum_defect);
  draw(exhibit, r, regime_from(values.text("regime"), values.real("gravity")).flow);
}

}  // namespace

Case steady_bump() {
  Case c;
  c.title = "Steady flow over a bump";
  c.source =
      "O. Delestre et al., SWASHES: a compilation of shallow water analytic solutions, Int. J. Numer. Meth. Fluids 72 "
      "(2013) 269, section 3.1";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      choice("regime", std::string("subcritical"), {"subcritical", "transcritical", "jump"}, "which steady state"),
      integer("particles", {25, 100, 400}, {8, 1e5}, "coarsest number of particles; 2, 4 and 8 times as many run too"),
      real("time", {100, 200, 400}, "s", {1, 1e5}, "time in which the flow settles"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
