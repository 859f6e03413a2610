#include "validation/instruments/manufactured/plan_manufactured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/difference.hpp"

namespace seiche::validation {

namespace {

/// sin(rate s + phase) and its derivatives by s, orders 0 to 3.
using Harmonic = std::array<double, 4>;

Harmonic sine(double rate, double s, double phase = 0) {
  const double value = std::sin(rate * s + phase);
  const double slope = rate * std::cos(rate * s + phase);
  return {value, slope, -rate * rate * value, -rate * rate * slope};
}

Harmonic cosine(double rate, double s, double phase = 0) {
  const double value = std::cos(rate * s + phase);
  const double slope = -rate * std::sin(rate * s + phase);
  return {value, slope, -rate * rate * value, -rate * rate * slope};
}

/// Orders of differentiation by X, Y and t.
struct Derivatives {
  unsigned x, y, t;
};

/// amplitude f(X) g(Y) h(t).
struct Swing {
  double amplitude;
  Harmonic x, y, t;

  [[nodiscard]] double derivative(Derivatives n) const { return amplitude * x[n.x] * y[n.y] * t[n.t]; }
};

/// The displacements x - X and y - Y with all their derivatives at one label and time.
class Displacements {
 public:
  Displacements(const PlanManufactured::Parameters& p, double label_x, double label_y, double time)
      : along_{p.amplitude, sine(wavenumber(p), label_x), cosine(wavenumber(p), label_y),
               cosine(p.frequency, time, 0.5)},
        across_{0.7 * p.amplitude, cosine(wavenumber(p), label_x), sine(wavenumber(p), label_y),
                cosine(p.frequency, time, 1)},
        double_{0.3 * p.amplitude, cosine(2 * wavenumber(p), label_x), sine(2 * wavenumber(p), label_y),
                sine(p.frequency, time)} {}

  [[nodiscard]] double x(Derivatives n) const { return along_.derivative(n); }
  [[nodiscard]] double y(Derivatives n) const { return across_.derivative(n) + double_.derivative(n); }
  /// Derivative of the gradient's components x_X, y_Y of the place.
  [[nodiscard]] double x_x(Derivatives n) const { return x({n.x + 1, n.y, n.t}) + (n.x + n.y + n.t == 0 ? 1 : 0); }
  [[nodiscard]] double y_y(Derivatives n) const { return y({n.x, n.y + 1, n.t}) + (n.x + n.y + n.t == 0 ? 1 : 0); }
  [[nodiscard]] double x_y(Derivatives n) const { return x({n.x, n.y + 1, n.t}); }
  [[nodiscard]] double y_x(Derivatives n) const { return y({n.x + 1, n.y, n.t}); }

  /// Derivative of J = x_X y_Y - x_Y y_X: Leibniz's rule, orders by X and Y at most 1 together, by t at most 2.
  [[nodiscard]] double jacobian(Derivatives n) const {
    constexpr std::array<std::array<double, 3>, 3> binomial{{{1, 0, 0}, {1, 1, 0}, {1, 2, 1}}};
    double sum = 0;
    for (unsigned i = 0; i <= n.x; ++i) {
      for (unsigned j = 0; j <= n.y; ++j) {
        for (unsigned l = 0; l <= n.t; ++l) {
          const Derivatives one{i, j, l};
          const Derivatives other{n.x - i, n.y - j, n.t - l};
          sum += binomial[n.t][l] * (x_x(one) * y_y(other) - x_y(one) * y_x(other));
        }
      }
    }
    return sum;
  }

 private:
  static double wavenumber(const PlanManufactured::Parameters& p) { return std::numbers::pi / p.length; }

