#include "validation/studies/wcsph/particle_frames.hpp"

#include "seiche/models/wcsph/settings.hpp"

namespace seiche::validation {

void add_particles(evidence::Exhibit& exhibit, double time, const wcsph::Particles& particles,
                   const wcsph::Settings& settings) {
  const wcsph::TaitFluid fluid(settings.density, settings.sound_speed);
  std::vector<double> pressure, identity, kind;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    pressure.push_back(fluid.pressure(particles.density[i]));
    identity.push_back(static_cast<double>(particles.identity[i]));
    kind.push_back(static_cast<double>(particles.kind[i]));
  }
  exhibit.snapshot({.time = time,
                    .x = {particles.x.begin(), particles.x.end()},
                    .z = {particles.z.begin(), particles.z.end()},
                    .unit = "m",
                    .fields = {{"u", "m/s", {particles.u.begin(), particles.u.end()}},
                               {"w", "m/s", {particles.w.begin(), particles.w.end()}},
                               {"density", "kg/m^3", {particles.density.begin(), particles.density.end()}},
                               {"pressure", "Pa", pressure},
                               {"identity", "1", identity},
                               {"kind", "1", kind}},
                    .joined = false});
}

}  // namespace seiche::validation
