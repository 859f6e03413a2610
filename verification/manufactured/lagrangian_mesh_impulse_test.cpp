// Velocities that an impulsive pressure on the surface gives the two-dimensional Lagrangian mesh.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mesh/mesh_solitary_wave.hpp"
#include "verification/check.hpp"

namespace lagrangian_mesh_impulse_test {

using namespace seiche;
using namespace seiche::verification;

const std::string source = "Lamb, Hydrodynamics (1932), art. 11; Frank (1994), chapter 2";
constexpr double length = 40;

struct Errors {
  double lower_half = 0;  ///< of the velocities of nodes, over the largest speed
  double surface = 0;
  double kinetic = 0;  ///< relative
  double rates = 0;    ///< largest rate of a cell's area, over its area
};

Errors errors_of(const exact::SolitaryWave& wave, long rows) {
  const validation::PlacedWave placed{wave, length / 2};
  const lagrangian_mesh_2d::Mesh mesh =
      placed.mesh(length, {.column_width = 2 / static_cast<double>(rows), .rows = rows});
  const auto velocity =
      lagrangian_mesh_2d::impulsive_start(mesh, [&](double x) { return placed.surface_potential(x); });
  lagrangian_mesh_2d::Model model(mesh);
  const mechanics::State state = model.state(velocity);
  Errors errors;
  errors.kinetic = std::abs(model.kinetic_energy(state.q, state.u) / wave.kinetic_energy() - 1);
  model.linearise({}, state.q);
  std::vector<double> rates(mesh.cells());
  model.constraint_rates(state.u, rates);
  Worst fastest;
  for (std::size_t s = 0; s < rates.size(); ++s) fastest.add(rates[s] / model.first_volumes()[s]);
  errors.rates = fastest.value();
  Worst speed;
  Worst lower_half;
  Worst surface;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Point exact = placed.velocity({mesh.x[k], mesh.y[k]});
    speed.add(std::hypot(exact.x, exact.y));
    const double error = std::hypot(state.u[k] - exact.x, state.u[mesh.nodes() + k] - exact.y);
    const std::size_t row = k / (mesh.columns + 1);
    if (2 * row <= mesh.rows) lower_half.add(error);
    if (row == mesh.rows) surface.add(error);
  }
  errors.lower_half = lower_half.value() / speed.value();
  errors.surface = surface.value() / speed.value();
  return errors;
}

TEST_CASE("an impulse on the surface starts the potential flow of an exact wave", "[manufactured]") {
  Check check(
      "lagrangian_mesh_impulse", "A mesh set into potential flow by an impulse on its surface",
      "An impulsive pressure, minus the potential of a solitary wave of 0.3 depths on its surface, acts on meshes "
      "of 4 to 32 rows at rest. In the lower half the velocities are the wave's to second order, and so is the "
      "energy. At the surface they are so to first order only: a surface node feels the pressure half a cell "
      "below. This is what the mesh takes for potential flow; nodes started with the exact velocities slide over "
      "the row beneath for ever.");
  const exact::SolitaryWave wave(0.3);
  std::vector<double> h, lower_half, surface, kinetic;
  Largest rates;
  for (const long rows : {4, 8, 16, 32}) {
    const Errors errors = errors_of(wave, rows);
    h.push_back(1 / static_cast<double>(rows));
    lower_half.push_back(errors.lower_half);
    surface.push_back(errors.surface);
    kinetic.push_back(errors.kinetic);
    rates.add(errors.rates);
  }
  auto& panel =
      check.figure("impulse", "Velocities after an impulse on the surface", "Errors against the height of the cells.")
          .panel({.x = "h2/depth", .y = "relative error", .log_x = true, .log_y = true});
  const auto order = [&](const std::string& id, const std::string& text, const std::vector<double>& errors,
                         Order criterion) {
    check.that({.id = id, .text = text, .quantity = "observed order", .source = source}, observed_order(h, errors),
               criterion);
    panel.points(id, h, errors, Role::computed);
  };
  order("lower-half", "Velocities in the lower half agree with the wave, to second order.", lower_half,
        {2, 0.2, "smooth wave; the coarsest mesh has four rows"});
  order("energy", "The kinetic energy after the impulse converges at second order.", kinetic,
        {2, 0.2, "smooth wave; the coarsest mesh has four rows"});
  order("surface", "Velocities at the surface are so to first order.", surface,
        {1, 0.2, "a surface node feels the pressure half a cell below"});
  check.that(
      {.id = "areas",
       .text = "Rates of all cell areas after the impulse are zero to round-off.",
       .quantity = "largest rate of an area over the area",
       .unit = "sqrt(g/depth)",
       .source = source},
      {.value = rates.value(), .resolution = "4 to 32 rows"},
      Roundoff{10, 1300,
               "ten rounded terms; the impulse alone gives surface nodes speeds 2 phi/h2, up to 40, which the cells' "
               "reactions take back, and a rate over its area is a difference of speeds over h2 = 1/32"});
}

}  // namespace lagrangian_mesh_impulse_test
