/*
A round drop without gravity, with initial velocities linear in position, becomes an ellipse: Dirichlet's exact
solution, with which Frank tests Gauss-principle particles (section 6.3).

**Set-up.** The initial velocity gradient is `xx`, `xy`, `yx` and $yy = -xx$; by default $u = x$, $v = -y$. Rings of
particles on the unit disc, markers on its rim; cubic splines on square cells of 0.2, many of them cut by the surface.
Steps of 0.01 to t = 2, when the drop is 13 times as long as wide. No condition is imposed on the surface.

**What is compared.** The positions of particles and markers with the exact ones, and with a space of the five linear
fields alone, in which the particle error comes from the steps only; the pressure at the centre, fitted to the reactions
of a step.

**What to look at.** The particles stay on their exact paths; the surface is as accurate as the interior.

**Limits of this test.** The fields are linear, so that the space contains them exactly: the test covers the extension
at cut cells, the sums over particles, and the steps.
*/
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/LU>

#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/drop/affine_motion.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/exact/affine_drop.hpp"
#include "validation/instruments/particles/gauss_pressure.hpp"
#include "validation/studies/gauss_particles/gauss_frame.hpp"

namespace seiche::validation::cases::ellipse_gauss {

using exact::AffineDrop;
using gauss_particles::Flow;
using gauss_particles::SplineSpace;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 6.3; Dirichlet (1860)";

constexpr long pressures = 10;  ///< how many times the pressure is taken

/// What the parameters decide.
struct SetUp {
  Eigen::Matrix2d gradient;  ///< of the velocity at the beginning
  AffineDrop drop;
  std::size_t rings;
  double tau, end;

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(rings); }
  [[nodiscard]] double particles() const { return 3 * static_cast<double>(rings * rings); }
};

/// Throws std::invalid_argument where the rotation is as fast as the strain.
SetUp set_up(const Values& values) {
  Eigen::Matrix2d gradient;
  gradient << values.real("xx"), values.real("xy"), values.real("yx"), -values.real("xx");
  if (!(gradient.determinant() < 0)) {
    throw std::invalid_argument(
        fmt::format("xx^2 + xy yx = {:g} is out of range: must be positive; otherwise the pressure is below the "
                    "surroundings and the surface unstable",
                    -gradient.determinant()));
  }
  const auto rings = std::lround(std::sqrt(values.number("particles") / 3));
  return {gradient, AffineDrop(Eigen::Matrix2d::Identity(), gradient), static_cast<std::size_t>(rings),
          values.real("tau"), values.real("time")};
}

struct Errors {
  double rms = 0;      ///< of the particles' places
  double surface = 0;  ///< largest of the markers' places
};

struct Results {
  SetUp set_up;
  std::vector<GaussFrame> frames;
  Errors splines, linear;
  std::vector<double> pressure_time, pressure;  ///< at the middle of the drop
  Worst pressure_error;                         ///< relative
  [[nodiscard]] double beside_linear() const { return splines.rms / linear.rms; }
};

Errors errors_of(const Flow& flow, const AffineDrop& drop) {
  const Eigen::Matrix2d deformation = drop.at(flow.time()).deformation;
  const gauss_particles::Particles& first = flow.model().particles();
  Mean inside;
  Worst surface;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const Eigen::Vector2d place = deformation * Eigen::Vector2d(first.x[k], first.y[k]);
    const double distance = std::hypot(flow.x()[k] - place.x(), flow.y()[k] - place.y());
    if (first.mass[k] > 0) {
      inside.add(distance, first.mass[k]);
    } else {
      surface.add(distance);
    }
  }
  return {inside.rms(), surface.value()};
}

Flow flow_in(std::unique_ptr<gauss_particles::FieldSpace> space, const SetUp& s) {
  return Flow(gauss_particles::disc(1, s.rings, 128), std::move(space), linear_velocity(s.gradient),
              {.gravity = 0, .penalty = 0});
}

