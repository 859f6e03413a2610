// Sound in weakly compressible SPH: its exact numerical dispersion, and the growth and phase of the midpoint rule.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "verification/check.hpp"
#include "verification/lattice_sums.hpp"
#include "verification/refinement.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_acoustics_test {

using namespace wcsph;

constexpr double sound_speed = 10;
constexpr std::size_t rows_of_lattice = 16;
const std::string source =
    "linearisation on the lattice: omega = c_0 |S(k)|; explicit midpoint rule: G = 1 + i omega dt - (omega dt)^2/2";

/// S(k)/k; dx = 1.
double symbol(KernelName kernel, double smoothing, double k) {
  const auto sums = kernel == KernelName::cubic_spline ? lattice_sums<CubicSpline> : lattice_sums<WendlandC2>;
  return sums(smoothing, Arrangement::square, k).symbol / k;
}

struct Wave {
  std::size_t cells;  ///< N per unit length
  int mode;
  KernelName kernel = KernelName::cubic_spline;
  double smoothing = 1.3;

  [[nodiscard]] double wavenumber() const { return 2 * std::numbers::pi * mode; }
  /// omega/(c_0 k) of the equations in continuous time.
  [[nodiscard]] double dispersion() const {
    return symbol(kernel, smoothing, wavenumber() / static_cast<double>(cells));
  }
  [[nodiscard]] double frequency() const { return sound_speed * wavenumber() * dispersion(); }
  [[nodiscard]] double acoustic_step() const { return 0.3 * smoothing / static_cast<double>(cells) / sound_speed; }
};

struct Outcome {
  double frequency, energy_growth;  ///< over c_0 k; relative
};

constexpr double amplitude = 1e-4;

/// What the second harmonic does to a wave up to a time, relative: it is driven with the rate (gamma + 1)/4 M c_0 k =
/// 2 M c_0 k, of which a standing wave, two waves of half its amplitude, has half, and falls out of step with it by
/// D = 2 omega(k) - omega(2k).
struct Harmonic {
  double shift;   ///< bound of the change of the frequency
  double energy;  ///< mean part of the energy
};
Harmonic harmonic_of(const Wave& wave, double time) {
  Wave second = wave;
  second.mode *= 2;
  const double detuning = 2 * std::abs(wave.dispersion() - second.dispersion());  // D/(c_0 k)
  const double rate = 2 * amplitude / sound_speed;
  const double angle = detuning * sound_speed * wave.wavenumber() * time;
  const double rest = 1 - std::sin(angle) / angle;  // mean of 1 - cos D t
  return {rate * rate * (1 + rest / detuning), 2 * rate * rate * rest / (detuning * detuning)};
}

/// A standing wave u = 1e-4 sin(kx) on a lattice without viscosity; steps of one length.
Outcome run(const Wave& wave, double step, long steps) {
  const double dx = 1 / static_cast<double>(wave.cells), k = wave.wavenumber();
  Particles particles = lattice(wave.cells, rows_of_lattice, dx, 1);
  for (std::size_t a = 0; a < particles.size(); ++a) particles.u[a] = amplitude * std::sin(k * particles.x[a]);
  const std::vector<double> place = particles.x;
  Flow flow(particles, dx,
            {.kernel = wave.kernel,
             .smoothing = wave.smoothing,
             .gravity = 0,
             .density = 1,
             .sound_speed = sound_speed,
             .viscosity = Inviscid{},
             .xsph = 0,
             .period = {1, rows_of_lattice * dx}});
  // Velocity and scaled density of the mode turn about each other: y' = omega a, a' = -omega y.
  const auto angle = [&] {
    double velocity = 0, density = 0;
    const Particles& p = flow.particles();
    for (std::size_t a = 0; a < p.size(); ++a) {
      const double x = place[static_cast<std::size_t>(p.identity[a])];
      velocity += p.u[a] * std::sin(k * x);
      density += (1 - p.density[a]) * sound_speed * std::cos(k * x);
    }
    return std::atan2(density, velocity);
  };
  const double energy = flow.totals().kinetic + flow.totals().elastic;
  double phase = 0, last = angle();
  for (long n = 0; n < steps; ++n) {
    flow.advance(step);
    const double now = angle();
    phase += std::remainder(now - last, 2 * std::numbers::pi);
    last = now;
  }
  const double time = step * static_cast<double>(steps);
  return {std::abs(phase) / time / (sound_speed * k), (flow.totals().kinetic + flow.totals().elastic) / energy - 1};
}

/// Angle by which the midpoint rule turns a mode in one step, and the factor of its energy.
double turn(double angle) {
  return std::atan2(angle, 1 - 0.5 * angle * angle);
}
double amplification(double angle) {
  return 1 + 0.25 * std::pow(angle, 4);
}

