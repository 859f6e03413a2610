/// A row of touching particles: particle i is the rectangle between edges i and i+1 and carries a constant mass.
///
/// Edges are the unknowns, not centres and widths: particles touch by construction, each is symmetric about its own
/// position, and the sawtooth mode of a centre-and-width description cannot exist.
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <vector>

namespace seiche::shallow_water_particles {

/// std::vector whose data start on a cache line, for full-width vector loads.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}
  T* allocate(std::size_t count) { return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{64})); }
  void deallocate(T* data, std::size_t /*count*/) { ::operator delete (data, std::align_val_t{64}); }
  template <class U>
  bool operator==(const CacheLineAllocator<U>& /*other*/) const {
    return true;
  }
};

using Array = std::vector<double, CacheLineAllocator<double>>;

/// State of the row at one instant.
struct Particles {
  Array edge;      ///< N + 1 positions [m], strictly increasing
  Array mass;      ///< N masses per width and density [m^2], positive
  Array velocity;  ///< N mass-mean velocities [m/s]

  [[nodiscard]] std::size_t size() const { return mass.size(); }
  [[nodiscard]] double width(std::size_t i) const { return edge[i + 1] - edge[i]; }
  [[nodiscard]] double depth(std::size_t i) const { return mass[i] / width(i); }
  [[nodiscard]] double centre(std::size_t i) const { return 0.5 * (edge[i] + edge[i + 1]); }

  /// Throws std::invalid_argument unless there are at least 4 particles, sizes agree, every number is finite, edges
  /// increase strictly and masses are positive (a dry region is the absence of particles).
  void validate() const;
};

/// Sum of m u [m^3/s].
double total_momentum(std::span<const double> mass, std::span<const double> velocity);

}  // namespace seiche::shallow_water_particles
