#pragma once

#include <string>
#include <string_view>

namespace seiche::shallow_water_finite_volume {

/// The schemes, from the oldest to today's practice.
enum class Scheme {
  lax_friedrichs,  ///< first order, viscosity chosen by hand
  mac_cormack,     ///< second order, forward-backward, with the Harten-Hyman entropy term
  roe,             ///< first-order upwind with Roe's average and the Harten-Hyman entropy correction
  muscl_hll,       ///< second order, limited linear reconstruction, HLL flux, well balanced and dry-aware
};

/// "lax_friedrichs", "mac_cormack", "roe", "muscl_hll".
std::string_view name(Scheme scheme);
/// Throws std::invalid_argument for any other name, listing these.
Scheme scheme_from(std::string_view name);

}  // namespace seiche::shallow_water_finite_volume
