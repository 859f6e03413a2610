#include "validation/instruments/polyline_distance.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

struct Segment {
  double x, y;    ///< where it begins
  double dx, dy;  ///< to its end
};

std::vector<Segment> segments_of(const Polylines& curve) {
  std::vector<Segment> segments;
  for (const Polyline& piece : curve) {
    for (std::size_t i = 0; i + 1 < piece.x.size(); ++i) {
      segments.push_back({piece.x[i], piece.y[i], piece.x[i + 1] - piece.x[i], piece.y[i + 1] - piece.y[i]});
    }
  }
  if (segments.empty()) throw std::invalid_argument("polyline_distance: a curve needs at least two points");
  return segments;
}

double square_distance(double x, double y, const Segment& s) {
  const double length = s.dx * s.dx + s.dy * s.dy;
  const double along = length > 0 ? std::clamp(((x - s.x) * s.dx + (y - s.y) * s.dy) / length, 0.0, 1.0) : 0.0;
  const double off_x = x - s.x - along * s.dx;
  const double off_y = y - s.y - along * s.dy;
  return off_x * off_x + off_y * off_y;
}

struct OneWay {
  double mean_square = 0;
  Largest square;
};

/// From the middles of the segments of `from`, weighted with their lengths.
OneWay one_way(const std::vector<Segment>& from, const std::vector<Segment>& to, double period) {
  std::vector<double> images{0};
  if (period > 0) images = {-period, 0, period};
  OneWay result;
  double length = 0;
  for (const Segment& s : from) {
    Smallest nearest;
    for (const double image : images) {
      for (const Segment& other : to) {
        nearest.add(square_distance(s.x + 0.5 * s.dx + image, s.y + 0.5 * s.dy, other));
      }
    }
    const double weight = std::hypot(s.dx, s.dy);
    result.mean_square += weight * nearest.value();
    result.square.add(nearest.value());
    length += weight;
  }
  if (!(length > 0)) throw std::invalid_argument("polyline_distance: a curve has no length");
  result.mean_square /= length;
  return result;
}

}  // namespace

PolylineDistance polyline_distance(const Polylines& a, const Polylines& b, double period) {
  const std::vector<Segment> first = segments_of(a);
  const std::vector<Segment> second = segments_of(b);
  const OneWay there = one_way(first, second, period);
  const OneWay back = one_way(second, first, period);
  Largest square = there.square;
  square.add(back.square);
  return {.rms = std::sqrt(0.5 * (there.mean_square + back.mean_square)), .largest = std::sqrt(square.value())};
}

}  // namespace seiche::validation
