#include "seiche/mechanics/plane_masses.hpp"

#include <cstddef>

#include "seiche/compensated_sum.hpp"

namespace seiche::mechanics {

double total_mass(std::span<const double> mass) {
  CompensatedSum sum;
  for (const double m : mass) sum.add(m);
  return sum.value();
}

std::array<double, 2> plane_momentum(std::span<const double> mass, std::span<const double> u) {
  const std::size_t n = mass.size();
  CompensatedSum x;
  CompensatedSum y;
  for (std::size_t k = 0; k < n; ++k) {
    x.add(mass[k] * u[k]);
    y.add(mass[k] * u[n + k]);
  }
  return {x.value(), y.value()};
}

std::array<double, 1> plane_angular_momentum(std::span<const double> mass, std::span<const double> q,
                                             std::span<const double> u) {
  const std::size_t n = mass.size();
  CompensatedSum sum;
  for (std::size_t k = 0; k < n; ++k) sum.add(mass[k] * (q[k] * u[n + k] - q[n + k] * u[k]));
  return {sum.value()};
}

double plane_kinetic_energy(std::span<const double> mass, std::span<const double> u) {
  const std::size_t n = mass.size();
  CompensatedSum sum;
  for (std::size_t k = 0; k < n; ++k) sum.add(0.5 * mass[k] * (u[k] * u[k] + u[n + k] * u[n + k]));
  return sum.value();
}

}  // namespace seiche::mechanics
