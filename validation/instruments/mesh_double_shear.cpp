#include "validation/instruments/mesh_double_shear.hpp"

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

/// Root of a weighted mean of squares.
class MeanSquare {
 public:
  void add(double weight, double square) {
    sum_ += weight * square;
    weight_ += weight;
  }
  [[nodiscard]] double root() const { return std::sqrt(sum_ / weight_); }

 private:
  double sum_ = 0;
  double weight_ = 0;
};

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

void advance_to_end(lagrangian_mesh_2d::Flow& flow, const DoubleShearRun& run) {
  march(flow, run.time, run.tau_over_h * run.spacing());
}

DoubleShearErrors errors_at_end(const lagrangian_mesh_2d::Flow& flow, const DoubleShearRun& run) {
  const lagrangian_mesh_2d::Mesh& mesh = flow.model().mesh();
  DoubleShearErrors errors;
  MeanSquare position;
  MeanSquare velocity;
  MeanSquare shape;
  Worst largest;
  Worst interior;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const DoubleShear::Sample s = run.motion.at(mesh.x[k], mesh.y[k], flow.time());
    const double dx = flow.x()[k] - s.x;
    const double dy = flow.y()[k] - s.y;
    const double du = flow.u()[k] - s.u;
    const double dv = flow.v()[k] - s.v;
    const double mass = flow.model().nodes().mass()[k];
    position.add(mass, dx * dx + dy * dy);
    velocity.add(mass, du * du + dv * dv);
    const Point place = lattice_place(mesh, k);
    const bool inside = std::abs(place.x) <= 0.5 && std::abs(place.y) <= 0.5;
    for (const double component : {dx, dy}) {
      largest.add(component);
      if (inside) interior.add(component);
    }
    if (k < mesh.node(0, mesh.rows) || std::abs(place.x) > judged_edge) continue;
    const TopEdge edge(run.motion.parameters(), flow.time(), flow.x()[k]);
    shape.add(1, std::pow(flow.y()[k] - edge.height, 2) / (1 + edge.slope * edge.slope));
  }
  MeanSquare lambda;
  const std::vector<double> pressure = flow.dynamic_pressure();
  const double tau = flow.time() / static_cast<double>(flow.steps());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const Point label = middle(mesh, cell);
    const double exact = run.motion.at(label.x, label.y, flow.time() - tau).pressure;
    lambda.add(flow.model().first_volumes()[cell], std::pow(pressure[cell] - exact, 2));
  }
  errors.position = largest.value();
  errors.interior = interior.value();
  errors.rms_position = position.root();
  errors.rms_velocity = velocity.root();
  errors.rms_lambda = lambda.root();
  errors.shape = shape.root();
  const EdgeSlip slips = edge_slip(flow, run);
  Worst slip;
  for (std::size_t i = 0; i < slips.label.size(); ++i) {
    if (std::abs(lattice_place(mesh, i).x) <= judged_edge) slip.add(slips.slip[i]);
  }
  errors.slip = slip.value();
  return errors;
}

DoubleShearErrors double_shear_errors(const DoubleShearRun& run) {
  lagrangian_mesh_2d::Flow flow = double_shear_flow(run);
  advance_to_end(flow, run);
  return errors_at_end(flow, run);
}

EdgeSlip edge_slip(const lagrangian_mesh_2d::Flow& flow, const DoubleShearRun& run) {
  const lagrangian_mesh_2d::Mesh& mesh = flow.model().mesh();
  EdgeSlip result;
  for (std::size_t i = 0; i <= mesh.columns; ++i) {
    const std::size_t k = mesh.node(i, mesh.rows);
    const DoubleShear::Sample s = run.motion.at(mesh.x[k], mesh.y[k], flow.time());
    const double slope = TopEdge(run.motion.parameters(), flow.time(), s.x).slope;
    result.label.push_back(mesh.x[k]);
    result.slip.push_back((flow.x()[k] - s.x + slope * (flow.y()[k] - s.y)) / std::hypot(1, slope));
  }
  return result;
}

double expected_slip(const DoubleShearRun& run, double label) {
  return 2 * run.spacing() * run.motion.parameters().pressure * label * (1 - std::cos(run.time));
}

}  // namespace seiche::validation
