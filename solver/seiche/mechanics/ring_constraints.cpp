#include "seiche/mechanics/ring_constraints.hpp"

#include <algorithm>

#include "seiche/compensated_sum.hpp"

namespace seiche::mechanics {

void RingConstraints::set_rings(std::span<const int> begin, std::span<const int> member) {
  begin_ = begin;
  member_ = member;
  matrix_.set_rings(begin, member, begin.size() - 1);
}

void RingConstraints::rates(Input u, Output w) const {
  std::fill(w.begin(), w.end(), 0.0);
  each_ring([&](std::size_t k, std::size_t first, std::size_t last) {
    const Point velocity{u[k], u[u.size() / 2 + k]};
    for (std::size_t e = first; e < last; ++e) w[member(e)] += dot(gradient_[e], velocity);
  });
}

void RingConstraints::react(Input mu, Output u) const {
  each_ring([&](std::size_t k, std::size_t first, std::size_t last) {
    Point change;
    for (std::size_t e = first; e < last; ++e) change += mu[member(e)] * response_[e];
    u[k] += change.x;
    u[u.size() / 2 + k] += change.y;
  });
}

double RingConstraints::stabilisation_loss(Input impulses) const {
  if (row_.empty()) return 0;
  CompensatedSum sum;
  each_ring([&](std::size_t, std::size_t first, std::size_t last) {
    double uneven = 0;
    for (std::size_t e = first; e < last; ++e) uneven += row_[e] * impulses[member(e)];
    sum.add(uneven * uneven);
  });
  return 2 * stiffness_ * sum.value();
}

}  // namespace seiche::mechanics
