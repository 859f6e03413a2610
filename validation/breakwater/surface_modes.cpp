#include "validation/breakwater/surface_modes.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "seiche/mechanics/step_parts.hpp"

namespace seiche::validation {
namespace {

using Eigen::Index;
using lagrangian_mesh_2d::Model;

class SurfaceResponse {
 public:
  explicit SurfaceResponse(Model& model)
      : model_(model),
        rest_(model.state().q),
        first_(model.mesh().node(0, model.mesh().rows)),
        size_(static_cast<Index>(model.mesh().columns + 1)) {}

  /// K, from forces that are linear in the elevations: the difference is exact but for rounding.
  [[nodiscard]] Eigen::MatrixXd stiffness() {
    const double displacement = lowest_cell() / 8;
    Eigen::MatrixXd k(size_, size_);
    for (Index column = 0; column < size_; ++column) {
      k.col(column) = (forces(column, -displacement) - forces(column, displacement)) / (2 * displacement);
    }
    model_.linearise({}, rest_);
    return k;
  }

  /// Accelerations of the surface under upward forces on it; the multipliers that keep the areas.
  Eigen::VectorXd answer(const Eigen::VectorXd& force, std::vector<double>& multipliers) {
    std::vector<double> u(model_.rates(), 0.0);
    for (Index i = 0; i < size_; ++i) u[vertical(i)] = model_.nodes().wy()[node(i)] * force[i];
    multipliers.assign(model_.constraints(), 0.0);
    mechanics::Projection<Model>(model_).project(u, {}, multipliers);
    Eigen::VectorXd acceleration(size_);
    for (Index i = 0; i < size_; ++i) acceleration[i] = u[vertical(i)];
    return acceleration;
  }

  [[nodiscard]] Index size() const { return size_; }

 private:
  /// Height of the lowest cell, which no displacement may tangle.
  [[nodiscard]] double lowest_cell() const {
    const double width = rest_[first_ + 1] - rest_[first_];
    return std::ranges::min(model_.first_volumes()) / width;
  }
  [[nodiscard]] std::size_t node(Index i) const { return first_ + static_cast<std::size_t>(i); }
  [[nodiscard]] std::size_t vertical(Index i) const { return model_.nodes().size() + node(i); }

  [[nodiscard]] Eigen::VectorXd forces(Index displaced, double displacement) {
    std::vector<double> q = rest_;
    q[vertical(displaced)] += displacement;
    model_.linearise({}, q);
    std::vector<double> u(model_.rates(), 0.0);
    model_.kick(1, u);
    Eigen::VectorXd force(size_);
    for (Index i = 0; i < size_; ++i) force[i] = u[vertical(i)] / model_.nodes().wy()[node(i)];
    return force;
  }

  Model& model_;
  std::vector<double> rest_;
  std::size_t first_;
  Index size_;
};

}  // namespace

std::vector<SurfaceMode> surface_modes(Model& model) {
  SurfaceResponse surface(model);
  const Eigen::MatrixXd k = surface.stiffness();
  Eigen::MatrixXd c(surface.size(), surface.size());
  std::vector<double> multipliers;
  for (Index i = 0; i < surface.size(); ++i) {
    c.col(i) = surface.answer(Eigen::VectorXd::Unit(surface.size(), i), multipliers);
  }
  // K and C are symmetric: with K = L L^T and eta = L^-T z,  L^T C L z = omega^2 z.
  const Eigen::LLT<Eigen::MatrixXd> root(k);
  const Eigen::MatrixXd lower = root.matrixL();
  const Eigen::MatrixXd product = c * lower;
  const Eigen::MatrixXd symmetric = lower.transpose() * product;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  std::vector<SurfaceMode> modes;
  for (Index m = 1; m < surface.size(); ++m) {
    const Eigen::VectorXd elevation = root.matrixU().solve(eigen.eigenvectors().col(m));
    const Eigen::VectorXd force = -k * elevation;
    surface.answer(force, multipliers);
    modes.push_back({.frequency = std::sqrt(eigen.eigenvalues()[m]),
                     .elevation = {elevation.begin(), elevation.end()},
                     .multipliers = multipliers});
  }
  return modes;
}

}  // namespace seiche::validation
