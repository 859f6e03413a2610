#include "validation/instruments/mesh/mesh_double_shear.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

namespace {

lagrangian_mesh_2d::Mesh label_mesh(std::size_t n, double distortion) {
  constexpr double pi = std::numbers::pi;
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::free_patch(n, n, {-1, -1}, {1, 1});
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double x = mesh.x[k];
    const double y = mesh.y[k];
    mesh.x[k] += distortion * std::sin(pi * x) * std::cos(pi * y);
    mesh.y[k] += distortion * std::cos(pi * x) * std::sin(pi * y);
  }
  return mesh;
}

/// Where a node is in the undistorted square.
Point lattice_place(const lagrangian_mesh_2d::Mesh& mesh, std::size_t node) {
  const auto between = [](std::size_t index, std::size_t count) {
    return (2.0 * static_cast<double>(index) - static_cast<double>(count)) / static_cast<double>(count);
  };
  return {between(node % (mesh.columns + 1), mesh.columns), between(node / (mesh.columns + 1), mesh.rows)};
}

/// Label of a cell's middle: mean of its corners.
Point middle(const lagrangian_mesh_2d::Mesh& mesh, std::size_t cell) {
  Point mean;
  for (const std::size_t node : mesh.corners(cell)) {
    mean.x += 0.25 * mesh.x[node];
    mean.y += 0.25 * mesh.y[node];
  }
  return mean;
}

/// The top edge is the curve y = 1 + e2 sin t cos lx.
struct TopEdge {
  double height, slope;

  TopEdge(const DoubleShear::Parameters& motion, double t, double x)
      : height(1 + motion.second_amplitude * std::sin(t) * std::cos(motion.second_wavenumber * x)),
        slope(-motion.second_amplitude * motion.second_wavenumber * std::sin(t) *
              std::sin(motion.second_wavenumber * x)) {}
};

}  // namespace

lagrangian_mesh_2d::Flow double_shear_flow(const DoubleShearRun& run) {
  const auto force = [motion = run.motion](Point label, double time) {
    const DoubleShear::Sample s = motion.at(label.x, label.y, time);
    return Point{s.force_x, s.force_y};
  };
  const auto velocity = [&](Point label) {
    const DoubleShear::Sample s = run.motion.at(label.x, label.y, 0);
    return Point{s.u, s.v};
  };
  return lagrangian_mesh_2d::Flow(label_mesh(run.n, run.distortion), velocity, run.scheme, {.gravity = 0},
                                  {.body_force = force});
}

DoubleShearErrors double_shear_errors(const DoubleShearRun& run) {
  lagrangian_mesh_2d::Flow flow = double_shear_flow(run);
  march(flow, run.time, run.tau_over_h * run.spacing());
  const lagrangian_mesh_2d::Mesh& mesh = flow.model().mesh();
  DoubleShearErrors errors;
  Mean position, shape;
  Worst interior, slip;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const DoubleShear::Sample s = run.motion.at(mesh.x[k], mesh.y[k], flow.time());
    const double dx = flow.x()[k] - s.x;
    const double dy = flow.y()[k] - s.y;
    position.add(std::hypot(dx, dy), flow.model().nodes().mass()[k]);
    const Point place = lattice_place(mesh, k);
    const bool inside = std::abs(place.x) <= 0.5 && std::abs(place.y) <= 0.5;
    if (inside) interior.add(worst(std::array{dx, dy}));
    if (k < mesh.node(0, mesh.rows) || std::abs(place.x) > judged_edge) continue;
    const TopEdge edge(run.motion.parameters(), flow.time(), flow.x()[k]);
    shape.add((flow.y()[k] - edge.height) / std::hypot(1, edge.slope));
    const double slope = TopEdge(run.motion.parameters(), flow.time(), s.x).slope;
    slip.add((dx + slope * dy) / std::hypot(1, slope));
  }
  Mean lambda;
  const std::vector<double> pressure = flow.dynamic_pressure();
  const double tau = flow.time() / static_cast<double>(flow.steps());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const Point label = middle(mesh, cell);
    const double exact = run.motion.at(label.x, label.y, flow.time() - tau).pressure;
    lambda.add(pressure[cell] - exact, flow.model().first_volumes()[cell]);
  }
  errors.interior = interior.value();
  errors.rms_position = position.rms();
  errors.rms_lambda = lambda.rms();
  errors.shape = shape.rms();
  errors.slip = slip.value();
  return errors;
}

}  // namespace seiche::validation
