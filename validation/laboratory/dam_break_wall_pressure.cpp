/*
A dam break, of initial depth H = 0.3 m, runs over a dry floor and hits a wall 1.01 m away (Lobovsky and others 2014).
The pressure 0.015 m above the floor was recorded in about a hundred repeats.

**What is compared.** Impulse of the impact; the mean from T = 2.6 to 2.8, where repeats scatter least, by 4 %; the
plateau after it; and the rms difference from the median from T = 2.6 on (earlier, the pressure rises, and the band of
the repeats is one of time). Time counts from the instant at which the pressure first reaches 0.3, as in the source,
because a gate that opens in 0.1 s delays the impact. The uncertainty is the band of the repeats. The case accepts
external results, and the same claims score weakly compressible SPH in the longer tiers.

**Model set-up.** Water viscosity, 8.9e-7 m²/s, density diffusion, wall pressure extrapolated from the water, Wendland
kernel of $h = 2\,dx$. With `--set nu0=2e-4`, the eddy viscosity $\kappa u_* d/6$ of a boundary layer filling the depth
at the wall at $T = 3$, applied in the whole tank, the plateau falls to the measured one: a statement on that closure,
not on the model.

**What to look at.** The median of peaks at different times is lower than each of them; peaks are not scored. Average a
computed pressure over 5 ms and over the sensor's face of 4 mm. Shallow water without friction has the head $(u^2/2g +
d)/H$ = 0.99 to 0.79 at the wall for $T$ from 3.4 to 5.4; the measured value is 0.6.
*/
#include <cmath>
#include <utility>

#include "seiche/models/wcsph/scene.hpp"
#include "validation/instruments/particles/sph_wall_gauge.hpp"
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation::cases::dam_break_wall_pressure {

using namespace laboratory;

constexpr double gravity = 9.81;
constexpr double density = 997;
constexpr double height = 0.3;
constexpr double column = 0.6;
constexpr double tank = 1.61;
constexpr double wall = 0.6;
constexpr double sensor = 0.015;
constexpr double face = 0.004;
constexpr double averaged = 0.005;  // [s]
constexpr double gate = 0.57;       // 0.1 s, the time that it takes to go, in T

/// Means over `averaged` of a record, by the trapezoidal rule, every millisecond.
SubmittedGroup smoothed(const std::vector<double>& times, const std::vector<double>& pressures) {
  std::vector<double> impulse{0};
  for (std::size_t i = 1; i < times.size(); ++i) {
    impulse.push_back(impulse.back() + 0.5 * (times[i] - times[i - 1]) * (pressures[i] + pressures[i - 1]));
  }
  const Curve sum{times, impulse};
  const double half = 0.5 * averaged;
  SubmittedGroup record;
  for (double t = half; t + half <= times.back(); t += 1e-3) {
    record.abscissa.push_back(t * std::sqrt(gravity / height));
    record.values["p"].push_back((linear_at(sum, t + half) - linear_at(sum, t - half)) /
                                 (averaged * density * gravity * height));
  }
  return record;
}

Submitted compute(const Run& run, double coarsening) {
  const double spacing = coarsening * run.real("dx");
  const wcsph::Settings settings = sph_settings(run, gravity, density, std::sqrt(gravity * height));
  wcsph::Scene scene = wcsph::dam_break(
      {.width = column, .height = height, .tank_length = tank + spacing, .wall_height = wall, .spacing = spacing},
      settings);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, settings);
  const wcsph::WallGauge gauge{.x = scene.far_wall, .z = sensor, .diameter = face};
  std::vector<double> times{0};
  std::vector<double> pressures{0};
  march(
      flow, 6.1 * std::sqrt(height / gravity), [&](double) { return flow.stable_step(); },
      [&] {
        times.push_back(flow.time());
        pressures.push_back(wcsph::pressure_on(gauge, flow));
      });
  return {{"pressure", {smoothed(times, pressures)}}};
}

Experiment experiment(const Values& values) {
  return {.source =
              "L. Lobovsky, E. Botia-Vera, F. Castellana, J. Mas-Soler, A. Souto-Iglesias, J. Fluids Struct. 48 (2014) "
              "407-434",
          .parts = {{.name = "pressure",
                     .table = "lobovsky_2014_dam_break_pressure",
                     .abscissa = {"T", "1", "time t sqrt(g/H) since the gate starts"},
                     .quantity = {"p", "1", "pressure over rho g H on the wall"},
                     .band = {"p_low", "p_high"},
                     .clock = Clock{.range = gate, .by = arrival(0, 0.3, {1.9, 4.0})},
                     .readings = {impulse(0, {2.46, 4.0}), mean(0, {2.6, 2.8}, Kind::pressure),
                                  mean(0, {3.4, 5.4}, Kind::pressure), misfit(0, {2.6, 5.5})}}},
          .compute = values.tier() == Tier::quick ? nullptr : compute,  // what it has time for decides nothing
          .model = "weakly compressible SPH",
          .order = 1,
          .coarsenings = {1, 1.5, 2},
          .miss =
              "cause unknown: the computed head belongs to shallow water without friction, 0.8 to 1, compared with 0.6 "
              "measured"};
}

void dam_break_wall_pressure(Case& c) {
  c.tiers = {Tier::quick, Tier::full};
  set_laboratory<experiment>(c, "Pressure of a dam break on a wall, with repeats",
                             with({real("dx", {0.005, 0.005, 0.0025}, "m", {0.001, 0.02},
                                        "particle spacing, for the model run; also 1.5 and 2 times that")},
                                  sph_parameters({.kernel = std::string("wendland_c2"),
                                                  .smoothing = 2.0,
                                                  .viscosity = "laminar",
                                                  .kinematic_viscosity = 8.9e-7,
                                                  .xsph = 0,
                                                  .sound = 15,
                                                  .walls = "extrapolated",
                                                  .diffusion = 0.1,
                                                  .courant = 0.25},
                                                 "sqrt(g times the height of the column)")));
}

}  // namespace seiche::validation::cases::dam_break_wall_pressure
