// Dispersive shallow water over an uneven bottom against a manufactured motion: orders and digits.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/manufactured/dispersive_manufactured.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_shallow_water_test {

using namespace dispersive_shallow_water_1d;
using validation::DispersiveManufactured;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";
const std::string digits = "regression: computed once by an earlier program for the same equations";
constexpr double end = 5;

/// x, y, p, r, lambda
constexpr std::size_t unknowns = 5;
const std::array<std::string, unknowns> names{"x", "y", "p", "r", "lambda"};
using Errors = std::array<double, unknowns>;
using Fields = std::array<std::vector<double>, unknowns>;

struct Named {
  std::string id, text;
  Stepping stepping;
};
const std::array<Named, 3> schemes{{{"A", "one-step", Stepping::one_step},
                                    {"B", "one-step with feedback", Stepping::one_step_feedback},
                                    {"C", "fully conservative", Stepping::conservative}}};

struct Frames {
  std::string id, text;
  Kinetics kinetics;
};
const std::array<Frames, 2> frames{{{"frank", "Frank's energy", Kinetics::frank},
                                    {"green_naghdi", "Green and Naghdi's energy", Kinetics::green_naghdi}}};

/// Errors at the end; of lambda in the middle of the cells and of the last step.
Fields errors_at_end(Kinetics kinetics, Stepping stepping, std::size_t n, long steps) {
  const DispersiveManufactured exact({.green_naghdi = kinetics == Kinetics::green_naghdi});
  const DispersiveManufactured::Parameters& parameters = exact.parameters();
  const double length = parameters.length;
  const Channel channel{
      .bottom = std::make_shared<CosineBottom>(parameters.depth, parameters.bottom_amplitude,
                                               2 * std::numbers::pi * parameters.bottom_mode / length),
      .period = length,
      .gravity = parameters.gravity,
      .kinetics = kinetics,
      .alpha = parameters.alpha};
  const std::vector<double> labels = equal_labels(channel, 0, length, n);
  Markers start;
  for (const double label : labels) {
    const DispersiveManufactured::Sample s = exact.at(label, 0);
    start.x.push_back(s.x);
    start.y.push_back(s.y);
  }
  // The motion turns at t = 0.
  start.u.assign(n, 0.0);
  start.v.assign(n, 0.0);
  Forcing forcing;
  forcing.body_force = [&](double time, std::span<double> along, std::span<double> across) {
    for (std::size_t i = 0; i < n; ++i) {
      const DispersiveManufactured::Sample s = exact.at(labels[i], time);
      along[i] += s.source_p;
      across[i] += s.source_r;
    }
  };
  Flow flow(channel, start, {.stepping = stepping}, forcing);
  const double tau = end / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) flow.advance(tau);
  Fields errors;
  for (std::size_t i = 0; i < n; ++i) {
    const DispersiveManufactured::Sample s = exact.at(labels[i], end);
    const double lambda = exact.at(labels[i] + 0.5 * length / static_cast<double>(n), end - tau / 2).lambda;
    const Errors error{flow.x()[i] - s.x, flow.y()[i] - s.y, flow.p()[i] - s.p, flow.r()[i] - s.r,
                       flow.multipliers()[i] - lambda};
    for (std::size_t k = 0; k < unknowns; ++k) errors[k].push_back(error[k]);
  }
  return errors;
}

Errors rms(const Fields& fields) {
  Errors result{};
  for (std::size_t k = 0; k < unknowns; ++k) {
    for (const double e : fields[k]) result[k] += e * e;
    result[k] = std::sqrt(result[k] / static_cast<double>(fields[k].size()));
  }
  return result;
}

/// n cells and steps of 2.5/n.
Errors rms_errors(Kinetics kinetics, Stepping stepping, std::size_t n) {
  return rms(errors_at_end(kinetics, stepping, n, static_cast<long>(2 * n)));
}

const std::array<std::size_t, 5> refinement{25, 50, 100, 200, 400};

/// Difference from a number printed with three digits, in units of the last.
double in_last_digits(double value, double printed) {
  return std::abs(value - printed) / std::pow(10.0, std::floor(std::log10(printed)) - 2);
}

