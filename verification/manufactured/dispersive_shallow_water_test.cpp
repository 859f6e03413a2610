// Dispersive shallow water over an uneven bottom against a manufactured motion: the order of every unknown.
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "validation/instruments/manufactured/dispersive_manufactured.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_shallow_water_test {

using namespace dispersive_shallow_water_1d;
using validation::DispersiveManufactured;

constexpr double end = 5;

/// x, y, p, r, lambda
constexpr std::size_t unknowns = 5;
const std::array<std::string, unknowns> names{"x", "y", "p", "r", "lambda"};
using Errors = std::array<double, unknowns>;
using Fields = std::array<std::vector<double>, unknowns>;

struct Water {
  std::string id, text;
  Kinetics kinetics = Kinetics::frank;
  Stepping stepping = Stepping::one_step;
  double gamma = 0;  ///< of improved dispersion
  Friction friction = {};
};

/// Errors at the end; of lambda in the middle of the cells and of the last step.
Fields errors_at_end(const Water& water, std::size_t n, long steps) {
  const DispersiveManufactured exact(
      {.alpha = 1.0 / 3 + water.gamma, .green_naghdi = water.kinetics == Kinetics::green_naghdi, .gamma = water.gamma});
  const DispersiveManufactured::Parameters& all = exact.parameters();
  const Channel channel{.bottom = std::make_shared<CosineBottom>(all.depth, all.bottom_amplitude,
                                                                 2 * std::numbers::pi * all.bottom_mode / all.length),
                        .period = all.length,
                        .gravity = all.gravity,
                        .kinetics = water.kinetics,
                        .alpha = all.alpha,
                        .gamma = all.gamma,
                        .friction = water.friction};
  const std::vector<double> labels = equal_labels(channel, 0, all.length, n);
  Markers start;
  for (const double label : labels) {
    start.x.push_back(exact.at(label, 0).x);
    start.y.push_back(exact.at(label, 0).y);
  }
  // The motion turns at t = 0.
  start.u = start.v = std::vector<double>(n, 0.0);
  const auto force = [&](double time, std::span<double> along, std::span<double> across) {
    for (std::size_t i = 0; i < n; ++i) {
      const DispersiveManufactured::Sample s = exact.at(labels[i], time);
      const double drag = water.friction.coefficient / (s.y - exact.bottom(s.x).height);
      along[i] += s.source_p + drag * std::abs(s.p) * s.p;
      across[i] += s.source_r;
    }
  };
  Flow flow(channel, start, {.stepping = water.stepping}, {.body_force = force});
  const double tau = end / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) flow.advance(tau);
  Fields errors;
  for (std::size_t i = 0; i < n; ++i) {
    const DispersiveManufactured::Sample s = exact.at(labels[i], end);
    const double lambda = exact.at(labels[i] + 0.5 * all.length / static_cast<double>(n), end - tau / 2).lambda;
    const Errors error{flow.x()[i] - s.x, flow.y()[i] - s.y, flow.p()[i] - s.p, flow.r()[i] - s.r,
                       flow.multipliers()[i] - lambda};
    for (std::size_t k = 0; k < unknowns; ++k) errors[k].push_back(error[k]);
  }
  return errors;
}

Errors rms(const Fields& fields) {
  std::array<Mean, unknowns> means;
  Errors result{};
  for (std::size_t k = 0; k < unknowns; ++k) {
    for (const double e : fields[k]) means[k].add(e);
    result[k] = means[k].rms();
  }
  return result;
}

/// One claim for each unknown.
std::vector<Refined> all_unknowns(const std::string& id, const std::string& text, const Order& order) {
  std::vector<Refined> all;
  for (const std::string& name : names)
    all.push_back({id + "-" + name, text + ": " + name + " is second-order accurate.", order});
  return all;
}

