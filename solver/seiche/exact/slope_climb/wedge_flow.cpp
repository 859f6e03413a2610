#include "seiche/exact/slope_climb/wedge_flow.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "seiche/linear/dense.hpp"

namespace seiche::exact::slope_climb {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Distance from the image over that from the next node, from where the integrals err by exp(-2 pi 5) at most.
constexpr double near_image = 5;

}  // namespace

WedgeFlow::WedgeFlow(std::size_t intervals, double slope)
    : beta_(slope),
      power_(std::numbers::pi / (std::numbers::pi - slope)),
      line_(intervals),
      psi_(Eigen::VectorXd::Zero(static_cast<Index>(intervals) + 1)) {
  for (const std::size_t times : {1, 4, 16}) {
    curves_.push_back({.times = times,
                       .refinement = times == 1 ? Eigen::MatrixXd() : line_.refinement(times),
                       .weights = clenshaw_curtis(times * intervals)});
  }
}

void WedgeFlow::map(const Eigen::VectorXcd& z, const Eigen::VectorXcd& z_s, Curve& curve) const {
  const auto n = static_cast<std::size_t>(z.size());
  for (std::vector<double>* part : {&curve.x, &curve.y, &curve.x_s, &curve.y_s}) part->resize(n);
  const Complex turn = std::polar(1.0, -beta_);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<Index>(k);
    const Complex turned = z[i] * turn;
    const double angle = k + 1 == n ? 0 : std::arg(turned);  // the shore is on the slope
    const Complex zeta = std::polar(std::pow(std::abs(turned), power_), power_ * angle);
    const Complex zeta_s = power_ * zeta / z[i] * z_s[i];
    curve.x[k] = zeta.real();
    curve.y[k] = zeta.imag();
    curve.x_s[k] = zeta_s.real();
    curve.y_s[k] = zeta_s.imag();
  }
}

const WedgeFlow::Curve& WedgeFlow::curve_for(std::size_t node) const {
  const Curve& coarse = curves_.front();
  const double next = std::hypot(coarse.x[node + 1] - coarse.x[node], coarse.y[node + 1] - coarse.y[node]);
  for (const Curve& curve : curves_) {
    if (static_cast<double>(curve.times) * 2 * coarse.y[node] >= near_image * next) return curve;
  }
  return curves_.back();
}

double WedgeFlow::row(const Curve& curve, std::size_t node, double curvature, double phi_s, double* kernels) const {
  const double x = curve.x[node];
  const double y = curve.y[node];
  const double phi = curve.phi[static_cast<Index>(node)];
  const double* const weights = curve.weights.data();
  const double* const phis = curve.phi.data();
  const std::size_t n = curve.x.size();
  double sum = 0;
  const auto range = [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const double dx = curve.x[j] - x;
      const double up = curve.y[j] - y;
      const double down = -curve.y[j] - y;
      const double direct = 1 / (dx * dx + up * up);
      const double image = 1 / (dx * dx + down * down);
      const double real = (curve.x_s[j] * dx + curve.y_s[j] * up) * direct;
      const double imaginary = (curve.y_s[j] * dx - curve.x_s[j] * up) * direct;
      const double image_real = (curve.x_s[j] * dx - curve.y_s[j] * down) * image;
      const double image_imaginary = (-curve.y_s[j] * dx - curve.x_s[j] * down) * image;
      kernels[j] = weights[j] * (imaginary + image_imaginary);
      sum += weights[j] * (real - image_real) * (phis[j] - phi);
    }
  };
  range(0, node);
  range(node + 1, n);
  // Here K has the limits Im(zeta_ss/zeta_s)/2 and, times phi - phi_i, phi_s; the image's is x_s/(2y).
  kernels[node] = weights[node] * (curvature + curve.x_s[node] / (2 * y));
  return sum + weights[node] * phi_s;
}

void WedgeFlow::solve(const Eigen::VectorXcd& z, const Eigen::VectorXd& phi) {
  const Index n = z.size() - 1;
  const Eigen::MatrixXd& d = line_.differentiation();
  const Eigen::VectorXcd z_s = d * z;
  const Eigen::VectorXcd z_ss = d * z_s;
  const Eigen::VectorXd phi_s = d * phi;
  for (Curve& curve : curves_) {
    const bool coarse = curve.times == 1;
    map(coarse ? z : curve.refinement * z, coarse ? z_s : curve.refinement * z_s, curve);
    curve.phi = coarse ? phi : curve.refinement * phi;
  }
  const Curve& surface = curves_.front();
  matrix_.resize(n + 1, n + 1);
  right_.resize(n + 1);
  const Complex far(surface.x[0], surface.y[0]);
  for (Index i = 1; i < n; ++i) {
    const Complex relative = (power_ - 1) * z_s[i] / z[i] + z_ss[i] / z_s[i];  // zeta_ss/zeta_s
    const double curvature = relative.imag() / 2;
    const auto k = static_cast<std::size_t>(i);
    const Curve& curve = curve_for(k);
    if (curve.times == 1) {
      right_[i] = row(curve, k, curvature, phi_s[i], matrix_.col(i).data());
    } else {
      kernels_.resize(curve.phi.size());
      right_[i] = row(curve, curve.times * k, curvature, phi_s[i], kernels_.data());
      matrix_.col(i).noalias() = curve.refinement.transpose() * kernels_;
    }
    const Complex zeta(surface.x[k], surface.y[k]);
    right_[i] -= phi[i] * std::log(std::abs((far - zeta) / (std::conj(far) - zeta)));
  }
  matrix_.diagonal().array() += std::numbers::pi;
  Eigen::MatrixXd inner = matrix_.block(1, 1, n - 1, n - 1).transpose();
  psi_.segment(1, n - 1) = linear::LuFactors(inner).solve(right_.segment(1, n - 1));
  psi_[0] = psi_[n] = 0;
  velocity_.resize(n + 1);
  const Eigen::VectorXd psi_s = d * psi_;
  for (Index i = 0; i <= n; ++i) velocity_[i] = Complex(phi_s[i], psi_s[i]) / z_s[i];
}

double WedgeFlow::kinetic_energy(const Eigen::VectorXd& phi) const {
  return -0.5 * line_.weights().cwiseProduct(phi).dot(line_.differentiation() * psi_);
}

}  // namespace seiche::exact::slope_climb
