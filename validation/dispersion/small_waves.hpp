/// Frequencies of small waves in tanks of a Lagrangian model: how they are measured, judged and drawn. Depth and
/// gravity are 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "reports/evidence/criterion.hpp"
#include "reports/evidence/figure.hpp"
#include "seiche/exact/dispersion.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {

/// @tparam Tank  with wavenumber, half_waves, linear_frequency(), tau
template <class Tank>
struct SmallWave {
  Tank tank;
  double frequency = 0;  ///< measured, of infinitely small waves

  [[nodiscard]] double wavenumber() const { return tank.wavenumber; }
  [[nodiscard]] double deviation() const { return frequency / tank.linear_frequency() - 1; }
};
template <class Tank>
using SmallWaves = std::vector<SmallWave<Tank>>;

template <class Tank>
SmallWaves<Tank> small_waves(const std::vector<Tank>& tanks, double periods, double amplitude) {
  SmallWaves<Tank> waves;
  for (const Tank& tank : tanks) waves.push_back({tank, smallest_wave_frequency(tank, periods, amplitude)});
  return waves;
}

template <class Tank>
Worst worst_deviation(const SmallWaves<Tank>& waves) {
  return over<Worst>(waves, &SmallWave<Tank>::deviation);
}

/// Of a relative deviation of the frequency. Elevations are counted from still water, so that roundings are relative to
/// the wave. Positions are not: they drift by eps L/6 a step at random (a number x is rounded by eps x/sqrt(12) in the
/// mean square, and x is L/sqrt(3)), which changes the frequency by half of k times the drift, averaged over columns.
/// @param columns_of  the number of a tank's columns
template <class Tank, class Columns>
evidence::Roundoff frequency_roundoff(const std::vector<Tank>& tanks, double periods, Columns columns_of) {
  constexpr double of_fit_and_law = 10;  // a hundred roundings
  constexpr double pi = std::numbers::pi;
  Largest scale;
  for (const Tank& tank : tanks) {
    const double steps = 2 * pi * periods / (tank.linear_frequency() * tank.tau);
    const double k_length = pi * static_cast<double>(tank.half_waves);
    const double drift = k_length / 12 * std::sqrt(steps / static_cast<double>(std::invoke(columns_of, tank)));
    scale.add(std::hypot(of_fit_and_law, drift));
  }
  return {.operations = 1,
          .scale = scale.value(),
          .reason =
              "a hundred roundings of fit, extrapolation and relation; positions, of the size of the tank's length L, "
              "drift by eps L/6 at random in every step, and the frequency by k/2 of that, averaged over columns"};
}

constexpr double deepest = 5;  ///< largest k H that is drawn

/// A panel of phase speeds over k H, and one of their errors against Airy.
class PhaseSpeedPanels {
 public:
  PhaseSpeedPanels(evidence::Figure& figure, double longest, double least_error)
      : speed_(figure.panel(
            {.x = "k H", .y = "phase speed/sqrt(g H)", .title = "Phase speed", .y_min = 0, .y_max = 1.05})),
        error_(figure.panel({.x = "k H",
                             .y = "relative error",
                             .title = "Error against Airy",
                             .log_x = true,
                             .log_y = true,
                             .x_min = longest,
                             .x_max = deepest,
                             .y_min = least_error,
                             .y_max = 1})) {}

  /// What was measured as circles, laws as lines; the exact one has no error.
  void add(const std::string& label, const std::vector<double>& k, const std::vector<double>& speeds,
           evidence::Role role) {
    const exact::AiryDispersion airy(1, 1);
    const auto errors =
        each(indices(k.size()), [&](std::size_t i) { return std::abs(speeds[i] / airy.phase_speed(k[i]) - 1); });
    if (role == evidence::Role::data) {
      speed_.points(label, k, speeds, role);
      error_.points(label, k, errors, role);
    } else {
      speed_.line(label, k, speeds, role);
      if (role != evidence::Role::exact) error_.line(label, k, errors, role);
    }
  }

 private:
  evidence::Panel& speed_;
  evidence::Panel& error_;
};

}  // namespace seiche::validation
