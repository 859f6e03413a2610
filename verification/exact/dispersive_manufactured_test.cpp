#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/dispersive_manufactured.hpp"
#include "verification/exact/spectral_derivative.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::dispersive_manufactured_test {

using validation::DispersiveManufactured;
using Parameters = DispersiveManufactured::Parameters;

constexpr double pi = std::numbers::pi;
const std::string source =
    "Bonneton et al., J. Comput. Phys. 230 (2011) 1479; Seabra-Santos, Renouard and Temperville, J. Fluid Mech. 176 "
    "(1987) 117";

Parameters in_frame(bool green_naghdi) {
  Parameters parameters;
  parameters.green_naghdi = green_naghdi;
  return parameters;
}

/// Both sides of the limit equations in Eulerian form at one instant, from the formulas of the motion and from the
/// sources that the solution returns. Derivatives along the channel are spectral.
class Snapshot {
 public:
  Snapshot(const DispersiveManufactured& flow, double t) : par_(flow.parameters()) {
    constexpr Eigen::Index n = 64;
    for (auto* field :
         {&jacobian_, &u_, &acceleration_, &depth_, &y_, &pressure_, &slope_, &curvature_, &source_p_, &source_r_}) {
      field->resize(n);
    }
    const double k = 2 * pi / par_.length;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double a = par_.length * static_cast<double>(i) / n;
      const auto at = flow.at(a, t);
      const double wave = par_.amplitude * std::sin(k * par_.motion_mode * a);
      const auto bottom = flow.bottom(at.x);
      jacobian_[i] =
          1 + par_.amplitude * k * par_.motion_mode * std::cos(k * par_.motion_mode * a) * std::cos(par_.frequency * t);
      u_[i] = -par_.frequency * wave * std::sin(par_.frequency * t);
      acceleration_[i] = -par_.frequency * par_.frequency * wave * std::cos(par_.frequency * t);
      depth_[i] = flow.volume_density(a) / jacobian_[i];
      y_[i] = bottom.height + depth_[i];
      pressure_[i] = par_.pressure * std::cos(k * par_.pressure_mode * a) * std::sin(par_.frequency * t);
      slope_[i] = bottom.slope;
      curvature_[i] = bottom.curvature;
      source_p_[i] = at.source_p;
      source_r_[i] = at.source_r;
    }
  }

  /// Residual of the Green-Naghdi momentum equation over an uneven bottom, in the operators T and Q of Bonneton et al.,
  /// against what the sources contribute.
  [[nodiscard]] double green_naghdi() const {
    const Eigen::ArrayXd h = depth_, d = acceleration_;
    const Eigen::ArrayXd u_x = along(u_), d_x = along(d);
    const Eigen::ArrayXd inertia = -along(h.cube() * d_x) / (3 * h) +
                                   (along(h.square() * slope_ * d) - h.square() * slope_ * d_x) / (2 * h) +
                                   slope_.square() * d;
    const Eigen::ArrayXd quadratic = 2 * h * (along(h) + slope_ / 2) * u_x.square() +
                                     4.0 / 3 * h.square() * u_x * along(u_x) + h * curvature_ * u_ * u_x +
                                     (along(y_) * curvature_ + h / 2 * along(curvature_)) * u_.square();
    const Eigen::ArrayXd momentum = d + inertia + par_.gravity * along(y_) + quadratic;
    const Eigen::ArrayXd contributed =
        source_p_ * (1 + slope_.square() / 4).sqrt() + 1.5 * slope_ * source_r_ + along(h.square() * source_r_) / h;
    return worst(momentum - contributed);
  }

  /// Residuals of Frank's limit equations, D p = -c (g y_x + (H pi)_x/H) and
  /// alpha D r = c (pi/H + b' (g y_x + (H pi)_x/H + b' pi/H)), p = u/c + s DH, r = c DH.
  [[nodiscard]] double frank() const {
    const Eigen::ArrayXd c = 1 / (1 + slope_.square()).sqrt();
    const Eigen::ArrayXd s = slope_ * c;
    const Eigen::ArrayXd u_x = along(u_);
    const Eigen::ArrayXd deepening = -depth_ * u_x;
    const Eigen::ArrayXd deepening_rate = depth_ * (2 * u_x.square() - along(acceleration_));
    const Eigen::ArrayXd turning = curvature_ * c.square() * u_;
    const Eigen::ArrayXd p_rate =
        acceleration_ / c + u_ * s / c * turning / c + s * deepening_rate + c * turning * deepening;
    const Eigen::ArrayXd r_rate = c * deepening_rate - s * turning * deepening;
    const Eigen::ArrayXd gradient = par_.gravity * along(y_) + along(depth_ * pressure_) / depth_;
    const Eigen::ArrayXd lift = pressure_ / depth_;
    const Eigen::ArrayXd along_bottom = p_rate + c * gradient - source_p_;
    const Eigen::ArrayXd across = par_.alpha * r_rate - c * (lift + slope_ * (gradient + slope_ * lift)) - source_r_;
    return worst(std::array{worst(along_bottom), worst(across)});
  }

 private:
  [[nodiscard]] Eigen::ArrayXd along(const Eigen::ArrayXd& f) const {
    return (spectral_derivative(f.size(), par_.length) * f.matrix()).array() / jacobian_;
  }

  Parameters par_;
  Eigen::ArrayXd jacobian_, u_, acceleration_, depth_, y_, pressure_, slope_, curvature_, source_p_, source_r_;
};

