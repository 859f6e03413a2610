#include "validation/instruments/mesh/mesh_linear_modes.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

using Eigen::Index;
using lagrangian_mesh_2d::Slide;

/// Q: a column per way in which a node can move, of kinetic energy 1/2.
Eigen::MatrixXd possible_rates(const lagrangian_mesh_2d::Model& model) {
  const auto& nodes = model.nodes();
  const auto n = static_cast<Index>(nodes.size());
  std::vector<Eigen::VectorXd> columns;
  for (Index k = 0; k < n; ++k) {
    const auto node = static_cast<std::size_t>(k);
    if (nodes.wx()[node] > 0) columns.emplace_back(Eigen::VectorXd::Unit(2 * n, k) * std::sqrt(nodes.wx()[node]));
    if (nodes.wy()[node] > 0) columns.emplace_back(Eigen::VectorXd::Unit(2 * n, n + k) * std::sqrt(nodes.wy()[node]));
  }
  for (const Slide& slide : nodes.slides()) {
    const auto k = static_cast<Index>(slide.node);
    Eigen::VectorXd along = Eigen::VectorXd::Zero(2 * n);
    along[k] = slide.direction.x;
    along[n + k] = slide.direction.y;
    columns.emplace_back(along / std::sqrt(nodes.mass()[slide.node]));
  }
  Eigen::MatrixXd q(2 * n, static_cast<Index>(columns.size()));
  for (Index j = 0; j < q.cols(); ++j) q.col(j) = columns[static_cast<std::size_t>(j)];
  return q;
}

auto entries_of(auto& matrix) {
  return std::span(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

/// W F with the nodes displaced.
Eigen::VectorXd accelerations(lagrangian_mesh_2d::Model& model, const std::vector<double>& rest,
                              const Eigen::VectorXd& rates, double h) {
  std::vector<double> q(rest.size());
  model.linearise({}, rest);
  model.predict(rest, entries_of(rates), h, q);
  model.linearise({}, q);
  Eigen::VectorXd kicked = Eigen::VectorXd::Zero(rates.size());
  model.kick(1, entries_of(kicked));
  return kicked;
}

}  // namespace

LinearModes linear_modes(lagrangian_mesh_2d::Model& model, double displacement) {
  const std::vector<double> rest = model.state().q;
  model.linearise({}, rest);
  const Eigen::MatrixXd q = possible_rates(model);
  Eigen::MatrixXd constraints(static_cast<Index>(model.constraints()), q.cols());
  Eigen::VectorXd rate(constraints.rows());
  for (Index j = 0; j < q.cols(); ++j) {
    const Eigen::VectorXd column = q.col(j);
    model.constraint_rates(entries_of(column), entries_of(rate));
    constraints.col(j) = rate;
  }
  // Columns of q have one or two entries: dividing by their squares gives Q^T M of an acceleration.
  const Eigen::MatrixXd dual = q * q.colwise().squaredNorm().cwiseInverse().asDiagonal();
  Eigen::MatrixXd stiffness(q.cols(), q.cols());
  for (Index j = 0; j < q.cols(); ++j) {
    const double h = displacement / q.col(j).norm();
    stiffness.col(j) = -dual.transpose() *
                       (accelerations(model, rest, q.col(j), h) - accelerations(model, rest, q.col(j), -h)) / (2 * h);
  }
  model.linearise({}, rest);

  // What the constraints' gradients do not reach.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(constraints.transpose());
  const Eigen::MatrixXd basis = factors.householderQ();
  const Eigen::MatrixXd kernel = basis.rightCols(constraints.cols() - factors.rank());
  const Eigen::MatrixXd s = kernel.transpose() * stiffness * kernel;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (s + s.transpose()));
  const Eigen::VectorXd& squares = eigen.eigenvalues();
  LinearModes modes;
  const Eigen::MatrixXd skew = s - s.transpose();
  modes.asymmetry = worst(entries_of(skew)) / worst(entries_of(s));
  const double least = 1e-10 * worst(entries_of(squares));
  // A square that is clearly negative belongs to no motionless mode: its frequency is not a number.
  while (static_cast<Index>(modes.motionless) < squares.size() &&
         std::abs(squares[static_cast<Index>(modes.motionless)]) < least) {
    ++modes.motionless;
  }
  const Index waves = squares.size() - static_cast<Index>(modes.motionless);
  for (const double square : squares.tail(waves)) modes.frequencies.push_back(std::sqrt(square));
  modes.rates = q * (kernel * eigen.eigenvectors().rightCols(waves));
  return modes;
}

}  // namespace seiche::validation
