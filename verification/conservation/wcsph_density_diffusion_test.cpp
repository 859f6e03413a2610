// Density diffusion between fluid particles: what it keeps, and what it leaves alone.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_density_diffusion_test {

using namespace wcsph;

constexpr double spacing = 0.1;

/// Rates of the density where nothing moves: the diffusion alone.
std::vector<double> diffusion_of(const Particles& still, const Settings& settings) {
  Flow flow(still, spacing, settings);
  const std::vector<double> rates = flow.rates().ddensity;
  return sorted_back(flow.particles(), rates);
}

Particles at_rest(Particles particles) {
  for (std::size_t a = 0; a < particles.size(); ++a) particles.u[a] = particles.w[a] = 0;
  return particles;
}

TEST_CASE("density diffusion creates no mass and leaves linear densities alone", "[conservation]") {
  Check check("wcsph_density_diffusion", "Density diffusion: what it keeps",
              "Disordered particles at rest with random densities and masses, so that the rates of the density are the "
              "diffusion alone. What one particle of a pair gains the other loses: $\\sum_a V_a D_a = 0$, $V = "
              "m/\\rho$, in a free blob and in a periodic box. A linear density, with the free surface of the blob "
              "around it, is not changed.");
  const double side = 16 * spacing;
  for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
    const double smoothing = kernel == KernelName::cubic_spline ? 1.3 : 2.0;
    const Settings open{.kernel = kernel,
                        .smoothing = smoothing,
                        .gravity = 0,
                        .sound_speed = 20,
                        .viscosity = Inviscid{},
                        .density_diffusion = 0.1};
    Settings box = open;
    box.period = {side, side};
    struct Setup {
      std::string id, name;
      Particles particles;
      Settings settings;
    };
    for (const Setup& setup : {Setup{"blob", "free blob", at_rest(random_blob(spacing, 1000, 1)), open},
                               Setup{"box", "periodic box", at_rest(noisy_square(16, spacing)), box}}) {
      const std::vector<double> rates = diffusion_of(setup.particles, setup.settings);
      long double sum = 0;
      long double scale = 0;
      for (std::size_t a = 0; a < rates.size(); ++a) {
        const double volume = setup.particles.mass[a] / setup.particles.density[a];
        sum += volume * rates[a];
        scale += std::abs(volume * rates[a]);
      }
      check.holds(fmt::format("Density diffusion creates no mass ({}, {}).", setup.name, name_of(kernel)),
                  {static_cast<double>(sum / scale)},
                  Roundoff{60, 1,
                           "terms of a pair are the same numbers bit by bit but for their volumes: 4 roundings of each "
                           "and of the sums of some 45 of them, which may be 10 times the rate; over hundreds of "
                           "particles they cancel as random numbers do"});
    }
    Particles linear = at_rest(random_blob(spacing, 1000, 1));
    for (std::size_t a = 0; a < linear.size(); ++a)
      linear.density[a] = 1000 * (1 + 0.01 * linear.x[a] - 0.02 * linear.z[a]);
    // The diffusion of a density that differs by as much from one neighbour to the next.
    const double usual = open.density_diffusion * open.sound_speed * 1000 * 0.02 / smoothing;
    Worst largest;
    for (const double rate : diffusion_of(linear, open)) largest.add(rate / usual);
    check.holds(fmt::format("A linear density is left alone ({}).", name_of(kernel)), {largest.value()},
                Roundoff{60, 1000 / (1000 * 0.02 * spacing) * 100,
                         "densities of 1000 are rounded where neighbours differ by 2: 500 times; the inverse of a "
                         "matrix that is taken down to a determinant of 0.01: 100 times; some 45 neighbours"});
  }
}

}  // namespace seiche::verification::wcsph_density_diffusion_test
