// First data of the two-dimensional Lagrangian mesh from exact waves: what is exact, and how the rest converges.
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_initial_test {

using namespace lagrangian_mesh_2d;

const std::string source = "Frank (1994), chapter 2: first data";

/// A piece of a wave: its mesh and velocities, and what is known of it.
struct Piece {
  std::function<Mesh(std::size_t columns, std::size_t rows)> mesh;
  std::function<double(double)> elevation;
  lagrangian_mesh_2d::VelocityAt velocity;
  double kinetic, potential, area;
};

Piece solitary_piece(const exact::SolitaryWave& wave) {
  constexpr double half = 20;  // sech^2 tails there: 1e-13 of the energy
  const auto elevation = [&wave](double x) { return wave.elevation(x); };
  return {.mesh =
              [=](std::size_t columns, std::size_t rows) {
                return layer_mesh({.begin = -half,
                                   .end = half,
                                   .depth = wave.depth(),
                                   .columns = columns,
                                   .rows = rows,
                                   .elevation = elevation});
              },
          .elevation = elevation,
          .velocity =
              [&wave](Point r) {
                const exact::Velocity v = wave.velocity(r.x, r.y);
                return Point{v.u, v.v};
              },
          .kinetic = wave.kinetic_energy(),
          .potential = wave.potential_energy(),
          .area = 2 * half * wave.depth() + wave.mass()};
}

/// From one trough to the next, between sides that move with the water.
Piece stokes_piece(const exact::StokesWave& wave) {
  const double length = wave.wavelength();
  const auto elevation = [&wave](double x) { return wave.elevation(x); };
  const lagrangian_mesh_2d::VelocityAt velocity = [&wave](Point r) {
    const exact::Velocity v = wave.velocity(r.x, r.y);
    return Point{v.u, v.v};
  };
  return {.mesh =
              [=, &wave](std::size_t columns, std::size_t rows) {
                Mesh mesh = layer_mesh({.begin = -length / 2,
                                        .end = length / 2,
                                        .depth = wave.mean_depth(),
                                        .columns = columns,
                                        .rows = rows,
                                        .elevation = elevation});
                const PrescribedSide side{.position =
                                              [=](Point label, double time) {
                                                const Point v = velocity(label);
                                                return Point{label.x + time * v.x, label.y + time * v.y};
                                              },
                                          .velocity = [=](Point label, double) { return velocity(label); }};
                mesh.sides.left = side;
                mesh.sides.right = side;
                return mesh;
              },
          .elevation = elevation,
          .velocity = velocity,
          .kinetic = wave.kinetic_energy() * length,
          .potential = wave.potential_energy() * length,
          .area = wave.mean_depth() * length};
}

/// Largest relative difference of the columns' areas, by a quadrature of its own.
double unequal_columns(const Mesh& mesh, const Piece& piece, double depth) {
  std::vector<double> areas;
  for (std::size_t i = 0; i < mesh.columns; ++i) {
    const double from = mesh.x[i];
    const double half = 0.5 * (mesh.x[i + 1] - from);
    double area = 0;
    constexpr int parts = 8;
    for (int k = 0; k < parts; ++k) {
      const double middle = from + half * (2 * k + 1) / parts;
      area += half / parts *
              boost::math::quadrature::gauss<double, 15>::integrate(
                  [&](double s) { return depth + piece.elevation(middle + half / parts * s); }, -1, 1);
    }
    areas.push_back(area);
  }
  const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
  Worst worst;
  for (const double area : areas) worst.add(area / mean - 1);
  return worst.value();
}

struct Errors {
  double columns, area, kinetic, potential, change, interior_change;
};

Errors errors_of(const Piece& piece, double depth, std::size_t columns, std::size_t rows) {
  const Mesh mesh = piece.mesh(columns, rows);
  const Flow flow(mesh, piece.velocity);
  const Model& model = flow.model();
  const auto areas = model.first_volumes();
  Errors errors{.columns = unequal_columns(mesh, piece, depth),
                .area = std::abs(std::accumulate(areas.begin(), areas.end(), 0.0) / piece.area - 1),
                .kinetic = std::abs(model.kinetic_energy(flow.state().q, flow.state().u) / piece.kinetic - 1),
                .potential = std::abs(model.potential_energy(flow.state().q) / piece.potential - 1),
                .change = 0,
                .interior_change = 0};
  Worst speed, interior_change;
  double sum = 0, all = 0;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Point v = piece.velocity({mesh.x[k], mesh.y[k]});
    const double change = std::hypot(flow.u()[k] - v.x, flow.v()[k] - v.y);
    speed.add(std::hypot(v.x, v.y));
    const std::size_t row = k / (mesh.columns + 1);
    if (2 * row <= mesh.rows) interior_change.add(change);
    sum += change * change * model.nodes().mass()[k];
    all += (v.x * v.x + v.y * v.y) * model.nodes().mass()[k];
  }
  errors.change = std::sqrt(sum / all);
  errors.interior_change = interior_change.value() / speed.value();
  return errors;
}

void check_piece(Check& check, const std::string& id, const std::string& name, const Piece& piece, double depth,
                 std::size_t columns_per_row) {
  const Order linear{2, 0.1, "smooth wave; the coarsest mesh has four rows"};
  const Order square{2, 0.2, linear.reason};
  Largest unequal;
  refine(check, {.axis = "h2/depth", .sizes = widths(1, {4, 8, 16, 32}), .id = id, .title = name},
         {{id + "-area", name + ": the mesh's area is the water's, to second order.", linear},
          {id + "-kinetic", name + ": the mesh's kinetic energy is the water's, to second order.", square},
          {id + "-potential", name + ": the potential energy of the mesh converges to the exact one at second order.",
           linear},
          {id + "-projection", name + ": the projection changes the velocities by second order (L2 norm).", square},
          {id + "-projection-below",
           name + ": the projection changes the velocities in the lower half by second order (largest norm).", square}},
         [&](double height) {
           const std::size_t rows = cells_of(1, height);
           const Errors e = errors_of(piece, depth, columns_per_row * rows, rows);
           unequal.add(e.columns);
           return std::array{e.area, e.kinetic, e.potential, e.change, e.interior_change};
         });
  check.holds(id + "-columns: " + name + ": the columns hold equal areas of water.", {unequal.value()},
              Roundoff{10, static_cast<double>(32 * columns_per_row),
                       "both ends of a column are rounded positions, up to the tank's length, that is as many columns' "
                       "widths as there are"});
}

TEST_CASE("initial data of a mesh converge to the exact wave at second order", "[manufactured]") {
  Check check("lagrangian_mesh_initial", "First data of the two-dimensional mesh",
              "Surface and velocities of an exact solitary wave and of a wavelength of an exact Stokes wave between "
              "sides that move with the water, on meshes of 4 to 32 rows. Columns hold equal areas of water to "
              "round-off. The polygons' area, the energies after the projection on constant areas, and the changes by "
              "the projection converge at second order to the integrals of the waves.",
              source);
  const exact::SolitaryWave solitary(0.3);
  check_piece(check, "solitary", "Solitary wave, A = 0.3", solitary_piece(solitary), 1, 20);
  const exact::StokesWave stokes(0.1, 4, 1, 1);
  check_piece(check, "stokes", "Stokes wave, a = 0.1, wavelength 4", stokes_piece(stokes), 1, 2);
}

}  // namespace seiche::verification::lagrangian_mesh_initial_test
