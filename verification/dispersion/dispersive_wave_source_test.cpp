// Waves that a force along the bottom makes, and what irregular waves are told by.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/wave_source.hpp"
#include "validation/instruments/wave_statistics.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_wave_source_test {

using namespace dispersive_shallow_water_1d;
using validation::wave_statistics;

constexpr double pi = std::numbers::pi;
const std::string derived = "derived in wave_source.hpp";

TEST_CASE("the wave source generates the prescribed record", "[dispersion]") {
  Check check("wave_source", "Waves out of a force along the bottom",
              "A channel 1 m deep, a force at 0, and as the record at x = 6 three small waves of 3.75, 2.5 and 1.875 s "
              "that repeat after 15 s, with phases. After 45 s, long after the slowest has arrived, the water's "
              "surface at x = 6 is the record, with improved dispersion and without; at x = -6 it is the record with "
              "reversed sign, because the force is antisymmetric. It sets in over 15 s.");
  for (const double gamma : {0.0, 1.0 / 15}) {
    const Channel channel{
        .bottom = std::make_shared<LevelBottom>(1.0), .gravity = 9.81, .alpha = 1.0 / 3 + gamma, .gamma = gamma};
    const auto record_at = [](double t) {
      return 1e-5 * (std::cos(2 * pi * t / 3.75 + 0.3) + 0.7 * std::cos(2 * pi * t / 2.5 - 1) +
                     0.5 * std::sin(2 * pi * t / 1.875 + 0.4));
    };
    std::vector<double> record;
    constexpr double interval = 0.05;
    for (int i = 0; i < 300; ++i) record.push_back(record_at(interval * i));
    const WaveSource source(channel, {.depth = 1, .source = 0, .width = 0.3, .target = 6}, record, interval, 0.1, 0.8);
    // Nothing comes back from the walls: the fastest waves run 3.2 m/s.
    constexpr double half = 110;
    constexpr std::size_t cells = 4400;
    const auto still = still_markers(channel, equal_labels(channel, -half, half, cells));
    Forcing forcing;
    forcing.body_force = [&](double time, std::span<double> along, std::span<double> /*across*/) {
      const double start = time < 15 ? 0.5 * (1 - std::cos(pi * time / 15)) : 1;
      const double strength = start * source.strength(time);
      for (std::size_t i = 2100; i <= 2300; ++i) along[i] += strength * source.shape(still.x[i]);
    };
    Flow flow(channel, still, {}, forcing);
    march(flow, 45, stable_steps(flow, 0.02));
    const std::vector<double> places{6, -6};
    Mean right, left, size;
    for (int i = 1; i <= 150; ++i) {
      march(flow, 45 + 0.1 * i, stable_steps(flow, 0.02));
      const auto surface = water_surface_at(flow, places);
      const double wanted = record_at(flow.time());
      right.add(std::pow(surface[0] - wanted, 2));
      left.add(std::pow(surface[1] + wanted, 2));
      size.add(wanted * wanted);
    }
    const std::string which = gamma > 0 ? "improved dispersion" : "gamma = 0";
    const auto claim = [&](const std::string& side, double square) {
      check.holds(
          fmt::format("The elevation with {} agrees with the requested record on the {}.", which, side),
          {std::sqrt(square / size.value())},
          Bound{0.02,
                "nodes and steps: (omega tau)^2/24 of 3.4 rad/s and (k h)^2 of a wave of 4.6 m are some 0.1 %, and so "
                "are remains of the switched on waves; straight lines between samples of F, 0.0125 s, far less"});
    };
    claim("right", right.value());
    claim("left", left.value());
  }
}

TEST_CASE("statistics of waves have their closed forms", "[dispersion]") {
  Check check("wave_statistics", "Standard deviation, skewness and asymmetry of a wave with its second harmonic",
              "a cos t + b cos(2 t + p) has the variance (a^2 + b^2)/2, and 3 a^2 b/4 times cos p and -sin p for its "
              "mean cube and for its Hilbert transform's a sin t + b sin(2 t + p). With p > 0 the wave pitches forward "
              "in time: its front comes first.");
  constexpr int n = 48;
  Worst deviation, skewness, asymmetry;
  for (const double phase : {0.0, 0.7, -0.7, 1.5, -2.4}) {
    constexpr double a = 1.3, b = 0.4;
    std::vector<double> samples;
    for (int i = 0; i < n; ++i) {
      const double t = 2 * pi * i / n * 3;
      samples.push_back(0.2 + a * std::cos(t) + b * std::cos(2 * t + phase));
    }
    const auto found = wave_statistics(samples);
    const double s = std::sqrt(0.5 * (a * a + b * b)), third = 0.75 * a * a * b / std::pow(s, 3);
    deviation.add(found.deviation - s);
    skewness.add(found.skewness - third * std::cos(phase));
    // mean of (a sin t + b sin(2 t + p))^3 = -3 a^2 b/4 sin p
    asymmetry.add(found.asymmetry - third * std::sin(phase));
  }
  const auto claim = [&](const std::string& id, double value) {
    check.holds("The " + id + " agrees with the closed form.", {value},
                Roundoff{200, 2, "transforms and sums of 48 samples of size 2"});
  };
  claim("deviation", deviation.value());
  claim("skewness", skewness.value());
  claim("asymmetry", asymmetry.value());
  CHECK_THROWS_AS(wave_statistics(std::vector<double>{1, 2, 3}), std::invalid_argument);
}

}  // namespace seiche::verification::dispersive_wave_source_test
