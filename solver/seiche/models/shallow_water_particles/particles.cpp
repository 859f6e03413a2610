#include "seiche/models/shallow_water_particles/particles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/compensated_sum.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::shallow_water_particles {

void Particles::validate() const {
  require_at_least("number of particles", static_cast<long>(size()), 4);
  require_that(edge.size() == size() + 1 && velocity.size() == size(),
               "particles: {} masses need {} edges and {} velocities, given {} and {}", size(), size() + 1, size(),
               edge.size(), velocity.size());
  for (std::size_t i = 0; i < edge.size(); ++i) require_finite(fmt::format("edge[{}]", i), edge[i]);
  for (std::size_t i = 0; i < size(); ++i) {
    require_positive(fmt::format("mass[{}]", i), mass[i]);
    require_finite(fmt::format("velocity[{}]", i), velocity[i]);
    require_that(edge[i] < edge[i + 1], "edge[{}] = {:g} must be greater than edge[{}] = {:g}", i + 1, edge[i + 1], i,
                 edge[i]);
  }
}

double total_momentum(std::span<const double> mass, std::span<const double> velocity) {
  CompensatedSum sum;
  for (std::size_t i = 0; i < mass.size(); ++i) sum.add(mass[i] * velocity[i]);
  return sum.value();
}

namespace {

void require_interval(double left, double right) {
  require_finite("left", left);
  require_finite("right", right);
  require_that(left < right, "right = {:g} must exceed left = {:g}", right, left);
}

}  // namespace

Array equal_width_edges(double left, double right, std::size_t count) {
  require_interval(left, right);
  require_at_least("number of particles", static_cast<long>(count), 1);
  Array edges(count + 1);
  const auto n = static_cast<double>(count);
  for (std::size_t k = 0; k <= count; ++k) {
    const auto position = static_cast<double>(k);
    edges[k] = (left * (n - position) + right * position) / n;
  }
  return edges;
}

Particles particles_from_profile(Array edges, const Function& depth, const Function& velocity) {
  Particles p;
  p.edge = std::move(edges);
  constexpr int parts = 8;
  for (std::size_t i = 0; i + 1 < p.edge.size(); ++i) {
    const double width = (p.edge[i + 1] - p.edge[i]) / parts;
    double mass = 0;
    double momentum = 0;
    for (int part = 0; part < parts; ++part) {
      const double left = p.edge[i] + part * width;
      using Gauss = boost::math::quadrature::gauss<double, 5>;
      mass += Gauss::integrate(depth, left, left + width);
      momentum += Gauss::integrate([&](double x) { return depth(x) * velocity(x); }, left, left + width);
    }
    p.mass.push_back(mass);
    p.velocity.push_back(momentum / mass);
  }
  return p;
}

Particles uniform_stretches(const std::vector<Stretch>& stretches, std::size_t count, bool equal_masses) {
  require_that(!stretches.empty(), "stretches: at least one must be given");
  require_at_least("number of particles", static_cast<long>(count), static_cast<long>(stretches.size()));
  const auto weight = [&](const Stretch& s) { return (s.right - s.left) * (equal_masses ? s.state.depth : 1.0); };
  double total = 0;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Stretch& s = stretches[k];
    require_interval(s.left, s.right);
    require_positive("depth", s.state.depth);
    require_finite("velocity", s.state.velocity);
    const double end = k > 0 ? stretches[k - 1].right : s.left;
    require_that(s.left == end, "stretches: one ends at {:g} and the next starts at {:g}", end, s.left);
    total += weight(s);
  }
  Particles p;
  p.edge.push_back(stretches.front().left);
  double done = 0;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Stretch& s = stretches[k];
    done += weight(s);
    const std::size_t still_to_come = stretches.size() - 1 - k;
    const auto until = static_cast<std::size_t>(std::lround(static_cast<double>(count) * done / total));
    const std::size_t last = std::clamp(until, p.mass.size() + 1, count - still_to_come);
    const std::size_t here = last - p.mass.size();
    const Array edges = equal_width_edges(s.left, s.right, here);
    for (std::size_t i = 0; i < here; ++i) {
      p.edge.push_back(edges[i + 1]);
      p.mass.push_back((edges[i + 1] - edges[i]) * s.state.depth);
      p.velocity.push_back(s.state.velocity);
    }
  }
  return p;
}

Particles dam_break(double start, double dam, double end, shallow_water::State left, shallow_water::State right,
                    std::size_t count, bool equal_masses) {
  return uniform_stretches({{start, dam, left}, {dam, end, right}}, count, equal_masses);
}

Particles bore(double gravity, double start, double jump, double end, double behind, double ahead, std::size_t count,
               bool equal_masses) {
  require_positive("gravity", gravity);
  require_positive("depth ahead", ahead);
  require_that(behind > ahead,
               "depth behind the bore = {:g} must exceed the depth ahead = {:g}: an expansion jump gains energy",
               behind, ahead);
  const double velocity = shallow_water::velocity_change(gravity, behind, ahead);
  return dam_break(start, jump, end, {behind, velocity}, {ahead, 0}, count, equal_masses);
}

}  // namespace seiche::shallow_water_particles
