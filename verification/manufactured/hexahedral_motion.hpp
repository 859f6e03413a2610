/// A prescribed motion of water over an uneven bottom between four walls, with the force that sustains it.
///
/// Three maps, each of which keeps volumes: from labels X, Y, S (height above the bottom, 0 to d) along x,
///
///     tan(k x/2) = tan(k X/2) e^p,   s = S (cos^2(k X/2) e^-p + sin^2(k X/2) e^p),
///     p = 2 k A(Y, t) (2/5 + S sin kX),
///
/// the flow of the stream function 4c/5 + c^2, c = s sin kx, for a time A, which shifts and shears columns and keeps
/// the walls X = 0, L = pi/k and the bottom, on which water slides; the same along y, with an amplitude B(x, t); and z
/// = b(x, y) + s. At t = 0 places are labels. With lambda = p + g z of any pressure that is 0 on the surface, the force
/// per unit mass is
///
///     f = r_tt + F^-T grad lambda,   F = d(x, y, z)/d(X, Y, S).
///
/// Derivatives by arithmetic on values and derivatives together.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification {

/// A function of label and time: its value, gradient over the label, first and second rate.
struct Jet {
  double value = 0;
  std::array<double, 3> gradient = {0, 0, 0};
  double rate = 0, second_rate = 0;
};

