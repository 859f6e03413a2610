// Sound in weakly compressible SPH with density diffusion: it dies away as the linear equations on the lattice say.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "verification/check.hpp"
#include "verification/lattice_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_diffusion_decay_test {

using namespace wcsph;

constexpr std::size_t cells = 32, rows = 16;
constexpr double dx = 1.0 / cells, sound_speed = 10, delta = 0.1, mach = 1e-6, duration = 0.5;

/// What the derivative of a wave is multiplied by, and the diffusion of exp(i k x) over delta c_0 h; dx = 1.
template <class Kernel>
std::pair<double, double> symbols(double h, double k) {
  double second = 0;
  const int reach = static_cast<int>(std::ceil(support * h));
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      const double r = std::hypot(i, j);
      if (r == 0 || r >= support * h) continue;
      second -= 2 * radial_slope<Kernel>(r, h) / r * (1 - std::cos(k * i));
    }
  }
  const LatticeSums sums = lattice_sums<Kernel>(h, Arrangement::square, k);
  return {sums.symbol, second - sums.symbol * sums.symbol / sums.first};
}

/// Amplitudes of rho/rho_0 - 1, as cos kx, and of u/c_0, as sin kx.
struct Amplitudes {
  double density, velocity;
};

Amplitudes of(const Flow& flow, double k) {
  const Particles& p = flow.particles();
  Amplitudes sum{0, 0};
  for (std::size_t a = 0; a < p.size(); ++a) {
    sum.density += (p.density[a] - 1) * std::cos(k * p.x[a]);
    sum.velocity += p.u[a] / sound_speed * std::sin(k * p.x[a]);
  }
  const double half = 0.5 * static_cast<double>(p.size());
  return {sum.density / half, sum.velocity / half};
}

TEST_CASE("density diffusion damps sound at the rate of the linear equations on the lattice", "[dispersion]") {
  Check check("wcsph_diffusion_decay", "Standing sound waves: decay by density diffusion",
              "$u = 10^{-6} c_0 \\sin kx$ on a square lattice in a periodic box, $\\delta = 0.1$, no viscosity. "
              "Density and velocity obey $\\dot r = -S u - \\delta c_0 h \\Lambda r$, $\\dot u = c_0^2 S r$ with the "
              "sums of the lattice, which the midpoint rule multiplies by one matrix each step: both amplitudes after "
              "many steps are known. $\\Lambda$ is of fourth order in $k$: long waves are not damped.");
  for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
    const bool spline = kernel == KernelName::cubic_spline;
    const double smoothing = spline ? 1.3 : 2.0;
    for (const int mode : {1, 2, 4}) {
      const double k = 2 * std::numbers::pi * mode;
      Particles particles = lattice(cells, rows, dx, 1);
      for (std::size_t a = 0; a < particles.size(); ++a) {
        particles.u[a] = mach * sound_speed * std::sin(k * particles.x[a]);
      }
      Flow flow(particles, dx,
                {.kernel = kernel,
                 .smoothing = smoothing,
                 .gravity = 0,
                 .density = 1,
                 .sound_speed = sound_speed,
                 .viscosity = Inviscid{},
                 .xsph = 0,
                 .density_diffusion = delta,
                 .period = {1, dx * rows}});
      const double step = 0.3 * dx / sound_speed;
      const long steps = std::lround(duration / step);
      const auto [first, second] =
          spline ? symbols<CubicSpline>(smoothing, k * dx) : symbols<WendlandC2>(smoothing, k * dx);
      const double symbol = first / dx, lambda = second / (dx * dx);
      const auto rate = [&](const Amplitudes& y) {
        return Amplitudes{
            -sound_speed * symbol * y.velocity - delta * sound_speed * smoothing * dx * lambda * y.density,
            sound_speed * symbol * y.density};
      };
      const auto moved = [](const Amplitudes& y, const Amplitudes& f, double tau) {
        return Amplitudes{y.density + tau * f.density, y.velocity + tau * f.velocity};
      };
      Amplitudes expected{0, mach};
      for (long n = 0; n < steps; ++n) {
        flow.advance(step);
        expected = moved(expected, rate(moved(expected, rate(expected), 0.5 * step)), step);
      }
      const Amplitudes found = of(flow, k);
      const double apart = std::hypot(found.density - expected.density, found.velocity - expected.velocity) / mach;
      check.holds(
          fmt::format("decay-{}-{}", name_of(kernel), mode) + ": The decay of sound agrees with the linear equations.",
          {apart},
          Bound{std::pow(2 * mach * k * sound_speed * duration, 2) + 1e-8,
                "((gamma + 1)/4 M k c_0 t)^2, the part returned by the second harmonic; 1e-8: densities of 1 are "
                "rounded some 500 times, 2e-16 sqrt(500) over 1e-6, and as much again"});
    }
  }
}

}  // namespace seiche::verification::wcsph_diffusion_decay_test
