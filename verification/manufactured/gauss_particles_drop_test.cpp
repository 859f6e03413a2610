// A disc that is stretched into an ellipse: free particles against Dirichlet's solution.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_drop_test {

using namespace gauss_particles;
using namespace mechanics;
using exact::StretchingDrop;

/// Largest distance from the exact places at t = 2; the disc has radius 1, u = (x, -y).
template <template <class> class Step>
double error(const Particles& particles, double tau) {
  const StretchingDrop drop(1, 1, 1);
  Model model(particles, std::make_unique<PolynomialSpace>(), {.gravity = 0, .penalty = 0});
  State state = model.state([](Point r) { return Point{r.x, -r.y}; });
  Step<Model> step(model);
  for (long k = 0; k < std::lround(2 / tau); ++k) step.step(state, tau);
  Worst largest;
  for (std::size_t k = 0; k < model.size(); ++k) {
    largest.add(std::hypot(state.q[k] - drop.semi_axis(2) * particles.x[k],
                           state.q[model.size() + k] - drop.other_axis(2) * particles.y[k]));
  }
  return largest.value();
}

Particles four() {
  Particles particles;
  for (int k = 0; k < 4; ++k) {
    const double angle = 0.3 + k * std::numbers::pi / 2;
    particles.add(std::cos(angle), std::sin(angle), 1);
  }
  return particles;
}

TEST_CASE("particles with all linear fields follow Dirichlet's ellipse, however few", "[manufactured]") {
  Check check("gauss_particles_linear_fields", "Gauss-principle particles with linear fields: Dirichlet's ellipse",
              "With the five linear solenoidal fields and isotropic second moments the particles move on the exact "
              "paths except for the error in time: second-order with the conservative scheme, for 300 particles and "
              "for 4, first-order with Frank's projection scheme.",
              "Frank, Discrete models of incompressible fluid (1994), section 6.3; Dirichlet (1860)");
  const std::string reason =
      "time is the only source of error, and the next term is tau (projection scheme) or tau^2 of the first: 0.01 of "
      "an order over this range";
  refine(check, {"step", {0.04, 0.02, 0.01, 0.005}},
         {{"conservative", "Conservative scheme, 300 particles: second order.", {2, 0.01, reason}},
          {"four-particles", "Conservative scheme, 4 particles: second order.", {2, 0.01, reason}},
          {"projection-scheme", "Frank's projection scheme converges at first order in the step.", {1, 0.01, reason}}},
         [](double tau) {
           return std::array{error<OneStep>(disc(1, 10), tau), error<OneStep>(four(), tau),
                             error<ProjectedStep>(disc(1, 10), tau)};
         });
}

TEST_CASE("a step of the projection scheme moves freely, then takes up gravity", "[manufactured]") {
  Model model(four(), std::make_unique<PolynomialSpace>(), {.gravity = 2, .penalty = 0});
  State state = model.state([](Point) { return Point{1, 0.5}; });
  const std::vector<double> begin = state.q;
  ProjectedStep<Model> step(model);
  for (int k = 0; k < 2; ++k) step.step(state, 0.1);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(std::abs(state.q[k] - begin[k] - 0.2) < 1e-14);
    CHECK(std::abs(state.q[4 + k] - begin[4 + k] - (0.05 + 0.03)) < 1e-14);
    CHECK((std::abs(state.u[k] - 1) < 1e-14 && std::abs(state.u[4 + k] - 0.1) < 1e-14));
  }
}

TEST_CASE("a flow gives places and velocities in the order of its particles", "[manufactured]") {
  const Particles particles = four();
  const Flow flow(particles, std::make_unique<PolynomialSpace>(),
                  [](Point r) {
                    return Point{r.x + 2, -r.y - 1};
                  },
                  {.gravity = 0, .penalty = 0});
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK((flow.x()[k] == particles.x[k] && flow.y()[k] == particles.y[k]));
    CHECK(std::abs(flow.u()[k] - particles.x[k] - 2) < 1e-14);
    CHECK(std::abs(flow.v()[k] + particles.y[k] + 1) < 1e-14);
  }
}

}  // namespace seiche::verification::gauss_particles_drop_test
