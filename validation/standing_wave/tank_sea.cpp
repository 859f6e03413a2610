#include "validation/standing_wave/tank_sea.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/samples.hpp"
#include "validation/studies/side_by_side/tank_wave.hpp"

namespace seiche::validation::tank_sea {

using exact::WavesInTank;

namespace {

const Named particles{"particles", "Gauss particles"};
const Named mesh{"mesh", "the Lagrangian mesh"};
constexpr double steep = 0.1;  ///< amplitude from which on the mesh tangles

WavesInTank::Parameters parameters_of(const Comparison& comparison) {
  WavesInTank::Parameters sea = comparison.sea;
  sea.wavelength = 2 * length;
  sea.depth = sea.gravity = 1;
  sea.last_time = comparison.last;
  return sea;
}

/// Elevation of the exact surface, between points of it that are close together.
class Elevation {
 public:
  explicit Elevation(WavesInTank sea) : sea_(std::move(sea)) {}

  double operator()(double x, double t) {
    auto [place, missing] = profiles_.try_emplace(t);
    if (missing) place->second = sea_.profile(t, 4001);
    const auto& [time, xs, ys, potential, u, v] = place->second;
    const auto right = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(xs, x) - xs.begin(), 1, std::ssize(xs) - 1);
    return std::lerp(ys[right - 1], ys[right], (x - xs[right - 1]) / (xs[right] - xs[right - 1]));
  }

 private:
  WavesInTank sea_;
  std::map<double, WavesInTank::Profile> profiles_;
};

TankWave tank_of(const WavesInTank& sea, const Comparison& comparison) {
  const double amplitude = comparison.sea.amplitude;
  std::optional<TankWave::Bottom> bottom;
  if (comparison.barred()) {
    bottom = {.elevation = [sea](double x) { return sea.bars().bottom(x).elevation; },
              .slope = [sea](double x) { return sea.bars().bottom(x).slope; },
              .curvature = [sea](double x) { return sea.bars().bottom(x).curvature; }};
  }
  return {.length = length,
          .water = {.period = 2 * length,
                    .highest = 3 * amplitude,
                    .elevation = [sea](double x) { return sea.linear(x, 0, 0).elevation; },
                    .velocity =
                        [sea](Point at) {
                          const auto v = sea.linear(at.x, at.y, 0).velocity;
                          return Point{v.u, v.v};
                        },
                    .pressure = [sea](Point at) { return sea.linear(at.x, at.y, 0).pressure; }},
          .speed = 1,
          .amplitude = amplitude,
          .surface = [exact = std::make_shared<Elevation>(sea)](double x, double t) { return (*exact)(x, t); },
          .part =
              [](double) {
                return TankWave::Part{0, length};
              },
          .bottom = bottom};
}

/// Markers that move with the mean velocity over the depth, of cells of equal volume.
dispersive_shallow_water_1d::Flow dispersive_of(const WavesInTank& sea, const TankWave& tank, double spacing) {
  using namespace dispersive_shallow_water_1d;
  Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  if (tank.bottom)
    channel.bottom = std::make_shared<SmoothBottom>(tank.bottom->elevation, tank.bottom->slope, 0, length);
  const auto elevation = [&](double x) { return sea.linear(x, 0, 0).elevation; };
  const auto depth = [&](double x) { return elevation(x) - sea.bars().bottom(x).elevation; };
  const auto mean = [&](double x) { return sea.linear(x, elevation(x), 0).discharge / depth(x); };
  const auto motion = [&](double x) {
    constexpr double h = 1e-5;
    return SurfaceMotion{elevation(x), mean(x), -depth(x) * (mean(x + h) - mean(x - h)) / (2 * h)};
  };
  const auto excess = [&](double x) {
    double sum = 0;
    for (const auto& [k, a, w, phase] : sea.modes()) sum += a / k * std::sin(k * x) * std::cos(phase);
    return sum;
  };
  const auto cells = static_cast<std::size_t>(std::lround(length / spacing));
  return Flow(channel, moved_markers(channel, equal_labels(channel, 0, length, cells), motion, excess, 0));
}

/// Of linear waves of other frequencies, started alike, from the true ones; over the amplitude, over the tank.
double rms_of_law(const Comparison& comparison, const std::function<double(double k)>& frequency) {
  const double end = comparison.end;
  double squares = 0;
  for (const auto& [k, a, w, phase] : WavesInTank::modes_of(parameters_of(comparison))) {
    const double other = frequency(k);
    const double arrives =
        std::cos(other * end) * std::cos(phase) - std::sin(other * end) * std::sin(phase) * w / other;
    squares += std::pow((arrives - std::cos(w * end + phase)) * a / comparison.sea.amplitude, 2);
  }
  return std::sqrt(squares / 2);
}

}  // namespace

std::vector<Parameter> with_sizes(std::vector<Parameter> own, ByTier<long> mesh, bool barred) {
  const std::vector<Parameter> sizes{
      integer("particles", {4, 12, 12}, {4, 40}, "cells of the Gauss-principle particles per depth, finest of three"),
      integer("mesh", mesh, {8, 96}, "rows of the Lagrangian mesh, finest of four"),
      integer("markers", {32, 64, 64}, {8, 512}, "nodes of the dispersive model per depth, finest of four"),
      integer("cells", {8, 16, 16}, {8, 48}, "rows of Dirichlet cells and variable masses, the finest"),
      integer("sph", {8, 32, 32}, {8, 96}, "SPH particles over the depth, finest of three")};
  own.insert(own.end(), sizes.begin(), sizes.end() - (barred ? 2 : 0));
  return own;
}

