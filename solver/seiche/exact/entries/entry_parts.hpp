/// What the entries of the catalogue are put together from.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "seiche/exact/catalogue.hpp"

namespace seiche::exact {

inline const Coordinate position_x{"x", "m", 0, "horizontal position"};
inline const Coordinate time_t{"t", "s", 0, "time"};
/// NaN, what y is where none is given, stands for the surface.
inline const Coordinate height_y{"y", "m", std::numeric_limits<double>::quiet_NaN(),
                                 "height above the undisturbed level; the surface where none is given"};

inline constexpr double infinite = std::numeric_limits<double>::infinity();

using Values = std::map<std::string, double>;

/// Gravity with the default of the solution's literature: 1 where everything is scaled, 9.81 for channels.
inline Parameter gravity_parameter(double default_value) {
  return {"gravity", "m/s^2", default_value, 1e-6, 1e6, "acceleration of gravity"};
}

inline Parameter depth_parameter(double default_value, double maximum) {
  return {"depth", "m", default_value, 1e-9, maximum, "depth of the water at rest"};
}
inline Parameter wavelength_parameter() {
  return {"wavelength", "m", 2 * std::numbers::pi, 1e-9, 1e9, "wavelength"};
}
/// NaN, what k is where none is given, stands for 2 pi/wavelength.
inline const Coordinate wavenumber_k{"k", "1/m", std::numeric_limits<double>::quiet_NaN(),
                                     "wavenumber; that of the wavelength where none is given"};

/// An evaluator that keeps the solution alive.
///
/// @param eval     (const S&, std::span<const double> at) -> Row
/// @param scalars  (const S&) -> Row
template <ReferenceSolution S, class Eval, class Scalars>
Evaluator evaluator_of(S solution, Eval eval, Scalars scalars) {
  auto kept = std::make_shared<const S>(std::move(solution));
  return {.eval = [kept, eval](std::span<const double> at) -> Evaluator::Row { return eval(*kept, at); },
          .scalars = [kept, scalars]() -> Evaluator::Row { return scalars(*kept); },
          .uncertainty = [kept] { return kept->uncertainty(); },
          .self_test = [kept] { return kept->self_test(); }};
}

}  // namespace seiche::exact
