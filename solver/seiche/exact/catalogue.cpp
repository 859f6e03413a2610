#include "seiche/exact/catalogue.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/wording.hpp"

namespace seiche::exact {

// Each is defined at the end of its solution's file.
ExactSolution riemann_entry(), bore_reflection_entry(), simple_wave_entry(), steady_bump_entry(), macdonald_entry(),
    thacker_entry(), thacker_radial_entry(), thacker_planar_entry(), airy_entry(), dispersion_entry(),
    frank_dispersion_entry(), lagrangian_mesh_dispersion_entry(), plan_dispersion_entry(),
    hexahedral_dispersion_entry(), serre_solitary_entry(), serre_cnoidal_entry(), solitary_asymptotic_entry(),
    solitary_entry(), stokes_entry(), standing_entry(), dispersive_standing_entry(), gerstner_entry(),
    overturning_wave_entry(), pressure_forced_wave_entry(), waves_in_tank_entry(), released_column_entry(),
    soliton_fission_entry(), solitary_runup_entry(), hall_watts_entry(), wall_load_entry(), wall_runup_entry(),
    slope_runup_entry(), mach_reflection_entry(), wavemaker_entry(), wavemaker_start_entry(), affine_drop_entry();

Evaluator ExactSolution::evaluator(const std::map<std::string, double>& values) const {
  std::map<std::string, double> complete;
  std::vector<std::string> known;
  for (const Parameter& parameter : parameters) {
    complete[parameter.name] = parameter.default_value;
    known.push_back(parameter.name);
  }
  for (const auto& [key, value] : values) {
    const auto place = complete.find(key);
    require_that(place != complete.end(), "{} is not a parameter of {}{} it has {}", key, name,
                 did_you_mean(key, known), fmt::join(known, ", "));
    place->second = value;
  }
  for (const Parameter& parameter : parameters) {
    const double value = complete[parameter.name];
    require_within(parameter.name, value, parameter.minimum, parameter.maximum);
    require_that(parameter.choices.empty() || value == std::floor(value),
                 "{} = {:g} is out of range: must be the number of one of {}, from 0", parameter.name, value,
                 fmt::join(parameter.choices, ", "));
  }
  return factory(complete);
}

namespace {

template <class... Entries>
std::vector<ExactSolution> solutions_of(Entries... entries) {
  return {entries()...};
}

}  // namespace

const std::vector<ExactSolution>& catalogue() {
  static const auto solutions =
      solutions_of(riemann_entry, bore_reflection_entry, simple_wave_entry, steady_bump_entry, macdonald_entry,
                   thacker_entry, thacker_radial_entry, thacker_planar_entry, airy_entry, dispersion_entry,
                   frank_dispersion_entry, lagrangian_mesh_dispersion_entry, plan_dispersion_entry,
                   hexahedral_dispersion_entry, serre_solitary_entry, serre_cnoidal_entry, solitary_asymptotic_entry,
                   solitary_entry, stokes_entry, standing_entry, dispersive_standing_entry, gerstner_entry,
                   overturning_wave_entry, pressure_forced_wave_entry, waves_in_tank_entry, released_column_entry,
                   soliton_fission_entry, solitary_runup_entry, hall_watts_entry, wall_load_entry, wall_runup_entry,
                   slope_runup_entry, mach_reflection_entry, wavemaker_entry, wavemaker_start_entry, affine_drop_entry);
  return solutions;
}

const ExactSolution& find_solution(std::string_view name) {
  std::vector<std::string> known;
  for (const ExactSolution& solution : catalogue()) {
    if (solution.name == name) return solution;
    known.push_back(solution.name);
  }
  throw std::invalid_argument(fmt::format("exact solution {} is unknown{} There are {}", name,
                                          did_you_mean(name, known), fmt::join(known, ", ")));
}

}  // namespace seiche::exact
