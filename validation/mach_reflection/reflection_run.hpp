/// One run of a solitary wave that meets a wall at an angle, and what is measured of it. Depth 1, gravity 1.
///
/// How long a stem takes to reach its height: the Kadomtsev-Petviashvili equation gives exp(-t/t_s),
///
///     t_s = 3/(S^3 kappa |1 - kappa|),   S = sqrt(3a),   kappa = tan(psi)/(S cos(psi)),
///
/// which has no end at kappa = 1. A run of 250 sqrt(0.3/a) + 4 t_s, with |1 - kappa| no less than 0.03, forms the
/// pattern and shows the approach to its limit; how well the limit is known follows from the run's length times 1/t_s,
/// without that 0.03 (wall_history.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "validation/case/study.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/fine_limit.hpp"
#include "validation/instruments/plan/oblique_wave.hpp"
#include "validation/instruments/plan/reflection_pattern.hpp"
#include "validation/instruments/plan/wall_history.hpp"
#include "validation/mach_reflection/surface_part.hpp"

namespace seiche::validation {

/// Which model carries the water: water columns seen from above, or layers of hexahedra.
enum class WaveModel { plan, hexahedra };
/// Throws std::invalid_argument listing the names.
WaveModel wave_model_named(std::string_view name);

inline double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}
inline double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}
/// A number as a part of an id: "0_3".
std::string id_of(double number);

/// What to run.
struct ReflectionRun {
  double amplitude = 0.3;
  double angle = 0;      ///< psi [rad]
  double spacing = 0.5;  ///< of the lattice at rest
  double step = 0.5;     ///< over the spacing
  double time = 0;       ///< how long; 0 for settled_time()
  WaveModel model = WaveModel::plan;
  std::size_t layers = 2;   ///< of hexahedra
  double height = 0;        ///< of the window; 0 for what window_until() finds sufficient
  double tolerance = 1e-7;  ///< relative residual of the solver
  double excess = 0;        ///< of the first wave next to the wall (oblique_wave.hpp)

  /// The theory for small waves, of Miles and with the parameter for finite angles.
  [[nodiscard]] exact::MachReflection miles() const { return {amplitude, angle}; }
  [[nodiscard]] exact::MachReflection finite_angles() const {
    return {amplitude, angle, exact::MachReflection::Theory::kodama_yeh};
  }
  [[nodiscard]] double tau() const { return step * spacing; }
  [[nodiscard]] double kappa() const { return miles().kappa(); }                       ///< psi/sqrt(3a)
  [[nodiscard]] double kappa_finite_angle() const { return finite_angles().kappa(); }  ///< tan(psi)/(sqrt(3a) cos(psi))
  [[nodiscard]] double settling_rate() const;                                          ///< 1/t_s
  [[nodiscard]] double settled_time() const;
  /// The time that will be run.
  [[nodiscard]] double duration() const { return time > 0 ? time : settled_time(); }
  /// "h = 0.5, tau = 0.25, t = 600".
  [[nodiscard]] std::string resolution() const;
};

/// a/b, with the uncertainties of both.
inline evidence::Measurement quotient(const evidence::Measurement& a, const evidence::Measurement& b,
                                      const std::string& resolution) {
  const double value = a.value / b.value;
  return {.value = value,
          .uncertainty = std::abs(value) * std::hypot(a.half_width() / a.value, b.half_width() / b.value),
          .resolution = resolution};
}

/// What came of it.
struct Reflection {
  ReflectionRun run;
  std::vector<double> time;
  std::vector<double> wall;    ///< a_w then, means over 2.5 time units
  double ripple = 0;           ///< half of the range of heights of which the last of them is the mean
  ReflectionPattern pattern;   ///< at the end
  SurfacePart surface;         ///< at the end, x from the crest on the wall
  WallLimit limit;             ///< of a_w
  evidence::Measurement stem;  ///< angle of the path of the stem's end [rad], over the last two fifths
  double worst_corner = 1;     ///< shape of the worst corner of the lattice at the end
  std::size_t cells = 0;
  double iterations = 0;  ///< of the solver, per solution
  double seconds = 0;     ///< processor time

  /// a_w at a time, linearly between its values; the last of them after it.
  [[nodiscard]] double wall_at(double when) const {
    return linear_at({time, wall}, std::clamp(when, time.front(), time.back()));
  }
  /// a_w/a_i at the end, a_i, a_w/a_i for t -> infinity, a_r/a_i, psi_r [deg]; NaN without a reflected crest.
  [[nodiscard]] evidence::Measurement wall_ratio() const;
  [[nodiscard]] evidence::Measurement incident_amplitude() const { return pattern.incident_amplitude; }
  [[nodiscard]] evidence::Measurement limit_ratio() const {
    return quotient(limit.amplitude, pattern.incident_amplitude, run.resolution());
  }
  [[nodiscard]] evidence::Measurement reflected_ratio() const;
  [[nodiscard]] evidence::Measurement reflected_angle() const;
  /// "growth 1.3 %: not steady" or "steady".
  [[nodiscard]] std::string growth_flag() const {
    return limit.steady() ? "steady" : fmt::format("growth {:.1f} %: not steady", 100 * limit.growth);
  }
};

/// Throws std::invalid_argument for what cannot be run, Divergence where it breaks down or shows no pattern that can be
/// measured.
Reflection reflect(const ReflectionRun& run);
/// The same as a part of a case's run: one that meets many takes those that an interrupted one had finished.
Reflection reflect_as_part(const Run& run, const ReflectionRun& what);
/// The limit of fine lattices, the finest first, of a number of their reflections.
template <class Number>
FineLimit limit_of_lattices(const std::vector<Reflection>& lattices, Number number) {
  return fine_limit(each(lattices, [](const Reflection& r) { return r.run.spacing; }), each(lattices, number));
}

}  // namespace seiche::validation
