/// Regular waves that come in from a paddle on a berm before a wall.
///
/// The tank is the basin of a standing wave, made longer towards the sea by `sea`; its left wall is a piston,
///
///     x = -length + (S/2) r(t) sin(omega t),
///
/// r a polynomial with three continuous derivatives that rises from 0 to 1 in the time `rise`. Depth, gravity and
/// density are 1.
///
/// The basin's wave is what the settled tank holds before the berm: its far wall, at x = -basin.length, is an antinode
/// and a mirror, on the same mesh. With
///
///     tau = (2/Omega) sin(pi/steps),   omega = 2 pi/(steps tau),
///
/// Omega the wave's frequency without errors of time, the one-step scheme has it exactly, `steps` to the period; and as
/// a force is read off two steps' mean, its ratio to the elevation is that of the eigenvalues, without an error of
/// order tau^2.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "validation/breakwater/berm_load.hpp"

namespace seiche::validation {

/// Speeds and times of a tank.
struct IncidentWaves {
  double sea = 36;           ///< from the far wall of the basin to the piston at rest
  double rise = 28;          ///< of the piston's motion
  double half_stroke = 0;    ///< S/2
  double omega = 1;          ///< of the piston
  double end = 1;            ///< of the run
  long settled_periods = 4;  ///< last periods, in which the tank counts as settled
  double tau = 0.1;

  [[nodiscard]] double piston(double time) const;
  [[nodiscard]] double piston_velocity(double time) const;
};

/// Histories, without what still water has.
struct TankHistory {
  std::vector<double> time, front, rear, antinode;  ///< elevation at an antinode

  /// Of the settled periods, over the elevation at the far antinode: what `StandingLoad::force` is.
  struct Settled {
    std::complex<double> antinode;     ///< elevation that the antinode would have at the basin's far wall
    std::complex<double> front, rear;  ///< over it
    [[nodiscard]] std::complex<double> total() const { return front + rear; }
  };
};

/// The antinode of a basin's wave that is next to the berm, two depths before it or more: the place, and the elevation
/// there over that at the far wall.
struct Antinode {
  double place = 0;
  double relative = 1;
};
Antinode antinode_before(const Berm& berm, const SurfaceMode& mode);

/// Throws Divergence.
TankHistory run_tank(const Berm& basin, const BermResolution& mesh, const IncidentWaves& waves,
                     const Antinode& antinode);

TankHistory::Settled settled(const TankHistory& history, const IncidentWaves& waves, const Antinode& antinode);

}  // namespace seiche::validation
