#include "seiche/models/shallow_water_particles/particles.hpp"

#include <stdexcept>

#include <fmt/format.h>

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

}  // namespace seiche::shallow_water_particles
