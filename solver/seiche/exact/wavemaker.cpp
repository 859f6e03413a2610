#include "seiche/exact/wavemaker.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "seiche/exact/dispersion.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

using std::numbers::pi;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Modes summed one by one; beyond about nu/pi their coefficients fall as n^-3 and the rest is summed as a whole.
long modes_before_tail(double nu) {
  return 400 + std::lround(std::min(nu, 1e6));
}

}  // namespace

std::string_view name_of(Paddle paddle) {
  return paddle == Paddle::piston ? "piston" : "flap";
}

Wavemaker::Wavemaker(Paddle paddle, double gravity, double depth, double frequency, double stroke)
    : paddle_(paddle), gravity_(gravity), depth_(depth), frequency_(frequency), stroke_(stroke) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("frequency", frequency);
  require_finite("stroke", stroke);
  nu_ = frequency * frequency * depth / gravity;
  require_within("frequency^2 depth/gravity", nu_, 1e-12, 1e6);
  wavenumber_ = AiryDispersion(1, 1).wavenumber(std::sqrt(nu_));
  // Divided through by cosh k, which would overflow: 4 sinh^2 k/(sinh 2k + 2k) = 2 tanh k/(1 + 2k/sinh 2k).
  const double k = wavenumber_;
  const double slow = 1 + 2 * k / std::sinh(2 * k);
  const double half = std::sinh(0.5 * k);
  const double missing = k > 40 ? 1 / k : 2 * half * half / (k * std::cosh(k));  // (1 - 1/cosh k)/k
  height_per_stroke_ = 2 * (std::tanh(k) - (paddle == Paddle::flap ? missing : 0)) / slow;
}

Wavemaker Wavemaker::with_period(Paddle paddle, double gravity, double depth, double period, double stroke) {
  require_positive("period", period);
  return {paddle, gravity, depth, 2 * pi / period, stroke};
}

Wavemaker Wavemaker::with_wavelength(Paddle paddle, double gravity, double depth, double wavelength, double stroke) {
  require_positive("wavelength", wavelength);
  return {paddle, gravity, depth, AiryDispersion(gravity, depth).frequency(2 * pi / wavelength), stroke};
}

double Wavemaker::period() const {
  return 2 * pi / frequency_;
}
double Wavemaker::wavelength() const {
  return 2 * pi / wavenumber();
}

double Wavemaker::scaled_wavenumber(double n) const {
  // k tan k = -nu on the n-th branch is k = n pi - atan(nu/k), increasing in k with slope above 0.68: Newton is safe.
  double k = (n - 0.25) * pi;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (k - n * pi + std::atan2(nu_, k)) / (1 - nu_ / (k * k + nu_ * nu_));
    k -= step;
    if (std::abs(step) <= 2 * eps * k) break;
  }
  return k;
}

// C_n = smooth_part(k_n) + (-1)^n alternating_part(k_n).
double Wavemaker::smooth_part(double k) const {
  const double common = 2 * nu_ / (k * (k * k + nu_ * nu_ - nu_));
  return paddle_ == Paddle::piston ? common * nu_ : common * (nu_ - 1);
}

double Wavemaker::alternating_part(double k) const {
  if (paddle_ == Paddle::piston) return 0;
  return 2 * nu_ * std::hypot(k, nu_) / (k * k * (k * k + nu_ * nu_ - nu_));
}

double Wavemaker::evanescent_wavenumber(long n) const {
  require_at_least("n", n, 1);
  return scaled_wavenumber(static_cast<double>(n)) / depth_;
}

double Wavemaker::coefficient(long n) const {
  require_at_least("n", n, 1);
  const double k = scaled_wavenumber(static_cast<double>(n));
  return smooth_part(k) + (n % 2 == 0 ? 1 : -1) * alternating_part(k);
}

