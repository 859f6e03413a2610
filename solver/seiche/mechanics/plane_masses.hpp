/// Momenta and energy of point masses in a plane: q = (x of all, y of all), u = (velocities along x, along y).
#pragma once

#include <array>
#include <span>

namespace seiche::mechanics {

/// [kg/m]
double total_mass(std::span<const double> mass);
/// Along x and y [kg/s].
std::array<double, 2> plane_momentum(std::span<const double> mass, std::span<const double> u);
/// About the origin [kg m/s].
std::array<double, 1> plane_angular_momentum(std::span<const double> mass, std::span<const double> q,
                                             std::span<const double> u);
/// [J/m]
double plane_kinetic_energy(std::span<const double> mass, std::span<const double> u);

}  // namespace seiche::mechanics
