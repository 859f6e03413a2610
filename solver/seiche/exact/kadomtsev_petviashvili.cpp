#include "seiche/exact/kadomtsev_petviashvili.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<KadomtsevPetviashvili>);

namespace {

/// e_i e_j with weight exp(constant).
ExponentialSum::Term product(double k_i, double k_j, double constant = 0) {
  return {{k_i + k_j, k_i * k_i + k_j * k_j, -(k_i * k_i * k_i + k_j * k_j * k_j)}, constant};
}

constexpr double closest_to_one = 1e-6;
/// Largest kappa. The rates of the exponentials differ by a kappa-th of themselves, and that squared is what waves that
/// meet so steeply do to each other.
constexpr double steepest = 100;

}  // namespace

double KadomtsevPetviashvili::Crest::angle() const {
  return std::atan(std::abs(lean));
}

KadomtsevPetviashvili::KadomtsevPetviashvili(double amplitude, double angle, double depth, double gravity,
                                             Pattern pattern)
    : depth_(depth), pattern_(pattern), tau_({}) {
  require_positive("amplitude", amplitude);
  require_positive("depth", depth);
  require_positive("gravity", gravity);
  require_positive("angle", angle);
  require_within("angle", angle, 0, std::nextafter(0.5 * std::numbers::pi, 0));
  celerity_ = std::sqrt(gravity * depth);
  const double sum = std::sqrt(3 * amplitude / depth);
  const double slope = std::tan(angle);
  kappa_ = slope / sum;
  if (std::abs(kappa_ - 1) < closest_to_one) {
    throw std::invalid_argument(fmt::format(
        "kappa = tan(angle)/sqrt(3 amplitude/depth) = {:.9g} is out of range: must differ from 1 by at least {:g}",
        kappa_, closest_to_one));
  }
  if (pattern == Pattern::resonant_triad) {
    require_within("kappa = tan(angle)/sqrt(3 amplitude/depth) of a resonant triad", kappa_, 0, 1);
  }
  require_within("kappa = tan(angle)/sqrt(3 amplitude/depth)", kappa_, 0, steepest);
  outer_ = 0.5 * (sum + slope);
  inner_ = 0.5 * (sum - slope);
  tau_ = tau_function(pattern);
  // Without a stem the crests are displaced by the logarithm of the coupling.
  const double shift = has_stem() ? 0 : 0.5 * std::log((1 - 1 / kappa_) * (1 + 1 / kappa_)) / sum;
  incident_ = crest(-outer_, inner_, shift);
  reflected_ = crest(std::abs(inner_), outer_, -shift);
  wall_ = has_stem() ? crest(-outer_, outer_) : crest(-outer_, inner_);
  wall_.lean = 0;
  wall_.amplitude = has_stem() ? (1 + kappa_) * (1 + kappa_) * amplitude
                               : 4 * amplitude / (1 + std::sqrt((kappa_ - 1) * (kappa_ + 1)) / kappa_);
}

ExponentialSum KadomtsevPetviashvili::tau_function(Pattern pattern) const {
  const double K = outer_;
  const double q = inner_;
  if (!has_stem()) {
    const double coupling = 0.5 * std::log((1 - 1 / kappa_) * (1 + 1 / kappa_));
    // k = (-K, q, -q, K) with q < 0
    return ExponentialSum({product(-K, -q), product(q, K), product(-K, K, coupling), product(q, -q, coupling)});
  }
  std::vector<ExponentialSum::Term> terms{product(-K, q), product(-K, K), product(q, K)};
  if (pattern == Pattern::wall_reflection) {
    terms.push_back(product(-q, q));
    terms.push_back(product(-q, K, -std::log((1 - kappa_) * (1 + kappa_))));
  }
  return ExponentialSum(std::move(terms));
}

KadomtsevPetviashvili::Crest KadomtsevPetviashvili::crest(double k_i, double k_j, double shift) const {
  const double width = k_j - k_i;
  const double travel = k_i * k_i + k_i * k_j + k_j * k_j;
  return {depth_ * width * width / 3, -(k_i + k_j), celerity_ * (1 + 2 * travel / 3), depth_ * shift};
}

ExponentialSum::Triple KadomtsevPetviashvili::scaled(double x, double y, double t) const {
  require_finite("x", x);
  require_finite("y", y);
  require_finite("t", t);
  return {(x - celerity_ * t) / depth_, y / depth_, 2 * celerity_ * t / (3 * depth_)};
}

