#include "seiche/exact/overturning/slope_climb.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/LU>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>

#include "seiche/divergence.hpp"

namespace seiche::exact::slope_climb {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// T_c at the r-th of the nodes of so many intervals; the argument stays small, as does its rounding.
double polynomial(Index c, Index r, Index intervals) {
  const Index phase = ((intervals - r) * c) % (2 * intervals);
  return std::cos(std::numbers::pi * static_cast<double>(phase) / static_cast<double>(intervals));
}

/// The polynomials at the nodes of `fine` intervals.
Eigen::MatrixXd polynomials(Index fine, Index n) {
  return Eigen::MatrixXd::NullaryExpr(fine + 1, n + 1, [=](Index r, Index c) { return polynomial(c, r, fine); });
}

double halved_at_ends(Index k, Index n) {
  return k == 0 || k == n ? 0.5 : 1;
}

/// Values to coefficients.
Eigen::MatrixXd coefficients(Index n) {
  return Eigen::MatrixXd::NullaryExpr(n + 1, n + 1, [n](Index c, Index r) {
    return 2 * halved_at_ends(c, n) * halved_at_ends(r, n) * polynomial(c, r, n) / static_cast<double>(n);
  });
}

/// Distance from the image over that from the next node, from where the integrals err by exp(-2 pi 5) at most.
constexpr double near_image = 5;

namespace odeint = boost::numeric::odeint;

constexpr double held = 4;         // depths at the far end, over which water is let go gradually
constexpr double shortest = 1e-6;  // step

/// From 0 to 1 with three derivatives 0 at both ends.
double smooth_step(double u) {
  const double t = std::clamp(u, 0.0, 1.0);
  return t * t * t * t * (35 + t * (-84 + t * (70 - 20 * t)));
}

}  // namespace

Eigen::VectorXd clenshaw_curtis(std::size_t intervals) {
  const auto n = static_cast<Index>(intervals);
  Eigen::VectorXd weights(n + 1);
  for (Index r = 0; r <= n; ++r) {
    double sum = 0;
    for (Index c = 0; c <= n; c += 2) {
      sum += halved_at_ends(c, n) * polynomial(c, r, n) * 2 / (1 - static_cast<double>(c * c));
    }
    weights[r] = 2 * halved_at_ends(r, n) * sum / static_cast<double>(n);
  }
  return weights;
}

ChebyshevLine::ChebyshevLine(std::size_t intervals)
    : nodes(static_cast<Index>(intervals) + 1), weights(clenshaw_curtis(intervals)) {
  const auto n = static_cast<Index>(intervals);
  for (Index r = 0; r <= n; ++r) nodes[r] = polynomial(1, r, n);
  differentiation.setZero(n + 1, n + 1);
  const double step = std::numbers::pi / (2 * static_cast<double>(n));
  for (Index r = 0; r <= n; ++r) {
    for (Index c = 0; c <= n; ++c) {
      if (r == c) continue;
      // s_r - s_c by sines, to the last digit.
      const double apart =
          2 * std::sin(step * static_cast<double>(r + c)) * std::sin(step * static_cast<double>(r - c));
      const double sign = (r + c) % 2 == 0 ? 1 : -1;
      differentiation(r, c) = sign * halved_at_ends(c, n) / (halved_at_ends(r, n) * apart);
    }
    differentiation(r, r) = -differentiation.row(r).sum();
  }
  const auto kept = Eigen::VectorXd::NullaryExpr(
      n + 1, [n](Index k) { return std::exp(-36 * std::pow(static_cast<double>(k) / static_cast<double>(n), 24)); });
  filter = polynomials(n, n) * kept.eval().asDiagonal() * coefficients(n);
}

Eigen::MatrixXd ChebyshevLine::refinement(std::size_t times) const {
  const Index n = nodes.size() - 1;
  return polynomials(n * static_cast<Index>(times), n) * coefficients(n);
}

