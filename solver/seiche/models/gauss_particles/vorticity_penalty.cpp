#include "seiche/models/gauss_particles/vorticity_penalty.hpp"

#include <array>
#include <cmath>

namespace seiche::gauss_particles {

namespace {

constexpr std::size_t orders = 4;  // derivatives 0 ... 3

/// Integrals of products of derivatives r of function i and s of function k over a cell, per metre.
class Integrals {
 public:
  Integrals(const CellPolynomials& polynomials, std::size_t order, double cell) : order_(order) {
    values_.resize(orders * orders * order * order);
    for (std::size_t r = 0; r < orders; ++r) {
      for (std::size_t s = 0; s < orders; ++s) {
        const double scale = cell * std::pow(cell, -static_cast<double>(r + s));
        for (std::size_t i = 0; i < order; ++i) {
          for (std::size_t k = 0; k < order; ++k) values_[index(r, s, i, k)] = scale * of(polynomials, r, s, i, k);
        }
      }
    }
  }
  [[nodiscard]] double operator()(std::size_t r, std::size_t s, std::size_t i, std::size_t k) const {
    return values_[index(r, s, i, k)];
  }

 private:
  [[nodiscard]] std::size_t index(std::size_t r, std::size_t s, std::size_t i, std::size_t k) const {
    return ((r * orders + s) * order_ + i) * order_ + k;
  }
  /// Coefficient of a power after so many derivations.
  [[nodiscard]] double coefficient(const CellPolynomials& p, std::size_t i, std::size_t power,
                                   std::size_t times) const {
    double value = p.function[i * order_ + power];
    for (std::size_t d = 0; d < times; ++d) value *= static_cast<double>(power - d);
    return value;
  }
  [[nodiscard]] double of(const CellPolynomials& p, std::size_t r, std::size_t s, std::size_t i, std::size_t k) const {
    double sum = 0;
    for (std::size_t a = r; a < order_; ++a) {
      for (std::size_t b = s; b < order_; ++b) {
        const std::size_t power = a - r + b - s;
        if (power % 2 != 0) continue;  // over [-1/2, 1/2]
        const auto n = static_cast<double>(power + 1);
        sum += coefficient(p, i, a, r) * coefficient(p, k, b, s) * std::pow(0.5, static_cast<double>(power)) / n;
      }
    }
    return sum;
  }

  std::size_t order_;
  std::vector<double> values_;
};

}  // namespace

void VorticityPenalty::prepare(const Lattice& lattice) {
  const bool same = degree_ == lattice.x.degree() && cell_x_ == lattice.x.cell() && cell_y_ == lattice.y.cell();
  degree_ = lattice.x.degree();
  cell_x_ = lattice.x.cell();
  cell_y_ = lattice.y.cell();
  if (!same) matrices_.assign(lattice.x.kinds() * lattice.y.kinds(), {});
}

std::span<const double> VorticityPenalty::matrix(std::size_t kind_x, std::size_t kind_y) {
  std::vector<double>& matrix = matrices_[kind_x * cell_polynomials(degree_).size() + kind_y];
  if (!matrix.empty()) return matrix;
  const auto order = static_cast<std::size_t>(degree_) + 1;
  const Integrals x(cell_polynomials(degree_)[kind_x], order, cell_x_);
  const Integrals y(cell_polynomials(degree_)[kind_y], order, cell_y_);
  matrix.resize(order * order * order * order);
  // grad lap Phi = (B_i''' B_j + B_i' B_j'', B_i'' B_j' + B_i B_j''')
  struct Product {
    std::size_t x, y;
  };
  constexpr std::array<std::array<Product, 2>, 2> gradient{{{{{3, 0}, {1, 2}}}, {{{2, 1}, {0, 3}}}}};
  std::size_t entry = 0;
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j < order; ++j) {
      for (std::size_t k = 0; k < order; ++k) {
        for (std::size_t l = 0; l < order; ++l) {
          double sum = 0;
          for (const auto& component : gradient) {
            for (const Product a : component) {
              for (const Product b : component) sum += x(a.x, b.x, i, k) * y(a.y, b.y, j, l);
            }
          }
          matrix[entry++] = sum;
        }
      }
    }
  }
  return matrix;
}

}  // namespace seiche::gauss_particles
