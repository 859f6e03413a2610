#include "seiche/exact/wavemaker_transient.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;
using Complex = std::complex<double>;

constexpr Complex i_unit{0, 1};
const Complex rising = std::polar(1.0, 0.25 * pi);
/// Exponents below it do not show: e^{-40} = 4e-18.
constexpr double unseen = 40;
/// A tail beyond this many units of an integrand that falls as s^-2 does not show either.
constexpr double far_away = 1e17;

/// tanh k = 1 and 1/cosh k = 0 to round-off from here on, and the resonance k = nu is left well behind.
double split_for(double nu) {
  return std::max(40.0, 4 * nu);
}

/// Ahead of the fastest waves, which go at 1, the surface does not show. On the path Im k = s < pi/2 no factor of the
/// integrand is larger than exp(-s x + t sqrt(s tan s)) times powers of 1/s; s is near the best for x next to t.
bool ahead_of_waves(double x, double t) {
  if (x <= t) return false;
  const double s = std::sqrt(std::min(1.0, (x - t) / t));
  return s * x - t * std::sqrt(s * std::tan(s)) > 1.5 * unseen;
}

double sinc(double z) {
  return std::abs(z) < 1e-8 ? 1 : std::sin(z) / z;
}

/// int_0^length f(s) ds for f analytic that varies over `scale` near 0 and ever more slowly further on.
template <class Function>
Complex along_ray(Function f, double scale, double length) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double v) { return f(scale * std::sinh(v)) * (scale * std::cosh(v)); }, 0.0, std::asinh(length / scale), 12,
      1e-13);
}

/// s at which linear s + square s^2 = unseen.
double visible_length(double linear, double square) {
  const double root = std::sqrt(linear * linear + 4 * square * unseen);
  return root + linear > 0 ? 2 * unseen / (root + linear) : far_away;
}

/// int amplitude(p) exp(i (p^2 x + p t)) dp from p0 along p0 + s direction, s > 0, where it must decay. The phase at
/// p0, thousands of radians, is taken out: its rounding error would look like noise to the adaptive rule.
template <class Amplitude>
Complex ray(Amplitude amplitude, double p0, double x, double t, Complex direction) {
  const double linear = 2 * p0 * x + t;
  const double length = std::min(visible_length(std::abs(linear) / sqrt2, x), far_away * p0);
  const Complex sum = along_ray(
      [&](double s) {
        const Complex step = s * direction;
        return amplitude(p0 + step) * std::exp(i_unit * step * (linear + step * x));
      },
      p0, length);
  return direction * std::polar(1.0, p0 * (p0 * x + t)) * sum;
}

/// int_{p0}^inf amplitude(p) exp(i (p^2 x - p t)) dp, with stationary phase at p = t/(2x).
template <class Amplitude>
Complex approaching(Amplitude amplitude, double p0, double x, double t) {
  if (t <= 2 * x * p0) return ray(amplitude, p0, x, -t, rising);
  if (x == 0) return ray(amplitude, p0, x, -t, std::conj(rising));
  // Down the valley on the left, then from its far end over the saddle: no pole of the amplitude lies in between.
  const double saddle = t / (2 * x);
  const double reach = std::sqrt(unseen / x);
  const Complex over = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double s) { return amplitude(saddle + s * rising) * std::exp(-x * s * s); }, -reach, reach, 12, 1e-13);
  return ray(amplitude, p0, x, -t, -rising) + rising * std::polar(1.0, -0.5 * saddle * t) * over;
}

}  // namespace

WavemakerTransient::WavemakerTransient(Paddle paddle, double gravity, double depth, double frequency, double stroke)
    : steady_(paddle, gravity, depth, frequency, stroke), time_unit_(std::sqrt(depth / gravity)) {
  omega_ = frequency * time_unit_;
  require_within("frequency^2 depth/gravity", omega_ * omega_, 1e-12, 1e3);
}

WavemakerTransient WavemakerTransient::with_period(Paddle paddle, double gravity, double depth, double period,
                                                   double stroke) {
  require_positive("period", period);
  return {paddle, gravity, depth, 2 * pi / period, stroke};
}

