#pragma once

namespace seiche::exact {

/// Fluid velocity at a point [m/s]: u along +x, v upwards.
struct Velocity {
  double u = 0;
  double v = 0;
};

}  // namespace seiche::exact