/// One claim per unknown over all resolutions of the table, and the table itself. @param energy  its code in the table
void check_table(Check& check, const std::string& id, const Frames& frame, const Named& scheme, double energy) {
  const io::Table known =
      validation::reference_table("regression_dispersive_manufactured", check.record().reference_data);
  std::vector<std::pair<std::size_t, Errors>> printed;
  for (std::size_t row = 0; row < known.rows(); ++row) {
    if (known.column("energy")[row] != energy) continue;
    Errors errors{};
    for (std::size_t k = 0; k < unknowns; ++k) errors[k] = known.column(names[k])[row];
    printed.emplace_back(static_cast<std::size_t>(known.column("n")[row]), errors);
  }
  REQUIRE(!printed.empty());
  evidence::Table table{
      .id = "digits_" + id,
      .title = fmt::format("Errors, {}, {} scheme", frame.text, scheme.text),
      .caption = "Root-mean-square errors at t = 5, each with the number of the earlier program after it.",
      .columns = {{"n", "1"}}};
  for (const std::string& name : names) {
    table.columns.emplace_back(name, "");
    table.columns.emplace_back(name + ", earlier program", "");
  }
  std::array<Largest, unknowns> farthest;
  for (const auto& [n, expected] : printed) {
    const Errors errors = rms_errors(frame.kinetics, scheme.stepping, n);
    auto& row = table.rows.emplace_back();
    row.emplace_back(static_cast<double>(n));
    for (std::size_t k = 0; k < unknowns; ++k) {
      row.emplace_back(errors[k]);
      row.emplace_back(expected[k]);
      farthest[k].add(in_last_digits(errors[k], expected[k]));
    }
  }
  check.table(table);
  for (std::size_t k = 0; k < unknowns; ++k) {
    check.holds(fmt::format("{}, {} scheme: the error of {} has every recorded digit (regression).", frame.text,
                            scheme.text, names[k]),
                {farthest[k].value()}, Bound{0.5, "half a unit of the last printed digit"});
  }
}

TEST_CASE("all unknowns of dispersive shallow water converge with second order over an uneven bottom",
          "[manufactured]") {
  Check check("dispersive_manufactured", "Dispersive shallow water: manufactured motion over an uneven bottom",
              "Bottom $b = -1 + 0.2\\cos(2\\pi x/10)$, period 10. Markers are made to follow $x = a + 0.3 "
              "\\sin(ka)\\cos(0.8t)$ with the dynamic pressure $0.05\\cos(2ka)\\sin(0.8t)$ by forces on both rates of "
              "every particle. The bottom lies on the markers' path, so that frames, volumes and forces all change. "
              "The step is $2.5/n$, the end $t = 5$. Positions, rates and the multipliers have to converge with second "
              "order, for either kinetic energy and each scheme.",
              source);
  for (const Frames& frame : frames) {
    auto& figure = check.figure("convergence_" + frame.id, "Errors under refinement, " + frame.text,
                                "Root-mean-square errors at t = 5 against the number of cells; the step shrinks with "
                                "them. The grey line falls with second order.");
    for (const Named& scheme : schemes) {
      std::array<std::vector<double>, unknowns> errors;
      std::vector<double> widths, cells;
      for (const std::size_t n : refinement) {
        const Errors e = rms_errors(frame.kinetics, scheme.stepping, n);
        for (std::size_t k = 0; k < unknowns; ++k) errors[k].push_back(e[k]);
        cells.push_back(static_cast<double>(n));
        widths.push_back(10 / cells.back());
      }
      auto& panel = figure.panel({.x = "cells n", .y = "error", .title = scheme.text, .log_x = true, .log_y = true});
      for (std::size_t k = 0; k < unknowns; ++k) {
        panel.line(names[k], cells, errors[k]);
        check.that(fmt::format("order-{}-{}-{}", frame.id, scheme.id, names[k]),
                   fmt::format("{}, {} scheme: {} is of second order.", frame.text, scheme.text, names[k]),
                   "order of the root-mean-square error", observed_order(widths, errors[k]),
                   Order{2, 0.05, "smooth solution, five resolutions deep in the asymptotic range"});
      }
      std::vector<double> slope;
      for (const double n : cells) slope.push_back(errors[0].front() * std::pow(cells.front() / n, 2) * 1.6);
      panel.line("second order", cells, slope, Role::guide);
    }
  }
}