/// The pressure at the middle of the drop in the middle of the last step.
void take_pressure(Results& r, const Flow& flow, double tau) {
  const double time = flow.time() - tau / 2;
  const exact::DropInstant instant = r.set_up.drop.at(time);
  const Eigen::Matrix2d back = instant.deformation.inverse();
  const gauss_particles::PressureFit fit(
      flow.model(), tau,
      [&](Point place) {
        const Eigen::Vector2d label = back * Eigen::Vector2d(place.x, place.y);
        const Eigen::Vector2d gradient = -2 * back.transpose() * label;
        return gauss_particles::Level{1 - label.squaredNorm(), {gradient.x(), gradient.y()}};
      },
      2);
  r.pressure_time.push_back(time);
  r.pressure.push_back(fit.pressure({0, 0}));
  r.pressure_error.add(r.pressure.back() / instant.central_pressure - 1, time);
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  const gauss_particles::LatticePlan plan{.degree = static_cast<int>(run.integer("degree")),
                                          .cell_x = run.real("cell")};
  Flow flow = flow_in(std::make_unique<SplineSpace>(plan, SplineSpace::Settings{.inner_fraction = 0.4}), s);
  r.frames.emplace_back(flow);
  for (long part = 1; part <= pressures; ++part) {
    double before = flow.time();
    double last_step = 0;
    march(flow, s.end * static_cast<double>(part) / pressures, s.tau, [&] {
      last_step = flow.time() - before;
      before = flow.time();
    });
    take_pressure(r, flow, last_step);
    if (2 * part % pressures == 0) r.frames.emplace_back(flow);
    run.progress(0.09 * static_cast<double>(part));
  }
  r.splines = errors_of(flow, s.drop);
  Flow linear = flow_in(std::make_unique<gauss_particles::PolynomialSpace>(), s);
  march(linear, s.end, s.tau);
  r.linear = errors_of(linear, s.drop);
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const SetUp s = set_up(values);
  const Claims<Results> claims = all.at(fmt::format("{:g} particles, tau = {:g}", s.particles(), s.tau));
  const double strain = s.gradient.norm() / std::numbers::sqrt2;
  const Claims<Errors> splines = claims.of(&Results::splines);
  splines.check(
      "places", "The rms error of particle positions is below its second-order estimate, (strain rate times step)^2.",
      "rms distance from the exact positions [radius]", &Errors::rms,
      Bound{std::pow(strain * s.tau, 2),
            "second order: the square of strain rate times step, in radii; the error of Frank's first-order projection "
            "scheme is a fraction of strain rate times step"});
  claims.check(
      "lattice",
      "The error with splines is at most twice the error with linear fields alone, the error of the time steps.",
      "rms distance over that with linear fields alone", &Results::beside_linear,
      Bound{2, "as much again: an error budget shared equally by steps and splines"});
  splines.check(
      "surface", "The distance of the surface markers from the exact surface is below 1 % of the ring spacing.",
      "largest distance of a marker from its exact position [radius]", &Errors::surface,
      Bound{0.01 * s.spacing(),
            "1 % of the ring spacing, below which particles do not define a surface position; splines without "
            "extension at cut cells have an error of a third of the spacing"});
  claims.check("pressure",
               "The pressure at the centre, fitted to the reactions, agrees with Dirichlet's solution within 0.1.",
               "largest relative error at ten instants", &Results::pressure_error,
               Bound{0.1 / std::sqrt(s.particles()),
                     "the grid error of the gradients, up to a tenth, has either sign: a mean over all particles"});
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("frames", "The drop", "Every fourth surface marker, and the exact ellipse.", {"frank-ellipse"});
  for (const GaussFrame& frame : r.frames) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < frame.line_x.size(); k += 4) {
      x.push_back(frame.line_x[k]);
      y.push_back(frame.line_y[k]);
    }
    draw_drop(figure, fmt::format("t = {:g}", frame.time), "markers", x, y, r.set_up.drop, frame.time);
  }
  auto& panel = add_panel(exhibit, "pressure", "Pressure at the centre",
                          "Fitted to the reactions of single steps, and Dirichlet's.",
                          {.x = "t", .y = "p(0, 0)/density"}, {"frank-ellipse"});
  const std::vector<double> time = evenly(0, r.set_up.end, 101);
  panel.points("fitted", r.pressure_time, r.pressure, Role::computed);
  panel.line("exact", time, each(time, [&](double t) { return r.set_up.drop.at(t).central_pressure; }), Role::exact);
  exhibit.measure("rms_linear_fields", r.linear.rms);
}

void ellipse_gauss(Case& c) {
  c.title = "Stretching of a liquid drop: Gauss-principle particles";
  c.source = source;
  c.parameters = {
      real("xx", 1.0, "1", {-5, 5}, "initial velocity gradient du/dx; dv/dy is its opposite"),
      real("xy", 0.0, "1", {-5, 5}, "initial velocity gradient du/dy"),
      real("yx", 0.0, "1", {-5, 5}, "initial velocity gradient dv/dx"),
      real("cell", 0.2, "1", {0.01, 1}, "side of a cell"),
      integer("particles", {4800, 19200, 76800}, {108, 3e6}, "on the disc, rounded to rings of 3, 9, 15, ..."),
      integer("degree", 3, {2, 4}, "degree of the splines"),
      real("tau", {0.01, 0.005, 0.0025}, "1", {1e-5, 0.5}, "time step"),
      real("time", 2.0, "1", {0.01, 10}, "end of the run"),
  };
  c.published = {{.tiles = {"frank-ellipse"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::ellipse_gauss
