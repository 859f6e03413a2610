#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"

#include <cmath>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_1d {

double Friction::per_length(double gravity, double depth) const {
  return law == FrictionLaw::quadratic ? coefficient / depth
                                       : gravity * coefficient * coefficient / (depth * std::cbrt(depth));
}

void Channel::validate() const {
  require_that(bottom != nullptr, "channel without a bottom: set Channel::bottom");
  require_not_negative("period", period);
  require_positive("gravity", gravity);
  require_positive("density", density);
  require_positive("alpha", alpha);
  require_finite("slope_energy", slope_energy);
  require_not_negative("gamma", gamma);
  require_finite("depth_power", depth_power);
  require_positive("reference_depth", reference_depth);
  require_not_negative("friction coefficient", friction.coefficient);
  if (breaking) breaking->validate();
  require_that(kinetics != Kinetics::green_naghdi || alpha >= 0.25,
               "kinetics = green_naghdi needs alpha >= 1/4: the kinetic energy over steep slopes "
               "would not be positive");
}

}  // namespace seiche::dispersive_shallow_water_1d
