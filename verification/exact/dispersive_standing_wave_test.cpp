#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "seiche/exact/standing_wave.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_standing_wave_test {

using namespace exact;
using Parameters = DispersiveStandingWave::Parameters;

constexpr double pi = std::numbers::pi;
const std::string source = "Frank, Discrete models of incompressible fluids (1994), ch. 3; averaged Lagrangian";

/// The stated Lagrangian, unexpanded, made stationary over sums of harmonics c sin(m k a) cos(n theta): g = H = 1.
class HarmonicBalance {
 public:
  HarmonicBalance(double kh, const Parameters& parameters) : k_(kh), parameters_(parameters) {
    for (int m = 1; m <= highest; ++m) {
      for (int n = m % 2; n <= highest; n += 2) add(m, n);
    }
  }

  /// Frequency with the first harmonic of the displacement e/k: Newton's method.
  [[nodiscard]] double frequency(double e) const {
    const Eigen::Index count = rate_.cols();
    // The frequency stands in the place of the first harmonic's coefficient.
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(count);
    unknowns[0] = k_ * std::sqrt((1 + parameters_.gamma * k_ * k_) / (1 + parameters_.alpha * k_ * k_));
    for (int iteration = 0; iteration < 6; ++iteration) {
      Eigen::MatrixXd slope(count, count);
      for (Eigen::Index j = 0; j < count; ++j) {
        const Eigen::VectorXd span = 1e-6 * Eigen::VectorXd::Unit(count, j);
        slope.col(j) = (defect(e, unknowns + span) - defect(e, unknowns - span)) / 2e-6;
      }
      unknowns -= slope.partialPivLu().solve(defect(e, unknowns));
    }
    return unknowns[0];
  }

 private:
  static constexpr int highest = 6;
  static constexpr Eigen::Index points = 24;

  /// Values of a harmonic, and of its derivatives by theta and a, over half a wave and half a period.
  void add(int m, int n) {
    const Eigen::Index column = rate_.cols();
    for (auto* field : {&rate_, &strain_, &strain_rate_, &strain_slope_}) {
      field->conservativeResize(points * points, column + 1);
    }
    for (Eigen::Index i = 0; i < points * points; ++i) {
      const Eigen::Index row = i / points;
      const double ka = m * pi * (static_cast<double>(row) + 0.5) / points;
      const double theta = n * pi * (static_cast<double>(i % points) + 0.5) / points;
      rate_(i, column) = -n * std::sin(ka) * std::sin(theta);
      strain_(i, column) = m * k_ * std::cos(ka) * std::cos(theta);
      strain_rate_(i, column) = -m * k_ * n * std::cos(ka) * std::sin(theta);
      strain_slope_(i, column) = -m * k_ * m * k_ * std::sin(ka) * std::cos(theta);
    }
  }

  /// Derivative of the mean Lagrangian by each coefficient.
  [[nodiscard]] Eigen::VectorXd defect(double e, const Eigen::VectorXd& unknowns) const {
    const auto& [alpha, gamma, exponent] = parameters_;
    const double w = unknowns[0];
    Eigen::VectorXd c = unknowns;
    c[0] = -e / k_;
    const Eigen::ArrayXd jacobian = 1 + (strain_ * c).array();
    const Eigen::ArrayXd strain_rate = w * (strain_rate_ * c).array();
    const Eigen::ArrayXd slope = (strain_slope_ * c).array();
    const Eigen::ArrayXd stiffness = gamma * jacobian.pow(-exponent - 5);
    const Eigen::ArrayXd by_strain = -2 * alpha * strain_rate.square() / jacobian.pow(5) + 0.5 / jacobian.square() +
                                     0.5 * (exponent + 5) * stiffness * slope.square() / jacobian;
    return (w * w * rate_.transpose() * (rate_ * c) + strain_.transpose() * by_strain.matrix() +
            w * strain_rate_.transpose() * (alpha * strain_rate / jacobian.pow(4)).matrix() -
            strain_slope_.transpose() * (stiffness * slope).matrix()) /
           (points * points);
  }

  double k_;
  Parameters parameters_;
  Eigen::MatrixXd rate_, strain_, strain_rate_, strain_slope_;
};

/// Relative change of frequency over (amplitude/depth)^2 in water.
double in_water(double kh) {
  return kh * kh * StandingWave::frequency_correction(kh) / (2 * StandingWave::linear_frequency(kh));
}

const Parameters improved{.alpha = 0.4, .gamma = 1.0 / 15};

Parameters weighted(double exponent) {
  return {improved.alpha, improved.gamma, exponent};
}

