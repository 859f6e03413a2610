#include "validation/parallel/flows.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/model_waves.hpp"
#include "seiche/require.hpp"

namespace seiche::parallel {

constexpr double crest = 15;  // of the solitary wave at the beginning, in depths from the west wall

void add_options(CLI::App& app, Options& options) {
  const auto option = [&](const char* name, auto& value, const char* meaning) {
    return app.add_option(name, value, meaning)->capture_default_str();
  };
  option("flow", options.flow,
         "hump: of water at rest in the middle of a box; soliton: a solitary wave that runs along x; reflection: "
         "one that meets a wall at an angle, in a window that follows it; island: one around a conical island, "
         "with its shoreline, without breaking")
      ->check(CLI::IsMember({"hump", "soliton", "reflection", "island"}));
  option("--columns", options.columns, "of cells, of hump and soliton")->check(CLI::Range(2, 1000000));
  option("--rows", options.rows, "of cells, of hump and soliton")->check(CLI::Range(1, 1000000));
  option("--layers", options.layers, "of hexahedra; 0: the 2DH model")->check(CLI::Range(0, 100));
  option("--spacing", options.spacing, "of the grid [h]");
  option("--angle", options.angle, "of a reflected wave [degrees]")->check(CLI::Range(0.0, 75.0));
  option("--amplitude", options.amplitude, "[depths]");
  option("--time", options.time, "[sqrt(depth/g)]");
  option("--step", options.step, "[sqrt(depth/g)]");
  option("--every", options.every, "time between files; 0: one at the end");
  option("--tolerance", options.tolerance, "relative residual of the solver");
  option("--scheme", options.scheme, "one_step, or conservative: energy exact, several solutions a step")
      ->check(CLI::IsMember({"one_step", "conservative"}));
  option("--out", options.out, "folder for fields_*.h5 and the record");
}

namespace {

void require_sensible(const Options& options) {
  require_positive("spacing", options.spacing);
  require_within("amplitude", options.amplitude, 1e-6, 0.6);
  require_positive("time", options.time);
  require_positive("step", options.step);
  require_not_negative("every", options.every);
}

}  // namespace

dispersive_shallow_water_2d::Rectangle water(const Options& options) {
  require_sensible(options);
  const double length = options.spacing * static_cast<double>(options.columns);
  const double width = options.spacing * static_cast<double>(options.rows);
  dispersive_shallow_water_2d::Rectangle rectangle{
      .begin = 0, .end = length, .north = width, .columns = options.columns, .rows = options.rows};
  if (options.flow == "hump") {
    rectangle.elevation = [=, a = options.amplitude](double x, double y) {
      const double r2 = (x - length / 2) * (x - length / 2) + (y - width / 2) * (y - width / 2);
      return a * std::exp(-r2 / 16);
    };
  } else {
    rectangle.elevation = [wave = exact::SerreSolitary(options.amplitude)](double x, double) {
      return wave.elevation(x - crest);
    };
  }
  return rectangle;
}

dispersive_shallow_water_2d::VelocityAt velocity(const Options& options) {
  if (options.flow == "hump") return {};
  return
      [wave = exact::SerreSolitary(options.amplitude), celerity = std::sqrt(1 + options.amplitude)](double x, double) {
        const double eta = wave.elevation(x - crest);
        const double u = celerity * eta / (1 + eta);
        return dispersive_shallow_water_2d::Velocity{u, 0, (u - celerity) * wave.elevation_slope(x - crest)};
      };
}

lagrangian_mesh_3d::Layer layered_water(const Options& options) {
  return validation::layers_of(water(options), options.layers);
}

lagrangian_mesh_3d::VelocityAt layered_velocity(const Options& options) {
  if (options.flow == "hump") return {};
  return validation::layered(velocity(options), water(options));
}

validation::ObliqueWave oblique_wave(const Options& options) {
  require_sensible(options);
  return {options.amplitude, options.angle * std::numbers::pi / 180};
}

validation::ReflectionWindow reflection_window(const Options& options) {
  return window_until(options.time, oblique_wave(options), options.spacing);
}

validation::ConicalIsland::Settings island(const Options& options) {
  require_sensible(options);
  if (options.layers > 0) throw std::invalid_argument("an island in layers of hexahedra; allowed: the 2DH model");
  validation::ConicalIsland::Settings settings{.height = options.amplitude};
  settings.spacing = options.spacing * settings.depth;
  settings.drag.breaking_slope = 0;  // fronts run through the blocks of several processes
  return settings;
}

Units units(const Options& options) {
  if (options.flow != "island") return {};
  const double depth = validation::ConicalIsland::Settings{}.depth;
  return {.length = depth, .time = std::sqrt(depth / validation::ConicalIsland::gravity)};
}

evidence::Record begun(const Options& options) {
  evidence::Record record;
  record.name = "parallel_" + options.flow + (options.layers > 0 ? "_hexahedra" : "");
  record.group = "parallel";
  const std::string what = options.flow == "hump"         ? "A hump of water in a box"
                           : options.flow == "soliton"    ? "A solitary wave"
                           : options.flow == "reflection" ? "A solitary wave that meets a wall at an angle"
                                                          : "A solitary wave around a conical island";
  record.title = what + ", on many processes";
  record.source = "validation/parallel/flows.cpp";
  record.article =
      std::string(options.layers > 0 ? "Layers of Lagrangian hexahedra" : "The 2DH model of dispersive shallow water") +
      " on a grid distributed over processes (MPI); PETSc exchanges neighbour values and solves the system of all "
      "cells.";
  const Options standard;
  const auto keep = [&](const char* name, auto value, auto usual, const char* unit, const char* meaning) {
    record.parameters[name] = {.value = value, .standard = usual, .unit = unit, .meaning = meaning};
  };
  keep("columns", static_cast<long>(options.columns), static_cast<long>(standard.columns), "1", "cells along x");
  keep("rows", static_cast<long>(options.rows), static_cast<long>(standard.rows), "1", "cells along y");
  keep("layers", static_cast<long>(options.layers), static_cast<long>(standard.layers), "1",
       "of hexahedra; 0: the 2DH model");
  if (options.flow == "reflection")
    keep("angle", options.angle, standard.angle, "deg", "between crest and wall's normal");
  keep("spacing", options.spacing, standard.spacing, "depth", "of the lattice");
  keep("amplitude", options.amplitude, standard.amplitude, "depth", "of the first surface");
  keep("time", options.time, standard.time, "sqrt(depth/g)", "at the end");
  keep("step", options.step, standard.step, "sqrt(depth/g)", "of time");
  keep("scheme", options.scheme, standard.scheme, "", "of time");
  keep("tolerance", options.tolerance, standard.tolerance, "1", "relative residual of the solver");
  return record;
}

namespace {

/// @param change  over the first energy
void judge_energy(evidence::Record& record, const std::string& text, const std::string& quantity,
                  const evidence::Measurement& change, double limit, const std::string& reason) {
  record.check({.id = "energy",
                .text = text,
                .quantity = quantity + " of energy over its first value",
                .source = "Frank, Discrete models of incompressible fluid (1994), chapter 1"},
               change, evidence::Bound{.limit = limit, .reason = reason});
}

/// k of the solitary wave a sech^2(k s), times the depth.
double wave_number(const Options& options) {
  return std::sqrt(3 * options.amplitude / (4 * (1 + options.amplitude)));
}

void judge_reflection(evidence::Record& record, const Options& options, const Findings& findings,
                      const std::string& resolution) {
  const validation::ObliqueWave wave = oblique_wave(options);
  const double decay = wave_number(options);
  const double coarse = decay * decay * options.spacing * options.spacing;
  record.check(
      {"ahead",
       "The elevation at the window's east side stays below the incident wave two columns behind its height of 1e-5.",
       "height of the surface at the east side", "depth", "validation/instruments/plan/oblique_wave.hpp"},
      {.value = findings.ahead, .resolution = resolution},
      evidence::Bound{.limit = 1e-5 * std::exp(4 * decay * std::cos(wave.angle()) * options.spacing),
                      .reason = "the incident wave two columns behind the position where its height is 1e-5: the east "
                                "side may lag by one"});
  record.check(
      {.id = "incident",
       .text =
           "The height of the incident wave far from the wall agrees with its initial height to second order, (k h)^2.",
       .quantity = "median of its height near the upper end of the window",
       .unit = "depth",
       .source = "Serre's solitary wave, an exact wave of the model in the limit of fine cells"},
      {.value = findings.incident, .resolution = resolution},
      evidence::Bound{.limit = coarse,
                      .reason = "(k h)^2 for a wave a sech^2(k s) on a grid of spacing h",
                      .expected = options.amplitude,
                      .relative = true});
  record.check({.id = "wall",
                .text = "The wave height at the wall lies between 1 and 4 times the incident height.",
                .quantity = "height at the wall over the height of the incident wave",
                .source = "J. W. Miles, Resonantly interacting solitary waves, J. Fluid Mech. 79 (1977) 171"},
               {.value = findings.wall / findings.incident, .resolution = resolution},
               evidence::Bound{.limit = 1.5 + coarse,
                               .reason = "from 1 without a reflection to 4, Miles's largest, and (k h)^2 as before",
                               .expected = 2.5});
}

void judge_island(evidence::Record& record, const Options& options, const Findings& findings,
                  const std::string& resolution) {
  const double coarse = std::pow(wave_number(options) * options.spacing, 2);
  constexpr double cotangent = 1 / validation::ConicalIsland::slope;
  judge_energy(record,
               "The energy with friction rises by at most the oscillation of the one-step scheme, (omega tau)^2/4.",
               "largest rise", {.value = findings.energy_rise / findings.energy, .resolution = resolution},
               3 * options.step * options.step / 4,
               "(omega tau)^2/4, twice an oscillator's amplitude of energy under drift, kick, drift, at the highest "
               "frequency sqrt(3 g/depth)");
  record.check(
      {.id = "run-up",
       .text = "The maximum run-up on the island is at most Synolakis' run-up on a plane beach of its slope.",
       .quantity = "highest shoreline elevation",
       .unit = "depth",
       .source = "C. E. Synolakis, The runup of solitary waves, J. Fluid Mech. 185 (1987) 523"},
      {.value = findings.run_up, .resolution = resolution},
      evidence::Bound{
          .limit = 2.831 * std::sqrt(cotangent) * std::pow(options.amplitude, 1.25) * (1 + coarse),
          .reason =
              "2.831 sqrt(cot beta) (H/d)^(5/4), and (k h)^2 of it for a wave a sech^2(k s) on a grid of spacing h"});
}

}  // namespace

void judge(evidence::Record& record, const Options& options, const Findings& findings) {
  const std::string resolution =
      fmt::format("{} x {}{} cells, {} steps", options.columns, options.rows,
                  options.layers > 0 ? fmt::format(" x {}", options.layers) : "", findings.steps);
  record.check({.id = "copies",
                .text = "The difference between the copies that several processes hold of a node is zero.",
                .quantity = "largest difference between copies",
                .source = "decomposition of the grid"},
               {.value = findings.rim_difference, .resolution = resolution},
               evidence::Bound{.limit = 0, .reason = "copies are assigned, not computed"});
  if (options.flow == "reflection") {
    judge_reflection(record, options, findings, resolution);
    return;
  }
  if (options.flow == "island") {
    judge_island(record, options, findings, resolution);
    return;
  }
  const evidence::Measurement change{.value = findings.energy_change / findings.energy, .resolution = resolution};
  if (options.scheme == "conservative") {
    judge_energy(record,
                 "The energy in the conservative scheme changes by at most 1e-11 per step, at which its sweeps end.",
                 "largest change", change, 1e-11 * static_cast<double>(findings.steps),
                 "sweeps end when velocities change by less than 1e-11 of the largest");
    return;
  }
  // Squares of the models' frequencies are below 3 for columns (alpha = 1/3, unit depth and gravity), below 2 over the
  // height of a layer for hexahedra.
  const double fastest = options.layers > 0 ? 2 * static_cast<double>(options.layers) : 3;
  judge_energy(
      record, "The energy change is within the oscillation of the one-step scheme, (omega tau)^2/4.", "largest change",
      change, fastest * options.step * options.step / 4,
      fmt::format("(omega tau)^2/4, twice an oscillator's amplitude of energy under drift, kick, drift, at the "
                  "highest frequency sqrt({:g} g/depth)",
                  fastest));
}

}  // namespace seiche::parallel
