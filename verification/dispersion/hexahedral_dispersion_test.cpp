#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/dispersion/long_waves.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::hexahedral_dispersion_test {

using exact::AiryDispersion, exact::HexahedralDispersion, exact::PlanDispersion, exact::SurfaceInertia;

constexpr double pi = std::numbers::pi;
const std::string source = "Frank, Discrete models of incompressible fluid (1994), 4.1; closed form of its layers";

/// Relative error of the frequency against Airy's law.
double frequency_error(const HexahedralDispersion& law, const AiryDispersion& airy, double k, double direction) {
  return law.frequency(k * std::cos(direction), k * std::sin(direction)) / airy.frequency(k) - 1;
}

/// Errors against Airy's law along an axis, in per cent.
double layers_error(double wavelength, double spacing, std::size_t layers, double direction = 0,
                    SurfaceInertia inertia = SurfaceInertia::nodal) {
  return 100 * frequency_error(HexahedralDispersion(1, 1, spacing, spacing, layers, inertia), AiryDispersion(1, 1),
                               2 * pi / wavelength, direction);
}

double plan_error(double wavelength, double spacing) {
  const double k = 2 * pi / wavelength;
  return 100 * (PlanDispersion(1, 1, spacing, spacing).frequency(k, 0) / AiryDispersion(1, 1).frequency(k) - 1);
}

void claim_limits(Check& check) {
  refine(check, {"size of the cubes", widths(1, {16, 32, 64, 128, 256})},
         {{"order",
           "The frequency on cubes converges to Airy's at second order in their size.",
           {2, 0.05, "expansion in even powers; the next is of the size (k h)^2, at most 0.02 of it"}}},
         [](double h) { return std::abs(layers_error(3, h, cells_of(1, h), 0.5)); });
  // On a fine 2DH lattice.
  for (const std::size_t layers : {1UL, 2UL, 3UL}) {
    for (const bool tuned : {false, true}) {
      const HexahedralDispersion law(1, 1, 1e-3, 1e-3, layers, tuned ? SurfaceInertia::tuned : SurfaceInertia::nodal);
      const double h3 = law.layer_height();
      check.holds(fmt::format("Long waves on {} layers, {} inertia: omega^2 = k^2 (1 - c k^2), c = {}.", layers,
                              tuned ? "tuned" : "nodal", tuned ? "1/3" : "1/3 + h3^2/6"),
                  {long_wave_coefficient([&](double k) { return law.phase_speed(0.6 * k, 0.8 * k); })},
                  Bound{1.4e-7,
                        "extrapolation leaves the product of the three k^2, 1e-6, times the coefficient of k^8, at "
                        "most the 1/16 of 1/(1 + k^2/2); the 2DH mesh h^2/6 (1 - 0.6^4 - 0.8^4) = 7.7e-8",
                        1.0 / 3 + (tuned ? 0 : h3 * h3 / 6)});
    }
  }
  const HexahedralDispersion fine(9.81, 2, 1e-4, 1e-4, 20000);
  Worst airy;
  for (const double k : {0.3, 1.0, 3.0}) airy.add(frequency_error(fine, AiryDispersion(9.81, 2), k, 0.3));
  check.that("airy", "The dispersion relation with 20000 layers of cubes is omega^2 = k tanh kH.",
             "largest relative error of the frequency, k H = 0.6, 2, 6", {airy.value()},
             Bound{9e-8, "(k h)^2 of the shortest wave; the leading coefficient is below 1"});
}

void draw(Check& check) {
  auto& figure = check.figure("models", "Frequency of the models in three dimensions against Airy's law",
                              "Relative error for waves along an axis, h1 = H/2: hexahedra in one to three layers, the "
                              "2DH model, and the Green-Naghdi law that it tends to.");
  auto& lengths = figure.panel({.x = "wavelength/H", .y = "1 - omega/omega_Airy [%]", .log_x = true, .log_y = true});
  auto& angles = figure.panel({.x = "direction [degrees]", .y = "omega/omega_Airy - 1 [%]", .title = "wavelength 7 H"});
  std::vector<double> wavelengths;
  for (double length = 2.5; length < 40; length *= 1.05) wavelengths.push_back(length);
  std::vector<double> degrees;
  for (int i = 0; i <= 90; i += 2) degrees.push_back(i);
  const auto along = [](const std::vector<double>& x, const auto& f) {
    std::vector<double> y;
    for (const double at : x) y.push_back(f(at));
    return y;
  };
  for (const std::size_t layers : {1UL, 2UL, 3UL}) {
    const std::string name = fmt::format("{} layer{}", layers, layers > 1 ? "s" : "");
    lengths.line(name, wavelengths,
                 along(wavelengths, [&](double length) { return -layers_error(length, 0.5, layers); }), Role::computed);
    angles.line(name, degrees,
                along(degrees, [&](double angle) { return layers_error(7, 0.5, layers, angle * pi / 180); }),
                Role::computed);
  }
  lengths.line("2DH model", wavelengths, along(wavelengths, [](double length) { return -plan_error(length, 0.5); }),
               Role::peer);
  const AiryDispersion airy(1, 1);
  const auto green_naghdi = exact::RationalDispersion::green_naghdi(1, 1);
  lengths.line("Green-Naghdi", wavelengths,
               along(wavelengths,
                     [&](double length) {
                       return 100 * (1 - green_naghdi.frequency(2 * pi / length) / airy.frequency(2 * pi / length));
                     }),
               Role::exact);
  angles.line("2DH model", degrees,
              along(degrees,
                    [&](double angle) {
                      const double k = 2 * pi / 7, kx = k * std::cos(angle * pi / 180),
                                   ky = k * std::sin(angle * pi / 180);
                      return 100 * (PlanDispersion(1, 1, 0.5, 0.5).frequency(kx, ky) / airy.frequency(k) - 1);
                    }),
              Role::peer);
}

TEST_CASE("the law of the hexahedral mesh has the known limits", "[dispersion]") {
  Check check(
      "exact_hexahedral_dispersion", "Dispersion law of the three-dimensional Lagrangian mesh",
      "Frank's remark that waves longer than 7 h are well represented by cells of width h and height h/2 holds at 3 %. "
      "The closed form against its layers one by one, the two-dimensional mesh along an axis, one layer against the "
      "2DH model, the coefficient of long waves for both surface inertias, and the order in the size.",
      source);
  check.that("seven-depths", "The frequency error of waves of L/H = 7 on cells H wide and H/2 high is below 3 %.",
             "error of the frequency against Airy's law [%]", {layers_error(7, 1, 2)},
             Bound{3, "Frank's remark, at 3 %"});
  claim_limits(check);
  draw(check);
  CHECK_THROWS_AS(HexahedralDispersion(1, 1, 0.3, 0.3, 0), std::invalid_argument);
  CHECK_THROWS_AS(HexahedralDispersion(1, 1, 0.3, -1, 1), std::invalid_argument);
  CHECK_THROWS_AS(HexahedralDispersion(1, 1, 0.5, 0.5, 2).frequency(2.001 * pi, 0), std::invalid_argument);
  CHECK_THROWS_AS(HexahedralDispersion(1, 1, 0.5, 0.5, 2).frequency(0, 0), std::invalid_argument);
}

}  // namespace seiche::verification::hexahedral_dispersion_test
