/*
A round patch of water without gravity is given the velocity $u = -A_0 x$, $w = A_0 z$ and stretches into an ellipse for
ever: Dirichlet's exact solution, and the usual first test of a particle method. Here weakly compressible SPH.

**Set-up.** Radius and $A_0$ are 1, $c_0 = 14$, no viscosity, XSPH $\epsilon = 0.5$. The pressure begins as
$\tfrac12\rho A_0^2 (1 - r^2)$. The runs end at $t = 1$, when the patch is 2.3 times as long as at first: beyond, rows
of particles that began $dx$ apart are $2h$ apart, and the cubic spline does not hold them together. Without viscosity
sound as short as the spacing grows in every midpoint step by $(\omega\,dt)^4/8$, and a finer lattice takes more steps:
with steps of $0.3\,h/c$ the energy changes by 5e-5 at $dx = 0.02$ and by 2e-3 at 0.01, with $0.2\,h/c$ there by 1e-5.
Hence $0.2\,h/c$ in the tier `full`.

**What is compared.** The semi-axis $b = 2\sqrt{\sum m z^2/\sum m}$ and the velocities with the exact ones at $t = 0.5$
and 1; momentum, angular momentum and energy with those of the beginning.

**What to look at.** The velocities hardly improve with the spacing, and the Wendland kernel with more neighbours is
several times better than the cubic spline with $h = 1.3\,dx$. Momenta are kept to rounding all the same.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "seiche/exact/affine_drop.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/wcsph/particle_frames.hpp"
#include "validation/studies/wcsph/spacing_ladder.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation::cases::patch_sph {
namespace {

using wcsph::Flow;

const std::string source = "Monaghan, J. Comput. Phys. 110 (1994) 399; Dirichlet (1860)";
constexpr double density = 1000;
constexpr double end = 1;
constexpr long samples = 20;

exact::StretchingDrop exact_drop() {
  return {1, 1, -1, 1000};
}

double long_axis(const wcsph::Particles& particles) {
  double mass = 0;
  double moment = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    mass += particles.mass[i];
    moment += particles.mass[i] * particles.z[i] * particles.z[i];
  }
  return 2 * std::sqrt(moment / mass);
}

/// Root mean square of a component's difference from u = alpha x, w = -alpha z, over the rms speed.
double velocity_error(const wcsph::Particles& particles, double alpha) {
  double error = 0;
  double norm = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double u = alpha * particles.x[i];
    const double w = -alpha * particles.z[i];
    error += particles.mass[i] * (std::pow(particles.u[i] - u, 2) + std::pow(particles.w[i] - w, 2));
    norm += 2 * particles.mass[i] * (u * u + w * w);
  }
  return std::sqrt(error / norm);
}

struct Stretched {
  double spacing = 0;
  std::size_t particles = 0;
  long steps = 0;
  std::vector<double> time, axis, axis_error, velocity_error;
  Worst momentum;                                            ///< defect over sum m|u|
  Worst angular_momentum;                                    ///< over sum m|u| times the radius
  double energy = std::numeric_limits<double>::quiet_NaN();  ///< defect at the end over the first kinetic energy
  wcsph::Particles last;
  [[nodiscard]] std::string resolution() const { return sph_resolution(spacing, particles); }
};

wcsph::Settings settings_of(const Values& values) {
  return sph_settings(values, 0, density, 1);
}

Stretched stretch(const wcsph::Settings& settings, double spacing) {
  wcsph::Scene scene =
      wcsph::patch({.radius = 1,
                    .velocity =
                        [](double x, double z) {
                          return wcsph::Velocity{-x, z};
                        },
                    .pressure = [&](double x, double z) { return 0.5 * density * std::max(0.0, 1 - x * x - z * z); },
                    .spacing = spacing},
                   settings);
  Flow flow(std::move(scene.particles), scene.spacing, settings);
  const exact::StretchingDrop drop = exact_drop();
  Stretched result{.spacing = scene.spacing, .particles = flow.particles().size()};
  const wcsph::Totals first = flow.totals();
  for (long n = 1; n <= samples; ++n) {
    const double t = end * static_cast<double>(n) / static_cast<double>(samples);
    march(flow, t);
    const wcsph::Totals now = flow.totals();
    result.time.push_back(t);
    result.axis.push_back(long_axis(flow.particles()));
    result.axis_error.push_back(result.axis.back() / drop.other_axis(t) - 1);
    result.velocity_error.push_back(velocity_error(flow.particles(), drop.strain_rate(t)));
    for (const double p : now.momentum) result.momentum.add(p / now.absolute_momentum, t);
    result.angular_momentum.add((now.angular_momentum - first.angular_momentum) / now.absolute_momentum, t);
    result.energy = std::abs(now.energy() - first.energy()) / first.kinetic;
  }
  result.steps = flow.steps();
  result.last = flow.particles();
  return result;
}

double at(const Stretched& run, const std::vector<double>& values, double t) {
  return linear_at({run.time, values}, t);
}

using Results = std::vector<Stretched>;  ///< by falling spacing

Results compute(const Run& run) {
  const double finest = run.real("dx");
  const std::vector<double> ladder{2 * finest, std::numbers::sqrt2 * finest, finest};
  Results runs(ladder.size());
  climb(run, ladder.size(), [&](std::size_t size) { runs[size] = stretch(settings_of(run), ladder[size]); });
  return runs;
}

void claim_momenta(const Claims<Stretched>& claims, const Values& values) {
  const double dx = values.real("dx");
  const double particles = std::numbers::pi / (dx * dx);
  const double steps = end * values.real("sound") / (values.real("courant") * values.real("smoothing") * dx);
  const std::string counted =
      "the N particles within the radius, each with 1/N of sum m|u|, are rounded once in each step of courant h/c; ";
  const auto kept = [](Worst Stretched::*member) {
    return [member](const Stretched& run) -> Measurement {
      const Worst& worst = run.*member;
      return {
          .value = worst.value(), .resolution = run.resolution(), .where = fmt::format("t = {:g} s", worst.where())};
    };
  };
  claims.check(
      "momentum", "Momentum of the SPH patch is conserved to round-off.", "largest defect over sum m|u|",
      kept(&Stretched::momentum),
      Roundoff{
          .operations = particles * steps,
          .scale = 1 / particles,
          .reason = counted + "forces of pairs are opposite bit by bit, sums of different order round differently"});
  claims.check(
      "angular-momentum", "Angular momentum is conserved to round-off: the patch is symmetric.",
      "largest defect over sum m|u| times the radius", kept(&Stretched::angular_momentum),
      Roundoff{.operations = particles * steps,
               .scale = 1 / particles,
               .reason = counted +
                         "the midpoint rule keeps it to second order only, but errors of mirrored particles cancel"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const auto finest = claims.of([](const Results& runs) -> const Stretched& { return runs.back(); });
  for (const double t : {0.5, 1.0}) {
    finest.check(
        fmt::format("axis-{:g}", 10 * t), fmt::format("The patch is as long as the exact one at t = {:g}.", t),
        "relative error of b",
        [t](const Stretched& run) -> Measurement {
          return {.value = at(run, run.axis_error, t), .resolution = run.resolution()};
        },
        Bound{.limit = 0.5 * values.real("dx"),
              .reason = "half a spacing over the radius: the edge of the patch is known to a spacing"});
  }
  claim_momenta(finest, values);
  finest.check(
      "energy", "Energy is kept to the order of the steps.",
      "defect at the end over the kinetic energy of the beginning",
      [](const Stretched& run) -> Measurement { return {.value = run.energy, .resolution = run.resolution()}; },
      Bound{.limit = 1 / (6 * std::pow(values.real("sound"), 2)),
            .reason = "the energy of the compression, the integral of p^2/(2 rho c^2) over that of rho r^2/2: 1/(6 "
                      "c^2); what steps change must be less than what they are to resolve"});
}

void draw(evidence::Exhibit& exhibit, const Results& runs) {
  const exact::StretchingDrop drop = exact_drop();
  auto& figure = exhibit.figure("patch", "Semi-axis and particles",
                                "Left: the longer semi-axis; right: particles at the end and the exact ellipse.");
  auto& axis = figure.panel({.x = "t [s]", .y = "b [m]"});
  std::vector<double> exact_axis = each(runs.back().time, [&](const double t) { return drop.other_axis(t); });
  axis.line("exact", runs.back().time, exact_axis, Role::exact);
  axis.points("SPH", runs.back().time, runs.back().axis, Role::computed);
  auto& places = figure.panel({.x = "x [m]", .y = "z [m]", .equal_aspect = true});
  places.points("SPH", runs.back().last.x, runs.back().last.z, Role::computed);
  std::vector<double> x, z;
  for (int k = 0; k <= 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200;
    x.push_back(drop.semi_axis(end) * std::cos(angle));
    z.push_back(drop.other_axis(end) * std::sin(angle));
  }
  places.line("exact", x, z, Role::exact);
  auto& study = exhibit.figure("convergence", "Errors", "Of the semi-axis and of the velocities, relative.");
  std::vector<double> sizes = each(runs, [](const Stretched& one) { return one.spacing; });
  for (const double t : {0.5, 1.0}) {
    std::vector<double> axes = each(runs, [&](const Stretched& one) { return std::abs(at(one, one.axis_error, t)); });
    std::vector<double> velocities = each(runs, [&](const Stretched& one) { return at(one, one.velocity_error, t); });
    auto& panel = study.panel(
        {.x = "dx [m]", .y = "relative error", .title = fmt::format("t = {:g} s", t), .log_x = true, .log_y = true});
    panel.points("semi-axis", sizes, axes, Role::computed);
    panel.points("velocities", sizes, velocities, Role::peer);
    slope_guide(panel, 1, sizes, 0.7 * axes.back());
  }
}

void show(const Results& runs, const Values& values, evidence::Exhibit& exhibit) {
  for (const double t : {0.5, 1.0}) {
    exhibit.measure(fmt::format("axis_at_{:g}", t), at(runs.back(), runs.back().axis_error, t));
    exhibit.measure(fmt::format("velocity_at_{:g}", t), at(runs.back(), runs.back().velocity_error, t));
  }
  draw(exhibit, runs);
  add_particles(exhibit, end, runs.back().last, settings_of(values));
}

}  // namespace

Case patch_sph() {
  Case c;
  c.title = "A free patch of water is stretched: weakly compressible SPH";
  c.source =
      "J. J. Monaghan, J. Comput. Phys. 110 (1994) 399; P. G. L. Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = with(
      {real("dx", {0.03, 0.01, 0.005}, "m", {0.001, 0.2}, "spacing of the particles; the radius is 1")},
      sph_parameters({.viscosity = "none", .sound = 14, .courant = {0.3, 0.2, 0.2}}, "the speed A_0 times the radius"));
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::patch_sph
