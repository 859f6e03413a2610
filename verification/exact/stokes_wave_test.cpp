#include "seiche/exact/stokes_wave.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "verification/check.hpp"
#include "verification/exact/wave_extremum.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::stokes_wave_test {

using namespace exact;

constexpr double wavelength = 2 * std::numbers::pi;
const std::string source =
    "Cokelet, Phil. Trans. R. Soc. A 286 (1977) 183; regression: digits computed once at two resolutions";

struct Column {
  std::string quantity;
  std::function<double(const StokesWave&)> computed;
  std::string printed;  ///< column of the reference
  Largest worst = {};
};

TEST_CASE("Stokes waves have every digit of the reference table", "[exact]") {
  Check check("exact_stokes_wave_table", "Exact Stokes waves: deep and finite depth",
              "Speed, Bernoulli's constant, impulse, energies, elevations and velocity at the crest of 27 waves "
              "against a table; 2 T = c I, the flux through the crest section and the mean velocity below the troughs, "
              "which need no outside data; a second resolution.",
              source);
  std::vector<Column> columns{{"phase speed", &StokesWave::phase_speed, "c"},
                              {"Bernoulli constant", &StokesWave::bernoulli_constant, "B"},
                              {"impulse", &StokesWave::impulse, "I"},
                              {"kinetic energy", &StokesWave::kinetic_energy, "T"},
                              {"potential energy", &StokesWave::potential_energy, "V"},
                              {"crest elevation", &StokesWave::crest_elevation, "eta_crest"},
                              {"trough elevation", &StokesWave::trough_elevation, "eta_trough"},
                              {"velocity at the crest", &StokesWave::crest_velocity, "u_crest"}};
  Largest identity;
  Worst depth, speed, elevation, velocity;
  const io::Table table = validation::reference_table("exact_stokes_waves", check.record().reference_data);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double amplitude = table.column("a")[row];
    const double conformal_depth = 1 / table.column("inverse_conformal_depth")[row];  // infinite in deep water
    const double mean_depth = table.column("mean_depth")[row];
    const auto wave = StokesWave::from_conformal_depth(amplitude, wavelength, conformal_depth, 1);
    // The reference solves the equation divided by 1/q^3: its rounding near the crest is eps/q^3; in the gentlest wave
    // its speed is known to eps/amplitude.
    const double reference =
        std::numeric_limits<double>::epsilon() * std::max(1 / std::pow(wave.crest_speed(), 3), 1 / amplitude);
    for (Column& column : columns) {
      const double printed = table.column(column.printed)[row];
      const double limit = 0.5e-14 + 5e-15 * std::abs(printed) + reference;
      column.worst.add(std::abs(column.computed(wave) - printed) / limit);
    }
    if (mean_depth > 0 && std::isfinite(mean_depth)) {
      depth.add(wave.mean_depth() - mean_depth);
      const StokesWave same(amplitude, wavelength, wave.mean_depth(), 1);
      depth.add(same.conformal_depth() - conformal_depth);
    } else if (std::isfinite(mean_depth)) {
      CHECK(std::isinf(wave.mean_depth()));
    }
    for (const auto& held : wave.self_test()) {
      INFO(held.name << " at a = " << amplitude << ", d = " << conformal_depth << ": " << held.defect);
      CHECK(held.defect <= held.accuracy);
      identity.add(held.defect);
    }
    const auto finer =
        StokesWave::from_conformal_depth(amplitude, wavelength, conformal_depth, 1, Resolution{1.25, 0.5});
    speed.add(wave.phase_speed() / finer.phase_speed() - 1);
    for (const double x : {0.0, 0.01, 0.3, 1.0, 2.5, 3.1}) {
      const double surface = wave.elevation(x);
      elevation.add(surface - finer.elevation(x));
      for (const double below : {0.45, 0.1, 1e-4}) {
        const auto a = wave.velocity(x, surface - below);
        const auto b = finer.velocity(x, surface - below);
        velocity.add(std::hypot(a.u - b.u, a.v - b.v) / std::max(1.0, 0.5 / wave.crest_speed()));
      }
    }
  }
  for (const Column& column : columns) {
    check.holds("The " + column.quantity + " of every wave has the digits of the table.", {column.worst.value()},
                Bound{1,
                      "half a unit of the 14th decimal, 5e-15 (agreement of the reference's two resolutions), and the "
                      "reference's rounding, eps/q^3 at the crest or eps/amplitude"});
  }
  check.that("depth", "Mean and conformal depth lead to each other to 14 decimals.", "largest difference of k depth",
             {depth.value()}, Bound{1e-14, "14 printed decimals and 20 roundings"});
  check.from("Longuet-Higgins, Proc. R. Soc. A 342 (1975) 157")
      .that("identities", "2 T = c I, the volume flux and the zero mean velocity hold.", "largest relative error",
            {identity.value()}, Bound{2e-14, "sums of 100 to 500 values known to 1e-15"});
  check.that("speed-resolution", "The speed is the same at two resolutions within 5e-15.",
             "largest relative difference of the speed", {speed.value()}, Bound{5e-15, "about 20 roundings of c^2"});
  const Bound pointwise{.limit = 1e-14, .reason = "45 roundings of numbers of order 1 (1/k, wave speed)"};
  check.that("elevation-resolution",
             "The surface, also between the nodes, is the same at two resolutions within 1e-14.",
             "largest difference of k elevation", {elevation.value()}, pointwise);
  check.that("velocity-resolution",
             "Velocities inside, down to 1e-4 below the surface, do not depend on the resolution.",
             "largest difference of the velocity over sqrt(g/k) max(1, 1/(2 q))", {velocity.value()},
             Bound{1e-14,
                   "45 roundings of numbers of order 1; under steep crests of q^2 = 2 (B - y)/c^2, a difference, which "
                   "divides them by 2 q"});
}

