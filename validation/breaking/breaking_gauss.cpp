/*
A periodic wave is pushed by a pressure on its surface until it breaks: the set-up of Longuet-Higgins and Cokelet
(1976), which Frank computes with free particles under Gauss's principle (figure 10, frames at t =
0, 3.2, 5.0, 5.4, 6.2, 6.8, 7.2, 7.4).

**Set-up.** A Stokes wave of height 0.6, wavelength $2\pi$, on water of mean depth $\pi$, crest at x = 0, in units of
$g$ and of the density. The surface pressure $-p_0 \sin t \sin(x - t)$ acts for $0 \le t \le \pi$. Frank gives no $p_0$:
the value of 0.1 is a fit to the times of his frames. Cubic splines on square cells that are shifted at random at every
step; five particles to a cell's side; the penalty on gradients of vorticity.

**What is compared.** The time at which the surface first overturns with the frames, on which it is smooth at 5.4 and
overturned at 7.2; the work of the pressure with that of linear theory, in which a wave of amplitude $a$ grows by
$\dot a = (p_0/2)\,c \sin t$; the crest's height with that on cells a third wider; the balance of energy.

**What to look at.** The front steepens from 6.2 on, is vertical at about 6.8 to 7.1, and throws a jet.

**When it is no test.** The amplitude of the pressure is fitted, so that the time of breaking is no prediction.
*/
#include <algorithm>
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
  std::vector<double> x, y;  ///< markers of three wavelengths
  double crest_x = 0;
};

struct Results {
  std::vector<Frame> frames;
  double crest = 0;         ///< above the bottom, at the time `at`
  double coarse_crest = 0;  ///< on the wider cells
  /// First time at which the line of markers goes backwards; NaN: never.
  double overturned = std::numeric_limits<double>::quiet_NaN();
  double work = 0;     ///< of the pressure
  double balance = 0;  ///< largest defect of energy, work and loss
  double loss = 0;     ///< by the penalty
  [[nodiscard]] double crest_change() const { return crest - coarse_crest; }
};

bool goes_backwards(const std::vector<Point>& line) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (line[k].x < line[k - 1].x) return true;
  }
  return false;
}

exact::StokesWave wave_of(const Values& values) {
  return {values.real("height") / 2, 2 * half_length, depth, 1};
}

