/// Books of a particle run: what came in, what pushed, and what is left unexplained.
///
/// Mass and momentum of the particles must equal their initial values plus everything booked here, to round-off.
#pragma once

#include "seiche/compensated_sum.hpp"

namespace seiche::shallow_water_particles {

/// Impulses on the water per unit width and density [m^3/s], positive along +x, since the start of the run; inflows of
/// mass [m^2] count positive into the domain.
struct Ledger {
  double initial_mass = 0;
  double initial_momentum = 0;
  double initial_length = 0;
  CompensatedSum left_impulse;
  CompensatedSum right_impulse;
  CompensatedSum bed_impulse;
  CompensatedSum friction_impulse;
  CompensatedSum source_impulse;
  CompensatedSum left_mass;
  CompensatedSum right_mass;

  [[nodiscard]] double booked_impulse() const {
    return left_impulse.value() + right_impulse.value() + bed_impulse.value() + friction_impulse.value() +
           source_impulse.value();
  }
  [[nodiscard]] double booked_mass() const { return left_mass.value() + right_mass.value(); }
};

}  // namespace seiche::shallow_water_particles