TEST_CASE("the errors of dispersive shallow water are those of an earlier program", "[manufactured]") {
  Check check("dispersive_manufactured_digits", "Dispersive shallow water: manufactured motion, digit by digit",
              "An order shows that a scheme converges; digits show that it is the scheme it claims to be. An earlier "
              "program, with dense matrices, ran the same problem: regression.");
  check_table(check, "frank", frames[0], schemes[0], 1);
  check_table(check, "green_naghdi", frames[1], schemes[0], 2);
  const Errors conservative = rms_errors(Kinetics::frank, Stepping::conservative, 400);
  const io::Table known =
      validation::reference_table("regression_dispersive_manufactured_conservative", check.record().reference_data);
  const auto printed = [&](std::size_t k) {
    const double expected = known.column(names[k]).front();
    check.holds(
        fmt::format("Frank's energy, fully conservative scheme: the error of {} has every recorded digit (regression).",
                    names[k]),
        {in_last_digits(conservative[k], expected)}, Bound{0.5, "half a unit of the last printed digit"});
  };
  for (const std::size_t k : {0, 1, 4}) printed(k);
}

TEST_CASE("the step alone is of second order over an uneven bottom", "[manufactured]") {
  Check check("dispersive_manufactured_step", "Dispersive shallow water: manufactured motion, refinement of the step",
              "Frank's energy, one-step scheme. On 400 cells the error of the cells is taken out marker by marker, as "
              "that of a run with very short steps. On 1600 cells it is small beside the step's.",
              source);
  const auto run = [](std::size_t n, double tau) {
    return errors_at_end(Kinetics::frank, Stepping::one_step, n, std::lround(end / tau));
  };
  const std::vector<double> steps{0.1, 0.05, 0.025, 0.0125};
  const Fields of_cells = run(400, steps.back() / 16);
  std::array<std::vector<double>, unknowns> errors;
  for (const double tau : steps) {
    Fields fields = run(400, tau);
    for (std::size_t k = 0; k < unknowns; ++k) {
      for (std::size_t i = 0; i < fields[k].size(); ++i) fields[k][i] -= of_cells[k][i];
    }
    const Errors e = rms(fields);
    for (std::size_t k = 0; k < unknowns; ++k) errors[k].push_back(e[k]);
  }
  auto& panel = check
                    .figure("convergence", "Errors against the step",
                            "Root-mean-square errors at t = 5 on 400 cells beyond those of very short steps; points "
                            "are an earlier program's on 1600 cells.")
                    .panel({.x = "step", .y = "error", .log_x = true, .log_y = true});
  for (std::size_t k = 0; k < unknowns; ++k) {
    panel.line(names[k], steps, errors[k]);
    check.that(
        "order-" + names[k], "The step's error of " + names[k] + " is of second order.",
        "order of the root-mean-square error", observed_order(steps, errors[k]),
        Order{
            2, 0.05,
            "dispersive waves reach omega = 1.9 here: errors of fourth order, (omega tau)^2/4 of those of second, are "
            "1 % at the longest step; the shortest step is 16 of the reference's, whose own error is 0.4 % of it"});
  }
  const std::vector<double> coarse{0.2, 0.1, 0.05};
  const std::vector<double> expected{5.1e-4, 1.27e-4, 3.2e-5};
  const std::vector<double> last_digit{1e-5, 1e-6, 1e-6};
  panel.points("p, earlier program", coarse, expected, Role::peer);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    check.holds(fmt::format("Error of p with steps of {:g}.", coarse[i]), {rms(run(1600, coarse[i]))[2]},
                Bound{last_digit[i] / 2, "half a unit of the last printed digit", expected[i]});
  }
}

}  // namespace seiche::verification::dispersive_shallow_water_test