/// sum C_n weight(k_n); `decay` is the rate with which weight falls exponentially with k, 0 if it does not.
template <class Weight>
double Wavemaker::sum_of_modes(Weight weight, double decay, long first_omitted) const {
  double sum = 0;
  for (long n = 1; n < first_omitted; ++n) {
    const double k = scaled_wavenumber(static_cast<double>(n));
    if (decay * k > 40) return sum;
    sum += (smooth_part(k) + (n % 2 == 0 ? 1 : -1) * alternating_part(k)) * weight(k);
  }
  const auto smooth = [&](double n) {
    const double k = scaled_wavenumber(n);
    return smooth_part(k) * weight(k);
  };
  const auto alternating = [&](double n) {
    const double k = scaled_wavenumber(n);
    return alternating_part(k) * weight(k);
  };
  const auto slope = [](const auto& f, double n) { return f(n + 0.5) - f(n - 0.5); };
  const auto bend = [](const auto& f, double n) { return f(n + 1.5) - 3 * f(n + 0.5) + 3 * f(n - 0.5) - f(n - 1.5); };
  // Euler-Maclaurin from the midpoint before the first omitted mode, with dn/dk = (1 - nu/(k^2 + nu^2))/pi and
  // k = first/u. With D = d/dn and the central difference delta = 2 sinh(D/2), D = delta - delta^3/24 + ...,
  //   1/(2 sinh(D/2)) = 1/D - D/24 + 7 D^3/5760 - ... = 1/D - delta/24 + 17 delta^3/5760 - ...
  const double middle = static_cast<double>(first_omitted) - 0.5;
  const double first = scaled_wavenumber(middle);
  const double integral = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      [&](double u) {
        const double k = first / u;
        return smooth_part(k) * weight(k) * (1 - nu_ / (k * k + nu_ * nu_)) / pi * k / u;
      },
      0.0, 1.0, 10, 1e-10);
  sum += integral + slope(smooth, middle) / 24 - 17.0 / 5760 * bend(smooth, middle);
  // Boole's sum of an alternating series, 1/(1 + exp(D)) = 1/2 - D/4 + D^3/48 - ... = 1/2 - delta/4 + delta^3/32 - ...
  const auto n = static_cast<double>(first_omitted);
  const double rest = 0.5 * alternating(n) - 0.25 * slope(alternating, n) + bend(alternating, n) / 32;
  return sum + (first_omitted % 2 == 0 ? rest : -rest);
}

double Wavemaker::progressive(double x, double t) const {
  return 0.5 * stroke_ * height_per_stroke_ * std::cos(wavenumber_ * x / depth_ - frequency_ * t);
}

double Wavemaker::elevation(double x, double t) const {
  require_finite("x", x);
  require_finite("t", t);
  if (x < 0) throw OutsideFluid(fmt::format("x = {:.17g} is behind the paddle: must be >= 0", x));
  const double distance = x / depth_;
  const double near =
      sum_of_modes([distance](double k) { return std::exp(-k * distance); }, distance, modes_before_tail(nu_));
  return progressive(x, t) + 0.5 * stroke_ * near * std::sin(frequency_ * t);
}

double Wavemaker::paddle_position(double t) const {
  require_finite("t", t);
  return 0.5 * stroke_ * std::sin(frequency_ * t);
}

Provenance Wavemaker::provenance() {
  return {
      "Havelock, Forced surface-waves on water, Phil. Mag. 8 (1929) 569; Dean and Dalrymple, Water Wave Mechanics for "
      "Engineers and Scientists (1991), ch. 6",
      "piston H/S = 4 sinh^2 k/(sinh 2k + 2k), flap H/S = 4 (sinh k/k)(k sinh k - cosh k + 1)/(sinh 2k + 2k), "
      "near field sum C_n exp(-k_n x), k_n tan k_n = -nu"};
}

double Wavemaker::uncertainty() const {
  return 1e-13;
}

SelfTest Wavemaker::self_test() const {
  const long modes = modes_before_tail(nu_);
  const auto one = [](double) { return 1.0; };
  const auto length = [](double k) { return 1 / k; };
  const double volume = paddle_ == Paddle::piston ? 1 : 0.5;
  const double k1 = scaled_wavenumber(1);
  const double first = std::abs(coefficient(1));
  const double under_near_field = sum_of_modes(length, 0, modes);
  const double near_field = sum_of_modes(one, 0, modes);
  // Sums as large as their first term or their value: random walks of the additions to them, and of the twenty
  // roundings of H/S, k and their quotient.
  const double volume_walk =
      std::sqrt(20) + std::sqrt(static_cast<double>(modes)) * (first / k1 + std::abs(under_near_field)) / volume;
  const double tail_walk = std::sqrt(0.5 * static_cast<double>(modes)) * (first + std::abs(near_field));
  return {
      {"k tanh k = omega^2", std::abs(wavenumber_ * std::tanh(wavenumber_) / nu_ - 1), 8 * eps, "8 roundings"},
      {"k_1 sin k_1 + omega^2 cos k_1 = 0", std::abs(k1 * std::sin(k1) + nu_ * std::cos(k1)) / std::hypot(k1, nu_),
       (4 + k1) * eps,
       "k_1 rounded once and one step of Newton's method in it, half a unit of its last place each; pi, arc tangent "
       "and the products of sine and cosine, an epsilon each"},
      {"water displaced by the paddle is under the surface: (H/S)/k + sum C_n/k_n = mean of f",
       std::abs(height_per_stroke_ / wavenumber_ + under_near_field - volume) / volume, 4 * eps * volume_walk,
       fmt::format("20 roundings of the progressive wave's part and {} additions to the near field's, closed by "
                   "Euler-Maclaurin to below round-off",
                   modes)},
      {"the near field does not depend on where its tail begins",
       std::abs(near_field - sum_of_modes(one, 0, modes + modes / 2)), 4 * eps * tail_walk,
       fmt::format("the first {} modes are the same in both sums: additions of the {} further ones", modes,
                   modes / 2)}};
}

static_assert(ReferenceSolution<Wavemaker>);

}  // namespace seiche::exact
