/// The exact solutions under a common face: names, parameters with ranges, outputs, and an evaluator by name and
/// number.
///
/// For listings and the command line. Code that uses one solution includes that solution's own header.
///
/// To add one: a file entries/<name>.cpp that defines `ExactSolution <name>_entry()`, its declaration in
/// entries/entries.hpp and its line in catalogue.cpp.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace seiche::exact {

/// A number that chooses one member of a family of solutions; allowed in [minimum, maximum].
struct Parameter {
  std::string name;
  std::string unit;
  double default_value = 0;
  double minimum = 0;
  double maximum = 0;
  std::string meaning;
};

/// Something a solution yields.
struct Quantity {
  std::string name;
  std::string unit;
  std::string meaning;
};

/// One solution with its parameters fixed.
struct Evaluator {
  /// Outputs at (x, y, t), in the order of ExactSolution::outputs; coordinates that are not inputs are ignored.
  /// Throws std::invalid_argument outside the solution's range of validity.
  std::function<std::vector<double>(double x, double y, double t)> eval;
  /// Numbers that belong to the solution as a whole, in the order of ExactSolution::scalars.
  std::function<std::vector<double>()> scalars;
};

struct ExactSolution {
  std::string name;
  std::string title;
  std::string citation;
  std::string formula;
  std::vector<Parameter> parameters;
  std::vector<std::string> inputs;  ///< subset of x, y, t
  std::vector<Quantity> outputs;
  std::vector<Quantity> scalars;
  /// Receives a value for every parameter. Use evaluator(), which checks them.
  std::function<Evaluator(const std::map<std::string, double>&)> factory;

  /// Evaluator for the given parameters, the others at their defaults. Throws std::invalid_argument for a name that is
  /// not a parameter or a value out of its range.
  [[nodiscard]] Evaluator evaluator(const std::map<std::string, double>& values = {}) const;
};

/// All of them, in the order they are listed.
const std::vector<ExactSolution>& catalogue();

/// The one with this name, or nullptr.
const ExactSolution* find_solution(std::string_view name);

}  // namespace seiche::exact
