#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "verification/check.hpp"
#include "verification/dispersion/long_waves.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_law_test {

using exact::LagrangianMeshDispersion, exact::SurfaceInertia;

constexpr double pi = std::numbers::pi;
const std::string source = "Frank, Discrete models of incompressible fluid (1994), ch. 2; closed form of its rows";

TEST_CASE("the law of the Lagrangian mesh has the known limits", "[dispersion]") {
  Check check("exact_lagrangian_mesh_dispersion", "Dispersion law of the two-dimensional Lagrangian mesh",
              "The coefficient of long waves for both surface inertias, and second order in the cells' size.", source);
  for (const std::size_t rows : {1UL, 2UL, 5UL, 40UL}) {
    for (const SurfaceInertia inertia : {SurfaceInertia::nodal, SurfaceInertia::tuned}) {
      const bool tuned = inertia == SurfaceInertia::tuned;
      const std::string name = fmt::format("{}-{}", tuned ? "tuned" : "nodal", rows);
      const LagrangianMeshDispersion law(1, 1, 0.3, rows, inertia);
      const double h2 = law.row_height();
      check.holds("long-" + name + ": " +
                      fmt::format("Long waves on {} rows, {} inertia: omega^2 = k^2 (1 - c k^2), c = {}.", rows,
                                  tuned ? "tuned" : "nodal", tuned ? "1/3" : "1/3 + h2^2/6"),
                  {long_wave_coefficient([&](double k) { return law.phase_speed(k); })},
                  Bound{1e-6, "extrapolation leaves the product of the three k^2, 1e-6, times a coefficient below 1",
                        1.0 / 3 + (tuned ? 0 : h2 * h2 / 6)});
    }
  }
  refine(
      check, {"h1 = h2", widths(1, {32, 64, 128, 256, 512})},
      {{"order",
        "The law tends to Airy's with the square of the cells' size.",
        {2, 0.05, "expansion of the law in even powers; the next is of the size (k h)^2, at most 0.004, beside it"}}},
      [](double h) {
        const double k = 2 * pi / 3, airy = exact::AiryDispersion(1, 1).frequency(k);
        return std::abs(LagrangianMeshDispersion(1, 1, h, cells_of(1, h)).frequency(k) / airy - 1);
      });
  CHECK_THROWS_AS(LagrangianMeshDispersion(1, 1, 0.3, 0), std::invalid_argument);
  CHECK_THROWS_AS(LagrangianMeshDispersion(1, 1, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(LagrangianMeshDispersion(1, 1, 0.5, 2).frequency(2.001 * pi), std::invalid_argument);
  CHECK_THROWS_AS(LagrangianMeshDispersion(1, 1, 0.5, 2).frequency(0), std::invalid_argument);
}

}  // namespace seiche::verification::lagrangian_mesh_law_test
