// Volumes and potential energy of the 2DH model: gradients against differences, and identities of the bilinear patch.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"

namespace seiche::verification::dispersive_2dh_gradients_test {

using namespace dispersive_shallow_water_2d;
using bilinear_patch::Corners;

/// 6 x 5 cells, uneven surface, off a rectangle at random; nothing holds them.
Lattice uneven_lattice(std::shared_ptr<const PlanBottom> bottom) {
  Rectangle water{.begin = 3, .end = 7, .south = 1, .north = 4, .columns = 6, .rows = 5, .bottom = std::move(bottom)};
  water.elevation = [](double x, double y) { return 0.2 * std::sin(1.7 * x) * std::cos(2.1 * y + 1); };
  water.sides = free_square().sides;
  return jittered(rectangular_lattice(water), 0.1, 5);
}

constexpr double difference_step = 1e-4;

/// Calls visit(i, above, below) with what `of` gives beside the state of the model, on either side along coordinate i.
template <class Of, class Visit>
void beside(const mechanics::State& state, const Of& of, const Visit& visit) {
  std::vector<double> q = state.q;
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = state.q[i] + difference_step;
    const auto above = of(q);
    q[i] = state.q[i] - difference_step;
    const auto below = of(q);
    q[i] = state.q[i];
    visit(i, above, below);
  }
}

/// Largest difference between J and the differences of the volumes, over all cells and coordinates.
double volume_gradient_error(Model& model) {
  const mechanics::State state = model.state();
  std::vector<double> unit(model.rates(), 0.0), rates(model.constraints());
  model.linearise({0, 0}, state.q);
  const auto volumes = [&](const std::vector<double>& q) {
    std::vector<double> values(model.constraints());
    model.constraint_values(q, values);
    return values;
  };
  Worst worst;
  beside(state, volumes, [&](std::size_t i, const auto& above, const auto& below) {
    unit[i] = 1;
    model.constraint_rates(unit, rates);
    unit[i] = 0;
    for (std::size_t s = 0; s < rates.size(); ++s) {
      worst.add(rates[s] - (above[s] - below[s]) / (2 * difference_step));
    }
  });
  return worst.value();
}

/// The same for forces and differences of the potential energy. Over a level bottom W is diagonal without sides: m kick
/// is the force.
double force_error(Model& model) {
  const mechanics::State state = model.state();
  model.linearise({0, 0}, state.q);
  std::vector<double> kick(model.rates(), 0.0);
  model.kick(1, kick);
  const std::size_t n = model.nodes();
  const auto energy = [&](const std::vector<double>& q) { return model.potential_energy(q); };
  Worst worst;
  beside(state, energy, [&](std::size_t i, double above, double below) {
    const double inertia = i < 2 * n ? 1 : model.settings().inertia;
    worst.add(kick[i] * model.node_masses()[i % n] * inertia + (above - below) / (2 * difference_step));
  });
  return worst.value();
}

/// Volume below the two triangles that a diagonal cuts from the patch.
double triangulated(const Corners& x, const Corners& y, const Corners& z, bool from_corner_0) {
  const std::array xs{x.c0, x.c1, x.c2, x.c3};
  const std::array ys{y.c0, y.c1, y.c2, y.c3};
  const std::array zs{z.c0, z.c1, z.c2, z.c3};
  const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
    const double twice_area = (xs[b] - xs[a]) * (ys[c] - ys[a]) - (ys[b] - ys[a]) * (xs[c] - xs[a]);
    return twice_area * (zs[a] + zs[b] + zs[c]) / 6;
  };
  return from_corner_0 ? triangle(0, 1, 2) + triangle(0, 2, 3) : triangle(1, 2, 3) + triangle(1, 3, 0);
}

/// int f(z) dA over the patch by Gauss's rule of three points each way: exact for f of degree two, z and the area
/// element being bilinear.
template <class Integrand>
double gauss(const Corners& x, const Corners& y, const Corners& z, const Integrand& f) {
  const double half = 0.5 * std::sqrt(0.6);
  const std::array<std::pair<double, double>, 3> rule{
      {{0.5 - half, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + half, 5.0 / 18}}};
  double sum = 0;
  for (const auto& [s, weight_s] : rule) {
    for (const auto& [t, weight_t] : rule) {
      const auto value = [&](const Corners& c) {
        return (1 - s) * (1 - t) * c.c0 + s * (1 - t) * c.c1 + s * t * c.c2 + (1 - s) * t * c.c3;
      };
      const auto along_s = [&](const Corners& c) { return (1 - t) * (c.c1 - c.c0) + t * (c.c2 - c.c3); };
      const auto along_t = [&](const Corners& c) { return (1 - s) * (c.c3 - c.c0) + s * (c.c2 - c.c1); };
      sum += weight_s * weight_t * (along_s(x) * along_t(y) - along_s(y) * along_t(x)) * f(value(z));
    }
  }
  return sum;
}

