#include "seiche/exact/dispersion.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/dispersion_identities.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<AiryDispersion>);
static_assert(ReferenceSolution<RationalDispersion>);

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double ten_roundings = 10 * std::numeric_limits<double>::epsilon();

}  // namespace

AiryDispersion::AiryDispersion(double gravity, double depth) : gravity_(gravity), depth_(depth) {
  require_positive("gravity", gravity);
  if (depth != endless) require_positive("depth", depth);
}

double AiryDispersion::frequency(double k) const {
  require_positive("wavenumber", k);
  return std::sqrt(gravity_ * k * std::tanh(k * depth_));
}

double AiryDispersion::phase_speed(double k) const {
  require_positive("wavenumber", k);
  return std::sqrt(gravity_ / k * std::tanh(k * depth_));
}

double AiryDispersion::group_speed(double k) const {
  const double twice = 2 * k * depth_;
  const double ratio = twice > 700 ? 0 : twice / std::sinh(twice);  // sinh overflows; the ratio is below 1e-300
  return 0.5 * (1 + ratio) * phase_speed(k);
}

double AiryDispersion::wavenumber(double omega) const {
  require_positive("frequency", omega);
  const double deep = omega * omega / gravity_;
  if (depth_ == endless) return deep;
  const double nu = deep * depth_;
  double kappa = nu / std::sqrt(std::tanh(nu));  // within 5 %: four steps square that below round-off
  for (int step = 0; step < 4; ++step) {
    const double t = std::tanh(kappa);
    kappa -= (kappa * t - nu) / (t + kappa * (1 - t) * (1 + t));
  }
  return kappa / depth_;
}

Provenance AiryDispersion::provenance() {
  return {"Airy, Tides and waves, Encyclopaedia Metropolitana (1845)", "omega^2 = g k tanh(k H)"};
}

double AiryDispersion::uncertainty() const {
  return ten_roundings;
}

SelfTest AiryDispersion::self_test() const {
  const double scale = depth_ == endless ? 1 : depth_;
  SelfTest identities{wavenumber_identity(*this, 1e-4 / scale, 1e3 / scale)};
  // Over endless depth the group speed is singular at k = 0, out of reach of quadrature: there c_g = c/2.
  if (depth_ == endless) {
    identities.push_back({"group speed = half the phase speed", std::abs(2 * group_speed(1) / phase_speed(1) - 1),
                          1e-15, "four roundings"});
  } else {
    identities.push_back(group_speed_identity(*this, 6 / scale));
  }
  return identities;
}

RationalDispersion::RationalDispersion(double gravity, double depth, double numerator, double denominator)
    : gravity_(gravity), depth_(depth), numerator_(numerator), denominator_(denominator) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("denominator", denominator);
  require_within("numerator", numerator, 0, denominator);
}

RationalDispersion RationalDispersion::green_naghdi(double gravity, double depth, double alpha) {
  require_positive("alpha", alpha);
  return {gravity, depth, 0, alpha};
}

RationalDispersion RationalDispersion::nwogu(double gravity, double depth, double a) {
  require_within("A", a, -0.5, -1.0 / 3);
  return {gravity, depth, -(a + 1.0 / 3), -a};
}

RationalDispersion RationalDispersion::madsen_sorensen(double gravity, double depth, double b) {
  require_not_negative("B", b);
  return {gravity, depth, b, b + 1.0 / 3};
}

double RationalDispersion::phase_speed(double k) const {
  require_positive("wavenumber", k);
  const double square = k * depth_ * k * depth_;
  return std::sqrt(gravity_ * depth_ * (1 + numerator_ * square) / (1 + denominator_ * square));
}

double RationalDispersion::frequency(double k) const {
  return k * phase_speed(k);
}

double RationalDispersion::group_speed(double k) const {
  const double c = phase_speed(k);
  const double square = k * depth_ * k * depth_;
  // d ln omega/d ln k = 1 + n kappa^2/(1 + n kappa^2) - d kappa^2/(1 + d kappa^2)
  return c * (1 - (denominator_ - numerator_) * square / ((1 + numerator_ * square) * (1 + denominator_ * square)));
}

double RationalDispersion::highest_frequency() const {
  return numerator_ > 0 ? endless : std::sqrt(gravity_ / (denominator_ * depth_));
}

double RationalDispersion::wavenumber(double omega) const {
  require_positive("frequency", omega);
  const double nu = omega * omega * depth_ / gravity_;
  if (numerator_ == 0) {
    const double r = omega / highest_frequency();
    if (!(r < 1)) {
      throw std::invalid_argument(
          fmt::format("frequency = {:.17g} is out of range: must be below {:.17g}, the limit of "
                      "short waves",
                      omega, highest_frequency()));
    }
    return std::sqrt(nu / ((1 - r) * (1 + r))) / depth_;
  }
  // n s^2 + (1 - d nu) s - nu = 0 for s = kappa^2, in the form without cancellation for either sign of 1 - d nu.
  const double linear = 1 - denominator_ * nu;
  const double root = std::sqrt(linear * linear + 4 * numerator_ * nu);
  const double square = linear >= 0 ? 2 * nu / (linear + root) : (root - linear) / (2 * numerator_);
  return std::sqrt(square) / depth_;
}

Provenance RationalDispersion::provenance() {
  return {"Peregrine (1967); Green and Naghdi (1976); Madsen and Sorensen (1992); Nwogu (1993)",
          "omega^2 = g H k^2 (1 + n (kH)^2)/(1 + d (kH)^2): n = 0, d = 1/3 (Green-Naghdi); n = B, d = B + 1/3 "
          "(Madsen-Sorensen); n = -(A + 1/3), d = -A (Nwogu)"};
}

double RationalDispersion::uncertainty() const {
  return ten_roundings;
}

SelfTest RationalDispersion::self_test() const {
  return {wavenumber_identity(*this, 1e-4 / depth_, 30 / depth_), group_speed_identity(*this, 6 / depth_)};
}

}  // namespace seiche::exact
