/*
A piston at the end of a long tank starts to oscillate from rest. The two-dimensional Lagrangian mesh (Frank 1994,
chapter 2) follows it: the nodes of its first column are on the piston and slide along it. Depth and gravity are 1.

**Set-up.** The piston moves by $\tfrac12 S\,r(t)\sin\omega t$, where $r$ rises from 0 to 1 during the first period
(`soft`) or is 1 (`jump`): its velocity is then discontinuous, and the constant cell areas determine the initial
velocities of the water. The tank ends at a wall at $x = 20$, and the run ends before the reflected first wave reaches a
gauge.

**What is compared.** The elevation at gauges $x$ = 2, 5 and 10 with the exact transient of linear theory; for the soft
start, with its Duhamel integral. Runs with $S$ and $-S$ separate odd from even orders in the stroke. Half of the
difference is the linear wave, up to third order; half of the sum is the second order, which linear theory neglects and
which must be four times as high for twice the stroke.

**What to look at.** The front that arrives first is the lowest and longest part of the wave and does not resemble the
settled wave. The difference from theory falls by four when cells and steps are halved. A piston with discontinuous
velocity emits short waves of all lengths. Their height falls with the wavenumber like $k^{-3/4}$ only, no mesh resolves
them all, and the difference falls as slowly. The second order has twice the frequency: crests become sharper, troughs
flatter.
*/
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "seiche/exact/wavemaker.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/mesh/mesh_gauges.hpp"

namespace seiche::validation::cases::wavemaker_mesh {

using lagrangian_mesh_2d::Flow;

// A piston that starts softly, and the elevation that linear theory gives it.
//
//     d(t) = (S/2) r(t) sin(omega t),   r: from 0 to 1 over the first period, three times differentiable.
//
// The elevation is Duhamel's integral over the exact response s to a piston that suddenly moves on with velocity 1:
//
//     eta(x, t) = int_0^t d''(t') s(x, t - t') dt'.
//
// Depth and gravity are 1.

struct SoftPiston {
  double omega, stroke;
  bool sudden;  ///< r = 1: the velocity jumps at t = 0

  [[nodiscard]] SoftPiston with_stroke(double other) const { return {omega, other, sudden}; }
  [[nodiscard]] double place(double t) const { return stroke / 2 * ramp(t).value * std::sin(omega * t); }
  [[nodiscard]] double velocity(double t) const {
    const Ramp r = ramp(t);
    return stroke / 2 * (r.rate * std::sin(omega * t) + r.value * omega * std::cos(omega * t));
  }
  [[nodiscard]] double acceleration(double t) const {
    const Ramp r = ramp(t);
    const double w = omega;
    return stroke / 2 * ((r.acceleration - r.value * w * w) * std::sin(w * t) + 2 * r.rate * w * std::cos(w * t));
  }
  /// Elevation at x at the times interval, 2 interval, ...
  [[nodiscard]] std::vector<double> elevation(double x, double interval, std::size_t samples) const;

