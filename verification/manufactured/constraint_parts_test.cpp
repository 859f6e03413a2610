// What models with constraints say of them beyond their gradients: curvatures, and rates that walls leave.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::constraint_parts_test {

std::vector<double> random_rates(std::size_t count, unsigned seed) {
  std::minstd_rand random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> rates(count);
  std::ranges::generate(rates, [&] { return uniform(random); });
  return rates;
}

TEST_CASE("the curvature of a chain's links is bilinear in two velocities", "[mechanics]") {
  Check check("chain_curvature", "Curvature of the constraints of a chain",
              "Links are polynomials of degree two: $f(q + u + v) - f(q + u) - f(q + v) + f(q) = f''(u, v)$ exactly, "
              "for any two velocities.");
  for (const bool pinned : {true, false}) {
    rigid_chain::RigidChain chain({.masses = rigid_chain::alternating_masses(6), .pinned = pinned});
    const std::vector<double> q = random_rates(chain.coordinates(), 1);
    const std::vector<double> u = random_rates(chain.rates(), 2), v = random_rates(chain.rates(), 3);
    const auto values = [&](double a, double b) {
      std::vector<double> at = q;
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += a * u[i] + b * v[i];
      std::vector<double> f(chain.constraints());
      chain.constraint_values(at, f);
      return f;
    };
    const auto both = values(1, 1), first = values(1, 0), second = values(0, 1), none = values(0, 0);
    std::vector<double> curvature(chain.constraints());
    chain.curvature(u, v, curvature);
    Worst worst;
    for (std::size_t s = 0; s < curvature.size(); ++s) {
      worst.add(curvature[s] - (both[s] - first[s] - second[s] + none[s]));
    }
    check.holds(
        std::string(pinned ? "pinned" : "free") + ": The curvature is the mixed difference of the constraints.",
        {worst.value()},
        Roundoff{40, 54, "four values of ten operations, half a square of differences up to 6 in three coordinates"});
  }
}

TEST_CASE("areas change along curved walls according to their curvature", "[mechanics]") {
  using namespace lagrangian_mesh_2d;
  Check check("lagrangian_mesh_curvature", "Curvature of areas along a curved bottom",
              "Nodes slide on a bump, others move straight. Along that motion, with constant speeds $s'$, the rates of "
              "the areas grow by $f''(u, u)$: the part that is bilinear in the velocities of the nodes, and the bend "
              "of the curve for those that slide. Areas at five times, $h = 10^{-3}$ apart, give their second "
              "derivatives with an error of $h^4/90$ of the sixth, at most 10, and with roundings of areas over $h^2$.",
              "Taylor's theorem");
  Model model(layer_mesh({.end = 6,
                          .columns = 16,
                          .rows = 4,
                          .elevation = verification::cosine_elevation,
                          .bottom = verification::bump()}));
  const mechanics::State start = model.state(VelocityAt([](Point r) {
    return Point{0.3 + 0.2 * std::sin(r.x), 0.2 * std::cos(2 * r.x + r.y)};
  }));
  constexpr double h = 1e-3;
  const auto areas = [&](double time) {
    std::vector<double> q(start.q.size()), f(model.constraints());
    model.predict(start.q, start.u, time, q);
    model.constraint_values(q, f);
    return f;
  };
  const auto m2 = areas(-2 * h), m1 = areas(-h), now = areas(0), p1 = areas(h), p2 = areas(2 * h);
  model.linearise({0, 0}, start.q);
  std::vector<double> curvature(model.constraints());
  model.curvature(start.u, start.u, curvature);
  Worst worst;
  for (std::size_t s = 0; s < curvature.size(); ++s) {
    const double second = (-m2[s] + 16 * m1[s] - 30 * now[s] + 16 * p1[s] - p2[s]) / (12 * h * h);
    worst.add(curvature[s] - second);
  }
  check.that("areas", "Second derivatives of the cell areas agree with differences within 1e-9.", "largest difference",
             {worst.value()},
             Bound{1e-9,
                   "h^4/90 of a sixth derivative of 10 is 1e-13; areas of 0.1 rounded to 1e-17 in products of "
                   "positions up to 6, 1e-15, over h^2"});
}

TEST_CASE("nodes at a slanted wall retain the velocity along it", "[mechanics]") {
  using namespace lagrangian_mesh_3d;
  Check check("lagrangian_mesh_3d_slides", "What a slanted wall leaves of velocities",
              "A layer between walls whose south side is turned by 30 degrees. Its nodes retain the component of any "
              "velocity along the wall, and the vertical component above the bottom.");
  const double c = std::cos(std::acos(-1.0) / 6), s = 0.5;
  using plan_lattice::FreeSide;
  Mesh mesh = layer_mesh({.end = 4,
                          .north = 3,
                          .columns = 4,
                          .rows = 3,
                          .layers = 2,
                          .sides = {.west = FreeSide{}, .east = FreeSide{}, .north = FreeSide{}}});
  for (std::size_t k = 0; k < mesh.x.size(); ++k) {
    const double x = mesh.x[k], y = mesh.y[k];
    mesh.x[k] = c * x - s * y;
    mesh.y[k] = s * x + c * y;
  }
  const Model model(mesh);
  const Vector given{0.7, -0.4, 0.3};
  const mechanics::State state = model.state(VelocityAt([&](Place) { return given; }));
  const std::size_t n = mesh.x.size();
  const double along = c * given.x + s * given.y;
  Worst slid, free;
  for (std::size_t l = 0; l <= 2; ++l) {
    for (std::size_t i = 0; i <= 4; ++i) {
      const std::size_t k = mesh.node(i, 0, l);
      slid.add(state.u[k] - along * c);
      slid.add(state.u[n + k] - along * s);
      const std::size_t inside = mesh.node(i, 2, l);
      free.add(state.u[inside] - given.x);
      free.add(state.u[n + inside] - given.y);
    }
  }
  all_hold(check, Roundoff{20, 1, "a normal from rounded positions, a product with it, and its part"},
           {{"The component along the wall is unchanged.", slid.value()},
            {"Velocities of nodes inside the water are not changed by sliding walls.", free.value()}});
}

}  // namespace seiche::verification::constraint_parts_test
