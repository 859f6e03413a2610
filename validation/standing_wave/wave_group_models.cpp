/*
Which model suits a wave group? A group crosses a tank and focuses at its wall, computed with six models, beside the
fully nonlinear potential flow.

**Set-up.** Depth, gravity and density are 1; the tank is 6 long. Six modes of equal amplitude, L/h = 6 to 1.7, start
with the surface and velocities of linear theory so that all crests would meet at the wall $x = 0$ at the time `focus`,
as in laboratories since Baldock, Swan and Taylor (1996). The exact flow starts with the same surface and potential, and
is computed with Cauchy's integral to spectral accuracy (`seiche exact focused_group`).

**What is compared.** Elevations along the tank at the focus, when every phase error counts: rms over the linear height
of the focus. Each model continues for half as long again.

**What to look at.** The error of linear theory itself measures the nonlinearity: a model with a larger error is less
accurate than linear theory. The dispersive model has the wrong celerity for waves of $L/h = 2$, as predicted by its
dispersion relation. With Gauss-principle particles and the mesh every component arrives in phase.

**Limits of this test.** Breaking is not covered, because the group is not steep enough; nor are long runs, the time to
focus being some three periods.
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/studies/side_by_side/tank_wave.hpp"

namespace seiche::validation::cases::wave_group_models {

using exact::FocusedGroup;

const std::string source = "potential flow by Cauchy's integral; Frank, Discrete models of incompressible fluid (1994)";
const Named particles{"particles", "Gauss particles"};
const Named mesh{"mesh", "the Lagrangian mesh"};

constexpr double length = 6;
constexpr int first = 2, last = 7;  // modes: half waves between the walls

double wavenumber(int mode) {
  return std::numbers::pi * mode / length;
}

FocusedGroup group_of(const Values& values) {
  return FocusedGroup({.amplitude = values.real("amplitude"),
                       .wavelength = 2 * length,
                       .depth = 1,
                       .gravity = 1,
                       .first = first,
                       .last = last,
                       .focus = values.real("focus"),
                       .last_time = 1.5 * values.real("focus")});
}

/// Elevation of the exact surface, between points of it that are close together.
class Elevation {
 public:
  explicit Elevation(FocusedGroup group) : group_(std::move(group)) {}

  double operator()(double x, double t) {
    auto [place, missing] = profiles_.try_emplace(t);
    if (missing) place->second = group_.profile(t, 4001);
    const auto& [time, xs, ys, potential, u, v] = place->second;
    const auto right = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(xs, x) - xs.begin(), 1, std::ssize(xs) - 1);
    return std::lerp(ys[right - 1], ys[right], (x - xs[right - 1]) / (xs[right] - xs[right - 1]));
  }

 private:
  FocusedGroup group_;
  std::map<double, FocusedGroup::Profile> profiles_;
};

TankWave tank_of(const FocusedGroup& group, double amplitude) {
  return {.length = length,
          .water = {.period = 2 * length,
                    .highest = 3 * amplitude,
                    .elevation = [group](double x) { return group.linear(x, 0, 0).elevation; },
                    .velocity =
                        [group](Point at) {
                          const auto v = group.linear(at.x, at.y, 0).velocity;
                          return Point{v.u, v.v};
                        },
                    .pressure = [group](Point at) { return group.linear(at.x, at.y, 0).pressure; }},
          .speed = 1,
          .amplitude = amplitude,
          .surface = [exact = std::make_shared<Elevation>(group)](double x, double t) { return (*exact)(x, t); },
          .part =
              [](double) {
                return TankWave::Part{0, length};
              }};
}

/// Markers that move with the mean velocity over the depth, of cells of equal volume.
dispersive_shallow_water_1d::Flow dispersive_of(const FocusedGroup& group, double spacing) {
  using namespace dispersive_shallow_water_1d;
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  const auto mean = [&](double x) {
    const double elevation = group.linear(x, 0, 0).elevation;
    return group.linear(x, elevation, 0).discharge / (1 + elevation);
  };
  const auto motion = [&](double x) {
    const double elevation = group.linear(x, 0, 0).elevation;
    constexpr double h = 1e-5;
    return SurfaceMotion{elevation, mean(x), -(1 + elevation) * (mean(x + h) - mean(x - h)) / (2 * h)};
  };
  const auto excess = [&](double x) {
    double sum = 0;
    for (int mode = first; mode <= last; ++mode) {
      const double k = wavenumber(mode);
      const double w = std::sqrt(k * std::tanh(k));
      sum += std::sin(k * x) / k * std::cos(w * group.focus());
    }
    return sum * group.amplitude() / (last - first + 1);
  };
  const auto cells = static_cast<std::size_t>(std::lround(length / spacing));
  return Flow(channel, moved_markers(channel, equal_labels(channel, 0, length, cells), motion, excess, 0));
}

Trial trial_of(const FocusedGroup& group) {
  const auto start = group.integrals(0);
  return {.end = group.focus(),
          .last = 1.5 * group.focus(),
          .looks = 6,
          .useless = 1,
          .useless_in_words = "the surface error exceeds the height of the focus",
          .energy_scale = (start.kinetic_energy + start.potential_energy) / 2,
          .reference_uncertainty = group.uncertainty(group.focus())};
}

/// Of linear waves of other frequencies, started alike, from the true ones at the focus.
double rms_of_law(const Values& values, const std::function<double(double k)>& frequency) {
  double squares = 0;
  for (int mode = first; mode <= last; ++mode) {
    const double k = wavenumber(mode);
    const double turn = std::sqrt(k * std::tanh(k)) * values.real("focus");
    const double ratio = frequency(k) / std::sqrt(k * std::tanh(k));
    const double arrives = std::cos(ratio * turn) * std::cos(turn) + std::sin(ratio * turn) * std::sin(turn) / ratio;
    squares += std::pow((arrives - 1) / (last - first + 1), 2);
  }
  return std::sqrt(squares / 2);
}

struct Results {
  Contest contest;
  double linear = 0;  ///< rms of linear theory from the exact surface at the focus, over the amplitude
  double crest = 0;   ///< of the exact surface at the wall at the focus, over that of linear theory
};

void claims(const Values& values, const Claims<Results>& all) {
  const auto at_focus = all.at("the finest, at the focus");
  const double amplitude = values.real("amplitude");
  const auto nonlinear = at_focus.only_if(amplitude >= 0.05 && amplitude <= 0.1 && values.real("focus") <= 10,
                                          "lower groups and longer runs differ from linear theory by less than the "
                                          "phase errors of the grids; higher groups tangle the mesh");
  for (const Named& model : {particles, mesh}) {
    nonlinear.from("potential flow by Cauchy's integral, spectral")
        .check(
            model.id + "-beside-linear",
            fmt::format("The surface error is below a quarter of linear theory's error: {}.", model.name),
            "rms error of the surface over the error of linear theory",
            [id = model.id](const Results& r) { return r.contest.of(id).finest().error / r.linear; },
            Bound{.limit = 0.25,
                  .reason = "the error of linear theory measures the nonlinearity of the group: below a quarter of it "
                            "a model resolves the nonlinearity"});
  }
  const Claims<Contest> claims = at_focus.of(&Results::contest);
  const double spacing = 1 / values.number("markers");
  const exact::FrankDispersion law(1, 1, spacing);
  const double apart = rms_of_law(values, [&](double k) {
    return exact::discrete_frequency(law.frequency(k), 0.25 * spacing, exact::TimeScheme::one_step);
  });
  claims_of(claims, "dispersive")
      .only_if(amplitude <= 0.1, "higher groups differ from linear waves by more than a tenth of the dispersion error")
      .from("Frank (1994), formula (13); linear waves")
      .check("dispersive-law",
             "The surface error of the dispersive model agrees with the error of linear waves of its dispersion "
             "relation within 10 %.",
             "rms error of the surface over the amplitude", error_of_finest,
             Bound{.limit = 0.1 * apart,
                   .reason = "the dispersion relation gives the lag of each wave at the focus; the error of linear "
                             "theory itself, 4 % of the amplitude, is a tenth of it",
                   .expected = apart});
  claim_energy(claims_of(claims, "particles"), particles, values.real("focus") * values.number("particles") / 0.15, 2,
               "one rounding per step of the kinetic and of the potential energy",
               "Frank (1994), chapter 6; exact for every space and step");
  const auto low = claims.only_if(amplitude <= 0.1, "higher groups tangle the mesh");
  for (const Named& model : {particles, mesh}) {
    claim_lasts(claims_of(low, model.id), model, 1.5 * values.real("focus"), source);
  }
}

Results compute(const Run& run) {
  const FocusedGroup group = group_of(run);
  const double amplitude = run.real("amplitude"), focus = run.real("focus");
  const TankWave tank = tank_of(group, amplitude);
  Mean linear;
  for (int k = 0; k <= 600; ++k) {
    const double x = length * k / 600;
    linear.add((group.linear(x, 0, focus).elevation - tank.surface(x, focus)) / amplitude, 1);
  }
  return {contest(run,
                  tank_contenders(
                      tank, [&](double spacing) { return dispersive_of(group, spacing); }, tank_sizes(run)),
                  trial_of(group)),
          linear.rms(), tank.surface(0, focus) / amplitude};
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  r.contest.show(exhibit, {.size = "depth", .error = "amplitude", .time = "sqrt(depth/g)"});
  exhibit.measure("linear_theory_rms", r.linear);
  exhibit.measure("crest_at_the_wall", r.crest);
}

void wave_group_models(Case& c) {
  c.title = "Model comparison: focus of a wave group at a wall";
  c.source = "T. E. Baldock, C. Swan, P. H. Taylor, Phil. Trans. R. Soc. Lond. A 354 (1996) 649; " +
             literature::longuet_higgins_cokelet;
  c.parameters = {
      real("amplitude", 0.1, "depth", {0.001, 0.2}, "of the crest at the focus by linear theory"),
      real("focus", 9.0, "sqrt(depth/g)", {1, 40}, "time at which the crests meet at the wall"),
      integer("particles", {4, 12, 12}, {4, 40}, "cells of the Gauss-principle particles per depth, finest of three"),
      integer("mesh", {16, 32, 32}, {8, 96}, "rows of the Lagrangian mesh, finest of four"),
      integer("cells", {8, 16, 16}, {8, 48}, "rows of Dirichlet cells and variable masses, the finest"),
      integer("markers", {32, 64, 64}, {8, 512}, "nodes of the dispersive model per depth, finest of four"),
      integer("sph", {8, 32, 32}, {8, 96}, "SPH particles over the depth, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wave_group_models
