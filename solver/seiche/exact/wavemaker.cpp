#include "seiche/exact/wavemaker.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace {

using std::numbers::pi;

/// Modes summed one by one; beyond about nu/pi their coefficients fall as n^-3 and the rest is summed as a whole.
long modes_before_tail(double nu) {
  return 400 + std::lround(std::min(nu, 1e6));
}

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

std::string_view name_of(Paddle paddle) {
  return paddle == Paddle::piston ? "piston" : "flap";
}

Wavemaker::Wavemaker(Paddle paddle, const Water& water, const WaveScale& wave, double stroke)
    : paddle_(paddle),
      gravity_(water.gravity),
      depth_(water.depth),
      frequency_(AiryDispersion(water.gravity, water.depth).frequency_of(wave)),
      stroke_(stroke) {
  require_positive("depth", depth_);
  require_finite("stroke", stroke);
  nu_ = frequency_ * frequency_ * depth_ / gravity_;
  require_within("frequency^2 depth/gravity", nu_, 1e-12, 1e6);
  wavenumber_ = AiryDispersion(1, 1).wavenumber(std::sqrt(nu_));
  // Divided through by cosh k, which would overflow: 4 sinh^2 k/(sinh 2k + 2k) = 2 tanh k/(1 + 2k/sinh 2k).
  const double k = wavenumber_;
  const double slow = 1 + 2 * k / std::sinh(2 * k);
  const double half = std::sinh(0.5 * k);
  const double missing = k > 40 ? 1 / k : 2 * half * half / (k * std::cosh(k));  // (1 - 1/cosh k)/k
  height_per_stroke_ = 2 * (std::tanh(k) - (paddle == Paddle::flap ? missing : 0)) / slow;
}

