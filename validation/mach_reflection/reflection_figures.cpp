#include "validation/mach_reflection/reflection_figures.hpp"
#include "validation/instruments/each.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"

namespace seiche::validation {
namespace {

using evidence::Panel;
using exact::MachReflection;

/// "a = 0.3: h = 0.5, tau = 0.25, t = 318 .. 720".
std::string name_of(const ReflectionSeries& series) {
  const std::vector<double> ends = each(series.reflections, [](const Reflection& r) { return r.time.back(); });
  return fmt::format("a = {:g}: h = {:g}, tau = {:g}, t = {:.0f} .. {:.0f}", series.amplitude, series.spacing,
                     series.reflections.front().run.tau(), smallest(ends), largest(ends));
}

using Kappa = double (ReflectionRun::*)() const;

struct Axis {
  std::string label;
  Kappa kappa;
};
const std::vector<Axis> axes{{"psi_i/sqrt(3 a_i)", &ReflectionRun::kappa},
                             {"tan(psi_i)/(sqrt(3 a_i) cos(psi_i))", &ReflectionRun::kappa_finite_angle}};

std::vector<double> kappas(const ReflectionSeries& series, Kappa kappa) {
  return each(series.reflections, [kappa](const Reflection& r) { return (r.run.*kappa)(); });
}

/// Both branches, with the cusp of the upper one.
void theory_curve(Panel& panel, double (*ratio)(double), double last) {
  std::vector<double> kappa = evenly(0.1, 1, 46);
  for (double step = 1e-4; step < 0.05; step *= 1.6) kappa.push_back(1 + step);
  for (double k = 1.05; k <= last; k += 0.05) kappa.push_back(k);
  panel.line("theory of small waves", kappa, each(kappa, ratio), Role::exact);
}

double last_kappa(const std::vector<ReflectionSeries>& series, Kappa kappa) {
  const double last = largest(each(series, [&](const ReflectionSeries& one) { return kappas(one, kappa).back(); }));
  return std::min(std::max(last, 1.3) + 0.05, 2.7);
}

/// Where runs did not become steady: their limits.
void limits(Panel& panel, const std::vector<ReflectionSeries>& series, Kappa kappa) {
  std::vector<double> at, limit, error;
  for (const ReflectionSeries& one : series) {
    for (const Reflection& r : one.reflections) {
      if (r.limit.steady()) continue;
      at.push_back((r.run.*kappa)());
      limit.push_back(r.limit_ratio().value);
      error.push_back(r.limit_ratio().half_width());
    }
  }
  if (!at.empty()) panel.points("limit where a_w still grows by more than 1 %", at, limit, Role::data, error);
}

}  // namespace

void draw_amplitudes(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series) {
  auto& figure =
      exhibit.figure("amplitudes", "Amplitudes at the wall and of the reflected wave",
                     "Over the measured incident amplitude; bars: the scatter along the crests. Left against the "
                     "parameter of Miles (1977), right against that for finite angles of Li, Yeh and Kodama (2011). "
                     "Thin: Frank's largest a_w/a_i, 3.5, and his a_r/a_i of regular reflection, 0.95. a_w at the end "
                     "of the run; where the growth in the last fifth exceeds 1 % also its limit.",
                     {"frank-fig-7"});
  const auto draw = [&](const Axis& axis, const evidence::Axes& frame, double (*theory)(double),
                        Measurement (Reflection::*ratio)() const, double frank) {
    auto& panel = figure.panel(frame);
    theory_curve(panel, theory, *frame.x_max);
    for (const ReflectionSeries& one : series) {
      panel.points(name_of(one), kappas(one, axis.kappa),
                   each(one.reflections, [&](const Reflection& r) { return (r.*ratio)().value; }), Role::computed,
                   each(one.reflections, [&](const Reflection& r) { return (r.*ratio)().half_width(); }));
    }
    if (ratio == &Reflection::wall_ratio) limits(panel, series, axis.kappa);
    panel.line("Frank (1994)", std::vector{0.1, *frame.x_max}, std::vector{frank, frank}, Role::guide);
  };
  for (const Axis& axis : axes) {
    draw(axis, {.x = axis.label, .y = "a_w/a_i", .x_max = last_kappa(series, axis.kappa), .y_min = 1, .y_max = 4.1},
         MachReflection::wall_ratio, &Reflection::wall_ratio, 3.5);
  }
  for (const Axis& axis : axes) {
    draw(axis, {.x = axis.label, .y = "a_r/a_i", .x_max = last_kappa(series, axis.kappa), .y_min = 0, .y_max = 1.1},
         MachReflection::reflected_ratio, &Reflection::reflected_ratio, regular_from);
  }
}

void draw_regimes(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series, const Values& values) {
  auto& figure = exhibit.figure("regimes", "Regular and irregular reflection",
                                "Irregular: a_r below 0.95 a_i, or, on grids too coarse for that, below 0.99 of the "
                                "largest a_r. Curves: the boundary of Miles (1977) and kappa = 1 for finite angles. "
                                "Horizontal: transitions in experiments as quoted by Frank (1994).",
                                {"frank-fig-8"});
  auto& panel =
      figure.panel({.x = "a_i [depth]", .y = "psi_i [deg]", .x_min = 0, .x_max = 0.4, .y_min = 0, .y_max = 60});
  const std::vector<double> fine = evenly(1e-4, 0.4, 200);
  panel.line("psi = sqrt(3a)", fine, each(fine, [](double a) { return degrees(std::sqrt(3 * a)); }), Role::exact);
  panel.line("tan(psi)/cos(psi) = sqrt(3a)", fine, each(fine, resonant_angle), Role::exact);
  for (const bool regular : {false, true}) {
    std::vector<double> amplitude, angle;
    for (const ReflectionSeries& one : series) {
      for (std::size_t k = 0; k < one.angles.size(); ++k) {
        const double ratio = one.reflections[k].reflected_ratio().value;
        if (!std::isfinite(ratio) || (ratio < one.regular_ratio()) == regular) continue;
        amplitude.push_back(one.amplitude);
        angle.push_back(one.angles[k]);
      }
    }
    if (!angle.empty()) panel.points(regular ? "regular" : "irregular", amplitude, angle);
  }
  const io::Table published = values.table("mach_reflection_angles_published");
  for (std::size_t k = 0; k < published.column("angle").size(); ++k) {
    if (std::lround(published.column("quantity")[k]) != 1) continue;
    const double angle = published.column("angle")[k];
    const long source = std::lround(published.column("source")[k]);
    if (source == 1) {
      panel.points("Tanaka (1993)", std::vector{published.column("a_from")[k]}, std::vector{angle}, Role::data,
                   std::vector{0.5});
    } else {
      panel.line(source == 3 ? "Chen" : "Perroud (1957)", std::vector{0.0, 0.4}, std::vector{angle, angle},
                 Role::guide);
    }
  }
}

void draw_angle_law(evidence::Exhibit& exhibit, const ReflectionSeries& series, const AngleLaw& law, double last) {
  auto& panel = add_panel(exhibit, "angle-law", "The reflected amplitude against the square of the angle",
                          fmt::format("{}. Fit up to {:g} deg.", name_of(series), last),
                          {.x = "psi_i^2 [rad^2]", .y = "a_r [depth]", .x_min = 0, .y_min = 0}, {"frank-ar-law"});
  std::vector<double> square, amplitude, error;
  for (const Reflection& r : series.reflections) {
    if (!r.pattern.reflected) continue;
    square.push_back(r.run.angle * r.run.angle);
    amplitude.push_back(r.pattern.reflected->amplitude.value);
    error.push_back(r.pattern.reflected->amplitude.half_width());
  }
  panel.points("computed", square, amplitude, Role::computed, error);
  const auto through = [&](const std::string& label, double factor, Role role) {
    const double end = std::min(1.05 * square.back(), 1.05 * series.amplitude / factor);
    panel.line(label, std::vector{0.0, end}, std::vector{0.0, factor * end}, role);
  };
  through(fmt::format("{:.3f} psi_i^2, fitted", law.factor), law.factor, Role::computed);
  through("0.62 psi_i^2, Frank (1994)", 0.62, Role::data);
  through("psi_i^2/3, Miles (1977)", 1.0 / 3, Role::exact);
}

void draw_reflected_angles(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series) {
  auto& panel = add_panel(exhibit, "angles", "The angle of reflection",
                          "Bars: twice the standard error of the line through the reflected crest. In irregular "
                          "reflection psi_r falls as psi_i grows, where Miles (1977) gives sqrt(3 a_i), drawn up to "
                          "the transition; in regular reflection both angles are equal.",
                          {.x = "psi_i [deg]", .y = "psi_r [deg]", .y_min = 15, .y_max = 60});
  for (const ReflectionSeries& one : series) {
    panel.points(name_of(one), one.angles,
                 each(one.reflections, [](const Reflection& r) { return r.reflected_angle().value; }), Role::computed,
                 each(one.reflections, [](const Reflection& r) { return r.reflected_angle().half_width(); }));
  }
  for (const ReflectionSeries& one : series) {
    const double edge = degrees(std::sqrt(3 * one.amplitude));
    panel.line(fmt::format("Miles, a = {:g}", one.amplitude), std::vector{std::min(one.angles.front(), edge), edge},
               std::vector{edge, edge}, Role::guide);
  }
  panel.line("psi_r = psi_i", std::vector{15.0, 60.0}, std::vector{15.0, 60.0}, Role::exact);
}

void draw_growth(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series) {
  auto& figure = exhibit.figure("growth", "Amplitude at the wall against time",
                                "Over the measured incident amplitude, against the slow time of weakly nonlinear "
                                "waves. The growth is slowest near resonance.");
  for (const ReflectionSeries& one : series) {
    const double slow = std::pow(one.amplitude, 1.5);
    const std::string title = fmt::format("a = {:g}, h = {:g}", one.amplitude, one.spacing);
    auto& panel = figure.panel({.x = "a_i^(3/2) t [sqrt(depth/g)]", .y = "a_w/a_i", .title = title});
    const std::size_t stride = std::max<std::size_t>(one.angles.size() / 5, 1);
    for (std::size_t k = 0; k < one.angles.size(); ++k) {
      const Reflection& r = one.reflections[k];
      if (k % stride != 0 && &r != &one.highest()) continue;
      panel.line(fmt::format("{:g} deg{}", one.angles[k], r.limit.steady() ? "" : ", growing"),
                 each(r.time, [&](double t) { return slow * t; }),
                 each(r.wall, [&](double height) { return height / r.pattern.incident_amplitude.value; }));
    }
  }
}

void tabulate_reflections(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series) {
  evidence::Table& table =
      add_table(exhibit, "runs", "All runs",
                "kappa': for finite angles. Growth: of a_w in the last fifth of the run; a run with a growth of more "
                "than 1 % is unsteady, and its limit counts.",
                {"a [depth]", "psi_i [deg]", "kappa [1]", "kappa' [1]", "h [depth]", "end [sqrt(depth/g)]",
                 "a_i [depth]", "a_w/a_i [1]", "growth [1]", "steady", "limit [1]", "uncertainty [1]", "a_r/a_i [1]",
                 "psi_r [deg]", "stem angle [deg]", "iterations [1]", "cells [1]", "processor time [s]"});
  for (const ReflectionSeries& one : series) {
    for (std::size_t k = 0; k < one.angles.size(); ++k) {
      const Reflection& r = one.reflections[k];
      table.rows.push_back({one.amplitude, one.angles[k], rounded(r.run.kappa()), rounded(r.run.kappa_finite_angle()),
                            one.spacing, std::round(r.time.back()), rounded(r.pattern.incident_amplitude.value, 1e5),
                            rounded(r.wall_ratio().value), rounded(r.limit.growth),
                            std::string(r.limit.steady() ? "yes" : "no"), rounded(r.limit_ratio().value),
                            rounded(r.limit_ratio().half_width()), rounded(r.reflected_ratio().value),
                            rounded(r.reflected_angle().value, 1e2), rounded(degrees(r.stem.value), 1e3),
                            rounded(r.iterations, 10), static_cast<double>(r.cells), rounded(r.seconds, 10)});
    }
  }
}

}  // namespace seiche::validation
