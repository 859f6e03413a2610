// Volumes of trilinear hexahedra, their gradients, and the matrix built from them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "seiche/linear/cosine_lattice.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"

namespace seiche::verification::hexahedron_test {

using namespace lagrangian_mesh_3d;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 4.1";

double determinant(Vector a, Vector b, Vector c) {
  return dot(a, cross(b, c));
}

CellCorners random_cell(std::minstd_rand& random) {
  std::uniform_real_distribution<double> uniform(-0.25, 0.25);
  CellCorners cell{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  for (Vector& r : cell) r = r + Vector{uniform(random), uniform(random), uniform(random)};
  return cell;
}

/// Volume inside the faces, each the mean of its two cuts into triangles.
double volume_of_cut_faces(const CellCorners& r) {
  constexpr std::array<std::array<std::size_t, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  double sum = 0;
  for (const auto& [a, b, c, d] : faces) {
    sum += determinant(r[a], r[b], r[c]) + determinant(r[a], r[c], r[d]) + determinant(r[a], r[b], r[d]) +
           determinant(r[b], r[c], r[d]);
  }
  return sum / 12;
}

/// Volume of the trilinear map by Gauss's rule of two points along each axis, exact for its cubic Jacobian.
double volume_by_quadrature(const CellCorners& r) {
  const double g = 1 / std::sqrt(3.0);
  double sum = 0;
  for (const double xi : {-g, g}) {
    for (const double eta : {-g, g}) {
      for (const double zeta : {-g, g}) {
        std::array<Vector, 3> tangent{};
        constexpr std::array<std::array<int, 3>, 8> sign{
            {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
        for (std::size_t a = 0; a < 8; ++a) {
          const auto [sx, sy, sz] = sign[a];
          const std::array weight{sx * (1 + sy * eta) * (1 + sz * zeta) / 8, sy * (1 + sx * xi) * (1 + sz * zeta) / 8,
                                  sz * (1 + sx * xi) * (1 + sy * eta) / 8};
          for (std::size_t axis = 0; axis < 3; ++axis) tangent[axis] = tangent[axis] + weight[axis] * r[a];
        }
        sum += determinant(tangent[0], tangent[1], tangent[2]);
      }
    }
  }
  return sum;
}

TEST_CASE("the volume of a hexahedron equals the trilinear map's and the mean over the cuts of its faces",
          "[geometry]") {
  Check check("hexahedron_volume", "Volume of a hexahedron",
              "1000 random hexahedra, the corners of a unit cube moved by up to 1/4 along each axis.", source);
  std::minstd_rand random(1);
  Worst cuts, quadrature;
  for (int n = 0; n < 1000; ++n) {
    const CellCorners cell = random_cell(random);
    const double volume = hexahedron_volume(cell);
    cuts.add(volume - volume_of_cut_faces(cell));
    quadrature.add(volume - volume_by_quadrature(cell));
  }
  const Roundoff rounding{.operations = 200, .scale = 1, .reason = "some 200 products and sums of numbers up to 1"};
  check.that("cuts", "The volume of a hexahedron is the mean over the two ways to cut its faces.",
             "largest difference of volumes", {cuts.value()}, rounding);
  check.that("trilinear", "The volume of a hexahedron equals that under the trilinear map.",
             "largest difference of volumes", {quadrature.value()}, rounding);
}

TEST_CASE("gradients of volumes and of the potential energy agree with differences", "[geometry]") {
  Check check("hexahedral_mesh_gradients", "Gradients of the hexahedral mesh",
              "A random mesh of 12 x 10 x 2 cells under a hump, moved along random velocities: rates of the volumes "
              "and the power of gravity against central differences of volumes and potential energy. $J$ is the "
              "derivative, and $A$ is $J W J^T$.",
              source);
  using plan_lattice::FreeSide;
  Mesh mesh = layer_mesh({.end = 6,
                          .north = 5,
                          .columns = 12,
                          .rows = 10,
                          .layers = 2,
                          .elevation = [](double x, double y) { return 0.3 * std::exp(-0.3 * (x * x + y * y)); },
                          .sides = {.north = FreeSide{}},
                          .south_wall = [](double x) { return x < 3 ? 0.0 : 0.4 * (x - 3); }});
  Model model(jittered(std::move(mesh), 0.05, 1));
  std::minstd_rand random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const mechanics::State state = model.state([&](Place) {
    return Vector{uniform(random), uniform(random), uniform(random)};
  });
  model.linearise({0, 0}, state.q);
  const std::size_t n = model.nodes().size();
  const std::size_t cells = model.constraints();
  const double h = 1e-3;
  std::vector<double> rates(cells);
  model.constraint_rates(state.u, rates);
  const auto place_after = [&](double time) {
    std::vector<double> q(state.q.size());
    model.advance(state.q, state.u, time, q);
    return q;
  };
  std::vector<double> volumes(cells), differences(cells);
  model.constraint_values(place_after(h), volumes);
  model.constraint_values(place_after(-h), differences);
  // The difference of a cubic along a line leaves its third derivative: h^2 V(u), known exactly.
  for (std::size_t s = 0; s < cells; ++s) {
    const auto corners = model.mesh().corners(s);
    CellCorners moving;
    for (std::size_t a = 0; a < 8; ++a) moving[a] = vector_at(state.u, corners[a]);
    differences[s] = (volumes[s] - differences[s]) / (2 * h) - h * h * hexahedron_volume(moving) - rates[s];
  }
  check.that("volumes", "Rates of the volumes are their derivatives.", "largest difference of rates",
             {seiche::worst(differences)},
             Roundoff{100, 0.5 / h, "volumes up to 0.5 rounded in some 100 operations, over the displacement"});
  std::vector<double> kick(state.u.size(), 0.0);
  model.kick(1, kick);
  double power = 0;
  for (std::size_t i = 0; i < kick.size(); ++i) power += model.nodes().mass()[i % n] * kick[i] * state.u[i];
  const auto energy_after = [&](double time) { return model.potential_energy(place_after(time)); };
  const auto difference = [&](double step) { return (energy_after(step) - energy_after(-step)) / (2 * step); };
  // Richardson's extrapolation is exact for a quartic.
  const double extrapolated = (4 * difference(h) - difference(2 * h)) / 3;
  check.that(
      "potential", "The power of gravity is minus the rate of the potential energy.", "difference of powers",
      {power + extrapolated},
      Roundoff{120, model.potential_energy(state.q) / h, "energies of 120 patches rounded, over the displacement"});
  std::vector<double> mu(cells);
  std::ranges::generate(mu, [&] { return uniform(random); });
  std::vector<double> reaction(state.u.size(), 0.0);
  model.react(mu, reaction);
  model.constraint_rates(reaction, rates);
  linear::LatticeArray x(model.matrix().columns(), model.matrix().rows() * model.matrix().layers());
  linear::LatticeArray product = x;
  std::copy(mu.begin(), mu.end(), x.data());
  model.matrix().multiply_and_dot(x, product);
  for (std::size_t s = 0; s < cells; ++s) differences[s] = product.data()[s] - rates[s];
  check.that("matrix", "The assembled matrix is J W J^T, at a wall with a bend too.", "largest difference of A mu",
             {seiche::worst(differences)},
             Roundoff{27 * 24, seiche::worst(rates),
                      "27 coefficients of 24 products each, of numbers up to the largest of A mu"});
}

TEST_CASE("the symbol of the hexahedral mesh agrees with the assembled matrix", "[geometry]") {
  Check check("hexahedral_lattice_symbol", "Symbol of the undeformed hexahedral mesh",
              "7 x 5 x 3 boxes of 0.4 x 0.6 between walls, on a level bottom, density 1.3. Cosines between the walls "
              "times a power of the layer, for every pair of phases: the assembled matrix against the symbol.",
              source);
  const Model reference(layer_mesh({.end = 2.8, .north = 3, .depth = 1.5, .columns = 7, .rows = 5, .layers = 3}),
                        {.density = 1.3});
  Model model(reference.mesh(), reference.settings());
  const mechanics::State state = model.state();
  model.linearise({0, 0}, state.q);
  const auto symbol = linear::hexahedral_lattice(0.4, 0.6, {0.5, 0.5, 0.5}, 1.3);
  linear::LatticeArray x(model.matrix().columns(), model.matrix().rows() * model.matrix().layers());
  linear::LatticeArray product = x;
  Worst worst;
  Largest scale;
  for (std::size_t m = 0; m < 7; ++m) {
    for (std::size_t l = 0; l < 5; ++l) {
      const double theta = std::numbers::pi * static_cast<double>(m) / 7;
      const double psi = std::numbers::pi * static_cast<double>(l) / 5;
      std::array<double, 3> diagonal{};
      std::array<double, 2> off_diagonal{};
      symbol(theta, psi, diagonal, off_diagonal);
      constexpr std::array layer_values{1.0, -0.7, 0.4};
      const auto plan = [&](std::size_t c) {
        return std::cos(theta * (static_cast<double>(c % 7) + 0.5)) *
               std::cos(psi * (static_cast<double>(c / 7 % 5) + 0.5));
      };
      for (std::size_t c = 0; c < 105; ++c) x.data()[c] = layer_values[c / 35] * plan(c);
      model.matrix().multiply_and_dot(x, product);
      for (std::size_t c = 0; c < 105; ++c) {
        const std::size_t k = c / 35;
        double expected = diagonal[k] * layer_values[k];
        if (k > 0) expected += off_diagonal[k - 1] * layer_values[k - 1];
        if (k < 2) expected += off_diagonal[k] * layer_values[k + 1];
        worst.add(product.data()[c] - expected * plan(c));
        scale.add(diagonal[k]);
      }
    }
  }
  check.that("symbol", "A times a cosine is the symbol times the cosine.", "largest difference of A x", {worst.value()},
             Roundoff{27 * 24, scale.value(), "27 coefficients of 24 products each"});
}

TEST_CASE("every inverted corner of a cell is counted", "[geometry]") {
  std::minstd_rand random(5);
  std::uniform_real_distribution<double> stretch(1, 3);
  std::array<long, 9> times{};
  for (int k = 0; k < 2000; ++k) {
    CellCorners cell = random_cell(random);
    const double s = stretch(random);
    std::array<std::array<std::array<double, 2>, 4>, 3> places{};
    NodeVectors rows{};
    for (std::size_t a = 0; a < 8; ++a) {
      const auto [east, north, above] = lattice::place_of[a];
      cell[a] = {east + s * (cell[a].x - east), north + s * (cell[a].y - north), above + s * (cell[a].z - above)};
      const std::array place{cell[a].x, cell[a].y, cell[a].z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        places[axis][static_cast<std::size_t>(north + 2 * above)][static_cast<std::size_t>(east)] = place[axis];
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t row = 0; row < 4; ++row) rows[axis][row] = places[axis][row].data();
    }
    const auto inverted = std::ranges::count_if(corner_volumes(cell), [](double volume) { return volume <= 0; });
    CHECK(inverted_corners_of_row(1, rows) == static_cast<double>(inverted));
    ++times[static_cast<std::size_t>(inverted)];
  }
  CHECK((times[0] > 0 && times[1] > 0 && times[2] > 0));
}

}  // namespace seiche::verification::hexahedron_test
