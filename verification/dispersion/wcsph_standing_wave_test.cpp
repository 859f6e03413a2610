// A standing gravity wave of small amplitude in weakly compressible SPH, against linear theory.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_standing_wave_test {

using namespace wcsph;

constexpr double gravity = 9.81;
constexpr double k = 2 * std::numbers::pi;  // one wave in a period of 1 m

/// A tank of periodic sides, 1 m long.
struct Layer {
  double depth = 0.5;        // [m]
  std::size_t columns = 40;  // of particles
  double crest = 0.02;       // amplitude of the wave [m]

  [[nodiscard]] double omega() const { return std::sqrt(gravity * k * std::tanh(k * depth)); }
};

struct Oscillation {
  std::vector<double> time, amplitude;

  [[nodiscard]] std::vector<double> zeros() const {
    std::vector<double> found;
    for (std::size_t n = 1; n < time.size(); ++n) {
      const double before = amplitude[n - 1], after = amplitude[n];
      if ((before < 0) != (after < 0)) {
        found.push_back(time[n - 1] + (time[n] - time[n - 1]) * before / (before - after));
      }
    }
    return found;
  }
  /// From the times between zeros, by least squares.
  [[nodiscard]] double frequency() const {
    const std::vector<double> t = zeros();
    const double middle = 0.5 * static_cast<double>(t.size() - 1);
    double numerator = 0, denominator = 0;
    for (std::size_t n = 0; n < t.size(); ++n) {
      const double offset = static_cast<double>(n) - middle;
      numerator += offset * t[n];
      denominator += offset * offset;
    }
    return std::numbers::pi * denominator / numerator;
  }
};

/// Three and a quarter periods from the velocities of linear theory on a level surface, where the lattice is regular
/// and the pressure hydrostatic. Amplitude: velocities projected on those of the wave, over omega; displacements would
/// see particles that change their places in the lattice too.
Oscillation run(KernelName kernel, double smoothing, double xsph, const Layer& layer) {
  const double omega = layer.omega(), depth = layer.depth;
  const auto mode = [depth](double x, double z) {
    const double scale = 1 / std::sinh(k * depth);
    return Velocity{-scale * std::cosh(k * z) * std::sin(k * x), scale * std::sinh(k * z) * std::cos(k * x)};
  };
  Settings settings{.kernel = kernel,
                    .smoothing = smoothing,
                    .gravity = gravity,
                    .sound_speed = sound_speed_for(gravity, depth),
                    .viscosity = ArtificialViscosity{0.02},
                    .xsph = xsph};
  const auto velocity = [&](double x, double z) {
    const auto [u, w] = mode(x, z);
    return Velocity{layer.crest * omega * u, layer.crest * omega * w};
  };
  const Scene scene = periodic_layer(
      {.period = 1, .depth = depth, .velocity = velocity, .spacing = 1 / static_cast<double>(layer.columns)}, settings);
  settings.period = scene.period;
  Flow flow(scene.particles, scene.spacing, settings);
  Oscillation oscillation{};
  const auto record = [&] {
    const Particles& p = flow.particles();
    double sum = 0, norm = 0;
    for (std::size_t a = 0; a < p.size(); ++a) {
      if (p.kind[a] != Kind::fluid) continue;
      const auto [u, w] = mode(p.x[a], p.z[a]);
      sum += p.u[a] * u + p.w[a] * w;
      norm += u * u + w * w;
    }
    oscillation.time.push_back(flow.time());
    oscillation.amplitude.push_back(sum / norm / omega);
  };
  record();
  march(
      flow, 3.25 * 2 * std::numbers::pi / omega, [&](double) { return flow.stable_step(); }, record);
  return oscillation;
}

struct Row {
  std::string name;
  KernelName kernel;
  double smoothing, xsph, limit;
  Layer layer = {};
};

void judge(Check& check, const std::vector<Row>& rows, const std::string& reason) {
  auto& panel =
      check.figure("oscillation", "Standing wave", "Velocities of the particles projected on the wave's, over omega.")
          .panel({.x = "t [s]", .y = "amplitude [m]"});
  const std::vector<Role> roles{Role::computed, Role::peer, Role::data, Role::guide};
  std::size_t lines = 0;
  for (const Row& row : rows) {
    const Oscillation found = run(row.kernel, row.smoothing, row.xsph, row.layer);
    check.holds(fmt::format("The wave has the frequency of linear theory ({}).", row.name),
                {found.frequency() / row.layer.omega()}, Bound{row.limit, reason, 1});
    panel.line(row.name, found.time, found.amplitude, roles[lines++ % 4]);
  }
  std::vector<double> t, exact;
  const Layer& first = rows.front().layer;
  for (double time = 0; time < 3.25 * 2 * std::numbers::pi / first.omega(); time += 0.01) {
    t.push_back(time);
    exact.push_back(first.crest * std::cos(first.omega() * time));
  }
  panel.line("linear theory, no damping", t, exact, Role::exact);
}

void judge_narrow(const std::vector<Row>& rows) {
  Check check("wcsph_standing_wave_narrow", "Standing wave, cubic spline with h = 1.3 dx",
              "Wave of length 1 m and amplitude 0.02 m on 0.5 m of water between periodic sides, over dynamic wall "
              "particles, $\\alpha = 0.02$, three periods from a level surface. With 20 neighbours the square lattice "
              "under hydrostatic pressure is a little stiff against shear: the frequency is 2 to 4 % too high for any "
              "amplitude, spacing, depth and sound speed; the excess vanishes from $h = 1.5$ dx on.");
  judge(check, rows, "stiffness of the lattice with 20 neighbours");
}

TEST_CASE("a standing wave with a narrow cubic spline has the frequency of linear theory within 4 %", "[dispersion]") {
  judge_narrow({{"h = 1.3 dx", KernelName::cubic_spline, 1.3, 0.5, 0.04},
                {"h = 1.3 dx, no smoothed motion", KernelName::cubic_spline, 1.3, 0, 0.04},
                {"h = 1.3 dx, depth 0.2 m", KernelName::cubic_spline, 1.3, 0.5, 0.04, {.depth = 0.2}}});
}

TEST_CASE("a standing wave with a narrow cubic spline has the same frequency on a finer lattice",
          "[dispersion][full]") {
  judge_narrow({{"h = 1.3 dx, 80 columns", KernelName::cubic_spline, 1.3, 0.5, 0.04, {.columns = 80}}});
}

TEST_CASE("a standing wave with a wide kernel has the frequency of linear theory within 1.5 %", "[dispersion][full]") {
  Check check("wcsph_standing_wave_wide", "Standing wave, wider kernels",
              "The same with $h \\ge 1.5$ dx: the remaining effects are the amplitude, $(ka)^2/8 = 0.2\\,\\%$ for "
              "standing waves, and the walls' gap of a fraction of h.");
  judge(check,
        {{"cubic spline, h = 1.5 dx", KernelName::cubic_spline, 1.5, 0.5, 0.015},
         {"cubic spline, h = 2 dx", KernelName::cubic_spline, 2.0, 0.5, 0.015},
         {"Wendland, h = 2 dx", KernelName::wendland_c2, 2.0, 0.5, 0.015}},
        "20 layers: amplitude 0.2 %, elevation of the effective bottom by a part of dx, which tanh kH hides, and the "
        "kernel's error of the first derivative of 0.1 to 0.7 %");
}

}  // namespace seiche::verification::wcsph_standing_wave_test