TEST_CASE("all unknowns of dispersive shallow water converge with second order over an uneven bottom",
          "[manufactured]") {
  Check check("dispersive_manufactured", "Dispersive shallow water: manufactured motion over an uneven bottom",
              "Bottom $b = -1 + 0.2\\cos(2\\pi x/10)$, period 10. Nodes are made to follow $x = a + 0.3 "
              "\\sin(ka)\\cos(0.8t)$ with the dynamic pressure $0.05\\cos(2ka)\\sin(0.8t)$ by forces on both rates of "
              "every particle. The bottom lies on the nodes' path, so that frames, volumes and forces all change. The "
              "step is $2.5/n$, the end $t = 5$. Positions, rates and the multipliers must converge at second order, "
              "for either kinetic energy and each scheme, and with the energy of improved dispersion, gamma = 1/15 and "
              "alpha = 2/5, for the two schemes whose gradients of that energy differ. With a quadratic law of "
              "friction, C = 1, and the force that makes up for it, the velocity along the bottom has to.",
              "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4");
  using enum Stepping;
  const Order smooth{2, 0.05, "smooth solution, five resolutions deep in the asymptotic range"};
  for (const auto& [frame, energy, kinetics] :
       {std::tuple{"frank", "Frank's energy", Kinetics::frank},
        {"green_naghdi", "Green and Naghdi's energy", Kinetics::green_naghdi}}) {
    const std::string id = std::string("order-") + frame, text = energy;
    for (const Water& water : std::vector<Water>{
             {id + "-A", text + ", one-step scheme", kinetics},
             {id + "-B", text + ", one-step scheme with feedback", kinetics, one_step_feedback},
             {id + "-C", text + ", fully conservative scheme", kinetics, conservative},
             {id + "-improved-A", text + ", improved dispersion, one-step scheme", kinetics, one_step, 1.0 / 15},
             {id + "-improved-C", text + ", improved dispersion, fully conservative scheme", kinetics, conservative,
              1.0 / 15},
             {id + "-friction", text + ", friction", kinetics, one_step, 0, {FrictionLaw::quadratic, 1}}}) {
      const bool friction = water.friction.coefficient > 0;
      const auto claims = friction ? std::vector<Refined>{{water.id, water.text + ": p converges at second order.",
                                                           Order{2, 0.1, "a symmetric splitting"}}}
                                   : all_unknowns(water.id, water.text, smooth);
      const std::vector<int> cells = friction          ? std::vector{25, 50, 100, 200}
                                     : water.gamma > 0 ? std::vector{50, 100, 200, 400}
                                                       : std::vector{25, 50, 100, 200, 400};
      refine(check, {"width of a cell", widths(10, cells), water.id, water.text}, claims, [&](double width) {
        const std::size_t n = cells_of(10, width);
        const Errors errors = rms(errors_at_end(water, n, static_cast<long>(2 * n)));
        return friction ? Errors{errors[2]} : errors;
      });
    }
  }
}

TEST_CASE("the step alone is second-order accurate over an uneven bottom", "[manufactured]") {
  Check check("dispersive_manufactured_step", "Dispersive shallow water: manufactured motion, refinement of the step",
              "Frank's energy, one-step scheme. On 400 cells the error of the cells, taken from a run with very short "
              "steps, is subtracted node by node.",
              "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4");
  const auto run = [](double tau) { return errors_at_end({}, 400, std::lround(end / tau)); };
  const Fields of_cells = run(0.0125 / 16);
  const Order second{
      2, 0.05,
      "dispersive waves reach omega = 1.9 here: fourth-order errors, (omega tau)^2/4 of the second-order ones, are 1 % "
      "at the longest step; the shortest step is 16 of the reference's, whose own error is 0.4 % of it"};
  refine(check, {"step", {0.1, 0.05, 0.025, 0.0125}}, all_unknowns("order", "The step's error", second),
         [&](double tau) {
           Fields fields = run(tau);
           for (std::size_t k = 0; k < unknowns; ++k) {
             for (std::size_t i = 0; i < fields[k].size(); ++i) fields[k][i] -= of_cells[k][i];
           }
           return rms(fields);
         });
}

}  // namespace seiche::verification::dispersive_shallow_water_test