TEST_CASE("gradients of the 2DH model's volumes and energy agree with differences", "[conservation]") {
  Check check(
      "dispersive_2dh_gradients", "Two-dimensional horizontal model: gradients",
      "6 x 5 cells off a rectangle at random below a curved surface: every entry of the gradients of all volumes, over "
      "a level bottom, a polynomial one and a bump that is none, and the forces on all nodes, against central "
      "differences with steps of 1e-4. Volumes over a level bottom and the energy are polynomials of degree one and "
      "two in each coordinate: their differences have no error but rounding, 1e-16 of the volume over twice the step.");
  const auto claim = [&](const std::string& text, double value) {
    check.holds(text, {value},
                Bound{1e-9,
                      "differences: step^2/6 of the third derivatives of the bottom, 1e-9 of their 0.1, and roundings "
                      "of 1e-16 over 2e-4, 1e-12"});
  };
  Model level(uneven_lattice({}));
  Model polynomial(uneven_lattice(quartic_bottom()));
  Model bump(uneven_lattice(std::make_shared<BumpBottom>()));
  Model improved(uneven_lattice({}), {.inertia = 0.4, .gamma = 1.0 / 15});
  check.holds("Gradients of cell volumes over a level bottom equal differences.", {volume_gradient_error(level)},
              Roundoff{200, 0.4 / (2 * difference_step),
                       "over twice the step: two volumes of 0.4 in sixty operations each, and two positions up to 7 "
                       "whose rounding moves faces of 0.35, as much as eighty of these"});
  claim("Gradients of cell volumes over a polynomial bottom equal differences.", volume_gradient_error(polynomial));
  claim("Gradients of cell volumes over a bump equal differences.", volume_gradient_error(bump));
  check.holds("Gradients of the potential energy equal differences.", {force_error(level)},
              Roundoff{64, level.potential_energy(level.state().q) / (2 * difference_step),
                       "over twice the step: two sums over 30 cells, rounded up to the energy, and the positions"});
  claim("Gradients of the potential energy, improved dispersion included, equal differences.", force_error(improved));
}

TEST_CASE("a bilinear patch is the mean of its two triangulations and its integrals are exact", "[conservation]") {
  Check check("bilinear_patch_identities", "Bilinear patches: identities",
              "1000 quadrilaterals with random corners. The volume below a patch is the mean of those below the two "
              "pairs of triangles that its diagonals cut, and, like its moment, agrees with Gauss's rule of 3 x 3 "
              "points, which is exact for these integrands.");
  std::minstd_rand random(7);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  Worst mean, volume_error, moment_error;
  for (int n = 0; n < 1000; ++n) {
    const auto near = [&](double a, double b, double c, double d) {
      return Corners{a + uniform(random), b + uniform(random), c + uniform(random), d + uniform(random)};
    };
    const auto x = near(0, 1, 1, 0), y = near(0, 0, 1, 1), z = near(1, 1, 1, 1);
    const double volume = bilinear_patch::volume(x, y, z);
    mean.add(volume - 0.5 * (triangulated(x, y, z, true) + triangulated(x, y, z, false)));
    volume_error.add(volume - gauss(x, y, z, [](double at) { return at; }));
    moment_error.add(bilinear_patch::moment(x, y, z) - gauss(x, y, z, [](double at) { return at * at / 2; }));
  }
  const auto claim = [&](const std::string& text, double value) {
    check.holds(text, {value}, Roundoff{60, 1, "some 60 operations on numbers of size one"});
  };
  claim("The volume is the mean of the two triangulations.", mean.value());
  claim("The volume under a bilinear patch equals the integral by quadrature.", volume_error.value());
  claim("The first moment of a bilinear patch equals the integral by quadrature.", moment_error.value());
}

}  // namespace seiche::verification::dispersive_2dh_gradients_test
