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
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/stretching_drop.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/case/on_threads.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "validation/studies/wcsph/particle_frames.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;
using wcsph::Flow;

const std::string source = "Monaghan, J. Comput. Phys. 110 (1994) 399; Dirichlet (1860)";
constexpr double density = 1000;
constexpr double end = 1;
constexpr long samples = 20;

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
  double momentum = 0;          ///< largest defect over sum m|u|
  double angular_momentum = 0;  ///< over sum m|u| times the radius
  double energy = 0;            ///< defect at the end over the kinetic energy of the beginning
  wcsph::Particles last;
};

wcsph::Settings settings_of(const Run& run) {
  return sph_settings(run.values(), 0, density, 1);
}

Stretched stretch(const Run& run, double spacing, const exact::StretchingDrop& drop) {
  const wcsph::Settings settings = settings_of(run);
  const wcsph::Scene scene =
      wcsph::patch({.radius = 1,
                    .velocity =
                        [](double x, double z) {
                          return wcsph::Velocity{-x, z};
                        },
                    .pressure = [&](double x, double z) { return 0.5 * density * std::max(0.0, 1 - x * x - z * z); },
                    .spacing = spacing},
                   settings);
  Flow flow(scene.particles, scene.spacing, settings);
  Stretched result{.spacing = scene.spacing, .particles = scene.particles.size()};
  const wcsph::Totals first = flow.totals();
  for (long n = 1; n <= samples; ++n) {
    const double t = end * static_cast<double>(n) / static_cast<double>(samples);
    flow.advance_to(t);
    const wcsph::Totals now = flow.totals();
    result.time.push_back(t);
    result.axis.push_back(long_axis(flow.particles()));
    result.axis_error.push_back(result.axis.back() / drop.other_axis(t) - 1);
    result.velocity_error.push_back(velocity_error(flow.particles(), drop.strain_rate(t)));
    for (const double p : now.momentum) {
      result.momentum = std::max(result.momentum, std::abs(p) / now.absolute_momentum);
    }
    result.angular_momentum = std::max(result.angular_momentum,
                                       std::abs(now.angular_momentum - first.angular_momentum) / now.absolute_momentum);
    result.energy = std::abs(now.energy() - first.energy()) / first.kinetic;
  }
  result.steps = flow.steps();
  result.last = flow.particles();
  return result;
}

double at(const Stretched& run, const std::vector<double>& values, double t) {
  return linear_at({run.time, values}, t);
}

void claim(Running& run, const std::vector<Stretched>& runs) {
  const Stretched& finest = runs.back();
  std::vector<double> sizes;
  for (const Stretched& one : runs) sizes.push_back(one.spacing);
  const std::string resolution = sph_resolution(finest.spacing, finest.particles);
  const auto judge = [&](const std::string& id, const std::string& text, const std::string& quantity, double t,
                         const std::vector<double> Stretched::*values, double limit, const std::string& reason) {
    std::vector<double> all;
    for (const Stretched& one : runs) all.push_back(at(one, one.*values, t));
    run.record.measure(fmt::format("{}_at_{:g}", id, t), all.back());
    run.record.check({.id = fmt::format("{}-{:g}", id, 10 * t), .text = text, .quantity = quantity, .source = source},
                     {.value = all.back(), .resolution = resolution}, Bound{.limit = limit, .reason = reason});
  };
  const std::string one_spacing = "the edge of the patch is known to a spacing";
  for (const double t : {0.5, 1.0}) {
    judge("axis", fmt::format("The patch is as long as the exact one at t = {:g}.", t), "relative error of b", t,
          &Stretched::axis_error, 0.5 * finest.spacing, "half a spacing over the radius: " + one_spacing);
  }
  run.record.check({.id = "momentum",
                    .text = "Momentum is kept to rounding.",
                    .quantity = "largest defect over sum m|u|",
                    .source = source},
                   {.value = finest.momentum, .resolution = resolution},
                   evidence::Roundoff{.operations = static_cast<double>(finest.steps),
                                      .scale = 1,
                                      .reason = "once per step; forces of pairs are opposite bit by bit, sums of "
                                                "different order round differently"});
  run.record.check({.id = "angular-momentum",
                    .text = "Angular momentum is kept to rounding: the patch is symmetric.",
                    .quantity = "largest defect over sum m|u| times the radius",
                    .source = source},
                   {.value = finest.angular_momentum, .resolution = resolution},
                   evidence::Roundoff{.operations = static_cast<double>(finest.steps),
                                      .scale = 1,
                                      .reason = "once per step; the midpoint rule keeps it to second order only, "
                                                "but errors of mirrored particles cancel"});
  run.record.check({.id = "energy",
                    .text = "Energy is kept to the order of the steps.",
                    .quantity = "defect at the end over the kinetic energy of the beginning",
                    .source = source},
                   {.value = finest.energy, .resolution = resolution},
                   Bound{.limit = 5e-4,
                         .reason = "ten times the 5e-5 that the midpoint rule, which lets sound grow, makes with steps "
                                   "of 0.3 h/c at dx = 0.02"});
}

