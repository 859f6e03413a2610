#include "validation/studies/shallow_water/profile_points.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"

namespace seiche::validation {

Profile ProfilePoints::cells() const {
  Profile cells;
  cells.edges.push_back(x.front());
  for (std::size_t i = 0; i < x.size(); ++i) {
    cells.edges.push_back(i + 1 < x.size() ? 0.5 * (x[i] + x[i + 1]) : x.back());
    cells.means.push_back({depth[i], velocity[i]});
  }
  return cells;
}

WantedTable wanted_profile(double start, double end, long cells, const std::function<State(double)>& exact,
                           const std::string& command) {
  std::vector<double> centres;
  for (long i = 0; i < cells; ++i)
    centres.push_back(start + (end - start) * (static_cast<double>(i) + 0.5) / static_cast<double>(cells));
  const auto velocity = [exact](Place p) {  // dry bed has none
    const State state = exact(p.abscissa);
    return state.depth > 0 ? state.velocity : nan;
  };
  return {
      .name = "profile",
      .kind = WantedTable::Kind::profile,
      .abscissa = Column{"x", "m", "position, increasing"},
      .quantities = {{.column = {"h", "m", "depth"}, .reference = [exact](Place p) { return exact(p.abscissa).depth; }},
                     {.column = {"u", "m/s", "velocity"}, .reference = velocity}},
      .points = [centres](double) { return centres; },
      .exact = {command}};
}

ProfilePoints points_of(const Profile& profile) {
  return {means_of(profile)};
}

Submitted submitted_profile(const Profile& profile) {
  const ProfilePoints points = points_of(profile);
  return {{"profile", {{.value = 0, .abscissa = points.x, .values = {{"h", points.depth}, {"u", points.velocity}}}}}};
}

ProfilePoints submitted_points(const Submitted& submitted, double start, double end, double cell) {
  const SubmittedGroup& group = submitted.at("profile").front();
  const std::vector<double>& x = group.abscissa;
  if (x.front() < start || x.back() > end) {
    throw std::invalid_argument(
        fmt::format("column x: values in [{:g}, {:g}], must be in [{:g}, {:g}]", x.front(), x.back(), start, end));
  }
  Largest apart;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) apart.add(x[i + 1] - x[i]);
  constexpr double rounding = 1e-9;
  if (!(apart.value() <= (2 + rounding) * cell)) {
    throw std::invalid_argument(
        fmt::format("column x: points up to {:.3g} m apart, must be at most two cells of {:.3g} m: submit more points, "
                    "or state the cell size by --dx",
                    apart.value(), cell));
  }
  const auto column = [&](const char* name) {
    const auto found = group.values.find(name);
    return found == group.values.end() ? std::vector<double>(x.size(), nan) : found->second;
  };
  return {x, column("h"), column("u")};
}

double judged_cell(const Submitted& submitted, double length, long cells, const SolverFacts& facts) {
  const std::vector<double>& x = submitted.at("profile").front().abscissa;
  const double apart = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  const double cell = facts.cell.value_or(std::min(apart, length / static_cast<double>(cells)));
  if (cell > length / 4) {
    throw std::invalid_argument(
        fmt::format("--dx {:g} is out of range: must be at most {:g}, a quarter of the channel", cell, length / 4));
  }
  return cell;
}

std::string resolution_of(const ProfilePoints& points, double cell, const SolverFacts& facts) {
  return fmt::format("cells of {:.4g} m{}, {} points", cell, facts.cell ? "" : " (--dx overrides)", points.x.size());
}

MeanErrors mean_errors(const ProfilePoints& points, const std::function<State(double)>& exact, int samples) {
  const auto& [x, h, u] = points;
  MeanErrors errors;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double width = (x[i + 1] - x[i]) / samples;
    for (int k = 0; k < samples; ++k) {
      const double share = (k + 0.5) / samples;
      const State there = exact(std::lerp(x[i], x[i + 1], share));
      errors.depth += width * std::abs(std::lerp(h[i], h[i + 1], share) - there.depth);
      errors.discharge +=
          width * std::abs(std::lerp(h[i] * u[i], h[i + 1] * u[i + 1], share) - there.depth * there.velocity);
      if (there.depth > 0) errors.velocity += width * std::abs(std::lerp(u[i], u[i + 1], share) - there.velocity);
    }
  }
  const double covered = x.back() - x.front();
  for (double* mean : {&errors.depth, &errors.velocity, &errors.discharge}) *mean /= covered;
  return errors;
}

}  // namespace seiche::validation
