#include "seiche/exact/overturning/overturning_wave.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/surface_curve.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/samples.hpp"
#include "verification/refinement.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::pressure_forced_wave_test {

using exact::PressureForcedWave;

using Complex = std::complex<double>;

const std::string source =
    "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) 1";
const std::string linear_theory =
    "linear response of one Fourier mode, N'' + T N = -T P, to p = -p0 sin t sin(x - t); derived in "
    "pressure_forced_wave.hpp";

constexpr double period = 2 * std::numbers::pi, last_frame = 7.4, tolerance = 2e-11;

/// Of the surface after `steps` steps of fifth order whose errors of fourth are kept at the tolerance, that change the
/// velocity and therefore act for the whole time.
double error_of_steps(double steps, double time) {
  return steps * std::pow(tolerance, 1.2) * (1 + time);
}

void claim_stokes_wave_stays(Check& check) {
  const PressureForcedWave wave({.pressure = 0, .markers = 128});
  const exact::StokesWave stokes(0.3, period, std::numbers::pi, 1);
  Worst difference;
  for (const double t : {2.0, 4.0, last_frame}) {
    const auto profile = wave.profile(t);
    for (std::size_t j = 0; j < profile.x.size(); ++j) {
      difference.add(profile.y[j] - stokes.elevation(profile.x[j], t), t);
    }
  }
  check.that("stokes-wave", "The Stokes wave without pressure is unchanged after more than one period.",
             "largest difference from the Stokes wave [1/k]",
             {.value = difference.value(), .resolution = "128 nodes, tolerance 2e-11"},
             Bound{error_of_steps(500, last_frame),
                   "no more than 500 steps whose fourth-order errors are kept at the tolerance, of fifth order at its "
                   "power 1.2, and act for the whole time"});
}

/// Elevation that the pressure p0 raises on water at rest of depth pi, by linear theory, k = g = 1.
///
/// The pressure is the real part of P e^{ix}, P = p0 (1 - e^{-2it})/2, and eta that of N e^{ix} with N'' + T N = -T P,
/// T = tanh h, N = N' = 0 at t = 0; after t = pi it oscillates freely with the frequency w = sqrt(T):
///
///     N = -p0/2 + A e^{-2it} + (p0/2 - A) cos wt + (2iA/w) sin wt,   A = T p0/(2 (T - 4)).
double linear_response(double p0, double x, double t) {
  using namespace std::complex_literals;
  const double T = std::tanh(std::numbers::pi);
  const double w = std::sqrt(T);
  const double A = T * p0 / (2 * (T - 4));
  const double forced = std::min(t, std::numbers::pi);
  const std::complex<double> turning = A * std::exp(-2.0i * forced);
  const std::complex<double> cosine = 0.5 * p0 - A;
  const std::complex<double> sine = 2.0i * A / w;
  const std::complex<double> N = -0.5 * p0 + turning + cosine * std::cos(w * forced) + sine * std::sin(w * forced);
  const std::complex<double> rate = -2.0i * turning + w * (sine * std::cos(w * forced) - cosine * std::sin(w * forced));
  const double free = w * (t - forced);
  return ((N * std::cos(free) + rate / w * std::sin(free)) * std::exp(1.0i * x)).real();
}

void claim_linear_theory(Check& check) {
  const Order second{.theory = 2,
                     .tolerance = 0.1,
                     .reason =
                         "terms beyond linear theory are of second order in the amplitude; the third order is at most "
                         "3 % of it, 0.04 of the order at its largest"};
  check.source(linear_theory);
  refine(check, {.axis = "p0", .sizes = falling(0.04, 4), .id = "linear", .title = {}},
         {{"linear-forced",
           "The response of still water to the pressure agrees with linear theory while the pressure acts.", second},
          {"linear-free", "The wave that the pressure leaves agrees with linear theory.", second}},
         [](double p0) {
           const PressureForcedWave wave({.amplitude = 0, .pressure = p0, .markers = 64, .last_time = 5});
           const auto error = [&](double t) {
             const auto profile = wave.profile(t);
             Worst worst;
             for (std::size_t j = 0; j < profile.x.size(); ++j) {
               worst.add(profile.y[j] - linear_response(p0, profile.x[j], t));
             }
             return worst.value();
           };
           return std::array{error(2), error(5)};
         });
}

