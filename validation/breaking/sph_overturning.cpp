#include "validation/breaking/sph_overturning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/dispersion.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/sph_steep_wave.hpp"
#include "validation/studies/wcsph/kept_flow.hpp"
#include "validation/studies/wcsph/speed_field.hpp"

namespace seiche::validation {
namespace {

using wcsph::Contour;

wcsph::VolumeFraction fraction_of(const wcsph::Flow& flow, const SphOverturning& setup) {
  wcsph::Box basin = wcsph::unbounded;
  basin.bottom = 0;
  return {flow.particles(), flow.smoothing_length(), basin, setup.settings.kernel, {.x = setup.wave.wavelength}};
}

/// Energy above that of still water.
double wave_energy(const wcsph::Flow& flow, const SteepWave& wave) {
  const wcsph::Totals totals = flow.totals();
  return totals.energy() - 0.5 * totals.mass * wave.gravity * wave.depth;
}

wcsph::Scene scene_of(const SphOverturning& setup) {
  const SteepWave& wave = setup.wave;
  const SteepWaveStart start(wave.amplitude, wave.wavelength, wave.depth, wave.gravity);
  const auto pressure = [&](double x, double z) {
    return setup.settings.density * start.pressure_over_density(x, z - wave.depth);
  };
  wcsph::Scene scene = wcsph::periodic_layer({.period = wave.wavelength,
                                              .depth = wave.depth,
                                              .elevation = [&](double x) { return start.elevation(x); },
                                              .velocity =
                                                  [&](double x, double z) {
                                                    const auto [u, w] = start.velocity(x, z - wave.depth);
                                                    return wcsph::Velocity{u, w};
                                                  },
                                              .pressure = pressure,
                                              .spacing = setup.spacing()},
                                             setup.settings);
  const wcsph::TaitFluid fluid(setup.settings.density, setup.settings.sound_speed);
  wcsph::Particles& p = scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.kind[i] == wcsph::Kind::wall) p.density[i] = fluid.density_at(pressure(p.x[i], p.z[i]));
  }
  return scene;
}

}  // namespace

double SteepWave::period() const {
  return 2 * std::numbers::pi / exact::AiryDispersion(gravity, depth).frequency(2 * std::numbers::pi / wavelength);
}

exact::OverturningWave SteepWave::exact(std::size_t markers, double last_phase) const {
  return exact::OverturningWave({.amplitude = amplitude,
                                 .wavelength = wavelength,
                                 .depth = depth,
                                 .gravity = gravity,
                                 .markers = markers,
                                 .last_time = last_phase * period()});
}

const std::array<Instant, 5> overturning_instants{{{"half", "halfway to a vertical front"},
                                                   {"steep", "with a steep front"},
                                                   {"vertical", "with a vertical front"},
                                                   {"turning", "halfway from a vertical front to a developed jet"},
                                                   {"jet", "with a developed jet"}}};

std::vector<double> times_of(const exact::OverturningWave& wave) {
  const double vertical = wave.vertical_tangent_time().value_or(wave.end_time());
  const double jet = std::min(wave.well_resolved_until(), wave.end_time());
  return {0.5 * vertical, 0.8 * vertical, vertical, 0.5 * (vertical + jet), jet};
}

Polyline moved(Polyline curve, double by) {
  for (double& x : curve.x) x += by;
  return curve;
}

void exchange(Tape& tape, Polyline& line) {
  tape(line.x, line.y);
}

void exchange(Tape& tape, SphOverturned& r) {
  tape(r.spacing, r.particles, r.steps, r.times, r.surfaces, r.speed, r.snapshots, r.kinetic, r.energy, r.level,
       r.hangs_over, r.touches, r.cavity, r.breaks_up, r.extremes);
}

