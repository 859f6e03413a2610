// The density filter: moving least squares of first order reproduces linear fields on any arrangement.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_density_filter_test {

using namespace wcsph;

constexpr double spacing = 0.1;

double linear(double x, double z) {
  return 1000 * (1 + 0.03 * x - 0.02 * z);
}

/// Jittered water of 20 x 14 on a floor, with random masses, velocities and a disturbed density.
Particles disturbed_layer() {
  Particles particles = lattice(20, 14, spacing, 1000);
  for (double& z : particles.z) z += 0.5 * spacing;
  jitter(particles, 0.2 * spacing);
  add_floor(particles, -5 * spacing, 25 * spacing, spacing, 1000);
  Noise noise(3);
  for (std::size_t a = 0; a < particles.size(); ++a) {
    particles.density[a] *= 1 + 0.02 * noise();
    particles.mass[a] *= 1 + 0.05 * noise();
    if (particles.kind[a] == Kind::fluid) particles.u[a] = noise();
  }
  return particles;
}

std::vector<double> density_of(const Flow& flow) {
  return sorted_back(flow.particles(), flow.particles().density);
}

TEST_CASE("the density filter is moving least squares, which reproduces linear fields", "[manufactured]") {
  Check check("wcsph_density_filter", "Density filter",
              "Moving least squares of first order, written as sums over all pairs, reproduces a linear density on a "
              "disordered layer with a free surface, corners and a floor, of unequal masses, to round-off. The flow's "
              "filter gives the same densities as these sums from the state after one step, walls excluded, and steps "
              "between filters equal steps without a filter.",
              "Colagrossi and Landrini, J. Comput. Phys. 191 (2003) 448");
  const Settings settings{.gravity = 0, .sound_speed = 20, .viscosity = ArtificialViscosity{0.1}};
  Particles layer = disturbed_layer();
  for (std::size_t a = 0; a < layer.size(); ++a) layer.density[a] = linear(layer.x[a], layer.z[a]);
  const std::vector<double> filtered = DirectSums(layer, spacing, settings).filtered_density();
  check.that("linear", "A linear density is reproduced by the filter.", "largest relative error",
             {largest_difference(filtered, layer.density) / 1000},
             Roundoff{80, DirectSums(layer, spacing, settings).filter_cancellation(),
                      "6 sums of some 10 roundings, and 20 of a 3 x 3 solution; the terms are larger than their sum by "
                      "the cancellation in moving least squares, most at the corners of the surface"});
  for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
    for (const int lanes : {2, 4, 8}) {
      Settings plain = settings;
      plain.kernel = kernel;
      plain.lanes = lanes;
      Settings filtering = plain;
      filtering.filter_every = 2;
      const Particles start = disturbed_layer();
      Flow without(start, spacing, plain), with(start, spacing, filtering);
      const double step = 1e-3;
      without.advance(step);
      with.advance(step);
      CHECK(density_of(with) == density_of(without));
      without.advance(step);
      with.advance(step);
      const std::vector<double> expected =
          sorted_back(without.particles(), DirectSums(without.particles(), spacing, plain).filtered_density());
      const std::vector<double> found = density_of(with);
      check.holds(fmt::format("The filter of the flow is moving least squares ({}, {} lanes).", name_of(kernel), lanes),
                  {relative_difference(found, expected)},
                  Roundoff{160, DirectSums(start, spacing, plain).filter_cancellation(),
                           "as for the linear density, in both ways of summing; the particles have moved by 0.02 dx "
                           "since their cancellation was determined"});
      CHECK(largest_difference(found, density_of(without)) / 1000 > 1e-3);
    }
  }
}

}  // namespace seiche::verification::wcsph_density_filter_test
