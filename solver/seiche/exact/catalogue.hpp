/// The exact solutions under a common face: names, parameters with ranges, outputs, and an evaluator by name and
/// number.
///
/// For listings, the command line and Python. C++ code that uses one solution includes that solution's own header.
///
/// To add one: `ExactSolution <name>_entry()` at the end of the solution's file (entry.hpp), and its name in
/// catalogue.cpp, twice.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

/// A number that chooses one member of a family of solutions; allowed in [minimum, maximum]. Infinity is a value where
/// maximum is infinite. A parameter with choices is the number of one of them.
struct Parameter {
  std::string name;
  std::string unit;
  double default_value = 0;
  double minimum = 0;
  double maximum = 0;
  std::string meaning;
  std::vector<std::string> choices = {};
};

/// A coordinate that the solution is evaluated at, and what it is where none is given.
struct Coordinate {
  std::string name;
  std::string unit;
  double default_value = 0;
  std::string meaning;
};

/// Something a solution yields.
struct Quantity {
  std::string name;
  std::string unit;
  std::string meaning;
};

/// One solution with its parameters fixed. Numbers come in the order of the solution's inputs, outputs and scalars.
struct Evaluator {
  using Row = std::vector<double>;

  /// Outputs at one point. Throws OutsideFluid where there is no water, std::invalid_argument outside the solution's
  /// range of validity.
  std::function<Row(std::span<const double>)> eval;
  /// Numbers that belong to the solution as a whole.
  std::function<Row()> scalars;
  /// For a solution that is a curve at every point (a surface that overturns): the outputs along it. Else empty.
  std::function<std::vector<Row>(std::span<const double>)> curve = {};
  /// See ReferenceSolution.
  std::function<double()> uncertainty;
  std::function<SelfTest()> self_test;
};

struct ExactSolution {
  std::string name;
  std::string title;
  std::string citation;
  std::string formula;
  std::vector<Parameter> parameters;
  std::vector<Coordinate> inputs;
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

/// The one with this name. Throws std::invalid_argument naming those that there are.
const ExactSolution& find_solution(std::string_view name);

}  // namespace seiche::exact
