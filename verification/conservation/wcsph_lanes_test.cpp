// The pair loops of weakly compressible SPH exist for several widths of registers: all give the rates of plain sums.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/equation_of_state.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "verification/check.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace {

using namespace seiche::wcsph;
using namespace seiche::verification;
using seiche::evidence::Bound;

constexpr double spacing = 0.1;

/// Rates of a free blob by one version of the loops, with every particle a candidate of every cluster.
Rates rates_by(const PairLoops& loops, const Particles& blob, const Settings& settings) {
  const TaitFluid water(settings.density, settings.sound_speed, settings.exponent);
  const std::size_t count = blob.size();
  const std::size_t padded = count + most_lanes;
  const auto* const artificial = std::get_if<ArtificialViscosity>(&settings.viscosity);
  const auto* const eddies = std::get_if<LaminarSps>(&settings.viscosity);
  const double sound_scale = artificial != nullptr ? -0.5 * artificial->alpha : 1;
  std::vector<Record> records(
      padded, Record{.x = 1e30, .z = 1e30, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0});
  std::vector<double> mass = blob.mass;
  mass.resize(padded);
  std::vector<Stress> stress(padded);
  for (std::size_t a = 0; a < count; ++a) {
    const double density = blob.density[a];
    records[a] = {.x = blob.x[a],
                  .z = blob.z[a],
                  .u = blob.u[a],
                  .w = blob.w[a],
                  .density = density,
                  .pressure = water.pressure(density) / (density * density),
                  .smoothing = settings.smoothing * spacing * std::sqrt(settings.density / density),
                  .sound = sound_scale * water.sound_speed(density)};
    stress[a].volume = blob.mass[a] / density;
  }
  // Filled up with a record that is nobody's neighbour.
  std::vector<std::int32_t> list(count + abreast + candidates_ahead, static_cast<std::int32_t>(count));
  std::iota(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count), 0);
  std::vector<Cluster> clusters;
  for (std::size_t first = 0; first < count; first += loops.lanes) {
    clusters.push_back({.first = static_cast<std::int32_t>(first),
                        .count = static_cast<std::int32_t>(std::min(loops.lanes, count - first)),
                        .begin = list.data(),
                        .end = list.data() + count});
  }
  Rates rates;
  for (auto* array : {&rates.dx, &rates.dz, &rates.du, &rates.dw, &rates.ddensity}) array->resize(padded);
  std::vector<double> limit(padded);
  const PairWork work{.records = records.data(),
                      .mass = mass.data(),
                      .stress = stress.data(),
                      .clusters = clusters.data(),
                      .dx = rates.dx.data(),
                      .dz = rates.dz.data(),
                      .du = rates.du.data(),
                      .dw = rates.dw.data(),
                      .ddensity = rates.ddensity.data(),
                      .limit = limit.data(),
                      .gravity = settings.gravity,
                      .xsph = settings.xsph,
                      .sound_scale = sound_scale,
                      .kinematic_viscosity = eddies != nullptr ? eddies->kinematic_viscosity : 0,
                      .eddy_factor = eddies != nullptr ? std::pow(eddies->smagorinsky * spacing, 2) : 0,
                      .isotropic_factor = eddies != nullptr ? 2.0 / 3 * eddies->isotropic * spacing * spacing : 0};
  Friction friction = Friction::none;
  if (artificial != nullptr) friction = Friction::artificial;
  if (eddies != nullptr) friction = Friction::turbulent;
  if (friction == Friction::turbulent) loops.strain(settings.kernel)(work, 0, clusters.size());
  loops.fluid(settings.kernel, friction, true)(work, 0, clusters.size());
  for (auto* array : {&rates.dx, &rates.dz, &rates.du, &rates.dw, &rates.ddensity}) array->resize(count);
  return rates;
}

struct Version {
  std::string name;
  const PairLoops* loops;
};

/// Those that this machine can run.
std::vector<Version> runnable() {
  std::vector<Version> found{{"baseline", &versions::baseline}};
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (__builtin_cpu_supports("x86-64-v3")) found.push_back({"avx2", &versions::avx2});
  if (__builtin_cpu_supports("x86-64-v4")) found.push_back({"avx512", &versions::avx512});
#endif
  return found;
}

}  // namespace

TEST_CASE("every width of registers gives the rates of sums over all pairs", "[conservation]") {
  Check check("wcsph_lanes", "Pair loops for every width of registers",
              "The loops exist for two, four and eight particles at a time, with reciprocals and roots of each "
              "instruction set. All that this machine runs, of a free blob whose number of particles is a multiple of "
              "none of them, "
              "against sums over all pairs.");
  Particles blob = random_blob(spacing, 1000, 1);
  while (blob.size() % 8 != 5) blob.add(5 + static_cast<double>(blob.size()), 3, 10, 1000);
  for (const Version& version : runnable()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      const std::vector<Viscosity> models{Inviscid{}, ArtificialViscosity{0.3}, LaminarSps{0.01, 0.12, 0.0066}};
      double largest = 0;
      for (const Viscosity& viscosity : models) {
        const Settings settings{.kernel = kernel, .sound_speed = 20, .viscosity = viscosity};
        const Rates found = rates_by(*version.loops, blob, settings);
        const Rates direct = DirectSums(blob, spacing, settings).rates();
        largest = std::max({largest, relative_difference(found.dx, direct.dx), relative_difference(found.dz, direct.dz),
                            relative_difference(found.du, direct.du), relative_difference(found.dw, direct.dw),
                            relative_difference(found.ddensity, direct.ddensity)});
      }
      check.that(
          {.id = fmt::format("{}-{}", version.name, name_of(kernel)),
           .text =
               fmt::format("The {} loops give the rates of sums over all pairs ({}).", version.name, name_of(kernel)),
           .quantity = "largest relative difference of a rate",
           .source = "formulas (2)-(6) summed over all pairs"},
          {.value = largest, .resolution = fmt::format("{} lanes", version.loops->lanes)},
          Bound{.limit = 1e-12,
                .reason = "some 20 pairs of 40 roundings each; pressures are differences of numbers 20 times larger"});
    }
  }
}