void claims(const Values& values, const Claims<Results>& all, const Comparison& comparison) {
  const double amplitude = comparison.sea.amplitude, end = comparison.end;
  const auto at_end = all.at("the finest, " + comparison.instant);
  const auto nonlinear =
      at_end.only_if(amplitude >= steep / 2 && amplitude <= steep && end <= comparison.soon,
                     "lower waves and longer runs differ from linear theory by less than the phase errors of the "
                     "grids; higher waves tangle the mesh");
  const bool barred = comparison.barred();
  const std::string yardstick = barred ? "the effect of the bars" : "linear theory's error";
  const std::string tangles = "the mesh tangles in some seas before the end";
  for (const Named& model : {particles, mesh}) {
    nonlinear.only_if(model.id != mesh.id || !comparison.tangles, tangles)
        .from("potential flow by Cauchy's integral, spectral")
        .check(
            model.id + (barred ? "-beside-level" : "-beside-linear"),
            fmt::format("The surface error is below {:g} of {}: {}.", comparison.resolved, yardstick, model.name),
            "rms error of the surface over " + yardstick,
            [id = model.id](const Results& r) { return r.contest.of(id).finest().error / r.yardstick; },
            Bound{.limit = comparison.resolved,
                  .reason = barred ? "the effect of the bars is what the sea differs by from that over a level bottom; "
                                     "a model resolves it with an error below this share of it"
                                   : "the error of linear theory measures the nonlinearity of the waves, which a model "
                                     "resolves with an error below this share of it"});
  }
  const Claims<Contest> claims = at_end.of(&Results::contest);
  const double spacing = 1 / values.number("markers");
  const exact::FrankDispersion law(1, 1, spacing);
  const double apart = rms_of_law(comparison, [&](double k) {
    return exact::discrete_frequency(law.frequency(k), 0.25 * spacing, exact::TimeScheme::one_step);
  });
  claims_of(claims, "dispersive")
      .only_if(!barred, "the dispersion relation is that over a level bottom")
      .only_if(amplitude <= steep, "higher waves differ from linear waves by more than a tenth of the dispersion error")
      .from("Frank (1994), formula (13); linear waves")
      .check("dispersive-law",
             "The surface error of the dispersive model agrees with the error of linear waves of its dispersion "
             "relation within 10 %.",
             "rms error of the surface over the amplitude", error_of_finest,
             Bound{.limit = 0.1 * apart,
                   .reason = "the dispersion relation gives the lag of each wave; the error of linear theory itself, "
                             "at most 4 % of the amplitude, is a tenth of it",
                   .expected = apart});
  claim_energy(claims_of(claims, "particles"), particles, end * values.number("particles") / 0.15, 2,
               "one rounding per step of the kinetic and of the potential energy",
               "Frank (1994), chapter 6; exact for every space and step");
  const auto low = claims.only_if(amplitude <= steep, "higher waves tangle the mesh");
  for (const Named& model : {particles, mesh}) {
    claim_lasts(claims_of(low, model.id).only_if(model.id != mesh.id || !comparison.tangles, tangles), model,
                comparison.last, source);
  }
}

Results compute(const Run& run, const Comparison& comparison) {
  const WavesInTank sea(parameters_of(comparison));
  const double amplitude = comparison.sea.amplitude, end = comparison.end;
  const TankWave tank = tank_of(sea, comparison);
  WavesInTank::Parameters level = parameters_of(comparison);
  level.bar_height = 0;
  Elevation without(comparison.barred() ? WavesInTank(level) : sea);
  Mean apart;
  Largest highest;
  for (int k = 0; k <= 600; ++k) {
    const double x = length * k / 600;
    const double exact = tank.surface(x, end);
    const double other = comparison.barred() ? without(x, end) : sea.linear(x, 0, end).elevation;
    apart.add((other - exact) / amplitude, 1);
    highest.add(exact / amplitude, x);
  }
  const auto start = sea.integrals(0);
  const Trial trial{.end = end,
                    .last = comparison.last,
                    .looks = 6,
                    .useless = 1,
                    .useless_in_words = "the surface error exceeds the sum of the amplitudes",
                    .energy_scale = (start.kinetic_energy + start.potential_energy) / 2,
                    .reference_uncertainty = sea.uncertainty(end)};
  return {contest(run,
                  tank_contenders(
                      tank, [&](double spacing) { return dispersive_of(sea, tank, spacing); }, tank_sizes(run)),
                  trial),
          apart.rms(), highest.value()};
}

void show(const Results& results, const Values& /*values*/, evidence::Exhibit& exhibit) {
  results.contest.show(exhibit, {.size = "depth", .error = "amplitude", .time = "sqrt(depth/g)"});
  exhibit.measure("yardstick_rms", results.yardstick);
  exhibit.measure("highest", results.highest);
}

}  // namespace seiche::validation::tank_sea
