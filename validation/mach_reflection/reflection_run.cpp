#include "validation/mach_reflection/reflection_run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/mach_reflection.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

constexpr double between_heights = 2.5;  // time between two values of a_w
constexpr long patterns = 20;            // in the last two fifths, for the path of the stem's end

double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Throws Divergence where the lattice shows no pattern.
ReflectionPattern pattern_of(const SurfaceLattice& surface, const ReflectionRun& run, double time, long step) {
  try {
    return measured_reflection(surface, run.amplitude);
  } catch (const std::runtime_error& missing) {
    throw Divergence(fmt::format("{} (the spacing h = {:g} may be too long)", missing.what(), run.spacing), time, step,
                     wall_crest(surface, 0.5 * run.amplitude).x);
  }
}

template <class Flow>
Reflection follow(Flow flow, const ReflectionRun& run) {
  Reflection result{.run = run};
  const double begin = thread_seconds();
  const double end = run.duration();
  const long steps = std::max(1L, std::lround(std::ceil(end / run.tau() - 1e-9)));
  const double tau = end / static_cast<double>(steps);
  const long every = std::max(1L, std::lround(between_heights / tau));
  const long every_pattern = std::max(1L, 2 * steps / 5 / patterns);
  std::vector<double> wall_x, stem_length;
  // The height that the nodes show changes as the crest passes between them: a mean over several steps.
  double heights = 0;
  double times = 0;
  long summed = 0;
  Largest tallest;
  Smallest lowest;
  for (long step = 1; step <= steps; ++step) {
    flow.advance(tau);
    const SurfaceLattice now = surface_of(flow);
    const double height = five_node_height(now, wall_crest(now, 0.5 * run.amplitude), 0);
    heights += height;
    tallest.add(height);
    lowest.add(height);
    times += flow.time();
    ++summed;
    if (step % every == 0 || step == steps) {
      result.time.push_back(times / static_cast<double>(summed));
      result.wall.push_back(heights / static_cast<double>(summed));
      if (summed == every) result.ripple = 0.5 * (tallest.value() - lowest.value());
      heights = times = 0;
      summed = 0;
      tallest = {};
      lowest = {};
    }
    if ((steps - step) % every_pattern == 0 && 5 * (steps - step) <= 2 * steps) {
      result.pattern = pattern_of(now, run, flow.time(), step);
      wall_x.push_back(result.pattern.wall.x);
      stem_length.push_back(result.pattern.stem_length.value);
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  result.surface = part_of(surface_of(flow), {-infinity, infinity, infinity}, result.pattern.wall.x);
  result.limit = wall_limit(result.time, result.wall, run.settling_rate());
  result.stem = stem_angle(wall_x, stem_length);
  result.worst_corner = flow.worst_corner().shape;
  result.cells = flow.model().constraints();
  const auto& solver = flow.model().solver();
  result.iterations = static_cast<double>(solver.iterations()) / static_cast<double>(std::max(solver.solutions(), 1L));
  result.seconds = thread_seconds() - begin;
  return result;
}

}  // namespace

WaveModel wave_model_named(std::string_view name) {
  return value_named<WaveModel>("model", name, {{"plan", WaveModel::plan}, {"hexahedra", WaveModel::hexahedra}});
}

std::string id_of(double number) {
  std::string id = fmt::format("{:g}", number);
  std::replace(id.begin(), id.end(), '.', '_');
  return id;
}

double ReflectionRun::settling_rate() const {
  const double kappa = kappa_finite_angle();
  return std::pow(3 * amplitude, 1.5) / 3 * kappa * std::abs(1 - kappa);
}

double ReflectionRun::settled_time() const {
  const double kappa = kappa_finite_angle();
  const double settling = 3 / (std::pow(3 * amplitude, 1.5) * kappa * std::max(std::abs(1 - kappa), 0.03));
  return 250 * std::sqrt(0.3 / amplitude) + 4 * settling;
}

std::string ReflectionRun::resolution() const {
  return fmt::format("{}h = {:g}, tau = {:g}, t = {:.0f}",
                     model == WaveModel::plan ? "" : fmt::format("{} layers, ", layers), spacing, tau(), duration());
}

evidence::Measurement Reflection::wall_ratio() const {
  const evidence::Measurement end{.value = wall.back(), .uncertainty = ripple};
  return quotient(end, pattern.incident_amplitude, run.resolution());
}

evidence::Measurement Reflection::reflected_ratio() const {
  if (!pattern.reflected) return {.resolution = run.resolution()};
  return quotient(pattern.reflected->amplitude, pattern.incident_amplitude, run.resolution());
}

evidence::Measurement Reflection::reflected_angle() const {
  if (!pattern.reflected) return {.resolution = run.resolution()};
  const evidence::Measurement& angle = pattern.reflected->angle;
  return {.value = degrees(angle.value), .uncertainty = degrees(angle.half_width()), .resolution = run.resolution()};
}

Reflection reflect(const ReflectionRun& run) {
  require_positive("spacing", run.spacing);
  require_within("time", run.time, 0, 1e6);
  const ObliqueWave wave(run.amplitude, run.angle);
  ReflectionWindow window = window_until(run.duration(), wave, run.spacing);
  if (run.height > 0) window.height = run.height;
  window.excess = run.excess;
  if (run.model == WaveModel::hexahedra) {
    return follow(layered_reflection_flow(wave, window, run.layers, {.tolerance = run.tolerance}), run);
  }
  return follow(reflection_flow(wave, window, {.tolerance = run.tolerance}), run);
}

void exchange(Tape& tape, Measurement& m) {
  tape(m.value, m.uncertainty, m.resolution, m.where, m.told);
}
void exchange(Tape& tape, ReflectedCrest& crest) {
  tape(crest.amplitude, crest.angle, crest.line, crest.crests);
}
void exchange(Tape& tape, ReflectionPattern& p) {
  tape(p.wall_amplitude, p.wall, p.incident_amplitude, p.incident_angle, p.incident_line, p.incident, p.stem_length,
       p.reflected);
}
void exchange(Tape& tape, SurfacePart& surface) {
  tape(surface.columns, surface.rows, surface.x, surface.y, surface.z);
}
void exchange(Tape& tape, WallLimit& limit) {
  tape(limit.amplitude, limit.growth, limit.exponential, limit.algebraic);
}
void exchange(Tape& tape, Reflection& r) {
  tape(r.run, r.time, r.wall, r.ripple, r.pattern, r.surface, r.limit, r.stem, r.worst_corner, r.cells, r.iterations,
       r.seconds);
}

Reflection reflect_as_part(const Run& run, const ReflectionRun& what) {
  const std::string every_number =
      fmt::format("{} {} a {} psi {} h {} tau {} t {} height {} tolerance {} excess {}",
                  what.model == WaveModel::plan ? "plan" : "hexahedra", what.layers, what.amplitude, what.angle,
                  what.spacing, what.tau(), what.duration(), what.height, what.tolerance, what.excess);
  return run.part(every_number).result<Reflection>([&] { return reflect(what); });
}

}  // namespace seiche::validation
