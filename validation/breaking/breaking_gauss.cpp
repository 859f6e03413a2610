/*
A periodic wave is pushed by a pressure on its surface until it breaks: the set-up of Longuet-Higgins and Cokelet
(1976), which Frank computes with free particles under Gauss's principle (figure 10, frames at t =
0, 3.2, 5.0, 5.4, 6.2, 6.8, 7.2, 7.4).

**Set-up.** A Stokes wave of height 0.6, wavelength $2\pi$, on water of mean depth $\pi$, crest at x = 0, in units of
$g$ and of the density. The surface pressure $-p_0 \sin t \sin(x - t)$ acts for $0 \le t \le \pi$. Frank gives no $p_0$:
the value of 0.1 is a fit to the times of his frames. Cubic splines on square cells that are shifted at random at every
step; five particles to a cell's side; the penalty on gradients of vorticity.

**What is compared.** The time at which the surface first overturns with the frames, on which it is smooth at 5.4 and
overturned at 7.2; the crest's height with an independent program; the balance of energy.

**What to look at.** The front steepens from 6.2 on, is vertical at about 6.8 to 7.1, and throws a jet.

**When it is no test.** The amplitude of the pressure is fitted, so that the time of breaking is no prediction.
*/
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/stokes_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
using gauss_particles::Flow;
using gauss_particles::LatticePlan;
using gauss_particles::SplineSpace;

const std::string source =
    "Frank, Discrete models of incompressible fluid (1994), figure 10; Longuet-Higgins & Cokelet, Proc. R. Soc. A 350 "
    "(1976) 1";

constexpr double half_length = std::numbers::pi;
constexpr double depth = std::numbers::pi;
const std::vector<double> frame_times{0, 3.2, 5.0, 5.4, 6.2, 6.8, 7.2, 7.4};

struct Frame {
  double time = 0;
  std::vector<double> x, y;
  double crest = 0;  ///< above the bottom
};

struct Results {
  std::vector<Frame> frames;
  /// First time at which the line of markers goes backwards; NaN: never.
  double overturned = std::numeric_limits<double>::quiet_NaN();
  double balance = 0;  ///< largest defect of energy, work and loss
  double loss = 0;     ///< by the penalty
  [[nodiscard]] double crest(std::size_t frame) const { return frames[frame].crest; }
};

bool goes_backwards(const std::vector<Point>& line) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (line[k].x < line[k - 1].x) return true;
  }
  return false;
}

Flow flow_of(const Values& values) {
  const exact::StokesWave wave(0.3, 2 * half_length, depth, 1);
  const double h = 2 * half_length / static_cast<double>(values.integer("cells"));
  const long side = values.integer("particles_per_side");
  const double strength = values.real("pressure");
  return Flow(gauss_particles::layer({.begin = -half_length,
                                      .end = half_length,
                                      .columns = static_cast<std::size_t>(values.integer("cells") * side),
                                      .rows = static_cast<std::size_t>(std::lround(depth / h) * side),
                                      .surface = [&](double x) { return wave.elevation(x); },
                                      .bottom = [](double) { return -depth; },
                                      .markers = 400}),
              std::make_unique<SplineSpace>(LatticePlan{.cell_x = h,
                                                        .left_wall = -half_length,
                                                        .period = 2 * half_length,
                                                        .bottom = true,
                                                        .ground = {.level = -depth},
                                                        .shift = true}),
              [&](Point r) {
                const auto v = wave.velocity(r.x, std::min(r.y, wave.elevation(r.x) - 1e-13));
                return Point{v.u, v.v};
              },
              {.gravity = 1, .penalty = 0.01}, {.surface_pressure_slope = [strength](double x, double t) {
                return t < std::numbers::pi ? -strength * std::sin(t) * std::cos(x - t) : 0.0;
              }});
}

