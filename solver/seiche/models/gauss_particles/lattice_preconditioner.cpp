#include "seiche/models/gauss_particles/lattice_preconditioner.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace seiche::gauss_particles {

namespace {

/// Integral over a cell of a polynomial in z from -1/2 to 1/2.
double integral(const double* coefficients, std::size_t powers) {
  double sum = 0;
  for (std::size_t k = 0; k < powers; k += 2) {
    sum += coefficients[k] * std::pow(0.5, static_cast<double>(k)) / static_cast<double>(k + 1);
  }
  return sum;
}

struct Modes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Of stiffness and mass over the cells all of whose functions are in the range, or held by a wall.
Modes modes(const SplineAxis& axis, LatticePreconditioner::Range range) {
  const auto order = static_cast<std::size_t>(axis.degree()) + 1;
  const std::size_t powers = 2 * order - 1;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(range.count, range.count);
  Eigen::MatrixXd stiffness = mass;
  const auto held = [&](long function) {
    return (axis.wall_below() && function == 0) || (axis.wall_above() && function == axis.functions() - 1);
  };
  for (long cell = 0; cell < axis.cells(); ++cell) {
    const auto place = [&](std::size_t i) { return axis.wrapped(cell + static_cast<long>(i)) - range.first; };
    bool whole = true;
    for (std::size_t i = 0; i < order; ++i) {
      whole = whole && (held(cell + static_cast<long>(i)) || (place(i) >= 0 && place(i) < range.count));
    }
    if (!whole) continue;
    const CellPolynomials& polynomials = cell_polynomials(axis.degree())[axis.kind(cell)];
    std::size_t pair = 0;
    for (std::size_t i = 0; i < order; ++i) {
      for (std::size_t k = i; k < order; ++k, ++pair) {
        if (held(cell + static_cast<long>(i)) || held(cell + static_cast<long>(k))) continue;
        const double m = axis.cell() * integral(&polynomials.product[pair * powers], powers);
        const double s = integral(&polynomials.derivative_product[pair * powers], powers) / axis.cell();
        mass(place(i), place(k)) += m;
        stiffness(place(i), place(k)) += s;
        if (i == k) continue;
        mass(place(k), place(i)) += m;
        stiffness(place(k), place(i)) += s;
      }
    }
  }
  for (Eigen::Index k = 0; k < range.count; ++k) {
    if (mass(k, k) == 0) mass(k, k) = stiffness(k, k) = 1;  // held, or beyond the cells: left alone
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

LatticePreconditioner::LatticePreconditioner(const Lattice& lattice, Range columns, Range rows) {
  const Modes x = modes(lattice.x, columns);
  const Modes y = modes(lattice.y, rows);
  // Of the constant, which has no energy where there is no wall: that of a wave as long as the rectangle.
  const double width = static_cast<double>(columns.count) * lattice.x.cell();
  const double height = static_cast<double>(rows.count) * lattice.y.cell();
  const double least = 1 / (width * width + height * height);
  along_x_ = x.vectors.cast<float>();
  along_y_ = y.vectors.cast<float>();
  inverse_.resize(columns.count, rows.count);
  for (Eigen::Index i = 0; i < columns.count; ++i) {
    for (Eigen::Index j = 0; j < rows.count; ++j) {
      inverse_(i, j) = static_cast<float>(1 / std::max(x.values[i] + y.values[j], least));
    }
  }
}

void LatticePreconditioner::apply(std::span<double> values, double magnitude) {
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> all(values.data(), inverse_.rows(),
                                                                                         inverse_.cols());
  values_ = (all / magnitude).cast<float>();
  half_.noalias() = along_x_.transpose() * values_;
  modes_.noalias() = half_ * along_y_;
  modes_.array() *= inverse_.array();
  half_.noalias() = along_x_ * modes_;
  values_.noalias() = half_ * along_y_.transpose();
  all = values_.cast<double>() * magnitude;
}

}  // namespace seiche::gauss_particles
