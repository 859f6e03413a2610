#include "seiche/models/gauss_particles/surface_gravity.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

SurfaceGravity::SurfaceGravity(SurfaceLine line, const Particles& particles, double weight)
    : period_(line.period), weight_(weight) {
  require_not_negative("period of the surface", line.period);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (particles.mass[k] == 0) markers_.push_back(k);
  }
  require_that(markers_.size() >= 2, "{} markers for a surface; allowed: at least 2", markers_.size());
}

/// Calls visit(a, b, width, ya, yb) for the pieces of the line.
template <class Visit>
void SurfaceGravity::each_piece(std::span<const double> q, Visit&& visit) const {
  const std::span<const double> x = q.first(q.size() / 2);
  const std::span<const double> y = q.last(q.size() / 2);
  for (std::size_t k = 0; k + 1 < markers_.size(); ++k) {
    const std::size_t a = markers_[k];
    const std::size_t b = markers_[k + 1];
    visit(a, b, x[b] - x[a], y[a], y[b]);
  }
  if (period_ > 0) {
    const std::size_t a = markers_.back();
    const std::size_t b = markers_.front();
    visit(a, b, x[b] + period_ - x[a], y[a], y[b]);
  }
}

double SurfaceGravity::energy(std::span<const double> q) const {
  CompensatedSum sum;
  each_piece(q, [&](std::size_t, std::size_t, double width, double ya, double yb) {
    sum.add(weight_ * width * (ya * ya + ya * yb + yb * yb) / 6);
  });
  return sum.value();
}

void SurfaceGravity::push(std::span<const double> q, double h, std::span<double> impulse) const {
  const std::size_t n = q.size() / 2;
  const double factor = h * weight_ / 6;
  each_piece(q, [&](std::size_t a, std::size_t b, double width, double ya, double yb) {
    const double squares = ya * ya + ya * yb + yb * yb;
    impulse[a] += factor * squares;
    impulse[b] -= factor * squares;
    impulse[n + a] -= factor * width * (2 * ya + yb);
    impulse[n + b] -= factor * width * (ya + 2 * yb);
  });
}

/// Simpson's rule: dPi/dq is quadratic.
void SurfaceGravity::push_between(std::span<const double> q0, std::span<const double> q1, double h,
                                  std::span<double> impulse) {
  middle_.resize(q0.size());
  for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
  push(q0, h / 6, impulse);
  push(middle_, 4 * h / 6, impulse);
  push(q1, h / 6, impulse);
}

}  // namespace seiche::gauss_particles