TEST_CASE("sound has the dispersion of the lattice and grows by the law of the midpoint rule", "[dispersion]") {
  Check check(
      "wcsph_acoustics", "Standing sound waves: exact numerical dispersion",
      "$u = 10^{-4}\\sin kx$ on a square lattice in a periodic box, no viscosity, no smoothed motion. In continuous "
      "time the frequency is exactly $\\omega = c_0|S(k)|$, $S = \\sum V \\sin(k x)\\,\\partial W/\\partial x$ over "
      "the lattice. The midpoint rule turns the mode by $\\mathrm{atan2}(\\omega\\Delta t, 1 - (\\omega\\Delta "
      "t)^2/2)$ per step, $\\omega\\Delta t$ and a third-order term $(\\omega\\Delta t)^3/6$, and multiplies its "
      "energy by $1 + (\\omega\\Delta t)^4/4$: without dissipation sound grows at any step.");
  const std::vector<Wave> waves{{32, 1}, {64, 1}, {128, 1}, {64, 1, KernelName::wendland_c2, 2.0}, {64, 4}, {64, 8}};
  std::vector<double> k_cubic, cubic, k_wendland, wendland;
  for (const Wave& wave : waves) {
    const std::string name = fmt::format("{}-{}-{}", name_of(wave.kernel), wave.cells, wave.mode);
    const double step = wave.acoustic_step();
    const long steps = std::lround(0.5 / step);
    const Outcome found = run(wave, step, steps);
    const double angle = wave.frequency() * step, expected = wave.dispersion() * turn(angle) / angle;
    const double growth = std::pow(amplification(angle), static_cast<double>(steps)) - 1;
    const Harmonic harmonic = harmonic_of(wave, step * static_cast<double>(steps));
    const double rounding = 4 * 0x1p-52 *
                            std::sqrt(static_cast<double>(steps) / static_cast<double>(wave.cells * rows_of_lattice)) *
                            sound_speed / amplitude;
    check.holds("frequency-" + name + ": The frequency agrees with the particle arrangement and the midpoint rule.",
                {found.frequency},
                Bound{harmonic.shift,
                      "(2 M)^2 [1 + mean of c_0 k (1 - cos D t)/D], M = 1e-5: the mode and its second harmonic, (gamma "
                      "+ 1)/4 M k c_0 t of it, out of tune by D = 2 omega(k) - omega(2k)",
                      expected, true});
    check.holds("growth-" + name + ": The energy grows by the law of the midpoint rule.", {found.energy_growth},
                Bound{15 * harmonic.energy + rounding / growth,
                      "the second harmonic has the part (2 M)^2 2 (1 - cos D t) (c_0 k/D)^2 of the energy, M = 1e-5, "
                      "and grows 16 times as fast; densities of 1 are rounded by steps, 4 eps sqrt(steps), over an "
                      "amplitude of 1e-5 of each particle",
                      growth, true});
    const bool spline = wave.kernel == KernelName::cubic_spline;
    (spline ? k_cubic : k_wendland).push_back(static_cast<double>(wave.mode) / static_cast<double>(wave.cells));
    (spline ? cubic : wendland).push_back(found.frequency * angle / turn(angle));
  }

  auto& panel = check
                    .figure("dispersion", "Numerical dispersion of sound",
                            "Frequency over the frequency of sound, with the error of the steps taken off. Lines: sums "
                            "over the lattice. The limit of long waves is not 1.")
                    .panel({.x = "dx/wavelength", .y = "omega/(c_0 k)"});
  std::vector<double> parts, spline_curve, wendland_curve;
  for (double part = 0.002; part < 0.2; part += 0.002) {
    const double k = 2 * std::numbers::pi * part;
    parts.push_back(part);
    spline_curve.push_back(symbol(KernelName::cubic_spline, 1.3, k));
    wendland_curve.push_back(symbol(KernelName::wendland_c2, 2, k));
  }
  panel.line("cubic spline, h = 1.3 dx", parts, spline_curve, Role::exact);
  panel.line("Wendland, h = 2 dx", parts, wendland_curve, Role::guide);
  panel.points("measured, cubic spline", k_cubic, cubic);
  panel.points("measured, Wendland", k_wendland, wendland, Role::peer);
}

TEST_CASE("the midpoint rule is second-order accurate in phase and third-order accurate in energy", "[dispersion]") {
  Check check("wcsph_time_order", "Orders of the steps",
              "The sound wave of N = 32, mode 2, with steps of 0.4, 0.2, 0.1 and 0.05 h/c_0 to the same time.", source);
  const Wave wave{32, 2};
  const double first = wave.acoustic_step() * 4 / 3;
  const long fewest = std::lround(0.5 / first);
  refine(check, {"dt [s]", falling(first, 4)},
         {{"phase",
           "The phase error is second-order in the step.",
           {2, 0.05, "next term (omega dt)^2/8 relative, 0.004 at the longest step"}},
          {"energy",
           "The energy error is third-order in the step.",
           {3, 0.0005,
            "the energy grows by the factor 1 + (omega dt)^4/4 per step: next term of its logarithm (omega dt)^4/8 "
            "relative, 2e-4 at the longest step, 3e-4 per halving"}}},
         [&](double step) {
           const Outcome found = run(wave, step, fewest * std::lround(first / step));
           return std::array{std::abs(found.frequency / wave.dispersion() - 1), std::log1p(found.energy_growth)};
         });
}

}  // namespace seiche::verification::wcsph_acoustics_test
