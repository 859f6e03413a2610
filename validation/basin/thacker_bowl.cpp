/*
Frictionless water in a paraboloid (Thacker 1981): a circulating plane surface of constant outline, or a pulsating
paraboloid. The shoreline runs over a dry bed in both horizontal directions.

**What is compared.** The case shows the solution and the residuals of its identities, and accepts external results: the
depth at three gauges, which fall dry under the circulating surface, and the surface along $y = 0$ at one instant.

**What to look at.** The circulating surface is example `bowl-slosh` of GeoClaw; the pulsating one, in a bowl 50 m deep
and 430.62 km in radius, is the wetting-and-drying test of Thetis. `examples/solvers/published` scores the result files
published with both.
*/
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/thacker.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::thacker_bowl {

const std::string source = "Thacker (1981)";

/// One of the two motions.
struct Water {
  std::function<double(double x, double y, double t)> depth;
  std::function<double(double x, double y)> bed;
  std::function<exact::SelfTest()> self_test;
  double period = 0;
  double reach = 0;     ///< how far from the middle the water ever comes
  std::string command;  ///< that prints it

  /// Where y = 0 is wet at time t, of 201 points.
  [[nodiscard]] std::vector<double> wet(double t) const {
    std::vector<double> x = evenly(-reach, reach, 201);
    std::erase_if(x, [&](double at) { return depth(at, 0, t) == 0; });
    return x;
  }
  [[nodiscard]] double surface(double x, double t) const { return depth(x, 0, t) + bed(x, 0); }
};

template <class Bowl>
Water water(const Values& values, const std::string& name, const std::string& start, double reach) {
  const double gravity = values.real("gravity");
  const double radius = values.real("radius");
  const double depth = values.real("depth");
  const Bowl bowl(gravity, radius, depth, values.real(start));
  return {[bowl](double x, double y, double t) { return bowl.at(x, y, t).depth; },
          [bowl](double x, double y) { return bowl.bed(x, y); },
          [bowl] { return bowl.self_test(); },
          bowl.period(),
          reach,
          fmt::format("seiche exact {} --set radius={},depth={},gravity={},{}={}", name, radius, depth, gravity, start,
                      values.real(start))};
}

Water water_of(const Values& values) {
  const double radius = values.real("radius");
  if (values.text("motion") == "circling") {
    return water<exact::ThackerPlanarBowl>(values, "thacker_planar", "displacement",
                                           radius + values.real("displacement"));
  }
  return water<exact::ThackerRadialBowl>(values, "thacker_radial", "start_radius",
                                         radius * std::sqrt(radius / values.real("start_radius")));
}

void show(const Water& water, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("period", water.period);
  auto& panel = add_panel(exhibit, "section", "The section along y = 0",
                          "Surface at the start, after a quarter and after half of a period, and bed.",
                          {.x = "x [m]", .y = "elevation [m]"});
  const std::vector<double> x = evenly(-1.5 * values.real("radius"), 1.5 * values.real("radius"), 201);
  panel.fill("bed", x, each(x, [&](double at) { return water.bed(at, 0); }), Role::bed);
  for (const double part : {0.0, 0.25, 0.5}) {
    const double t = part * water.period;
    const std::vector<double> wet = water.wet(t);
    panel.line(fmt::format("t = {:g} T", part), wet, each(wet, [&](double at) { return water.surface(at, t); }),
               Role::exact);
  }
}

std::vector<WantedTable> wanted(const Values& values) {
  const Water water = water_of(values);
  const double radius = values.real("radius");
  const double time = values.real("time");
  const double end = values.real("periods") * water.period;
  const std::map<double, std::pair<double, double>> places{
      {1, {radius / 2, radius / 2}}, {2, {-radius / 2, 0}}, {3, {0, -radius / 4}}};
  std::vector<std::string> series;
  for (const auto& [gauge, place] : places) {
    series.push_back(fmt::format("{} --grid x={},y={},t=0:{}:101", water.command, place.first, place.second, end));
  }
  return {
      {.name = "gauges",
       .kind = WantedTable::Kind::series,
       .group = Column{"gauge", "1", "number of the gauge: (a/2, a/2), (-a/2, 0) and (0, -a/4) from the centre"},
       .abscissa = Column{"t", "s", "time"},
       .quantities = {{.column = {"h", "m", "depth, 0 where dry"},
                       .reference =
                           [=](Place p) {
                             const auto& [x, y] = places.at(p.group);
                             return water.depth(x, y, p.abscissa);
                           },
                       .requirements = {within_tolerance(Measure::relative_l2, values,
                                                         "Depth at the gauge agrees with the exact motion.", source)}}},
       .groups = {1, 2, 3},
       .points = [end](double) { return evenly(0, end, 101); },
       .places = places,
       .exact = series},
      {.name = "section",
       .kind = WantedTable::Kind::profile,
       .abscissa = Column{"x", "m", "position from the centre, at y = 0 and the parameter time"},
       .quantities = {{.column = {"eta", "m", "surface elevation above the rim, where wet"},
                       .reference = [=](Place p) { return water.surface(p.abscissa, time); },
                       .requirements = {within_tolerance(Measure::relative_l2, values,
                                                         "The surface agrees with the exact motion.", source)}}},
       .points = [=](double) { return water.wet(time); },
       .exact = {fmt::format("{} --grid x={}:{}:201,y=0,t={}", water.command, -2 * radius, 2 * radius, time)}}};
}

void thacker_bowl(Case& c) {
  c.title = "Circulating or pulsating water in a paraboloid";
  c.source =
      "W. C. Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981) "
      "499";
  c.parameters = {
      choice("motion", "circling", {"circling", "pulsating"}, "the surface a plane, or a paraboloid"),
      real("radius", 1.0, "m", {1e-3, 1e7}, "of the bowl's rim"),
      real("depth", 0.1, "m", {1e-6, 1e5}, "of the bowl below its rim"),
      real("displacement", 0.5, "m", {1e-6, 1e7}, "circling: of the water's centre from the bowl's centre"),
      real("start_radius", 0.8, "m", {1e-6, 1e7}, "pulsating: r0, at rest at t = 0 inside sqrt(radius r0)"),
      real("periods", 1.0, "1", {1e-3, 1000}, "length of the records of the gauges"),
      real("time", 2.0, "s", {0, 1e9}, "instant of the section"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      tolerance_parameter(),
  };
  c.study = exact_study<water_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::thacker_bowl
