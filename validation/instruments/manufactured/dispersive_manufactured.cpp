#include "validation/instruments/manufactured/dispersive_manufactured.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/difference.hpp"

namespace seiche::validation {

namespace {

using Sample = DispersiveManufactured::Sample;
using Bottom = DispersiveManufactured::Bottom;

/// Velocity and acceleration of a surface label.
struct Motion {
  double u, v, u_rate, v_rate;
};

/// Rates p, r and their derivatives in time.
struct Rates {
  double p, r, p_rate, r_rate;
};

/// One over the length of the tangent (1, b'): cosine of the bottom's angle.
double cosine(const Bottom& bottom) {
  return 1 / std::sqrt(1 + bottom.slope * bottom.slope);
}

Rates rates_along_bottom(const Motion& m, const Bottom& bottom) {
  const double c = cosine(bottom);
  const double s = bottom.slope * c;
  const double p = m.u * c + m.v * s;
  const double r = -m.u * s + m.v * c;
  const double turning = bottom.curvature * c * c * m.u;  // rate of the bottom's angle
  return {p, r, m.u_rate * c + m.v_rate * s + turning * r, -m.u_rate * s + m.v_rate * c - turning * p};
}

/// kappa, mu and q of the header.
struct GreenNaghdiFrame {
  double kappa, mu, q;
  GreenNaghdiFrame(double alpha, double slope)
      : kappa((1 - 2 * alpha) / (2 * alpha)), mu(1 - 1 / (4 * alpha)), q(1 / std::sqrt(1 + mu * slope * slope)) {}
};

Rates rates_of_green_naghdi(const Motion& m, const Bottom& bottom, double alpha) {
  const GreenNaghdiFrame frame(alpha, bottom.slope);
  return {m.u / frame.q, m.v + frame.kappa * bottom.slope * m.u,
          m.u_rate / frame.q + frame.q * frame.mu * bottom.slope * bottom.curvature * m.u * m.u,
          m.v_rate + frame.kappa * (bottom.slope * m.u_rate + bottom.curvature * m.u * m.u)};
}

/// Horizontal and vertical force or velocity.
struct Vector {
  double x, y;
};

Vector velocity(const Sample& at, const Bottom& bottom, const DispersiveManufactured::Parameters& parameters) {
  if (parameters.green_naghdi) {
    const GreenNaghdiFrame frame(parameters.alpha, bottom.slope);
    const double u = frame.q * at.p;
    return {u, at.r - frame.kappa * bottom.slope * u};
  }
  const double c = cosine(bottom);
  const double s = bottom.slope * c;
  return {at.p * c - at.r * s, at.p * s + at.r * c};
}

/// Components of a force per unit mass in the frame of p, r.
Vector generalised(const Vector& force, const Bottom& bottom, const DispersiveManufactured::Parameters& parameters) {
  if (parameters.green_naghdi) {
    const GreenNaghdiFrame frame(parameters.alpha, bottom.slope);
    return {frame.q * (force.x - frame.kappa * bottom.slope * force.y), force.y};
  }
  const double c = cosine(bottom);
  const double s = bottom.slope * c;
  return {c * force.x + s * force.y, -s * force.x + c * force.y};
}

}  // namespace

DispersiveManufactured::DispersiveManufactured(const Parameters& parameters) : parameters_(parameters) {
  require_positive("gravity", parameters.gravity);
  require_positive("depth", parameters.depth);
  require_positive("length", parameters.length);
  require_positive("frequency", parameters.frequency);
  require_finite("pressure", parameters.pressure);
  require_at_least("motion_mode", parameters.motion_mode, 1);
  require_at_least("bottom_mode", parameters.bottom_mode, 1);
  require_at_least("pressure_mode", parameters.pressure_mode, 1);
  const auto wavenumber = [&](int mode) { return 2 * std::numbers::pi * mode / parameters.length; };
  motion_wavenumber_ = wavenumber(parameters.motion_mode);
  bottom_wavenumber_ = wavenumber(parameters.bottom_mode);
  pressure_wavenumber_ = wavenumber(parameters.pressure_mode);
  const double crossing = 0.999 / motion_wavenumber_;
  require_within("amplitude", parameters.amplitude, -crossing, crossing);
  const double drying = 0.999 * parameters.depth;
  require_within("bottom_amplitude", parameters.bottom_amplitude, -drying, drying);
  require_positive("alpha", parameters.alpha);
  require_not_negative("gamma", parameters.gamma);
  // mu >= 0: the energy is positive over any slope.
  if (parameters.green_naghdi) require_within("alpha", parameters.alpha, 0.25, 1);
}

DispersiveManufactured::Bottom DispersiveManufactured::bottom(double x) const {
  const double k = bottom_wavenumber_;
  const double e = parameters_.bottom_amplitude;
  return {-parameters_.depth + e * std::cos(k * x), -e * k * std::sin(k * x), -e * k * k * std::cos(k * x)};
}

double DispersiveManufactured::volume_density(double label) const {
  return parameters_.depth - parameters_.bottom_amplitude * std::cos(bottom_wavenumber_ * label);
}

DispersiveManufactured::Sample DispersiveManufactured::at(double label, double t) const {
  require_finite("label", label);
  require_finite("t", t);
  const double k = motion_wavenumber_;
  const double w = parameters_.frequency;
  const double swing = parameters_.amplitude * std::sin(k * label);
  const double x = label + swing * std::cos(w * t);
  const Bottom bed = bottom(x);

  // x_a = J, its derivatives, and those of H = volume/J
  const double stretch = parameters_.amplitude * k * std::cos(k * label);
  const double jacobian = 1 + stretch * std::cos(w * t);
  const double jacobian_label = -k * k * swing * std::cos(w * t);
  const double jacobian_rate = -w * stretch * std::sin(w * t);
  const double jacobian_rate2 = -w * w * stretch * std::cos(w * t);
  const double volume_slope = parameters_.bottom_amplitude * bottom_wavenumber_ * std::sin(bottom_wavenumber_ * label);
  const double depth = volume_density(label) / jacobian;
  const double depth_label = (volume_slope - depth * jacobian_label) / jacobian;
  const double expansion = jacobian_rate / jacobian;  // u_x
  const double depth_rate = -depth * expansion;
  const double depth_rate2 = depth * (2 * expansion * expansion - jacobian_rate2 / jacobian);

  const double u = -w * swing * std::sin(w * t);
  const double u_rate = -w * w * swing * std::cos(w * t);
  const Motion motion{u, bed.slope * u + depth_rate, u_rate, bed.slope * u_rate + bed.curvature * u * u + depth_rate2};

  const double wave = parameters_.pressure * std::sin(w * t);
  const double pi = wave * std::cos(pressure_wavenumber_ * label);
  const double pi_x = -pressure_wavenumber_ * wave * std::sin(pressure_wavenumber_ * label) / jacobian;
  const double y = bed.height + depth;
  const double y_x = bed.slope + depth_label / jacobian;
  Vector force{-parameters_.gravity * y_x - pi_x - pi * y_x / depth, pi / depth};

  // Improved dispersion; M = H x_a, its derivatives, and those of y along the label.
  const double volume = volume_density(label);
  const double volume_curvature =
      parameters_.bottom_amplitude * bottom_wavenumber_ * bottom_wavenumber_ * std::cos(bottom_wavenumber_ * label);
  const double jacobian_label2 = -k * k * stretch * std::cos(w * t);
  const double depth_label2 =
      (volume_curvature - 2 * depth_label * jacobian_label - depth * jacobian_label2) / jacobian;
  const double y_label = bed.slope * jacobian + depth_label;
  const double y_label2 = bed.curvature * jacobian * jacobian + bed.slope * jacobian_label + depth_label2;
  const double weight = parameters_.gravity * parameters_.gamma / std::pow(jacobian, 3);
  const double pinch = jacobian_label / jacobian;
  force.x -=
      3 * weight / jacobian * y_label * (volume_slope * y_label + volume * y_label2 - 2 * volume * y_label * pinch);
  force.y += weight * (2 * volume_slope * y_label + volume * y_label2 - 3 * volume * y_label * pinch);

  const Rates rates = parameters_.green_naghdi ? rates_of_green_naghdi(motion, bed, parameters_.alpha)
                                               : rates_along_bottom(motion, bed);
  const Vector push = generalised(force, bed, parameters_);
  return {x,
          y,
          rates.p,
          rates.r,
          parameters_.gravity * y + pi,
          rates.p_rate - push.x,
          parameters_.alpha * rates.r_rate - push.y};
}

double DispersiveManufactured::uncertainty() const {
  return 40 * exact::epsilon;
}

exact::SelfTest DispersiveManufactured::self_test() const {
  const Parameters& par = parameters_;
  const int finest = std::max({par.motion_mode, par.bottom_mode, par.pressure_mode});
  // Derivatives of the returned values alone, in variables in which they vary over unit distance.
  const double label_scale = par.length / (8 * std::numbers::pi * finest);
  const double time_scale = 1 / (4 * par.frequency);
  const auto along = [&](auto value, double label) {
    return difference([&](double z) { return value(label + label_scale * z); }) / label_scale;
  };
  const auto rate = [&](auto value, double t) {
    return difference([&](double z) { return value(t + time_scale * z); }) / time_scale;
  };
  const double speed = par.frequency * par.depth;
  const double acceleration = par.gravity + par.frequency * speed;
  Worst mass;
  Largest continuity, velocities, momentum;
  constexpr int labels = 12;
  constexpr int times = 8;
  for (int i = 0; i < labels; ++i) {
    for (int j = 0; j < times; ++j) {
      const double a = par.length * (i + 0.3) / labels;
      const double t = 2 * std::numbers::pi / par.frequency * (j + 0.4) / times;
      const Sample here = at(a, t);
      const Bottom bed = bottom(here.x);
      const double depth = here.y - bed.height;
      const auto velocity_at = [&](double label) {
        const Sample there = at(label, t);
        return velocity(there, bottom(there.x), par);
      };
      const double x_a = 1 + along([&](double label) { return at(label, t).x - label; }, a);
      const double y_x = along([&](double label) { return at(label, t).y; }, a) / x_a;
      const double lambda_x = along([&](double label) { return at(label, t).lambda; }, a) / x_a;
      const double u_x = along([&](double label) { return velocity_at(label).x; }, a) / x_a;
      const Vector moves = velocity_at(a);
      mass.add(depth * x_a / volume_density(a) - 1);
      continuity.add(std::abs(moves.y - bed.slope * moves.x + depth * u_x) / speed);
      velocities.add(std::abs(rate([&](double s) { return at(a, s).x - a; }, t) - moves.x) / speed);
      velocities.add(std::abs(rate([&](double s) { return at(a, s).y; }, t) - moves.y) / speed);
      // -lambda_x - (lambda - g y) y_x/H = -g y_x - pi_x - pi y_x/H
      const double pi = here.lambda - par.gravity * here.y;
      // Differences of differences where dispersion is improved.
      const auto energy_slope = [&](double label, int of_y, int of_x) {
        const double growth = 1 + along([&](double z) { return at(z, t).x - z; }, label);
        const double rise = along([&](double z) { return at(z, t).y; }, label);
        return std::pow(volume_density(label), 2) * std::pow(rise, of_y) / std::pow(growth, of_x);
      };
      const double strength = par.gravity * par.gamma / volume_density(a);
      const double more_x =
          strength == 0 ? 0 : -1.5 * strength * along([&](double z) { return energy_slope(z, 2, 4); }, a);
      const double more_y = strength == 0 ? 0 : strength * along([&](double z) { return energy_slope(z, 1, 3); }, a);
      const Vector push = generalised({-lambda_x - pi * y_x / depth + more_x, pi / depth + more_y}, bed, par);
      const double p_rate = rate([&](double s) { return at(a, s).p; }, t);
      const double r_rate = rate([&](double s) { return at(a, s).r; }, t);
      momentum.add(std::abs(p_rate - push.x - here.source_p) / acceleration);
      momentum.add(std::abs(par.alpha * r_rate - push.y - here.source_r) / acceleration);
    }
  }
  // Eighth-order differences over h = (551 eps)^(1/9) = 0.037 scales: weights of 2.1/h in sum.
  const double limit = 4 * exact::epsilon * par.length / label_scale * 2.1 / 0.037;
  const std::string reason =
      "labels and positions up to L rounded four times, in the scale of the finest mode, divided by the spacing of "
      "eighth-order differences";
  return {
      {"H x_a = d - e cos(kb a)", mass.value(), limit, reason},
      {"D(H x_a)/Dt = 0 with the velocities p, r", continuity.value(), limit, "the same"},
      {"x_t = u, y_t = v", velocities.value(), limit, "the same"},
      {"equations of motion with the sources", momentum.value(), limit * (1 + par.gamma * 2.1 / (0.037 * label_scale)),
       "the same, and differenced twice where gamma weighs it"}};
}

}  // namespace seiche::validation
