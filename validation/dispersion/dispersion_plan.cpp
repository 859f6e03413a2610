/*
Small waves of the discrete dispersive shallow-water model in plan (Frank 1994, section 4.2) have a frequency in closed
form. On cells $h_1 \times h_2$ over still water of depth $H$, with $T_i = (2/h_i)\tan(k_i h_i/2)$,
$K^2 = T_1^2 + T_2^2$ and $G = \tfrac19(2 + \cos k_1h_1)(2 + \cos k_2h_2)$,

$$\omega^2 = gH\,\frac{G K^2}{1 + \tfrac13 H^2 K^2}.$$

Along an axis of the lattice this is Frank's formula (13). Fine cells have the law of the Green-Naghdi equations,
$\omega^2 = gHk^2/(1 + \tfrac13 H^2k^2)$. Depth and gravity are 1.

**Set-up.** A box of whole half-waves between four walls; `h1` and `h2` are changed until whole numbers of cells fit.
Still water gets a vertical velocity of $10^{-6}$ in the shape of the wave.

**What is compared.** Twice: the eigenvalue of the linearised model for the wave, and the frequency in a run of the
one-step scheme, whose amplitudes obey $a_{n+1} + a_{n-1} = (2 - \omega^2\tau^2)\,a_n$. For the wave of the parameters,
and for a fan of directions.

**What to look at.** The lattice is not isotropic. Along its axes the error of long waves is of fourth order in $kh$,
for the errors of the pressure and of the inertia cancel; at an angle $\theta$ a term $-\tfrac1{48}(h_1^2 + h_2^2)\,k^2
\sin^2 2\theta$ of the frequency remains, largest at 45 degrees.
*/
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/instruments/plan_standing_mode.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;

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
  return result;
}

/// Relative deviations from the closed form.
struct Deviations {
  double eigenvalue = 0;
  double run = 0;
};

Deviations deviations(const PlanMode& mode, double periods, double tau) {
  const double omega = mode.linear_frequency();
  const int steps = static_cast<int>(std::ceil(2 * pi * periods / (omega * tau)));
  return {std::abs(mode.eigenvalue().square / (omega * omega) - 1),
          std::abs(mode.measured_frequency(tau, steps) / omega - 1)};
}

void claim(Running& run, const std::string& id, const std::string& what, const Deviations& found,
           const std::string& resolution) {
  run.record.check({.id = id + "-eigenvalue",
                    .text = "The linearised model has the eigenvalue of the closed form: " + what + ".",
                    .quantity = "relative deviation of omega^2",
                    .source = source},
                   {.value = found.eigenvalue, .resolution = resolution},
                   Bound{1e-12, "round-off of a direct solution, amplified by the condition of up to 1e3 cells"});
  run.record.check({.id = id + "-run",
                    .text = "A run has the frequency of the closed form: " + what + ".",
                    .quantity = "relative deviation of the frequency",
                    .source = source},
                   {.value = found.run, .resolution = resolution},
                   Bound{1e-6,
                         "the solver keeps amplitudes to 1e-11; second differences divide that by (omega "
                         "tau)^2, 1e-4 at least"});
}

void claim_own_wave(Running& run) {
  const double k = run.real("wavenumber");
  const double direction = run.real("direction") * pi / 180;
  const Fitted box = fitted(k * std::cos(direction), k * std::sin(direction), run.real("h1"), run.real("h2"));
  const PlanMode mode(box.tank, box.half_waves_x, box.half_waves_y);
  const double used = std::hypot(mode.kx(), mode.ky());
  const double limit = box.tank.law().limit().frequency(used);
  run.record.measure("h1_used", box.tank.length / static_cast<double>(box.tank.columns));
  run.record.measure("h2_used", box.tank.width / static_cast<double>(box.tank.rows));
  run.record.measure("omega_theory", mode.linear_frequency());
  run.record.measure("omega_green_naghdi", limit);
  run.record.measure("frequency_error", mode.linear_frequency() / limit - 1);
  claim(run, "wave", "the wave of the parameters", deviations(mode, run.real("periods"), run.real("tau")),
        fmt::format("{}, tau = {:g}", box.tank.text(), run.real("tau")));
}