 private:
  struct Ramp {
    double value, rate, acceleration;
  };
  [[nodiscard]] Ramp ramp(double t) const {
    const double rate = omega / (2 * std::numbers::pi);
    const double z = rate * t;
    if (sudden || z >= 1) return {1, 0, 0};
    if (z <= 0) return {0, 0, 0};
    // The polynomial with r' = 140 z^3 (1 - z)^3.
    return {z * z * z * z * (35 + z * (-84 + z * (70 - 20 * z))), 140 * std::pow(z * (1 - z), 3) * rate,
            420 * std::pow(z * (1 - z), 2) * (1 - 2 * z) * rate * rate};
  }
};

std::vector<double> SoftPiston::elevation(double x, double interval, std::size_t samples) const {
  using exact::WavemakerTransient;
  std::vector<double> all;
  if (sudden) {
    const WavemakerTransient start(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{omega}, stroke);
    for (std::size_t n = 1; n <= samples; ++n) all.push_back(start.elevation(x, static_cast<double>(n) * interval));
    return all;
  }
  // A frequency of zero: cos(slow t) is 1 to 1e-5 as long as the run lasts.
  constexpr double slow = 1e-4;
  const WavemakerTransient step(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{slow}, 2 / slow);
  constexpr std::size_t parts = 4;  // panels of the integral in an interval
  const double dt = interval / parts;
  std::vector<double> response{0};
  std::vector<double> push{0};
  for (std::size_t n = 1; n <= samples * parts; ++n) {
    response.push_back(step.elevation(x, static_cast<double>(n) * dt));
    push.push_back(acceleration(static_cast<double>(n) * dt));
  }
  // Trapezoidal rule: both factors vanish at one of the ends.
  for (std::size_t n = parts; n <= samples * parts; n += parts) {
    double sum = 0;
    for (std::size_t m = 1; m < n; ++m) sum += push[m] * response[n - m];
    all.push_back(sum * dt);
  }
  return all;
}

const std::string source = "Kennard (1949); Frank (1994), chapter 2";
constexpr double tank = 20;
constexpr std::array<double, 3> gauges{2, 5, 10};
using Gauges = std::array<std::vector<double>, gauges.size()>;

struct Mesh {
  double spacing;
  long rows;
  double tau;
  /// The same with as many rows and steps times `factor`.
  [[nodiscard]] Mesh refined(double factor) const {
    return {spacing / factor, std::lround(factor * static_cast<double>(rows)), tau / factor};
  }
  [[nodiscard]] std::string name() const { return fmt::format("h1 = {:g}, {} rows, tau = {:g}", spacing, rows, tau); }
};

struct Series {
  std::vector<double> time;
  Gauges elevation;
};

/// Elevations at the gauges every `interval`, until `end`.
Series make_waves(const SoftPiston& paddle, const Mesh& resolution, mechanics::Stepping stepping, double interval,
                  double end) {
  auto mesh =
      lagrangian_mesh_2d::layer_mesh({.end = tank,
                                      .depth = 1,
                                      .columns = static_cast<std::size_t>(std::lround(tank / resolution.spacing)),
                                      .rows = static_cast<std::size_t>(resolution.rows)});
  mesh.sides.left = lagrangian_mesh_2d::MovingWall{.place = [paddle](double t) { return paddle.place(t); },
                                                   .velocity = [paddle](double t) { return paddle.velocity(t); }};
  Flow flow(std::move(mesh), {}, {.stepping = stepping});
  Series series;
  const auto samples = std::lround(end / interval);
  for (long n = 1; n <= samples; ++n) {
    march(flow, static_cast<double>(n) * interval, resolution.tau);
    series.time.push_back(flow.time());
    const std::vector<double> elevation = elevation_at(flow, gauges);
    for (std::size_t g = 0; g < gauges.size(); ++g) series.elevation[g].push_back(elevation[g]);
  }
  return series;
}

/// What changes sign with the stroke, over the stroke, and what does not, over its square.
struct Orders {
  std::vector<double> time;
  Gauges odd = {}, even = {};
};

Orders orders(const SoftPiston& paddle, const Mesh& mesh, const Run& run, double interval, double end) {
  const auto stepping = mechanics::stepping_named(run.text("scheme"));
  const Series plus = make_waves(paddle, mesh, stepping, interval, end);
  const Series minus = make_waves(paddle.with_stroke(-paddle.stroke), mesh, stepping, interval, end);
  Orders result{.time = plus.time};
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    for (std::size_t n = 0; n < plus.time.size(); ++n) {
      const double a = plus.elevation[g][n];
      const double b = minus.elevation[g][n];
      result.odd[g].push_back(0.5 * (a - b) / paddle.stroke);
      result.even[g].push_back(0.5 * (a + b) / (paddle.stroke * paddle.stroke));
    }
  }
  return result;
}

/// sqrt(sum (a - b)^2/sum b^2).
double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  double norm = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    difference += (a[n] - b[n]) * (a[n] - b[n]);
    norm += b[n] * b[n];
  }
  return std::sqrt(difference / norm);
}

/// Errors of the linear wave on meshes refined in all directions.
struct Convergence {
  std::vector<double> sizes;
  Gauges errors;            ///< relative L2, one per mesh
  std::vector<double> all;  ///< the largest of the gauges

  [[nodiscard]] evidence::ObservedOrder order() const { return evidence::observed_order(sizes, all); }
};

/// What the parameters decide.
struct SetUp {
  SoftPiston paddle;
  Mesh mesh;
  exact::Wavemaker settled;
  double interval, end;
};

SetUp set_up(const Values& values) {
  const double period = values.real("period");
  const SoftPiston paddle{2 * std::numbers::pi / period, values.real("stroke"), values.text("start") == "jump"};
  return {paddle,
          {values.real("h1"), values.integer("rows"), values.real("tau")},
          {exact::Paddle::piston, {1, 1}, exact::AngularFrequency{paddle.omega}},
          period / 40,
          values.real("periods") * period};
}

Convergence converge(const Run& run, const SetUp& s, const Gauges& theory) {
  const std::array<double, 4> factors{0.5, 1, 1.5, run.tier() == Tier::quick ? 2.0 : 3.0};
  const SoftPiston tiny = s.paddle.with_stroke(1e-5);
  Convergence c;
  for (const double factor : factors) {
    const Mesh finer = s.mesh.refined(factor);
    const Series result = make_waves(tiny, finer, mechanics::stepping_named(run.text("scheme")), s.interval, s.end);
    c.sizes.push_back(finer.spacing);
    Worst all;
    for (std::size_t g = 0; g < gauges.size(); ++g) {
      std::vector<double> linear = result.elevation[g];
      for (double& eta : linear) eta /= tiny.stroke;
      c.errors[g].push_back(distance(linear, theory[g]));
      all.add(c.errors[g].back());
    }
    c.all.push_back(all.value());
    run.progress(0.7 * factor / factors.back());
  }
  return c;
}

