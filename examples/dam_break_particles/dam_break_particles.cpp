// A dam breaks, by weakly compressible SPH: the front against time as CSV, and all particles for ParaView.
#include <algorithm>
#include <cstdio>

#include <seiche/models/wcsph/flow.hpp>
#include <seiche/models/wcsph/particle_file.hpp>
#include <seiche/models/wcsph/scene.hpp>

int main() {
  using namespace seiche::wcsph;

  // Martin and Moyce (1952): a column of width a and height 2a in a tank of length 4a.
  constexpr double a = 0.057;
  const Settings settings{.sound_speed = sound_speed_for(9.81, 4 * a), .viscosity = ArtificialViscosity{0.3}};
  const Scene dam = dam_break(
      {.width = a, .height = 2 * a, .tank_length = 4 * a, .wall_height = 3.5 * a, .spacing = a / 25}, settings);
  Flow flow(dam.particles, dam.spacing, settings);

  ParticleFile file("dam_break_particles");
  std::puts("t,front,kinetic_energy");
  for (int k = 0; k <= 16; ++k) {
    seiche::march(flow, 0.01 * k);
    file.frame(flow.time(), flow.particles(), flow.pressure());
    const Particles& now = flow.particles();
    double front = dam.rear_wall;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now.kind[i] == Kind::fluid) front = std::max(front, now.x[i]);
    }
    std::printf("%g,%.5g,%.6g\n", flow.time(), front - dam.rear_wall, flow.totals().kinetic);
  }
  file.close();
}
