/// What Flow refuses to start from; internal to Flow. All throw std::invalid_argument.
#pragma once

#include <cstddef>
#include <span>

#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/paddle.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::wcsph {

/// Arrays of one length, values finite, masses and densities positive, carriers that exist and can be asked.
void check_particles(const Particles& particles, std::span<const Paddle> paddles);
/// A period of at least three supports with their reserve: a particle meets one image of another at most.
void check_period(const Settings& settings, double smoothing_length);
/// No two fluid particles in one place, none in a wall.
void check_distances(const Particles& particles, std::span<const Image> images, std::span<const Cluster> clusters,
                     double spacing);

}  // namespace seiche::wcsph
