// Parts of the 2DH model that are known in closed form: volumes over a bottom, motion carried to another tangent
// plane, masses on a shore, the column that a moving window appends.
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/geometry/vector.hpp"
#include "seiche/lattice/water.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::parts_2dh_test {

using namespace dispersive_shallow_water_2d;

/// Over 0 < s, t < 1, by Gauss's rule of 7 x 7 points: exact for polynomials of degree 13 along each side.
template <class Integrand>
double integral_over_square(const Integrand& integrand) {
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  return Gauss::integrate(
      [&](double t) { return Gauss::integrate([&](double s) { return integrand(s, t); }, 0.0, 1.0); }, 0.0, 1.0);
}

/// int (z - b) dA over a cell with straight sides and the bilinear surface.
double water_in_cell(const Lattice& lattice, std::size_t cell) {
  const auto corners = lattice.shape.corners(cell);
  const auto mapped = [&](const std::vector<double>& v, double s, double t) {
    return (1 - s) * (1 - t) * v[corners[0]] + s * (1 - t) * v[corners[1]] + s * t * v[corners[2]] +
           (1 - s) * t * v[corners[3]];
  };
  const auto along_s = [&](const std::vector<double>& v, double t) {
    return (1 - t) * (v[corners[1]] - v[corners[0]]) + t * (v[corners[2]] - v[corners[3]]);
  };
  const auto along_t = [&](const std::vector<double>& v, double s) {
    return (1 - s) * (v[corners[3]] - v[corners[0]]) + s * (v[corners[2]] - v[corners[1]]);
  };
  return integral_over_square([&](double s, double t) {
    const double area = along_s(lattice.x, t) * along_t(lattice.y, s) - along_s(lattice.y, t) * along_t(lattice.x, s);
    const double bed = lattice.bottom->slope(mapped(lattice.x, s, t), mapped(lattice.y, s, t)).elevation;
    return area * (mapped(lattice.z, s, t) - bed);
  });
}

/// A bowl -1 + (x/10)^2 + (y/12)^2 - x y/200.
std::shared_ptr<const PlanBottom> bowl() {
  return polynomial_bottom({{-1, 0, 0}, {0.01, 2, 0}, {1.0 / 144, 0, 2}, {-0.005, 1, 1}});
}

/// A sheared lattice, 4 x 3 cells, its south side a slanted wall, the others free.
Lattice slanted_lattice() {
  using plan_lattice::FreeSide;
  Lattice lattice = rectangular_lattice({.end = 4,
                                         .north = 3,
                                         .columns = 4,
                                         .rows = 3,
                                         .sides = {.west = FreeSide{}, .east = FreeSide{}, .north = FreeSide{}},
                                         .bottom = bowl()});
  for (std::size_t k = 0; k < lattice.x.size(); ++k) lattice.y[k] += 0.5 * lattice.x[k];
  return lattice;
}

/// The unit normal of the bottom below node k.
Vector3 normal_at(const PlanBottom& bottom, std::span<const double> q, std::size_t k) {
  const auto b = bottom.slope(q[k], q[q.size() / 3 + k]);
  const double length = std::sqrt(1 + b.along_x * b.along_x + b.along_y * b.along_y);
  return {-b.along_x / length, -b.along_y / length, 1 / length};
}

TEST_CASE("volumes of cells of the 2DH model are the water between surface and bottom", "[manufactured]") {
  Check check("volumes_2dh", "Two-dimensional horizontal model: volumes over a bottom of degree four",
              "Volumes are integrals around the cells, by Gauss's rule of three points on each side, exact for bottoms "
              "of degree four. They are compared with integrals over the cells, by products of rules of seven points. "
              "8 x 8 cells perturbed at random from a rectangle.",
              "Frank, Discrete models of incompressible fluid (1994), chapters 3 and 4");
  Lattice lattice = jittered(rectangular_lattice({.end = 8,
                                                  .north = 8,
                                                  .columns = 8,
                                                  .rows = 8,
                                                  .elevation = [](double x, double y) { return 0.1 * std::sin(x + y); },
                                                  .bottom = quartic_bottom()}),
                             0.2, 3);
  const Model model(lattice);
  Worst worst;
  for (std::size_t cell = 0; cell < lattice.shape.cells(); ++cell) {
    worst.add(model.first_volumes()[cell] - water_in_cell(lattice, cell));
  }
  check.that("volume", "The volume of every cell is the integral of the depth.", "largest difference of a volume [m^3]",
             {worst.value()},
             Roundoff{40, 10,
                      "four sides of three points, each the bottom's integral along x, up to 8 deep and 8 long, times "
                      "a side of about one"});
}

