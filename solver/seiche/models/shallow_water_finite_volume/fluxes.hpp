/// Numerical fluxes of the four schemes, each a pass over contiguous arrays.
///
/// @f[ \frac{\partial h}{\partial t} + \frac{\partial q}{\partial x} = 0, \qquad
///     \frac{\partial q}{\partial t} + \frac{\partial}{\partial x} \left( q u + \frac{g h^2}{2} \right)
///     = -g h \frac{\partial z}{\partial x}, \qquad q = h u @f]
///
/// Cells carry two ghosts at each end. Face k lies left of cell k, face n is the right end. A scheme reads n cells, a
/// channel's or a block's of one, and writes the first n + 1 fluxes; the update, the ends and the booking are the
/// caller's (finite_volume_flow.hpp).
///
/// References: Toro, Shock-capturing methods for free-surface shallow flows (2001); Harten and Hyman, J. Comput. Phys.
/// 50 (1983) 235; Einfeldt, SIAM J. Numer. Anal. 25 (1988) 294; Audusse et al., SIAM J. Sci. Comput. 25 (2004) 2050;
/// Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, section 7.
#pragma once

#include <cstddef>
#include <vector>

namespace seiche::shallow_water_finite_volume {

inline constexpr std::size_t ghosts = 2;

/// Where the cells of a channel, or of a block of it, are: cell i is entry i, ghosts are entries -2, -1, n and n + 1.
struct CellsView {
  double* depth = nullptr;      ///< h [m]
  double* discharge = nullptr;  ///< q = h u [m^2/s]
  double* velocity = nullptr;   ///< u [m/s], 0 below the dry depth
  double* celerity = nullptr;   ///< sqrt(g h) [m/s]

  /// Counted from cell i on.
  [[nodiscard]] CellsView from(std::ptrdiff_t i) const {
    return {depth + i, discharge + i, velocity + i, celerity + i};
  }
};

/// State of n cells and their ghosts: cell i is entry i + ghosts.
struct Cells {
  explicit Cells(std::size_t n)
      : depth(n + 2 * ghosts), discharge(n + 2 * ghosts), velocity(n + 2 * ghosts), celerity(n + 2 * ghosts) {}

  [[nodiscard]] CellsView view() {
    return CellsView{depth.data(), discharge.data(), velocity.data(), celerity.data()}.from(ghosts);
  }

  std::vector<double> depth, discharge, velocity, celerity;
};

/// Fluxes through n + 1 faces. On an uneven bed the two sides of a face feel different thrusts, and a cell has a
/// source.
struct Fluxes {
  explicit Fluxes(std::size_t n, bool uneven)
      : mass(n + 1), momentum(n + 1), momentum_right(uneven ? n + 1 : 0), source(uneven ? n : 0) {}

  std::vector<double> mass;            ///< [m^2/s]
  std::vector<double> momentum;        ///< [m^3/s^2], as the cell on the left of the face feels it
  std::vector<double> momentum_right;  ///< as the cell on the right feels it; empty on a flat bed
  std::vector<double> source;          ///< centred bed source of each cell [m^3/s^2]; empty on a flat bed
};

/// U' = (1 - nu) U + (nu/2)(U_{i-1} + U_{i+1}) - (tau/2dx)(F_{i+1} - F_{i-1}) in flux form:
/// F = (F_L + F_R)/2 - nu dx/(2 tau) (U_R - U_L).
///
/// @param ratio  tau/dx [s/m]
void lax_friedrichs_fluxes(double gravity, double viscosity, double ratio, const CellsView& cells, std::size_t n,
                           Fluxes& fluxes);

/// Predictor forward, corrector backward, in flux form F = (F(U_R) + F(U*_L))/2, plus the entropy term
/// -(1/2) sum (psi(lam) - |lam|) alpha r wherever Harten and Hyman's test activates it.
class MacCormackFluxes {
 public:
  /// @param most  cells
  explicit MacCormackFluxes(std::size_t most) : predicted_mass_(most + 1), predicted_momentum_(most + 1) {}
  void operator()(double gravity, double ratio, const CellsView& cells, std::size_t n, Fluxes& fluxes);

 private:
  std::vector<double> predicted_mass_;  // F(U*) of the cell left of each face
  std::vector<double> predicted_momentum_;
};

/// F = (F_L + F_R)/2 - (1/2) sum psi(lam_k) alpha_k r_k with Roe's averages.
void roe_fluxes(double gravity, const CellsView& cells, std::size_t n, Fluxes& fluxes);

/// Limited linear reconstruction of h, u and h + z, hydrostatic reconstruction at the faces, HLL flux with Einfeldt's
/// speeds.
class MusclHllFluxes {
 public:
  /// @param most  cells
  MusclHllFluxes(std::size_t most, bool uneven);
  /// @param bed  mean bed elevations, of ghosts too: cell i is entry i; null for a flat bed
  void operator()(double gravity, double theta, const CellsView& cells, const double* bed, std::size_t n,
                  Fluxes& fluxes);

 private:
  void flat(double gravity, std::size_t n, Fluxes& fluxes) const;
  void uneven(double gravity, std::size_t n, Fluxes& fluxes) const;

  // Values at the left and right edge of every cell from one ghost to the other.
  std::vector<double> depth_left_, depth_right_, velocity_left_, velocity_right_, bed_left_, bed_right_;
};

}  // namespace seiche::shallow_water_finite_volume
