/*
A round drop without gravity, with initial velocities linear in position, becomes an ellipse: Dirichlet's exact
solution, a free-surface test for Frank's overlapping particles (section 5.1).

**Set-up.** The initial velocity gradient is `xx`, `xy`, `yx` and `yy` $= -$`xx`; by default $u = x$, $v = -y$.
Staggered rows of particles of equal mass in the unit disc and on its rim, except at the ends of the middle row. A
control volume of radius $S/2$ = `smoothing`/2 spacings is centred on every particle, and its mass is constant. The
initial velocities are projected on that constraint.

**What is compared.** Particle positions with the exact ones; the semi-axes of the linear map fitted to the particle
motion with the exact ones; both at 5, 7, 10, ... spacings per radius, with steps in proportion.

**What to look at.** Next to the surface control volumes are half empty, and constant mass in them is not constant
volume: the projection removes some per cent of the velocity there. Particle positions therefore converge at first
order. The stretch, a mean over them, is more accurate, but scatters between resolutions with the way the rim is cut:
the six particles on it alone change its error twofold at ten spacings per radius. Balls as the source defines them
(`shape = ball`, `smoothing` 1.6) converge at first order too, with a stretch error of 3 % at the finest spacing; the
source states no radius, 1.6 is a choice made here. Wider balls resist more: with 10 spacings per radius the stretch is
low by 0.9, 2.5 and 7.9 % for `smoothing` 1.2, 1.3 and 1.6. Below 1.5 particles separate in pairs, whose multipliers are
not unique: those two values were computed with a stabilisation of $10^{-9}$, and their order of convergence is
undetermined, because the error scatters between resolutions.

**Limits of this test.** Pressures: the multipliers are chequered, and no multiple of them is the drop's pressure.
Rotation faster than strain (`xx` 0.5, `xy` -1, `yx` 1, `yy` -0.5) has a pressure below the surroundings and an unstable
surface; the links between particles bear tension and follow the exact motion for a time that shortens with the spacing:
until t = 1 to 0.01 % of the stretch with a spacing of 0.1, to 2.4 % with 0.05.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "seiche/models/overlapping_particles/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/refinement.hpp"
#include "validation/drop/affine_motion.hpp"
#include "validation/instruments/exact/affine_drop.hpp"

namespace seiche::validation::cases::ellipse_overlapping {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using exact::AffineDrop;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 5.1; Dirichlet (1860)";

constexpr std::array lattices{5, 7, 10, 14, 20, 28, 40};  ///< spacings to the radius
constexpr std::array drawn{5, 10, 20};
constexpr double usual_smoothing = 2.6;
constexpr double smoothing_of_balls = 1.6;

/// What the parameters decide.
struct SetUp {
  Matrix2d gradient;  ///< of the velocity at the beginning
  AffineDrop drop;
  overlapping_particles::Settings settings;
  double spacing, tau, end;

  /// About as many as the rows hold.
  [[nodiscard]] double particles() const { return 2 * std::numbers::pi / std::numbers::sqrt3 / (spacing * spacing); }
  [[nodiscard]] double strain() const { return gradient.norm() / std::numbers::sqrt2; }
  [[nodiscard]] bool balls() const { return settings.shape == overlapping_particles::Shape::ball; }
  [[nodiscard]] bool usual() const { return settings.support == (balls() ? smoothing_of_balls : usual_smoothing); }
};

/// Throws std::invalid_argument for a gradient that does not keep volume.
SetUp set_up(const Values& values) {
  Matrix2d gradient;
  gradient << values.real("xx"), values.real("xy"), values.real("yx"), values.real("yy");
  if (gradient.trace() != 0) {
    throw std::invalid_argument(
        fmt::format("xx + yy = {:g} is out of range: must be 0, for constant volume", gradient.trace()));
  }
  if (gradient.norm() == 0) {
    throw std::invalid_argument("xx = xy = yx = yy = 0 is out of range: at least one must be non-zero");
  }
  return {gradient,
          AffineDrop(Matrix2d::Identity(), gradient),
          {.shape = overlapping_particles::shape_named(values.text("shape")), .support = values.real("smoothing")},
          values.real("spacing"),
          values.real("tau"),
          values.real("time")};
}

/// Semi-axes of what becomes of the unit disc, the larger first.
Vector2d stretch_of(const Matrix2d& deformation) {
  return Eigen::JacobiSVD<Matrix2d>(deformation).singularValues();
}

struct Places {
  double time = 0;
  std::vector<double> x, y;
};

/// A drop of particles and how far it is from the exact one.
struct Drop {
  overlapping_particles::Particles first;
  std::vector<Places> frames = {};  ///< at the beginning, about the middle, at the end
  Vector2d stretch = Vector2d::Zero();
  double rms = 0;    ///< of the distances from the exact places
  double taken = 0;  ///< part of the velocity that the first projection took, rms

  [[nodiscard]] Vector2d label(std::size_t k) const { return {first.x[k], first.y[k]}; }
};

Drop run_drop(const SetUp& s, double spacing, double tau) {
  Drop drop{.first = overlapping_particles::staggered_disc(1, spacing)};
  overlapping_particles::Flow flow(drop.first, linear_velocity(s.gradient), s.settings);
  Mean given, taken;
  for (std::size_t k = 0; k < drop.first.size(); ++k) {
    const Vector2d u = s.gradient * drop.label(k);
    given.add(u.norm());
    taken.add((Vector2d(flow.u()[k], flow.v()[k]) - u).norm());
  }
  drop.taken = taken.rms() / given.rms();
  const auto keep = [&] {
    drop.frames.push_back({flow.time(), {flow.x().begin(), flow.x().end()}, {flow.y().begin(), flow.y().end()}});
  };
  keep();
  march(flow, s.end, tau, [&] {
    if (drop.frames.size() == 1 && 2 * flow.time() >= s.end - tau) keep();
  });
  keep();
  const Matrix2d deformation = s.drop.at(s.end).deformation;
  Mean apart;
  Matrix2d moved = Matrix2d::Zero();
  Matrix2d labels = Matrix2d::Zero();
  for (std::size_t k = 0; k < drop.first.size(); ++k) {
    const Vector2d place(flow.x()[k], flow.y()[k]);
    apart.add((place - deformation * drop.label(k)).norm());
    moved += place * drop.label(k).transpose();
    labels += drop.label(k) * drop.label(k).transpose();
  }
  drop.stretch = stretch_of(moved * labels.inverse());
  drop.rms = apart.rms();
  return drop;
}

struct Results {
  SetUp set_up;
  Drop own;
  std::vector<Drop> coarser = {};  ///< of the lattices that are drawn
  Refinement refinement = {};
  Vector2d exact;  ///< stretch
};

RefinementStudy study_of_orders() {
  return {.quantities = {{"places", "places, rms",
                          "Particle positions converge to the exact drop at an order between 1 and 3/2.",
                          Order{1.25, 0.5,
                                "between 1, if the velocity lost beside the surface, a fraction h, slows all water, "
                                "and 3/2, for errors of size h in a layer of width h alone"}},
                         {"stretch", "larger semi-axis"}},
          .source = source};
}

std::vector<int> lattices_of(const SetUp& s) {
  std::vector<int> chosen;
  std::ranges::copy_if(lattices, std::back_inserter(chosen), [&](int n) { return n * s.spacing < 1.001; });
  return chosen;
}

void claims(const Values& values, const Claims<Results>& all) {
  const SetUp s = set_up(values);
  const bool published = values.as_published("frank-overlapping");
  const Claims<Results> claims =
      all.at(fmt::format("h = {:g}, tau = {:g}", s.spacing, s.tau))
          .only_if(
              s.gradient.determinant() < 0,
              "the surface of a drop that rotates faster than it is strained is unstable, more so at finer spacings")
          .only_if(s.usual(), "volumes of another width agree qualitatively only");
  const double deformed = s.strain() * s.end;
  const auto judge = [&](const Claims<Results>& list, double missed) {
    return list.only_if(!s.balls() || published, "the error with balls depends on the particle arrangement")
        .fails({.value = missed,
                .width = 0.02 * std::abs(missed),
                .reason = "balls that overlap more than their six neighbours resist the stretch: at 10 spacings it is "
                          "low by 0.9, 2.5 and 7.9 % with S = 1.2, 1.3 and 1.6; below 1.5 particles separate in pairs "
                          "and the system is singular"},
               s.balls());
  };
  judge(claims, 0.0720869)
      .check(
          "places", "The particle positions agree with the exact drop to about one spacing.",
          "rms distance from the exact positions [radius]", [](const Results& r) { return r.own.rms; },
          Bound{s.spacing * deformed,
                "one spacing, the uncertainty of the surface, strained like the drop: first order"});
  judge(
      claims.only_if(deformed <= 1.2 && s.spacing <= 0.1, "for drops of the aspect ratio of the source's first tests"),
      -0.0308398)
      .check(
          "stretch", "The larger semi-axis agrees with the exact drop.", "relative error",
          [](const Results& r) { return r.own.stretch[0] / r.exact[0] - 1; },
          Bound{std::pow(s.settings.support * s.spacing / 2, 2),
                "the projection removes a velocity component orthogonal to the rest, over half a control volume, S/2, "
                "and its square from the energy, which drives the stretch"});
  study_of_orders().claim_orders(claims.of(&Results::refinement)
                                     .only_if(deformed <= 1.2 && lattices_of(s).size() >= 5,
                                              "five spacings, at which the drop is many spacings thick"));
}

Results compute(const Run& run) {
  const SetUp s = set_up(run);
  Results r{.set_up = s, .own = run_drop(s, s.spacing, s.tau), .exact = stretch_of(s.drop.at(s.end).deformation)};
  run.progress(0.4);
  for (const int n : lattices_of(s)) {
    const double spacing = 1.0 / n;
    Drop drop = run_drop(s, spacing, s.tau / s.spacing * spacing);
    r.refinement.add(n, {drop.rms, std::abs(drop.stretch[0] - r.exact[0])});
    if (std::ranges::count(drawn, n) > 0) r.coarser.push_back(std::move(drop));
    run.progress(0.4 + 0.6 * std::pow(n * s.spacing, 3));
  }
  return r;
}

void draw_drops(const Results& r, evidence::Exhibit& exhibit) {
  auto& particles = exhibit.figure("particles", "The drop", "Particles, and the exact outline.", {"frank-overlapping"});
  for (const auto& [time, x, y] : r.own.frames) {
    draw_drop(particles, fmt::format("t = {:g}", time), "particles", x, y, r.set_up.drop, time);
  }
  if (r.coarser.empty()) return;
  auto& outlines = exhibit.figure("outlines", "Outline at three spacings",
                                  "Final positions of the particles that were within one spacing of the rim.",
                                  {"frank-overlapping"});
  for (const Drop& drop : r.coarser) {
    const Places& end = drop.frames.back();
    std::vector<double> x, y;
    for (std::size_t k = 0; k < drop.first.size(); ++k) {
      if (drop.label(k).norm() < 1 - drop.first.spacing) continue;
      x.push_back(end.x[k]);
      y.push_back(end.y[k]);
    }
    draw_drop(outlines, fmt::format("h = {:g}", drop.first.spacing), "particles of the rim", x, y, r.set_up.drop,
              end.time);
  }
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  draw_drops(r, exhibit);
  if (r.refinement.n().size() > 1) {
    const RefinementStudy study = study_of_orders();
    study.draw(r.refinement, add_panel(exhibit, "convergence", "Errors against the spacing",
                                       "Spacings per radius; grey lines have slopes 1 and 2.",
                                       {.x = "1/h", .y = "error", .log_x = true, .log_y = true}));
    study.tabulate(r.refinement, exhibit);
  }
  exhibit.measure("stretch_smaller", r.own.stretch[1]);
  exhibit.measure("stretch_smaller_exact", r.exact[1]);
  exhibit.measure("taken_at_start", r.own.taken);
  exhibit.measure("particles", static_cast<double>(r.own.first.size()));
}

void ellipse_overlapping(Case& c) {
  c.title = "Stretching of a liquid drop: overlapping particles";
  c.source = source;
  c.parameters = {
      real("xx", 1.0, "1", {-5, 5}, "initial velocity gradient du/dx"),
      real("xy", 0.0, "1", {-5, 5}, "initial velocity gradient du/dy"),
      real("yx", 0.0, "1", {-5, 5}, "initial velocity gradient dv/dx"),
      real("yy", -1.0, "1", {-5, 5}, "initial velocity gradient dv/dy, the opposite of xx"),
      real("spacing", {0.05, 0.025, 0.025}, "1", {0.01, 0.5}, "of the particles, in radii"),
      real("tau", {0.01, 0.005, 0.005}, "1", {1e-5, 0.5}, "time step"),
      real("time", 1.0, "1", {0.01, 10}, "end of the run"),
      choice("shape", "smoothed", {"smoothed", "ball"}, "of particles and control volumes"),
      real("smoothing", usual_smoothing, "1", {1.5, 10}, "S, diameter of a control volume, in spacings"),
  };
  c.published = {{.tiles = {"frank-overlapping"},
                  .values = {{"shape", std::string("ball")}, {"smoothing", smoothing_of_balls}},
                  .stated = {"shape"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::ellipse_overlapping
