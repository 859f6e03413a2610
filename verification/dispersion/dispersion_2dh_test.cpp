#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersion_2dh_test {

using exact::PlanDispersion;

constexpr double pi = std::numbers::pi, diagonal = pi / 4;
const std::string source =
    "Frank, Discrete models of incompressible fluid (1994), ch. 3 and 4.2; closed form of its cells";
PlanDispersion square(double spacing) {
  return {1, 1, spacing, spacing};
}

/// The leading term of the law's error, of second order in the spacings, for g = H = 1 and alpha = 1/3.
double leading_error(double hx, double hy, double k, double direction) {
  const double c2 = std::pow(std::cos(direction), 2), s2 = std::pow(std::sin(direction), 2);
  const double potential = c2 * hx * hx + s2 * hy * hy;
  const double inertia = (c2 * c2 * hx * hx + s2 * s2 * hy * hy) / (1 + k * k / 3);
  return k * k / 12 * (inertia - potential);
}

/// Relative error of the frequency against the limit without a lattice: the anisotropy of the lattice.
double frequency_error(const PlanDispersion& law, double k, double direction) {
  return law.frequency(k * std::cos(direction), k * std::sin(direction)) / law.limit().frequency(k) - 1;
}

void claim_orders(Check& check) {
  constexpr double k = 1.2, direction = 0.5;
  check.source(source);
  refine(check, {"h1", {0.4, 0.2, 0.1, 0.05, 0.025}},
         {{"order",
           "The frequency converges to the Green-Naghdi equations at second order in the spacing.",
           {2, 0.05, "expansion in even powers; the next is of the size (k h)^2, at most 0.2 of it"}},
          {"leading-term",
           "The frequency error beyond its leading term is fourth-order in the spacing.",
           {4, 0.1, "expansion in even powers; the next is of the size (k h)^2, at most 0.2 of it"}}},
         [](double spacing) {
           const PlanDispersion law(1, 1, spacing, 0.7 * spacing);
           const double error = frequency_error(law, k, direction);
           return std::array{std::abs(error), std::abs(error - leading_error(spacing, 0.7 * spacing, k, direction))};
         });
  const double h = 0.5, small = 0.02;
  check.from(source).that(
      "anisotropy", "The relative error of omega^2 of long waves at 45 degrees is -(h k)^2/12.",
      "2 delta omega/omega over (h k)^2 at k H = 0.02",
      {2 * frequency_error(square(h), small, diagonal) / (h * h * small * small)},
      Bound{3e-4 / 12, "the next terms are (k H)^2/3 and (h k)^2 of it, 1.3e-4 and 1e-4", -1.0 / 12});
}

void draw(Check& check) {
  auto& sizes = check.figure("wavelength", "Error of the frequency on 2DH meshes",
                             "Relative error against the Green-Naghdi law for square cells: along an axis the "
                             "second-order terms cancel for long waves, at 45 degrees they do not.");
  auto& panel = sizes.panel({.x = "wavelength/H", .y = "-(omega/omega_GN - 1)", .log_x = true, .log_y = true});
  std::vector<double> wavelengths;
  for (double length = 2.9; length < 40; length *= 1.05) wavelengths.push_back(length);
  for (const double h : {1.0, 0.5, 0.25}) {
    for (const double direction : {0.0, diagonal}) {
      std::vector<double> errors;
      for (const double length : wavelengths) errors.push_back(-frequency_error(square(h), 2 * pi / length, direction));
      panel.line(fmt::format("h = {:g} H, {}", h, direction == 0 ? "axis" : "45 degrees"), wavelengths, errors,
                 direction == 0 ? Role::computed : Role::peer);
    }
  }
  auto& rose = check.figure("anisotropy", "Anisotropy of the 2DH mesh",
                            "Size of the relative error of the frequency against the direction of the wave, h = H/2: "
                            "in polar form, distance from the centre in %, and against the angle.");
  auto& polar = rose.panel({.x = "error along x [%]", .y = "error along y [%]", .equal_aspect = true});
  auto& angles = rose.panel({.x = "direction [degrees]", .y = "omega/omega_GN - 1 [%]"});
  for (const double length : {4.0, 6.0, 10.0}) {
    std::vector<double> x, y, degrees, errors;
    for (int i = 0; i <= 180; ++i) {
      const double direction = 2 * pi * i / 180;
      const double percent = 100 * frequency_error(square(0.5), 2 * pi / length, direction);
      x.push_back(-percent * std::cos(direction));
      y.push_back(-percent * std::sin(direction));
      if (4 * i > 180) continue;
      degrees.push_back(direction * 180 / pi);
      errors.push_back(percent);
    }
    const std::string name = fmt::format("wavelength {:g} H", length);
    polar.line(name, x, y, Role::computed);
    angles.line(name, degrees, errors, Role::computed);
  }
}

TEST_CASE("the law of the 2DH model has the known limits", "[dispersion]") {
  Check check("exact_2dh_dispersion", "Dispersion law of dispersive shallow water in 2DH",
              "Formula (13) along the axes, the leading error with its anisotropy, and the order in the spacing.");
  claim_orders(check);
  draw(check);
  CHECK_THROWS_AS(PlanDispersion(1, 1, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(PlanDispersion(1, 1, 1, 1, 0), std::invalid_argument);
  CHECK_THROWS_AS(square(0.5).frequency(0, 0), std::invalid_argument);
  CHECK_THROWS_AS(square(0.5).frequency(0.1, 2.001 * pi), std::invalid_argument);
}

}  // namespace seiche::verification::dispersion_2dh_test
