// Small oscillations of a hanging chain: frequencies of both schemes, and the largest stable step.
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification::one_step_linear_modes_test {

using namespace mechanics;
using namespace rigid_chain;

const std::string source = "Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), I.1.4, I.5";
constexpr double amplitude = 1e-7;
constexpr std::size_t count = 4;
using Matrix = Eigen::Matrix<double, count, count>;

RigidChain hanging_chain() {
  return RigidChain({.masses = alternating_masses(count), .pinned = true, .gravity = 1});
}

/// Modes of M x'' = -K x, K tridiagonal: unit links under tensions that are the weights below.
struct Modes {
  std::vector<double> frequency;
  Matrix shape;
};

Modes modes() {
  const std::vector<double> mass = alternating_masses(count);
  Matrix m = Matrix::Zero(), k = Matrix::Zero();
  double tension = 0;
  for (Eigen::Index i = count - 1; i >= 0; --i) {
    m(i, i) = mass[static_cast<std::size_t>(i)];
    tension += m(i, i);
    k(i, i) += tension;
    if (i > 0) {
      k(i - 1, i - 1) += tension;
      k(i, i - 1) -= tension;
      k(i - 1, i) -= tension;
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(k, m);
  Modes result{{}, solver.eigenvectors()};
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(count); ++i) {
    result.frequency.push_back(std::sqrt(solver.eigenvalues()[i]));
  }
  return result;
}

State displaced(const Modes& all, std::size_t mode) {
  State state{.q = std::vector<double>(3 * count, 0.0), .u = std::vector<double>(3 * count, 0.0)};
  for (std::size_t k = 0; k < count; ++k) {
    state.q[3 * k] = amplitude * all.shape(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(mode));
    state.q[3 * k + 2] = -static_cast<double>(k + 1);
  }
  return state;
}

/// omega tau from x^{n+1} + x^{n-1} = 2 cos(omega tau) x^n, least squares over all masses and steps.
double phase_of_a_step(Integrator integrator, const Modes& all, std::size_t mode, double tau) {
  RigidChain chain = hanging_chain();
  const StepFunction step = make_integrator(integrator, chain);
  State state = displaced(all, mode);
  std::vector<double> before = state.q;
  step(state, tau);
  std::vector<double> now = state.q;
  double product = 0, square = 0;
  for (int n = 0; n < 40; ++n) {
    step(state, tau);
    for (std::size_t i = 0; i < now.size(); i += 3) {
      product += (state.q[i] + before[i]) * now[i];
      square += now[i] * now[i];
    }
    before = std::exchange(now, state.q);
  }
  return std::acos(product / (2 * square));
}

/// Measured frequencies against the scheme's law, for steps given as Omega_max tau.
struct Deviation {
  std::vector<double> step;
  Worst largest = {};              ///< relative, over all modes
  std::vector<double> found = {};  ///< omega/Omega of the fastest mode
  std::vector<double> law = {};
};

Deviation deviation(Integrator integrator, const Modes& all, const std::vector<double>& steps) {
  Deviation result{steps};
  for (const double step : steps) {
    const double tau = step / all.frequency.back();
    for (std::size_t mode = 0; mode < count; ++mode) {
      const double half = all.frequency[mode] * tau / 2;
      const double law = 2 * (integrator == Integrator::one_step ? std::asin(half) : std::atan(half));
      const double found = phase_of_a_step(integrator, all, mode, tau);
      result.largest.add(found / law - 1);
      if (mode + 1 < count) continue;
      result.found.push_back(found / step);
      result.law.push_back(law / step);
    }
  }
  return result;
}

/// Largest horizontal displacement over the initial one.
double growth(double share_of_limit, int steps) {
  const Modes all = modes();
  RigidChain chain = hanging_chain();
  const StepFunction step = make_integrator(Integrator::one_step, chain);
  State state = displaced(all, count - 1);
  const auto sideways = [&] { return worst_of(count, [&](std::size_t k) { return state.q[3 * k]; }); };
  const double start = sideways();
  Largest largest;
  for (int n = 0; n < steps && !(largest.value() >= 1e3 * start); ++n) {
    step(state, share_of_limit * 2 / all.frequency.back());
    largest.add(sideways());
  }
  return largest.value() / start;
}

TEST_CASE("frequencies of small oscillations and the largest stable step", "[dispersion]") {
  Check check("one_step_linear_modes", "Small oscillations: phase error and stability",
              "Four masses hang from a pin; a mode of frequency $\\Omega$ has amplitude 1e-7. The one-step scheme "
              "gives it the frequency $\\omega$ with $\\sin(\\omega\\tau/2) = \\Omega\\tau/2$, too high, and is stable "
              "for $\\Omega\\tau < 2$; the fully conservative one $\\tan(\\omega\\tau/2) = \\Omega\\tau/2$, too low by "
              "twice as much. The modes of the linearised chain come from an eigenvalue solver.",
              source);
  const Modes all = modes();
  // Beyond 1.2 the sweeps of the implicit scheme, which gain (Omega tau)^2/4 each, take too many.
  const Deviation one_step = deviation(Integrator::one_step, all, {0.1, 0.3, 0.6, 0.9, 1.2, 1.5, 1.8});
  const Deviation conservative = deviation(Integrator::conservative, all, {0.1, 0.3, 0.6, 0.9, 1.2});
  auto& panel = check.figure("phase", "Frequency of small oscillations", "The fastest mode and the schemes' laws.")
                    .panel({.x = "Omega tau", .y = "omega / Omega"});
  panel.points("one-step scheme", one_step.step, one_step.found, Role::computed);
  panel.line("arcsine law", one_step.step, one_step.law, Role::exact);
  panel.points("fully conservative", conservative.step, conservative.found, Role::peer);
  panel.line("arctangent law", conservative.step, conservative.law, Role::guide);
  const Bound small{1e-10,
                    "rounding of cos(omega tau), up to 1e-15, over its slope (omega tau)^2 of 3e-4 in the slowest mode "
                    "at the smallest step; second-order terms in the amplitude are 1e-14"};
  check.that("one-step", "The frequencies of the one-step scheme agree with the arcsine law.",
             "largest relative error of a frequency, all modes, Omega_max tau = 0.1 .. 1.8", {one_step.largest.value()},
             small);
  check.that("conservative", "The frequencies of the fully conservative scheme agree with the arctangent law.",
             "largest relative error of a frequency, all modes, Omega_max tau = 0.1 .. 1.2",
             {conservative.largest.value()}, small);
  check.that("stable", "The fastest mode at 0.98 of the limit tau = 2/Omega_max stays bounded.",
             "largest displacement over the initial one, 10000 steps", {growth(0.98, 10000)},
             Bound{1.01, "a mode released from rest oscillates between its ends; other modes enter by rounding"});
  check.that(
      "unstable", "The fastest mode at 1.02 of the limit tau = 2/Omega_max grows a thousandfold.",
      "displacement grows by a factor of 1000 in 100 steps", {growth(1.02, 100) >= 1e3 ? 1.0 : 0.0},
      Qualitative{"largest displacement >= 1000 times the initial", "it grows by cosh(100 * 2 arcosh 1.02) = 1e17"});
}

}  // namespace seiche::verification::one_step_linear_modes_test
