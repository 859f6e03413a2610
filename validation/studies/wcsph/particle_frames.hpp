/// Particles in a record, which ParaView opens through its .xdmf file: velocities u and w, density, pressure, number of
/// the particle, kind (0 fluid, 1 wall, 2 paddle).
#pragma once

#include "reports/evidence/record.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::validation {

void add_particles(evidence::Exhibit& exhibit, double time, const wcsph::Particles& particles,
                   const wcsph::Settings& settings);

}  // namespace seiche::validation
