/*
A round liquid drop, without gravity or surface tension, has the initial velocity $u = \alpha x$, $v = -\alpha y$. It
remains an ellipse of constant area, and every particle's path is known: Dirichlet's ellipse, a usual test of particle
methods.

$$\alpha^2 (a^2 + b^2) = \mathrm{const}, \qquad p = \rho\,\frac{\alpha^2 a^2 b^2}{a^2 + b^2}
\left(1 - \frac{x^2}{a^2} - \frac{y^2}{b^2}\right).$$

**What is compared.** The case shows the semi-axes and the pressure at the centre. It accepts external results: the
semi-axes and the pressure as functions of time.

**What to look at.** The pressure: a method with a shape error of 1 % may have a pressure error several times as large.
*/
#include <memory>

#include "seiche/exact/affine_drop.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::stretching_drop {

const std::string source = "Dirichlet (1860); Longuet-Higgins (1972)";

exact::StretchingDrop drop_of(const Values& values) {
  return {values.real("radius"), values.real("radius"), values.real("strain_rate"), values.real("density")};
}

std::vector<double> times_of(const Values& values) {
  return evenly(0, values.real("time"), 101);
}

void show(const exact::StretchingDrop& drop, const Values& values, evidence::Exhibit& exhibit) {
  const std::vector<double> times = times_of(values);
  auto& figure = exhibit.figure("drop", "Semi-axes and pressure", "Along and across the stretching; at the centre.");
  auto& axes = figure.panel({.x = "t [s]", .y = "semi-axis [m]"});
  axes.line("along x", times, each(times, [&](double t) { return drop.semi_axis(t); }), Role::exact);
  axes.line("along y", times, each(times, [&](double t) { return drop.other_axis(t); }), Role::guide);
  figure.panel({.x = "t [s]", .y = "pressure [Pa]"})
      .line("centre", times, each(times, [&](double t) { return drop.at(t).central_pressure; }), Role::exact);
  exhibit.measure("reference_uncertainty", drop.uncertainty());
}

std::vector<WantedTable> wanted(const Values& values) {
  const auto drop = std::make_shared<const exact::StretchingDrop>(drop_of(values));
  const auto close = [&](const std::string& text) {
    return std::vector<Requirement>{within_tolerance(Measure::relative_l2, values, text, source)};
  };
  return {{.name = "drop",
           .kind = WantedTable::Kind::series,
           .abscissa = Column{"t", "s", "time"},
           .quantities = {{.column = {"a", "m", "semi-axis along x"},
                           .reference = [drop](Place p) { return drop->semi_axis(p.abscissa); },
                           .requirements = close("The semi-axis along x agrees with the exact solution.")},
                          {.column = {"b", "m", "semi-axis along y"},
                           .reference = [drop](Place p) { return drop->other_axis(p.abscissa); },
                           .requirements = close("The semi-axis along y agrees with the exact solution.")},
                          {.column = {"pressure", "Pa", "pressure at the centre"},
                           .reference = [drop](Place p) { return drop->at(p.abscissa).central_pressure; },
                           .requirements = close("The pressure at the centre agrees with the exact solution.")}},
           .points = [times = times_of(values)](double) { return times; }}};
}

void stretching_drop(Case& c) {
  c.title = "Stretching of a free liquid drop into an ellipse";
  c.source =
      "P. G. L. Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; M. S. Longuet-Higgins, J. Fluid Mech. 55 (1972) "
      "529";
  c.parameters = {
      real("radius", 1.0, "m", {1e-9, 1e6}, "radius at t = 0"),
      real("strain_rate", 1.0, "1/s", {1e-9, 1e6}, "strain rate at t = 0"),
      real("density", 1000.0, "kg/m^3", {1e-9, 1e9}, "density"),
      real("time", 2.0, "s", {1e-9, 1e6}, "end of the requested series"),
      tolerance_parameter(),
  };
  c.study = exact_study<drop_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::stretching_drop
