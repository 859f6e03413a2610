#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mesh/mesh_linear_modes.hpp"
#include "verification/check.hpp"
#include "verification/dispersion/tank_frequencies.hpp"

namespace seiche::verification::lagrangian_mesh_dispersion_test {

using namespace lagrangian_mesh_2d;
using exact::LagrangianMeshDispersion, exact::SurfaceInertia;

constexpr double pi = std::numbers::pi;

struct Tank {
  std::size_t columns, rows;
  double length, depth, gravity;
  SurfaceInertia inertia;

  [[nodiscard]] std::string name() const {
    return fmt::format("{}x{}{}", columns, rows, inertia == SurfaceInertia::tuned ? "-tuned" : "");
  }
  [[nodiscard]] LagrangianMeshDispersion law() const {
    return {gravity, depth, length / static_cast<double>(columns), rows, inertia};
  }
  [[nodiscard]] Model model() const {
    return Model(layer_mesh({.end = length, .depth = depth, .columns = columns, .rows = rows}),
                 {.gravity = gravity, .density = 1.3, .tuned_surface_inertia = inertia == SurfaceInertia::tuned});
  }
  /// Of the wave with m half-waves in the tank.
  [[nodiscard]] double wavenumber(std::size_t m) const { return pi * static_cast<double>(m) / length; }
};

TEST_CASE("the linearised mesh has the frequencies of the closed form", "[dispersion]") {
  Check check(
      "dispersion_lagrangian_mesh", "Dispersion of the two-dimensional Lagrangian mesh",
      "The model is linearised about still water by its own calls: forces, constraints, masses. The eigenvalues of "
      "that matrix are the frequencies of the tank, from one half-wave to the shortest, $k h_1 = \\pi$. They agree "
      "with the closed form. All other modes are motionless: vortices, among them the hourglass motions.");
  auto& figure = check.figure("frequencies", "Frequencies of six meshes",
                              "Lines: closed form. Circles: eigenvalues of the linearised model.");
  auto& panel = figure.panel({.x = "k H", .y = "omega sqrt(H/g)"});
  const std::array tanks{Tank{6, 2, 6, 1, 1, SurfaceInertia::nodal}, Tank{8, 3, 5, 1, 1, SurfaceInertia::nodal},
                         Tank{5, 1, 6, 1, 1, SurfaceInertia::nodal}, Tank{12, 5, 3, 0.7, 9.81, SurfaceInertia::nodal},
                         Tank{8, 3, 5, 1, 1, SurfaceInertia::tuned}, Tank{5, 1, 6, 1, 1, SurfaceInertia::tuned}};
  for (const Tank& tank : tanks) {
    Model model = tank.model();
    const LagrangianMeshDispersion law = tank.law();
    const validation::LinearModes modes = validation::linear_modes(model, law.row_height() / 32);
    std::vector<double> wavenumbers, expected;
    for (std::size_t m = 1; m <= tank.columns; ++m) {
      wavenumbers.push_back(tank.wavenumber(m));
      expected.push_back(law.frequency(wavenumbers.back()));
    }
    draw_law(panel, tank.name(), tank, 200, [&](double k) { return law.frequency(k); });
    // Frequencies of short waves need not ascend.
    std::vector<double> sorted = expected;
    std::sort(sorted.begin(), sorted.end());
    check.holds("waves-" + tank.name() + ": " +
                    fmt::format("The {} mesh has one wave per column, and otherwise no frequency.", tank.name()),
                {static_cast<double>(modes.frequencies.size())},
                Bound{0, "only the surface has potential energy; one equation for all its nodes: the water's volume",
                      static_cast<double>(tank.columns)});
    Worst worst;
    for (std::size_t m = 0; m < std::min(sorted.size(), modes.frequencies.size()); ++m) {
      worst.add(modes.frequencies[m] / sorted[m] - 1);
    }
    check.holds(fmt::format("The frequencies of the {} mesh agree with the closed form.", tank.name()), {worst.value()},
                Roundoff{6.0 * static_cast<double>((tank.columns + 1) * (tank.rows + 1)),
                         0.5 * std::pow(sorted.back() / sorted.front(), 2),
                         "two products with the basis and the reflections of the eigenvalues' solution round an entry "
                         "once per coordinate, two on each node; entries are of the size of the largest omega^2, to "
                         "which the lowest is compared, and a root has half the error. Forces are linear in elevations "
                         "from rest: their rounding is relative"});
    std::vector<double> places, found;
    for (std::size_t m = 0; m < tank.columns; ++m) {
      const auto rank = std::lower_bound(sorted.begin(), sorted.end(), expected[m]) - sorted.begin();
      places.push_back(wavenumbers[m] * tank.depth);
      found.push_back(modes.frequencies.at(static_cast<std::size_t>(rank)) / std::sqrt(tank.gravity / tank.depth));
    }
    panel.points("eigenvalues", places, found, Role::data);
    CHECK(modes.asymmetry < 1e-11);
  }
}

}  // namespace seiche::verification::lagrangian_mesh_dispersion_test
