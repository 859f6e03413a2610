#include "validation/breakwater/surface_modes.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "seiche/mechanics/step_parts.hpp"

namespace seiche::validation {
using Eigen::Index;
using lagrangian_mesh_2d::Model;

std::vector<SurfaceMode> surface_modes(Model& model) {
  const std::vector<double> rest = model.state().q;
  const std::size_t first = model.mesh().node(0, model.mesh().rows);
  const auto size = static_cast<Index>(model.mesh().columns + 1);
  const auto node = [&](Index i) { return first + static_cast<std::size_t>(i); };
  const auto vertical = [&](Index i) { return model.nodes().size() + node(i); };
  // Of the surface, with one of its nodes displaced.
  const auto forces = [&](Index displaced, double displacement) {
    std::vector<double> q = rest;
    q[vertical(displaced)] += displacement;
    model.linearise({}, q);
    std::vector<double> u(model.rates(), 0.0);
    model.kick(1, u);
    Eigen::VectorXd force(size);
    for (Index i = 0; i < size; ++i) force[i] = u[vertical(i)] / model.nodes().wy()[node(i)];
    return force;
  };
  // Accelerations of the surface under upward forces on it; the multipliers that keep the areas.
  std::vector<double> multipliers;
  const auto answer = [&](const Eigen::VectorXd& force) {
    std::vector<double> u(model.rates(), 0.0);
    for (Index i = 0; i < size; ++i) u[vertical(i)] = model.nodes().wy()[node(i)] * force[i];
    multipliers.assign(model.constraints(), 0.0);
    mechanics::Projection<Model>(model).project(u, {}, multipliers);
    Eigen::VectorXd acceleration(size);
    for (Index i = 0; i < size; ++i) acceleration[i] = u[vertical(i)];
    return acceleration;
  };

  // K, from forces that are linear in the elevations: the difference is exact but for rounding. No displacement may
  // tangle the lowest cell.
  const double displacement = std::ranges::min(model.first_volumes()) / (rest[first + 1] - rest[first]) / 8;
  Eigen::MatrixXd k(size, size);
  for (Index i = 0; i < size; ++i) k.col(i) = (forces(i, -displacement) - forces(i, displacement)) / (2 * displacement);
  model.linearise({}, rest);
  Eigen::MatrixXd c(size, size);
  for (Index i = 0; i < size; ++i) c.col(i) = answer(Eigen::VectorXd::Unit(size, i));
  // K and C are symmetric: with K = L L^T and eta = L^-T z,  L^T C L z = omega^2 z.
  const Eigen::LLT<Eigen::MatrixXd> root(k);
  const Eigen::MatrixXd lower = root.matrixL();
  const Eigen::MatrixXd product = c * lower;
  const Eigen::MatrixXd symmetric = lower.transpose() * product;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  std::vector<SurfaceMode> modes;
  for (Index m = 1; m < size; ++m) {
    const Eigen::VectorXd elevation = root.matrixU().solve(eigen.eigenvectors().col(m));
    const Eigen::VectorXd force = -k * elevation;
    answer(force);
    modes.push_back({.frequency = std::sqrt(eigen.eigenvalues()[m]),
                     .elevation = {elevation.begin(), elevation.end()},
                     .multipliers = multipliers});
  }
  return modes;
}

}  // namespace seiche::validation
