#include "validation/breaking/sph_plunging.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "validation/instruments/sph_free_surface.hpp"
#include "validation/instruments/sph_front.hpp"
#include "validation/studies/wcsph/kept_flow.hpp"

namespace seiche::validation {
namespace {

wcsph::Scene scene_of(const SphPlunging& setup) {
  const double spacing = setup.depth / static_cast<double>(setup.layers);
  return wcsph::flume({.length = spacing * std::round(setup.flume * setup.wavelength / spacing),
                       .depth = setup.depth,
                       .paddle_height = 4 * setup.depth,
                       .stroke = setup.stroke,
                       .frequency = 2 * std::numbers::pi / setup.period,
                       .spacing = spacing,
                       .lattice = setup.lattice,
                       .paddle_rows = 3},
                      setup.settings);
}

/// The second wave is looked for from where a flap that leans forward does not reach, to halfway between it and the
/// first one, which is a wavelength ahead and leaves the flap at the beginning. In wavelengths.
constexpr double first_seen = 0.25;
constexpr double behind_first = 0.55;

/// What is seen of the second wave at one instant.
void watch(SphPlunged& result, const wcsph::Flow& flow, const SphPlunging& setup, const wcsph::Scene& scene) {
  wcsph::Box basin = wcsph::unbounded;
  basin.bottom = scene.bottom;
  basin.right = scene.far_wall;
  const wcsph::VolumeFraction fraction(flow.particles(), flow.smoothing_length(), basin, setup.settings.kernel);
  const double phase = flow.time() / setup.period;
  const wcsph::Box window{first_seen * setup.wavelength, (phase - behind_first) * setup.wavelength,
                          flow.smoothing_length(), 4 * setup.depth};
  const auto curves = wcsph::free_surface(fraction, window, 0.5 * flow.spacing());
  const double least = 2 * flow.spacing();
  const double hole = 4 * flow.spacing() * flow.spacing();
  const wcsph::Contour* surface = wcsph::main_surface(curves);
  if (surface == nullptr) return;
  const wcsph::Overhang jet = wcsph::overhang(*surface);
  const bool hangs = jet.extent > least && jet.towards_right;
  if (std::isnan(result.hangs_over) && hangs) result.hangs_over = phase;
  if (std::isnan(result.hangs_over)) return;
  if (wcsph::touches_down(curves, hole)) {
    if (std::isnan(result.touches)) result.touches = phase;
    result.cavity.add(wcsph::cavity_area(curves, hole), phase);
  } else if (hangs && std::isnan(result.touches)) {
    result.jet_time.push_back(flow.time());
    result.jet_x.push_back(jet.tip.x);
    result.jet_z.push_back(jet.tip.z);
  }
}

}  // namespace

void exchange(Tape& tape, SphPlunged& r) {
  tape(r.spacing, r.particles, r.steps, r.lost, r.frames, r.crest, r.speed, r.hangs_over, r.touches, r.cavity,
       r.jet_time, r.jet_x, r.jet_z, r.extremes);
}

SphPlunged plunge(const SphPlunging& setup, const std::vector<double>& frames, Part part) {
  wcsph::Scene scene = scene_of(setup);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, setup.settings, scene.paddles);
  SphPlunged result{.spacing = scene.spacing, .particles = flow.particles().size()};
  constexpr double per_period = 100;
  std::size_t next = 0;
  long n = std::lround(per_period);
  const auto state = [&](Tape& tape) { tape(n, next, result, flow); };
  for (part.resume(state); next < frames.size(); ++n) {
    part.keep(state);
    const double phase = static_cast<double>(n) / per_period;
    march(flow, setup.period * phase);
    watch(result, flow, setup, scene);
    if (phase < frames[next] - 1e-9) continue;
    ++next;
    const wcsph::Particles& p = flow.particles();
    result.frames.push_back(p);
    result.crest.push_back(wcsph::column_height(p, flow.smoothing_length(), first_seen * setup.wavelength,
                                                (frames[next - 1] - behind_first) * setup.wavelength) -
                           scene.bottom);
    Largest fastest;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.kind[i] == wcsph::Kind::fluid) fastest.add(std::hypot(p.u[i], p.w[i]));
    }
    result.speed.push_back(fastest.value());
  }
  result.steps = flow.steps();
  result.lost =
      flow.outside(scene.extents.left, scene.extents.right, scene.extents.bottom, std::numeric_limits<double>::max());
  result.extremes = flow.extremes();
  return result;
}

}  // namespace seiche::validation