SphOverturned overturn(const SphOverturning& setup, const std::vector<double>& times, double overhang, long watched,
                       Part part, bool landed) {
  wcsph::Scene scene = scene_of(setup);
  wcsph::Settings settings = setup.settings;
  settings.period = scene.period;
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, settings, scene.paddles);
  SphOverturned result{.spacing = scene.spacing, .particles = flow.particles().count(wcsph::Kind::fluid)};
  const SteepWave& wave = setup.wave;
  const double phase_speed =
      exact::AiryDispersion(wave.gravity, wave.depth).phase_speed(2 * std::numbers::pi / wave.wavelength);
  const double first_energy = wave_energy(flow, wave);
  const double interval = times.back() / static_cast<double>(watched);
  const double hole = 4 * scene.spacing * scene.spacing;
  const auto look = [&] {
    // A window of one wavelength that begins in the trough behind the crest, which runs with the linear wave.
    const double left = phase_speed * flow.time() - 0.5 * wave.wavelength;
    const wcsph::Box window{left, left + wave.wavelength, flow.smoothing_length(), wave.depth + 4 * wave.amplitude};
    const std::vector<Contour> curves = wcsph::free_surface(fraction_of(flow, setup), window, 0.5 * flow.spacing());
    if (std::isnan(result.hangs_over) && wcsph::overturns(curves, overhang)) result.hangs_over = flow.time();
    if (std::isnan(result.touches) && !std::isnan(result.hangs_over) && wcsph::touches_down(curves, hole)) {
      result.touches = flow.time();
      result.cavity = wcsph::cavity_area(curves, hole);
    }
    return curves;
  };
  std::size_t next = 0;
  long n = 0;
  const auto state = [&](Tape& tape) { tape(n, next, result, flow); };
  try {
    for (part.resume(state); n <= watched; ++n) {
      part.keep(state);
      const double watch = static_cast<double>(n) * interval;
      for (; next < times.size() && times[next] <= watch + 1e-9 * interval; ++next) {
        march(flow, times[next]);
        const std::vector<Contour> curves = look();
        const Contour* main = wcsph::main_surface(curves);
        if (main == nullptr || main->x.size() < 2)
          throw std::runtime_error(fmt::format("no water surface at t = {:g} s", flow.time()));
        Polylines surface{{main->x, main->z}};
        for (double& y : surface.front().y) y -= wave.depth;
        result.times.push_back(times[next]);
        result.surfaces.push_back(std::move(surface));
        result.speed.push_back(fastest(flow.particles()));
        result.snapshots.push_back(flow.particles());
        result.kinetic.push_back(flow.totals().kinetic / setup.settings.density);
        result.energy.push_back(wave_energy(flow, wave) / first_energy);
        result.level.push_back(fraction_of(flow, setup).mean_elevation(0, wave.wavelength).value_or(nan) - wave.depth);
      }
      if (watch > flow.time()) march(flow, watch);
      look();
      if (!landed && next + 1 >= times.size() && std::isfinite(result.touches)) break;
    }
  } catch (const Divergence& failure) {
    if (landed || next + 1 < times.size()) throw;
    result.breaks_up = failure.time();
  }
  result.steps = flow.steps();
  result.extremes = flow.extremes();
  return result;
}

Polylines exact_surface(const exact::OverturningWave& wave, double time, std::size_t points) {
  auto profile = wave.profile(time, points);
  return {{std::move(profile.x), std::move(profile.y)}};
}

evidence::Panel& draw_beside_images(evidence::Figure& figure, const std::string& title, const Polyline& exact,
                                    const Polyline& surface) {
  evidence::Axes axes{.x = "x [m]", .y = "z [m]", .title = title, .equal_aspect = true};
  axes.x_min = surface.x.front();
  axes.x_max = surface.x.back();
  auto& panel = figure.panel(axes);
  for (const double image : {-1.0, 0.0, 1.0}) {
    panel.line("potential flow", moved(exact, image).x, exact.y, evidence::Role::exact);
  }
  return panel;
}

double exact_overhang_time(const exact::OverturningWave& wave, double overhang, double end) {
  const auto hangs = [&](double time) {
    auto profile = wave.profile(time, 2001);
    return wcsph::overhang({.x = std::move(profile.x), .z = std::move(profile.y)}).extent >= overhang;
  };
  double before = 0;
  double after = end;
  if (!hangs(after)) return nan;
  for (int halving = 0; halving < 24; ++halving) {
    const double middle = 0.5 * (before + after);
    (hangs(middle) ? after : before) = middle;
  }
  return after;
}

}  // namespace seiche::validation
