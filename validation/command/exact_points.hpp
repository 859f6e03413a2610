/// Points and parameters of `seiche exact` from the words of the command line.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "seiche/exact/catalogue.hpp"

namespace seiche::command {

/// A value for every input of a solution, in their order.
using Point = std::vector<double>;

/// The default of every input.
Point default_point(const exact::ExactSolution& solution);

/// The points of --at ("x=1,t=2"), or the product of the ranges of --grid ("x=-10:10:401,t=2"), the first input running
/// fastest. Inputs that are not named keep their default.
///
/// @throws std::invalid_argument naming the coordinate and what is allowed
std::vector<Point> points_at(const exact::ExactSolution& solution, const std::vector<std::string>& points);
std::vector<Point> points_on_grid(const exact::ExactSolution& solution, const std::string& grid);

/// A value for every parameter: defaults, then "name=value" (several in one word are separated by commas).
std::map<std::string, double> parameters_from(const exact::ExactSolution& solution,
                                              const std::vector<std::string>& settings);

}  // namespace seiche::command
