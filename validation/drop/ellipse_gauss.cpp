/*
A round drop without gravity is stretched, $u = x$, $v = -y$ at the beginning, and becomes an ellipse: Dirichlet's exact
solution, with which Frank tries free particles under Gauss's principle of least constraint (section 6.3).

**Set-up.** Rings of particles on the unit disc, markers on its rim; cubic splines on cells of 0.4 by 0.2, most of them
cut by the surface. Steps of 0.01 to t = 2, when the drop is 13 times as long as wide. No condition is set on the
surface.

**What is compared.** The places of particles and markers with the exact ones; those of a space that holds the five
linear fields alone, in which the particles err by the steps only; energy and momenta.

**What to look at.** The particles stay on their exact paths; the surface is as good as the inside.

**When it is no test.** The fields are linear, so that the space holds them exactly: what is tried is the extension at
cut cells, the sums over particles, and the steps.
*/
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/stretching_drop.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/polynomial_space.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
using exact::StretchingDrop;
using gauss_particles::FieldSpace;
using gauss_particles::Flow;
using gauss_particles::LatticePlan;
using gauss_particles::Particles;
using gauss_particles::PolynomialSpace;
using gauss_particles::SplineSpace;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 6.3; Dirichlet (1860)";

struct Frame {
  double time = 0;
  std::vector<double> x, y;  ///< particles, then markers
};

struct Errors {
  double rms = 0;      ///< of the particles' places
  double surface = 0;  ///< largest of the markers' places
};

struct Results {
  std::vector<Frame> frames;
  std::size_t massive = 0;
  Errors splines, linear;
  double energy = 0;            ///< largest defect over the kinetic energy
  double momentum = 0;          ///< largest defect of the momentum
  double angular_momentum = 0;  ///< largest defect
  [[nodiscard]] double beside_linear() const { return splines.rms / linear.rms; }
};

Errors errors_of(const Flow& flow) {
  const StretchingDrop drop(1, 1, 1);
  const Particles& first = flow.model().particles();
  Mean inside;
  Worst surface;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const double distance = std::hypot(flow.x()[k] - drop.semi_axis(flow.time()) * first.x[k],
                                       flow.y()[k] - drop.other_axis(flow.time()) * first.y[k]);
    if (first.mass[k] > 0) {
      inside.add(distance, first.mass[k]);
    } else {
      surface.add(distance);
    }
  }
  return {inside.rms(), surface.value()};
}

Flow flow_in(std::unique_ptr<FieldSpace> space, const Values& values) {
  return Flow(gauss_particles::disc(1, static_cast<std::size_t>(values.integer("rings")), 128), std::move(space),
              [](Point r) {
                return Point{r.x, -r.y};
              },
              {.gravity = 0, .penalty = 0});
}

Results compute(const Run& run) {
  Results r;
  const double tau = run.real("time_step");
  const double end = run.real("time");
  Flow flow = flow_in(std::make_unique<SplineSpace>(LatticePlan{.degree = static_cast<int>(run.integer("degree")),
                                                                .cell_x = run.real("cell_x"),
                                                                .cell_y = run.real("cell_y")},
                                                    SplineSpace::Settings{.inner_fraction = 0.4}),
                      run);
  const double kinetic = flow.energy();
  const auto keep = [&] {
    r.frames.push_back({flow.time(), {flow.x().begin(), flow.x().end()}, {flow.y().begin(), flow.y().end()}});
  };
  keep();
  for (int part = 1; part <= 2; ++part) {
    flow.advance_to(end * part / 2, tau, [&] { flow.observe(); });
    keep();
    run.progress(0.45 * part);
  }
  r.massive = flow.model().size() - flow.markers().size();
  r.splines = errors_of(flow);
  r.energy = flow.ledger().largest_defect("energy") / kinetic;
  r.momentum = flow.ledger().largest_defect("momentum");
  r.angular_momentum = flow.ledger().largest_defect("angular");
  Flow linear = flow_in(std::make_unique<PolynomialSpace>(), run);
  linear.advance_to(end, tau);
  r.linear = errors_of(linear);
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const double steps = std::ceil(values.real("time") / values.real("time_step"));
  const Claims<Results> claims =
      all.at(fmt::format("{} rings, tau = {:g}", values.integer("rings"), values.real("time_step")));
  const auto published =
      claims.only_if(values.as_published("frank-ellipse"), "the independent program ran with the default parameters");
  published.check(
      {.id = "places",
       .text = "The particles err by little more than the steps make them err.",
       .quantity = "rms distance over that with linear fields alone",
       .source = source},
      &Results::beside_linear,
      evidence::Bound{.limit = 0.5,
                      .reason = "sums over 4800 particles err by less than the steps do; a lattice without the "
                                "continuation at cut cells errs by 40 times as much",
                      .expected = 1});
  published.check(
      {.id = "surface",
       .text = "The markers stay on the surface.",
       .quantity = "largest distance of a marker from its exact place",
       .unit = "radius",
       .source = source},
      [](const Results& r) { return r.splines.surface; },
      evidence::Bound{1.5 * 3.2e-5, "1.5 times what an independent program of the same method found"});
  const auto kept = [&](const std::string& id, const std::string& what, double Results::*member, double scale) {
    claims.check(
        {.id = id,
         .text = "The " + what + " is kept to round-off.",
         .quantity = "largest defect",
         .source = "Frank (1994), chapter 6, proposition 4"},
        member,
        evidence::Roundoff{
            .operations = steps, .scale = scale, .reason = "one rounded velocity per step; scale: sums of magnitudes"});
  };
  kept("energy", "energy", &Results::energy, 1);
  kept("momentum", "momentum", &Results::momentum, 3);
  kept("angular_momentum", "angular momentum", &Results::angular_momentum, 6);
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const StretchingDrop drop(1, 1, 1);
  auto& figure =
      exhibit.figure("frames", "The drop", "Markers of its surface, and the exact ellipse.", {"frank-ellipse"});
  for (const Frame& frame : r.frames) {
    auto& panel =
        figure.panel({.x = "x", .y = "y", .title = fmt::format("t = {:g}", frame.time), .equal_aspect = true});
    std::vector<double> x;
    std::vector<double> y;
    for (int k = 0; k <= 200; ++k) {
      const double angle = 2 * std::numbers::pi * k / 200;
      x.push_back(drop.semi_axis(frame.time) * std::cos(angle));
      y.push_back(drop.other_axis(frame.time) * std::sin(angle));
    }
    panel.line("exact", x, y, Role::exact);
    panel.points("markers", std::span(frame.x).subspan(r.massive), std::span(frame.y).subspan(r.massive),
                 Role::computed);
  }
  exhibit.measure("rms", r.splines.rms);
  exhibit.measure("rms_linear_fields", r.linear.rms);
  exhibit.measure("surface", r.splines.surface);
  exhibit.measure("energy_defect", r.energy);
}

}  // namespace

Case ellipse_gauss() {
  Case c;
  c.title = "A liquid drop is stretched, by free particles under Gauss's principle";
  c.source = source;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("rings", {40, 80, 160}, {6, 1000}, "rings of particles on the disc"),
      real("cell_x", 0.4, "1", {0.01, 1}, "width of a cell"),
      real("cell_y", 0.2, "1", {0.01, 1}, "height of a cell"),
      integer("degree", 3, {2, 4}, "degree of the splines"),
      real("time_step", 0.01, "1", {1e-5, 0.5}, "time step"),
      real("time", 2.0, "1", {0.01, 10}, "end of the run"),
  };
  c.published = {{.tiles = {"frank-ellipse"}}};
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