/// Errors of an independent implementation with the same spacing.
struct Known {
  std::string kernel;
  double smoothing;
  std::array<double, 2> axis, velocity;  ///< at t = 0.5 and 1
};

void claim_independent(Running& run, const Stretched& finest) {
  const std::array<Known, 2> known{Known{"cubic_spline", 1.3, {1.6e-3, 6.3e-3}, {3.3e-2, 6.7e-2}},
                                   Known{"wendland_c2", 2.0, {1.1e-3, 1.8e-3}, {1.3e-2, 2.2e-2}}};
  const auto found = std::ranges::find_if(known, [&](const Known& one) {
    return one.kernel == run.text("kernel") && one.smoothing == run.real("smoothing");
  });
  if (found == known.end() || finest.spacing != 0.02) return;
  constexpr std::array<double, 2> times{0.5, 1};
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto judge = [&](const std::string& what, const std::vector<double>& values, double theirs) {
      run.record.check({.id = fmt::format("independent-{}-{:g}", what, 10 * times[k]),
                        .text = fmt::format("At t = {:g} the error of the {} is not above that of an independent "
                                            "program with the same spacing.",
                                            times[k], what),
                        .quantity = "error over theirs",
                        .source = "computed once by an independent implementation"},
                       {.value = std::abs(at(finest, values, times[k])) / theirs,
                        .resolution = sph_resolution(finest.spacing, finest.particles)},
                       Bound{.limit = 1.25, .reason = "the order of sums and steps differ: a quarter"});
    };
    judge("axis", finest.axis_error, found->axis[k]);
    judge("velocity", finest.velocity_error, found->velocity[k]);
  }
}

void draw(Running& run, const std::vector<Stretched>& runs, const exact::StretchingDrop& drop) {
  auto& figure = run.record.figure("patch", "Semi-axis and particles",
                                   "Left: the longer semi-axis; right: particles at the end and the exact ellipse.");
  auto& axis = figure.panel({.x = "t [s]", .y = "b [m]"});
  std::vector<double> exact_axis;
  for (const double t : runs.back().time) exact_axis.push_back(drop.other_axis(t));
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
  auto& study = run.record.figure("convergence", "Errors", "Of the semi-axis and of the velocities, relative.");
  std::vector<double> sizes;
  for (const Stretched& one : runs) sizes.push_back(one.spacing);
  for (const double t : {0.5, 1.0}) {
    std::vector<double> axes, velocities;
    for (const Stretched& one : runs) {
      axes.push_back(std::abs(at(one, one.axis_error, t)));
      velocities.push_back(at(one, one.velocity_error, t));
    }
    auto& panel = study.panel(
        {.x = "dx [m]", .y = "relative error", .title = fmt::format("t = {:g} s", t), .log_x = true, .log_y = true});
    panel.points("semi-axis", sizes, axes, Role::computed);
    panel.points("velocities", sizes, velocities, Role::peer);
    slope_guide(panel, 1, sizes, 0.7 * axes.back());
  }
}

void run(Running& run) {
  const exact::StretchingDrop drop(1, 1, -1, 1000);
  const double finest = run.real("dx");
  const std::vector<double> ladder{2 * finest, std::sqrt(2.0) * finest, finest};
  std::vector<Stretched> runs(ladder.size());
  on_threads(
      ladder.size(), workers_of(run.tier()),
      [&](std::size_t k) {
        const std::size_t costly_first = ladder.size() - 1 - k;
        runs[costly_first] = stretch(run, ladder[costly_first], drop);
      },
      [&](std::size_t done) { run.progress(static_cast<double>(done) / static_cast<double>(ladder.size())); });
  claim(run, runs);
  claim_independent(run, runs.back());
  for (const double t : {0.5, 1.0}) {
    run.record.measure(fmt::format("velocity_at_{:g}", t), at(runs.back(), runs.back().velocity_error, t));
  }
  draw(run, runs, drop);
  add_particles(run.record, end, runs.back().last, settings_of(run));
}

}  // namespace

Case patch_sph() {
  Case c;
  c.title = "A free patch of water is stretched: weakly compressible SPH";
  c.source =
      "J. J. Monaghan, J. Comput. Phys. 110 (1994) 399; P. G. L. Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 "
      "(1860) 3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = with(
      {real("dx", {0.02, 0.01, 0.005}, "m", {0.001, 0.2}, "spacing of the particles; the radius is 1")},
      sph_parameters({.viscosity = "none", .sound = 14, .courant = {0.3, 0.2, 0.2}}, "the speed A_0 times the radius"));
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
