#include "seiche/exact/solitary_runup.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_sf_bessel.h>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace {

/// e^{-40} = 4e-18: what lies below it does not show.
constexpr double invisible = 40;
/// The zeros of J0 - i J1 nearest the real axis are +-2.98 - 1.28 i: a beach rings down as e^{-0.64 t/X0}.
constexpr double ringing_rate = 0.6398;

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

}  // namespace

SolitaryRunup::SolitaryRunup(double gravity, double depth, double amplitude, double cotangent, double refinement)
    : depth_(depth), toe_(cotangent) {
  require_all_positive({{"gravity", gravity}, {"depth", depth}, {"amplitude", amplitude}});
  require_within("cotangent", cotangent, 1e-3, 1e4);
  require_within("amplitude/depth", amplitude / depth, 1e-6, 1);
  time_unit_ = std::sqrt(depth / gravity);
  amplitude_ = amplitude / depth;
  gamma_ = std::sqrt(0.75 * amplitude_);
  const double alpha = 0.5 * std::numbers::pi / gamma_;

  // Step 1: the window outside which nothing moves. The crest needs 2 X0 from the toe to the shoreline.
  arrival_ = 2 * toe_ - 0.5 * invisible / gamma_;
  end_ = 2 * toe_ + 0.5 * invisible / gamma_ + invisible * toe_ / ringing_rate;

  // Step 2: the transform at the points of the trapezoidal rule; its period 2 pi/h covers the window, so that the
  // copies it adds to R are invisible.
  wavenumber_step_ = 2 * std::numbers::pi / (refinement * (end_ - arrival_));
  const double largest = refinement * (invisible + 5) / alpha;  // csch(alpha k), and 5 for the factor k^{3/2} before it
  const auto count = static_cast<std::size_t>(std::ceil(largest / wavenumber_step_));
  real_.reserve(count);
  imaginary_.reserve(count);
  for (std::size_t j = 0; j < count; ++j) {
    const double k = static_cast<double>(j) * wavenumber_step_;
    // 2 Re over k > 0, the ordinate at 0 once; Phi(0) = (2/3)/alpha.
    const double phi = j == 0 ? 1 / (3 * alpha) : 2.0 / 3 * k / std::sinh(alpha * k);
    const std::complex<double> response(gsl_sf_bessel_J0(2 * k * toe_), -gsl_sf_bessel_J1(2 * k * toe_));
    const std::complex<double> value = 4 * wavenumber_step_ * phi / response;
    real_.push_back(value.real());
    imaginary_.push_back(value.imag());
  }

  // Step 3: the highest and the lowest shoreline. The motion follows the wave, of duration 1/gamma, and the beach's
  // ringing, of period 2 pi/(2.98/(2 X0)) = 4.2 X0.
  const double duration = 1 / gamma_ + toe_;
  highest_ = *extreme(arrival_, 2 * toe_ + 5 * duration, 1);
  const double crest = highest_.time / time_unit_;
  const double quiet = crest + 10 * duration;
  lowest_ = extreme(crest, quiet, -1);

  // Step 4: how steep it becomes, and when it breaks.
  const double span = std::min(1 / gamma_, toe_) / 50;
  Largest run_up, overall;
  Worst excursion;
  for (double tau = arrival_; tau < quiet; tau += span) {
    const Jet here = jet(tau);
    const double bend = toe_ * toe_ * here.curvature;
    if (bend >= 1 && std::isinf(breaking_time_)) {
      const double vertical = root([&](double s) { return toe_ * toe_ * jet(s).curvature - 1; }, tau - span, tau);
      breaking_time_ = time_unit_ * (vertical - toe_ * toe_ * jet(vertical).slope);
    }
    if (tau < crest) run_up.add(bend);
    overall.add(bend);
    excursion.add(toe_ * toe_ * here.slope);
  }
  steepness_ = {.run_up = run_up.value(), .overall = overall.value()};
  excursion_ = excursion.value();
}

SolitaryRunup::Jet SolitaryRunup::jet(double tau) const {
  if (!(tau > arrival_ && tau < end_)) return {0, 0, 0};
  Jet sum{0, 0, 0};
  for (std::size_t j = 0; j < real_.size(); ++j) {
    const double k = static_cast<double>(j) * wavenumber_step_;
    const double cosine = std::cos(k * tau);
    const double sine = std::sin(k * tau);
    const double term = real_[j] * cosine + imaginary_[j] * sine;
    sum.value += term;
    sum.slope += k * (imaginary_[j] * cosine - real_[j] * sine);
    sum.curvature -= k * k * term;
  }
  return sum;
}

