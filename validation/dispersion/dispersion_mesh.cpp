/*
Small waves on the two-dimensional Lagrangian mesh have a closed-form frequency (Frank 1994, section 2.1). The mesh has
$n$ rows of height $h_2 = H/n$ and columns of width $h_1$. With depth and gravity 1, $T = (h_2/h_1)\tan(kh_1/2)$ and
$t_n = \tanh(2n\,\mathrm{artanh}\,T)$,

$$\omega^2 = \frac{2}{h_2}\,\frac{2 + \cos kh_1}{3}\,\frac{T(1 - T^2)\,t_n}{1 - T^3 t_n}.$$

Fine meshes tend to Airy's relation. Long waves have $\omega^2 = k^2\,(1 - (\tfrac13 + \tfrac16 h_2^2)\,k^2 + \dots)$:
their error depends on the row height alone. The time step $\tau$ turns $\omega$ into $\Omega$, $\sin(\Omega\tau/2) =
\omega\tau/2$ for the one-step scheme, $\tan(\Omega\tau/2) = \omega\tau/2$ for the conservative scheme.

**Set-up.** A tank of one or more half-waves between walls. `h1` is adjusted to a whole number of columns, `h2` to a
whole number of rows. The flat surface receives an impulse in the shape of the wave. Amplitudes are $10^{-6}$ and
$2\cdot10^{-6}$ of the depth.

**What is compared.** Elevations are projected on the wave; a sinusoid fitted to the series gives the frequency, and the
two amplitudes its limit for small waves, which must equal the formula digit for digit: for the wave of the parameters,
and for all points of the figure. Then two statements of Frank: waves of $L/H \ge 7$ are well described with $h_1 = H$,
$h_2 = H/2$; and with special parameters the mesh has nearly the relation of Boussinesq's equations, $\omega^2 = k^2/(1
+ k^2/3)$, for waves of $L/H \ge 3.5$.

**What to look at.** The celerity on the coarse mesh is 2.9 % low at $L/H = 7$, 0.23 % at 20. The last panel shows
meshes that imitate Boussinesq's equations: with four rows and $h_1 = 0.46$ the difference is 0.2 %. One or two rows are
too few. Deviations of the measured frequencies from the relation are round-off.
*/
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ranges>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/dispersion/small_waves.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_standing_mode.hpp"

