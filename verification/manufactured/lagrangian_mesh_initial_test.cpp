// First data of the two-dimensional Lagrangian mesh from exact waves: what is exact, and how the rest converges.
#include <array>
#include <cmath>
#include <functional>
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

/// A piece of a wave of depth 1 about its crest: its velocities, and what is known of it.
struct Piece {
  double half;  ///< of its length
  bool moving_sides;
  std::function<double(double)> elevation;
  lagrangian_mesh_2d::VelocityAt velocity;
  double kinetic, potential, area;

  [[nodiscard]] Mesh mesh(std::size_t columns, std::size_t rows) const {
    Mesh mesh = layer_mesh({.begin = -half, .end = half, .columns = columns, .rows = rows, .elevation = elevation});
    if (moving_sides) {
      mesh.sides.left = mesh.sides.right =
          PrescribedSide{.position = [v = velocity](Point label, double time) { return label + time * v(label); },
                         .velocity = [v = velocity](Point label, double) { return v(label); }};
    }
    return mesh;
  }
};

template <class Wave>
lagrangian_mesh_2d::VelocityAt velocity_of(const Wave& wave) {
  return [&wave](Point r) {
    const exact::Velocity v = wave.velocity(r.x, r.y);
    return Point{v.u, v.v};
  };
}

Piece solitary_piece(const exact::SolitaryWave& wave) {
  constexpr double half = 20;  // sech^2 tails there: 1e-13 of the energy
  return {.half = half,
          .moving_sides = false,
          .elevation = [&wave](double x) { return wave.elevation(x); },
          .velocity = velocity_of(wave),
          .kinetic = wave.kinetic_energy(),
          .potential = wave.potential_energy(),
          .area = 2 * half + wave.mass()};
}

/// From one trough to the next, between sides that move with the water.
Piece stokes_piece(const exact::StokesWave& wave) {
  const double length = wave.wavelength();
  return {.half = length / 2,
          .moving_sides = true,
          .elevation = [&wave](double x) { return wave.elevation(x); },
          .velocity = velocity_of(wave),
          .kinetic = wave.kinetic_energy() * length,
          .potential = wave.potential_energy() * length,
          .area = length};
}

/// Largest relative difference of the columns' areas, by a quadrature of its own.
double unequal_columns(const Mesh& mesh, const Piece& piece) {
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
                  [&](double s) { return 1 + piece.elevation(middle + half / parts * s); }, -1, 1);
    }
    areas.push_back(area);
  }
  const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
  Worst worst;
  for (const double area : areas) worst.add(area / mean - 1);
  return worst.value();
}

/// Of the area, of kinetic and potential energy, and the projection's changes of velocities: the mean, and the largest
/// in the lower half; all relative.
std::array<double, 5> errors_of(const Piece& piece, const Mesh& mesh) {
  const Flow flow(mesh, piece.velocity);
  const Model& model = flow.model();
  const auto areas = model.first_volumes();
  Mean speeds, changes;
  Worst fastest, in_lower_half;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Point v = piece.velocity({mesh.x[k], mesh.y[k]});
    const double speed = std::hypot(v.x, v.y);
    const double change = std::hypot(flow.u()[k] - v.x, flow.v()[k] - v.y);
    fastest.add(speed);
    if (2 * (k / (mesh.columns + 1)) <= mesh.rows) in_lower_half.add(change);
    speeds.add(speed, model.nodes().mass()[k]);
    changes.add(change, model.nodes().mass()[k]);
  }
  return {std::abs(std::accumulate(areas.begin(), areas.end(), 0.0) / piece.area - 1),
          std::abs(model.kinetic_energy(flow.state().q, flow.state().u) / piece.kinetic - 1),
          std::abs(model.potential_energy(flow.state().q) / piece.potential - 1), changes.rms() / speeds.rms(),
          in_lower_half.value() / fastest.value()};
}

void check_piece(Check& check, const std::string& id, const std::string& name, const Piece& piece,
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
           const Mesh mesh = piece.mesh(columns_per_row * rows, rows);
           unequal.add(unequal_columns(mesh, piece));
           return errors_of(piece, mesh);
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
              "Frank (1994), chapter 2: first data");
  const exact::SolitaryWave solitary(0.3);
  check_piece(check, "solitary", "Solitary wave, A = 0.3", solitary_piece(solitary), 20);
  const exact::StokesWave stokes(0.1, 4, 1, 1);
  check_piece(check, "stokes", "Stokes wave, a = 0.1, wavelength 4", stokes_piece(stokes), 2);
}

}  // namespace seiche::verification::lagrangian_mesh_initial_test
