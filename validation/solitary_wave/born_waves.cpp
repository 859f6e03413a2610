#include "validation/solitary_wave/born_waves.hpp"

#include <cmath>

#include "seiche/exact/solitary_asymptotic.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"

namespace seiche::validation {

using exact::LaitoneSolitary;
using exact::SolitaryWave;
using lagrangian_mesh_2d::Settings;

lagrangian_mesh_2d::Flow raised(const Hump& hump, const MeshResolution& mesh, double hourglass) {
  lagrangian_mesh_2d::Layer layer = tank(birth_tank, 1, mesh);
  layer.elevation = [&](double x) {
    const double s = 1 / std::cosh(x / hump.width);
    return hump.height * s * s;
  };
  return lagrangian_mesh_2d::Flow(layer_mesh(layer), {}, {}, Settings{.hourglass = hourglass});
}

Born follow(lagrangian_mesh_2d::Flow& flow, double tau, const std::function<void()>& after_step) {
  Born born{.track = follow_crest(flow, birth_duration, tau, after_step)};
  born.amplitude = born.track.mean_elevation(birth_separated);
  born.speed = born.track.speed(birth_separated);
  const SolitaryWave exact(born.end_amplitude());
  const LaitoneSolitary laitone(born.end_amplitude());
  const double crest = born.track.place.back();
  born.from_exact = largest_profile_error(flow, crest, birth_reach, [&](double s) { return exact.elevation(s); });
  born.from_laitone = largest_profile_error(flow, crest, birth_reach, [&](double s) { return laitone.elevation(s); });
  return born;
}

}  // namespace seiche::validation