TEST_CASE("the manufactured motion over an uneven bottom satisfies the forced dispersive equations", "[exact]") {
  Check check("exact_dispersive_manufactured",
              "Manufactured solution of dispersive shallow water over an uneven bottom",
              "The sources in label coordinates against the equations of the literature in Eulerian form, with "
              "spectral derivatives along the channel: the Green-Naghdi equations in the operators of Bonneton et al., "
              "and the limit of Frank's model. On a flat bottom both have the same sources. Mass, velocities and "
              "equations of motion by finite differences of the values returned alone.",
              source);
  const DispersiveManufactured frank;
  const DispersiveManufactured green_naghdi(in_frame(true));
  Largest frank_residual, green_naghdi_residual;
  for (double t = 0.2; t < 8; t += 0.7) {
    frank_residual.add(Snapshot(frank, t).frank());
    green_naghdi_residual.add(Snapshot(green_naghdi, t).green_naghdi());
  }
  // A spectral derivative multiplies round-off, which has all wavenumbers alike, by their root mean square, 1/sqrt(3)
  // of the highest, 2 pi/10 * 32, two derivatives by 1/sqrt(5) of its square; and it adds that of its sums: 64 terms,
  // of which the largest are a third of the highest wavenumber. Labels are compressed by no more than 1.25.
  const double highest = 2 * pi / 10 * 32;
  check.that("green-naghdi", "The sources in the Green-Naghdi frame agree with the Green-Naghdi momentum equation.",
             "residual of the momentum equation [m/s^2]",
             {.value = green_naghdi_residual.value(), .resolution = "64 labels"},
             Roundoff{60 + 2 * 64, 0.2 * 1.5 * 1.5 * std::pow(1.25 * highest, 2) / (3 * std::sqrt(5)),
                      "twice differentiated: mean fourth power of the wavenumbers, its root, times H^2/3; "
                      "accelerations below 0.2 rounded 60 times, 64 sums per derivative"});
  check.from("Frank, Discrete models of incompressible fluids (1994), ch. 3, formulas 11, 12")
      .that("frank", "The sources in the frame along the bed agree with the limit of Frank's model.",
            "residual of both equations [m/s^2]", {.value = frank_residual.value(), .resolution = "64 labels"},
            Roundoff{60 + 64, 1.25 * highest / std::sqrt(3),
                     "once differentiated; values below 1 rounded 60 times, 64 sums"});
  Worst flat;
  Parameters level = in_frame(false);
  level.bottom_amplitude = 0;
  Parameters level_green_naghdi = in_frame(true);
  level_green_naghdi.bottom_amplitude = 0;
  for (double a = 0; a < 10; a += 0.3) {
    const auto one = DispersiveManufactured(level).at(a, 1.3);
    const auto other = DispersiveManufactured(level_green_naghdi).at(a, 1.3);
    flat.add(one.source_p - other.source_p);
    flat.add(one.source_r - other.source_r);
    flat.add(one.p - other.p);
    flat.add(one.r - other.r);
  }
  check.that("flat", "The sources of both frames agree on a flat bed to round-off.",
             "largest difference of rates and sources [m/s]", {flat.value()},
             Roundoff{10, 1, "the same sums with exact zeros added"});
  const auto a_label = frank.at(2.5, 0.7);
  const auto one_period_on = frank.at(12.5, 0.7);
  CHECK(std::abs(one_period_on.x - a_label.x - 10) < 1e-14);
  CHECK(std::abs(one_period_on.source_p - a_label.source_p) < 1e-14);
  self_test_holds(check, "frank", frank);
  self_test_holds(check, "green-naghdi", green_naghdi);
  Parameters dimensional{.gravity = 9.81,
                         .depth = 0.4,
                         .length = 3,
                         .amplitude = 0.05,
                         .frequency = 4,
                         .pressure = 0.1,
                         .bottom_amplitude = 0.1,
                         .motion_mode = 2,
                         .bottom_mode = 1,
                         .pressure_mode = 3,
                         .alpha = 0.4,
                         .green_naghdi = true};
  self_test_holds(check, "alpha-0-4", DispersiveManufactured(dimensional));
  dimensional.green_naghdi = false;
  self_test_holds(check, "alpha-0-4-frank", DispersiveManufactured(dimensional));
  dimensional.gamma = 1.0 / 15;
  self_test_holds(check, "gamma-frank", DispersiveManufactured(dimensional));
  dimensional.green_naghdi = true;
  self_test_holds(check, "gamma", DispersiveManufactured(dimensional));
  dimensional.amplitude = 0.3;
  CHECK_THROWS_AS(DispersiveManufactured(dimensional), std::invalid_argument);
  dimensional.amplitude = 0.05;
  dimensional.bottom_amplitude = 0.4;
  CHECK_THROWS_AS(DispersiveManufactured(dimensional), std::invalid_argument);
  CHECK_THROWS_AS(frank.at(std::nan(""), 0), std::invalid_argument);
}

}  // namespace seiche::verification::dispersive_manufactured_test