Flow flow_of(const Values& values, long cells) {
  const exact::StokesWave wave = wave_of(values);
  const double h = 2 * half_length / static_cast<double>(cells);
  const long side = values.integer("per_cell");
  const double strength = values.real("pressure");
  return Flow(gauss_particles::layer({.begin = -half_length,
                                      .end = half_length,
                                      .columns = static_cast<std::size_t>(cells * side),
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

long wider(const Values& values) {
  return values.integer("cells") * 3 / 4;
}

Point highest(const std::vector<Point>& line) {
  return *std::max_element(line.begin(), line.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
}

Frame frame_of(const Flow& flow) {
  const std::vector<Point> line = flow.markers();
  Frame frame{.time = flow.time(), .crest_x = highest(line).x};
  for (const int period : {-1, 0, 1}) {
    for (const Point& marker : line) {
      frame.x.push_back(marker.x + 2 * half_length * period);
      frame.y.push_back(marker.y);
    }
  }
  return frame;
}

Results compute(const Run& run) {
  Results r;
  const double at = run.real("at");
  Flow coarse = flow_of(run, wider(run));
  coarse.advance_to(at, run.real("tau"));
  r.coarse_crest = depth + highest(coarse.markers()).y;
  run.progress(0.25);

  Flow flow = flow_of(run, run.integer("cells"));
  std::vector<double> times = frame_times;
  times.push_back(at);
  std::sort(times.begin(), times.end());
  for (const double time : times) {
    flow.advance_to(time, run.real("tau"), [&] {
      flow.observe();
      if (std::isnan(r.overturned) && goes_backwards(flow.markers())) r.overturned = flow.time();
    });
    if (time == at) r.crest = depth + highest(flow.markers()).y;
    if (std::find(frame_times.begin(), frame_times.end(), time) != frame_times.end() &&
        (r.frames.empty() || r.frames.back().time < time)) {
      r.frames.push_back(frame_of(flow));
    }
    run.progress(0.25 + 0.75 * time / frame_times.back());
  }
  r.work = flow.model().work();
  r.balance = flow.ledger().largest_defect("energy");
  r.loss = flow.model().penalty_loss();
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const Claims<Results> claims =
      all.at(fmt::format("{} cells, {} particles to a side, tau = {:g}", values.integer("cells"),
                         values.integer("per_cell"), values.real("tau")));
  const double pressure = values.real("pressure");
  claims
      .only_if(pressure == 0.1 && values.real("height") == 0.6,
               "the frames are met with a height of 0.6 and a pressure of 0.1")
      .check(
          {.id = "overturns",
           .text = "With the fitted pressure the surface overturns after the frame of 6.2 and before that of 7.2.",
           .quantity = "time at which the line of markers first goes backwards",
           .unit = "(g k)^(-1/2)",
           .source = source},
          &Results::overturned,
          evidence::Bound{.limit = 0.5,
                          .reason = "half of the time between the frames in which the source draws a steep front and "
                                    "a jet",
                          .expected = 6.7});
  const exact::StokesWave wave = wave_of(values);
  const double first = wave.amplitude();
  const double last = first + pressure * wave.phase_speed();
  claims.only_if(pressure > 0, "without a pressure there is no work")
      .check({.id = "work",
              .text = "The pressure does the work of linear theory, but for what the wave's steepness changes.",
              .quantity = "work of the pressure on a wavelength",
              .unit = "rho g/k^3",
              .source = "Stokes waves of small amplitude: da/dt = (p0/2) c sin t, energy rho g a^2/2"},
             &Results::work,
             evidence::Bound{.limit = last * last,
                             .reason = "theory of finite amplitude changes the energy by a part (k a)^2",
                             .expected = half_length * (last * last - first * first),
                             .relative = true});
  claims.only_if(values.real("at") <= 6.2, "the crest then is a jet, which no lattice resolves")
      .check({.id = "crest",
              .text = fmt::format("The crest at t = {:g} is as high as on cells a third wider.", values.real("at")),
              .quantity = "difference of its heights",
              .unit = "1/k",
              .source = source},
             &Results::crest_change,
             evidence::Bound{0.01 * values.real("height"),
                             "a hundredth of the wave's height: in a figure in which it is 3 cm high, the width of a "
                             "line"});
  claims.check({.id = "energy",
                .text = "The energy changes by the work of the pressure and by what the penalty takes, to round-off.",
                .quantity = "largest defect",
                .unit = "rho g/k^3",
                .source = "Frank (1994), chapter 6; the discrete work is exact"},
               &Results::balance,
               evidence::Roundoff{.operations = frame_times.back() / values.real("tau"),
                                  .scale = 1,
                                  .reason = "one rounding per step of energies below 1"});
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("frames", "The wave breaks", "The surface at the times of the source's frames.", {"frank-fig-10"});
  for (const Frame& frame : r.frames) {
    auto& panel = figure.panel({.x = "x - x(crest)",
                                .y = "y",
                                .title = fmt::format("t = {:g}", frame.time),
                                .equal_aspect = true,
                                .x_min = -1.6,
                                .x_max = 1.6,
                                .y_min = -0.5,
                                .y_max = 0.8});
    std::vector<double> x;
    for (const double place : frame.x) x.push_back(place - frame.crest_x);
    panel.line("surface", x, frame.y, Role::computed);
  }
  if (std::isfinite(r.overturned)) exhibit.measure("overturning_time", r.overturned);
  exhibit.measure("crest", r.crest);
  exhibit.measure("crest_wider_cells", r.coarse_crest);
  exhibit.measure("work", r.work);
  exhibit.measure("energy_balance", r.balance);
  exhibit.measure("penalty_loss", r.loss);
}

}  // namespace

Case breaking_gauss() {
  Case c;
  c.title = "A wave is pushed until it breaks, by free particles under Gauss's principle";
  c.source = source;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("height", 0.6, "1/k", {0.01, 0.87}, "of the wave, from trough to crest"),
      integer("cells", {40, 60, 80}, {16, 400}, "cells of the lattice to a wavelength"),
      integer("per_cell", 5, {3, 40}, "particles to a cell's side"),
      real("tau", {0.02, 0.0133, 0.01}, "(g k)^(-1/2)", {1e-4, 0.1}, "time step"),
      real("pressure", 0.1, "rho g/k", {0, 0.2},
           "p0, amplitude of the surface pressure; fitted to the source's frames"),
      real("at", 6.2, "(g k)^(-1/2)", {0, 7.4}, "when the crest is measured"),
  };
  c.published = {
      {.tiles = {"frank-fig-10"},
       .differs = "the thesis does not state the pressure: its amplitude is a fit to the times of the frames"}};
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
