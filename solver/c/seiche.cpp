#include "seiche.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "seiche/exact/catalogue.hpp"
#include "seiche/io/text_table.hpp"
#include "seiche/require_that.hpp"

using namespace seiche;

struct seiche_solution {
  const exact::ExactSolution& description;
  exact::Evaluator evaluator;
};

namespace {

thread_local std::string error;

/// What `action` gives, or a value that says that it failed.
template <class Result, class Action>
Result guarded(Result failed, Action action) noexcept {
  try {
    return action();
  } catch (const std::exception& wrong) {
    error = wrong.what();
  } catch (...) {
    error = "unknown error";
  }
  return failed;
}

std::map<std::string, double> values_of(const exact::ExactSolution& solution, const std::string& text) {
  std::map<std::string, double> values;
  for (const std::string& setting : io::words_of(text, ", \t")) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string name = setting.substr(0, equals);
    const std::string value = setting.substr(std::min(equals + 1, setting.size()));
    const auto parameter = std::find_if(solution.parameters.begin(), solution.parameters.end(),
                                        [&](const exact::Parameter& p) { return p.name == name; });
    if (parameter != solution.parameters.end()) {
      const auto choice = std::find(parameter->choices.begin(), parameter->choices.end(), value);
      if (choice != parameter->choices.end()) {
        values[name] = static_cast<double>(choice - parameter->choices.begin());
        continue;
      }
    }
    const auto number = io::number_in(value);
    require_that(number.has_value(), "parameter '{}': must be name=number", setting);
    values[name] = *number;
  }
  return values;
}

template <class Named>
const char* name_of(const std::vector<Named>& all, std::size_t k) {
  return k < all.size() ? all[k].name.c_str() : nullptr;
}

}  // namespace

seiche_solution* seiche_create(const char* name, const char* parameters) {
  return guarded<seiche_solution*>(nullptr, [&] {
    require_that(name != nullptr, "name: must not be NULL");
    const exact::ExactSolution& description = exact::find_solution(name);
    require_that(!description.outputs.empty(), "{}: has no values at points", name);
    exact::Evaluator evaluator = description.evaluator(values_of(description, parameters == nullptr ? "" : parameters));
    require_that(!evaluator.curve, "{}: is a curve, not values at points", name);
    return new seiche_solution{description, std::move(evaluator)};
  });
}

void seiche_free(seiche_solution* solution) {
  delete solution;
}

size_t seiche_inputs(const seiche_solution* solution) {
  return solution == nullptr ? 0 : solution->description.inputs.size();
}

size_t seiche_outputs(const seiche_solution* solution) {
  return solution == nullptr ? 0 : solution->description.outputs.size();
}

const char* seiche_input(const seiche_solution* solution, size_t k) {
  return solution == nullptr ? nullptr : name_of(solution->description.inputs, k);
}

const char* seiche_output(const seiche_solution* solution, size_t k) {
  return solution == nullptr ? nullptr : name_of(solution->description.outputs, k);
}

int seiche_evaluate(const seiche_solution* solution, size_t count, const double* points, double* values) {
  return guarded(1, [&] {
    require_that(solution != nullptr, "solution: must not be NULL");
    const std::size_t inputs = seiche_inputs(solution);
    const std::size_t outputs = seiche_outputs(solution);
    for (std::size_t i = 0; i < count; ++i) {
      double* const at = values + i * outputs;
      try {
        const std::vector<double> row = solution->evaluator.eval({points + i * inputs, inputs});
        std::copy(row.begin(), row.end(), at);
      } catch (const exact::OutsideFluid&) {
        std::fill_n(at, outputs, std::numeric_limits<double>::quiet_NaN());
      }
    }
    return 0;
  });
}

double seiche_scalar(const seiche_solution* solution, const char* name) {
  return guarded(std::numeric_limits<double>::quiet_NaN(), [&] {
    require_that(solution != nullptr && name != nullptr, "solution and name: must not be NULL");
    const std::vector<double> values = solution->evaluator.scalars();
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (solution->description.scalars[k].name == name) return values[k];
    }
    throw std::invalid_argument(fmt::format("{} has no scalar {}", solution->description.name, name));
  });
}

const char* seiche_error(void) {
  return error.c_str();
}
