#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// 2/omega with omega^2 = g H K^2 (1 + gamma H^2 K^2)/(1 + alpha H^2 K^2), K^2 = 4/h1^2 + 4/h2^2 of the narrowest cell:
/// K is larger than that of any mode, and the factor G < 1 of the dispersion law is left out.
double surely_stable_step(const Model& model) {
  const Lattice& lattice = model.lattice();
  const Settings& settings = model.settings();
  double fastest = 0;
  for (std::size_t cell = 0; cell < lattice.shape.cells(); ++cell) {
    const auto [c0, c1, c2, c3] = lattice.shape.corners(cell);
    const double h1 = std::hypot(lattice.x[c1] - lattice.x[c0], lattice.y[c1] - lattice.y[c0]);
    const double h2 = std::hypot(lattice.x[c3] - lattice.x[c0], lattice.y[c3] - lattice.y[c0]);
    const double square = 4 / (h1 * h1) + 4 / (h2 * h2);
    double depth = 0;
    for (const std::size_t k : lattice.shape.corners(cell)) {
      depth = std::max(depth, -lattice.bed(lattice.x[k], lattice.y[k]));
    }
    if (!(depth > 0)) continue;
    const double s = depth * depth * square;
    fastest =
        std::max(fastest, settings.gravity * depth * square * (1 + settings.gamma * s) / (1 + settings.inertia * s));
  }
  return fastest > 0 ? 2 / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

}  // namespace

Flow::Flow(Lattice lattice, const InitialVelocity& velocity, Scheme scheme, Settings settings, Forcing forcing,
           Window window, bool smooth_start)
    : LatticeFlow(scheme, window) {
  auto model = std::make_unique<Model>(std::move(lattice), settings, std::move(forcing));
  require_that(!window.reach || !model->has_shoreline(), "a moving window with a shoreline; allowed: one of them");
  require_that(!window.reach || !model->absorbs(), "a moving window with absorption; allowed: one of them");
  begin_between(model->lattice().sides, model->shape(), std::move(model), model->state(velocity),
                surely_stable_step(*model), smooth_start && !model->has_driven_sides());
}

}  // namespace seiche::dispersive_shallow_water_2d

template class seiche::plan_lattice::LatticeFlow<seiche::dispersive_shallow_water_2d::Model>;