TEST_CASE("a step over an uneven bottom transfers velocities without a change of energy", "[manufactured]") {
  Check check("carried_velocities_2dh", "Two-dimensional horizontal model: velocities carried to another tangent plane",
              "The bottom's normal under a node changes in a step by 0.1 to 0.4, much more than in a run. Free nodes "
              "are turned by the smallest rotation that takes one normal to the other: the components along both, and "
              "along the axis of the rotation, are retained. Nodes at a slanted wall conserve their energy.");
  Model model(slanted_lattice());
  mechanics::State state = model.state();
  const std::size_t n = model.nodes();
  const std::size_t columns = model.shape().columns;
  std::minstd_rand random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (double& u : state.u) u = uniform(random);
  // The wall: y = x/2.
  for (std::size_t k = 0; k <= columns; ++k) state.u[n + k] = 0.5 * state.u[k];
  const std::vector<double> before = state.u;
  std::vector<double> moved = state.q;
  for (std::size_t k = 0; k < n; ++k) {
    const double way = 4 + uniform(random);
    moved[k] += way;
    moved[n + k] += 0.5 * way;
    moved[2 * n + k] = 2;
  }
  model.linearise({0, 0}, state.q);
  std::vector<double> after = before;
  model.settle({0, 0}, moved, after);
  const PlanBottom& bottom = *model.lattice().bottom;
  Worst normal_part, axis_part, length, wall_energy, through_wall;
  for (std::size_t k = 0; k < n; ++k) {
    const auto from = normal_at(bottom, state.q, k), to = normal_at(bottom, moved, k);
    const Vector3 u{before[k], before[n + k], before[2 * n + k]}, v{after[k], after[n + k], after[2 * n + k]};
    if (k > columns) {
      const auto axis = cross(from, to);
      normal_part.add(dot(v, to) - dot(u, from));
      axis_part.add(dot(v, axis) - dot(u, axis));
      length.add(dot(v, v) - dot(u, u));
    } else {
      const double less = 1 - model.settings().inertia;
      const auto energy = [&](Vector3 w, Vector3 normal) { return dot(w, w) - less * dot(w, normal) * dot(w, normal); };
      wall_energy.add(energy(v, to) - energy(u, from));
      through_wall.add(v.y - 0.5 * v.x);
    }
  }
  all_hold(check, Roundoff{60, 3, "some sixty operations on squares that add up to 3"},
           {{"The velocity normal to the bed is preserved.", normal_part.value()},
            {"The velocity along the rotation axis is preserved.", axis_part.value()},
            {"The magnitude of the carried velocity is conserved.", length.value()},
            {"The energy at a slanted wall is conserved.", wall_energy.value()},
            {"The velocity component through the wall is zero.", through_wall.value()}});
}

TEST_CASE("nodes on a shore have the mass of a sixth of their cells", "[manufactured]") {
  Check check("shore_masses_2dh", "Two-dimensional horizontal model: masses on a shore",
              "A node on the shoreline has the mass that linear elements give it, a sixth of each of its cells; all "
              "others have a quarter. A canal between walls, 6 x 2 cells, shores at both ends.",
              "linear elements; shoreline.hpp");
  Lattice lattice = rectangular_lattice({.begin = -10, .end = 10, .north = 2, .columns = 6, .rows = 2});
  lattice.bottom = polynomial_bottom({{.coefficient = -1}, {.coefficient = 0.01, .x_power = 2}});
  lattice.sides.west = lattice.sides.east = plan_lattice::ShoreSide{};
  const Model model(lattice);
  std::vector<double> masses(lattice.shape.nodes(), 0.0);
  for (std::size_t cell = 0; cell < lattice.shape.cells(); ++cell) {
    for (const std::size_t k : lattice.shape.corners(cell)) {
      const bool on_shore = k % 7 % 6 == 0;
      masses[k] += model.first_volumes()[cell] * (on_shore ? 1.0 / 6 : 1.0 / 4);
    }
  }
  check.that("share", "Masses are the shares of the cells around.", "largest difference of a mass",
             {largest_difference(mechanics::Input(masses), model.node_masses())},
             Roundoff{8, 4, "four products added, of volumes up to 4"});
}

