#include "seiche/models/shallow_water_particles/row_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seiche/models/shallow_water_particles/reconstruction.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_particles {

namespace {

constexpr std::size_t block = 64;

// Branch-free form of shallow_water::limited_slope for the loop below.
SEICHE_INLINE double limited(double backward, double central, double forward, double theta) {
  const double one_sided = theta * std::min(std::abs(backward), std::abs(forward));
  const double magnitude = std::min(one_sided, std::abs(central));
  return backward * forward > 0 ? std::copysign(magnitude, backward) : 0.0;
}

}  // namespace

SEICHE_SIMD_CLONES
void predict_row(const PredictionRow& row, std::size_t count) {
  const auto [x, h, u, inv_mass, hl, hr, ul, ur, g, theta, half] = row;
  const auto particles = static_cast<std::ptrdiff_t>(count);
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < particles; ++i) {
    // Step 1: slopes. Twice the distances between centres; one division serves three quotients.
    const double width = x[i + 1] - x[i];
    const double back = x[i + 1] - x[i - 1];
    const double ahead = x[i + 2] - x[i];
    const double both = back + ahead;
    const double r = width / (back * ahead * both);
    const double per_back = ahead * both * r;
    const double per_ahead = back * both * r;
    const double per_both = back * ahead * r;
    const double h_back = h[i] - h[i - 1];
    const double h_ahead = h[i + 1] - h[i];
    const double u_back = u[i] - u[i - 1];
    const double u_ahead = u[i + 1] - u[i];
    const double dh_free = limited(h_back * per_back, (h_back + h_ahead) * per_both, h_ahead * per_ahead, theta);
    const double du = limited(u_back * per_back, (u_back + u_ahead) * per_both, u_ahead * per_ahead, theta);
    const double most = 0.9 * h[i];
    const double dh = std::min(std::max(dh_free, -most), most);

    // Step 2: half a step of the particle by itself.
    const double stretched = width + half * 2 * du;
    const bool sane = stretched > 0.2 * width && stretched < 5 * width;
    const double ratio = sane ? width / stretched : 1.0;
    const double kick = half * inv_mass[i] * 0.5 * g * (-2 * dh) * (2 * h[i]);
    hl[i] = (h[i] - dh) * ratio;
    hr[i] = (h[i] + dh) * ratio;
    ul[i] = u[i] - du + kick;
    ur[i] = u[i] + du + kick;
  }
}

SEICHE_SIMD_CLONES
void solve_row(const EdgeRow& row, std::size_t count) {
  const auto [hl, ul, hr, ur, us, ps, g] = row;
  const double half_inv_g = 0.5 / g;
  constexpr double half_small = 0.5e-4;
  for (std::size_t start = 0; start < count; start += block) {
    const std::size_t stop = std::min(start + block, count);
    int sharp = 0;  // set where an edge needs the iteration, or is not a number
#pragma GCC ivdep
    for (std::size_t k = start; k < stop; ++k) {
      const double c_left = std::sqrt(g * hl[k]);
      const double c_right = std::sqrt(g * hr[k]);
      const double jump = ul[k] - ur[k];
      const double c = 0.5 * (c_left + c_right) + 0.25 * jump;
      us[k] = 0.5 * (ul[k] + ur[k]) + (c_left - c_right);
      const double c2 = c * c;
      ps[k] = half_inv_g * c2 * c2;
      const double little = half_small * (c_left + c_right);
      const bool smooth = (std::abs(jump) <= little) & (std::abs(c_left - c_right) <= little);
      sharp |= static_cast<int>(!smooth);
    }
    for (std::size_t k = start; sharp != 0 && k < stop; ++k) {
      const EdgeState e = edge_state(g, hl[k], ul[k], hr[k], ur[k]);
      us[k] = e.velocity;
      ps[k] = e.thrust;
    }
  }
}

SEICHE_SIMD_CLONES
void move_row(double* edge, double* velocity, const double* inv_mass, const double* edge_velocity,
              const double* edge_thrust, double tau, std::size_t count, bool closes) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    edge[i] += tau * edge_velocity[i];
    velocity[i] += tau * inv_mass[i] * (edge_thrust[i] - edge_thrust[i + 1]);
  }
  if (closes) edge[count] += tau * edge_velocity[count];
}

void RowLimits::add(const RowLimits& other) {
  celerity_rate = std::max(celerity_rate, other.celerity_rate);
  closing_rate = std::max(closing_rate, other.closing_rate);
  sound = sound && other.sound;
}

SEICHE_SIMD_CLONES
RowLimits measure_row(const double* __restrict x, const double* __restrict u, const double* __restrict mass,
                      double* __restrict h, double gravity, std::size_t count, bool goes_on) {
  constexpr double huge = std::numeric_limits<double>::max();
  // Maxima of separate lanes: a single running maximum could not be reordered because of NaN.
  constexpr std::size_t lanes = 8;
  double fastest[lanes] = {};
  double closing[lanes] = {};
  double worst[lanes] = {};  // 1 where a particle is not sound; comparisons with NaN are false
  const auto one = [&](std::size_t i, double next_velocity, std::size_t lane) {
    const double width = x[i + 1] - x[i];
    const double inverse = 1 / width;
    h[i] = mass[i] * inverse;
    const double rate = h[i] * inverse * inverse;
    const double approach = (u[i] - next_velocity) * inverse;
    const double fault = (width > 0) & (std::abs(u[i]) <= huge) ? 0.0 : 1.0;
    fastest[lane] = rate > fastest[lane] ? rate : fastest[lane];
    closing[lane] = approach > closing[lane] ? approach : closing[lane];
    worst[lane] = fault > worst[lane] ? fault : worst[lane];
  };
  std::size_t i = 0;
  for (; i + lanes < count; i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) one(i + lane, u[i + lane + 1], lane);
  }
  for (; i < count; ++i) one(i, u[i + 1 < count || goes_on ? i + 1 : i], 0);
  const double rate = *std::max_element(fastest, fastest + lanes);
  return {std::sqrt(gravity * rate), *std::max_element(closing, closing + lanes),
          *std::max_element(worst, worst + lanes) == 0};
}

SEICHE_SIMD_CLONES
bool may_hold_jump(const double* h, const double* u, double gravity, double threshold, std::size_t count) {
  // The two-wave depth exceeds (1 + threshold) of the lower depth only if the depths do, or if the velocity difference
  // exceeds 2 (sqrt(1 + threshold) - 1) celerities: either half of the rise must come from one of the two.
  const double s = std::sqrt(1 + threshold) - 1;
  const double ratio = (1 + s) * (1 + s);
  const double square = 4 * s * s * gravity;
  int found = 0;
  const auto particles = static_cast<std::ptrdiff_t>(count);
  for (std::ptrdiff_t i = 0; i < particles; ++i) {
    const double closing = u[i - 1] - u[i + 1];
    const double low = std::min(h[i - 1], h[i + 1]);
    const double high = std::max(h[i - 1], h[i + 1]);
    const bool steep = (high >= ratio * low) | (closing * closing >= square * low);
    found |= static_cast<int>((closing > 0) & steep);
  }
  return found != 0;
}

}  // namespace seiche::shallow_water_particles
