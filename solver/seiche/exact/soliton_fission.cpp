#include "seiche/exact/soliton_fission.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace {

/// Lowest eigenvalues of -psi'' - nu (nu + 1) sech^2(x) psi, by the sinc series on [-half, half].
Eigen::VectorXd levels(double order, double spacing, double half) {
  const auto beside = static_cast<Eigen::Index>(std::ceil(half / spacing));
  const Eigen::Index n = 2 * beside + 1;
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto apart = static_cast<double>(i - j);
      matrix(i, j) = ((i - j) % 2 == 0 ? 2 : -2) / std::pow(apart * spacing, 2);
    }
    const double sech = 1 / std::cosh(static_cast<double>(i - beside) * spacing);
    matrix(i, i) = std::pow(std::numbers::pi / spacing, 2) / 3 - order * (order + 1) * sech * sech;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace

SolitonFission::SolitonFission(double depth, Passage passage) : depth_(depth) {
  require_within("depth", depth, 0.05, 1);
  const double root = std::sqrt(depth);
  transmission_ = passage == Passage::abrupt ? 2 / (1 + root) : 1 / std::sqrt(root);
  reflection_ = passage == Passage::abrupt ? (1 - root) / (1 + root) : 0;
  order_ = std::sqrt(0.25 + 2 * transmission_ / (depth * depth)) - 0.5;
}

int SolitonFission::solitons() const {
  return static_cast<int>(std::ceil(order_));
}

double SolitonFission::amplitude(int n) const {
  require_at_least("n", n, 1);
  const double level = std::max(order_ - n + 1, 0.0);
  return std::pow(depth_ * level, 2);
}

Provenance SolitonFission::provenance() {
  return {"Madsen & Mei, J. Fluid Mech. 39 (1969) 781; Johnson, Proc. Camb. Phil. Soc. 73 (1973) 183; Lamb (1932), 176",
          "a_n/a_0 = h^2 (nu - n + 1)^2, nu (nu + 1) = 2 T/h^2, T = 2/(1 + sqrt h) or h^(-1/4)"};
}

double SolitonFission::uncertainty() const {
  return 1e-14;  // a root and a few products, of order up to 40
}

SelfTest SolitonFission::self_test() const {
  const double root = std::sqrt(depth_);
  const double flux = reflection_ * reflection_ + transmission_ * transmission_ * root;
  // The bound states that decay within the interval.
  const double slowest = std::max(0.5, order_ / 4);
  const double spacing = std::min(0.15, 0.8 / order_);  // sech^2 has poles at i pi/2: exp(-pi^2/(2 spacing))
  // They oscillate out to where the potential is their level, about nu sech x = slowest, and decay from there.
  const double turning = std::acosh(std::max(1.0, (order_ + 0.5) / slowest));
  const Eigen::VectorXd found = levels(order_, spacing, turning + 1 + 15 / slowest);
  Worst worst;
  for (int n = 1; n <= solitons(); ++n) {
    const double decay = std::sqrt(amplitude(n)) / depth_;
    if (decay >= slowest) worst.add(std::sqrt(-found[n - 1]) / decay - 1);
  }
  return {{"the energy of long waves passes or is reflected, R^2 + T^2 sqrt(h) = 1", std::abs(flux - 1), 1e-14,
           "a few rounded operations of numbers of order 1"},
          {"the amplitudes are the levels of -nu (nu + 1) sech^2 x, by the sinc series", std::abs(worst.value()), 1e-11,
           "rounding of a matrix whose entries, (pi/spacing)^2, are up to 1e3 times the levels; what the interval cuts "
           "off is exp(-30)"}};
}

static_assert(ReferenceSolution<SolitonFission>);

}  // namespace seiche::exact
