/// What the entries of surfaces that may overturn have in common: points along the surface, times of breaking.
#pragma once

#include <memory>
#include <optional>

#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/overturning/moving_surface.hpp"

namespace seiche::exact {

inline const std::vector<Quantity> points_of_surface{{"x", "m", "along the surface, in the surface's order"},
                                                     {"y", "m", "elevation there"},
                                                     {"phi", "m^2/s", "velocity potential"},
                                                     {"u", "m/s", "horizontal velocity"},
                                                     {"v", "m/s", "vertical velocity"}};

inline const Parameter points_of_profile{"points", "1", 0,
                                         0,        1e6, "points of a profile, at equal arc length; 0: at the markers"};

inline std::vector<Evaluator::Row> rows_of(const overturning::MovingSurface& wave, double t, std::size_t points) {
  const auto profile = points > 0 ? wave.profile(t, points) : wave.profile(t);
  std::vector<Evaluator::Row> rows;
  for (std::size_t j = 0; j < profile.x.size(); ++j) {
    rows.push_back({profile.x[j], profile.y[j], profile.potential[j], profile.u[j], profile.v[j]});
  }
  return rows;
}

inline double or_none(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// @param scalars  (const Wave&) -> Row
template <class Wave, class Scalars>
Evaluator moving_surface_evaluator(Wave wave, std::size_t points, Scalars scalars) {
  const auto kept = std::make_shared<const Wave>(std::move(wave));
  const auto along = [kept, points](std::span<const double> at) { return rows_of(*kept, at[0], points); };
  return {.eval = [along](std::span<const double> at) { return along(at).front(); },
          .scalars = [kept, scalars]() -> Evaluator::Row { return scalars(*kept); },
          .curve = along,
          .uncertainty = [kept] { return kept->uncertainty(); },
          .self_test = [kept] { return kept->self_test(); }};
}

}  // namespace seiche::exact
