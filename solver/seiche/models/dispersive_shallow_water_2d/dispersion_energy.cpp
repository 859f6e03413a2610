#include "seiche/models/dispersive_shallow_water_2d/dispersion_energy.hpp"

#include <array>

#include "seiche/compensated_sum.hpp"
#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// A cell's diagonals, from corner 0 to 2 and from 1 to 3: differences of x, y and z.
struct Diagonals {
  double x1, y1, z1;
  double x2, y2, z2;

  [[nodiscard]] double dx() const { return z1 * x2 - z2 * x1; }
  [[nodiscard]] double dy() const { return z1 * y2 - z2 * y1; }
  [[nodiscard]] double area() const { return 0.5 * (x1 * y2 - x2 * y1); }
};

Diagonals diagonals_of(mechanics::Input q, std::size_t nodes, const std::array<std::size_t, 4>& corners) {
  const auto [c0, c1, c2, c3] = corners;
  const double* const x = q.data();
  const double* const y = x + nodes;
  const double* const z = y + nodes;
  return {x[c2] - x[c0], y[c2] - y[c0], z[c2] - z[c0], x[c3] - x[c1], y[c3] - y[c1], z[c3] - z[c1]};
}

Diagonals mean(const Diagonals& a, const Diagonals& b) {
  return {0.5 * (a.x1 + b.x1), 0.5 * (a.y1 + b.y1), 0.5 * (a.z1 + b.z1),
          0.5 * (a.x2 + b.x2), 0.5 * (a.y2 + b.y2), 0.5 * (a.z2 + b.z2)};
}

double cube(double a) {
  return a * a * a;
}

/// Derivatives of |D|^2/A^3 with respect to the diagonals between two configurations of a cell.
Diagonals gradient(const Diagonals& from, const Diagonals& to) {
  const Diagonals middle = mean(from, to);
  const double a0 = from.area();
  const double a1 = to.area();
  const double inverse = 0.5 * (1 / cube(a0) + 1 / cube(a1));
  const double divided = -(a0 * a0 + a0 * a1 + a1 * a1) / cube(a0 * a1);  // (1/a1^3 - 1/a0^3)/(a1 - a0)
  const double square = 0.5 * (from.dx() * from.dx() + from.dy() * from.dy() + to.dx() * to.dx() + to.dy() * to.dy());
  const double dx = inverse * (from.dx() + to.dx());
  const double dy = inverse * (from.dy() + to.dy());
  const double by_area = 0.5 * square * divided;
  return {.x1 = -middle.z2 * dx + by_area * middle.y2,
          .y1 = -middle.z2 * dy - by_area * middle.x2,
          .z1 = dx * middle.x2 + dy * middle.y2,
          .x2 = middle.z1 * dx - by_area * middle.y1,
          .y2 = middle.z1 * dy + by_area * middle.x1,
          .z2 = -dx * middle.x1 - dy * middle.y1};
}

}  // namespace

DispersionEnergy::DispersionEnergy(plan_lattice::Shape shape, double gamma) : shape_(shape), gamma_(gamma) {
  require_not_negative("gamma", gamma);
}

double DispersionEnergy::value(std::span<const double> volumes, mechanics::Input q) const {
  CompensatedSum sum;
  for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
    const Diagonals at = diagonals_of(q, shape_.nodes(), shape_.corners(cell));
    sum.add(gamma_ / 8 * volumes[cell] * volumes[cell] * (at.dx() * at.dx() + at.dy() * at.dy()) / cube(at.area()));
  }
  return sum.value();
}

void DispersionEnergy::push(std::span<const double> volumes, mechanics::Input q0, mechanics::Input q1, double gravity,
                            mechanics::Output forces) const {
  const std::size_t n = shape_.nodes();
  double* const fx = forces.data();
  double* const fy = fx + n;
  double* const fz = fy + n;
  for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
    const auto corners = shape_.corners(cell);
    const auto [c0, c1, c2, c3] = corners;
    const Diagonals slope = gradient(diagonals_of(q0, n, corners), diagonals_of(q1, n, corners));
    const double weight = gravity * gamma_ / 8 * volumes[cell] * volumes[cell];
    fx[c0] += weight * slope.x1;
    fx[c1] += weight * slope.x2;
    fx[c2] -= weight * slope.x1;
    fx[c3] -= weight * slope.x2;
    fy[c0] += weight * slope.y1;
    fy[c1] += weight * slope.y2;
    fy[c2] -= weight * slope.y1;
    fy[c3] -= weight * slope.y2;
    fz[c0] += weight * slope.z1;
    fz[c1] += weight * slope.z2;
    fz[c2] -= weight * slope.z1;
    fz[c3] -= weight * slope.z2;
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
