#include "validation/steady_flow/settled_flow.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"

namespace seiche::validation {

std::vector<long> numbers_of_particles(long coarsest) {
  std::vector<long> numbers;
  for (int k = 0; k < numbers_of_resolutions; ++k) {
    numbers.push_back(std::lround(static_cast<double>(coarsest) * std::pow(2.0, 0.5 * k)));
  }
  return numbers;
}

Profile part_of(const Profile& whole, double from, double to) {
  Profile part;
  for (std::size_t i = 0; i < whole.means.size(); ++i) {
    if (whole.edges[i] < from || whole.edges[i + 1] > to) continue;
    if (part.edges.empty()) part.edges.push_back(whole.edges[i]);
    part.edges.push_back(whole.edges[i + 1]);
    part.means.push_back(whole.means[i]);
  }
  if (part.means.empty()) {
    throw std::runtime_error(fmt::format(
        "no particle lies wholly between x = {:g} and {:g} at some time: the flow there is not resolved", from, to));
  }
  return part;
}

double mean_discharge_error(const Profile& profile, double discharge) {
  Mean error;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    const State& s = profile.means[i];
    error.add(std::abs(s.depth * s.velocity / discharge - 1), profile.edges[i + 1] - profile.edges[i]);
  }
  return error.value();
}

}  // namespace seiche::validation
