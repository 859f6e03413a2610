#include "seiche/models/dispersive_shallow_water_1d/friction.hpp"

#include <cmath>

#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_1d {

void Friction::validate() const {
  require_not_negative("friction coefficient", coefficient);
}

double Friction::per_length(double gravity, double depth) const {
  switch (law) {
    case FrictionLaw::manning:
      return gravity * coefficient * coefficient / (depth * std::cbrt(depth));
    case FrictionLaw::chezy:
      return gravity / (coefficient * coefficient * depth);
    case FrictionLaw::quadratic:
      break;
  }
  return coefficient / depth;
}

}  // namespace seiche::dispersive_shallow_water_1d