void draw(Check& check, double exponent) {
  auto& figure = check.figure("frequency", "Change of a standing wave's frequency with amplitude",
                              "The model has the change of sign that water has, at a longer wave ($kH = 0.942$ instead "
                              "of 1.058). An added energy of slopes, which corrects the linear dispersion, removes it "
                              "unless that energy is weighted with a power of the depth near 0.71.");
  auto& panel =
      figure.panel({.x = "k H", .y = "C", .title = "Omega = omega (1 + C (a/H)^2)", .y_min = -0.4, .y_max = 0.6});
  const std::vector<double> depths = validation::evenly(0.4, 1.8, 141);
  const auto line = [&](const std::string& label, Role role, const auto& correction) {
    panel.line(label, depths, validation::each(depths, correction), role);
  };
  line("Tadjbakhsh and Keller", Role::exact, in_water);
  const auto model = [](const Parameters& parameters) {
    return [parameters](double kh) { return DispersiveStandingWave::frequency_correction(kh, parameters); };
  };
  line("gamma = 0", Role::computed, model({}));
  line("gamma = 1/15, s = 2", Role::peer, model(weighted(2)));
  line("gamma = 1/15, s = 0", Role::guide, model(weighted(0)));
  line("gamma = 1/15, s = 0.71", Role::data, model(weighted(exponent)));
}

TEST_CASE("the frequency of a standing wave of the dispersive model follows from harmonic balance", "[exact]") {
  Check check(
      "exact_dispersive_standing_wave", "Standing wave of the dispersive shallow-water model",
      "Third-order frequency against frequencies of the unexpanded Lagrangian, made stationary over 21 "
      "harmonics: the formula leaves them with the fourth power of the amplitude. The "
      "weight of an added energy of slopes that makes the frequency independent of amplitude where it is in water.",
      source);
  const auto correction = [](double kh, const Parameters& parameters) {
    return DispersiveStandingWave::frequency_correction(kh, parameters);
  };
  struct Case {
    std::string id;
    double kh;
    Parameters parameters;
  };
  for (const Case& c : {Case{"plain-0-6", 0.6, {}}, Case{"plain-1-4", 1.4, {}}, Case{"s2-1-3", 1.3, weighted(2)},
                        Case{"s0-1-058", 1.058, weighted(0)}, Case{"s-fraction", 0.8, {0.45, 0.11, 0.7}}}) {
    const HarmonicBalance balance(c.kh, c.parameters);
    Convergence errors;
    for (double e = 0.08; e > 0.008; e /= 2) {
      const DispersiveStandingWave wave(e, 2 * pi / c.kh, 1, 1, c.parameters);
      errors.add(e, std::abs(balance.frequency(e) - wave.frequency()));
    }
    check.that(
        "order-" + c.id, "The frequency differs from the unexpanded Lagrangian's by the fourth power of the amplitude.",
        "order in e of the frequency error", errors.order(1e-13),
        Order{4, 0.1,
              "first neglected order; the next is e^2 <= 0.0064 of it times a ratio of coefficients of order 1 to 10"});
  }
  const double water = StandingWave::critical_depth();
  const auto exponent = DispersiveStandingWave::exponent_for_critical_depth(water, improved.alpha, improved.gamma);
  REQUIRE(exponent.has_value());
  check.from("Tadjbakhsh and Keller, J. Fluid Mech. 8 (1960) 442")
      .that("critical-depth-of-water",
            "The critical wavelength with that exponent equals the theoretical one of water to round-off.",
            "critical k H", {DispersiveStandingWave::critical_depth(weighted(*exponent)).value_or(0)},
            Bound{4 * std::numeric_limits<double>::epsilon() * std::sqrt(60) / 0.5,
                  "terms up to 1 rounded 60 times, over a slope of 0.5 in k H", water});
  check.from("Tadjbakhsh and Keller, J. Fluid Mech. 8 (1960) 442")
      .that("long-waves",
            "The change of frequency with amplitude agrees with Tadjbakhsh and Keller (1960) within 1e-4.",
            "C over the value of Tadjbakhsh and Keller at k H = 0.01", {correction(0.01, {}) / in_water(0.01)},
            Bound{1e-4, "relative rest of order (k H)^2 = 1e-4", 1});
  draw(check, *exponent);
  CHECK_FALSE(DispersiveStandingWave::critical_depth(weighted(2)).has_value());
  CHECK_THROWS_AS(correction(-1, {}), std::invalid_argument);
}

}  // namespace seiche::verification::dispersive_standing_wave_test