std::optional<SolitaryRunup::Extreme> SolitaryRunup::extreme(double from, double to, double sign) const {
  const double span = std::min(1 / gamma_, toe_) / 20;
  Largest best;
  for (double t = from; t < to; t += span) best.add(sign * jet(t).value, t);
  if (!(best.value() >= 1e-12 * amplitude_)) return {};
  const double time = root([&](double t) { return jet(t).slope; }, best.where() - span, best.where() + span);
  return Extreme{jet(time).value * depth_, time * time_unit_};
}

double SolitaryRunup::linear_elevation(double t) const {
  require_finite("t", t);
  return depth_ * jet(t / time_unit_).value;
}

SolitaryRunup::Shoreline SolitaryRunup::shoreline(double t) const {
  require_finite("t", t);
  require_that(t < breaking_time_,
               "t = {:.17g} is out of range: must be before the wave breaks at the shoreline, {:.6g}", t,
               breaking_time_);
  // The first tau with tau - X0^2 R'(tau) = t: before breaking the left side increases.
  const double time = t / time_unit_;
  const auto ahead = [&](double tau) { return tau - toe_ * toe_ * jet(tau).slope - time; };
  const double span = std::min(1 / gamma_, toe_) / 20;
  double later = time - 1.01 * excursion_;
  while (ahead(later) < 0) later += span;
  const double tau = root(ahead, later - span, later);
  const Jet at = jet(tau);
  const double speed = toe_ * at.slope;
  return {depth_ * (at.value - 0.5 * speed * speed), depth_ / time_unit_ * speed};
}

SelfTest SolitaryRunup::self_test() const {
  const double gravity = depth_ / (time_unit_ * time_unit_);
  const SolitaryRunup finer(gravity, depth_, amplitude_ * depth_, toe_, 1.5);
  Worst change, before;
  for (int i = 0; i <= 40; ++i) {
    const double t = time_unit_ * (arrival_ + (end_ - arrival_) * i / 40);
    change.add(finer.linear_elevation(t) - linear_elevation(t));
    // The crest's forerunner e^{2 gamma (t - 2 X0)} is still below 1e-15 here; the terms that cancel are not.
    const double early = arrival_ + 2.5 / gamma_ * i / 40;
    before.add(finer.linear_elevation(time_unit_ * early));
  }
  const double crest = highest_.elevation;
  // Of the difference of two sums at tau, relative to the crest: every addition rounds a sum as high as the crest, and
  // every term its phase k tau.
  const auto rounding = [&](double tau) {
    auto square = static_cast<double>(real_.size());
    for (std::size_t j = 0; j < real_.size(); ++j) {
      const double turns = static_cast<double>(j) * wavenumber_step_ * tau * depth_ / crest;
      square += (real_[j] * real_[j] + imaginary_[j] * imaginary_[j]) * turns * turns;
    }
    return 4 * epsilon * std::sqrt(2 * square);
  };
  return {{"a finer and longer rule gives the same elevation", change.value() / crest, rounding(end_),
           fmt::format("the rule converges exponentially; {} additions to sums up to R, and the rounded phases of "
                       "their terms at the last time",
                       real_.size())},
          {"a finer and longer rule gives the same maximum", std::abs(finer.highest_.elevation / crest - 1),
           rounding(highest_.time / time_unit_), "the same, with the phases at the time of the maximum"},
          {"the shoreline rests before the wave arrives", before.value() / crest, uncertainty(),
           "causality, by cancellation of terms up to a fifth of R"}};
}

HallWatts::HallWatts(double depth, double slope) : depth_(depth) {
  require_positive("depth", depth);
  require_within("slope", slope, tangent(5) * (1 - 1e-12), 1 + 1e-12);
  const bool steep = slope >= tangent(12);
  coefficient_ = steep ? 3.05 * std::pow(slope, -0.13) : 11 * std::pow(slope, 0.67);
  exponent_ = steep ? 1.15 * std::pow(slope, 0.02) : 1.9 * std::pow(slope, 0.35);
}

double HallWatts::runup(double amplitude) const {
  require_positive("amplitude", amplitude);
  return depth_ * coefficient_ * std::pow(amplitude / depth_, exponent_);
}

