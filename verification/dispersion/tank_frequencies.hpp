/// Standing waves of boxes of cells: their frequencies beside the closed form.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// Half-waves along x and y.
struct HalfWaves {
  std::size_t x, y;
};
/// From one half-wave to nearly the shortest of ten cells.
inline constexpr std::array tank_modes{HalfWaves{1, 0}, HalfWaves{2, 1}, HalfWaves{3, 3},
                                       HalfWaves{0, 5}, HalfWaves{7, 6}, HalfWaves{9, 7}};

/// The law of a tank, frequency(k), up to its shortest wave, over sqrt(g/H).
template <class Frequency>
void draw_law(auto& panel, const std::string& name, const auto& tank, int points, const Frequency& frequency) {
  std::vector<double> kh, omega;
  for (int i = 1; i <= points; ++i) {
    const double k = i * (std::numbers::pi * static_cast<double>(tank.columns) / tank.length) / points;
    kh.push_back(k * tank.depth);
    omega.push_back(frequency(k) / std::sqrt(tank.gravity / tank.depth));
  }
  panel.line(name, kh, omega, Role::exact);
}

/// Draws the law along the x axis, and runs at any angle. Returns their largest relative error.
/// @param run  run(half-waves): frequency of the closed form, and of a run
template <class Frequency, class Run>
double draw_runs(auto& panel, const std::string& name, const auto& tank, const Frequency& along_x, const Run& run) {
  draw_law(panel, name, tank, 100, along_x);
  std::vector<double> places, found;
  Worst worst;
  for (const HalfWaves& mode : tank_modes) {
    const auto [expected, measured] = run(mode);
    worst.add(measured / expected - 1);
    const double k = std::hypot(std::numbers::pi * static_cast<double>(mode.x) / tank.length,
                                std::numbers::pi * static_cast<double>(mode.y) / tank.width);
    if (k > std::numbers::pi * static_cast<double>(tank.columns) / tank.length) continue;
    places.push_back(k * tank.depth);
    found.push_back(measured / expected * along_x(k) / std::sqrt(tank.gravity / tank.depth));
  }
  panel.points("runs, " + name, places, found, Role::data);
  return worst.value();
}

}  // namespace seiche::verification
