#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Dense>

#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/plan_manufactured.hpp"
#include "verification/exact/spectral_derivative.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::manufactured_2dh_test {

using validation::PlanManufactured;
using Field = Eigen::ArrayXXd;  // labels: X along rows, Y along columns

constexpr double pi = std::numbers::pi;
constexpr Eigen::Index period_points = 48;  // over [0, 2 L) either way, where the motion has period 2 L
const std::string source =
    "Green and Naghdi, J. Fluid Mech. 78 (1976) 237; Miles and Salmon, J. Fluid Mech. 157 (1985) 519";

/// The Green-Naghdi equations in Eulerian form at one instant, from the formulas of the motion alone.
class Snapshot {
 public:
  Snapshot(const PlanManufactured::Parameters& p, double t)
      : derivative_(spectral_derivative(period_points, 2 * p.length)) {
    const Field shape = Field::Zero(period_points, period_points);
    Field x = shape, y = shape, u = shape, v = shape;
    ax_ = shape;
    ay_ = shape;
    const double w = p.frequency;
    for (Eigen::Index i = 0; i < period_points; ++i) {
      for (Eigen::Index j = 0; j < period_points; ++j) {
        const double X = 2 * pi * static_cast<double>(i) / period_points;
        const double Y = 2 * pi * static_cast<double>(j) / period_points;
        const double one = p.amplitude * std::sin(X) * std::cos(Y);
        const double two = 0.7 * p.amplitude * std::cos(X) * std::sin(Y);
        const double three = 0.3 * p.amplitude * std::cos(2 * X) * std::sin(2 * Y);
        x(i, j) = one * std::cos(w * t + 0.5);
        y(i, j) = two * std::cos(w * t + 1) + three * std::sin(w * t);
        u(i, j) = -w * one * std::sin(w * t + 0.5);
        v(i, j) = -w * two * std::sin(w * t + 1) + w * three * std::cos(w * t);
        ax_(i, j) = -w * w * x(i, j);
        ay_(i, j) = -w * w * y(i, j);
      }
    }
    x_x_ = 1 + by_x(x);
    x_y_ = by_y(x);
    y_x_ = by_x(y);
    y_y_ = 1 + by_y(y);
    jacobian_ = x_x_ * y_y_ - x_y_ * y_x_;
    const Field depth = p.depth / jacobian_;
    const Field expansion = along_x(u) + along_y(v);
    const Field shear = along_x(u).square() + 2 * along_y(u) * along_x(v) + along_y(v).square();  // tr (grad u)^2
    const Field lift =
        depth.cube() * (expansion.square() + shear - along_x(ax_) - along_y(ay_));  // H^2 times its second rate
    force_x_ = ax_ + p.gravity * along_x(depth) + p.alpha / depth * along_x(lift);
    force_y_ = ay_ + p.gravity * along_y(depth) + p.alpha / depth * along_y(lift);
  }

  /// Largest deviation from the force of the solution [m/s^2], inside the basin.
  [[nodiscard]] double deviation(const PlanManufactured& flow, double t) const {
    Worst worst;
    const double step = 2 * flow.parameters().length / period_points;
    for (Eigen::Index i = 0; i <= period_points / 2; ++i) {
      for (Eigen::Index j = 0; j <= period_points / 2; ++j) {
        const auto at = flow.at(std::min(step * static_cast<double>(i), flow.parameters().length),
                                std::min(step * static_cast<double>(j), flow.parameters().length), t);
        worst.add(at.bx - force_x_(i, j));
        worst.add(at.by - force_y_(i, j));
      }
    }
    return worst.value();
  }

 private:
  [[nodiscard]] Field by_x(const Field& f) const { return (derivative_ * f.matrix()).array(); }
  [[nodiscard]] Field by_y(const Field& f) const { return (f.matrix() * derivative_.transpose()).array(); }
  [[nodiscard]] Field along_x(const Field& f) const { return (by_x(f) * y_y_ - by_y(f) * y_x_) / jacobian_; }
  [[nodiscard]] Field along_y(const Field& f) const { return (by_y(f) * x_x_ - by_x(f) * x_y_) / jacobian_; }

  Eigen::MatrixXd derivative_;
  Field ax_, ay_, x_x_, x_y_, y_x_, y_y_, jacobian_, force_x_, force_y_;
};

void claim_labels(Check& check, const PlanManufactured& flow) {
  const double length = flow.parameters().length;
  Worst worst;
  constexpr int points = 24;
  for (double t = 0; t < 5; t += 0.7) {
    for (int i = 0; i <= points; ++i) {
      for (int j = 0; j <= points; ++j) {
        const double a = length * i / points, b = length * j / points;
        const auto at = flow.at(a, b, t);
        const auto label = flow.label(std::clamp(at.x, 0.0, length), std::clamp(at.y, 0.0, length), t);
        worst.add(label.x - a);
        worst.add(label.y - b);
      }
    }
  }
  check.that("labels", "The label found at a position is the label of the column that is there.",
             "largest deviation of a label [m]", {.value = worst.value(), .resolution = "25 by 25 columns, 8 times"},
             Roundoff{20, length / 0.6, "positions rounded ten times there and back, divided by J above 0.6"});
}

TEST_CASE("the manufactured motion in 2DH satisfies the forced Green-Naghdi equations", "[exact]") {
  Check check("exact_2dh_manufactured", "Manufactured solution of the Green-Naghdi equations in 2DH",
              "The body force in label coordinates against the equations in Eulerian form, $D^2 H = H ((\\nabla\\cdot "
              "u)^2 + \\mathrm{tr}(\\nabla u)^2 - \\nabla\\cdot Du)$, with spectral derivatives; mass, velocities and "
              "both equations of motion by finite differences of the values returned alone.",
              source);
  const PlanManufactured flow;
  PlanManufactured::Parameters steep{
      .gravity = 9.81, .depth = 0.4, .length = 3, .amplitude = -0.2, .frequency = 4, .alpha = 0.4};
  Largest deviation;
  for (double t = 0.1; t < 5; t += 0.6) {
    deviation.add(Snapshot(flow.parameters(), t).deviation(flow, t));
  }
  const double highest = 0.5 * period_points;
  check.that("force", "The body force agrees with the Green-Naghdi equations in Eulerian form.",
             "largest deviation of a component [m/s^2]",
             {.value = deviation.value(), .resolution = "48 by 48 labels over [0, 2 pi)^2, 9 times"},
             Roundoff{60 * 60, highest * highest / 3,
                      "twice differentiated: highest wavenumber squared, times alpha H^2; accelerations below 1 "
                      "rounded 60 times, 60 sums in effect per derivative"});
  self_test_holds(check, "default", flow);
  self_test_holds(check, "dimensional", PlanManufactured(steep));
  claim_labels(check, flow);
  steep.amplitude = 0.3;
  CHECK_THROWS_AS(PlanManufactured(steep), std::invalid_argument);
  steep.amplitude = 0.1;
  steep.alpha = 0;
  CHECK_THROWS_AS(PlanManufactured(steep), std::invalid_argument);
  CHECK_THROWS_AS(flow.at(-0.1, 1, 0), std::invalid_argument);
  CHECK_THROWS_AS(flow.at(1, 1, std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(flow.label(1, 4, 0), std::invalid_argument);
}

}  // namespace seiche::verification::manufactured_2dh_test