/// The state at t = 2 after equal steps of the wave that the pressure pushes.
exact::overturning::State after_steps(int steps) {
  namespace ow = exact::overturning;
  constexpr double end = 2;
  ow::Stepper stepper(64, std::numbers::pi, [](double x, double t) { return -0.1 * std::sin(t) * std::sin(x - t); },
                      {});
  std::vector<ow::Moment> moments{stepper.begin(0, ow::still_water(64))};
  for (int k = 0; k < steps; ++k) moments.push_back(stepper.step(moments, end / steps).moment);
  return moments.back().state;
}

/// -int p u.n ds, n the outward normal, from a profile alone.
double power(const PressureForcedWave& wave, double t) {
  const auto profile = wave.profile(t);
  const std::size_t n = profile.x.size();
  std::vector<Complex> periodic(n);
  for (std::size_t j = 0; j < n; ++j) {
    periodic[j] = {profile.x[j] - period * static_cast<double>(j) / static_cast<double>(n), profile.y[j]};
  }
  const auto tangents = exact::overturning::TrigonometricInterpolant(periodic).derivative().refined(1);
  double sum = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double outward = profile.v[j] * (1 + tangents[j].real()) - profile.u[j] * tangents[j].imag();
    sum -= wave.pressure(profile.x[j], t) * outward;
  }
  return sum * period / static_cast<double>(n);
}

void claim_work(Check& check, const PressureForcedWave& wave) {
  const double work = boost::math::quadrature::gauss<double, 20>::integrate([&](double t) { return power(wave, t); },
                                                                            0.0, std::numbers::pi);
  check.that(
      "work",
      "The work of the pressure equals the quadrature of pressure times inward normal velocity over 20 profiles.",
      "difference from the work by quadrature of 20 profiles [rho g/k^3]",
      {.value = wave.action(last_frame).work - work, .resolution = "256 nodes, 20 Gauss points"},
      Bound{200 * std::pow(tolerance, 1.2),
            "the work is stepped with the surface: some 200 steps to t = pi whose fourth-order errors are kept at the "
            "tolerance, of fifth order at its power 1.2"});
}

void claim_balance(Check& check, const PressureForcedWave& wave) {
  const auto start = wave.integrals(0);
  Worst energy, impulse, volume;
  for (int i = 1; i <= 37; ++i) {
    const double t = last_frame * i / 37;
    const auto now = wave.integrals(t);
    const auto action = wave.action(t);
    energy.add(now.kinetic_energy + now.potential_energy - start.kinetic_energy - start.potential_energy - action.work);
    impulse.add(now.impulse - start.impulse - action.thrust);
    volume.add(now.volume - start.volume);
  }
  const double limit = 400 * std::pow(tolerance / 0.3, 1.2);
  const std::string reason =
      "some 400 steps whose fourth-order errors are kept at 2e-11, over the amplitude; the fifth-order solution that "
      "is carried on errs less by a step, the fifth root of that";
  check.that("energy", "The energy at 37 times changes by the work of the pressure, up to the jet.",
             "largest |E(t) - E(0) - W(t)| at 37 times [rho g/k^3]", {energy.value()},
             Bound{2 * limit, reason + "; twice as much of a square"});
  check.that("impulse", "The horizontal impulse at 37 times changes by the thrust of the pressure, up to the jet.",
             "largest |I(t) - I(0) - thrust(t)| at 37 times [rho g^(1/2) k^(-5/2)]", {impulse.value()},
             Bound{2 * limit, reason + "; twice as much of a square"});
  check.that("volume", "Volume is conserved at 37 times up to the jet.", "largest change at 37 times [1/k^2]",
             {volume.value()}, Bound{limit, reason});
}

double tangent_of(const PressureForcedWave& wave) {
  return wave.vertical_tangent_time().value_or(std::numeric_limits<double>::quiet_NaN());
}

