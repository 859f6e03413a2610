/// Particles for the checks of weakly compressible SPH, and how they are compared.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/noise.hpp"

namespace seiche::verification {

/// A square lattice of columns x rows particles in the middle of their cells, lower left corner at the origin, at rest.
inline wcsph::Particles lattice(std::size_t columns, std::size_t rows, double spacing, double density) {
  wcsph::Particles particles;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      particles.add((static_cast<double>(i) + 0.5) * spacing, (static_cast<double>(j) + 0.5) * spacing,
                    density * spacing * spacing, density);
    }
  }
  return particles;
}

/// Moves the fluid by up to `distance` in each direction.
inline void jitter(wcsph::Particles& particles, double distance, std::uint64_t seed = 1) {
  Noise noise(seed);
  for (std::size_t a = 0; a < particles.size(); ++a) {
    if (particles.kind[a] != wcsph::Kind::fluid) continue;
    particles.x[a] += distance * noise();
    particles.z[a] += distance * noise();
  }
}

/// A disc of unit radius about the origin on a square lattice with a particle at its centre, at rest.
inline wcsph::Particles wcsph_disc(double spacing, double density) {
  wcsph::Particles particles;
  const int reach = static_cast<int>(std::ceil(1 / spacing));
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      const double x = i * spacing;
      const double z = j * spacing;
      if (x * x + z * z <= 1) particles.add(x, z, density * spacing * spacing, density);
    }
  }
  return particles;
}

/// A free blob without symmetry: a jittered disc with random velocities, densities and masses.
inline wcsph::Particles random_blob(double spacing, double density, double speed, std::uint64_t seed = 1) {
  wcsph::Particles particles = wcsph_disc(spacing, density);
  jitter(particles, 0.2 * spacing, seed);
  Noise noise(seed + 1);
  for (std::size_t a = 0; a < particles.size(); ++a) {
    particles.u[a] = speed * noise();
    particles.w[a] = speed * noise();
    particles.density[a] *= 1 + 0.01 * noise();
    particles.mass[a] *= 1 + 0.1 * noise();
  }
  return particles;
}

/// A jittered square of n x n particles of density 1000 with random velocities and densities.
inline wcsph::Particles noisy_square(std::size_t n, double spacing) {
  wcsph::Particles particles = lattice(n, n, spacing, 1000);
  jitter(particles, 0.2 * spacing);
  Noise noise(7);
  for (std::size_t a = 0; a < particles.size(); ++a) {
    particles.u[a] = noise();
    particles.w[a] = noise();
    particles.density[a] *= 1 + 0.02 * noise();
  }
  return particles;
}

/// A wall of two staggered rows on z = 0 from x = left to right, the second half a spacing below.
inline void add_floor(wcsph::Particles& particles, double left, double right, double spacing, double density) {
  const double mass = density * spacing * spacing;
  const long cells = std::lround((right - left) / spacing);
  for (long i = 0; i <= cells; ++i) {
    particles.add(left + static_cast<double>(i) * spacing, 0, mass, density, wcsph::Kind::wall);
    if (i < cells) {
      particles.add(left + (static_cast<double>(i) + 0.5) * spacing, -0.5 * spacing, mass, density, wcsph::Kind::wall);
    }
  }
}

/// Indices of the particles in the order of their identity: sorting by the flow undone.
inline std::vector<std::size_t> by_identity(const wcsph::Particles& particles) {
  std::vector<std::size_t> order(particles.size());
  for (std::size_t a = 0; a < order.size(); ++a) order[static_cast<std::size_t>(particles.identity[a])] = a;
  return order;
}

/// The values of an array in the order of identities.
inline std::vector<double> sorted_back(const wcsph::Particles& particles, const std::vector<double>& values) {
  std::vector<double> result;
  for (const std::size_t a : by_identity(particles)) result.push_back(values[a]);
  return result;
}

/// Largest difference over the largest magnitude of the reference.
inline double relative_difference(const std::vector<double>& values, const std::vector<double>& reference) {
  Worst difference, scale;
  for (std::size_t a = 0; a < values.size(); ++a) {
    difference.add(values[a] - reference[a]);
    scale.add(reference[a]);
  }
  return scale.value() == 0 ? difference.value() : difference.value() / scale.value();
}

}  // namespace seiche::verification
