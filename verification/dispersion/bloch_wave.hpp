/// Frequency of a plane wave on an infinite lattice of cell columns, from the discrete energies and volumes alone.
///
/// A column of cells has four corners in plan and one node per level at each. Its potential energy and the volumes of
/// its cells are integrals over bilinear patches and trilinear hexahedra, by Gauss quadrature that is exact for them.
/// About rest, with the multipliers of rest,
///
///     M q'' = -D^2(Pi - lambda . V) q + DV^T mu,   DV q = 0,   q at the corners: (i X, i Y, Z) exp(i k . r).
///
/// Both are polynomials, so that central differences are exact derivatives; the lattice being its own mirror image, all
/// matrices are real for real X, Y, Z. Nothing here knows a dispersion law.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

namespace seiche::verification {

struct CellColumn {
  double gravity, depth, hx, hy;
  std::size_t layers;  ///< of hexahedra; 0: straight columns under the markers of the 2DH model
  double inertia = 1;  ///< factor of the vertical inertia of surface nodes
};

namespace cell_column {

inline constexpr std::array<double, 2> gauss{0.21132486540518711775, 0.78867513459481288225};  // weights 1/2

inline Eigen::Index levels(const CellColumn& column) {
  return static_cast<Eigen::Index>(column.layers) + 1;
}

inline double cell_height(const CellColumn& column) {
  return column.layers == 0 ? column.depth : column.depth / static_cast<double>(column.layers);
}

/// Corner c = 0..3 counter-clockwise at level l is node 4 l + c, with coordinates 3 node + axis.
inline Eigen::VectorXd at_rest(const CellColumn& column) {
  Eigen::VectorXd q(12 * levels(column));
  for (Eigen::Index node = 0; node < q.size() / 3; ++node) {
    const Eigen::Index corner = node % 4, level = node / 4;
    q[3 * node] = (corner == 1 || corner == 2 ? 0.5 : -0.5) * column.hx;
    q[3 * node + 1] = (corner >= 2 ? 0.5 : -0.5) * column.hy;
    q[3 * node + 2] = column.layers == 0 ? column.depth : cell_height(column) * static_cast<double>(level);
  }
  return q;
}

/// Place and its derivatives by xi, eta on the bilinear patch of a level.
struct Patch {
  Eigen::Vector3d place, xi, eta;
};

inline Patch patch(const Eigen::VectorXd& q, Eigen::Index level, double xi, double eta) {
  const auto r = [&](Eigen::Index corner) { return q.segment<3>(3 * (4 * level + corner)); };
  return {(1 - xi) * (1 - eta) * r(0) + xi * (1 - eta) * r(1) + xi * eta * r(2) + (1 - xi) * eta * r(3),
          (1 - eta) * (r(1) - r(0)) + eta * (r(2) - r(3)), (1 - xi) * (r(3) - r(0)) + xi * (r(2) - r(1))};
}

/// Integral of f(z) over the plan area of the top patch.
template <class Integrand>
double over_surface(const CellColumn& column, const Eigen::VectorXd& q, const Integrand& f) {
  double sum = 0;
  for (const double xi : gauss) {
    for (const double eta : gauss) {
      const Patch p = patch(q, levels(column) - 1, xi, eta);
      sum += 0.25 * f(p.place.z()) * (p.xi.x() * p.eta.y() - p.xi.y() * p.eta.x());
    }
  }
  return sum;
}

inline double hexahedron(const Eigen::VectorXd& q, Eigen::Index layer) {
  double sum = 0;
  for (const double xi : gauss) {
    for (const double eta : gauss) {
      const Patch below = patch(q, layer, xi, eta), above = patch(q, layer + 1, xi, eta);
      for (const double s : gauss) {
        const Eigen::Vector3d along = (1 - s) * below.xi + s * above.xi, across = (1 - s) * below.eta + s * above.eta;
        sum += 0.125 * along.cross(across).dot(above.place - below.place);
      }
    }
  }
  return sum;
}

inline Eigen::VectorXd volumes(const CellColumn& column, const Eigen::VectorXd& q) {
  if (column.layers == 0) return Eigen::VectorXd::Constant(1, over_surface(column, q, [](double z) { return z; }));
  Eigen::VectorXd result(static_cast<Eigen::Index>(column.layers));
  for (Eigen::Index layer = 0; layer < result.size(); ++layer) result[layer] = hexahedron(q, layer);
  return result;
}

/// (Pi - lambda . V)/rho with the multipliers of rest, rho g H in every cell.
inline double excess(const CellColumn& column, const Eigen::VectorXd& q) {
  const double potential = over_surface(column, q, [](double z) { return 0.5 * z * z; });
  return column.gravity * (potential - column.depth * volumes(column, q).sum());
}

/// Masses over rho by level and axis.
inline Eigen::VectorXd masses(const CellColumn& column) {
  Eigen::VectorXd mass = Eigen::VectorXd::Constant(3 * levels(column), column.hx * column.hy * cell_height(column));
  if (column.layers > 0) {
    mass.head(3) /= 2;
    mass.tail(3) /= 2;
  }
  mass[mass.size() - 1] *= column.inertia;
  return mass;
}

/// Without the entry or column of the vertical motion of the bottom nodes, which the level bottom forbids.
inline Eigen::MatrixXd on_bottom(const CellColumn& column, const Eigen::MatrixXd& m) {
  if (column.layers == 0) return m;
  Eigen::MatrixXd kept(m.rows(), m.cols() - 1);
  kept << m.leftCols(2), m.rightCols(m.cols() - 3);
  return kept;
}

}  // namespace cell_column

class BlochWave {
 public:
  explicit BlochWave(const CellColumn& column) : column_(column), rest_(cell_column::at_rest(column)) {
    constexpr double d = 0.25;
    const auto moved = [&](Eigen::Index i, double by_i, Eigen::Index j, double by_j) {
      Eigen::VectorXd q = rest_;
      q[i] += by_i;
      q[j] += by_j;
      return q;
    };
    const auto volumes = [&](Eigen::Index i, double by) { return cell_column::volumes(column_, moved(i, by, i, 0)); };
    gradient_.resize(cell_column::volumes(column, rest_).size(), rest_.size());
    hessian_.resize(rest_.size(), rest_.size());
    for (Eigen::Index i = 0; i < rest_.size(); ++i) {
      gradient_.col(i) = (volumes(i, d) - volumes(i, -d)) / (2 * d);
      for (Eigen::Index j = 0; j <= i; ++j) {
        const auto energy = [&](double by_i, double by_j) {
          return cell_column::excess(column_, moved(i, by_i, j, by_j));
        };
        hessian_(i, j) = (energy(d, d) - energy(d, -d) - energy(-d, d) + energy(-d, -d)) / (4 * d * d);
        hessian_(j, i) = hessian_(i, j);
      }
    }
  }

