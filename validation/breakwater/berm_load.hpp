/// The load of standing waves on a structure whose front and rear are pushed at different times: a berm before a
/// vertical wall, on the two-dimensional Lagrangian mesh.
///
/// Units: depth, gravity and density are 1. The rear wall is at x = 0, the front face of the berm around x = -width,
///
///     y_b = -1 + (rise/2) (1 + tanh((x + width)/steepness)),
///
/// and the basin ends at a vertical wall at x = -length. Forces are per unit width, of the dynamic pressure, towards
/// the land.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "validation/breakwater/surface_modes.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation {

struct BermLoad {
  double front = 0;  ///< on the berm
  double rear = 0;   ///< on the wall behind it

  [[nodiscard]] double total() const { return front + rear; }
};

struct Berm {
  double rise = 0.6;
  double width = 2;
  double steepness = 0.21;
  double length = 14;

  [[nodiscard]] lagrangian_mesh_2d::Mesh mesh(std::size_t columns, std::size_t rows,
                                              const std::function<double(double x)>& elevation = {}) const;
  /// It is that of the thesis.
  [[nodiscard]] bool usual() const { return rise == Berm{}.rise && width == Berm{}.width; }
};

struct BermResolution {
  double columns_per_depth;
  std::size_t rows;

  [[nodiscard]] std::size_t columns(const Berm& berm) const {
    return static_cast<std::size_t>(std::lround(columns_per_depth * berm.length));
  }
  [[nodiscard]] lagrangian_mesh_2d::Mesh mesh(const Berm& berm,
                                              const std::function<double(double x)>& elevation = {}) const {
    return berm.mesh(columns(berm), rows, elevation);
  }
  [[nodiscard]] BermResolution times(double factor) const {
    return {columns_per_depth * factor, static_cast<std::size_t>(std::lround(factor * static_cast<double>(rows)))};
  }
  /// "112 x 6 cells"
  [[nodiscard]] std::string name(const Berm& berm) const { return fmt::format("{} x {} cells", columns(berm), rows); }
};

/// Of a case's parameters.
Berm berm_of(const Values& values);
BermResolution berm_mesh_of(const Values& values);

/// Of the multipliers of all cells on a mesh with these nodes.
BermLoad berm_load(const lagrangian_mesh_2d::Mesh& mesh, std::span<const double> y,
                   std::span<const double> multipliers);

/// A standing wave of unit height at the far wall, an antinode, when it pushes on the rear wall hardest.
struct StandingLoad {
  double wavelength = 0;  ///< of a small wave of its frequency on the depth before the berm
  BermLoad force;
  double plain_wall = 0;  ///< force on a vertical wall without a berm, tanh(kH)/k

  /// |total| over that.
  [[nodiscard]] double relative() const { return std::abs(force.total()) / plain_wall; }
};

/// The waves of the basin that are longer than `shortest`, longest first.
std::vector<StandingLoad> standing_loads(const Berm& berm, const BermResolution& mesh, double shortest);
/// The same of nine basins, up to two depths shorter and longer than this, up to a wavelength; shortest first.
std::vector<StandingLoad> loads_by_wavelength(const Berm& berm, const BermResolution& mesh, double shortest,
                                              double longest);

/// A standing wave of a basin over a berm.
struct BasinWave {
  SurfaceMode mode;
  StandingLoad load;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / mode.frequency; }
  /// 1 where the rear wall is pushed when the water is high at the far wall, -1 when it is low.
  [[nodiscard]] double sense() const { return mode.multipliers.back() * mode.elevation.front() > 0 ? 1 : -1; }
};

/// The wave of nearly this length among those longer than three depths.
BasinWave basin_wave(const Berm& berm, const BermResolution& mesh, double wavelength);

}  // namespace seiche::validation