SelfTest HallWatts::self_test() const {
  const double low = runup(0.1 * depth_);
  const double high = runup(0.4 * depth_);
  return {{"R is a power of a: R(a) R(4 a) = R(2 a)^2", std::abs(low * high / std::pow(runup(0.2 * depth_), 2) - 1),
           4e-15, "five powers of one rounding each and four products"}};
}

static_assert(ReferenceSolution<HallWatts>);

ExactSolution solitary_runup_entry() {
  return Entry<SolitaryRunup>{
      .name = "solitary_runup",
      .title = "Run-up of a solitary wave on a plane beach: the integral of Carrier, Greenspan and Synolakis",
      .citation =
          "Synolakis, The runup of solitary waves, J. Fluid Mech. 185 (1987) 523; Carrier and Greenspan, J. Fluid "
          "Mech. 4 (1958) 97",
      .formula =
          "R = int (4/3) k csch(pi k/(2 gamma)) e^{-ikt}/(J0(2 k X0) - i J1(2 k X0)) dk; law 2.831 sqrt(cot b) a^{5/4}",
      .parameters = {{"amplitude", "m", 0.019, 1e-9, 1e6, "crest height of the incident wave"},
                     depth_parameter(1, 1e6),
                     {"cot_slope", "1", 19.85, 0.1, 1e3, "cotangent of the beach's angle"},
                     gravity_parameter()},
      .inputs = {{"t", "s", 0, "time, 0 when the crest is at the toe of the beach"}},
      .outputs = {{"eta", "m", "elevation at the initial shoreline, linear theory"}},
      .scalars = {{"runup", "m", "highest shoreline, of linear and nonlinear theory alike", &SolitaryRunup::highest,
                   &SolitaryRunup::Extreme::elevation},
                  {"runup_time", "s", "when", &SolitaryRunup::highest, &SolitaryRunup::Extreme::time},
                  {"rundown", "m", "lowest shoreline, negative; NaN on a beach too short for one",
                   [](const SolitaryRunup& wave) { return wave.lowest() ? wave.lowest()->elevation : none_given; }},
                  {"rundown_time", "s", "when",
                   [](const SolitaryRunup& wave) { return wave.lowest() ? wave.lowest()->time : none_given; }},
                  {"law", "m", "run-up law 2.831 sqrt(cot) a^(5/4), the leading term of runup", &SolitaryRunup::law},
                  {"breaking_amplitude", "m", "amplitude from which the wave breaks during run-up",
                   &SolitaryRunup::breaking_amplitude}},
      .make = made_by(
          [](double g, double depth, double amplitude, double cotangent) {
            // Beaches so gentle that waves of this height break far out, and that the quadrature takes minutes.
            require_within("cot_slope sqrt(amplitude/depth)", cotangent * std::sqrt(amplitude / depth), 0, 30);
            return SolitaryRunup(g, depth, amplitude, cotangent);
          },
          "gravity", "depth", "amplitude", "cot_slope"),
      .row = [](const SolitaryRunup& wave, At at) { return Row{wave.linear_elevation(at[0])}; }};
}

ExactSolution hall_watts_entry() {
  struct Beach : HallWatts {
    double amplitude;
  };
  return Entry<Beach>{
      .name = "hall_watts",
      .title = "Correlation of measured solitary-wave run-up on plane beaches",
      .citation =
          "Hall and Watts, Laboratory investigation of the vertical rise of solitary waves on impermeable slopes, "
          "Beach Erosion Board Tech. Memo. 33 (1953), as quoted by Synolakis, J. Fluid Mech. 185 (1987) 523",
      .formula = "R = 3.05 S^-0.13 a^(1.15 S^0.02), 12 to 45 deg; R = 11 S^0.67 a^(1.9 S^0.35), 5 to 12 deg",
      .parameters = {{"amplitude", "m", 0.1, 1e-9, 1e6, "crest height of the incident wave"},
                     depth_parameter(1, 1e6),
                     {"cot_slope", "1", 1, 1, 11.430052302761343, "cotangent of the beach's angle, 5 to 45 degrees"}},
      .inputs = {},
      .outputs = {{"runup", "m", "run-up; standard uncertainty of the correlation 5 per cent"}},
      .scalars = {},
      .make = made_by(
          [](double depth, double cot, double amplitude) {
            return Beach{{depth, 1 / cot}, amplitude};
          },
          "depth", "cot_slope", "amplitude"),
      .row = [](const Beach& beach, At) { return Row{beach.runup(beach.amplitude)}; }};
}

}  // namespace seiche::exact