double Wavemaker::scaled_wavenumber(double n) const {
  // k tan k = -nu on the n-th branch is k = n pi - atan(nu/k), increasing in k with slope above 0.68: Newton is safe.
  double k = (n - 0.25) * pi;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (k - n * pi + std::atan2(nu_, k)) / (1 - nu_ / (k * k + nu_ * nu_));
    k -= step;
    if (std::abs(step) <= 2 * epsilon * k) break;
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

double Wavemaker::elevation(double x, double t) const {
  require_finite("x", x);
  require_finite("t", t);
  require_that<OutsideFluid>(x >= 0, "x = {:.17g} is behind the paddle: must be >= 0", x);
  const double distance = x / depth_;
  const double near =
      sum_of_modes([distance](double k) { return std::exp(-k * distance); }, distance, modes_before_tail(nu_));
  return progressive(x, t) + 0.5 * stroke_ * near * std::sin(frequency_ * t);
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
  return {{"k tanh k = omega^2", std::abs(wavenumber_ * std::tanh(wavenumber_) / nu_ - 1), 8 * epsilon, "8 roundings"},
          {"k_1 sin k_1 + omega^2 cos k_1 = 0", std::abs(k1 * std::sin(k1) + nu_ * std::cos(k1)) / std::hypot(k1, nu_),
           (4 + k1) * epsilon,
           "k_1 rounded once and one step of Newton's method in it, half a unit of its last place each; pi, arc "
           "tangent and the products of sine and cosine, an epsilon each"},
          {"water displaced by the paddle is under the surface: (H/S)/k + sum C_n/k_n = mean of f",
           std::abs(height_per_stroke_ / wavenumber_ + under_near_field - volume) / volume, 4 * epsilon * volume_walk,
           fmt::format("20 roundings of the progressive wave's part and {} additions to the near field's, closed by "
                       "Euler-Maclaurin to below round-off",
                       modes)},
          {"the near field does not depend on where its tail begins",
           std::abs(near_field - sum_of_modes(one, 0, modes + modes / 2)), 4 * epsilon * tail_walk,
           fmt::format("the first {} modes are the same in both sums: additions of the {} further ones", modes,
                       modes / 2)}};
}

WavemakerTransient::WavemakerTransient(Paddle paddle, const Water& water, const WaveScale& wave, double stroke)
    : steady_(paddle, water, wave, stroke),
      time_unit_(std::sqrt(water.depth / water.gravity)),
      omega_(steady_.frequency() * time_unit_) {
  require_within("frequency^2 depth/gravity", omega_ * omega_, 1e-12, 1e3);
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
  require_that<OutsideFluid>(x >= 0, "x = {:.17g} is behind the paddle: must be >= 0", x);
  return steady_.stroke() * scaled_elevation(x / steady_.depth(), t / time_unit_, split_for(omega_ * omega_));
}

double WavemakerTransient::initial_rate_of_piston(double x) const {
  require_positive("x", x);
  require_that(steady_.paddle() == Paddle::piston, "paddle = flap: must be piston");
  return -steady_.stroke() * steady_.frequency() / pi * std::log(std::tanh(0.25 * pi * x / steady_.depth()));
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

ExactSolution wavemaker_entry() {
  return Entry<Wavemaker>{
      .name = "wavemaker",
      .title = "Waves of a piston or a bottom-hinged flap, with the near field",
      .citation =
          "Havelock, Forced surface-waves on water, Phil. Mag. 8 (1929) 569; Dean and Dalrymple, Water Wave Mechanics "
          "for Engineers and Scientists (1991), ch. 6",
      .formula =
          "piston H/S = 4 sinh^2 k/(sinh 2k + 2k), flap H/S = 4 (sinh k/k)(k sinh k - cosh k + 1)/(sinh 2k + 2k), near "
          "field sum C_n exp(-k_n x), k_n tan k_n = -nu",
      .parameters = {{"kind", "1", 0, 0, 1, "paddle", {"piston", "flap"}},
                     depth_parameter(1, 1e6),
                     gravity_parameter(),
                     {"period", "s", 2, 0, 1e6, "period; 0: it follows from the wavelength"},
                     {"wavelength", "m", 0, 0, 1e9, "wavelength of the progressive wave, where period is 0"},
                     {"stroke", "m", 1, 0, 1e6, "stroke at the still-water level; 0: it follows from the height"},
                     {"height", "m", 0, 0, 1e6, "height of the progressive wave, where stroke is 0"}},
      .inputs = {{"x", "m", 0, "distance from the paddle"}, time_t},
      .outputs = {{"eta", "m", "surface elevation of the settled motion"},
                  {"progressive", "m", "the progressive wave alone"}},
      .scalars = {{"stroke_ratio", "1", "height of the progressive wave over the stroke, H/S",
                   &Wavemaker::height_per_stroke},
                  {"stroke", "m", "stroke", &Wavemaker::stroke},
                  {"wave_height", "m", "height of the progressive wave", &Wavemaker::wave_height},
                  {"period", "s", "period", &Wavemaker::period},
                  {"wavenumber", "1/m", "of the progressive wave", &Wavemaker::wavenumber},
                  {"evanescent_1", "1/m", "k_1 of the near field",
                   [](const Wavemaker& maker) { return maker.evanescent_wavenumber(1); }},
                  {"coefficient_1", "1", "C_1", [](const Wavemaker& maker) { return maker.coefficient(1); }},
                  {"evanescent_2", "1/m", "k_2 of the near field",
                   [](const Wavemaker& maker) { return maker.evanescent_wavenumber(2); }},
                  {"coefficient_2", "1", "C_2", [](const Wavemaker& maker) { return maker.coefficient(2); }}},
      .make = made_by(
          [](Paddle kind, double depth, double g, double period, double length, double stroke, double height) {
            const WaveScale wave = period > 0 ? WaveScale(Period{period}) : Wavelength{length};
            const double stroke_of_height = Wavemaker(kind, {g, depth}, wave).stroke_for(height);
            return Wavemaker(kind, {g, depth}, wave, stroke > 0 ? stroke : stroke_of_height);
          },
          "kind", "depth", "gravity", "period", "wavelength", "stroke", "height"),
      .row = [](const Wavemaker& maker, At at) {
        return Row{maker.elevation(at[0], at[1]), maker.progressive(at[0], at[1])};
      }};
}

ExactSolution wavemaker_start_entry() {
  return Entry<WavemakerTransient>{
      .name = "wavemaker_start",
      .title = "A piston or a flap starts from rest: the transient of linear theory",
      .citation =
          "Kennard, Generation of surface waves by a moving partition, Quart. Appl. Math. 7 (1949) 303; Joo, Schultz "
          "and Messiter, J. Fluid Mech. 214 (1990) 161",
      .formula = "eta = (2/pi) int q(k) [w sin wt - w_k sin(w_k t)]/(w^2 - w_k^2) cos(kx) dk, w_k^2 = k tanh k",
      .parameters = {{"kind", "1", 1, 0, 1, "paddle", {"piston", "flap"}},
                     depth_parameter(1, 1e6),
                     gravity_parameter(),
                     {"period", "s", 2, 1e-9, 1e6, "period"},
                     {"stroke", "m", 1, 1e-12, 1e6, "stroke at the still-water level"}},
      .inputs = {{"x", "m", 1, "distance from the paddle"}, time_t},
      .outputs = {surface_eta, {"settled", "m", "what it tends to"}},
      .scalars = {{"wave_height", "m", "height of the settled progressive wave", &WavemakerTransient::steady,
                   &Wavemaker::wave_height},
                  {"wavenumber", "1/m", "of the settled progressive wave", &WavemakerTransient::steady,
                   &Wavemaker::wavenumber}},
      .make = made_by(
          [](Paddle kind, double depth, double g, double period, double stroke) {
            // Waves of 600 depths: the panels of the quadrature over a period grow with the period.
            require_within("period sqrt(gravity/depth)", period * std::sqrt(g / depth), 0, 600);
            return WavemakerTransient(kind, {g, depth}, Period{period}, stroke);
          },
          "kind", "depth", "gravity", "period", "stroke"),
      .row = [](const WavemakerTransient& start, At at) {
        return Row{start.elevation(at[0], at[1]), start.steady().elevation(at[0], at[1])};
      }};
}

}  // namespace seiche::exact
