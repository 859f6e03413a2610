#include "validation/studies/wcsph/sph_settings.hpp"

#include <iterator>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

wcsph::Viscosity viscosity_of(const Values& values) {
  const std::string& name = values.text("viscosity");
  if (name == "artificial") return wcsph::ArtificialViscosity{values.real("alpha")};
  if (name == "none") return wcsph::Inviscid{};
  if (name == "laminar") return wcsph::LaminarSps{values.real("nu0"), 0, 0};
  return wcsph::LaminarSps{values.real("nu0"), values.real("smagorinsky"), values.real("isotropic")};
}

wcsph::WallPressure walls_of(const std::string& name) {
  if (name == "clamped") return wcsph::WallPressure::clamped;
  if (name == "extrapolated") return wcsph::WallPressure::extrapolated;
  return wcsph::WallPressure::dynamic;
}

}  // namespace

std::vector<Parameter> sph_parameters(const SphDefaults& defaults, const std::string& sound_meaning) {
  return {
      choice("kernel", defaults.kernel, {"cubic_spline", "wendland_c2"}, "smoothing kernel"),
      real("smoothing", defaults.smoothing, "dx", {0.9, 3}, "smoothing length h over the particle spacing"),
      choice("viscosity", defaults.viscosity, {"artificial", "sps", "laminar", "none"},
             "artificial: on approaching pairs; sps: laminar and the SPS stress"),
      real("alpha", defaults.alpha, "1", {0, 5}, "coefficient of the artificial viscosity"),
      real("nu0", defaults.kinematic_viscosity, "m^2/s", {0, 1e6}, "kinematic viscosity of sps and laminar"),
      real("smagorinsky", 0.12, "1", {0, 1}, "coefficient C_S of sps"),
      real("isotropic", 0.00066, "1", {0, 1}, "coefficient C_I of sps"),
      real("xsph", defaults.xsph, "1", {0, 1},
           "XSPH coefficient: fraction of the neighbours' velocity that moves a particle"),
      integer("filter", defaults.filter, {0, 1e6}, "steps between density filters; 0: none"),
      real("sound", defaults.sound, "1", {1, 1000}, "sound speed over " + sound_meaning),
      choice("walls", defaults.walls, {"dynamic", "clamped", "extrapolated"},
             "pressure of wall particles: their own density, the same without suction, from the fluid beside them"),
      real("diffusion", defaults.diffusion, "1", {0, 1}, "coefficient of the density diffusion of delta-SPH; 0: none"),
      toggle("shifting", false, "particle shifting away from the free surface"),
      real("courant", defaults.courant, "1", {0.01, 0.5}, "time step over h/(c + sigma)"),
  };
}

wcsph::Settings sph_settings(const Values& values, double gravity, double density, double sound_unit) {
  return {.kernel = wcsph::kernel_named(values.text("kernel")),
          .smoothing = values.real("smoothing"),
          .gravity = gravity,
          .density = density,
          .sound_speed = values.real("sound") * sound_unit,
          .viscosity = viscosity_of(values),
          .xsph = values.real("xsph"),
          .filter_every = static_cast<int>(values.integer("filter")),
          .density_diffusion = values.real("diffusion"),
          .particle_shifting = values.toggle("shifting"),
          .walls = walls_of(values.text("walls")),
          .courant = values.real("courant")};
}

std::vector<Parameter> with(std::vector<Parameter> a, std::vector<Parameter> b) {
  a.insert(a.end(), std::make_move_iterator(b.begin()), std::make_move_iterator(b.end()));
  return a;
}

std::string sph_resolution(double spacing, std::size_t particles) {
  return fmt::format("dx = {:.4g} m, {} particles", spacing, particles);
}

}  // namespace seiche::validation