TEST_CASE("a gentle Stokes wave has the speed of Stokes's series", "[exact]") {
  Check check(
      "exact_stokes_wave_velocity", "Speed of a gentle Stokes wave",
      "The speed of a gentle wave against Stokes's series; velocities are symmetric about the crest; bad input.",
      source);
  const StokesWave wave(0.3, wavelength, StokesWave::deep, 1);
  const auto ahead = wave.velocity(1, -0.5);
  const auto behind = wave.velocity(wavelength - 1, -0.5);
  CHECK(std::abs(behind.u - ahead.u) < 1e-15);
  CHECK(std::abs(behind.v + ahead.v) < 1e-15);
  CHECK(ahead.v > 0);  // water rises ahead of the crest
  const double a = 0.01;
  check.from("Schwartz, J. Fluid Mech. 62 (1974) 553")
      .that("series", "The speed of a gentle deep wave agrees with Stokes's series.", "c^2 for k a = 0.01",
            {std::pow(StokesWave(a, wavelength, StokesWave::deep, 1).phase_speed(), 2)},
            Bound{2e-15, "10 roundings; the next term of the series is of order a^8 = 1e-16",
                  1 + a * a + std::pow(a, 4) / 2 + std::pow(a, 6) / 4});
  CHECK_NOTHROW(wave.velocity(0.7, wave.elevation(0.7)));
}

TEST_CASE("high Stokes waves in shallow water satisfy their identities", "[exact]") {
  Check check("exact_stokes_wave_shallow", "High Stokes waves in shallow water",
              "Crests as sharp as the water is shallow, k d = 0.2, up to 3 % below the limiting height.");
  for (const double amplitude : {0.2, 0.3, 0.35, 0.36}) {
    self_test_holds(check, fmt::format("a = {:g}", amplitude), StokesWave(amplitude, 5 * wavelength, 1, 1));
  }
}

TEST_CASE("deep Stokes waves are fastest below the limiting steepness", "[exact]") {
  Check check("exact_stokes_wave_maximum", "Stokes waves: the fastest and the limiting wave",
              "Speed against steepness with its maximum, and two almost limiting deep waves.", source);
  const auto speed = [](double a) { return StokesWave(a, wavelength, StokesWave::deep, 1).phase_speed(); };
  const auto [at, largest] = verification::wave_maximum(speed, 0.436, 0.0003);
  check.from("Longuet-Higgins, Proc. R. Soc. A 342 (1975) 157")
      .that("place", "The speed is largest at k a = 0.436.", "k amplitude of the maximum", {at},
            Bound{0.5e-3, "half a printed digit", 0.436});
  check.that("wave", "The maximum speed of the polynomial agrees with the wave solved there within 2e-13.",
             "relative difference", {largest / speed(at) - 1},
             Bound{2e-13,
                   "nine waves known to 1e-14, whose errors the polynomial sums, and its remainder, (spacing/0.007)^9 "
                   "of the bracketing variation, 1e-5: the singularity at the limiting wave is 0.007 away"});
  const StokesWave steep(0.443144051862, wavelength, StokesWave::deep, 1);
  const StokesWave finer(0.443144051862, wavelength, StokesWave::deep, 1, Resolution{1.25, 0.5});
  check.that("steep-resolution", "The speed of the steepest wave is the same at two resolutions within 5e-15.",
             "relative difference of the speed", {std::abs(steep.phase_speed() / finer.phase_speed() - 1)},
             Bound{5e-15, "about 20 roundings of c^2"});
  const auto limiting = StokesWave::from_crest_speed(0.0019, wavelength, StokesWave::deep, 1);
  check.from("Schwartz, J. Fluid Mech. 62 (1974) 553")
      .that("limiting-amplitude", "The almost limiting wave has k a = 0.44316.", "k amplitude", {limiting.amplitude()},
            Bound{0.5e-5, "half a printed digit", 0.44316});
  check.from("Longuet-Higgins, Proc. R. Soc. A 342 (1975) 157")
      .that("limiting-speed", "The almost limiting wave has c = 1.09228.", "c/sqrt(g/k)", {limiting.phase_speed()},
            Bound{1e-5, "one printed digit: 1.09228 and 1.0923 are in print", 1.09228});
  check.from("Longuet-Higgins & Fox, J. Fluid Mech. 80 (1977) 721")
      .that("limiting-slope", "The slope exceeds 30 degrees near the limiting wave.", "largest slope [deg]",
            {limiting.maximum_slope() * 180 / std::numbers::pi},
            Bound{1e-3, "one unit of the third decimal of the limit", 30.379});
  std::vector<double> steepness;
  for (double a = 0.02; a < 0.4431; a += a < 0.37 ? 0.05 : a < 0.439 ? 0.007 : 0.002) steepness.push_back(a);
  const auto series = [](double a) { return std::sqrt(1 + a * a + std::pow(a, 4) / 2); };
  auto& speed_panel = check
                          .figure("speed", "Speed of deep-water waves",
                                  "Phase speed against steepness with its maximum near 0.436, below the limiting "
                                  "0.4432; Stokes's fifth-order series for comparison.")
                          .panel({.x = "k amplitude", .y = "c / sqrt(g/k)"});
  speed_panel.line("exact", steepness, validation::each(steepness, speed), evidence::Role::exact);
  speed_panel.line("1 + a^2 + a^4/2", steepness, validation::each(steepness, series), evidence::Role::peer);
  speed_panel.vertical("largest speed", std::vector<double>{at});
}

}  // namespace seiche::verification::stokes_wave_test
