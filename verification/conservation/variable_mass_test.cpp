// Particles of variable mass: neutral exchanges.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"

namespace seiche::verification::variable_mass_test {

using namespace free_lagrangian;
using namespace variable_mass;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 5.3";

TEST_CASE("masses exchanged between moving bodies leave mass, momentum and kinetic energy alone", "[conservation]") {
  Check check("variable_mass_exchanges", "Finite exchanges of mass are neutral",
              "64 bodies of masses between 1 and 3 and random velocities exchange masses, up to a tenth of their own, "
              "in a thousand rounds of 100 exchanges. Velocities change by the convective term alone.",
              source);
  Noise noise(7);
  constexpr std::size_t n = 64, rounds = 1000;
  std::vector<double> mass, u;
  for (std::size_t k = 0; k < n; ++k) mass.push_back(2 + noise());
  for (std::size_t k = 0; k < 2 * n; ++k) u.push_back(noise());
  const std::vector<double> zeros(n, 0.0);
  const auto sums = [&] {
    std::array<CompensatedSum, 4> all;
    for (std::size_t k = 0; k < n; ++k) {
      all[0].add(mass[k]);
      all[1].add(mass[k] * u[k]);
      all[2].add(mass[k] * u[n + k]);
      all[3].add(mass[k] * (u[k] * u[k] + u[n + k] * u[n + k]) / 2);
    }
    return std::array{all[0].value(), all[1].value(), all[2].value(), all[3].value()};
  };
  const auto first = sums();
  Convection convection;
  std::vector<double> mean = u, next;
  Worst handed_on;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<Exchange> exchanges;
    for (int e = 0; e < 100; ++e) {
      const auto i = static_cast<std::size_t>(n * 0.5 * (noise() + 1)) % n;
      const auto j = static_cast<std::size_t>(n * 0.5 * (noise() + 1)) % n;
      const double least = std::min(mass[i], mass[j]);
      if (i != j) exchanges.push_back({static_cast<int>(i), static_cast<int>(j), 0.1 * least * noise()});
    }
    convection.begin(mass, exchanges, {zeros, zeros});
    const auto respond = [&](std::span<double> momenta) {
      for (std::size_t i = 0; i < 2 * n; ++i) momenta[i] /= convection.mean_masses()[i % n];
    };
    convection.settle(u, respond, 0, mean);
    convection.finish(u, mean, next);
    for (std::size_t k = 0; k < n; ++k) handed_on.add(convection.next_masses()[k] / mass[k] - 1);
    u = next;
    mass.assign(convection.next_masses().begin(), convection.next_masses().end());
  }
  const auto last = sums();
  const auto keeps = [&](const std::string& text, double defect, double scale) {
    check.holds(text, {defect},
                Roundoff{rounds * 264.0, scale,
                         "each round rounds 64 bodies and 200 sides of exchanges, of this size at most: masses to 10, "
                         "momenta to 10, energies to 5"});
  };
  keeps("Mass is conserved by the exchanges to round-off.", last[0] - first[0], 10);
  keeps("Momentum along x is conserved by the exchanges to round-off.", last[1] - first[1], 10);
  keeps("Momentum along y is conserved by the exchanges to round-off.", last[2] - first[2], 10);
  keeps("Kinetic energy is conserved by the exchanges to round-off.", last[3] - first[3], 5);
  check.that("finite", "The largest change of a mass in a round exceeds a tenth.",
             "largest change of a mass in a round, relative", {std::abs(handed_on.value()) > 0.1 ? 1.0 : 0.0},
             Qualitative{"more than a tenth", "neutrality to first order in small exchanges would not be enough"});
}

}  // namespace seiche::verification::variable_mass_test