struct Results {
  SetUp set_up;
  Orders high, low;  ///< of the stroke, and of half of it
  Gauges theory;
  Convergence convergence;
};

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  claims.only_if(!s.paddle.sudden, "no mesh resolves all waves of a piston with discontinuous velocity")
      .check(
          "order", "The error of the linear wave against linear theory converges at second order.",
          "order of the largest relative L2 error of the gauges",
          [](const Results& r) { return r.convergence.order(); },
          Order{.theory = 2,
                .tolerance = 0.5,
                .reason = "second order in cells and steps; half an order for coarse meshes and the corner of piston "
                          "and surface"});
  const double steepness = s.settled.wavenumber() * s.paddle.stroke;
  claims.at(s.mesh.name())
      .check(
          "second-order", "The second-order elevation is proportional to the square of the stroke.",
          "largest relative L2 distance of the even parts over the stroke's square",
          [](const Results& r) {
            return worst(
                each(indices(gauges.size()), [&](std::size_t g) { return distance(r.high.even[g], r.low.even[g]); }));
          },
          Bound{.limit = 10 * steepness * steepness,
                .reason = "the next even order is the fourth, relative to the second (k S)^2 times a coefficient of "
                          "order one, which grows with the distance travelled, 10 h"});
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  r.high = orders(s.paddle, s.mesh, run, s.interval, s.end);
  r.low = orders(s.paddle.with_stroke(s.paddle.stroke / 2), s.mesh, run, s.interval, s.end);
  const SoftPiston unit = s.paddle.with_stroke(1);
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    r.theory[g] = unit.elevation(gauges[g], s.interval, r.high.time.size());
  }
  r.convergence = converge(run, s, r.theory);
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const SetUp& s = r.set_up;
  exhibit.measure("wavelength", s.settled.wavelength());
  exhibit.measure("height_per_stroke", s.settled.height_per_stroke());
  auto& errors = add_panel(exhibit, "convergence", "Errors of the linear wave",
                           "Relative L2 difference from the exact transient at the gauges; rows and steps in "
                           "proportion to the columns.",
                           {.x = "h1 [depth]", .y = "relative error", .log_x = true, .log_y = true});
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    errors.points(fmt::format("gauge at {:g}", gauges[g]), r.convergence.sizes, r.convergence.errors[g],
                  g == 0 ? Role::computed : Role::peer);
  }
  slope_guide(errors, 2, r.convergence.sizes, r.convergence.all.back());
  const double stroke = s.paddle.stroke;
  auto& waves = exhibit.figure(
      "gauges", "Elevation at the gauges",
      fmt::format("Over the stroke {:g}, with the exact transient of linear theory; {}.", stroke, s.mesh.name()));
  auto& second =
      exhibit.figure("second-order", "Second order",
                     "Even part in the stroke, over the square of the stroke: for the stroke and for half of it.");
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    const std::string title = fmt::format("x/h = {:g} from the piston", gauges[g]);
    auto& panel = waves.panel({.x = "t [sqrt(depth/g)]", .y = "elevation/stroke", .title = title});
    panel.line("linear theory", r.high.time, r.theory[g], Role::exact);
    panel.line("mesh", r.high.time, r.high.odd[g], Role::computed);
    auto& even = second.panel({.x = "t [sqrt(depth/g)]", .y = "elevation depth/stroke^2", .title = title});
    even.line(fmt::format("stroke {:g}", stroke), r.high.time, r.high.even[g], Role::computed);
    even.line(fmt::format("stroke {:g}", stroke / 2), r.low.time, r.low.even[g], Role::peer);
  }
}

void wavemaker_mesh(Case& c) {
  c.former_names = {"wavemaker_2d"};
  c.title = "Piston started from rest: two-dimensional Lagrangian mesh";
  c.source = "E. H. Kennard, Quart. Appl. Math. 7 (1949) 303; " + literature::frank + ", chapter 2";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("period", 10.0, "sqrt(depth/g)", {3, 30}, "of the piston"),
      real("stroke", 0.05, "depth", {1e-5, 0.3}, "from one end of the piston's motion to the other"),
      choice("start", "soft", {"soft", "jump"}, "soft or discontinuous start of the piston velocity"),
      real("periods", 3.0, "1", {0.5, 10}, "length of the run in periods"),
      real("h1", 0.125, "depth", {0.02, 1}, "width of the columns"),
      integer("rows", 8, {4, 64}, "rows of cells"),
      real("tau", 0.1, "sqrt(depth/g)", {1e-3, 0.5}, "time step"),
      choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"},
             "time stepping; the first is Frank's"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wavemaker_mesh
