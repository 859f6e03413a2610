/// Particles of weakly compressible SPH: one array per quantity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace seiche::wcsph {

/// Fluid moves by the equations; walls stand; paddle k (kind = paddle, body = k) is carried by its motion.
enum class Kind : std::uint8_t { fluid, wall, paddle };

/// x horizontal, z up [m]; velocities [m/s]; density [kg/m^3]; mass per unit width [kg/m].
struct Particles {
  std::vector<double> x, z, u, w, density, mass;
  std::vector<Kind> kind;
  std::vector<std::int32_t> body;      ///< index of the paddle that carries the particle; -1 otherwise
  std::vector<std::int32_t> identity;  ///< number of the particle in the order of the beginning; sorting keeps it

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Appends one particle with the next identity.
  void add(double x_, double z_, double mass_, double density_, Kind kind_ = Kind::fluid, double u_ = 0, double w_ = 0,
           std::int32_t body_ = -1);
  [[nodiscard]] std::size_t count(Kind wanted) const;
};

}  // namespace seiche::wcsph
