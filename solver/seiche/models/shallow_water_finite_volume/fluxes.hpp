/// Numerical fluxes of the four schemes, each a pass over contiguous arrays.
///
/// @f[ \frac{\partial h}{\partial t} + \frac{\partial q}{\partial x} = 0, \qquad
///     \frac{\partial q}{\partial t} + \frac{\partial}{\partial x} \left( q u + \frac{g h^2}{2} \right)
///     = -g h \frac{\partial z}{\partial x}, \qquad q = h u @f]
///
/// Cells carry two ghosts at each end: cell i of the channel is entry i + ghosts. Face k lies left of cell k, face n is
/// the right end. A scheme reads cells and writes fluxes; the update, the ends and the booking are the caller's
/// (finite_volume_flow.hpp).
///
/// References: Toro, Shock-capturing methods for free-surface shallow flows (2001); Harten and Hyman, J. Comput. Phys.
/// 50 (1983) 235; Einfeldt, SIAM J. Numer. Anal. 25 (1988) 294; Audusse et al., SIAM J. Sci. Comput. 25 (2004) 2050;
/// Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, section 7.
#pragma once

#include <cstddef>
#include <vector>

namespace seiche::shallow_water_finite_volume {

inline constexpr std::size_t ghosts = 2;

/// State of n cells and their ghosts.
struct Cells {
  explicit Cells(std::size_t n)
      : depth(n + 2 * ghosts), discharge(n + 2 * ghosts), velocity(n + 2 * ghosts), celerity(n + 2 * ghosts) {}

  std::vector<double> depth;      ///< h [m]
  std::vector<double> discharge;  ///< q = h u [m^2/s]
  std::vector<double> velocity;   ///< u [m/s], 0 below the dry depth
  std::vector<double> celerity;   ///< sqrt(g h) [m/s]
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

/// Velocity and celerity from depth and discharge in entries [first, last).
void update_primitives(double gravity, double dry_depth, std::size_t first, std::size_t last, Cells& cells);

/// U' = (1 - nu) U + (nu/2)(U_{i-1} + U_{i+1}) - (tau/2dx)(F_{i+1} - F_{i-1}) in flux form:
/// F = (F_L + F_R)/2 - nu dx/(2 tau) (U_R - U_L).
///
/// @param ratio  tau/dx [s/m]
void lax_friedrichs_fluxes(double gravity, double viscosity, double ratio, const Cells& cells, Fluxes& fluxes);

/// Predictor forward, corrector backward, in flux form F = (F(U_R) + F(U*_L))/2, plus the entropy term
/// -(1/2) sum (psi(lam) - |lam|) alpha r wherever Harten and Hyman's test activates it.
class MacCormackFluxes {
 public:
  explicit MacCormackFluxes(std::size_t n) : predicted_mass_(n + 1), predicted_momentum_(n + 1) {}
  void operator()(double gravity, double ratio, const Cells& cells, Fluxes& fluxes);

 private:
  std::vector<double> predicted_mass_;  // F(U*) of the cell left of each face
  std::vector<double> predicted_momentum_;
};

/// F = (F_L + F_R)/2 - (1/2) sum psi(lam_k) alpha_k r_k with Roe's averages.
void roe_fluxes(double gravity, const Cells& cells, Fluxes& fluxes);

/// Limited linear reconstruction of h, u and h + z, hydrostatic reconstruction at the faces, HLL flux with Einfeldt's
/// speeds.
class MusclHllFluxes {
 public:
  /// @param bed  mean bed elevation of the cells with their ghosts; empty for a flat bed
  MusclHllFluxes(std::size_t n, std::vector<double> bed);
  void operator()(double gravity, double theta, const Cells& cells, Fluxes& fluxes);

 private:
  void flat(double gravity, Fluxes& fluxes) const;
  void uneven(double gravity, Fluxes& fluxes) const;

  std::vector<double> bed_;
  // Values at the left and right edge of every cell from one ghost to the other.
  std::vector<double> depth_left_, depth_right_, velocity_left_, velocity_right_, bed_left_, bed_right_;
};

}  // namespace seiche::shallow_water_finite_volume
