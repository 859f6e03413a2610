/*
A liquid ball without gravity starts with velocities that are linear in place, strains and rotations about all axes, and
becomes an ellipsoid that turns while the water turns in it: the exact solution of Dirichlet (1861) and Dedekind, by
free particles under Gauss's principle in space.

**Set-up.** The velocity gradient at the beginning is given by its entries; its trace is zero. Shells of particles fill
the unit ball, with isotropic second moments; the space of fields is that of the eleven linear solenoidal fields,
$\mathbf{v} = \mathrm{rot}\,\mathbf{A}$ of quadratic $\mathbf{A}$. No condition is set on the surface.

**What is compared.** The places of all particles with the exact ones, on four steps; those of a thousand particles with
those of five, for the motion is one of matrices, whatever the particles; energy, momentum and angular momentum.

**What to look at.** The error is that of the steps alone, of second order. The ellipsoid's axes, from the second
moments of the particles, follow the exact ones.

**When it is no test.** The fields are linear, and the space holds them exactly: nothing is said of a space of splines,
of a surface that cuts cells, or of walls.
*/
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "reports/evidence/slope_guide.hpp"
#include "seiche/exact/affine_ellipsoid.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/models/gauss_particles/spatial_model.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases::ellipsoid_gauss {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using evidence::Role;
using exact::AffineEllipsoid;
using gauss_particles::SpatialFields;
using gauss_particles::SpatialModel;
using gauss_particles::SpatialParticles;
using mechanics::State;

const std::string source =
    "Dirichlet, J. reine angew. Math. 58 (1861) 181; Dedekind, ibid. 217; Frank (1994), chapter 6, proposition 4";

constexpr int halvings = 3;   ///< of the longest step
constexpr int instants = 40;  ///< at which axes are taken

/// Throws std::invalid_argument where the rotation is as fast as the strain.
AffineEllipsoid drop_of(const Values& values) {
  Matrix3d gradient;
  gradient << values.real("xx"), values.real("xy"), values.real("xz"), values.real("yx"), values.real("yy"),
      values.real("yz"), values.real("zx"), values.real("zy"), -values.real("xx") - values.real("yy");
  AffineEllipsoid drop(gradient);
  const double pressure = drop.at(0).central_pressure;
  if (!(pressure > 0)) {
    throw std::invalid_argument(
        fmt::format("the velocity gradient xx, xy, xz, yx, yy, yz, zx, zy makes a pressure of {:g} at the centre, out "
                    "of range: positive; "
                    "else it is below that of the surroundings and the surface unstable",
                    pressure));
  }
  return drop;
}

/// The end in a whole number of the longest steps.
long longest_steps(const Values& values) {
  return std::lround(std::ceil(values.real("time") / (values.real("tau") * (1 << halvings))));
}

/// A regular tetrahedron and its middle: second moments are isotropic.
SpatialParticles five() {
  return {.x = {1, 1, -1, -1, 0}, .y = {1, -1, 1, -1, 0}, .z = {1, -1, -1, 1, 0}, .mass = {1, 1, 1, 1, 2}};
}

State start(const SpatialModel& model, const Matrix3d& gradient) {
  return model.state([&](const SpatialModel::Vector& r) {
    const Vector3d v = gradient * Vector3d(r[0], r[1], r[2]);
    return SpatialModel::Vector{v[0], v[1], v[2]};
  });
}

Vector3d first_place(const SpatialModel& model, std::size_t k) {
  const SpatialParticles& at = model.particles();
  return {at.x[k], at.y[k], at.z[k]};
}

Vector3d place(const SpatialModel& model, const State& state, std::size_t k) {
  const std::size_t n = model.size();
  return {state.q[k], state.q[n + k], state.q[2 * n + k]};
}

/// Largest distance of a particle from where a motion takes it.
double distance(const SpatialModel& model, const State& state, const Matrix3d& motion) {
  Worst worst;
  for (std::size_t k = 0; k < model.size(); ++k) {
    worst.add((place(model, state, k) - motion * first_place(model, k)).norm());
  }
  return worst.value();
}

/// The motion of a tetrahedron's corners.
Matrix3d motion(const SpatialModel& model, const State& state) {
  Matrix3d from;
  Matrix3d to;
  for (std::size_t k = 0; k < 3; ++k) {
    from.col(static_cast<Eigen::Index>(k)) = first_place(model, k);
    to.col(static_cast<Eigen::Index>(k)) = place(model, state, k);
  }
  return to * from.inverse();
}

