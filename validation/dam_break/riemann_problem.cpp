#include "validation/dam_break/riemann_problem.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"

namespace seiche::validation {

exact::Riemann riemann_solution(const Values& values) {
  return {values.real("gravity"),
          {values.real("left_depth"), values.real("left_velocity")},
          {values.real("right_depth"), values.real("right_velocity")},
          values.real("jump")};
}

FlowProblem riemann_channel(const Values& values) {
  const double start = values.real("start");
  const double end = values.real("end");
  const double jump = values.real("jump");
  if (!(start < end))
    throw std::invalid_argument(fmt::format("end = {:g} is out of range: must exceed start = {:g}", end, start));
  if (!(jump > start && jump < end)) {
    throw std::invalid_argument(fmt::format("jump = {:g} is out of range: must be in ({:g}, {:g})", jump, start, end));
  }
  const auto end_kind = [&](const char* side) {
    return values.real(std::string(side) + "_depth") == 0 ? FlowProblem::End::dry : FlowProblem::End::stream;
  };
  const exact::Riemann solution = riemann_solution(values);
  return problem_of(solution, solution.gravity(), start, end, {jump}, end_kind("left"), end_kind("right"));
}

void require_before_ends(const exact::Riemann& solution, const FlowProblem& problem, double time, bool moving_ends) {
  Smallest meetings;
  const double left_end = moving_ends ? solution.left().velocity : 0;
  const double right_end = moving_ends ? solution.right().velocity : 0;
  if (solution.left().depth > 0 && solution.left_wave().slowest < left_end) {
    meetings.add((solution.jump() - problem.start) / (left_end - solution.left_wave().slowest));
  }
  if (solution.right().depth > 0 && solution.right_wave().fastest > right_end) {
    meetings.add((problem.end - solution.jump()) / (solution.right_wave().fastest - right_end));
  }
  if (time > meetings.value()) {
    throw std::invalid_argument(fmt::format(
        "time = {:g} is out of range: must be at most {:g}, when a wave meets an end", time, meetings.value()));
  }
}

}  // namespace seiche::validation
