// What weakly compressible SPH conserves: momentum to round-off, angular momentum and energy to the order of the steps;
// and density diffusion between fluid particles: what it keeps, and what it leaves alone.
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_invariants_test {

using namespace wcsph;

const std::string source = "Monaghan, Rep. Prog. Phys. 68 (2005) 1703: antisymmetry of the pair forces";

/// Blob with random velocities and no net momentum.
Particles resting_blob(double spacing) {
  Particles blob = random_blob(spacing, 1000, 1);
  double mass = 0, px = 0, pz = 0;
  for (std::size_t a = 0; a < blob.size(); ++a) {
    mass += blob.mass[a];
    px += blob.mass[a] * blob.u[a];
    pz += blob.mass[a] * blob.w[a];
  }
  for (std::size_t a = 0; a < blob.size(); ++a) {
    blob.u[a] -= px / mass;
    blob.w[a] -= pz / mass;
  }
  return blob;
}

/// Velocity (-x, z), jittered: no symmetry is left.
Particles jittered_patch(double spacing, double density) {
  Particles patch = wcsph_disc(spacing, density);
  jitter(patch, 0.1 * spacing);
  for (std::size_t a = 0; a < patch.size(); ++a) {
    patch.u[a] = -patch.x[a] + 0.3 * patch.z[a];
    patch.w[a] = patch.z[a] - 0.3 * patch.x[a];
  }
  return patch;
}

TEST_CASE("momentum of a free blob is conserved to round-off with every viscosity", "[conservation]") {
  Check check("wcsph_momentum", "Momentum and mass of a free blob",
              "A disordered disc of unequal masses with random velocities and densities, no walls, no gravity, 300 "
              "steps. Pair forces are bitwise antisymmetric, although every particle gathers its own sums, so that the "
              "momentum wanders by rounding alone.");
  for (const auto& [name, viscosity] : {std::pair<std::string, Viscosity>{"inviscid", Inviscid{}},
                                        {"artificial", ArtificialViscosity{0.3}},
                                        {"laminar", LaminarSps{0.05, 0, 0}},
                                        {"sps", LaminarSps{0.01, 0.12, 0.00066}}}) {
    Flow flow(resting_blob(0.05), 0.05, {.gravity = 0, .sound_speed = 20, .viscosity = viscosity});
    const Totals start = flow.totals();
    for (int step = 0; step < 300; ++step) flow.advance(flow.stable_step());
    const Totals end = flow.totals();
    check.holds(fmt::format("Momentum is conserved to round-off ({}).", name),
                {std::hypot(end.momentum[0], end.momentum[1]) / start.absolute_momentum},
                Roundoff{300.0 * 4 / 1250, 1,
                         "each of 1250 particles rounds its velocity 4 times per step, independently: the mean of "
                         "their random walks over 300 steps"});
    CHECK(end.mass == start.mass);
  }
}

TEST_CASE("smoothed motion moves the centre of mass with the momentum", "[conservation]") {
  Check check("wcsph_smoothed_motion", "Smoothed motion",
              "The displacement (6) pulls particles towards the mean velocity of their neighbours: it moves no mass, "
              "$\\sum m\\,\\dot r = \\sum m\\,u$, and by its sign it brings particles together in velocity, $\\sum "
              "m\\,\\dot r\\cdot u < \\sum m\\,u\\cdot u$.",
              source);
  const Particles blob = random_blob(0.05, 1000, 1);
  Flow flow(blob, 0.05, {.gravity = 0, .sound_speed = 20, .viscosity = Inviscid{}, .xsph = 0.5});
  const Rates rates = flow.rates();
  const Particles& p = flow.particles();
  double drift = 0, scale = 0, smoothed = 0, square = 0;
  for (std::size_t a = 0; a < p.size(); ++a) {
    drift += p.mass[a] * (rates.dx[a] - p.u[a]);
    scale += p.mass[a] * std::abs(rates.dx[a] - p.u[a]);
    smoothed += p.mass[a] * (rates.dx[a] * p.u[a] + rates.dz[a] * p.w[a]);
    square += p.mass[a] * (p.u[a] * p.u[a] + p.w[a] * p.w[a]);
  }
  check.that("centre", "The velocity of the centre of mass is unchanged by smoothing of the motion to round-off.",
             "sum m (dr/dt - u) over its absolute sum", {drift / scale},
             Roundoff{20.0 + 1250, 0.05,
                      "20 pairs per particle, and a sum of 1250 terms, of relative size 1/sqrt(1250) each"});
  check.from("Monaghan, J. Comput. Phys. 82 (1989) 1")
      .that("direction", "The smoothing of the motion reduces velocity differences between neighbours.",
            "sum m dr/dt . u below sum m u . u", {smoothed < square ? 1.0 : 0.0},
            Qualitative{"sum m dr/dt . u < sum m u . u", "the weights are positive: each pair contributes -|u_ab|^2"});
}

TEST_CASE("energy and angular momentum are conserved to the order of the steps", "[conservation]") {
  Check check("wcsph_energy", "Energy and angular momentum of a free patch",
              "A jittered stretching and turning disc without viscosity to t = 0.2. The equations conserve energy, "
              "kinetic and elastic, and angular momentum in continuous time, with smoothed motion too: the work of the "
              "pressures in (3) is the elastic power of (2). What is left is of the steps: of their order, second, for "
              "angular momentum, and of third for the energy of sound.");
  constexpr double spacing = 0.08;
  const Particles patch = jittered_patch(spacing, 1);
  refine(
      check, {"dt [s]", widths(0.2, {100, 141, 200, 283})},
      {{"energy-order",
        "The energy drift is third-order in the step.",
        {3, 0.3,
         "the growth of sound, (omega dt)^4/4 per step, dominates at steps near the acoustic limit; the energy is not "
         "quadratic, so that a second-order part shows below a quarter of it"}},
       {"angular-momentum-order",
        "The angular momentum drift is second-order in the step.",
        {2, 0.25, "order of the midpoint rule; a third-order share at the longest steps"}}},
      [&](double step) {
        Flow flow(patch, spacing,
                  {.gravity = 0, .density = 1, .sound_speed = 14, .viscosity = Inviscid{}, .xsph = 0.5});
        const Totals start = flow.totals();
        for (std::size_t k = cells_of(0.2, step); k > 0; --k) flow.advance(step);
        const Totals end = flow.totals();
        return std::array{std::abs(end.energy() - start.energy()) / start.kinetic,
                          std::abs(end.angular_momentum - start.angular_momentum) / std::abs(start.angular_momentum)};
      });
}

TEST_CASE("a symmetric patch does not start to rotate", "[conservation]") {
  Check check("wcsph_symmetric_patch", "Angular momentum of a symmetric patch",
              "The stretching disc on a particle arrangement symmetric about both axes: angular momentum stays at "
              "round-off although steps are explicit.",
              "symmetry");
  Particles patch = wcsph_disc(0.05, 1);
  for (std::size_t a = 0; a < patch.size(); ++a) {
    patch.u[a] = -patch.x[a];
    patch.w[a] = patch.z[a];
  }
  Flow flow(patch, 0.05, {.gravity = 0, .density = 1, .sound_speed = 14, .viscosity = Inviscid{}, .xsph = 0.5});
  march(flow, 0.5);
  const Totals end = flow.totals();
  check.that("turning", "The angular momentum of a symmetric patch is zero to round-off.",
             "angular momentum/sum m |u| R", {end.angular_momentum / end.absolute_momentum},
             Roundoff{static_cast<double>(flow.steps()) * 4 / 1257, 1,
                      "independent rounding of 1257 velocities, 4 times per step"});
  CHECK(std::hypot(end.momentum[0], end.momentum[1]) / end.absolute_momentum < 1e-15);
}

/// Rates of the density where nothing moves: the diffusion alone.
std::vector<double> diffusion_of(const Particles& still, const Settings& settings) {
  Flow flow(still, 0.1, settings);
  const std::vector<double> rates = flow.rates().ddensity;
  return sorted_back(flow.particles(), rates);
}

Particles at_rest(Particles particles) {
  for (std::size_t a = 0; a < particles.size(); ++a) particles.u[a] = particles.w[a] = 0;
  return particles;
}

TEST_CASE("density diffusion conserves mass and leaves linear densities unchanged", "[conservation]") {
  Check check("wcsph_density_diffusion", "Density diffusion: conservation",
              "Disordered particles at rest with random densities and masses, so that the rates of the density are the "
              "diffusion alone. What one particle of a pair gains the other loses: $\\sum_a V_a D_a = 0$, $V = "
              "m/\\rho$, in a free blob and in a periodic box. A linear density, with the free surface of the blob "
              "around it, is not changed.");
  constexpr double spacing = 0.1, side = 16 * spacing;
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
    for (const auto& [name, particles, settings] :
         {std::tuple{"free blob", at_rest(random_blob(spacing, 1000, 1)), open},
          std::tuple{"periodic box", at_rest(noisy_square(16, spacing)), box}}) {
      const std::vector<double> rates = diffusion_of(particles, settings);
      long double sum = 0, scale = 0;
      for (std::size_t a = 0; a < rates.size(); ++a) {
        const double volume = particles.mass[a] / particles.density[a];
        sum += volume * rates[a];
        scale += std::abs(volume * rates[a]);
      }
      check.holds(
          fmt::format("The mass created by density diffusion is zero to round-off ({}, {}).", name, name_of(kernel)),
          {static_cast<double>(sum / scale)},
          Roundoff{60, 1,
                   "terms of a pair are bitwise identical except for their volumes: 4 roundings of each and of "
                   "the sums of some 45 of them, which may be 10 times the rate; over hundreds of particles "
                   "they cancel as random numbers do"});
    }
    Particles linear = at_rest(random_blob(spacing, 1000, 1));
    for (std::size_t a = 0; a < linear.size(); ++a) {
      linear.density[a] = 1000 * (1 + 0.01 * linear.x[a] - 0.02 * linear.z[a]);
    }
    // The diffusion of a density that differs by as much from one neighbour to the next.
    const double usual = open.density_diffusion * open.sound_speed * 1000 * 0.02 / smoothing;
    check.holds(fmt::format("The diffusion of a linear density is zero to round-off ({}).", name_of(kernel)),
                {worst(diffusion_of(linear, open)) / usual},
                Roundoff{60, 1000 / (1000 * 0.02 * spacing) * 100,
                         "densities of 1000 are rounded where neighbours differ by 2: 500 times; the inverse of a "
                         "matrix that is taken down to a determinant of 0.01: 100 times; some 45 neighbours"});
  }
}

}  // namespace seiche::verification::wcsph_invariants_test
