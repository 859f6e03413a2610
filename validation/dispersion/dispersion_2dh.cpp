/*
Small waves of the discrete dispersive shallow-water model in plan (Frank 1994, section 4.2) have a frequency in closed
form. On cells $h_1 \times h_2$ over still water of depth $H$, with $T_i = (2/h_i)\tan(k_i h_i/2)$,
$K^2 = T_1^2 + T_2^2$ and $G = \tfrac19(2 + \cos k_1h_1)(2 + \cos k_2h_2)$,

$$\omega^2 = gH\,\frac{G K^2}{1 + \tfrac13 H^2 K^2}.$$

Along an axis of the lattice this is Frank's formula (13). Fine cells have the law of the Green-Naghdi equations,
$\omega^2 = gHk^2/(1 + \tfrac13 H^2k^2)$. Depth and gravity are 1.

**Set-up.** A box of whole half-waves between four walls; `h1` and `h2` are changed until whole numbers of cells fit.
Still water gets a vertical velocity of $10^{-8}$ in the shape of the wave.

**What is compared.** Twice: the eigenvalue of the linearised model for the wave, and the frequency in a run of the
one-step scheme, whose amplitudes obey $a_{n+1} + a_{n-1} = (2 - \omega^2\tau^2)\,a_n$. For the wave of the parameters,
and for a fan of directions.

**What to look at.** The lattice is not isotropic. Along its axes the error of long waves is of fourth order in $kh$,
for the errors of the pressure and of the inertia cancel; at an angle $\theta$ a term $-\tfrac1{48}(h_1^2 + h_2^2)\,k^2
\sin^2 2\theta$ of the frequency remains, largest at 45 degrees.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/plan_standing_mode.hpp"

namespace seiche::validation::cases::dispersion_2dh {
namespace {

constexpr double pi = std::numbers::pi;
const std::string source = "Frank (1994), formula 13 and section 4.2; closed form of the linearised cells";

struct Fitted {
  PlanTank tank;
  std::size_t half_waves_x = 0;
  std::size_t half_waves_y = 0;
};

/// A box of one half-wave each way (none across the axis that the wave runs along).
Fitted fitted(double kx, double ky, double h1, double h2) {
  const auto side = [](double k, double h, double& length, std::size_t& cells, std::size_t& half_waves) {
    const bool along = k < 1e-9;  // constant along this side
    half_waves = along ? 0 : 1;
    length = along ? 4 * h : pi / k;
    cells = std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(length / h)));
  };
  Fitted result;
  side(kx, h1, result.tank.length, result.tank.columns, result.half_waves_x);
  side(ky, h2, result.tank.width, result.tank.rows, result.half_waves_y);
  constexpr double most = 4e6;  // some gigabytes
  if (const double cells = static_cast<double>(result.tank.columns) * static_cast<double>(result.tank.rows);
      cells > most) {
    throw std::invalid_argument(fmt::format(
        "h1 = {:g}, h2 = {:g} and the wavenumber make {:.3g} cells: must be at most {:g}", h1, h2, cells, most));
  }
  return result;
}

Fitted own_box(const Values& values) {
  const double k = values.real("wavenumber");
  const double direction = values.real("direction") * pi / 180;
  return fitted(k * std::cos(direction), k * std::sin(direction), values.real("h1"), values.real("h2"));
}

/// Waves in a box of 24 x 24 cells of h1 x h2, long and short, in many directions.
PlanTank fan_tank(const Values& values) {
  return {.columns = 24, .rows = 24, .length = 24 * values.real("h1"), .width = 24 * values.real("h2")};
}
constexpr double fan_phase = 0.1;  // omega tau
constexpr double fan_periods = 5;
const std::vector<std::pair<std::size_t, std::size_t>> fan_modes = {
    {1, 0}, {0, 1}, {1, 1}, {3, 1}, {2, 5}, {6, 6}, {9, 0}, {4, 11}, {12, 7}, {15, 15}, {20, 3}, {21, 20}};

/// Relative deviations from the closed form.
struct Deviations {
  double eigenvalue = 0;
  double run = 0;
};

/// So small that the second order of the waves is below rounding.
constexpr double first_velocity = 1e-8;

Deviations deviations(const PlanMode& mode, double periods, double tau) {
  const double omega = mode.linear_frequency();
  const int steps = static_cast<int>(std::ceil(2 * pi * periods / (omega * tau)));
  return {std::abs(mode.eigenvalue().square / (omega * omega) - 1),
          std::abs(mode.measured_frequency(tau, steps, first_velocity) / omega - 1)};
}

struct Results {
  std::vector<Deviations> own;
  std::vector<Deviations> fan;
};

/// Of the equation for the pressure, 1 - H^2/3 times the differences of the cells.
double condition(const PlanTank& tank) {
  const double h1 = tank.length / static_cast<double>(tank.columns);
  const double h2 = tank.width / static_cast<double>(tank.rows);
  return 1 + tank.inertia * tank.depth * tank.depth * (4 / (h1 * h1) + 4 / (h2 * h2));
}

/// @param phase  omega tau
void claim_law(const Claims<std::vector<Deviations>>& claims, const std::string& id, const std::string& what,
               const PlanTank& tank, double phase, double periods) {
  const auto largest = [](double Deviations::*of) {
    return [of](const std::vector<Deviations>& found) {
      Worst worst;
      for (const Deviations& d : found) worst.add(d.*of);
      return worst;
    };
  };
  claims.check(id + "-eigenvalue", "The linearised model has the eigenvalue of the closed form: " + what + ".",
               "relative deviation of omega^2", largest(&Deviations::eigenvalue),
               Roundoff{.operations = 30,
                        .scale = condition(tank),
                        .reason = "some thirty roundings of a row of a direct solution, amplified by the condition of "
                                  "the equation for the pressure"});
  constexpr double tolerance = 1e-13;
  const double steps = 2 * pi * periods / phase;
  const double operations = 100 + 6 / (4 * std::pow(phase, 4) * steps);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::sqrt(operations);
  claims.check(id + "-run", "A run has the frequency of the closed form: " + what + ".",
               "relative deviation of the frequency", largest(&Deviations::run),
               Bound{.limit = tolerance + rounding,
                     .reason = "the pressure of the wave is solved to the part 1e-13 of itself; second differences "
                               "divide the rounding of amplitudes by (omega tau)^2, the mean over n steps that by "
                               "sqrt(n); a hundred roundings of the rest"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const double tau = values.real("tau");
  const Fitted own = own_box(values);
  const PlanMode mode(own.tank, own.half_waves_x, own.half_waves_y);
  claim_law(claims.of(&Results::own).at(fmt::format("{}, tau = {:g}", own.tank.text(), tau)), "wave",
            "the wave of the parameters", own.tank, mode.linear_frequency() * tau, values.real("periods"));
  claim_law(claims.of(&Results::fan).at("24 x 24 cells, omega tau = 0.1"), "fan",
            "twelve waves from the longest to nearly the shortest", fan_tank(values), fan_phase, fan_periods);
}

Results compute(const Run& run) {
  Results r;
  const Fitted own = own_box(run);
  r.own.push_back(
      deviations(PlanMode(own.tank, own.half_waves_x, own.half_waves_y), run.real("periods"), run.real("tau")));
  run.progress(0.3);
  for (const auto& [m, n] : fan_modes) {
    const PlanMode mode(fan_tank(run), m, n);
    r.fan.push_back(deviations(mode, fan_periods, fan_phase / mode.linear_frequency()));
  }
  return r;
}

void show_own(const Values& values, evidence::Exhibit& exhibit) {
  const Fitted own = own_box(values);
  const PlanMode mode(own.tank, own.half_waves_x, own.half_waves_y);
  const double limit = own.tank.law().limit().frequency(std::hypot(mode.kx(), mode.ky()));
  exhibit.measure("h1_used", own.tank.length / static_cast<double>(own.tank.columns));
  exhibit.measure("h2_used", own.tank.width / static_cast<double>(own.tank.rows));
  exhibit.measure("omega_theory", mode.linear_frequency());
  exhibit.measure("omega_green_naghdi", limit);
  exhibit.measure("frequency_error", mode.linear_frequency() / limit - 1);
}

evidence::Table fan_table(const std::vector<Deviations>& fan, const PlanTank& tank) {
  evidence::Table table{.id = "fan",
                        .title = "Waves in a box of 24 x 24 cells",
                        .caption =
                            "Relative deviations of eigenvalues and of measured frequencies from the closed form, and "
                            "of the closed form from the Green-Naghdi equations.",
                        .columns = table_columns({"half-waves along x", "along y", "k H", "direction [degrees]",
                                                  "eigenvalue", "run", "error of the lattice"})};
  for (std::size_t i = 0; i < fan_modes.size(); ++i) {
    const auto& [m, n] = fan_modes[i];
    const PlanMode mode(tank, m, n);
    const double k = std::hypot(mode.kx(), mode.ky());
    const double direction = std::atan2(mode.ky(), mode.kx());
    table.rows.push_back({static_cast<double>(m), static_cast<double>(n), k, direction * 180 / pi, fan[i].eigenvalue,
                          fan[i].run, tank.law().frequency_error(k, direction)});
  }
  return table;
}

void draw(const Values& values, evidence::Exhibit& exhibit) {
  const exact::PlanDispersion law(1, 1, values.real("h1"), values.real("h2"));
  auto& figure = exhibit.figure("anisotropy", "Direction makes a difference on a lattice",
                                fmt::format("Frequency of the closed form below that of the Green-Naghdi equations, in "
                                            "per cent, against the direction of the wave; cells {:g} x {:g}.",
                                            values.real("h1"), values.real("h2")));
  auto& polar = figure.panel({.x = "direction", .y = "frequency too low [%]", .title = "Direction", .polar = true});
  auto& along = figure.panel({.x = "k H", .y = "phase speed/sqrt(g H)", .title = "Phase speed"});
  // Up to where the longer side resolves the wave in every direction.
  const double shortest = pi / std::max(values.real("h1"), values.real("h2"));
  for (const double part : {0.1, 0.2, 0.3}) {
    std::vector<double> directions, errors;
    for (int degrees = 0; degrees <= 360; degrees += 2) {
      directions.push_back(degrees);
      errors.push_back(-100 * law.frequency_error(part * shortest, degrees * pi / 180));
    }
    polar.line(fmt::format("k H = {:.2f}", part * shortest), directions, errors);
  }
  for (const int degrees : {0, 45, 90}) {
    std::vector<double> k, speed;
    for (int i = 1; i <= 200; ++i) {
      k.push_back(shortest * i / 200);
      const double direction = degrees * pi / 180;
      speed.push_back(law.phase_speed(k.back() * std::cos(direction), k.back() * std::sin(direction)));
    }
    along.line(fmt::format("{} degrees", degrees), k, speed);
  }
  std::vector<double> k, speed;
  for (int i = 1; i <= 200; ++i) {
    k.push_back(shortest * i / 200);
    speed.push_back(law.limit().phase_speed(k.back()));
  }
  along.line("Green-Naghdi", k, speed, Role::exact);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  show_own(values, exhibit);
  exhibit.table(fan_table(r.fan, fan_tank(values)));
  draw(values, exhibit);
}

}  // namespace

Case dispersion_2dh() {
  Case c;
  c.title = "Small waves of the 2DH model have the frequency of its dispersion law in every direction";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 4.2, formula (13)";
  c.parameters = {
      real("wavenumber", 1.0, "1/H", {1e-2, 20}, "of the wave"),
      real("direction", 30.0, "degrees", {0, 90}, "of the wave, from the x axis"),
      real("h1", 0.5, "H", {1e-2, 1.5}, "length of cells; changed to fit a whole number of times between the walls"),
      real("h2", 0.5, "H", {1e-2, 1.5}, "width of cells, likewise"),
      real("tau", 0.1, "sqrt(H/g)", {1e-3, 1}, "time step"),
      real("periods", {10.0, 20.0, 40.0}, "1", {2, 1000}, "length of the run"),
  };
  c.study = Study(claims, compute, show, source);
  c.former_names = {"dispersion_plan"};
  return c;
}

}  // namespace seiche::validation::cases::dispersion_2dh
