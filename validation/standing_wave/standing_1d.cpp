/*
The frequency of a standing wave depends on its amplitude $a$. In water of depth $H$,

$$\Omega = \omega\,\bigl(1 + C\,(a/H)^2\bigr),$$

and $C$ changes sign: frequency rises with amplitude in shallow water and falls in deep water. In Tadjbakhsh and
Keller's theory the change is at $kH = 1.0581$, a wavelength of $5.938\,H$. Frank (1994, section 3.3) studies the effect
with the discrete dispersive shallow-water model. In the limit of fine cells the model's coefficient has a closed form,
with $z = \alpha k^2H^2$, $\alpha = 1/3$,

$$C = -\frac{59 z^3 + 27 z^2 - 3 z - 3}{64\,z\,(1 + z)^2},$$

zero at $kH = 0.9419$: the model has its critical wavelength at $6.671\,H$. The source names Tadjbakhsh and Keller's
$5.94\,H$, which its equations do not have.

**Set-up.** Half a wavelength between two walls, depth and gravity 1. The wave starts from rest at maximum elevation,
with its second harmonic. Elevations are projected on $\cos kx$ of the labels; harmonics fitted to the series give
$\Omega$.

**What is compared.** First the wave of the parameters with the closed form. Then coefficients in the limit of small
amplitude and spacing: amplitudes 0.02 and 0.01, boxes of `cells` and twice as many cells, extrapolated in the squares
of both. The critical wavelength is the root of that measured coefficient. The same with an additional energy of slopes,
$\gamma = 1/15$, $\alpha = 2/5$, which gives small waves nearly Airy's dispersion. Its weight is a power $s$ of the
depth.

**What to look at.** The model agrees with its theory to four digits, and with water qualitatively. The additional
energy with $s = 2$ removes the effect: $C$ stays positive. With $s = 0.714$ the critical wavelength equals the value
for water, and longer waves are near Tadjbakhsh and Keller's theory; the frequency of shorter ones falls too little.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/tools/roots.hpp>

#include "seiche/exact/standing_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/dispersive_standing_mode.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::standing_1d {

using dispersive_shallow_water_1d::stepping_named;
using exact::DispersiveStandingWave;
using Parameters = DispersiveStandingWave::Parameters;

constexpr double pi = std::numbers::pi;
const std::string frank = "Frank, Discrete models of incompressible fluids (1994), section 3.3; averaged Lagrangian";
const std::string water = "Tadjbakhsh and Keller, J. Fluid Mech. 8 (1960) 442";

const Parameters frank_model{.weight_exponent = 2};
const Parameters improved{.alpha = 0.4, .gamma = 1.0 / 15, .weight_exponent = 2};

/// With the weight of the added energy with which the critical wavelength is that of water.
Parameters like_water() {
  Parameters parameters = improved;
  parameters.weight_exponent = *DispersiveStandingWave::exponent_for_critical_depth(
      exact::StandingWave::critical_depth(), improved.alpha, improved.gamma);
  return parameters;
}

/// Tadjbakhsh and Keller's coefficient over (a/H)^2.
double in_water(double kh) {
  return kh * kh * exact::StandingWave::frequency_correction(kh) / (2 * exact::StandingWave::linear_frequency(kh));
}

double coefficient(const StandingBox& box, double amplitude, double periods) {
  return (finite_oscillation(box, amplitude, periods).frequency / box.linear_frequency() - 1) / (amplitude * amplitude);
}

/// What the discrete model has without the errors of spacing and amplitude.
class Limit {
 public:
  explicit Limit(const Values& values)
      : cells_(values.count("cells")),
        periods_(values.real("periods")),
        scheme_{.stepping = stepping_named(values.text("scheme"))} {}

  [[nodiscard]] double coefficient(double kh, const Parameters& parameters) const {
    const double fine = of_small_waves(kh, parameters, 2 * cells_);
    return fine + (fine - of_small_waves(kh, parameters, cells_)) / 3;
  }

  /// Root between two depths at which the coefficient has different signs.
  [[nodiscard]] double critical_wavelength(const Parameters& parameters) const {
    std::uintmax_t evaluations = 30;
    const auto [low, high] =
        boost::math::tools::toms748_solve([&](double kh) { return coefficient(kh, parameters); }, 0.7, 1.5,
                                          boost::math::tools::eps_tolerance<double>(20), evaluations);
    return 4 * pi / (low + high);
  }

  /// A quarter of (k s)^4 of the coarser box: what the extrapolation leaves of the next power of the spacing.
  [[nodiscard]] double uncertainty() const { return std::pow(pi / static_cast<double>(cells_), 4) / 4; }
  [[nodiscard]] std::string resolution() const {
    return fmt::format("{} and {} cells, a/H = 0.01 and 0.02", cells_, 2 * cells_);
  }

 private:
  [[nodiscard]] double of_small_waves(double kh, const Parameters& parameters, std::size_t cells) const {
    StandingBox box{.wavenumber = kh,
                    .cells = cells,
                    .scheme = scheme_,
                    .alpha = parameters.alpha,
                    .gamma = parameters.gamma,
                    .depth_power = parameters.weight_exponent};
    box.tau = 0.4 * box.spacing();
    const double high = validation::cases::standing_1d::coefficient(box, 0.02, periods_);
    const double low = validation::cases::standing_1d::coefficient(box, 0.01, periods_);
    return low + (low - high) / 3;
  }

  std::size_t cells_;
  double periods_;
  dispersive_shallow_water_1d::Scheme scheme_;
};

/// A tenth of what tells the model from water: their critical depths differ by 0.12, the coefficients by half of that.
constexpr double useful_uncertainty = 0.006;

/// Slope of the coefficients over the depth where they vanish, about.
constexpr double slope_at_root = 0.5;

/// In wavelengths, of a root: the coefficient's over its slope in kH.
double in_wavelengths(double uncertainty, double wavelength) {
  return uncertainty / slope_at_root * wavelength * wavelength / (2 * pi);
}

/// The wave of the parameters.
StandingBox own_box(const Values& values) {
  const double kh = values.real("wavenumber");
  return stable({.wavenumber = kh,
                 .cells = StandingBox::cells_of(kh, values.real("h")),
                 .tau = values.real("tau"),
                 .scheme = {.stepping = stepping_named(values.text("scheme"))},
                 .alpha = values.real("alpha"),
                 .gamma = values.real("gamma"),
                 .depth_power = values.real("depth_power")});
}

constexpr std::array judged_depths{0.6, 0.9419, 1.0581, 1.4};
const std::vector<double> drawn_lengths = evenly(4, 12, 9);
const std::vector<double> drawn_amplitudes = evenly(0.01, 0.1, 7);
constexpr std::array drawn_depths{0.6, 0.9419, 1.4};

/// The models whose coefficients are drawn over wavelength.
std::vector<std::pair<std::string, Parameters>> models() {
  return {{"Frank's model", frank_model}, {"gamma = 1/15, s = 2", improved}, {"gamma = 1/15, s = 0.714", like_water()}};
}
constexpr std::size_t judged_model = 1;

struct Results {
  Oscillation own;
  double own_coefficient = 0;
  std::vector<double> coefficients;         ///< of Frank's model at the judged depths
  double critical = 0;                      ///< wavelength of Frank's model
  double critical_with_weight = 0;          ///< of the one made like water
  std::vector<std::vector<double>> curves;  ///< coefficients of the models over the drawn wavelengths
  std::vector<std::vector<double>> shifts;  ///< relative ones of the frequency, at the drawn depths and amplitudes

  /// Of the improved model with s = 2.
  [[nodiscard]] Worst deviation() const {
    const auto off = [&](std::size_t k) {
      return curves[judged_model][k] -
             DispersiveStandingWave::frequency_correction(2 * pi / drawn_lengths[k], improved);
    };
    return over<Worst>(indices(drawn_lengths.size()), off, [](std::size_t k) { return drawn_lengths[k]; });
  }
  [[nodiscard]] double smallest() const { return seiche::smallest(curves[judged_model]); }
};

void claims(const Values& values, const Claims<Results>& claims) {
  const StandingBox box = own_box(values);
  const double own_theory = DispersiveStandingWave::frequency_correction(box.wavenumber, box.wave_parameters());
  claims.at(fmt::format("{} cells, tau = {:g}, a/H = {:g}", box.cells, box.tau, values.real("amplitude")))
      .check("coefficient", "The amplitude coefficient C of the wave of the parameters agrees with theory.",
             "C = (Omega/omega - 1)/(a/H)^2", &Results::own_coefficient,
             Bound{.limit = std::max(0.01 * std::abs(own_theory), 1e-3),
                   .reason = "1 %, and 0.001 where C nearly vanishes: the square of k s is 0.001 at k = 0.6, s = 0.05, "
                             "the square of the amplitude 0.0004, with coefficients of order one",
                   .expected = own_theory});

  const Limit fine(values);
  const Claims<Results> limit = claims.at(fine.resolution());
  const Amount uncertainty = Amount::at_most(fine.uncertainty(), useful_uncertainty);
  for (std::size_t k = 0; k < judged_depths.size(); ++k) {
    const double kh = judged_depths[k];
    limit.check(
        fmt::format("limit-{:.0f}", 1e4 * kh),
        fmt::format("The coefficient C of the model at k H = {:g} agrees with its theory.", kh),
        "C = (Omega/omega - 1)/(a/H)^2", [k](const Results& r) { return r.coefficients[k]; },
        Bound{.limit = uncertainty,
              .reason = "a quarter of (k s)^4 of the coarser box: the error of extrapolation in s^2 from the next "
                        "power, whose coefficient is at most of order one",
              .expected = DispersiveStandingWave::frequency_correction(kh, frank_model)});
  }

  const double theory = DispersiveStandingWave::critical_wavelength(frank_model).value();
  const double of_water = exact::StandingWave::critical_wavelength();
  const auto root_within = [&](double wavelength) {
    return Bound{.limit = Amount::at_most(in_wavelengths(fine.uncertainty(), wavelength),
                                          in_wavelengths(useful_uncertainty, wavelength)),
                 .reason = "a quarter of (k s)^4 of the coarser box over the slope of C, 1/2 per unit of kH",
                 .expected = wavelength};
  };
  limit.check(
      "critical-wavelength",
      "The critical wavelength, at which frequency does not depend on amplitude, agrees with the theory of the model.",
      "critical wavelength/H", &Results::critical, root_within(theory));
  limit.from(water)
      .fails({.value = theory,
              .width = in_wavelengths(useful_uncertainty, theory),
              .reason = "a property of the equations, not of the cells: the coefficient vanishes at alpha (kH)^2 = "
                        "0.2957, a wave 12 % longer than in water"})
      .check("critical-wavelength-of-water",
             "The critical wavelength, at which frequency does not depend on amplitude, equals 5.94 H, the value for "
             "water.",
             "critical wavelength/H", &Results::critical,
             Bound{.limit = 0.01,
                   .reason = "the printed digits of 5.94 in the source",
                   .expected = of_water,
                   .relative = true});
  limit.from(water).check(
      "critical-wavelength-with-weight",
      fmt::format(
          "The critical wavelength with gamma = 1/15 and the weight s = {:.3f} equals 5.938 H, the value for water.",
          like_water().weight_exponent),
      "critical wavelength/H", &Results::critical_with_weight, root_within(of_water));
  limit.check(
      "no-critical-wavelength",
      "The coefficient C with additional energy of weight s = 2 is positive at all wavelengths of 4 to 12 H: no "
      "critical wavelength exists.",
      "the smallest C exceeds its uncertainty",
      [least = fine.uncertainty()](const Results& r) {
        const double smallest = r.smallest();
        return std::isnan(smallest) ? smallest : smallest > least ? 1.0 : 0.0;
      },
      Qualitative{.detector = "sign of the measured coefficient at wavelengths of 4 to 12 H",
                  .reason = "the energy of slopes stiffens crests more than it softens troughs"});
  limit.check("with-gamma", "The coefficient C with additional energy agrees with theory at wavelengths of 4 to 12 H.",
              "largest deviation of C, wavelengths of 4 to 12 H", &Results::deviation,
              Bound{uncertainty, "a quarter of (k s)^4 of the coarser box"});
}

Results compute(const Run& run) {
  const StandingBox own = own_box(run);
  const double amplitude = run.real("amplitude");
  const double periods = run.real("periods");
  const Limit limit(run);
  Results r{.own = finite_oscillation(own, amplitude, periods)};
  r.own_coefficient = (r.own.frequency / own.linear_frequency() - 1) / (amplitude * amplitude);
  for (const double kh : judged_depths) r.coefficients.push_back(limit.coefficient(kh, frank_model));
  r.critical = limit.critical_wavelength(frank_model);
  r.critical_with_weight = limit.critical_wavelength(like_water());
  for (const auto& [label, parameters] : models()) {
    r.curves.push_back(
        each(drawn_lengths, [&, p = parameters](double length) { return limit.coefficient(2 * pi / length, p); }));
    run.progress(0.3 + 0.2 * static_cast<double>(r.curves.size()));
  }
  for (const double kh : drawn_depths) {
    StandingBox box{
        .wavenumber = kh, .cells = 2 * run.count("cells"), .scheme = {.stepping = stepping_named(run.text("scheme"))}};
    box.tau = 0.4 * box.spacing();
    r.shifts.push_back(each(drawn_amplitudes, [&](double a) { return a * a * coefficient(box, a, periods); }));
  }
  return r;
}

/// Coefficients over wavelengths: lines, what was measured, and the critical wavelengths.
void show_coefficients(const Results& r, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(exhibit, "coefficients", "Change of frequency with amplitude",
                                     "C of Frank's model, measured and theoretical, and of water.",
                                     {"k H", "wavelength/H", "measured", "theory", "Tadjbakhsh and Keller"});
  for (std::size_t k = 0; k < judged_depths.size(); ++k) {
    const double kh = judged_depths[k];
    table.rows.push_back({kh, 2 * pi / kh, r.coefficients[k],
                          DispersiveStandingWave::frequency_correction(kh, frank_model), in_water(kh)});
  }
  auto& panel = add_panel(
      exhibit, "coefficient", "Dependence of the standing-wave frequency on amplitude",
      "Coefficient of $(a/H)^2$ in the relative change of frequency, over the wavelength. Lines are theory, circles "
      "are measured, vertical lines the critical wavelengths, 5.938 H in water and 6.671 H in the model.",
      {.x = "wavelength/H", .y = "C", .x_min = 3.4, .x_max = 13, .y_min = -0.4, .y_max = 0.6}, {"frank-standing"});
  const std::vector<double> lengths = evenly(3.4, 13, 193);
  const auto line = [&](const std::string& label, Role role, const auto& correction) {
    panel.line(label, lengths, each(lengths, [&](double length) { return correction(2 * pi / length); }), role);
  };
  line("Tadjbakhsh and Keller", Role::exact, in_water);
  for (const auto& [label, parameters] : models()) {
    line(label, Role::computed,
         [&p = parameters](double kh) { return DispersiveStandingWave::frequency_correction(kh, p); });
  }
  for (const std::vector<double>& measured : r.curves) panel.points("measured", drawn_lengths, measured, Role::data);
  panel.vertical("critical in water", std::vector{exact::StandingWave::critical_wavelength()}, Role::guide);
  panel.vertical("critical in the model", std::vector{r.critical}, Role::guide);
}

/// Frequencies of Frank's model over amplitude.
void draw_frequencies(const Results& r, evidence::Exhibit& exhibit) {
  auto& panel = add_panel(exhibit, "frequency", "Frequency of Frank's model over amplitude",
                          "Circles are measured, the parabolas are third-order theory; the middle wave has the "
                          "model's critical wavelength.",
                          {.x = "a/H", .y = "Omega/omega - 1"});
  const std::vector<double> fine = evenly(0, 0.1, 61);
  for (std::size_t k = 0; k < drawn_depths.size(); ++k) {
    const double c = DispersiveStandingWave::frequency_correction(drawn_depths[k], frank_model);
    const auto theory = each(fine, [&](double a) { return a * a * c; });
    panel.line(fmt::format("kH = {:g}", drawn_depths[k]), fine, theory, Role::exact);
    panel.points("measured", drawn_amplitudes, r.shifts[k], Role::data);
  }
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const StandingBox own = own_box(values);
  show_coefficients(r, exhibit);
  draw_frequencies(r, exhibit);
  exhibit.measure("omega_measured", r.own.frequency);
  exhibit.measure("omega_linear", own.linear_frequency());
  exhibit.measure("coefficient_of_water", in_water(own.wavenumber));
  exhibit.measure("weight_exponent_of_water", like_water().weight_exponent);
}

void standing_1d(Case& c) {
  c.title = "Frequency of standing waves against amplitude: dispersive shallow-water model";
  c.source = literature::frank + ", section 3.3; I. Tadjbakhsh, J. B. Keller, J. Fluid Mech. 8 (1960) 442";
  c.parameters = {
      real("wavenumber", 0.6, "1/H", {0.2, 6}, "wavelength; the walls are half a wavelength apart"),
      real("amplitude", 0.02, "H", {1e-3, 0.3}, "of the first harmonic of the elevation"),
      real("h", 0.05, "H", {1e-3, 1}, "node spacing; adjusted to fit a whole number of times between the walls"),
      real("tau", 0.02, "sqrt(H/g)", {1e-4, 1}, "time step"),
      choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
      real("alpha", 1.0 / 3, "1", {1e-3, 10}, "factor of the vertical kinetic energy"),
      real("gamma", 0.0, "1", {0, 10}, "factor of the additional energy of slopes; below alpha"),
      real("depth_power", 2.0, "1", {-10, 10}, "s: weight of that energy, as a power of the depth"),
      integer("cells", {24, 48, 96}, {8, 1000}, "of the coarser of the two boxes of the extrapolation"),
      real("periods", {10.0, 20.0, 20.0}, "1", {2, 1000}, "length of the series"),
  };
  c.published = {{.tiles = {"frank-standing"},
                  .stated = {"alpha", "gamma", "scheme"},
                  .contradicted = {"critical-wavelength-of-water"}}};
  c.study = Study(claims, compute, show, frank);
}

}  // namespace seiche::validation::cases::standing_1d