double KadomtsevPetviashvili::elevation(double x, double y, double t) const {
  return 4 * depth_ / 3 * tau_.log_derivative(scaled(x, y, t), {2, 0, 0});
}

KadomtsevPetviashvili::Point KadomtsevPetviashvili::triple_point(double t) const {
  if (!has_stem()) {
    throw std::logic_error(fmt::format("no stem and no triple point at kappa = {:g}: kappa < 1 is needed", kappa_));
  }
  return {wall_.at(0, t), 2 * inner_ * celerity_ * t / 3};
}

double KadomtsevPetviashvili::settling_rate() const {
  // On the wall at the stem's crest e1 e4 is smaller than e1 e3 = e3 e4 by exp(-q (K^2 - q^2) T).
  return has_stem() ? 2 * celerity_ / (3 * depth_) * inner_ * (outer_ - inner_) * (outer_ + inner_) : 0;
}

double KadomtsevPetviashvili::equation_defect(double x, double y, double t) const {
  const ExponentialSum::Triple at = scaled(x, y, t);
  const auto u = [&](int in_x, int in_y, int in_t) { return 2 * tau_.log_derivative(at, {in_x + 2, in_y, in_t}); };
  const double change = 4 * u(1, 0, 1);
  const double steepening = 6 * (u(1, 0, 0) * u(1, 0, 0) + u(0, 0, 0) * u(2, 0, 0));
  const double dispersion = u(4, 0, 0);
  const double spreading = 3 * u(0, 2, 0);
  return (change + steepening + dispersion + spreading) /
         std::max({std::abs(change), std::abs(steepening), std::abs(dispersion), std::abs(spreading)});
}

double KadomtsevPetviashvili::uncertainty() const {
  // Exponents up to a few hundred within that many depths of the crests, each with two or three roundings.
  return 1000 * std::numeric_limits<double>::epsilon();
}

SelfTest KadomtsevPetviashvili::self_test() const {
  // Lengths along x and y and the time in which the waves change.
  const double across = depth_ / (outer_ + inner_);
  const double steep = std::max(1.0, kappa_);
  const double along = across / ((outer_ + inner_) * steep);
  const double time = along / (celerity_ * (outer_ + inner_) * steep);
  Worst equation;
  for (const double s : {-1.3, 0.2, 0.9}) {
    for (const double r : {0.0, 0.4, 1.7}) {
      for (const double p : {0.0, 1.1}) {
        equation.add(equation_defect(wall_.at(0, p * time) + s * across, r * along, p * time));
      }
    }
  }
  const double limit = 4000 * std::numeric_limits<double>::epsilon();
  SelfTest test{{"the equation holds", equation.value(), limit,
                 "cumulants of order 6 of up to 5 terms: 400 roundings, terms that cancel to a tenth of their size"}};
  if (has_stem()) {
    const double triad = std::sqrt(wall_.amplitude) - std::sqrt(incident_.amplitude) - std::sqrt(reflected_.amplitude);
    test.push_back({"sqrt(a_w) = sqrt(a_i) + sqrt(a_r)", std::abs(triad) / std::sqrt(wall_.amplitude),
                    8 * std::numeric_limits<double>::epsilon(), "8 roundings"});
  }
  if (pattern_ == Pattern::wall_reflection) {
    const double here = elevation(wall_.at(0, time) + 0.3 * across, 0.7 * along, time);
    const double mirrored = elevation(wall_.at(0, time) + 0.3 * across, -0.7 * along, time);
    test.push_back({"eta(y) = eta(-y)", std::abs(here - mirrored) / incident_.amplitude,
                    100 * std::numeric_limits<double>::epsilon(), "exponents up to 10 and their exponential"});
  }
  return test;
}

Provenance KadomtsevPetviashvili::provenance() {
  return {
      "Kadomtsev and Petviashvili, Sov. Phys. Dokl. 15 (1970) 539; Miles, J. Fluid Mech. 79 (1977) 171; Kodama, J. "
      "Phys. "
      "A 43 (2010) 434004; Kodama and Yeh, J. Fluid Mech. 800 (2016) 766",
      "eta = (4h/3) (ln tau)_XX, X = (x - c0 t)/h, tau = e1 e3 + e1 e4 + e2 e3 + e3 e4 + e2 e4/(1 - kappa^2) for "
      "kappa < 1, e1 e3 + e2 e4 + sqrt(1 - kappa^-2) (e1 e4 + e2 e3) for kappa > 1, e_j = exp(k_j X + k_j^2 Y - "
      "k_j^3 T)"};
}

}  // namespace seiche::exact