Results compute(const Run& run) {
  Results r;
  Flow flow = flow_of(run);
  for (const double time : frame_times) {
    flow.advance_to(time, run.real("time_step"), [&] {
      flow.observe();
      if (std::isnan(r.overturned) && goes_backwards(flow.markers())) r.overturned = flow.time();
    });
    Frame frame{.time = time};
    Largest crest;
    for (const Point& marker : flow.markers()) {
      frame.x.push_back(marker.x);
      frame.y.push_back(marker.y);
      crest.add(marker.y + depth);
    }
    frame.crest = crest.value();
    r.frames.push_back(std::move(frame));
    run.progress(time / frame_times.back());
  }
  r.balance = flow.ledger().largest_defect("energy");
  r.loss = flow.model().penalty_loss();
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const Claims<Results> claims =
      all.at(fmt::format("{} cells, {} particles to a side, tau = {:g}", values.integer("cells"),
                         values.integer("particles_per_side"), values.real("time_step")));
  const auto fitted = claims.only_if(values.real("pressure") == 0.1, "the frames are met with a pressure of 0.1");
  fitted.check(
      {.id = "overturns",
       .text = "The surface overturns after the frame of 6.2 and before that of 7.2.",
       .quantity = "time at which the line of markers first goes backwards",
       .unit = "(g k)^(-1/2)",
       .source = source},
      &Results::overturned,
      evidence::Bound{.limit = 0.5,
                      .reason = "half of the time between the frames in which the source draws a steep front and "
                                "a jet",
                      .expected = 6.7});
  const auto published =
      claims.only_if(values.as_published("frank-fig-10"), "the independent program ran with the default parameters");
  const auto crest = [&](const std::string& id, std::size_t frame, double expected, double limit) {
    published.check(
        {.id = id,
         .text = fmt::format("The crest at t = {:g} is as high as an independent program finds.", frame_times[frame]),
         .quantity = "height above the bottom",
         .unit = "1/k",
         .source = source},
        [frame](const Results& r) { return r.crest(frame); },
        evidence::Bound{.limit = limit,
                        .reason = "0.5 per cent of the wave's height before it breaks, 3 per cent after, when "
                                  "the crest is a jet two cells thick",
                        .expected = expected});
  };
  crest("crest-steep", 4, 3.781, 0.003);
  crest("crest-jet", 6, 3.753, 0.018);
  claims.check({.id = "energy",
                .text = "The energy changes by the work of the pressure and by what the penalty takes, to round-off.",
                .quantity = "largest defect",
                .unit = "rho g/k^3",
                .source = "Frank (1994), chapter 6; the discrete work is exact"},
               &Results::balance,
               evidence::Roundoff{.operations = frame_times.back() / values.real("time_step"),
                                  .scale = 1,
                                  .reason = "one rounding per step of energies below 1"});
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("frames", "The wave breaks", "The surface at the times of the source's frames.", {"frank-fig-10"});
  for (const Frame& frame : r.frames) {
    auto& panel =
        figure.panel({.x = "k x", .y = "k y", .title = fmt::format("t = {:g}", frame.time), .equal_aspect = true});
    panel.line("surface", frame.x, frame.y, Role::computed);
  }
  exhibit.measure("overturned", r.overturned);
  exhibit.measure("crest_6_2", r.crest(4));
  exhibit.measure("crest_7_2", r.crest(6));
  exhibit.measure("penalty_loss", r.loss);
}

}  // namespace

Case breaking_gauss() {
  Case c;
  c.title = "A wave is pushed until it breaks, by free particles under Gauss's principle";
  c.source = source;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("cells", {40, 60, 80}, {16, 400}, "cells of the lattice to a wavelength"),
      integer("particles_per_side", 5, {3, 40}, "particles to a cell's side"),
      real("time_step", {0.02, 0.0133, 0.01}, "(g k)^(-1/2)", {1e-4, 0.1}, "time step"),
      real("pressure", 0.1, "rho g/k", {0, 0.2}, "p0, amplitude of the surface pressure"),
  };
  c.published = {{.tiles = {"frank-fig-10"}}};
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