  Swing along_, across_, double_;
};

}  // namespace

PlanManufactured::PlanManufactured(const Parameters& parameters) : parameters_(parameters) {
  require_positive("gravity", parameters.gravity);
  require_positive("depth", parameters.depth);
  require_positive("length", parameters.length);
  require_positive("frequency", parameters.frequency);
  require_positive("alpha", parameters.alpha);
  const double crossing = 0.3 * parameters.length / std::numbers::pi;
  require_within("amplitude", parameters.amplitude, -crossing, crossing);
}

PlanManufactured::Sample PlanManufactured::at(double label_x, double label_y, double t) const {
  require_within("label_x", label_x, 0, parameters_.length);
  require_within("label_y", label_y, 0, parameters_.length);
  require_finite("t", t);
  const Displacements motion(parameters_, label_x, label_y, t);
  const double d = parameters_.depth;
  const double j = motion.jacobian({0, 0, 0});
  const double j_t = motion.jacobian({0, 0, 1});
  const double j_tt = motion.jacobian({0, 0, 2});
  const double depth = d / j;
  // H^2 D^2 H over d^3 is 2 J_t^2/J^5 - J_tt/J^4.
  const double alpha = parameters_.alpha;
  const double dynamic = alpha * d * d * (2 * j_t * j_t / j - j_tt) / (j * j * j);  // alpha H D^2 H
  // g grad H + (alpha/H) grad(H^2 D^2 H) by a label, from derivatives of J by it.
  const auto slope = [&](Derivatives by) {
    const double j_s = motion.jacobian(by);
    const double j_st = motion.jacobian({by.x, by.y, 1});
    const double j_stt = motion.jacobian({by.x, by.y, 2});
    const double squared = (4 * j_t * j_st - 10 * j_t * j_t * j_s / j + 4 * j_tt * j_s) / j - j_stt;
    return -parameters_.gravity * d * j_s / (j * j) + alpha * d * d * squared / (j * j * j);
  };
  const double by_x = slope({1, 0, 0});
  const double by_y = slope({0, 1, 0});
  constexpr Derivatives none{0, 0, 0};
  constexpr Derivatives rate{0, 0, 1};
  constexpr Derivatives acceleration{0, 0, 2};
  return {label_x + motion.x(none),
          label_y + motion.y(none),
          motion.x(rate),
          motion.y(rate),
          depth,
          -depth * j_t / j,
          parameters_.gravity * depth + dynamic,
          motion.x(acceleration) + (by_x * motion.y_y(none) - by_y * motion.y_x(none)) / j,
          motion.y(acceleration) + (by_y * motion.x_x(none) - by_x * motion.x_y(none)) / j};
}

PlanManufactured::Label PlanManufactured::label(double x, double y, double t) const {
  require_within("x", x, 0, parameters_.length);
  require_within("y", y, 0, parameters_.length);
  require_finite("t", t);
  constexpr int iterations = 50;  // Newton's method: six or seven suffice where J is near 1
  constexpr Derivatives none{0, 0, 0};
  Label at{x, y};
  for (int i = 0; i < iterations; ++i) {
    const Displacements motion(parameters_, at.x, at.y, t);
    const double miss_x = at.x + motion.x(none) - x;
    const double miss_y = at.y + motion.y(none) - y;
    const double j = motion.jacobian(none);
    const double step_x = (motion.y_y(none) * miss_x - motion.x_y(none) * miss_y) / j;
    const double step_y = (motion.x_x(none) * miss_y - motion.y_x(none) * miss_x) / j;
    at.x = std::clamp(at.x - step_x, 0.0, parameters_.length);
    at.y = std::clamp(at.y - step_y, 0.0, parameters_.length);
    if (std::hypot(step_x, step_y) <= 1e-9 * parameters_.length) break;  // the next error is its square
  }
  return at;
}

/// The derivatives are those of the returned values alone, in variables in which they vary over unit distance.
exact::SelfTest PlanManufactured::self_test() const {
  const Parameters& p = parameters_;
  const double k = std::numbers::pi / p.length;
  const double closest = 1 - 2.3 * std::abs(p.amplitude) * k;  // lower bound of J
  const double strain = 1 - closest;  // of J's departure from 1 and of the velocity's gradient over the frequency
  const double label_scale = closest / (4 * k);
  const double time_scale = closest / (4 * p.frequency);
  const double speed = p.frequency * p.length;
  const double acceleration = p.gravity + p.frequency * speed;
  Worst walls, mass, rates, vertical, momentum;
  const auto check_walls = [&](double a, double t) {
    for (const double wall : {0.0, p.length}) {
      const Sample west = at(wall, a, t);
      const Sample south = at(a, wall, t);
      for (const double place : {west.x, south.y}) walls.add((place - wall) / p.length);
      for (const double across : {west.u, south.v}) walls.add(across / speed);
      for (const double force : {west.bx, south.by}) walls.add(force / acceleration);
    }
  };
  const auto check_inside = [&](double a, double b, double t) {
    const auto by_x = [&](auto value) {
      return difference([&](double z) { return std::invoke(value, at(a + label_scale * z, b, t)); }) / label_scale;
    };
    const auto by_y = [&](auto value) {
      return difference([&](double z) { return std::invoke(value, at(a, b + label_scale * z, t)); }) / label_scale;
    };
    const auto rate = [&](auto value) {
      return difference([&](double z) { return std::invoke(value, at(a, b, t + time_scale * z)); }) / time_scale;
    };
    const double x_x = by_x(&Sample::x);
    const double x_y = by_y(&Sample::x);
    const double y_x = by_x(&Sample::y);
    const double y_y = by_y(&Sample::y);
    const double jacobian = x_x * y_y - x_y * y_x;
    const Sample here = at(a, b, t);
    mass.add(here.depth * jacobian / p.depth - 1);
    for (const auto& [value, its_rate, scale] :
         {std::tuple(&Sample::x, &Sample::u, speed), std::tuple(&Sample::y, &Sample::v, speed),
          std::tuple(&Sample::depth, &Sample::depth_rate, p.frequency * here.depth)}) {
      rates.add((rate(value) - here.*its_rate) / scale);
    }
    const double rise = p.alpha * rate(&Sample::depth_rate);
    vertical.add((rise - (here.lambda - p.gravity * here.depth) / here.depth) /
                 (p.frequency * p.frequency * here.depth));
    // H Du = -grad(lambda H - g H^2/2) + H b
    const auto thrust = [&](const Sample& s) { return (s.lambda - 0.5 * p.gravity * s.depth) * s.depth; };
    const double ax = rate(&Sample::u) + (by_x(thrust) * y_y - by_y(thrust) * y_x) / jacobian / here.depth;
    const double ay = rate(&Sample::v) + (by_y(thrust) * x_x - by_x(thrust) * x_y) / jacobian / here.depth;
    // Where lambda passes through 0 the differences still carry the rounding of its neighbours.
    const double head =
        0.5 * p.gravity * here.depth + p.alpha * std::pow(p.frequency * here.depth, 2) * strain / (closest * closest);
    const double size = acceleration + std::max(std::abs(thrust(here)) / here.depth, head) / label_scale;
    momentum.add(std::hypot(ax - here.bx, ay - here.by) / size);
  };
  constexpr int labels = 6;
  for (int n = 0; n < 5 * labels * labels; ++n) {
    const auto inside = [&](int i) { return p.length * (0.15 + 0.7 * i / (labels - 1)); };  // room for the differences
    const double t = 2 * std::numbers::pi / p.frequency * (n / (labels * labels) + 0.4) / 5;
    check_walls(inside(n % labels), t);
    check_inside(inside(n % labels), inside(n / labels % labels), t);
  }
  // Gravity's part of the force has a factor J^-3, the inertia's up to J^-5.
  const double wall_force = (p.gravity * k * p.depth / std::pow(closest, 3) +
                             p.alpha * p.frequency * p.frequency * k * p.depth * p.depth / std::pow(closest, 5)) /
                            acceleration;
  const double wall_limit =
      10 * std::abs(std::sin(k * p.length) * p.amplitude * k) * (1 / std::numbers::pi + wall_force);
  // Eighth-order differences over h = (551 eps)^(1/9) = 0.037 scales: weights of 2.1/h in sum, 1.17/h in the root of
  // the sum of their squares.
  constexpr double epsilon = exact::epsilon;
  const double limit = 8 * epsilon * p.length / label_scale * 2.1 / 0.037;
  const double noise = 4 * epsilon * std::sqrt(4) * 1.17 / 0.037;
  const double tilt = noise * p.length / label_scale * strain / closest;
  const double lift = noise * 4 * p.alpha * strain / (closest * closest) +
                      8 * epsilon * 2 * p.gravity / (p.frequency * p.frequency * p.depth);
  const std::string reason =
      "values up to L rounded eight times, over the scale of the finest harmonic and the spacing of the differences";
  return {{"walls: x = 0, L and y = 0, L stay, without velocity or force across", walls.value(), wall_limit,
           "sine of the rounded pi in up to ten terms of each, with their factors J^-3 and J^-5"},
          {"H (x_X y_Y - x_Y y_X) = d", mass.value(), limit, reason},
          {"u, v, DH are the rates of x, y, H", rates.value(), limit, reason},
          {"alpha D^2 H = (lambda - g H)/H", vertical.value(), lift,
           "four roundings of DH, as large as the strain allows, as a random walk through the weights of the "
           "differences; eight roundings of g H in lambda"},
          {"D(u, v) + grad(lambda H - g H^2/2)/H = b", momentum.value(), noise / closest + tilt,
           "the same of lambda H - g H^2/2 over its scale, and of x and y times its gradient"}};
}

}  // namespace seiche::validation
