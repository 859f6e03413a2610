#include <cmath>
#include <numbers>

#include "seiche/exact/mach_reflection.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::mach_reflection_test {

using exact::MachReflection;
using validation::each;
using validation::evenly;

const std::string kodama_yeh_source = "Li, Yeh and Kodama, J. Fluid Mech. 672 (2011) 326";

/// Amplitude at the wall over that of the incident wave in the two-soliton solution of the Kadomtsev-Petviashvili
/// equation, u = 2 (ln tau)_xx, tau = cosh(p x) + sqrt(1 - kappa^-2) at y = t = 0 (incident amplitude p^2/2, p = 1), by
/// fourth-order differences of width `span`.
double two_soliton_peak(double kappa, double span) {
  const double coupling = std::sqrt(1 - 1 / (kappa * kappa));
  const auto log_tau = [&](double x) { return std::log(std::cosh(x) + coupling); };
  const double second =
      (16 * (log_tau(span) + log_tau(-span)) - (log_tau(2 * span) + log_tau(-2 * span)) - 30 * log_tau(0)) /
      (12 * span * span);
  return 2 * second / 0.5;
}

double degrees(double angle) {
  return angle * std::numbers::pi / 180;
}

TEST_CASE("amplitudes of Mach and regular reflection have the digits known", "[exact]") {
  Check check(
      "exact_mach_reflection", "Mach reflection of a solitary wave",
      "The resonance condition of the three crests; the regular case against the peak of the two-soliton solution "
      "of the Kadomtsev-Petviashvili equation, of which it is the closed form.");
  const MachReflection steep_kp(0.05, degrees(20), MachReflection::Theory::kodama_yeh);
  const MachReflection regular(0.05, degrees(30));
  const MachReflection high(0.1, degrees(25));
  const double sensitivity = std::abs(
      (MachReflection::wall_ratio(steep_kp.kappa() + 1e-9) - MachReflection::wall_ratio(steep_kp.kappa() - 1e-9)) /
      2e-9);
  check.from(kodama_yeh_source)
      .that("near-one", "The wall amplitude is right next to kappa = 1, where its slope is largest.",
            "a_w/a_i at kappa = 1.00008", {steep_kp.wall_ratio()},
            Roundoff{8, sensitivity, "8 roundings of kappa = 1, times the slope of the amplitude there",
                     3.95026621549695});
  check.source(kodama_yeh_source);
  refine(check, {.axis = "width of the differences", .sizes = falling(0.2, 5), .title = {}, .floor = 1e-11},
         {{"two-solitons",
           "4/(1 + sqrt(1 - kappa^-2)) is the peak of the two-soliton solution.",
           {4, 0.2, "fourth-order differences of an analytic function are the only error"}}},
         [](double span) {
           Worst worst;
           for (const double kappa : {1.01, 1.2, 2.0, 10.0}) {
             worst.add(two_soliton_peak(kappa, span) - MachReflection::wall_ratio(kappa));
           }
           return worst.value();
         });
  CHECK(MachReflection::wall_ratio(1) == 4);
  CHECK(std::abs(MachReflection::wall_ratio(std::nextafter(1.0, 0.0)) - 4) < 1e-15);
  CHECK(regular.reflected_angle() == degrees(30));
  CHECK(regular.stem_angle() == 0);

  auto& figure = check.figure(
      "amplitudes", "Amplitudes at the wall and of the reflected wave",
      "Below $\\kappa = 1$ a stem grows along the wall and the reflected wave is lower than the incident one; at "
      "$\\kappa = 1$ the run-up is fourfold, with infinite slope on the regular side. The linear limit is 2.");
  auto& ratios = figure.panel({.x = "kappa", .y = "amplitude/incident amplitude", .y_min = 0});
  const std::vector<double> kappas = evenly(0.0075, 3, 400);
  ratios.line("wall, a_w/a_i", kappas, each(kappas, [](double k) { return MachReflection::wall_ratio(k); }),
              Role::exact);
  ratios.line("reflected, a_r/a_i", kappas, each(kappas, [](double k) { return MachReflection::reflected_ratio(k); }),
              Role::peer);
  ratios.vertical("kappa = 1", std::vector<double>{1});
  auto& angles = figure.panel({.x = "angle of incidence [deg]",
                               .y = "a_w/a_i",
                               .title = "a_i = 0.05 and 0.2: Miles and Kodama-Yeh",
                               .y_min = 0});
  for (const double a : {0.05, 0.2}) {
    for (const auto theory : {MachReflection::Theory::miles, MachReflection::Theory::kodama_yeh}) {
      const std::vector<double> psi = evenly(1, 70, 277);
      const bool miles = theory == MachReflection::Theory::miles;
      angles.line((miles ? "Miles, a = " : "Kodama-Yeh, a = ") + std::string(a < 0.1 ? "0.05" : "0.2"), psi,
                  each(psi, [&](double p) { return MachReflection(a, degrees(p), theory).wall_ratio(); }),
                  miles ? Role::exact : Role::peer);
    }
  }
}

}  // namespace seiche::verification::mach_reflection_test
