#include "seiche/exact/solitary_wave.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "verification/check.hpp"
#include "verification/difference.hpp"
#include "verification/exact/wave_extremum.hpp"

namespace seiche::verification::solitary_wave_test {

using namespace exact;
using validation::each;

constexpr double degree = std::numbers::pi / 180;
const std::string source =
    "Longuet-Higgins & Fenton, Proc. R. Soc. A 340 (1974) 471; Hunter & Vanden-Broeck, J. Fluid Mech. 136 (1983) 63; "
    "regression: digits computed once at two resolutions";

/// Distance from the printed value over what printing and the reference's own uncertainty allow.
double excess(double value, double printed, int decimals, double relative) {
  return std::abs(value - printed) / (0.5 * std::pow(10.0, -decimals) + relative * std::abs(printed));
}

struct Column {
  std::string quantity;
  int decimals;
  double relative;
  std::function<double(const SolitaryWave&)> computed;
  std::string printed;  ///< column of the reference
  Largest worst = {};
};

TEST_CASE("solitary waves have every digit of the reference table", "[exact]") {
  Check check(
      "exact_solitary_wave_table", "Exact solitary wave: 21 amplitudes",
      "Speed, crest speed, mass, energies, circulation, velocity at the crest and half-width of waves of amplitude "
      "0.02 to 0.83 against a table; the integral identities 2 T = F (I - C) and 3 V = (F^2 - 1) M (Longuet-Higgins "
      "1974), which need no outside data; and a second resolution, because identities alone under-report the error.",
      source);
  std::vector<Column> columns{{"Froude number", 14, 5e-15, &SolitaryWave::froude, "F"},
                              {"speed at the crest", 14, 2e-13, &SolitaryWave::crest_speed, "q_crest"},
                              {"mass", 13, 2e-13, &SolitaryWave::mass, "M"},
                              {"kinetic energy", 14, 2e-13, &SolitaryWave::kinetic_energy, "T"},
                              {"potential energy", 14, 2e-13, &SolitaryWave::potential_energy, "V"},
                              {"circulation", 13, 2e-13, &SolitaryWave::circulation, "C"},
                              {"velocity at the crest", 14, 2e-13, &SolitaryWave::crest_velocity, "u_crest"},
                              {"half-width", 12, 2e-13, &SolitaryWave::half_width, "x_half"}};
  Largest kinetic, potential;
  Worst speed, velocity, elevation;
  const io::Table table = validation::reference_table("exact_solitary_waves", check.record().reference_data);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double amplitude = table.column("a")[row];
    const SolitaryWave wave(amplitude);
    // A long wave balances up to the square of its amplitude: in double precision, with about 1300 nodes at 0.02.
    const double reference = std::sqrt(1300.0) * std::numeric_limits<double>::epsilon() / amplitude;
    for (Column& column : columns) {
      const double relative = column.printed == "F" ? column.relative : std::max(column.relative, reference);
      column.worst.add(excess(column.computed(wave), table.column(column.printed)[row], column.decimals, relative));
    }
    const auto identities = wave.self_test();
    kinetic.add(identities[0].defect);
    potential.add(identities[1].defect);
    for (const auto& identity : identities) {
      INFO(identity.name << " at " << amplitude << ": " << identity.defect);
      CHECK(identity.defect <= identity.accuracy);
    }
    // Every third wave and the steep ones.
    if (row % 3 != 0 && amplitude < 0.8) continue;
    const SolitaryWave finer(amplitude, 1, 1, Resolution{1.2, 0.5});
    speed.add(wave.froude() / finer.froude() - 1);
    for (const double x : {0.0, 0.01, 0.3, 1.0, 2.0, 4.0}) {
      const double surface = wave.elevation(x);
      elevation.add(surface - finer.elevation(x));
      for (const double depth : {1.0, 0.5, 0.01, 1e-6}) {
        const double y = surface - depth * (1 + surface);
        const auto a = wave.velocity(x, y);
        const auto b = finer.velocity(x, y);
        velocity.add(std::hypot(a.u - b.u, a.v - b.v));
      }
    }
  }
  for (const Column& column : columns) {
    check.holds(
        "The " + column.quantity + " of every wave has the digits of the table.", {column.worst.value()},
        Bound{1,
              "half a unit of the last printed digit plus the agreement of the reference's two resolutions, 5e-15 of "
              "the speed and 2e-13 of the others, or its rounding in long waves, 36 eps/amplitude (4e-13 at 0.02)"});
  }
  const Bound identity{.limit = 5e-14, .reason = "500 terms of values known to 1e-15, amplified by 1/amplitude"};
  check.from("Longuet-Higgins, Proc. R. Soc. A 337 (1974) 1")
      .that("kinetic-identity", "2 T = F (I - C) holds at every amplitude.", "largest relative error",
            {kinetic.value()}, identity);
  check.from("Longuet-Higgins, Proc. R. Soc. A 337 (1974) 1")
      .that("potential-identity", "3 V = (F^2 - 1) M holds at every amplitude.", "largest relative error",
            {potential.value()}, identity);
  check.that("speed-resolution", "The speed is the same at two resolutions within 5e-15.",
             "largest relative difference of the speed", {speed.value()}, Bound{5e-15, "about 20 roundings of F^2"});
  const Bound pointwise{.limit = 1e-14, .reason = "45 roundings of numbers of order 1 (depth, wave speed)"};
  check.that("elevation-resolution",
             "The surface, also between the nodes, is the same at two resolutions within 1e-14.",
             "largest difference of the elevation over the depth", {elevation.value()}, pointwise);
  check.that("velocity-resolution",
             "Velocities inside, down to 1e-6 below the surface, do not depend on the resolution.",
             "largest difference of the velocity over sqrt(g h)", {velocity.value()}, pointwise);
}