WedgeFlow::WedgeFlow(std::size_t intervals, double slope)
    : beta_(slope),
      power_(std::numbers::pi / (std::numbers::pi - slope)),
      line_(intervals),
      psi_(Eigen::VectorXd::Zero(static_cast<Index>(intervals) + 1)) {
  for (const Index times : {1, 4, 16}) {
    curves_.push_back({.times = times,
                       .refinement = times == 1 ? Eigen::MatrixXd() : line_.refinement(static_cast<std::size_t>(times)),
                       .weights = clenshaw_curtis(static_cast<std::size_t>(times) * intervals)});
  }
}

void WedgeFlow::map(const Eigen::ArrayXcd& z, const Eigen::ArrayXcd& z_s, Curve& curve) const {
  const Eigen::ArrayXcd turned = z * std::polar(1.0, -beta_);
  Eigen::ArrayXd angle = power_ * turned.arg();
  angle[angle.size() - 1] = 0;  // the shore is on the slope
  const Eigen::ArrayXd radius = turned.abs().pow(power_);
  curve.x = radius * angle.cos();
  curve.y = radius * angle.sin();
  const Eigen::ArrayXcd rate = power_ * z_s / z;
  curve.x_s = rate.real() * curve.x - rate.imag() * curve.y;
  curve.y_s = rate.real() * curve.y + rate.imag() * curve.x;
}

const WedgeFlow::Curve& WedgeFlow::curve_for(Index node) const {
  const Curve& coarse = curves_.front();
  const double next = std::hypot(coarse.x[node + 1] - coarse.x[node], coarse.y[node + 1] - coarse.y[node]);
  for (const Curve& curve : curves_) {
    if (static_cast<double>(curve.times) * 2 * coarse.y[node] >= near_image * next) return curve;
  }
  return curves_.back();
}

