// A ball that flows into a rotating ellipsoid: free particles in space against Dirichlet's and Dedekind's solution.
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "seiche/exact/affine_ellipsoid.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/projected_step.hpp"
#include "seiche/models/gauss_particles/spatial_model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace gauss_particles_ellipsoid_test {

using namespace seiche::gauss_particles;
using namespace seiche::mechanics;
using namespace seiche::verification;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using seiche::Worst;
using seiche::evidence::Order;
using seiche::evidence::Roundoff;

const std::string source =
    "Dirichlet, J. reine angew. Math. 58 (1861) 181; Dedekind, ibid. 217; Frank (1994), chapter 6, proposition 4";

constexpr double end = 2;

/// Velocity gradient of the ball: strains and rotations about all axes.
Matrix3d first_gradient() {
  Matrix3d gradient;
  gradient << 0.6, -0.4, 0.1, 0.5, -0.2, -0.3, 0.2, 0.3, -0.4;
  return gradient;
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

template <template <class> class Step>
State flowed(SpatialModel& model, const Matrix3d& gradient, double tau) {
  State state = start(model, gradient);
  Step<SpatialModel> step(model);
  for (long k = 0; k < std::lround(end / tau); ++k) step.step(state, tau);
  return state;
}

/// Largest distance of a particle from where F takes it.
double distance(const SpatialModel& model, const State& state, const Matrix3d& f) {
  Worst worst;
  const SpatialParticles& at = model.particles();
  const std::size_t n = model.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3d to(state.q[k], state.q[n + k], state.q[2 * n + k]);
    worst.add((to - f * Vector3d(at.x[k], at.y[k], at.z[k])).norm());
  }
  return worst.value();
}

/// F that takes a tetrahedron's corners where they are.
Matrix3d motion(const SpatialModel& model, const State& state) {
  const SpatialParticles& at = model.particles();
  const std::size_t n = model.size();
  Matrix3d from;
  Matrix3d to;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    from.col(k) << at.x[i], at.y[i], at.z[i];
    to.col(k) << state.q[i], state.q[n + i], state.q[2 * n + i];
  }
  return to * from.inverse();
}

TEST_CASE("particles with all linear fields in space follow the ellipsoids of Dirichlet and Dedekind",
          "[manufactured]") {
  Check check(
      "gauss_particles_ellipsoid", "Free particles in space: the ellipsoids of Dirichlet and Dedekind",
      "A ball with strains and rotations about all axes becomes an ellipsoid that turns while the water turns in "
      "it. With the eleven linear solenoidal fields, rot A of quadratic A, the particles move on the exact "
      "paths but for the error in time: 546 particles as five. The transpose of a motion is a motion "
      "(Dedekind), step by step.");
  const Matrix3d f = seiche::exact::AffineEllipsoid(first_gradient()).at(end).deformation;
  SpatialModel many(ball(1, 6), SpatialFields());
  SpatialModel few(five(), SpatialFields());
  const std::vector<double> lengths{0.04, 0.02, 0.01, 0.005};
  std::vector<double> of_many;
  std::vector<double> of_few;
  std::vector<double> of_first;
  for (const double tau : lengths) {
    of_many.push_back(distance(many, flowed<OneStep>(many, first_gradient(), tau), f));
    of_few.push_back(distance(few, flowed<OneStep>(few, first_gradient(), tau), f));
    of_first.push_back(distance(few, flowed<ProjectedStep>(few, first_gradient(), tau), f));
  }
  const auto order = [&](const std::string& id, const std::string& text, const std::vector<double>& error,
                         double theory, double tolerance) {
    check.that({.id = id, .text = text, .quantity = "order of the largest distance at t = 2", .source = source},
               seiche::evidence::observed_order(lengths, error),
               Order{theory, tolerance,
                     "nothing else errs, and the next term is tau (projection scheme) or tau^2 of the first, times "
                     "rates up to 2"});
  };
  order("conservative", "Conservative scheme, 546 particles: second order.", of_many, 2, 0.01);
  order("five-particles", "Conservative scheme, five particles: second order.", of_few, 2, 0.01);
  order("projection-scheme", "Frank's projection scheme, five particles: first order.", of_first, 1, 0.1);

  const State there = flowed<OneStep>(few, first_gradient(), 0.02);
  const State back = flowed<OneStep>(few, first_gradient().transpose(), 0.02);
  check.that({.id = "dedekind",
              .text = "Dedekind's theorem holds for the steps: the transposed velocity gradient makes the transposed "
                      "motion.",
              .quantity = "largest entry of the difference of F and the other's transpose",
              .source = source},
             {.value = (motion(few, there) - motion(few, back).transpose()).cwiseAbs().maxCoeff(),
              .resolution = "five particles, tau = 0.02"},
             Roundoff{.operations = 100 * 16,
                      .scale = 4,
                      .reason = "a hundred steps of a projection of some sixteen roundings, of entries up to 4"});
}

TEST_CASE("energy and momenta of a drop in space are kept to round-off", "[manufactured]") {
  Check check(
      "gauss_particles_spatial_invariants", "Free particles in space: invariants",
      "The same ball, moving and under gravity, with velocities that are not linear: the reaction is orthogonal "
      "to the eleven linear fields, and energy, momentum and angular momentum are those of the free motion.");
  for (const double gravity : {0.0, 0.5}) {
    SpatialModel model(ball(1, 6), SpatialFields(), gravity);
    State state = model.state([](const SpatialModel::Vector& r) {
      const Vector3d v = first_gradient() * Vector3d(r[0], r[1], r[2]);
      return SpatialModel::Vector{v[0] + 0.3 * std::sin(2 * r[1]), v[1] + 0.2 * r[0] * r[2] - 0.4, v[2] + 0.1};
    });
    OneStep<SpatialModel> step(model);
    InvariantsWatch<SpatialModel> watch(model, state);
    const double kinetic = model.kinetic_energy(state.q, state.u);
    constexpr double tau = 0.01;
    constexpr int steps = 200;
    const auto first_momentum = model.momentum(state.q, state.u);
    Worst along_z;
    for (int k = 0; k < steps; ++k) {
      step.step(state, tau);
      watch.record(state);
      along_z.add(model.momentum(state.q, state.u)[2] - first_momentum[2] + model.mass() * gravity * state.time);
    }
    const std::string id = gravity > 0 ? "falling-" : "";
    const std::string text = gravity > 0 ? "Falling: " : "Without gravity: ";
    const auto kept = [&](const std::string& what, double defect) {
      check.that(
          {.id = id + what,
           .text = text + what + " is kept to round-off.",
           .quantity = "largest defect over the kinetic energy",
           .source = source},
          {.value = defect / kinetic, .resolution = "546 particles, tau = 0.01"},
          Roundoff{.operations = steps * 11,
                   .scale = 2,
                   .reason = "in each step the residuals of eleven fields, each a rounding of sums of magnitudes "
                             "of up to twice the kinetic energy (units of radius and time)"});
    };
    kept("energy", watch.ledger().largest_defect("energy"));
    kept("momentum-x", watch.ledger().largest_defect("momentum_x"));
    kept("momentum-y", watch.ledger().largest_defect("momentum_y"));
    kept("momentum-z", along_z.value());
    if (gravity == 0) kept("angular-momentum", watch.ledger().largest_defect("angular_momentum"));
  }
}

}  // namespace gauss_particles_ellipsoid_test
