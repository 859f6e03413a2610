#include "validation/run_up/mild_slopes.hpp"

#include <cmath>
#include <string>

#include "seiche/exact/solitary_runup.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/mesh_climb.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation {
namespace {

constexpr double seen_height = 1e-3;  // of the wave's height, at the wall and at the toe

std::vector<double> euler_on_meshes(double cot_slope, double amplitude) {
  const double reach = SolitaryClimb{.cot_slope = cot_slope, .amplitude = amplitude}.reach(seen_height);
  std::vector<double> runup;
  for (const long refinement : {1, 2, 4}) {
    const double spacing = 0.5 / static_cast<double>(refinement);
    runup.push_back(climb_on_mesh({.wave = exact::SolitaryWave(amplitude),
                                   .tan_slope = 1 / cot_slope,
                                   .spacing = spacing,
                                   .rows = 4 * refinement,
                                   .tau = 0.1 * spacing,
                                   .crest = reach,
                                   .toe = std::ceil(2 * reach)})
                        .runup());
  }
  return runup;
}

}  // namespace

std::vector<EulerRunup> euler_runups(const std::vector<MeasuredWave>& waves) {
  std::vector<EulerRunup> all;
  for (const MeasuredWave& wave : waves) {
    if (!exact::SolitaryRunup(1, 1, wave.amplitude, wave.cot_slope).nonbreaking()) continue;
    const std::vector<double> r = euler_on_meshes(wave.cot_slope, wave.amplitude);
    const double coarser = 2 * r[1] - r[0];
    const double finest = 2 * r[2] - r[1];
    all.push_back({wave, finest, std::abs(finest - coarser)});
  }
  return all;
}

std::vector<LowWave> small_waves(const Values& values, double spacing) {
  std::vector<LowWave> all;
  for (const double cot_slope : {10.0, 3.732, 2.747}) {
    SolitaryClimb climb = climb_from(values, cot_slope, LowWave::amplitude, spacing);
    climb.tip_mass = dispersive::TipMass::consistent;
    const auto with = [&](dispersive::Kinetics kinetics) {
      climb.kinetics = kinetics;
      return run_up(climb).height;
    };
    all.push_back({.cot_slope = cot_slope,
                   .frank = with(dispersive::Kinetics::frank),
                   .green_naghdi = with(dispersive::Kinetics::green_naghdi),
                   .exact = exact::SolitaryRunup(1, 1, LowWave::amplitude, cot_slope).highest().elevation});
  }
  return all;
}

void claim_mild_slopes(const Claims<MildSlopes>& claims) {
  claims.from("Synolakis (1987)")
      .check(
          "small-waves",
          "The run-up of small waves agrees with the exact shallow-water solution, with either kinetic energy, on "
          "slopes 1:10, 1:3.732 and 1:2.747.",
          "largest |R/R_exact - 1|, A = 0.005",
          [](const MildSlopes& r) {
            Worst off;
            for (const LowWave& wave : r.small) {
              off.add(wave.frank / wave.exact - 1, wave.cot_slope);
              off.add(wave.green_naghdi / wave.exact - 1, wave.cot_slope);
            }
            return off;
          },
          Bound{.limit = LowWave::amplitude,
                .reason = "the incident wave of the theory, sech^2 at the speed sqrt(g d), and its lack of dispersion "
                          "are errors of the order of A"});
  const auto meshes = claims.at("mesh: h1 = 0.5, 0.25, 0.125, extrapolated; finest spacing, tip V/6");
  meshes.from("Frank (1994), section 2.2")
      .check(
          "mild-euler",
          "The run-up of non-breaking waves with the Green-Naghdi kinetic energy agrees with the Euler equations on "
          "slopes milder than 1:2.",
          "rms of R/R_Euler - 1",
          [](const MildSlopes& r) -> Measurement {
            const auto off =
                over<Mean>(r.euler, [](const EulerRunup& one) { return one.green_naghdi / one.runup - 1; });
            const auto uncertain =
                over<Mean>(r.euler, [](const EulerRunup& one) { return one.uncertainty / one.runup; });
            return {.value = off.rms(), .uncertainty = uncertain.rms()};
          },
          Uncertainty{.data = 0.025,
                      .useful = 0.075,
                      .reason = "twice u_data is 5 %, the tolerance of analytical benchmarks in Synolakis et al., NOAA "
                                "Tech. Memo. OAR PMEL-135 (2007); of the mesh, the change by the last halving of its "
                                "cells; together less than three quarters of the 10 % to be explained"});
  meshes.from("Hall and Watts (1953), in Frank (1994)")
      .check(
          "mild-friction",
          "The number of waves with a measured run-up at or above the frictionless Euler run-up on slopes milder than "
          "1:2 is zero.",
          "waves measured as high or higher",
          [](const MildSlopes& r) {
            Count higher;
            for (const EulerRunup& one : r.euler) {
              higher.add(one.measured - (one.runup - one.uncertainty), [](double above) { return above >= 0; });
            }
            return higher.value();
          },
          Bound{.limit = 0,
                .reason = "friction dissipates energy, all else is in the equations; the mesh run-up minus its "
                          "uncertainty counts"});
}

void show_mild_slopes(const MildSlopes& mild, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(
      exhibit, "mild", "Without friction on mild slopes",
      "Non-breaking waves: measured by Hall and Watts; Euler equations on the Lagrangian mesh, extrapolated, with the "
      "change by the last halving; one-dimensional model with the kinetic energy of Green and Naghdi.",
      {"cot [1]", "A [depth]", "measured [depth]", "Euler [depth]", "+- [depth]", "Green-Naghdi [depth]"});
  for (const EulerRunup& one : mild.euler) {
    table.rows.push_back({one.cot_slope, one.amplitude, one.measured, rounded(one.runup), rounded(one.uncertainty),
                          rounded(one.green_naghdi)});
  }
  const auto off = over<Mean>(mild.euler, [](const EulerRunup& one) { return one.runup / one.measured - 1; });
  exhibit.measure("measured_rms_mild_euler", off.rms());
}

}  // namespace seiche::validation