double WavemakerTransient::up_to(double split, double x, double t) const {
  const bool flap = steady_.paddle() == Paddle::flap;
  const double forced = std::sin(omega_ * t);
  const auto integrand = [&](double k) {
    const double tanh = std::tanh(k);
    const double w = std::sqrt(k * tanh);
    // B as a divided difference: sin(omega t) - sin(w t) as a product leaves nothing to cancel at w = omega.
    const double b = (forced + w * t * std::cos(0.5 * (omega_ + w) * t) * sinc(0.5 * (omega_ - w) * t)) / (omega_ + w);
    const double half = std::sinh(0.5 * k) / k;
    const double q = tanh / k - (flap ? 2 * half * half / std::cosh(k) : 0);
    return q * b * std::cos(k * x);
  };
  // Panels of at most half a unit (the poles of tanh are 1.57 from the axis) and six radians of either phase.
  double sum = 0;
  for (double k = 0; k < split;) {
    const double group = k < 1 ? 1 : 0.5 / std::sqrt(k);
    const double next = std::min(split, k + std::min(0.5, 6 / (x + group * t)));
    sum += boost::math::quadrature::gauss<double, 20>::integrate(integrand, k, next);
    k = next;
  }
  return sum;
}

double WavemakerTransient::beyond(double split, double x, double t) const {
  const bool flap = steady_.paddle() == Paddle::flap;
  const double nu = omega_ * omega_;
  const auto q = [flap](Complex k) { return flap ? (k - 1.0) / (k * k) : 1.0 / k; };
  const Complex forced = along_ray(
      [&](double s) {
        const Complex k{split, s};
        return q(k) / (nu - k) * std::exp(-s * x);
      },
      split, x > 0 ? std::min(unseen / x, far_away * split) : far_away * split);
  const auto amplitude = [&](Complex p) { return 2.0 * p * p * q(p * p) / (nu - p * p); };
  const double p0 = std::sqrt(split);
  const Complex free = ray(amplitude, p0, x, t, rising) - approaching(amplitude, p0, x, t);
  return omega_ * std::sin(omega_ * t) * (i_unit * std::polar(1.0, split * x) * forced).real() - 0.5 * free.imag();
}

double WavemakerTransient::scaled_elevation(double x, double t, double split) const {
  if (t == 0 || ahead_of_waves(x, t)) return 0;
  return omega_ / pi * (up_to(split, x, t) + beyond(split, x, t));
}

double WavemakerTransient::elevation(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  if (x < 0) throw OutsideFluid(fmt::format("x = {:.17g} is behind the paddle: must be >= 0", x));
  return steady_.stroke() * scaled_elevation(x / steady_.depth(), t / time_unit_, split_for(omega_ * omega_));
}

double WavemakerTransient::initial_rate_of_piston(double x) const {
  require_positive("x", x);
  if (steady_.paddle() != Paddle::piston) throw std::invalid_argument("paddle = flap: must be piston");
  return -steady_.stroke() * steady_.frequency() / pi * std::log(std::tanh(0.25 * pi * x / steady_.depth()));
}

Provenance WavemakerTransient::provenance() {
  return {
      "Kennard, Generation of surface waves by a moving partition, Quart. Appl. Math. 7 (1949) 303; Joo, Schultz and "
      "Messiter, J. Fluid Mech. 214 (1990) 161",
      "eta = (2/pi) int q(k) [w sin wt - w_k sin(w_k t)]/(w^2 - w_k^2) cos(kx) dk, w_k^2 = k tanh k"};
}

double WavemakerTransient::uncertainty() const {
  return 1e-12;
}

SelfTest WavemakerTransient::self_test() const {
  const double split = split_for(omega_ * omega_);
  const double period = 2 * pi / omega_;
  Worst shifted;
  for (const double x : {0.0, 0.01, 0.5, 4.0, 20.0}) {
    for (const double t : {0.01, 0.3, 1.0, 3.0, 10.0}) {
      shifted.add(scaled_elevation(x, t * period, 1.7 * split) - scaled_elevation(x, t * period, split));
    }
  }
  SelfTest test{{"the elevation does not depend on where the path leaves the real axis",
                 shifted.value() / steady_.height_per_stroke(), uncertainty(), "both parts are integrated to 1e-13"}};
  if (steady_.paddle() == Paddle::piston) {
    // eta = t eta'(0) (1 + O(t^2)): one extrapolation leaves t^4.
    const double t = 1e-3 * std::min(1.0, period);
    const double depth = steady_.depth();
    const double fine = elevation(depth, 0.5 * t * time_unit_) / (0.5 * t * time_unit_);
    const double coarse = elevation(depth, t * time_unit_) / (t * time_unit_);
    test.push_back({"the surface rises at first as (omega S/pi) ln coth(pi x/(4 d))",
                    std::abs((4 * fine - coarse) / 3 / initial_rate_of_piston(depth) - 1), 1e-8,
                    "rounding of an elevation of 1e-3 of the scale of its parts, divided by the time"});
  }
  return test;
}

static_assert(ReferenceSolution<WavemakerTransient>);

}  // namespace seiche::exact