  /// Squares of the frequencies of all motions with the wavenumber (kx, ky), ascending [1/s^2].
  [[nodiscard]] Eigen::VectorXd squared_frequencies(double kx, double ky) const;

 private:
  CellColumn column_;
  Eigen::VectorXd rest_;
  Eigen::MatrixXd gradient_, hessian_;
};

inline Eigen::VectorXd BlochWave::squared_frequencies(double kx, double ky) const {
  const Eigen::Index nodes = cell_column::levels(column_);
  Eigen::MatrixXd real = Eigen::MatrixXd::Zero(rest_.size(), 3 * nodes);
  Eigen::MatrixXd imaginary = real;
  for (Eigen::Index node = 0; node < 4 * nodes; ++node) {
    const double phase = kx * rest_[3 * node] + ky * rest_[3 * node + 1];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::Index row = 3 * node + axis, column = 3 * (node / 4) + axis;
      real(row, column) = axis == 2 ? std::cos(phase) : -std::sin(phase);
      imaginary(row, column) = axis == 2 ? std::sin(phase) : std::cos(phase);
    }
  }
  real = cell_column::on_bottom(column_, real);
  imaginary = cell_column::on_bottom(column_, imaginary);
  const Eigen::VectorXd mass = cell_column::on_bottom(column_, cell_column::masses(column_).transpose()).transpose();
  const Eigen::MatrixXd stiffness = real.transpose() * hessian_ * real + imaginary.transpose() * hessian_ * imaginary;
  const Eigen::MatrixXd constraint = gradient_ * real;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(constraint.transpose());
  const Eigen::MatrixXd basis = qr.householderQ();
  const Eigen::MatrixXd allowed = basis.rightCols(real.cols() - constraint.rows());
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(allowed.transpose() * stiffness * allowed,
                                                                   allowed.transpose() * mass.asDiagonal() * allowed,
                                                                   Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace seiche::verification
