// Rates of weakly compressible SPH against plain sums over all pairs, for every model, kernel and boundary.
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_rates_test {

using namespace wcsph;

constexpr double spacing = 0.1;

/// A jittered layer over a floor, repeated in x.
Particles layer(std::size_t columns, std::size_t rows) {
  Particles particles = noisy_square(columns, spacing);
  Particles result;
  for (std::size_t a = 0; a < columns * rows; ++a) {
    result.add(particles.x[a], particles.z[a] + 0.5 * spacing, particles.mass[a], particles.density[a], Kind::fluid,
               particles.u[a], particles.w[a]);
  }
  add_floor(result, 0, static_cast<double>(columns) * spacing, spacing, 1000);
  // The last wall particle is the image of the first.
  Particles open;
  Noise noise(11);
  for (std::size_t a = 0; a < result.size(); ++a) {
    const bool image = result.kind[a] == Kind::wall && result.x[a] > (static_cast<double>(columns) - 0.25) * spacing;
    const double density = result.kind[a] == Kind::wall ? 1000 * (1 + 0.02 * noise()) : result.density[a];
    if (!image) open.add(result.x[a], result.z[a], result.mass[a], density, result.kind[a], result.u[a], result.w[a]);
  }
  return open;
}

struct Setup {
  std::string id, name;
  Particles particles;
  Period period;
  double deviation;  ///< of densities from rho_0, relative
};

struct Model {
  std::string id, name;
  Viscosity viscosity;
};

TEST_CASE("rates equal the sums over all pairs for every viscosity, kernel and boundary", "[conservation]") {
  Check check("wcsph_rates", "Rates against sums over all pairs",
              "The right-hand sides of (2)-(6) on disordered particles with random velocities, densities and masses: "
              "the tiled, clustered evaluation against sums over all N^2 pairs written straight from the formulas. A "
              "free blob, a box that repeats itself in both directions and a layer over a floor of dynamic particles; "
              "both kernels; inviscid, artificial viscosity, laminar viscosity with and without sub-particle-scale "
              "stress. Largest difference over the largest rate.");
  const double side = 16 * spacing;
  const std::vector<Setup> setups{{"blob", "free blob", random_blob(spacing, 1000, 1), {}, 0.01},
                                  {"box", "periodic box", noisy_square(16, spacing), {side, side}, 0.02},
                                  {"floor", "layer over a floor", layer(16, 10), {.x = side}, 0.02}};
  const std::vector<Model> models{{"inviscid", "no viscosity", Inviscid{}},
                                  {"artificial", "artificial viscosity", ArtificialViscosity{0.3}},
                                  {"laminar", "laminar viscosity", LaminarSps{0.01, 0, 0}},
                                  {"sps", "laminar and sub-particle-scale stress", LaminarSps{0.01, 0.12, 0.0066}}};
  for (const Setup& setup : setups) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      for (const Model& model : models) {
        const Settings settings{.kernel = kernel,
                                .smoothing = kernel == KernelName::cubic_spline ? 1.3 : 1.6,
                                .sound_speed = 20,
                                .viscosity = model.viscosity,
                                .period = setup.period};
        Flow flow(setup.particles, spacing, settings);
        const RateDifference found = compare(flow, spacing);
        check.holds(
            fmt::format("{}, {} kernel, {}: all rates agree with the sums over all pairs.", setup.name, name_of(kernel),
                        model.name),
            {worst(std::array{found.motion, found.acceleration, found.density})},
            Roundoff{4, 1 / setup.deviation,
                     "pressures are differences (rho/rho_0)^7 - 1 of densities within 1 % (blob) or 2 %: the rounding "
                     "of rho/rho_0, of both particles and in both ways of summing, counts 100 or 50 times; of the 40 "
                     "others of a pair each counts once, all together less than one of these"});
      }
    }
  }
}

TEST_CASE("rates equal the sums over all pairs with clamped walls and density diffusion", "[conservation]") {
  Check check("wcsph_rates_options", "Rates of the options against sums over all pairs",
              "The same for options: no smoothed motion, walls that do not suck or whose pressure is extrapolated from "
              "the fluid, and density diffusion with corrected gradients, whose correction here is the inverse of the "
              "matrix of first moments of the fluid.");
  const double side = 16 * spacing;
  const std::vector<Setup> setups{{"box", "periodic box", noisy_square(16, spacing), {side, side}, 0.02},
                                  {"floor", "layer over a floor", layer(16, 10), {.x = side}, 0.02}};
  for (const Setup& setup : setups) {
    const Settings plain{.sound_speed = 20, .viscosity = ArtificialViscosity{0.1}, .period = setup.period};
    std::vector<std::pair<std::string, Settings>> options(4, {"", plain});
    options[0].first = "no smoothed motion";
    options[0].second.xsph = 0;
    options[1].first = "clamped walls";
    options[1].second.walls = WallPressure::clamped;
    options[2].first = "density diffusion";
    options[2].second.density_diffusion = 0.1;
    options[3].first = "extrapolated walls";
    options[3].second.walls = WallPressure::extrapolated;
    for (const auto& [name, settings] : options) {
      Flow flow(setup.particles, spacing, settings);
      // Walls are clamped by steps.
      flow.advance(1e-4);
      const RateDifference found = compare(flow, spacing);
      std::string id = setup.id + "-" + name;
      std::replace(id.begin(), id.end(), ' ', '-');
      check.holds(id + ": " + fmt::format("{}, {}: all rates agree with the sums over all pairs.", setup.name, name),
                  {worst(std::array{found.motion, found.acceleration, found.density})},
                  Roundoff{6, 1 / setup.deviation,
                           "as for the plain rates, and two roundings of rho/rho_0 more where the pressure of a wall "
                           "becomes a density and a pressure again"});
    }
  }
}

TEST_CASE("the step rule is that of the sums over all pairs", "[conservation]") {
  Check check("wcsph_step_rule", "Length of the step",
              "$\\Delta t = 0.3\\min_a h_a/(c_a + \\sigma_a)$ with $\\sigma_a$ the largest $|h_{ab}\\,u_{ab}\\cdot "
              "r_{ab}|/(r_{ab}^2 + 0.01 h_{ab}^2)$ over neighbours inside the support.",
              "Monaghan, J. Comput. Phys. 110 (1994) 399");
  const double side = 16 * spacing;
  Flow flow(noisy_square(16, spacing), spacing,
            {.sound_speed = 20, .viscosity = ArtificialViscosity{0.1}, .period = {side, side}});
  const double expected = DirectSums(noisy_square(16, spacing), spacing, flow.settings()).largest_step();
  check.that("step", "The first step has the length of the rule.", "dt [s]", {flow.stable_step()},
             Roundoff{40, expected,
                      "two evaluations of some 10 roundings of h, of the sound speed and of their quotient, and that "
                      "of rho/rho_0, which the cube of the sound speed counts three times (as 9)",
                      expected});
}

}  // namespace seiche::verification::wcsph_rates_test
