#pragma once

namespace seiche {

/// The surface of water with improved dispersion over what its markers carry: (1 + above s)/(1 + below s) =
/// sqrt(1 + s) + O(s^3), s = gamma H^2 k^2. See dispersive_shallow_water_1d/water_surface.hpp.
struct DispersiveSurface {
  static constexpr double above = 0.75;
  static constexpr double below = 0.25;
};

}  // namespace seiche
