#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/shallow_water/dispersive_surface.hpp"

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
    double depth = lattice.bottom ? 0 : lattice.depth;
    for (const std::size_t k : lattice.shape.corners(cell)) {
      if (lattice.bottom) depth = std::max(depth, -lattice.bottom->slope(lattice.x[k], lattice.y[k]).elevation);
    }
    if (!(depth > 0)) continue;
    const double s = depth * depth * square;
    fastest =
        std::max(fastest, settings.gravity * depth * square * (1 + settings.gamma * s) / (1 + settings.inertia * s));
  }
  return fastest > 0 ? 2 / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

constexpr double above = DispersiveSurface::above;
constexpr double below = DispersiveSurface::below;

constexpr double accuracy = 1e-8;  // of zeta - z, relative

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

WaterSurface::WaterSurface(plan_lattice::Shape shape, double gamma)
    : shape_(shape),
      gamma_(gamma),
      matrix_(shape.columns + 1, shape.rows + 1),
      push_(shape.columns + 1, shape.rows + 1),
      beyond_(shape.columns + 1, shape.rows + 1),
      surface_(shape.nodes()) {
  require_not_negative("gamma", gamma);
}

void WaterSurface::assemble(std::span<const double> volumes, mechanics::Input q) {
  matrix_.clear();
  std::ranges::fill(push_.values(), 0.0);
  double* const push = push_.data();
  for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
    const auto [c0, c1, c2, c3] = shape_.corners(cell);
    const Diagonals at(q, shape_, cell);
    const Vector3 a = at.a;
    const Vector3 b = at.b;
    const double area = at.area();
    // The energy's form in the differences of z along the diagonals 0-2 and 1-3.
    const double weight = gamma_ / 4 * std::pow(volumes[cell], 2) / std::pow(area, 3);
    const double first = weight * (b.x * b.x + b.y * b.y);
    const double second = weight * (a.x * a.x + a.y * a.y);
    const double both = -weight * (a.x * b.x + a.y * b.y);
    const double along_first = (above - below) * (first * a.z + both * b.z);
    const double along_second = (above - below) * (both * a.z + second * b.z);
    push[c0] -= along_first;
    push[c1] -= along_second;
    push[c2] += along_first;
    push[c3] += along_second;
    matrix_[matrix_.own][c0] += 0.25 * area + below * first;
    matrix_[matrix_.own][c1] += 0.25 * area + below * second;
    matrix_[matrix_.own][c2] += 0.25 * area + below * first;
    matrix_[matrix_.own][c3] += 0.25 * area + below * second;
    matrix_[matrix_.up_right][c0] -= below * first;
    matrix_[matrix_.up_left][c1] -= below * second;
    matrix_[matrix_.right][c0] += below * both;
    matrix_[matrix_.up][c1] -= below * both;
    matrix_[matrix_.right][c3] += below * both;
    matrix_[matrix_.up][c0] -= below * both;
  }
}

std::span<const double> WaterSurface::read(std::span<const double> volumes, mechanics::Input q) {
  const auto z = q.last(shape_.nodes());
  if (gamma_ == 0) {
    std::ranges::copy(z, surface_.begin());
    return surface_;
  }
  assemble(volumes, q);
  const auto multiply = [&](const linear::LatticeArray& in, linear::LatticeArray& out) {
    return matrix_.multiply_and_dot(in, out);
  };
  const auto precondition = [&](std::span<const double> residual, std::span<double> better, double) {
    const double* const own = matrix_[matrix_.own];
    for (std::size_t node = 0; node < better.size(); ++node) better[node] = residual[node] / own[node];
  };
  solver_.solve(multiply, precondition, push_, beyond_, {.tolerance = accuracy});
  for (std::size_t node = 0; node < surface_.size(); ++node) surface_[node] = z[node] + beyond_.data()[node];
  return surface_;
}

}  // namespace seiche::dispersive_shallow_water_2d

template class seiche::plan_lattice::LatticeFlow<seiche::dispersive_shallow_water_2d::Model>;