TEST_CASE("the surface of a solitary wave has the slope that it states", "[exact]") {
  Check check("exact_solitary_wave_velocity", "Slope of the exact solitary wave",
              "The slope of the surface against its differences; velocities are symmetric about the crest.", source);
  const SolitaryWave gentle(0.3);
  const SolitaryWave steep(0.5);
  for (const double y : {-0.5, -0.3}) {
    const auto ahead = steep.velocity(1.5, y);
    const auto behind = steep.velocity(-1.5, y);
    CHECK((behind.u == ahead.u && behind.v == -ahead.v && ahead.v > 0));  // water rises ahead of the crest
  }
  Largest slope;
  for (double x = 0.2; x < 1.6; x += 0.001) {
    slope.add(-difference([&](double d) { return steep.elevation(x + d); }, 4e-3));
  }
  check.that("slope", "The maximum slope agrees with the differences of the surface every 0.001.",
             "difference of the slope angles [rad]", {steep.maximum_slope() - std::atan(slope.value())},
             Bound{1.3e-7, "samples every 0.001 miss a maximum of curvature of order 1 by 0.0005^2/2"});
  CHECK_NOTHROW(gentle.velocity(0.7, gentle.elevation(0.7)));
}

TEST_CASE("speed, mass and energy of solitary waves are largest below the limiting height", "[exact]") {
  Check check("exact_solitary_wave_maxima", "Solitary waves: maxima of speed, mass and energy",
              "Speed, mass and kinetic energy along the family, their maxima by a polynomial through nine waves, and "
              "the wave whose crest moves at 0.99961 of the wave's speed.",
              source);
  struct Maximum {
    std::string id, quantity;
    double (SolitaryWave::*value)() const;
    double at;
  };
  double largest_speed = 0, fastest = 0;
  for (const Maximum& maximum : {Maximum{"speed", "speed", &SolitaryWave::froude, 0.795908},
                                 Maximum{"mass", "mass", &SolitaryWave::mass, 0.738847},
                                 Maximum{"energy", "kinetic energy", &SolitaryWave::kinetic_energy, 0.782694}}) {
    const auto of = [&](double amplitude) { return (SolitaryWave(amplitude).*maximum.value)(); };
    const auto [at, largest] = verification::wave_maximum(of, std::round(1000 * maximum.at) / 1000, 0.001);
    check.holds("The " + maximum.quantity + " is largest at this amplitude.", {at},
                Bound{1e-6, "one unit of the last printed digit", maximum.at});
    check.holds(
        "The polynomial's largest " + maximum.quantity + " agrees with the wave solved there.", {largest / of(at) - 1},
        Bound{2e-13,
              "nine waves known to 1e-14, whose errors the polynomial sums, and its remainder, (spacing/0.04)^9 of the "
              "bracketing variation, 1e-4: the singularity at the limiting wave is 0.037 away"});
    if (maximum.id != "speed") continue;
    fastest = at;
    largest_speed = largest;
  }
  check.that("speed-value", "The largest speed is 1.294211 sqrt(g h).", "Froude number", {largest_speed},
             Bound{0.5e-6, "half a unit of the last printed digit", 1.294211});
  const auto limiting = SolitaryWave::from_crest_speed(3.9e-4);
  const auto digits = [&](const std::string& quantity, double value, double printed, double limit) {
    check.holds("The almost limiting wave has the printed " + quantity + ".", {value},
                Bound{limit,
                      "one unit of the last digit; the crest speed 3.9e-4 is printed to two digits, which moves the "
                      "amplitude by F^2 q dq = 3e-9 and the others by less than their printed digits",
                      printed});
  };
  digits("amplitude", limiting.amplitude(), 0.83319895782988, 3.3e-9);
  digits("Froude number", limiting.froude(), 1.29089045589427, 1e-10);
  digits("mass", limiting.mass(), 1.970320660265, 1e-10);
  digits("kinetic energy", limiting.kinetic_energy(), 0.535008836079, 1e-10);
  digits("potential energy", limiting.potential_energy(), 0.437672693526, 1e-10);
  check.from("Byatt-Smith & Longuet-Higgins, Proc. R. Soc. A 350 (1976) 175")
      .that("limiting-slope", "The slope exceeds 30 degrees near the limiting wave.", "largest slope [deg]",
            {limiting.maximum_slope() / degree}, Bound{1e-3, "30.379 is printed for the limit", 30.379});

  std::vector<SolitaryWave> waves;
  for (double a = 0.03; a < 0.8331; a += a < 0.69 ? 0.1 : 0.02) waves.emplace_back(a);
  const std::vector<double> amplitudes = each(waves, &SolitaryWave::amplitude);
  auto& family = check.figure("family", "Family of solitary waves",
                              "Speed, mass and kinetic energy against the height. All three fall before the limiting "
                              "wave, 0.8332 high: two waves share a speed, the crest loses mass faster than it rises.");
  auto& speed_panel = family.panel({.x = "amplitude / depth", .y = "speed / sqrt(g h)"});
  speed_panel.line("F", amplitudes, each(waves, &SolitaryWave::froude), evidence::Role::exact);
  speed_panel.vertical("largest speed", std::vector<double>{fastest});
  auto& mass_panel = family.panel({.x = "amplitude / depth", .y = "mass, kinetic energy"});
  mass_panel.line("mass M", amplitudes, each(waves, &SolitaryWave::mass), evidence::Role::exact);
  mass_panel.line("kinetic energy T", amplitudes, each(waves, &SolitaryWave::kinetic_energy), evidence::Role::peer);
}

}  // namespace seiche::verification::solitary_wave_test
