#include "validation/instruments/straight_line.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {

StraightLine straight_line(std::span<const double> u, std::span<const double> v) {
  if (u.size() != v.size() || u.size() < 2) {
    throw std::invalid_argument(fmt::format(
        "a line through {} abscissae and {} ordinates: at least two of each are needed", u.size(), v.size()));
  }
  const auto count = static_cast<double>(u.size());
  StraightLine line;
  line.points = u.size();
  line.mean_u = std::accumulate(u.begin(), u.end(), 0.0) / count;
  line.mean_v = std::accumulate(v.begin(), v.end(), 0.0) / count;
  double spread = 0;
  double moment = 0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    spread += (u[k] - line.mean_u) * (u[k] - line.mean_u);
    moment += (u[k] - line.mean_u) * (v[k] - line.mean_v);
  }
  if (!(spread > 0)) throw std::invalid_argument(fmt::format("a line through {} points of one abscissa", u.size()));
  line.slope = moment / spread;
  if (u.size() == 2) return line;
  double squares = 0;
  for (std::size_t k = 0; k < u.size(); ++k) squares += (v[k] - line.at(u[k])) * (v[k] - line.at(u[k]));
  const double variance = squares / (count - 2);
  line.mean_error = std::sqrt(variance / count);
  line.slope_error = std::sqrt(variance / spread);
  return line;
}

StraightLine straight_line_of_curve(std::span<const double> u, std::span<const double> v) {
  StraightLine line = straight_line(u, v);
  const std::size_t half = u.size() / 2;
  const StraightLine near = straight_line(u.first(half), v.first(half));
  const StraightLine far = straight_line(u.subspan(half), v.subspan(half));
  line.slope_error = std::hypot(line.slope_error, 0.5 * (far.slope - near.slope));
  return line;
}

evidence::Measurement StraightLine::where(double v) const {
  const double u = mean_u + (v - mean_v) / slope;
  return {.value = u,
          .uncertainty = 2 * std::hypot(mean_error, (u - mean_u) * slope_error) / std::abs(slope),
          .resolution = {}};
}

evidence::Measurement StraightLine::angle() const {
  return {.value = std::atan(std::abs(slope)), .uncertainty = 2 * slope_error / (1 + slope * slope), .resolution = {}};
}

}  // namespace seiche::validation
