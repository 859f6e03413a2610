// Improved dispersion over an uneven bottom against a manufactured motion: the order of every unknown.
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/dispersive_manufactured.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_improved_test {

using namespace dispersive_shallow_water_1d;
using validation::DispersiveManufactured;

constexpr double gamma_factor = 1.0 / 15;
constexpr double end = 5;
constexpr std::size_t unknowns = 5;
const std::array<std::string, unknowns> names{"x", "y", "p", "r", "lambda"};

/// Root mean squares at the end; of lambda in the middle of the cells and of the last step.
std::array<double, unknowns> errors_at_end(Kinetics kinetics, Stepping stepping, std::size_t n) {
  const DispersiveManufactured exact(
      {.alpha = 1.0 / 3 + gamma_factor, .green_naghdi = kinetics == Kinetics::green_naghdi, .gamma = gamma_factor});
  const auto& parameters = exact.parameters();
  const double length = parameters.length;
  Channel channel{.bottom = std::make_shared<CosineBottom>(parameters.depth, parameters.bottom_amplitude,
                                                           2 * std::numbers::pi / length),
                  .period = length,
                  .gravity = parameters.gravity,
                  .kinetics = kinetics,
                  .alpha = parameters.alpha,
                  .gamma = parameters.gamma};
  const std::vector<double> labels = equal_labels(channel, 0, length, n);
  Markers start;
  for (const double label : labels) {
    const auto s = exact.at(label, 0);
    start.x.push_back(s.x);
    start.y.push_back(s.y);
  }
  start.u.assign(n, 0.0);  // the motion turns at t = 0
  start.v.assign(n, 0.0);
  Forcing forcing;
  forcing.body_force = [&](double time, std::span<double> along, std::span<double> across) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto s = exact.at(labels[i], time);
      along[i] += s.source_p;
      across[i] += s.source_r;
    }
  };
  Flow flow(channel, start, {.stepping = stepping}, forcing);
  const auto steps = static_cast<long>(2 * n);
  const double tau = end / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) flow.advance(tau);
  std::array<Mean, unknowns> squares;
  for (std::size_t i = 0; i < n; ++i) {
    const auto s = exact.at(labels[i], end);
    const double lambda = exact.at(labels[i] + 0.5 * length / static_cast<double>(n), end - tau / 2).lambda;
    const std::array<double, unknowns> error{flow.x()[i] - s.x, flow.y()[i] - s.y, flow.p()[i] - s.p, flow.r()[i] - s.r,
                                             flow.multipliers()[i] - lambda};
    for (std::size_t k = 0; k < unknowns; ++k) squares[k].add(error[k] * error[k]);
  }
  std::array<double, unknowns> result{};
  for (std::size_t k = 0; k < unknowns; ++k) result[k] = std::sqrt(squares[k].value());
  return result;
}

TEST_CASE("improved dispersion over an uneven bottom is of second order", "[manufactured]") {
  Check check("dispersive_improved_manufactured", "Improved dispersion: manufactured motion over an uneven bottom",
              "The motion of `dispersive_manufactured`, whose depth changes by a fifth of its mean and whose markers "
              "by a fifth of their distance, with the energy of improved dispersion, gamma = 1/15 and alpha = 2/5, and "
              "the forces that then sustain it. All unknowns have to converge with second order, for both kinetic "
              "energies and the two schemes whose gradients of that energy differ.",
              "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4");
  struct Frame {
    std::string id, text;
    Kinetics kinetics;
  };
  struct Scheme {
    std::string id, text;
    Stepping stepping;
  };
  for (const Frame& frame : {Frame{"frank", "Frank's energy", Kinetics::frank},
                             Frame{"green_naghdi", "Green and Naghdi's energy", Kinetics::green_naghdi}}) {
    for (const Scheme& scheme :
         {Scheme{"A", "one-step", Stepping::one_step}, Scheme{"C", "fully conservative", Stepping::conservative}}) {
      std::array<std::vector<double>, unknowns> errors;
      std::vector<double> widths;
      for (const std::size_t n : {50, 100, 200, 400}) {
        const auto e = errors_at_end(frame.kinetics, scheme.stepping, n);
        for (std::size_t k = 0; k < unknowns; ++k) errors[k].push_back(e[k]);
        widths.push_back(10 / static_cast<double>(n));
      }
      for (std::size_t k = 0; k < unknowns; ++k) {
        check.that(fmt::format("order-{}-{}-{}", frame.id, scheme.id, names[k]),
                   fmt::format("{}, {} scheme: {} is of second order.", frame.text, scheme.text, names[k]),
                   "order of the root-mean-square error", observed_order(widths, errors[k]),
                   Order{2, 0.05, "smooth solution, four resolutions, the same motion as without gamma"});
      }
    }
  }
}

}  // namespace seiche::verification::dispersive_improved_test
