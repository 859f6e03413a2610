#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/require.hpp"

namespace seiche::overlapping_particles {

namespace {

constexpr double one_place = 1e-12;  // of S: particles nearer than that are at one place

Particles valid(Particles particles) {
  particles.require_valid();
  return particles;
}

double support_of(const Particles& particles, const Settings& settings) {
  require_ranges(settings);
  return settings.support * particles.spacing;
}

}  // namespace

Model::Model(Particles particles, Settings settings)
    : particles_(valid(std::move(particles))),
      settings_(std::move(settings)),
      kernel_(settings_.shape, support_of(particles_, settings_)),
      walls_(settings_.walls, kernel_.support()),
      first_(particles_.size()),
      near_(kernel_.support()) {
  const std::vector<double> q = state().q;
  try {
    require_places(q);
    measure(q);
  } catch (const mechanics::Infeasible& failure) {
    throw std::invalid_argument(failure.what());
  }
  sum_masses(q, first_);
}

void Model::require_places(Input q) const {
  if (const std::size_t bad = mechanics::first_not_finite(q); bad < q.size()) {
    const std::size_t k = bad % size();
    throw mechanics::Infeasible(particles_.x[k], "particle {} is at ({:g}, {:g}); allowed: finite places", k,
                                at(q, k).x, at(q, k).y);
  }
  if (walls_.empty()) return;
  for (std::size_t k = 0; k < size(); ++k) {
    const Point r = at(q, k);
    if (const int wall = walls_.behind(r); wall >= 0) {
      throw mechanics::Infeasible(r.x,
                                  "particle {} at ({:g}, {:g}) is {:g} from wall {}; allowed: positive, "
                                  "on the side of the water",
                                  k, r.x, r.y, walls_.distance(wall, r), wall);
    }
  }
}

void Model::linearise(Interval /*when*/, Input q) {
  require_places(q);
  measure(q);
  const auto pivots = volumes_.factor(gradient_, unevenness_, settings_.stabilisation, [&](std::size_t k, Point force) {
    return Point{force.x / particles_.mass[k], force.y / particles_.mass[k]};
  });
  if (!pivots) return;
  throw mechanics::Infeasible(
      particles_.x[0],
      "singular configuration: multipliers without forces, as of two particles alone or of a lattice that "
      "fills a box (smallest pivot over largest {:.2g}; allowed: at least {:g}); stabilisation = 0; set "
      "stabilisation > 0, or a support above {:g}",
      *pivots, linear::RingSolver::smallest_pivot, settings_.support);
}

/// Gradients and, for L, overlaps of all particles with the control volumes near them.
void Model::measure(Input q) {
  const std::size_t n = size();
  if (near_.update(q.first(n), q.last(n), walls_)) volumes_.set_rings(near_.begin(), near_.members());
  const auto begin = near_.begin();
  const auto member = near_.members();
  const bool stabilised = settings_.stabilisation > 0;
  gradient_.assign(member.size(), {});
  unevenness_.assign(stabilised ? member.size() : 0, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const Point rk = at(q, k);
    const auto first = static_cast<std::size_t>(begin[k]);
    const auto last = static_cast<std::size_t>(begin[k + 1]);
    int overlaps = 0;
    double nearest = kernel_.support();
    std::size_t nearest_to = k;
    // The gradient of Phi(|R r_k - r_s|) by r_k, for R the identity and the reflections: by r_k itself, in f_k, it is
    // the same, with the mass of s.
    const auto overlap = [&](std::size_t e, Point r, std::size_t s) -> Point {
      const Point apart = r - at(q, s);
      const double distance = std::sqrt(dot(apart, apart));
      if (!(distance < kernel_.support())) return {};
      ++overlaps;
      if (distance < nearest) {
        nearest = distance;
        nearest_to = s;
      }
      if (stabilised) unevenness_[e] += kernel_.value(distance);
      const double slope = kernel_.slope_over_distance(distance);
      return slope * apart;
    };
    for (std::size_t e = first + 1; e < last; ++e) gradient_[e] = overlap(e, rk, static_cast<std::size_t>(member[e]));
    for (const Image& image : walls_.images()) {
      if (!walls_.sees(image, rk, kernel_.support())) continue;
      const Point r = image.of(rk);
      for (std::size_t e = first + 1; e < last; ++e) {
        gradient_[e] += image.turned(overlap(e, r, static_cast<std::size_t>(member[e])));
      }
      const Point own = overlap(first, r, k);
      gradient_[first] += particles_.mass[k] * (image.turned(own) - own);
    }
    if (nearest < one_place * kernel_.support()) {
      throw mechanics::Infeasible(rk.x,
                                  "particles {} and {} are at one place, ({:g}, {:g}); allowed: apart by at "
                                  "least {:g}",
                                  k, nearest_to, rk.x, rk.y, one_place * kernel_.support());
    }
    if (overlaps == 0 && !stabilised) {
      throw mechanics::Infeasible(rk.x,
                                  "singular configuration: particle {} at ({:g}, {:g}) is in no other "
                                  "control volume; set stabilisation > 0, or a support above {:g}",
                                  k, rk.x, rk.y, settings_.support);
    }
    double all = 0;
    for (std::size_t e = first + 1; e < last; ++e) {
      gradient_[first] += particles_.mass[static_cast<std::size_t>(member[e])] * gradient_[e];
      gradient_[e] = particles_.mass[k] * gradient_[e];
      if (stabilised) all += unevenness_[e];
    }
    if (!stabilised) continue;
    for (std::size_t e = first + 1; e < last && all > 0; ++e) unevenness_[e] /= -all;
    unevenness_[first] = 1;
  }
}

void Model::advance(Input from, Input u, double h, Output to) const {
  if (!walls_.empty()) {
    for (std::size_t k = 0; k < size(); ++k) {
      const Point r{from[k] + h * u[k], from[size() + k] + h * u[size() + k]};
      if (const int wall = walls_.behind(r); wall >= 0) {
        throw mechanics::Infeasible(r.x, "particle {} goes through wall {} at ({:g}, {:g})", k, wall, r.x, r.y);
      }
    }
  }
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + h * u[i];
}

void Model::kick(double h, Output u) const {
  for (std::size_t k = size(); k < 2 * size(); ++k) u[k] -= h * settings_.gravity;
}

void Model::sum_masses(Input q, Output f) const {
  const std::size_t n = size();
  CellGrid grid;
  grid.sort(q.first(n), q.last(n), kernel_.support());
  for (std::size_t s = 0; s < n; ++s) {
    CompensatedSum sum;
    // R r_k is as far from r_s as r_k from R r_s.
    each_image(at(q, s), walls_, kernel_.support(), [&](Point r) {
      grid.near(r, [&](int particle) {
        const auto k = static_cast<std::size_t>(particle);
        const double dx = q[k] - r.x;
        const double dy = q[n + k] - r.y;
        sum.add(particles_.mass[k] * kernel_.value(std::sqrt(dx * dx + dy * dy)));
      });
    });
    f[s] = sum.value();
  }
}

void Model::constraint_values(Input q, Output f) const {
  sum_masses(q, f);
  for (std::size_t s = 0; s < size(); ++s) f[s] -= first_[s];
}

double Model::potential_energy(Input q) const {
  CompensatedSum sum;
  for (std::size_t k = 0; k < size(); ++k) sum.add(particles_.mass[k] * q[size() + k]);
  return settings_.gravity * sum.value();
}

}  // namespace seiche::overlapping_particles

template class seiche::mechanics::OneStep<seiche::overlapping_particles::Model>;
template class seiche::mechanics::Start<seiche::overlapping_particles::Model>;
template class seiche::mechanics::InvariantsWatch<seiche::overlapping_particles::Model>;