/// Waves in a box of 24 x 24 cells of h1 x h2, long and short, in many directions.
void claim_fan(Running& run) {
  const PlanTank tank{.columns = 24, .rows = 24, .length = 24 * run.real("h1"), .width = 24 * run.real("h2")};
  evidence::Table table{.id = "fan",
                        .title = "Waves in a box of 24 x 24 cells",
                        .caption =
                            "Relative deviations of eigenvalues and of measured frequencies from the closed "
                            "form, and of the closed form from the Green-Naghdi equations.",
                        .columns = {{"half-waves along x", ""},
                                    {"along y", ""},
                                    {"k H", ""},
                                    {"direction", "degrees"},
                                    {"eigenvalue", ""},
                                    {"run", ""},
                                    {"error of the lattice", ""}}};
  Deviations worst;
  const std::vector<std::pair<std::size_t, std::size_t>> modes = {
      {1, 0}, {0, 1}, {1, 1}, {3, 1}, {2, 5}, {6, 6}, {9, 0}, {4, 11}, {12, 7}, {15, 15}, {20, 3}, {21, 20}};
  for (const auto& [m, n] : modes) {
    const PlanMode mode(tank, m, n);
    const Deviations found = deviations(mode, 5, 0.1 / mode.linear_frequency());
    worst = {std::max(worst.eigenvalue, found.eigenvalue), std::max(worst.run, found.run)};
    const double k = std::hypot(mode.kx(), mode.ky());
    const double direction = std::atan2(mode.ky(), mode.kx());
    table.rows.push_back({static_cast<double>(m), static_cast<double>(n), k, direction * 180 / pi, found.eigenvalue,
                          found.run, tank.law().frequency_error(k, direction)});
  }
  run.record.table(std::move(table));
  claim(run, "fan", "twelve waves from the longest to nearly the shortest", worst, "24 x 24 cells, omega tau = 0.1");
}

void draw(Running& run) {
  const exact::PlanDispersion law(1, 1, run.real("h1"), run.real("h2"));
  auto& figure = run.record.figure("anisotropy", "Direction makes a difference on a lattice",
                                   fmt::format("Frequency of the closed form below that of the Green-Naghdi equations, "
                                               "in per cent, against the direction of the wave; cells {:g} x {:g}.",
                                               run.real("h1"), run.real("h2")));
  auto& polar = figure.panel({.x = "direction", .y = "frequency too low [%]", .title = "Direction", .polar = true});
  auto& along = figure.panel({.x = "k H", .y = "phase speed/sqrt(g H)", .title = "Phase speed"});
  // Up to where the longer side resolves the wave in every direction.
  const double shortest = pi / std::max(run.real("h1"), run.real("h2"));
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

void run(Running& run) {
  claim_own_wave(run);
  run.progress(0.3);
  claim_fan(run);
  run.progress(0.9);
  draw(run);
}

}  // namespace

Case dispersion_plan() {
  Case c;
  c.title = "Small waves of the plan model have the frequency of its dispersion law in every direction";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 4.2, formula (13)";
  c.parameters = {
      real("wavenumber", 1.0, "1/H", {1e-2, 20}, "of the wave"),
      real("direction", 30.0, "degrees", {0, 90}, "of the wave, from the x axis"),
      real("h1", 0.5, "H", {1e-2, 5}, "length of cells; changed to fit a whole number of times between the walls"),
      real("h2", 0.5, "H", {1e-2, 5}, "width of cells, likewise"),
      real("tau", 0.1, "sqrt(H/g)", {1e-3, 1}, "time step"),
      real("periods", {10.0, 20.0, 40.0}, "1", {2, 1000}, "length of the run"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
