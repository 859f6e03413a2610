// What weakly compressible SPH needs of memory: as much as its arrays, and nothing twice.
#include <cstddef>
#include <string>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "verification/check.hpp"
#include "verification/live_memory.hpp"

namespace seiche::verification::wcsph_memory_test {

using namespace wcsph;

/// Bytes per particle after some steps of a column in a tank that is mostly empty.
double memory_of(Settings settings, double& particles) {
  settings.sound_speed = 30;
  const Scene scene =
      dam_break({.width = 1, .height = 1, .tank_length = 4, .wall_height = 2, .spacing = 1.0 / 200}, settings);
  particles = static_cast<double>(scene.particles.size());
  const double before = verification::live_bytes();
  Flow flow(scene.particles, scene.spacing, settings);
  for (int step = 0; step < 3; ++step) flow.advance(flow.stable_step());
  return (verification::live_bytes() - before) / particles;
}

TEST_CASE("the memory of SPH is the sum of its arrays", "[robustness]") {
  Check check("wcsph_memory", "Weakly compressible SPH: memory",
              "Memory per particle of a dam break in a large tank after three steps. Needed are, in bytes: the "
              "particle 57; rates 40; its record, as neighbours read it, 64; with eddies stresses 32. Clusters of as "
              "many particles as a register has lanes share 40 and a list of candidates at 4, about 45 beside eight "
              "particles.");
  const auto lanes = static_cast<double>(pair_loops(KernelName::cubic_spline, 8).lanes);
  for (const bool eddies : {false, true}) {
    Settings settings;
    if (eddies) settings.viscosity = LaminarSps{};
    double particles = 0;
    const double measured = memory_of(settings, particles);
    check.holds(std::string(eddies ? "with" : "without") + " eddies: A flow holds no more than its arrays.", {measured},
                Bound{1.06 * (57 + 40 + 64 + (eddies ? 32 : 0) + (40 + 4 * 45) / lanes),
                      "the sum above; a few per cent of room at the end of lists"});
  }
}

}  // namespace seiche::verification::wcsph_memory_test
