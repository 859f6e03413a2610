// Smoothing kernels: moments, sums over lattices, and the derivative beside the value; the equation of state.
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/lattice_sums.hpp"

namespace seiche::verification::wcsph_kernel_test {

using namespace wcsph;

/// Of a polynomial of degree at most 10 on either side of q = 1, up to q = 2.
template <class Ring>
double over_support(const Ring& ring) {
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  return Gauss::integrate(ring, 0.0, 1.0) + Gauss::integrate(ring, 1.0, 2.0);
}

/// int q^power W dA with q = r/h.
template <class Kernel>
double moment(double h, int power) {
  return over_support(
      [&](double q) { return 2 * std::numbers::pi * q * std::pow(q, power) * h * h * weight<Kernel>(q * h, h); });
}

/// The same with -r/2 dW/dr in place of W: integration by parts turns it into (power + 2)/2 times the moment.
template <class Kernel>
double slope_moment(double h, int power) {
  return over_support([&](double q) {
    return -0.5 * 2 * std::numbers::pi * q * std::pow(q, power) * h * h * q * h * radial_slope<Kernel>(q * h, h);
  });
}

template <class Kernel>
void check_moments(Check& check, const std::string& id, const std::string& name, const std::vector<double>& exact) {
  const double h = 0.0148;
  for (int power = 0; power <= 4; power += 2) {
    const double expected = exact[static_cast<std::size_t>(power / 2)];
    const std::string q = power == 0 ? "1" : fmt::format("q^{}", power);
    all_hold(check,
             Roundoff{40, 1,
                      "30 partial sums of up to 1 and some 10 roundings of factors that all points share; roundings of "
                      "single points average out"},
             {{fmt::format("{}-moment-{}: The {} has the moment of {} that integration gives.", id, power, name, q),
               moment<Kernel>(h, power), expected},
              {fmt::format("{}-slope-moment-{}: The slope of the {} is the derivative of its value, under the "
                           "integral.",
                           id, power, name),
               slope_moment<Kernel>(h, power) * 2 / (power + 2), expected}});
  }
}

/// Sums of a lattice, and the reference's.
struct LatticeRow {
  std::string id, name;
  LatticeSums sums;
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
  const std::string five = "5 rounded operations on W(0)";
  check.from(cubic_source)
      .that("cubic-top", "The cubic spline has W(0) = 10/(7 pi h^2).", "W(0) [1/m^2]", {weight<CubicSpline>(0, h)},
            Roundoff{5, top, five, top});
  check.from(cubic_source)
      .that("cubic-h", "The cubic spline has W(h) = 5/(14 pi h^2).", "W(h) [1/m^2]", {weight<CubicSpline>(h, h)},
            Roundoff{5, top, five, 0.25 * top});
  CHECK(weight<CubicSpline>(2 * h, h) == 0);
  CHECK(weight<WendlandC2>(2.5 * h, h) == 0);
  CHECK(radial_slope<WendlandC2>(2.5 * h, h) == 0);

  const std::vector<LatticeRow> rows{
      {"cubic-1_0", "cubic spline, h/dx = 1.0", lattice_sums<CubicSpline>(1.0), 1.000862, 1.013099, 8},
      {"cubic-1_2", "cubic spline, h/dx = 1.2", lattice_sums<CubicSpline>(1.2), 0.999757, 0.990793, 20},
      {"cubic-1_3", "cubic spline, h/dx = 1.3", lattice_sums<CubicSpline>(1.3), 0.999947, 1.010543, 20},
      {"cubic-1_5", "cubic spline, h/dx = 1.5", lattice_sums<CubicSpline>(1.5), 1.003440, 1.006725, 24},
      {"cubic-2_0", "cubic spline, h/dx = 2.0", lattice_sums<CubicSpline>(2.0), 0.999958, 0.999100, 44},
      {"wendland-1_3", "Wendland, h/dx = 1.3", lattice_sums<WendlandC2>(1.3), 1.010473, 0.973921, 20},
      {"wendland-2_0", "Wendland, h/dx = 2.0", lattice_sums<WendlandC2>(2.0), 1.001206, 0.999199, 44},
      {"cubic-body-centred", "cubic spline, h/dx = 1.3, body-centred",
       lattice_sums<CubicSpline>(1.3, Arrangement::body_centred), 1.000509, 0.994034, 44}};
  evidence::Table table{.id = "lattices",
                        .title = "Sums over lattices",
                        .caption = "M differs from 1 by up to 3 % and does not depend on the spacing.",
                        .columns = {{"kernel, lattice", ""}, {"sum V W", "1"}, {"M", "1"}, {"neighbours", "1"}}};
  for (const LatticeRow& row : rows) {
    const auto digits = [&](const std::string& what) {
      return fmt::format("{}: The {} has every digit of the reference ({}).", row.id, what, row.name);
    };
    all_hold(check, Bound{0.5e-6, "half a unit of the last printed digit"},
             {{digits("sum of V W"), row.sums.zeroth, row.zeroth},
              {digits("derivative factor M"), row.sums.first, row.first}});
    CHECK(row.sums.neighbours == row.neighbours);
    table.rows.push_back({row.name, row.sums.zeroth, row.sums.first, static_cast<double>(row.sums.neighbours)});
  }
  check.table(std::move(table));

  std::vector<double> q;
  for (double r = 0; r <= 2.2; r += 0.02) q.push_back(r);
  const auto draw = [&](evidence::Panel& panel, double (*cubic)(double r, double h),
                        double (*wendland)(double, double)) {
    const auto over_q = [&](double (*function)(double, double)) {
      std::vector<double> values;
      for (const double r : q) values.push_back(function(r, 1));
      return values;
    };
    panel.line("cubic spline", q, over_q(cubic));
    panel.line("Wendland C2", q, over_q(wendland), Role::peer);
  };
  auto& figure = check.figure("kernels", "Smoothing kernels", "Value and slope for h = 1.");
  draw(figure.panel({.x = "r/h", .y = "h^2 W"}), weight<CubicSpline>, weight<WendlandC2>);
  draw(figure.panel({.x = "r/h", .y = "h^3 dW/dr"}), radial_slope<CubicSpline>, radial_slope<WendlandC2>);
}

TEST_CASE("pressure, sound speed and elastic energy of Tait's fluid belong together", "[manufactured]") {
  Check check("wcsph_tait", "Tait's equation of state",
              "Pressure and its inverse; $c^2 = dP/d\\rho$ and $de = P/\\rho^2\\,d\\rho$ through the mean over an "
              "interval by quadrature; the pressure of still water.",
              "Batchelor, An introduction to fluid dynamics (1967), section 1.8");
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
