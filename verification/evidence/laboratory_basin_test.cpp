// Waves in laboratory basins of the 2DH model: what a paddle makes, what the layer before the far wall leaves, and
// what gauges read on a lattice that moves.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/plan/plan_gauges.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"
#include "validation/studies/dispersive_shallow_water/wave_basin.hpp"
#include "verification/check.hpp"

namespace seiche::verification::laboratory_basin_test {

using namespace validation;
using namespace validation::laboratory;

constexpr double depth = 0.4572;
constexpr double channel = 9;  // before the layer
constexpr double rate = 3;
constexpr double amplitude = 1e-5;  // so small that waves are linear

/// Waves of a period in a level channel, and what is known of them.
struct Channel {
  double period = 1, spacing = 0.1;

  [[nodiscard]] double layer() const { return 6 * period; }
  [[nodiscard]] long steps() const { return std::lround(4 * period / spacing); }
  [[nodiscard]] double wavenumber_of(double at_period) const { return wavenumber(depth, at_period, 9.81, improved); }
  [[nodiscard]] double k() const { return wavenumber_of(period); }
  [[nodiscard]] double omega() const { return 2 * std::numbers::pi / period; }
  [[nodiscard]] double group_speed() const {
    constexpr double part = 1e-4;
    return omega() * 2 * part / (wavenumber_of(period * (1 - part)) - wavenumber_of(period * (1 + part)));
  }
  /// What a smooth layer leaves on the way to the wall and back, exp(-int r dx/c_g).
  [[nodiscard]] double left() const { return std::exp(-rate * layer() / (3 * group_speed())); }
  [[nodiscard]] Bound bound() const {
    return {.limit = std::pow(k() * spacing, 2) / 12 + 2 * left() + rate / (4 * omega() * k() * layer()),
            .reason =
                "the relative error of the grid is (k h)^2/12; waves reach the wall behind the layer and come back, "
                "twice exp(-int r dx/c_g); its rate rises within a length L, which sends back r/(4 omega k L)"};
  }
};

/// Amplitude of the first harmonic along half a wavelength, in which the envelope of two waves repeats itself.
struct Envelope {
  double mean = 0;       ///< over what was asked for
  double reflected = 0;  ///< amplitude of the wave that returns over that of the one that comes
};

Envelope envelope(const Channel& waves) {
  auto flow = basin_flow({.begin = 0,
                          .end = channel + waves.layer(),
                          .north = 2 * waves.spacing,
                          .bottom = [](double, double) { return -depth; },
                          .spacing = waves.spacing,
                          .absorbed_from = channel,
                          .absorption = rate},
                         {.depth = depth, .amplitude = amplitude, .period = waves.period});
  constexpr double settled = 36;  // waves have come everywhere, for all periods a whole number of them
  march(flow, settled, waves.period / static_cast<double>(waves.steps()));
  std::vector<Point> places;
  constexpr int count = 24;
  for (int i = 0; i < count; ++i) {
    places.push_back({0.95 * channel - std::numbers::pi / waves.k() * i / count, waves.spacing});
  }
  const std::vector<double> amplitudes = harmonics_at(flow, places, 1, waves.period, waves.steps(), 4).front();
  Mean mean;
  for (const double a : amplitudes) mean.add(a);
  const auto [least, most] = std::ranges::minmax(amplitudes);
  return {mean.value() / amplitude, (most - least) / (most + least)};
}

/// Corners of a lattice of unit cells, moved at random.
struct Sheet {
  plan_lattice::Shape shape{12, 9};
  std::vector<double> x, y, z;

  explicit Sheet(double drift) {
    std::minstd_rand random(4);
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    for (std::size_t k = 0; k < shape.nodes(); ++k) {
      const std::size_t row = k / 13;
      x.push_back(static_cast<double>(k % 13) + uniform(random) + drift);
      y.push_back(static_cast<double>(row) + uniform(random) - 0.5 * drift);
      z.push_back(height({x.back(), y.back()}));
    }
  }
  static double height(Point at) { return 0.3 + 0.7 * at.x - 1.1 * at.y; }
};

TEST_CASE("a paddle generates the waves of theory and the layer absorbs them", "[evidence]") {
  Check check("laboratory_basin", "Waves in a laboratory basin",
              "A level channel 0.4572 m deep and 9 m long, with 6 to 18 m more in which waves are absorbed; waves of "
              "1, 2 and 3 s, so small that they are linear. Amplitude of the elevation over half a wavelength before "
              "the layer: its mean, and its variation, which measures the returning wave.",
              "validation/laboratory/wave_basin.hpp");
  for (const double period : {1.0, 2.0, 3.0}) {
    const Channel waves{.period = period, .spacing = 0.1};
    const Envelope found = envelope(waves);
    const std::string id = fmt::format("{:g}s", period);
    check.that("amplitude-" + id, "The wave amplitude agrees with linear theory of the model.",
               "amplitude over the stated one, minus 1", {.value = found.mean - 1, .resolution = "h = 0.1 m"},
               waves.bound());
    check.that("reflection-" + id, "The amplitude reflected by the absorbing layer is below the limit.",
               "amplitude of the returning wave over the amplitude of the incident one",
               {.value = found.reflected, .resolution = "h = 0.1 m"}, waves.bound());
  }
}

TEST_CASE("gauges read the surface where they stand while the grid moves", "[evidence]") {
  Check check("laboratory_gauges", "Gauges on a moving grid",
              "A plane surface over 12 x 9 cells off a square at random: bilinear patches hold it exactly. Gauges "
              "inside, on a node, on a side; the grid then drifts by 2.5 cells.",
              "bilinear maps hold planes");
  const Sheet before(0);
  const Sheet after(2.5);
  std::vector<Point> places{{before.x[30], before.y[30]},
                            {0.5 * (before.x[3] + before.x[4]), 0.5 * (before.y[3] + before.y[4])}};
  for (int k = 0; k < 8; ++k) places.push_back({3.1 + 0.7 * k, 1.2 + 0.61 * k});
  PlanGauges gauges(before.shape, places);
  Worst worst;
  const auto first = gauges.read({before.x, before.y, before.z});
  for (std::size_t k = 0; k < places.size(); ++k) worst.add(first[k] - Sheet::height(places[k]));
  const auto second = gauges.read({after.x, after.y, after.z});
  for (std::size_t k = 2; k < places.size(); ++k) worst.add(second[k] - Sheet::height(places[k]));
  check.that("plane", "Gauges read a plane surface exactly, on the grid before and after rezoning.", "largest error",
             {worst.value()}, Roundoff{40, 10, "forty roundings of positions up to 10"});
  PlanGauges outside(before.shape, {{-2, 4}, {20, 4}, {6, 12}});
  double numbers = 0;
  for (const double z : outside.read({before.x, before.y, before.z})) numbers += std::isnan(z) ? 0 : 1;
  check.from("validation/instruments/plan_gauges.hpp")
      .that("outside", "Gauges outside the water have no reading.", "gauges outside that read a number", {numbers},
            Bound{0, "none stands in the water"});
}

}  // namespace seiche::verification::laboratory_basin_test
