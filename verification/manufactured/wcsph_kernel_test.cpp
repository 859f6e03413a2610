// Smoothing kernels: moments, sums over lattices, and the derivative beside the value; the equation of state.
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/lattice_sums.hpp"

namespace seiche::verification::wcsph_kernel_test {

using namespace wcsph;

/// int q^power W dA with q = r/h: a polynomial of degree at most 10 on either side of q = 1.
template <class Kernel>
double moment(double h, int power) {
  const auto ring = [&](double q) {
    return 2 * std::numbers::pi * q * std::pow(q, power) * h * h * weight<Kernel>(q * h, h);
  };
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  return Gauss::integrate(ring, 0.0, 1.0) + Gauss::integrate(ring, 1.0, 2.0);
}

/// The same with -r/2 dW/dr in place of W: integration by parts turns it into (power + 2)/2 times the moment.
template <class Kernel>
double slope_moment(double h, int power) {
  const auto ring = [&](double q) {
    return -0.5 * 2 * std::numbers::pi * q * std::pow(q, power) * h * h * q * h * radial_slope<Kernel>(q * h, h);
  };
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  return Gauss::integrate(ring, 0.0, 1.0) + Gauss::integrate(ring, 1.0, 2.0);
}

template <class Kernel>
void check_moments(Check& check, const std::string& id, const std::string& name, const std::vector<double>& exact) {
  const double h = 0.0148;
  for (int power = 0; power <= 4; power += 2) {
    const double expected = exact[static_cast<std::size_t>(power / 2)];
    const Roundoff limit{.operations = 40,
                         .scale = 1,
                         .reason =
                             "30 partial sums of up to 1 and some 10 roundings of factors that all points share; "
                             "roundings of single points average out",
                         .expected = expected};
    const std::string q = power == 0 ? "1" : "q^" + std::to_string(power);
    check.holds(id + "-moment-" + std::to_string(power) + ": The " + name + " has the moment of " + q +
                    " that integration gives.",
                {moment<Kernel>(h, power)}, limit);
    check.holds(id + "-slope-moment-" + std::to_string(power) + ": The slope of the " + name +
                    " is the derivative of its value, under the integral.",
                {slope_moment<Kernel>(h, power) * 2 / (power + 2)}, limit);
  }
}

struct LatticeRow {
  std::string id, name;
  verification::LatticeSums sums;
  double zeroth, first;
  int neighbours;
};

TEST_CASE("kernels have their moments, and their sums over lattices", "[manufactured]") {
  const std::string cubic_source = "Monaghan and Lattanzio, Astron. Astrophys. 149 (1985) 135; integration by hand";
  Check check(
      "wcsph_kernels", "Smoothing kernels",
      "Moments in the plane against exact fractions, of the value and, by parts, of the slope. Sums over square and "
      "body-centred lattices: the sum of $V W$, the factor $M = -\\sum V x\\,\\partial W/\\partial x$ by which the "
      "uncorrected first derivative is wrong however fine the lattice, and the number of neighbours.");
  check_moments<CubicSpline>(check, "cubic", "cubic spline", {1, 31.0 / 49, 635.0 / 882});
  check_moments<WendlandC2>(check, "wendland", "Wendland kernel", {1, 5.0 / 9, 56.0 / 99});
  const double h = 0.0148;
  const double top = 10 / (7 * std::numbers::pi * h * h);
  const Roundoff five{.operations = 5, .scale = top, .reason = "5 rounded operations on W(0)"};
  check.from(cubic_source)
      .that("cubic-top", "The cubic spline has W(0) = 10/(7 pi h^2).", "W(0) [1/m^2]", {weight<CubicSpline>(0, h)},
            Roundoff{5, top, five.reason, top});
  check.from(cubic_source)
      .that("cubic-h", "The cubic spline has W(h) = 5/(14 pi h^2).", "W(h) [1/m^2]", {weight<CubicSpline>(h, h)},
            Roundoff{5, top, five.reason, 0.25 * top});
  CHECK(weight<CubicSpline>(2 * h, h) == 0);
  CHECK(weight<WendlandC2>(2.5 * h, h) == 0);
  CHECK(radial_slope<WendlandC2>(2.5 * h, h) == 0);

  constexpr auto square = Arrangement::square;
  const std::vector<LatticeRow> rows{
      {"cubic-1.0", "cubic spline, h/dx = 1.0", lattice_sums<CubicSpline>(1.0, square), 1.000862, 1.013099, 8},
      {"cubic-1.2", "cubic spline, h/dx = 1.2", lattice_sums<CubicSpline>(1.2, square), 0.999757, 0.990793, 20},
      {"cubic-1.3", "cubic spline, h/dx = 1.3", lattice_sums<CubicSpline>(1.3, square), 0.999947, 1.010543, 20},
      {"cubic-1.5", "cubic spline, h/dx = 1.5", lattice_sums<CubicSpline>(1.5, square), 1.003440, 1.006725, 24},
      {"cubic-2.0", "cubic spline, h/dx = 2.0", lattice_sums<CubicSpline>(2.0, square), 0.999958, 0.999100, 44},
      {"wendland-1.3", "Wendland, h/dx = 1.3", lattice_sums<WendlandC2>(1.3, square), 1.010473, 0.973921, 20},
      {"wendland-2.0", "Wendland, h/dx = 2.0", lattice_sums<WendlandC2>(2.0, square), 1.001206, 0.999199, 44},
      {"cubic-body-centred", "cubic spline, h/dx = 1.3, body-centred",
       lattice_sums<CubicSpline>(1.3, Arrangement::body_centred), 1.000509, 0.994034, 44}};
  evidence::Table table{.id = "lattices",
                        .title = "Sums over lattices",
                        .caption = "M differs from 1 by up to 3 % and does not depend on the spacing.",
                        .columns = {{"kernel, lattice", ""}, {"sum V W", "1"}, {"M", "1"}, {"neighbours", "1"}}};
  for (const LatticeRow& row : rows) {
    std::string id = row.id;
    std::replace(id.begin(), id.end(), '.', '_');
    for (const auto& [what, sum, printed] :
         {std::tuple{"sum of V W", row.sums.zeroth, row.zeroth}, {"derivative factor M", row.sums.first, row.first}}) {
      check.holds(id + ": The " + what + " has every digit of the reference (" + row.name + ").", {sum},
                  Bound{0.5e-6, "half a unit of the last printed digit", printed});
    }
    CHECK(row.sums.neighbours == row.neighbours);
    table.rows.push_back({row.name, row.sums.zeroth, row.sums.first, static_cast<double>(row.sums.neighbours)});
  }
  check.table(std::move(table));

  std::vector<double> q, cubic, wendland, cubic_slope, wendland_slope;
  for (double r = 0; r <= 2.2; r += 0.02) {
    q.push_back(r);
    cubic.push_back(weight<CubicSpline>(r, 1));
    wendland.push_back(weight<WendlandC2>(r, 1));
    cubic_slope.push_back(radial_slope<CubicSpline>(r, 1));
    wendland_slope.push_back(radial_slope<WendlandC2>(r, 1));
  }
  auto& figure = check.figure("kernels", "Smoothing kernels", "Value and slope for h = 1.");
  auto& values = figure.panel({.x = "r/h", .y = "h^2 W"});
  values.line("cubic spline", q, cubic);
  values.line("Wendland C2", q, wendland, Role::peer);
  auto& slopes = figure.panel({.x = "r/h", .y = "h^3 dW/dr"});
  slopes.line("cubic spline", q, cubic_slope);
  slopes.line("Wendland C2", q, wendland_slope, Role::peer);
}

TEST_CASE("pressure, sound speed and elastic energy of Tait's fluid belong together", "[manufactured]") {
  const std::string source = "Batchelor, An introduction to fluid dynamics (1967), section 1.8";
  Check check("wcsph_tait", "Tait's equation of state",
              "Pressure and its inverse; $c^2 = dP/d\\rho$ and $de = P/\\rho^2\\,d\\rho$ through the mean over an "
              "interval by quadrature; the pressure of still water.");
  check.source(source);
  const TaitFluid water(1000, 14.96);
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  Worst inverse, sound, energy;
  const double stiffness = 1000 * 14.96 * 14.96 / 7;
  for (double density = 920; density < 1100; density += 20) {
    inverse.add(water.density_at(water.pressure(density)) - density);
    const double rise = Gauss::integrate([&](double d) { return std::pow(water.sound_speed(d), 2); }, 1000.0, density);
    sound.add(water.pressure(density) - rise);
    const double work = Gauss::integrate([&](double d) { return water.pressure(d) / (d * d); }, 1000.0, density);
    energy.add(water.elastic_energy(density) - work);
  }
  const double scale = std::pow(1.1, 7) * stiffness;
  check.that("inverse", "Density and pressure of Tait's equation are inverse functions.", "density error [kg/m^3]",
             {inverse.value()}, Roundoff{20, 1100, "two powers, 20 roundings of numbers up to 1100"});
  check.that("sound", "The square of the sound speed is the slope of the pressure.",
             "pressure minus the integral of c^2 [Pa]", {sound.value()},
             Roundoff{60, scale, "15 points and a power on pressures up to 1.95 B"});
  check.that("energy", "Elastic energy is the work of the pressure.", "e minus the integral of P/rho^2 [J/kg]",
             {energy.value()},
             Roundoff{60, 0.2 * stiffness / 1000,
                      "15 points and a power on P/rho^2 of up to 1.6 B/rho_0^2 over 0.1 rho_0; the terms of the "
                      "energy, in B/rho_0, are no larger"});
  CHECK(water.elastic_energy(1000) == 0);
  CHECK(std::abs(water.stiffness() - stiffness) < 1e-15 * 8 * stiffness);
  const double depth = 0.114;
  check.from("P = rho_0 g depth")
      .that("hydrostatic", "Still water of the hydrostatic density is in equilibrium.", "P(depth) [Pa]",
            {water.pressure(water.hydrostatic_density(9.81, depth))},
            Roundoff{30, stiffness, "P is a difference of two terms near B", 1000 * 9.81 * depth});
  CHECK_THROWS_AS(water.hydrostatic_density(9.81, 1.001 * stiffness / 9810), std::invalid_argument);
  CHECK_THROWS_AS(TaitFluid(0, 10), std::invalid_argument);
  CHECK_THROWS_AS(TaitFluid(1000, 0), std::invalid_argument);
}

}  // namespace seiche::verification::wcsph_kernel_test
