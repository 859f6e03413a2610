// Water at rest between walls of dynamic particles: what pressures the walls make, and what each option does to them.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_still_tank_test {

using namespace wcsph;

constexpr double gravity = 9.81, width = 1, depth = 0.5;

/// Rms errors of the pressure over rho_0 g H: of all water, and farther than 3.5 smoothing lengths from walls.
struct Errors {
  double all = 0, core = 0;
};

/// A lattice of water with three rows of wall particles that continue it, without pressure of their own.
Particles full_rows(double spacing, const Settings& settings) {
  const TaitFluid water(settings.density, settings.sound_speed);
  const long columns = std::lround(width / spacing), rows = std::lround(depth / spacing);
  Particles particles;
  for (long j = -3; j < rows + 4; ++j) {
    for (long i = -3; i < columns + 3; ++i) {
      const bool fluid = i >= 0 && i < columns && j >= 0;
      if (fluid && j >= rows) continue;
      const double z = (static_cast<double>(j) + 0.5) * spacing;
      particles.add((static_cast<double>(i) + 0.5) * spacing, z, settings.density * spacing * spacing,
                    fluid ? water.hydrostatic_density(gravity, depth - z) : settings.density,
                    fluid ? Kind::fluid : Kind::wall);
    }
  }
  return particles;
}

Errors settle(Settings settings, double time, bool full = false) {
  constexpr double spacing = 0.025;
  settings.gravity = gravity;
  settings.sound_speed = sound_speed_for(gravity, 2 * depth);
  settings.viscosity = ArtificialViscosity{0.1};
  settings.xsph = 0.5;
  Flow flow(full ? full_rows(spacing, settings)
                 : tank({.width = width, .depth = depth, .spacing = spacing}, settings).particles,
            spacing, settings);
  march(flow, time);
  const Particles& p = flow.particles();
  const std::vector<double> pressure = flow.pressure();
  const double core = 3.5 * flow.smoothing_length();
  Mean everywhere, inside;
  for (std::size_t a = 0; a < p.size(); ++a) {
    if (p.kind[a] != Kind::fluid) continue;
    const double error = pressure[a] / (1000 * gravity * depth) - (1 - p.z[a] / depth);
    everywhere.add(error);
    if (p.x[a] > core && p.x[a] < width - core && p.z[a] > core) inside.add(error);
  }
  return {everywhere.rms(), inside.rms()};
}

TEST_CASE("the effect of options on the pressure of a tank at rest", "[robustness]") {
  Check check("wcsph_still_tank", "Tank at rest: effect of options on the pressure",
              "1 m x 0.5 m of water, $dx = 0.025$ m, $c_0 = 10\\sqrt{2gH}$, $\\alpha = 0.1$, hydrostatic start, 1 or 2 "
              "s. Claims of the case `hydrostatic_sph` are not repeated here. Then the same tank with three full rows "
              "of wall particles on the lattice of the water, whose initial density is the reference density: dynamic "
              "walls push only after compression by the water, and the pressure wave of this start stays in their "
              "densities. Extrapolation from the water with its hydrostatic gradient finds the right pressure at once.",
              "P = rho_0 g (H - z)");
  const Settings filtered{.filter_every = 30}, diffusive{.density_diffusion = 0.1},
      extrapolated{.walls = WallPressure::extrapolated};
  const auto claim = [&](const std::string& source, const std::string& id, const std::string& text,
                         const std::string& quantity, double value, double limit, const std::string& reason) {
    check.from(source).that(id, text, quantity, {value}, Bound{limit, reason});
  };
  claim("Colagrossi and Landrini, J. Comput. Phys. 191 (2003) 448", "filter-smooths",
        "The core error with the density filter is at most 0.5 times the error without.",
        "core error with the filter over that without, 2 s", settle(filtered, 2).core / settle({}, 2).core, 0.5,
        "most means more than half");
  claim("Antuono, Colagrossi, Marrone and Molteni, Comput. Phys. Comm. 181 (2010) 532", "smoother",
        "The L2 error with density diffusion is at most 0.5 times the error without.",
        "L2 error over that without diffusion, 1 s", settle(diffusive, 1).all / settle({}, 1).all, 0.5,
        "more than half: it acts on the noise, the pressure itself is linear");
  const std::string adami = "Adami, Hu and Adams, J. Comput. Phys. 231 (2012) 7057";
  const double all = settle(extrapolated, 1, true).all;
  claim(adami, "pressure", "Walls with extrapolated pressure need no pressure of their own.",
        "L2 error over rho_0 g H, 1 s", all, 0.0105,
        "|M - 1| = 1.05 % of the pressure at the bottom, the error of the derivative on the lattice");
  claim(adami, "better", "The pressure error is below half of the error with dynamic walls.",
        "L2 error over the error with dynamic walls", all / settle({}, 1, true).all, 0.5,
        "more than half of the error is due to the walls");
}

}  // namespace seiche::verification::wcsph_still_tank_test