TEST_CASE("the bottom's energy under a moving shoreline", "[manufactured]") {
  Check check("shore_moment_2dh", "Two-dimensional horizontal model: the bottom's energy at a shoreline",
              "int b^2/2 over the area flooded by the nodes of a shore since the beginning, b linear along each edge. "
              "A canal 2 wide, 3 x 2 cells, its shore in the east. Over a plane bottom a shore that moves by d as a "
              "whole has flooded a wedge: 2 s^2 d^3/6. Over a bowl, with nodes that move independently, the integral "
              "over both parameters is taken by Gauss's rule of 7 x 7 points.",
              "closed form");
  const auto lattice_over = [](std::vector<PolynomialBottom::Term> terms) {
    Lattice lattice = rectangular_lattice({.end = 3, .north = 2, .columns = 3, .rows = 2});
    lattice.bottom = std::make_shared<PolynomialBottom>(std::move(terms));
    lattice.sides.east = plan_lattice::ShoreSide{};
    return lattice;
  };
  const auto places = [](const Lattice& lattice) { return lattice::joined({lattice.x, lattice.y, lattice.z}); };
  const Roundoff rounding{.operations = 60, .scale = 4, .reason = "sums of some sixty products, of terms up to 4"};

  const double slope = 0.4, way = 1.5;
  const Lattice plane = lattice_over({{.coefficient = -3 * slope}, {.coefficient = slope, .x_power = 1}});
  std::vector<double> q = places(plane);
  const Shoreline beach(plane.shape, plane.sides, plane.bottom, q);
  for (std::size_t j = 0; j <= 2; ++j) q[plane.shape.node(3, j)] += way;
  check.that("wedge", "A straight shore over a plane bottom has flooded a wedge.", "difference of the moments",
             {beach.bottom_moment(q) - 2 * slope * slope * way * way * way / 6}, rounding);

  const Lattice curved = lattice_over({{.coefficient = -0.9},
                                       {.coefficient = 0.1, .x_power = 2},
                                       {.coefficient = 0.05, .y_power = 2},
                                       {.coefficient = -0.08, .x_power = 1, .y_power = 1}});
  const std::vector<double> first = places(curved);
  const Shoreline shore(curved.shape, curved.sides, curved.bottom, first);
  const std::size_t nodes = curved.shape.nodes();
  std::vector<double> moved = first;
  const std::array<Point, 3> ways{Point{0.9, 0.2}, Point{-0.6, -0.1}, Point{0.4, -0.3}};
  for (std::size_t j = 0; j <= 2; ++j) {
    moved[curved.shape.node(3, j)] += ways[j].x;
    moved[nodes + curved.shape.node(3, j)] += ways[j].y;
  }
  double exact = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto marker = [&](std::size_t row, double s) {
      const std::size_t k = curved.shape.node(3, row);
      return Point{first[k] + s * ways[row].x, first[nodes + k] + s * ways[row].y};
    };
    const auto bed = [&](Point at) { return curved.bottom->slope(at.x, at.y).elevation; };
    exact += integral_over_square([&](double t, double s) {
      const Point p = marker(j, s), r = marker(j + 1, s);
      const double b = (1 - t) * bed(p) + t * bed(r);
      const Point sweep{(1 - t) * ways[j].x + t * ways[j + 1].x, (1 - t) * ways[j].y + t * ways[j + 1].y};
      return 0.5 * b * b * (sweep.x * (r.y - p.y) - sweep.y * (r.x - p.x));
    });
  }
  check.from("shoreline.hpp")
      .that("bowl", "The moment is the integral over both parameters; Gauss's three points are exact for a bowl.",
            "difference of the moments", {shore.bottom_moment(moved) - exact}, rounding);

  std::vector<double> forces(3 * nodes);
  shore.push(first, moved, 1, forces);
  double work = 0;
  for (std::size_t k = 0; k < 2 * nodes; ++k) work += forces[k] * (moved[k] - first[k]);
  check.from("discrete gradient; shoreline.hpp")
      .that("work", "The work of the mean force along a straight path equals the gain of the moment.",
            "difference of work and moment", {work - exact}, rounding);
}

TEST_CASE("a moving window appends still water of its own depth", "[manufactured]") {
  Check check("window_cells_2dh", "Two-dimensional horizontal model: the column that a window appends",
              "A mesh whose columns widen to the east, over a level bottom 2 deep and over an inclined one, is shifted "
              "by one column. The new cells hold still water as wide as the last column was, at rest; constraints are "
              "met, and masses agree with the cells. Over a level bottom a new cell is the copy of its neighbour: only "
              "the inclined bottom distinguishes them.");
  for (const bool inclined : {false, true}) {
    Lattice lattice = rectangular_lattice(
        {.end = 4, .north = 3, .columns = 4, .rows = 3, .sides = {.west = plan_lattice::HeldSide{}}, .depth = 2});
    for (double& x : lattice.x) x *= 1 + 0.1 * x;
    if (inclined) lattice.bottom = polynomial_bottom({{.coefficient = -2}, {.coefficient = 0.1, .x_power = 1}});
    const double east = lattice.x[4];
    const double width = lattice.x[4] - lattice.x[3];
    const double depth = inclined ? 2 - 0.1 * (east + 0.5 * width) : 2;
    Model model(std::move(lattice));
    mechanics::State state = model.state();
    model.shift_east(state);
    const auto volumes = model.first_volumes();
    Worst volume;
    for (std::size_t j = 0; j < 3; ++j) volume.add(volumes[4 * j + 3] - width * depth);
    std::vector<double> values(model.constraints());
    model.constraint_values(state.q, values);
    const double water = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    const std::string where = inclined ? "inclined-" : "level-";
    all_hold(check, Roundoff{60, 20, "volumes from positions up to 7 deep and wide, in some sixty operations"},
             {{where + "A new cell holds its width times the depth in its middle.", volume.value()},
              {where + "The shifted state meets its constraints.", worst(values)},
              {where + "The masses of the nodes are the water of the cells.", model.mass() - water}});
  }
}

}  // namespace seiche::verification::parts_2dh_test
