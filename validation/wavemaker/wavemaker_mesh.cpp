/*
A piston starts to oscillate at the end of a long tank at rest. The two-dimensional Lagrangian mesh (Frank 1994, chapter
2) follows it: the nodes of its first column are where the piston is and slide up and down on it. Depth and gravity
are 1.

**Set-up.** The piston moves by $\tfrac12 S\,r(t)\sin\omega t$, where $r$ rises from 0 to 1 during the first period
(`soft`) or is 1 (`jump`): its velocity then jumps, and the first velocities of the water follow from it, for the areas
of all cells must stay. The tank ends at a wall 20 depths away, and the run ends before the first wave is back at a
gauge.

**What is compared.** The elevation at gauges 2, 5 and 10 depths from the piston with the exact transient of linear
theory; for the soft start, with Duhamel's integral of it. Runs with $S$ and $-S$ separate what changes sign with the
stroke from what does not. Half of the difference is the linear wave, but for a third order; half of the sum is the
second order, which linear theory leaves out. It must be four times as high for twice the stroke.

**What to look at.** The front that arrives first is the lowest and longest part of the wave; nothing of it resembles
the settled wave. The difference from theory falls by four when cells and steps are halved. A piston that jumps sends
out short waves of all lengths. Their height falls with the wavenumber like $k^{-3/4}$ only, no mesh resolves them all,
and the difference falls as slowly. The second order has twice the frequency: crests become sharper, troughs flatter.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/wavemaker.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "validation/wavemaker/soft_piston.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;
using lagrangian_mesh_2d::Flow;

const std::string source = "Kennard (1949); Frank (1994), chapter 2";
constexpr double tank = 20;
constexpr std::array<double, 3> gauges{2, 5, 10};
using Gauges = std::array<std::vector<double>, gauges.size()>;

struct Paddle {
  double omega;
  double stroke;
  bool sudden;
  [[nodiscard]] SoftPiston motion() const { return {omega, stroke, sudden}; }
  [[nodiscard]] Paddle with_stroke(double other) const { return {omega, other, sudden}; }
};

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
Series make_waves(const Paddle& paddle, const Mesh& resolution, mechanics::Stepping stepping, double interval,
                  double end) {
  auto mesh =
      lagrangian_mesh_2d::layer_mesh({.begin = 0,
                                      .end = tank,
                                      .depth = 1,
                                      .columns = static_cast<std::size_t>(std::lround(tank / resolution.spacing)),
                                      .rows = static_cast<std::size_t>(resolution.rows)});
  mesh.sides.left =
      lagrangian_mesh_2d::MovingWall{.place = [piston = paddle.motion()](double t) { return piston.place(t); },
                                     .velocity = [piston = paddle.motion()](double t) { return piston.velocity(t); }};
  Flow flow(std::move(mesh), {}, {.stepping = stepping});
  Series series;
  const auto samples = std::lround(end / interval);
  for (long n = 1; n <= samples; ++n) {
    flow.advance_to(static_cast<double>(n) * interval, resolution.tau);
    series.time.push_back(flow.time());
    const std::vector<double> elevation = flow.elevation_at(gauges);
    for (std::size_t g = 0; g < gauges.size(); ++g) series.elevation[g].push_back(elevation[g]);
  }
  return series;
}

/// What changes sign with the stroke, over the stroke, and what does not, over its square.
struct Orders {
  std::vector<double> time;
  Gauges odd, even;
};

Orders orders(const Paddle& paddle, const Mesh& mesh, const Run& run, double interval, double end) {
  const auto stepping = mechanics::stepping_named(run.text("scheme"));
  const Series plus = make_waves(paddle, mesh, stepping, interval, end);
  const Series minus = make_waves(paddle.with_stroke(-paddle.stroke), mesh, stepping, interval, end);
  Orders result{.time = plus.time, .odd = {}, .even = {}};
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

void claim_linear(Running& run, const Paddle& paddle, const Mesh& mesh, const Gauges& theory, double interval, double end) {
  const std::array<double, 4> factors{0.5, 1, 1.5, run.tier() == Tier::quick ? 2.0 : 3.0};
  const Paddle tiny = paddle.with_stroke(1e-5);
  std::vector<double> sizes;
  std::array<std::vector<double>, gauges.size()> errors;
  std::vector<double> all;
  for (const double factor : factors) {
    const Mesh finer = mesh.refined(factor);
    const Series result = make_waves(tiny, finer, mechanics::stepping_named(run.text("scheme")), interval, end);
    sizes.push_back(finer.spacing);
    double worst = 0;
    for (std::size_t g = 0; g < gauges.size(); ++g) {
      std::vector<double> linear = result.elevation[g];
      for (double& eta : linear) eta /= tiny.stroke;
      errors[g].push_back(distance(linear, theory[g]));
      worst = std::max(worst, errors[g].back());
      if (factor == 1) {
        run.record.measure(fmt::format("relative_error_at_{:g}", gauges[g]), errors[g].back());
      }
    }
    all.push_back(worst);
    run.progress(0.7 * factor / factors.back());
  }
  const evidence::ObservedOrder observed = evidence::observed_order(sizes, all);
  run.record.measure("order", observed.order);
  if (!paddle.sudden) {
    run.record.check({.id = "order",
                      .text = "The linear wave converges to linear theory with the second order.",
                      .quantity = "order of the largest relative L2 error of the gauges",
                      .source = source},
                     observed,
                     evidence::Order{.theory = 2,
                                     .tolerance = 0.5,
                                     .reason = "second order in cells and steps; half an order for coarse meshes and "
                                               "for where piston and surface meet"});
  }
  auto& panel = run.record
                    .figure("convergence", "Errors of the linear wave",
                            "Relative L2 difference from the exact transient at the gauges; rows and steps in "
                            "proportion to the columns.")
                    .panel({.x = "h1 [depth]", .y = "relative error", .log_x = true, .log_y = true});
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    panel.points(fmt::format("gauge at {:g}", gauges[g]), sizes, errors[g], g == 0 ? Role::computed : Role::peer);
  }
  slope_guide(panel, 2, sizes, all.back());
}

void run(Running& run) {
  const Paddle paddle{2 * std::numbers::pi / run.real("period"), run.real("stroke"), run.text("start") == "jump"};
  const Mesh mesh{run.real("h1"), run.integer("rows"), run.real("tau")};
  const double end = run.real("periods") * run.real("period");
  const double interval = run.real("period") / 40;
  const exact::Wavemaker settled(exact::Paddle::piston, 1, 1, paddle.omega);
  const SoftPiston unit = paddle.with_stroke(1).motion();
  run.record.measure("wavelength", settled.wavelength());
  run.record.measure("height_per_stroke", settled.height_per_stroke());

  const Orders high = orders(paddle, mesh, run, interval, end);
  const Orders low = orders(paddle.with_stroke(paddle.stroke / 2), mesh, run, interval, end);
  Gauges theory;
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    theory[g] = unit.elevation(gauges[g], interval, static_cast<long>(high.time.size()));
  }
  claim_linear(run, paddle, mesh, theory, interval, end);

  double off = 0;
  auto& waves = run.record.figure(
      "gauges", "Elevation at the gauges",
      fmt::format("Over the stroke {:g}, with the exact transient of linear theory; {}.", paddle.stroke, mesh.name()));
  auto& second = run.record.figure("second-order", "The second order",
                                   "What does not change sign with the stroke, over its square: for the stroke and for "
                                   "half of it.");
  for (std::size_t g = 0; g < gauges.size(); ++g) {
    auto& panel = waves.panel({.x = "t [sqrt(depth/g)]",
                               .y = "elevation/stroke",
                               .title = fmt::format("{:g} depths from the piston", gauges[g])});
    panel.line("linear theory", high.time, theory[g], Role::exact);
    panel.line("mesh", high.time, high.odd[g], Role::computed);
    auto& even = second.panel({.x = "t [sqrt(depth/g)]",
                               .y = "elevation depth/stroke^2",
                               .title = fmt::format("{:g} depths from the piston", gauges[g])});
    even.line(fmt::format("stroke {:g}", paddle.stroke), high.time, high.even[g], Role::computed);
    even.line(fmt::format("stroke {:g}", paddle.stroke / 2), low.time, low.even[g], Role::peer);
    off = std::max(off, distance(high.even[g], low.even[g]));
    run.record.measure(fmt::format("second_order_at_{:g}", gauges[g]), *std::ranges::max_element(high.even[g]));
  }
  const double steepness = settled.wavenumber() * paddle.stroke;
  run.record.check(
      {.id = "second-order",
       .text = "What linear theory leaves out is four times as high for twice the stroke.",
       .quantity = "largest relative L2 distance of the even parts over the stroke's square",
       .source = source},
      {.value = off, .resolution = mesh.name()},
      Bound{.limit = 10 * steepness * steepness,
            .reason = "the next even order is the fourth, the square of k S relative to the second, times "
                      "a coefficient of order one, which grows with the ten depths that the wave has run"});
}

}  // namespace

Case wavemaker_mesh() {
  Case c;
  c.former_names = {"wavemaker_2d"};
  c.title = "A piston starts from rest: the two-dimensional Lagrangian mesh";
  c.source =
      "E. H. Kennard, Quart. Appl. Math. 7 (1949) 303; A. M. Frank, Discrete models of incompressible fluid, doctoral "
      "thesis (1994), chapter 2";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("period", 10.0, "sqrt(depth/g)", {3, 30}, "of the piston"),
      real("stroke", 0.05, "depth", {1e-5, 0.3}, "from one end of the piston's motion to the other"),
      choice("start", std::string("soft"), {"soft", "jump"}, "whether the piston's velocity rises or jumps"),
      real("periods", 3.0, "1", {0.5, 10}, "periods that are run"),
      real("h1", 0.125, "depth", {0.02, 1}, "width of the columns"),
      integer("rows", 8, {4, 64}, "rows of cells"),
      real("tau", 0.1, "sqrt(depth/g)", {1e-3, 0.5}, "time step"),
      choice("scheme", std::string("one_step"), {"one_step", "one_step_feedback", "conservative"},
             "stepping; Frank's is the first"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
