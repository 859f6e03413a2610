#include "validation/instruments/plan/oblique_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seiche/exact/mach_reflection.hpp"
#include "seiche/require.hpp"

namespace seiche::validation {

using dispersive_shallow_water_2d::Flow;
using dispersive_shallow_water_2d::Velocity;

ObliqueWave::ObliqueWave(double amplitude, double angle, double crest)
    : amplitude_(amplitude), angle_(angle), crest_(crest), wave_(amplitude) {
  require_within("amplitude", amplitude, 1e-3, 0.8332);
  require_within("angle", angle, 0, 75 * std::numbers::pi / 180);
}

double ObliqueWave::phase(double x, double y, double time) const {
  return (x - crest_) * std::cos(angle_) - y * std::sin(angle_) - wave_.speed() * time;
}

Velocity ObliqueWave::velocity(double x, double y, double time) const {
  const double s = phase(x, y, time);
  const double eta = wave_.elevation(s);
  const double along = wave_.speed() * eta / (1 + eta);
  return {.u = along * std::cos(angle_),
          .v = -along * std::sin(angle_),
          .w = (along - wave_.speed()) * wave_.elevation_slope(s)};
}

double ObliqueWave::crest_at(double y, double time) const {
  return crest_ + (y * std::sin(angle_) + wave_.speed() * time) / std::cos(angle_);
}

double ObliqueWave::margin() const {
  const double decay = std::sqrt(3 * amplitude_ / (4 * (1 + amplitude_)));
  return std::log(4 * amplitude_ / 1e-5) / (2 * decay * std::cos(angle_));
}

namespace {

/// Largest tangent of the angle at which the stem's end leaves the wall; 0 without a stem.
double steepest_stem(const ObliqueWave& wave) {
  const double psi = wave.angle();
  if (!(psi > 0)) return 0;
  const exact::MachReflection theory(wave.amplitude(), psi, exact::MachReflection::Theory::kodama_yeh);
  if (!theory.has_stem()) return 0;
  const double speeds = std::sqrt((1 + wave.amplitude()) / (1 + theory.wall_ratio() * wave.amplitude()));
  return std::max(std::min(std::tan(theory.stem_angle()), (std::cos(psi) - speeds) / std::sin(psi)), 0.0);
}

/// About the reflected angle: the incident one, but at least that of resonance, where tan(psi)/cos(psi) = sqrt(3a).
double reflected_angle(const ObliqueWave& wave) {
  const double s = std::sqrt(3 * wave.amplitude());
  return std::max(wave.angle(), std::asin((std::sqrt(1 + 4 * s * s) - 1) / (2 * s)));
}

/// The smallest number from `cells` on without prime factors but 2, 3, 5 and 7: others make Fourier transforms slow.
std::size_t fast_from(std::size_t cells) {
  for (;; ++cells) {
    std::size_t rest = cells;
    for (const std::size_t factor : {2, 3, 5, 7}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return cells;
  }
}

/// By how much the first wave is stronger than the undisturbed one.
double strength(const ObliqueWave& wave, const ReflectionWindow& window, double y) {
  const double distance = y / (6 * wave.width_unit());
  return 1 + window.excess * std::exp(-distance * distance);
}

/// Cells that fill a length, in a number that suits Fourier transforms.
std::size_t cells(double length, double spacing) {
  return fast_from(std::max<std::size_t>(static_cast<std::size_t>(std::ceil(length / spacing)), 4));
}

}  // namespace

ReflectionWindow window_until(double time, const ObliqueWave& wave, double spacing) {
  constexpr double longest = 30;
  constexpr double shortest = 17;
  const double unit = wave.width_unit();
  const double slope = std::tan(reflected_angle(wave));
  const double leaving = 36 * slope - 10;
  const bool steep = leaving >= shortest;
  const double beyond = steep ? 36 : 46;
  const double path = wave.crest_at(0, time) - wave.crest_at(0, 0);
  ReflectionWindow window{.spacing = spacing, .height = path * steepest_stem(wave) + beyond * unit, .rear = 0};
  const double past_corner = std::min(window.height / unit * slope + 6, 2 * beyond * slope - 8);
  window.rear = unit * (steep ? std::min(leaving, longest) : std::max(past_corner, shortest));
  return window;
}

PlanReflection plan_reflection(const ObliqueWave& wave, const ReflectionWindow& window) {
  require_positive("spacing", window.spacing);
  require_positive("height", window.height);
  require_positive("rear", window.rear);
  const std::size_t rows = cells(window.height, window.spacing);
  const double north = static_cast<double>(rows) * window.spacing;
  const double front = wave.crest_at(north, 0) - wave.crest_at(0, 0) + wave.margin();
  const std::size_t columns = cells(window.rear + front + window.spacing, window.spacing);
  const double begin = wave.crest_at(0, 0) - window.rear;
  return {
      .water = {.begin = begin,
                .end = begin + static_cast<double>(columns) * window.spacing,
                .north = north,
                .columns = columns,
                .rows = rows,
                .elevation = [=](double x, double y) { return strength(wave, window, y) * wave.elevation(x, y, 0); },
                .sides = {.west = plan_lattice::WallSide{},
                          .east = plan_lattice::WallSide{},
                          .south = plan_lattice::WallSide{},
                          .north = plan_lattice::DrivenSide{[wave](plan_lattice::Place at, double time) {
                            const Velocity given = wave.velocity(at.x, at.y, time);
                            return Point{given.u, given.v};
                          }}}},
      .velocity =
          [=](double x, double y) {
            const double factor = strength(wave, window, y);
            const Velocity undisturbed = wave.velocity(x, y, 0);
            return Velocity{factor * undisturbed.u, factor * undisturbed.v, factor * undisturbed.w};
          },
      .window = {.reach = [=](double time) { return wave.crest_at(0, time) + front; }}};
}

Flow reflection_flow(const ObliqueWave& wave, const ReflectionWindow& window,
                     dispersive_shallow_water_2d::Settings settings, dispersive_shallow_water_2d::Scheme scheme) {
  const PlanReflection made_of = plan_reflection(wave, window);
  return Flow(rectangular_lattice(made_of.water), made_of.velocity, scheme, settings, {}, made_of.window);
}

lagrangian_mesh_3d::Layer layers_of(const dispersive_shallow_water_2d::Rectangle& water, std::size_t layers) {
  return {.begin = water.begin,
          .end = water.end,
          .south = water.south,
          .north = water.north,
          .depth = water.depth,
          .columns = water.columns,
          .rows = water.rows,
          .layers = layers,
          .elevation = water.elevation,
          .sides = water.sides};
}

lagrangian_mesh_3d::VelocityAt layered(const dispersive_shallow_water_2d::VelocityAt& of_columns,
                                       const dispersive_shallow_water_2d::Rectangle& water) {
  return [of_columns, elevation = water.elevation](plan_lattice::Place at) {
    const Velocity top = of_columns(at.x, at.y);
    return lagrangian_mesh_3d::Vector{top.u, top.v, (1 + at.z) / (1 + elevation(at.x, at.y)) * top.w};
  };
}

LayeredReflection layered_reflection(const ObliqueWave& wave, const ReflectionWindow& window, std::size_t layers) {
  const PlanReflection seen_from_above = plan_reflection(wave, window);
  return {.water = layers_of(seen_from_above.water, layers),
          .velocity = layered(seen_from_above.velocity, seen_from_above.water),
          .window = seen_from_above.window};
}

lagrangian_mesh_3d::Flow layered_reflection_flow(const ObliqueWave& wave, const ReflectionWindow& window,
                                                 std::size_t layers, lagrangian_mesh_3d::Settings settings,
                                                 lagrangian_mesh_3d::Scheme scheme) {
  const LayeredReflection made_of = layered_reflection(wave, window, layers);
  return lagrangian_mesh_3d::Flow(layer_mesh(made_of.water), made_of.velocity, scheme, settings, made_of.window);
}

SurfaceLattice surface_of(const Flow& flow) {
  return {.columns = flow.shape().columns, .rows = flow.shape().rows, .x = flow.x(), .y = flow.y(), .z = flow.z()};
}

SurfaceLattice surface_of(const lagrangian_mesh_3d::Flow& flow) {
  return {.columns = flow.shape().columns,
          .rows = flow.shape().rows,
          .x = flow.surface_x(),
          .y = flow.surface_y(),
          .z = flow.surface_z()};
}

}  // namespace seiche::validation