void claim_convergence(Check& check, const PressureForcedWave& wave) {
  constexpr std::array coarser{std::pair(128UL, 1e-8), std::pair(192UL, 1e-9)};
  evidence::Table table{.id = "convergence",
                        .title = "Distance of the surface from the surface with 256 nodes and tolerance 2e-11",
                        .caption = "Hausdorff distances; the time of the first vertical tangent.",
                        .columns = {{"markers", "1"}, {"tolerance", "1/k"}, {"vertical tangent", "1/sqrt(g k)"}},
                        .rows = {}};
  constexpr std::array times{5.4, 6.8, 7.2, 7.4};
  for (const double t : times) table.columns.emplace_back(fmt::format("t = {:g}", t), "1/k");
  std::vector<double> tangents, distances;
  for (const auto& [markers, step_tolerance] : coarser) {
    const PressureForcedWave other({.markers = markers, .tolerance = step_tolerance});
    tangents.push_back(tangent_of(other));
    std::vector<std::variant<double, std::string>> row{static_cast<double>(markers), step_tolerance, tangents.back()};
    for (const double t : times) row.emplace_back(wave.distance_from(other, t));
    distances.push_back(std::get<double>(row.back()));
    table.rows.push_back(row);
  }
  const double tangent = tangent_of(wave);
  check.table(table);
  const std::string use = "1e-4 of half a cell of the finest particle arrangement compared with this surface";
  check.that("self-convergence",
             "The surface with a jet at the last frame is the same with 256 and with 192 nodes within 4e-6.",
             "Hausdorff distance of 256 nodes, tolerance 2e-11, and 192, 1e-9 [1/k]", {distances[1]}, Bound{4e-6, use});
  check.that(
      "convergence",
      "The surface converges at least as its tolerance, which is 10 times smaller from resolution to resolution.",
      "distance from the third resolution at 7.4, second over first resolution", {distances[1] / distances[0]},
      Bound{0.2,
            "a tolerance ten times smaller lets fifth-order errors be ten times smaller; steps are at most cut in "
            "five, which shifts them by less than two"});
  check.that("vertical-tangent",
             "The time at which the front is first vertical is the same with 256 and with 192 nodes within 4e-6.",
             "time by 192 nodes, tolerance 1e-9, minus the time by 256, 2e-11 [1/sqrt(g k)]", {tangents[1] - tangent},
             Bound{4e-6, use + ", which the crest travels in that time"});
}

TEST_CASE("a pressure moves water as linear theory says and without one the Stokes wave stays itself", "[exact]") {
  Check check("exact_pressure_response", "Water at rest and a Stokes wave under a small pressure, or none",
              "Water at rest under $p_s = -p_0 \\sin t \\sin(x - t)$, $0 \\le t \\le \\pi$, must respond as in linear "
              "theory, up to terms of second order in $p_0$: the error is measured for four amplitudes. Without "
              "pressure a Stokes wave of height 0.6 must travel unchanged.",
              source);
  claim_stokes_wave_stays(check);
  claim_linear_theory(check);
}

TEST_CASE("the surface under a pressure converges with the order of the step", "[exact]") {
  Check check("exact_pressure_steps", "Equal steps of a surface under a changing pressure",
              "Water at rest under the pressure of 0.1, by equal steps of a pair of order five.",
              "Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19: order five");
  const auto finest = after_steps(320);
  refine(
      check, {.axis = "time step", .sizes = widths(2, {10, 14, 20, 28, 40}), .title = {}, .floor = 1e-12},
      {{"order-in-time",
        "Surface, work and thrust converge with the order of the step, also under a pressure that changes.",
        {5, 0.3,
         "steps of 0.2 to 0.05 of a wave whose period is 6.3: the next order is a fifth of this one at the longest"}}},
      [&](double tau) {
        const auto state = after_steps(static_cast<int>(cells_of(2, tau)));
        Worst worst;
        for (std::size_t k = 0; k < state.size(); ++k) worst.add(state[k] - finest[k]);
        return worst.value();
      });
}

TEST_CASE("a Stokes wave pushed by a pressure satisfies its balances and converges up to the jet", "[exact]") {
  Check check("exact_pressure_forced_wave", "Stokes wave pushed by a surface pressure until it overturns",
              "A Stokes wave of height 0.6, $L = 2\\pi$, depth $\\pi$ is pushed by $p_s = -p_0 \\sin t \\sin(x - t)$, "
              "$0 \\le t \\le \\pi$. Energy and impulse must change by the pressure's work and thrust. Three "
              "resolutions give the numerical error of surface and time of the vertical tangent. $p_0 = 0.1$ is a fit "
              "to the times of Frank's figure 10, not his number.",
              source);
  const PressureForcedWave wave({});
  claim_work(check, wave);
  claim_balance(check, wave);
  claim_convergence(check, wave);
  self_test_holds(check, "figure-10", wave);
  self_test_holds(check, "quickened", PressureForcedWave({.pressure = 0, .velocity_factor = 1.5, .last_time = 3}));
}

TEST_CASE("a wave pushed by a pressure rejects parameters outside its range", "[exact]") {
  const PressureForcedWave unit({.markers = 64, .last_time = 3.5});
  CHECK(unit.pressure(1, 3.2) == 0);
  CHECK(unit.pressure(1, 1) == 0);
  CHECK(std::abs(unit.pressure(0, std::numbers::pi / 2) - 0.1) < 1e-15);
  CHECK_THROWS_AS(unit.action(4), std::invalid_argument);
}

}  // namespace seiche::verification::pressure_forced_wave_test
