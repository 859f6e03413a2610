#include "seiche/models/gauss_particles/spatial_model.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/require.hpp"

namespace seiche::gauss_particles {

namespace {

using Vector = SpatialModel::Vector;

/// About z by one angle, then about x by another: any number of these leave an octahedron's second moments isotropic.
Vector turned(const Vector& r, double about_z, double about_x) {
  const double x = std::cos(about_z) * r[0] - std::sin(about_z) * r[1];
  const double y = std::sin(about_z) * r[0] + std::cos(about_z) * r[1];
  return {x, std::cos(about_x) * y - std::sin(about_x) * r[2], std::sin(about_x) * y + std::cos(about_x) * r[2]};
}

void require_spatial(const SpatialParticles& particles) {
  const std::size_t n = particles.size();
  if (n == 0 || particles.x.size() != n || particles.y.size() != n || particles.z.size() != n) {
    throw std::invalid_argument(fmt::format("particles: {} x, {} y, {} z, {} masses; allowed: as many of each, not 0",
                                            particles.x.size(), particles.y.size(), particles.z.size(), n));
  }
  for (std::size_t k = 0; k < n; ++k) {
    require_finite(fmt::format("x of particle {}", k), particles.x[k]);
    require_finite(fmt::format("y of particle {}", k), particles.y[k]);
    require_finite(fmt::format("z of particle {}", k), particles.z[k]);
    require_positive(fmt::format("mass of particle {}", k), particles.mass[k]);
  }
}

}  // namespace

SpatialParticles ball(double radius, std::size_t shells, double density) {
  require_positive("radius", radius);
  require_at_least("shells", static_cast<long>(shells), 1);
  require_positive("density", density);
  SpatialParticles particles;
  const double width = radius / static_cast<double>(shells);
  for (std::size_t i = 1; i <= shells; ++i) {
    const double inner = width * static_cast<double>(i - 1);
    const double outer = width * static_cast<double>(i);
    const double cubes = std::pow(outer, 3) - std::pow(inner, 3);
    const double r = std::sqrt(0.6 * (std::pow(outer, 5) - std::pow(inner, 5)) / cubes);
    const std::size_t octahedra = i * i;
    const double mass = density * 4 * std::numbers::pi / 3 * cubes / (6 * static_cast<double>(octahedra));
    for (std::size_t k = 0; k < octahedra; ++k) {
      const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(octahedra);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double side : {-r, r}) {
          Vector corner{};
          corner[axis] = side;
          const Vector at = turned(corner, part * std::numbers::pi / 2, std::numbers::phi * static_cast<double>(k + i));
          particles.x.push_back(at[0]);
          particles.y.push_back(at[1]);
          particles.z.push_back(at[2]);
          particles.mass.push_back(mass);
        }
      }
    }
  }
  return particles;
}

SpatialModel::SpatialModel(SpatialParticles particles, SpatialFields fields, double gravity)
    : particles_(std::move(particles)), fields_(std::move(fields)), gravity_(gravity) {
  require_spatial(particles_);
  require_not_negative("gravity", gravity);
  const mechanics::State first = state({});
  try {
    linearise({0, 0}, first.q);
  } catch (const mechanics::Infeasible& failure) {
    throw std::invalid_argument(failure.what());
  }
}

mechanics::State SpatialModel::state(const std::function<Vector(const Vector& place)>& velocity) const {
  mechanics::State state;
  for (const auto* const places : {&particles_.x, &particles_.y, &particles_.z}) {
    state.q.insert(state.q.end(), places->begin(), places->end());
  }
  state.u.assign(rates(), 0.0);
  if (velocity) {
    for (std::size_t k = 0; k < size(); ++k) {
      const Vector v = velocity({particles_.x[k], particles_.y[k], particles_.z[k]});
      for (std::size_t c = 0; c < 3; ++c) state.u[c * size() + k] = v[c];
    }
  }
  return state;
}

void SpatialModel::linearise(mechanics::Interval, mechanics::Input q) {
  fields_.place(q, particles_.mass);
}

void SpatialModel::kick(double h, mechanics::Output u) const {
  for (std::size_t k = 2 * size(); k < 3 * size(); ++k) u[k] -= h * gravity_;
}

void SpatialModel::advance(mechanics::Input from, mechanics::Input u, double h, mechanics::Output to) const {
  for (std::size_t k = 0; k < from.size(); ++k) to[k] = from[k] + h * u[k];
}

void SpatialModel::project(mechanics::Output u, mechanics::Input, mechanics::Output) {
  fields_.project(u);
}

double SpatialModel::mass() const {
  CompensatedSum sum;
  for (const double m : particles_.mass) sum.add(m);
  return sum.value();
}

SpatialModel::Vector SpatialModel::momentum(mechanics::Input, mechanics::Input u) const {
  Vector total{};
  for (std::size_t c = 0; c < 3; ++c) {
    CompensatedSum sum;
    for (std::size_t k = 0; k < size(); ++k) sum.add(particles_.mass[k] * u[c * size() + k]);
    total[c] = sum.value();
  }
  return total;
}

SpatialModel::Vector SpatialModel::angular_momentum(mechanics::Input q, mechanics::Input u) const {
  Vector total{};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t a = (c + 1) % 3 * size();
    const std::size_t b = (c + 2) % 3 * size();
    CompensatedSum sum;
    for (std::size_t k = 0; k < size(); ++k) {
      sum.add(particles_.mass[k] * q[a + k] * u[b + k]);
      sum.add(-particles_.mass[k] * q[b + k] * u[a + k]);
    }
    total[c] = sum.value();
  }
  return total;
}

double SpatialModel::kinetic_energy(mechanics::Input, mechanics::Input u) const {
  CompensatedSum sum;
  for (std::size_t i = 0; i < u.size(); ++i) sum.add(0.5 * particles_.mass[i % size()] * u[i] * u[i]);
  return sum.value();
}

double SpatialModel::potential_energy(mechanics::Input q) const {
  CompensatedSum sum;
  for (std::size_t k = 0; k < size(); ++k) sum.add(particles_.mass[k] * gravity_ * q[2 * size() + k]);
  return sum.value();
}

}  // namespace seiche::gauss_particles
