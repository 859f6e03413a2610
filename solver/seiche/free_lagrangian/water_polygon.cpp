#include "seiche/free_lagrangian/water_polygon.hpp"

#include <algorithm>

#include "seiche/compensated_sum.hpp"

namespace seiche::free_lagrangian {

namespace {

double mean_square(double a, double b) {
  return (a * a + a * b + b * b) / 6;
}

}  // namespace

double potential_energy(Places at, std::span<const int> outline, double weight) {
  CompensatedSum sum;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const Point a = at[outline[e]];
    const Point b = at[outline[e + 1 == outline.size() ? 0 : e + 1]];
    sum.add((a.x - b.x) * mean_square(a.y, b.y));
  }
  return weight * sum.value();
}

void gravity_forces(Places at, std::span<const int> outline, double weight, std::vector<Point>& force) {
  std::fill(force.begin(), force.end(), Point{});
  if (weight == 0) return;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const int a = outline[e];
    const int b = outline[e + 1 == outline.size() ? 0 : e + 1];
    const Point ra = at[a];
    const Point rb = at[b];
    Point& fa = force[static_cast<std::size_t>(a)];
    Point& fb = force[static_cast<std::size_t>(b)];
    const double along = weight * mean_square(ra.y, rb.y);
    const double width = weight * (ra.x - rb.x) / 6;
    fa.x -= along;
    fb.x += along;
    fa.y -= width * (2 * ra.y + rb.y);
    fb.y -= width * (2 * rb.y + ra.y);
  }
}

}  // namespace seiche::free_lagrangian
