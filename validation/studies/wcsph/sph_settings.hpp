/// The parameters that every case of weakly compressible SPH offers, and the settings that follow from them.
#pragma once

#include <string>
#include <vector>

#include "seiche/models/wcsph/settings.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation {

/// Defaults of one case.
struct SphDefaults {
  ByTier<std::string> kernel = std::string("cubic_spline");
  ByTier<double> smoothing = 1.3;
  std::string viscosity = "artificial";
  double alpha = 0.1;
  double kinematic_viscosity = 1e-6;
  double xsph = 0.5;
  long filter = 0;
  double sound = 10;
  std::string walls = "dynamic";
  double diffusion = 0;
  ByTier<double> courant = 0.3;
};

/// kernel, smoothing, viscosity, alpha, nu0, smagorinsky, isotropic, xsph, filter, sound, walls, diffusion, shifting,
/// courant.
/// @param sound_meaning  what the parameter `sound` is the coefficient of
std::vector<Parameter> sph_parameters(const SphDefaults& defaults, const std::string& sound_meaning);

/// @param sound_unit  [m/s], what the parameter `sound` multiplies
wcsph::Settings sph_settings(const Values& values, double gravity, double density, double sound_unit);

/// Appends b to a.
std::vector<Parameter> with(std::vector<Parameter> a, std::vector<Parameter> b);

/// "dx = 0.00114 m, 6101 particles".
std::string sph_resolution(double spacing, std::size_t particles);

}  // namespace seiche::validation
