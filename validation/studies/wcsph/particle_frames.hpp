/// Particles in a record, which ParaView opens through its .xdmf file: velocities u and w, density, pressure, number of
/// the particle, kind (0 fluid, 1 wall, 2 paddle).
#pragma once

#include "reports/evidence/record.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {

inline void add_particles(evidence::Exhibit& exhibit, double time, const wcsph::Particles& particles,
                          const wcsph::Settings& settings) {
  const wcsph::TaitFluid fluid(settings.density, settings.sound_speed);
  const auto number = [](auto of) { return static_cast<double>(of); };
  exhibit.snapshot(
      {.time = time,
       .x = {particles.x.begin(), particles.x.end()},
       .z = {particles.z.begin(), particles.z.end()},
       .unit = "m",
       .fields = {{"u", "m/s", {particles.u.begin(), particles.u.end()}},
                  {"w", "m/s", {particles.w.begin(), particles.w.end()}},
                  {"density", "kg/m^3", {particles.density.begin(), particles.density.end()}},
                  {"pressure", "Pa", each(particles.density, [&](double density) { return fluid.pressure(density); })},
                  {"identity", "1", each(particles.identity, number)},
                  {"kind", "1", each(particles.kind, number)}},
       .joined = false});
}

}  // namespace seiche::validation