namespace seiche::validation::cases::dispersion_mesh {

using exact::LagrangianMeshDispersion;
using Wave = SmallWave<MeshTank>;
using Waves = SmallWaves<MeshTank>;

constexpr double pi = std::numbers::pi;
const std::string frank = "Frank, Discrete models of incompressible fluids (1994), section 2.1";
const exact::AiryDispersion airy(1, 1);
const exact::RationalDispersion boussinesq = exact::RationalDispersion::green_naghdi(1, 1);
constexpr double shortest_like_boussinesq = 3.5;  ///< wavelength, in depths, down to which they are compared

/// Small enough that what the extrapolation leaves is below rounding: streaming of the second order moves nodes by
/// parts (Omega t a)^2 of a cell, so that the frequency has a term in (Omega t a)^4.
constexpr double amplitude = 1e-6;

/// The mesh of so many rows that comes nearest to Boussinesq's equations, omega^2 = k^2/(1 + k^2/3) (Frank 1994,
/// section 2.1).
struct Nearest {
  std::size_t rows;
  double width;     ///< of columns, between 0.001 and 1.7
  double distance;  ///< largest relative difference of the frequencies over those wavelengths
};

Nearest nearest_to_boussinesq(std::size_t rows) {
  const auto distance = [rows](double width) {
    const LagrangianMeshDispersion law(1, 1, width, rows);
    return over<Worst>(evenly(0.01, 2 * pi / shortest_like_boussinesq, 300),
                       [&](double k) { return law.frequency(k) / boussinesq.frequency(k) - 1; })
        .value();
  };
  const std::vector<double> widths = evenly(0.02, 1.7, 85);
  const double near = *std::ranges::min_element(widths, {}, distance);
  const double reach = widths[1] - widths[0];
  constexpr int bits = 26;
  const double width =
      boost::math::tools::brent_find_minima(distance, std::max(0.001, near - reach), near + reach, bits).first;
  return {rows, width, distance(width)};
}

/// The time step's effect on the one-step scheme taken out by its law.
double without_step(const Wave& wave) {
  return 2 * std::sin(0.5 * wave.frequency * wave.tank.tau) / wave.tank.tau;
}

/// Of long waves, the time step's effect taken out, against Airy.
double error_of(const Wave& wave) {
  return without_step(wave) / airy.frequency(wave.tank.wavenumber) - 1;
}

MeshTank own_tank(const Values& values) {
  const double k = values.real("wavenumber");
  return {.wavenumber = k,
          .columns = MeshTank::columns_of(k, values.real("h1")),
          .rows = static_cast<std::size_t>(std::lround(1 / values.real("h2"))),
          .tau = values.real("tau"),
          .scheme = {.stepping = mechanics::stepping_named(values.text("scheme"))},
          .tuned_surface_inertia = values.toggle("tuned_surface_inertia")};
}

/// Frank's mesh for long waves, h1 = H, h2 = H/2, in tanks of one wavelength.
std::vector<MeshTank> long_tanks() {
  std::vector<MeshTank> tanks;
  for (const std::size_t length : {7UL, 10UL, 15UL, 20UL}) {
    tanks.push_back(
        {.wavenumber = 2 * pi / static_cast<double>(length), .columns = length, .rows = 2, .half_waves = 2});
  }
  return tanks;
}

/// A mesh of the figure.
struct Family {
  std::string label;
  double column_width;
  std::size_t rows;
};

const std::vector<Family> families = {
    {"h1 = 1, h2 = 1/2", 1, 2}, {"h1 = 0.46, h2 = 1/4", 0.46, 4}, {"h1 = 1/4, h2 = 1/8", 0.25, 8}};

/// Meshes of narrow columns, whose error is that of their rows: from one row, near to Boussinesq's equations, to water.
const std::vector<std::size_t> row_numbers{1, 2, 4, 8, 16, 32};

LagrangianMeshDispersion law_of_rows(std::size_t rows) {
  return {1, 1, 0.005, rows};
}

/// Waves of one to twenty half-waves in tanks of twenty columns.
std::vector<MeshTank> tanks_of_figure() {
  constexpr std::size_t columns = 20;
  std::vector<MeshTank> tanks;
  for (const Family& family : families) {
    for (const std::size_t half_waves : {1, 2, 3, 5, 7, 9, 12, 15, 18, 20}) {
      const MeshTank tank{.wavenumber = pi * static_cast<double>(half_waves) / (columns * family.column_width),
                          .columns = columns,
                          .rows = family.rows,
                          .half_waves = half_waves,
                          .tau = 0.05};
      if (tank.wavenumber > deepest) break;
      tanks.push_back(tank);
    }
  }
  return tanks;
}

struct Results {
  Waves own, long_waves, figure;
  std::vector<Nearest> nearest;
};

void claim_waves(const Values& values, const Claims<Results>& claims) {
  const double periods = values.real("periods");
  const MeshTank own = own_tank(values);
  claims.of(&Results::own)
      .at(fmt::format("{} x {} cells, tau = {:g}", own.columns, own.rows, own.tau))
      .check(
          "frequency",
          "The frequency of the wave of the parameters equals the exact dispersion relation of the mesh to round-off.",
          "relative deviation of the frequency", worst_deviation<MeshTank>,
          frequency_roundoff(std::vector{own}, periods, &MeshTank::columns));
  claims.of(&Results::figure)
      .at("20 columns, 2, 4 and 8 rows, tau = 0.05")
      .check("figure",
             "The frequencies of all waves of the figure, up to the shortest that the meshes resolve, equal the exact "
             "dispersion relation to round-off.",
             "largest relative deviation of the frequency", worst_deviation<MeshTank>,
             frequency_roundoff(tanks_of_figure(), periods, &MeshTank::columns));
}

void claim_boussinesq(const Claims<std::vector<Nearest>>& claims) {
  const auto many_rows = [](const Nearest& n) { return n.rows >= 3; };
  claims.at("3, 4, 6, 8, 16 rows")
      .from(frank)
      .check(
          "boussinesq",
          "The frequency with three rows or more and a suitable column width agrees with Boussinesq's equations within "
          "0.5 % for L/H >= 3.5.",
          "largest relative difference of the frequency, L/H >= 3.5",
          [=](const std::vector<Nearest>& all) {
            Worst distance;
            for (const Nearest& n : all | std::views::filter(many_rows)) distance.add(n.distance);
            return distance;
          },
          Bound{.limit = 0.005,
                .reason = "0.5 %, invisible in a plot of the relation; water differs from Boussinesq's equations by "
                          "ten times as much at L/H = 3.5"});
  claims.check(
      "boussinesq-few-rows",
      "The frequency with one or two rows differs from Boussinesq's equations by more than 0.5 % at every column "
      "width.",
      "no column width brings the difference below 0.5 %",
      [=](const std::vector<Nearest>& all) {
        Count near;
        for (const Nearest& n : all) {
          if (!many_rows(n)) near.add(n.distance, [](double distance) { return distance <= 0.005; });
        }
        return 1 - near.value();
      },
      Qualitative{.detector = "smallest difference over widths of 0.02 to 1.7 H",
                  .reason = "their k^4 term, 1/3 + h2^2/6, cannot be compensated by the width"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_waves(values, claims);
  const std::vector<MeshTank> tanks = long_tanks();
  const MeshTank& seven = tanks.front();
  Roundoff of_the_law = frequency_roundoff(tanks, values.real("periods"), &MeshTank::columns);
  of_the_law.expected = std::abs(seven.law().frequency(seven.wavenumber) / airy.frequency(seven.wavenumber) - 1);
  of_the_law.reason =
      "the error of the dispersion relation at L/H = 7, 2.94 %, which falls for longer waves; Frank gives no number. "
      "Measured to the accuracy of the frequencies:  " +
      of_the_law.reason;
  claims.at("h1 = H, h2 = H/2")
      .from(frank)
      .check(
          "seven-depths", "The frequency error of waves of L/H >= 7 on the coarse mesh is below 3 %.",
          "largest relative error of the frequency against Airy",
          [](const Results& r) { return over<Worst>(r.long_waves, error_of); }, of_the_law);
  claims.at("4 to 32 rows, h1 = H/200")
      .from(frank)
      .check(
          "rows", "The phase speed converges to Airy's at second order in the row height.",
          "order of the error at kH = 1",
          [](const Results&) {
            std::vector<double> heights, errors;
            for (const std::size_t rows : row_numbers) {
              if (rows < 4) continue;
              heights.push_back(1 / static_cast<double>(rows));
              errors.push_back(std::abs(law_of_rows(rows).phase_speed(1) / airy.phase_speed(1) - 1));
            }
            return evidence::observed_order(heights, errors);
          },
          Order{2, 0.1,
                "long waves have the error (h2 k)^2/12, and with four rows the next order is a tenth of it; columns of "
                "H/200 leave two millionths"});
  claim_boussinesq(claims.of(&Results::nearest));
}

Results compute(const Run& run) {
  const double periods = run.real("periods");
  Results r{.own = small_waves(std::vector{own_tank(run)}, periods, amplitude)};
  run.progress(0.1);
  r.long_waves = small_waves(long_tanks(), periods, amplitude);
  for (const std::size_t rows : {1UL, 2UL, 3UL, 4UL, 6UL, 8UL, 16UL}) r.nearest.push_back(nearest_to_boussinesq(rows));
  run.progress(0.7);
  r.figure = small_waves(tanks_of_figure(), periods, amplitude);
  return r;
}

void tabulate(const Results& r, evidence::Exhibit& exhibit) {
  evidence::Table& coarse = add_table(
      exhibit, "long-waves", "Long waves on the coarse mesh, h1 = H, h2 = H/2",
      "Measured in a tank of one wavelength with tau = 0.05; the effect of the time step is removed by its relation.",
      {"wavelength/H", "frequency", "error against Airy [%]"});
  for (const Wave& wave : r.long_waves) {
    const std::size_t length = wave.tank.columns;
    coarse.rows.push_back(
        {static_cast<double>(length), fmt::format("{:.10f}", without_step(wave)), 100 * error_of(wave)});
    exhibit.measure(fmt::format("error_at_{}_depths", length), error_of(wave));
  }

  evidence::Table& nearest =
      add_table(exhibit, "boussinesq", "Meshes nearest to Boussinesq's equations",
                "Column width with the smallest maximum difference of the frequency from $k/\\sqrt{1 + k^2/3}$ over "
                "L/H >= 3.5. With one or two rows the narrowest columns tried, 0.001 H, are the best.",
                {"rows", "h1/H", "difference [%]"});
  for (const Nearest& n : r.nearest) nearest.rows.push_back({static_cast<double>(n.rows), n.width, 100 * n.distance});
}

void draw(const Waves& measured, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("dispersion", "Phase speed of waves on the Lagrangian mesh",
                                "Lines: dispersion relations, up to the shortest wave of each mesh. Circles: measured "
                                "with tau = 0.05; the effect of the time step is removed by its relation.",
                                {"frank-dispersion-2d"});
  PhaseSpeedPanels panels(figure, 0.1, 1e-6);
  auto& difference = figure.panel({.x = "k H",
                                   .y = "relative difference",
                                   .title = "Difference from Boussinesq",
                                   .x_min = 0,
                                   .x_max = 2 * pi / shortest_like_boussinesq,
                                   .y_min = -0.03,
                                   .y_max = 0.03});
  const auto add = [&](const std::string& label, const auto& law, double k_last, Role role) {
    const std::vector<double> k = evenly(0.02, k_last, 400);
    panels.add(label, k, each(k, [&](double at) { return law.phase_speed(at); }), role);
    const auto apart = [&](double at) { return law.phase_speed(at) / boussinesq.phase_speed(at) - 1; };
    difference.line(label, k, each(k, apart), role);
  };
  add("Airy", airy, deepest, Role::exact);
  add("Boussinesq", boussinesq, deepest, Role::guide);
  for (const auto& [label, width, rows] : families) {
    add(label, LagrangianMeshDispersion(1, 1, width, rows), std::min(deepest, pi / width), Role::computed);
  }
  const auto speed = [](const Wave& wave) { return without_step(wave) / wave.wavenumber(); };
  const auto apart = [&](const Wave& wave) { return speed(wave) / boussinesq.phase_speed(wave.wavenumber()) - 1; };
  for (const Family& family : families) {
    auto waves = measured | std::views::filter([&](const Wave& wave) { return wave.tank.rows == family.rows; });
    const std::vector<double> k = each(waves, &Wave::wavenumber);
    panels.add("measured", k, each(waves, speed), Role::data);
    difference.points("measured", k, each(waves, apart), Role::data);
  }
}

/// From shallow water to the Euler equations.
void draw_rows(evidence::Exhibit& exhibit) {
  auto& panel =
      add_panel(exhibit, "rows", "From shallow water to the Euler equations by the number of rows",
                "Phase speed by the dispersion relations, columns of H/200. Shallow water: 1 at every wavenumber.",
                {.x = "k H", .y = "phase speed/sqrt(g H)", .y_min = 0, .y_max = 1.05}, {"frank-dispersion-2d"});
  const std::vector<double> k = evenly(0.02, deepest, 200);
  const auto line = [&](const std::string& label, const auto& law, Role role) {
    panel.line(label, k, each(k, [&](double at) { return law.phase_speed(at); }), role);
  };
  line("Airy", airy, Role::exact);
  for (const std::size_t rows : row_numbers) line(fmt::format("rows: {}", rows), law_of_rows(rows), Role::computed);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const MeshTank own = own_tank(values);
  exhibit.measure("h1_used", own.column_width());
  exhibit.measure("h2_used", own.law().row_height());
  exhibit.measure("omega_theory", own.law().frequency(own.wavenumber));
  exhibit.measure("omega_discrete_time", own.linear_frequency());
  exhibit.measure("omega_measured", r.own.front().frequency);
  exhibit.measure("omega_airy", airy.frequency(own.wavenumber));
  tabulate(r, exhibit);
  draw(r.figure, exhibit);
  draw_rows(exhibit);
}

void dispersion_mesh(Case& c) {
  c.former_names = {"dispersion_2d"};
  c.title = "Frequency of small waves on the Lagrangian mesh: exact dispersion relation";
  c.source = literature::frank + ", section 2.1";
  c.tiers = {Tier::quick};
  c.parameters = {
      real("wavenumber", pi / 6, "1/H", {1e-2, 100}, "wavelength; the walls are half a wavelength apart"),
      real("h1", 0.375, "H", {1e-3, 10}, "column width; adjusted to fit a whole number of times between the walls"),
      real("h2", 0.25, "H", {1e-2, 1}, "row height; adjusted to fit a whole number of times in the depth"),
      real("tau", 0.1, "sqrt(H/g)", {1e-4, 2}, "time step"),
      choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
      toggle("tuned_surface_inertia", false, "relative reduction h2/(3H) of the vertical inertia of surface nodes"),
      real("periods", {20.0, 30.0, 60.0}, "1", {2, 1000}, "length of the series"),
  };
  c.published = {{.tiles = {"frank-dispersion-2d"}, .stated = {"scheme"}}};
  c.study = Study(claims, compute, show, frank + "; closed form of the linearised rows");
}

}  // namespace seiche::validation::cases::dispersion_mesh
