#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/dispersion/bloch_wave.hpp"

namespace seiche::verification::lattice_energies_test {

using exact::HexahedralDispersion, exact::PlanDispersion, exact::SurfaceInertia;

constexpr double pi = std::numbers::pi;
const std::string source = "Frank, Discrete models of incompressible fluid (1994), 4.1, 4.2; closed forms of the cells";

template <class Visit>
void over_the_zone(const CellColumn& column, const Visit& visit) {
  for (double a = 0.05; a < 0.96; a += 0.1) {
    for (double b = 0; b < 0.96; b += 0.1) visit(a * pi / column.hx, b * pi / column.hy);
  }
}

template <class Law>
void claim(Check& check, const std::string& name, const std::string& lattice, const CellColumn& column,
           const Law& law) {
  const BlochWave cells(column);
  Worst wave, vortex;
  over_the_zone(column, [&](double kx, double ky) {
    const Eigen::VectorXd squares = cells.squared_frequencies(kx, ky);
    const Eigen::Index others = squares.size() - 1;
    wave.add(squares[others] / std::pow(law.frequency(kx, ky), 2) - 1);
    vortex.add(worst(squares.head(others)) / std::pow(law.frequency_bound(), 2));
  });
  check.holds("waves-" + name +
                  ": Energies and volumes linearised about rest have the frequencies of the closed form, on " +
                  lattice + ".",
              {wave.value()},
              Bound{1e-12,
                    "second differences over h/4 leave 1e-15 of a cell's energy; the longest wave has 1e-3 of the "
                    "largest omega^2"});
  check.holds("vortices-" + name + ": All other motions that the volumes allow are motionless, on " + lattice + ".",
              {vortex.value()}, Bound{1e-13, "the same differences, 1e-14 of a cell's energy"});
}

/// The same frequency from the symbol of the multipliers' matrix: for a plane wave it is tridiagonal over the layers.
double by_multipliers(const CellColumn& column, double kx, double ky) {
  const auto n = static_cast<Eigen::Index>(column.layers);
  const double h3 = column.depth / static_cast<double>(column.layers);
  const double mass = column.hx * column.hy * h3;
  const double s1 = std::sin(0.5 * kx * column.hx), c1 = std::cos(0.5 * kx * column.hx);
  const double s2 = std::sin(0.5 * ky * column.hy), c2 = std::cos(0.5 * ky * column.hy);
  const double level = h3 * h3 * (std::pow(column.hy * s1 * c2, 2) + std::pow(column.hx * s2 * c1, 2)) / mass;
  const double upright = std::pow(column.hx * column.hy * c1 * c2, 2) / mass;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  matrix(0, 0) += 2 * level;
  matrix(n - 1, n - 1) += 2 * (level + upright);
  for (Eigen::Index j = 0; j + 1 < n; ++j) {
    matrix(j, j) += level + upright;
    matrix(j + 1, j + 1) += level + upright;
    matrix(j, j + 1) = matrix(j + 1, j) = level - upright;
  }
  const double top = matrix.ldlt().solve(Eigen::VectorXd::Unit(n, n - 1))[n - 1];
  const double potential = (2 + std::cos(kx * column.hx)) * (2 + std::cos(ky * column.hy)) / 9;
  return std::sqrt(2 * column.gravity / h3 * potential * (1 - 2 * upright * top));
}

TEST_CASE("the laws of the models in three dimensions follow from their energies and volumes", "[dispersion]") {
  Check check("exact_lattice_energies", "Waves on meshes of cells from energies and volumes alone",
              "Potential energy and volumes of bilinear and trilinear cells by Gauss quadrature, differentiated twice "
              "about rest, joined to an infinite mesh by the phases of a plane wave: the eigenvalues of "
              "volume-conserving motions are the squared frequencies. One equals the closed form, all others vanish.",
              source);
  const double third = 1.0 / 3;
  for (const auto& [name, g, depth, hx, hy, alpha] : {std::tuple{"2dh-square", 1.0, 1.0, 0.5, 0.5, third},
                                                      {"2dh-oblong", 9.81, 0.7, 0.4, 0.3, third},
                                                      {"2dh-alpha-1-2", 1.0, 1.0, 1.0, 0.25, 0.5}}) {
    claim(check, name, fmt::format("{:g} by {:g} H in 2DH, alpha = {:.3g}", hx / depth, hy / depth, alpha),
          {g, depth, hx, hy, 0, alpha}, PlanDispersion(g, depth, hx, hy, alpha));
  }
  Worst multipliers;
  for (const std::size_t layers : {1UL, 2UL, 3UL, 5UL}) {
    const CellColumn column{9.81, 0.7, 0.4, 0.3, layers};
    const HexahedralDispersion law(9.81, 0.7, 0.4, 0.3, layers);
    claim(check, fmt::format("layers-{}", layers), fmt::format("{} layers of hexahedra", layers), column, law);
    const double tuned = 1 - 1 / (3 * static_cast<double>(layers));
    claim(check, fmt::format("tuned-{}", layers), fmt::format("{} layers, tuned surface inertia", layers),
          {1, 1, 0.5, 0.25, layers, tuned}, HexahedralDispersion(1, 1, 0.5, 0.25, layers, SurfaceInertia::tuned));
    over_the_zone(column, [&](double kx, double ky) {
      multipliers.add(by_multipliers(column, kx, ky) / law.frequency(kx, ky) - 1);
    });
  }
  check.that("multipliers",
             "The tridiagonal problem of the layers' multipliers has the frequencies of the closed form, for T = K "
             "h3/2 below and above 1.",
             "largest relative deviation of omega",
             {.value = multipliers.value(), .resolution = "1, 2, 3, 5 layers, 100 wavenumbers over the zone"},
             Bound{1e-12,
                   "the problem is a difference from 1 of which the longest wave leaves 0.01, solved to some ten "
                   "roundings times the matrix's condition, below 1e2"});
}

}  // namespace seiche::verification::lattice_energies_test