/// Semi-axes of the ellipsoid with the particles' second moments, radius^2/5 of a ball's mass; largest first.
Vector3d axes_of(const SpatialModel& model, const State& state) {
  Matrix3d moments = Matrix3d::Zero();
  Matrix3d at_first = Matrix3d::Zero();
  for (std::size_t k = 0; k < model.size(); ++k) {
    const double mass = model.particles().mass[k];
    const Vector3d r = place(model, state, k);
    const Vector3d r0 = first_place(model, k);
    moments += mass * r * r.transpose();
    at_first += mass * r0 * r0.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(moments / (at_first.trace() / 3));
  return solver.eigenvalues().reverse().cwiseSqrt();
}

struct Axes {
  std::vector<double> time;
  std::vector<std::vector<double>> computed, exact;  ///< [axis][instant]
};

struct Results {
  std::vector<double> tau, error;  ///< longest step first; largest distance from the exact place
  double beside_five = 0;          ///< of the particles from the motion of five
  double energy = 0;               ///< largest defects, the energy's over the kinetic energy
  double momentum = 0;
  double angular_momentum = 0;
  Axes axes;

  [[nodiscard]] double finest() const { return error.back(); }
};

Results compute(const Run& run) {
  const AffineEllipsoid drop = drop_of(run);
  const AffineEllipsoid::Instant first = drop.at(0);
  const double end = run.real("time");
  const AffineEllipsoid::Instant last = drop.at(end);
  SpatialModel many(gauss_particles::ball(1, static_cast<std::size_t>(run.integer("shells"))), SpatialFields());
  SpatialModel few(five(), SpatialFields());
  Results r;
  r.axes.computed.resize(3);
  r.axes.exact.resize(3);
  for (int level = 0; level <= halvings; ++level) {
    const long steps = longest_steps(run) << level;
    const double tau = end / static_cast<double>(steps);
    const bool finest = level == halvings;
    State state = start(many, first.rate);
    mechanics::OneStep<SpatialModel> step(many);
    mechanics::InvariantsWatch<SpatialModel> watch(many, state);
    const double kinetic = many.kinetic_energy(state.q, state.u);
    const long every = std::max(1L, steps / instants);
    for (long n = 1; n <= steps; ++n) {
      step.step(state, tau);
      if (!finest) continue;
      watch.record(state);
      if (n % every != 0) continue;
      r.axes.time.push_back(state.time);
      const Vector3d computed = axes_of(many, state);
      const Vector3d exact = drop.semi_axes(drop.at(state.time));
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        r.axes.computed[static_cast<std::size_t>(axis)].push_back(computed[axis]);
        r.axes.exact[static_cast<std::size_t>(axis)].push_back(exact[axis]);
      }
    }
    r.tau.push_back(tau);
    r.error.push_back(distance(many, state, last.deformation));
    if (finest) {
      State of_five = start(few, first.rate);
      mechanics::OneStep<SpatialModel> other(few);
      for (long n = 0; n < steps; ++n) other.step(of_five, tau);
      r.beside_five = distance(many, state, motion(few, of_five));
      r.energy = watch.ledger().largest_defect("energy") / kinetic;
      r.momentum = watch.ledger().largest_defect("momentum");
      r.angular_momentum = watch.ledger().largest_defect("angular_momentum");
    }
    run.progress(std::pow(0.5, halvings - level));
  }
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const AffineEllipsoid drop = drop_of(values);
  const AffineEllipsoid::Instant first = drop.at(0);
  const AffineEllipsoid::Instant last = drop.at(values.real("time"));
  const auto steps = static_cast<double>(longest_steps(values) << halvings);
  const double tau = values.real("time") / steps;
  const Claims<Results> claims = all.at(fmt::format("{} shells, tau = {:g}", values.integer("shells"), tau));
  const double rate = first.rate.norm() / std::numbers::sqrt2;
  const double stretch = last.deformation.norm();
  claims.only_if(rate * tau * (1 << halvings) <= 0.1, "the longest step is not short for the rates of the motion")
      .check(
          {.id = "order",
           .text = "The error is that of the steps, of second order.",
           .quantity = "order of the largest distance from the exact places",
           .source = source},
          [](const Results& r) { return evidence::observed_order(r.tau, r.error); },
          evidence::Order{.theory = 2,
                          .tolerance = 0.05,
                          .reason = "nothing else errs, and the next term is the square of rate times step, a "
                                    "hundredth, of the first; fewer than five of them on the shortest steps"});
  claims.check(
      {.id = "places",
       .text = "The particles are where they should be.",
       .quantity = "largest distance from the exact places",
       .unit = "radius",
       .source = source},
      &Results::finest,
      evidence::Bound{std::pow(rate * tau, 2) / 24 * rate * values.real("time") * stretch,
                      "in each unit of time tau^2/24 times the third rate of the motion, what midpoints leave; "
                      "grown as the ellipsoid"});
  claims.check({.id = "particles",
                .text = "Where a particle is does not depend on how many there are.",
                .quantity = "largest distance from the motion of five particles",
                .unit = "radius",
                .source = source},
               &Results::beside_five,
               evidence::Roundoff{.operations = 16 * steps,
                                  .scale = stretch,
                                  .reason = "a projection of some sixteen roundings in each step, of places as far as "
                                            "the ellipsoid is long"});
  const double mass = 4 * std::numbers::pi / 3;
  const double kinetic = mass / 10 * first.rate.squaredNorm();
  const auto kept = [&](const std::string& id, const std::string& what, double Results::*member, double scale,
                        const std::string& of_scale) {
    claims.check({.id = id,
                  .text = "The " + what + " is kept to round-off.",
                  .quantity = "largest defect",
                  .source = "Frank (1994), chapter 6, proposition 4"},
                 member,
                 evidence::Roundoff{.operations = 11 * steps,
                                    .scale = scale,
                                    .reason = "in each step the residuals of eleven fields; scale: " + of_scale});
  };
  kept("energy", "energy", &Results::energy, 1, "the kinetic energy, over which it is taken");
  kept("momentum", "momentum", &Results::momentum, std::sqrt(2 * kinetic * mass),
       "sqrt(2 K M), above the sum of m |u|");
  kept("angular_momentum", "angular momentum", &Results::angular_momentum, std::sqrt(2 * kinetic * mass / 5) * stretch,
       "sqrt(2 K I) with the moment of inertia at the end, above the sum of m |r| |u|");
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& axes = exhibit.figure("axes", "The ellipsoid", "Semi-axes: from the particles' second moments, and exact.")
                   .panel({.x = "t", .y = "semi-axis"});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes.points(axis == 0 ? "particles" : "", r.axes.time, r.axes.computed[axis], Role::computed);
    axes.line(axis == 0 ? "exact" : "", r.axes.time, r.axes.exact[axis], Role::exact);
  }
  auto& errors = exhibit.figure("errors", "Error of the places", "Largest distance from the exact place, at the end.")
                     .panel({.x = "tau", .y = "distance", .log_x = true, .log_y = true});
  errors.points("particles", r.tau, r.error, Role::computed);
  slope_guide(errors, 2, r.tau, r.error.back());
  exhibit.measure("largest_distance", r.error.back());
  exhibit.measure("beside_five", r.beside_five);
  exhibit.measure("energy_defect", r.energy);
  exhibit.measure("momentum_defect", r.momentum);
  exhibit.measure("angular_momentum_defect", r.angular_momentum);
}

}  // namespace

Case ellipsoid_gauss() {
  Case c;
  c.title = "A liquid ball becomes a turning ellipsoid, by free particles under Gauss's principle in space";
  c.source = source;
  c.tiers = {Tier::quick, Tier::full};
  const auto rate = [](const std::string& name, double value, const std::string& meaning) {
    return real(name, value, "1", {-5, 5}, "velocity gradient " + meaning + " at the beginning");
  };
  c.parameters = {
      rate("xx", 0.8, "du/dx"),
      rate("xy", -0.3, "du/dy"),
      rate("xz", 0.1, "du/dz"),
      rate("yx", 0.4, "dv/dx"),
      rate("yy", -0.2, "dv/dy; dw/dz = -du/dx - dv/dy,"),
      rate("yz", -0.2, "dv/dz"),
      rate("zx", 0.2, "dw/dx"),
      rate("zy", 0.1, "dw/dy"),
      integer("shells", {8, 12, 12}, {1, 40}, "of the ball; shell i has 6 i^2 particles"),
      real("tau", {0.005, 0.0025, 0.0025}, "1", {1e-4, 0.1}, "shortest of four time steps, at most"),
      real("time", 2.0, "1", {0.01, 10}, "end of the run"),
  };
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases::ellipsoid_gauss