/// h(a) from h, h' and h'' at a.
inline Jet composed(const Jet& a, double value, double first, double second) {
  Jet c{.value = value, .rate = first * a.rate, .second_rate = first * a.second_rate + second * a.rate * a.rate};
  for (std::size_t i = 0; i < 3; ++i) c.gradient[i] = first * a.gradient[i];
  return c;
}
inline Jet operator+(const Jet& a, const Jet& b) {
  Jet c{.value = a.value + b.value, .rate = a.rate + b.rate, .second_rate = a.second_rate + b.second_rate};
  for (std::size_t i = 0; i < 3; ++i) c.gradient[i] = a.gradient[i] + b.gradient[i];
  return c;
}
inline Jet operator*(const Jet& a, const Jet& b) {
  Jet c{.value = a.value * b.value,
        .rate = a.value * b.rate + a.rate * b.value,
        .second_rate = a.value * b.second_rate + 2 * a.rate * b.rate + a.second_rate * b.value};
  for (std::size_t i = 0; i < 3; ++i) c.gradient[i] = a.value * b.gradient[i] + a.gradient[i] * b.value;
  return c;
}
inline Jet operator*(double a, const Jet& b) {
  return Jet{.value = a} * b;
}
inline Jet operator+(double a, const Jet& b) {
  return Jet{.value = a} + b;
}
inline Jet sin(const Jet& a) {
  return composed(a, std::sin(a.value), std::cos(a.value), -std::sin(a.value));
}
inline Jet cos(const Jet& a) {
  return composed(a, std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
}
inline Jet exp(const Jet& a) {
  return composed(a, std::exp(a.value), std::exp(a.value), std::exp(a.value));
}
/// Of the ratio y/x of two that are not both 0: the derivatives are those of its tangent or of its cotangent.
inline Jet atan2(const Jet& y, const Jet& x) {
  const auto quotient = [](const Jet& a, const Jet& b) {
    const double inverse = 1 / b.value;
    return a * composed(b, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
  };
  const bool steep = std::abs(y.value) > std::abs(x.value);
  const Jet ratio = steep ? quotient(x, y) : quotient(y, x);
  const double sign = steep ? -1 : 1;
  const double bell = 1 / (1 + ratio.value * ratio.value);
  return composed(ratio, std::atan2(y.value, x.value), sign * bell, -2 * sign * ratio.value * bell * bell);
}

class HexahedralMotion {
 public:
  static constexpr double length = 2;   ///< between walls, along x and y
  static constexpr double depth = 1;    ///< of water over the bottom at t = 0
  static constexpr double gravity = 1;  ///< density 1 too

  using Vector = lagrangian_mesh_3d::Vector;

  struct Sample {
    Vector place, velocity, force;
    double lambda = 0;  ///< p + g z
    double volume = 0;  ///< det F, 1
    /// Of the surface S = const, upward; not a unit vector.
    Vector normal;
  };

  /// b = sum of the terms below.
  static std::shared_ptr<const PlanBottom> bottom() {
    return polynomial_bottom({{-1, 0, 0}, {tilt_x, 1, 0}, {tilt_y, 0, 1}, {twist, 1, 1}, {bend, 2, 0}, {skew, 1, 2}});
  }

  /// @param place  at t = 0
  [[nodiscard]] static Sample at(const Vector& place, double time);

 private:
  static constexpr double tilt_x = 0.12, tilt_y = -0.08, twist = 0.1, bend = -0.07, skew = 0.03;
  static constexpr double wavenumber = std::numbers::pi / length;

  /// One of the two maps: along one axis, and the height.
  static void shear(Jet& along, Jet& height, const Jet& amplitude);
};

inline void HexahedralMotion::shear(Jet& along, Jet& height, const Jet& amplitude) {
  const double k = wavenumber;
  const Jet half = 0.5 * k * along;
  const Jet sine = sin(half);
  const Jet cosine = cos(half);
  const Jet p = 2 * k * (amplitude * (0.4 + height * sin(k * along)));
  height = height * (cosine * cosine * exp(-1 * p) + sine * sine * exp(p));
  along = (2 / k) * atan2(sine * exp(0.5 * p), cosine * exp(-0.5 * p));
}

inline HexahedralMotion::Sample HexahedralMotion::at(const Vector& place, double time) {
  const Jet t{.value = time, .rate = 1};
  const Jet label_x{.value = place.x, .gradient = {1, 0, 0}};
  const Jet label_y{.value = place.y, .gradient = {0, 1, 0}};
  const auto bed = [](const Jet& x, const Jet& y) {
    return -1 + tilt_x * x + tilt_y * y + twist * (x * y) + bend * (x * x) + skew * (x * y * y);
  };
  const Jet height{.value = place.z - bed({place.x}, {place.y}).value, .gradient = {0, 0, 1}};
  Jet x = label_x;
  Jet y = label_y;
  Jet s = height;
  shear(x, s, 0.1 * (sin(1.3 * t) * (1 + 0.5 * cos(wavenumber * label_y))));
  shear(y, s, 0.08 * (sin(1.7 * t) * (0.4 + cos(wavenumber * x))));
  const Jet z = bed(x, y) + s;

  const Jet over = depth + -1 * height;  // 0 at the surface
  const Jet pressure = over * (gravity + 0.4 * (cos(wavenumber * label_x) * cos(wavenumber * label_y) * cos(1.1 * t)) +
                               0.3 * (height * sin(0.7 * label_x + 0.5 * label_y)));
  const Jet lambda = pressure + gravity * z;

  const std::array<std::array<double, 3>, 3> f{x.gradient, y.gradient, z.gradient};
  // Row i of F's cofactors: the cross product of the other two rows.
  std::array<std::array<double, 3>, 3> cofactor{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = f[(i + 1) % 3];
    const auto& b = f[(i + 2) % 3];
    cofactor[i] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  const double volume = f[0][0] * cofactor[0][0] + f[0][1] * cofactor[0][1] + f[0][2] * cofactor[0][2];
  const auto gradient = [&](std::size_t i) {
    const auto& c = cofactor[i];
    return (c[0] * lambda.gradient[0] + c[1] * lambda.gradient[1] + c[2] * lambda.gradient[2]) / volume;
  };
  return {.place = {x.value, y.value, z.value},
          .velocity = {x.rate, y.rate, z.rate},
          .force = {x.second_rate + gradient(0), y.second_rate + gradient(1), z.second_rate + gradient(2)},
          .lambda = lambda.value,
          .volume = volume,
          .normal = {cofactor[0][2], cofactor[1][2], cofactor[2][2]}};
}

}  // namespace seiche::verification