double WedgeFlow::row(const Curve& curve, Index node, double curvature, double phi_s, double* kernels) const {
  const double x = curve.x[node];
  const double y = curve.y[node];
  const double phi = curve.phi[node];
  const double* const weights = curve.weights.data();
  const double* const phis = curve.phi.data();
  double sum = 0;
  const auto range = [&](Index begin, Index end) {
    for (Index j = begin; j < end; ++j) {
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
  range(node + 1, curve.x.size());
  // Here K has the limits Im(zeta_ss/zeta_s)/2 and, times phi - phi_i, phi_s; the image's is x_s/(2y).
  kernels[node] = weights[node] * (curvature + curve.x_s[node] / (2 * y));
  return sum + weights[node] * phi_s;
}

void WedgeFlow::solve(const Eigen::VectorXcd& z, const Eigen::VectorXd& phi) {
  const Index n = z.size() - 1;
  const Eigen::MatrixXd& d = line_.differentiation;
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
    const Curve& curve = curve_for(i);
    if (curve.times == 1) {
      right_[i] = row(curve, i, curvature, phi_s[i], matrix_.col(i).data());
    } else {
      kernels_.resize(curve.phi.size());
      right_[i] = row(curve, curve.times * i, curvature, phi_s[i], kernels_.data());
      matrix_.col(i).noalias() = curve.refinement.transpose() * kernels_;
    }
    const Complex zeta(surface.x[i], surface.y[i]);
    right_[i] -= phi[i] * std::log(std::abs((far - zeta) / (std::conj(far) - zeta)));
  }
  matrix_.diagonal().array() += std::numbers::pi;
  Eigen::MatrixXd inner = matrix_.block(1, 1, n - 1, n - 1).transpose();
  psi_.segment(1, n - 1) = Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>>(inner).solve(right_.segment(1, n - 1));
  psi_[0] = psi_[n] = 0;
  velocity_.resize(n + 1);
  const Eigen::VectorXd psi_s = d * psi_;
  for (Index i = 0; i <= n; ++i) velocity_[i] = Complex(phi_s[i], psi_s[i]) / z_s[i];
}

Climb::Climb(double slope, const Eigen::VectorXcd& z, const Eigen::VectorXd& phi, double tolerance)
    : n_(static_cast<std::size_t>(z.size())),
      slope_(slope),
      flow_(n_ - 1, slope),
      state_(3 * n_),
      moved_(z.size()),
      stepper_(odeint::make_controlled(tolerance, 0.0, odeint::runge_kutta_dopri5<State>())) {
  part(state_, 0) = z.real();
  part(state_, 1) = z.imag();
  part(state_, 2) = phi;
  moved_ = ((z.real().array() - z[0].real()) / held).unaryExpr(&smooth_step);
}

Eigen::VectorXcd Climb::nodes(const State& state) const {
  return part(state, 0) + Complex(0, 1) * part(state, 1);
}

void Climb::rate(const State& state, State& rate) {
  rate.resize(state.size());
  flow_.solve(nodes(state), part(state, 2));
  Eigen::VectorXcd velocity = flow_.velocity().conjugate();
  Complex& shore = velocity[velocity.size() - 1];
  const Complex up = std::polar(1.0, slope_);
  shore = up * (shore * std::conj(up)).real();
  part(rate, 0) = moved_.cwiseProduct(velocity.real());
  part(rate, 1) = moved_.cwiseProduct(velocity.imag());
  part(rate, 2) = moved_.array() * (velocity.array().abs2() / 2 - (part(state, 1).array() - 1));
}

void Climb::require_finite() const {
  for (std::size_t k = 0; k < n_; ++k) {
    if (std::isfinite(state_[k]) && std::isfinite(state_[n_ + k]) && std::isfinite(state_[2 * n_ + k])) continue;
    throw Divergence(
        "the surface is not resolved: it overturns at this amplitude and cotangent, or has too few markers", time_,
        steps_, state_[k]);
  }
}

void Climb::filter() {
  for (const std::size_t which : {0, 1, 2}) part(state_, which) = flow_.line().filter * part(state_, which).eval();
  const Complex up = std::polar(1.0, slope_);
  const Complex shore = up * (Complex(state_[n_ - 1], state_[2 * n_ - 1]) * std::conj(up)).real();
  state_[n_ - 1] = shore.real();
  state_[2 * n_ - 1] = shore.imag();
}

void Climb::step() {
  before_ = state_;
  time_before_ = time_;
  stepper_.reset();  // the filter changed the state since
  while (stepper_.try_step(system(), state_, time_, duration_) == odeint::fail) {
    if (duration_ > shortest) continue;
    throw Divergence(
        "steps get shorter without end: the surface overturns at this amplitude and cotangent, or has too few markers",
        time_, steps_, state_[n_ - 1]);
  }
  ++steps_;
  require_finite();
  filter();
}

void Climb::step_back() {
  state_ = before_;
  time_ = time_before_;
}

void Climb::step_to(double time) {
  if (time == time_) return;
  odeint::runge_kutta_dopri5<State> pair;
  pair.do_step(system(), state_, time_, time - time_);
  time_ = time;
  require_finite();
}

double Climb::shore_speed() {
  State rates;
  rate(state_, rates);
  return rates[2 * n_ - 1];
}

double Climb::energy() {
  State rates;
  rate(state_, rates);
  return moment(2) + flow_.kinetic_energy(part(state_, 2));
}

double Climb::moment(int power) const {
  const Eigen::VectorXcd z = nodes(state_);
  const Eigen::VectorXd x_s = flow_.line().differentiation * z.real();
  const Eigen::ArrayXd heights = (z.imag().array() - 1).pow(power) / power;
  const double below_surface = flow_.line().weights.dot((heights * x_s.array()).matrix());
  // The slope's side.
  return below_surface - std::cos(slope_) / std::sin(slope_) * std::pow(shore(), power + 1) / (power * (power + 1));
}

}  // namespace seiche::exact::slope_climb
