/// The twin of a flow: what it is in a mirror, turned, in other units, at another place, from a moving frame, with its
/// particles in another order. What comes out of the twin is brought back and must be what the flow gives.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/samples.hpp"

namespace seiche::verification {

struct Twin {
  double length = 1, time = 1, density = 1;  ///< what one unit of the flow is in the twin's
  bool mirrored = false;                     ///< x -> -x
  int turns = 0;                             ///< then quarter turns, anticlockwise
  Point origin{0, 0};                        ///< then added to all places, in the flow's units
  double drift = 0;                          ///< then added to all velocities along x, likewise
  bool permuted = false;

  [[nodiscard]] double speed() const { return length / time; }
  [[nodiscard]] double acceleration(double a) const { return a * (length / (time * time)); }
  [[nodiscard]] double sign() const { return mirrored ? -1 : 1; }

  [[nodiscard]] Point direction(Point d) const {
    if (mirrored) d.x = -d.x;
    for (int k = 0; k < turns; ++k) d = {-d.y, d.x};
    return d;
  }
  [[nodiscard]] Point undirected(Point d) const {
    for (int k = 0; k < turns; ++k) d = {d.y, -d.x};
    if (mirrored) d.x = -d.x;
    return d;
  }
  [[nodiscard]] Point place(Point r) const {
    const Point d = direction(r);
    return {length * (d.x + origin.x), length * (d.y + origin.y)};
  }
  [[nodiscard]] double place(double x) const { return place({x, 0}).x; }
  [[nodiscard]] Point velocity(Point v) const {
    const Point d = direction(v);
    return {speed() * (d.x + drift), speed() * d.y};
  }
  /// Of a place in the twin at a time of the flow.
  [[nodiscard]] Point place_back(Point r, double at_time = 0) const {
    return undirected({r.x / length - origin.x - drift * at_time, r.y / length - origin.y});
  }
  [[nodiscard]] Point velocity_back(Point v) const { return undirected({v.x / speed() - drift, v.y / speed()}); }
  /// A velocity at a place, seen in the twin.
  template <class Field>
  [[nodiscard]] auto field(Field of) const {
    return [*this, of](Point r) { return velocity(of(place_back(r))); };
  }

  /// The number that the k-th of n has in the flow: reversed in a mirror where they stand in a row.
  [[nodiscard]] std::size_t in_row(std::size_t k, std::size_t n) const { return mirrored ? n - 1 - k : k; }
  /// Of particles in any order.
  [[nodiscard]] std::vector<std::size_t> order(std::size_t n) const {
    std::vector<std::size_t> numbers(n);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    if (permuted) std::shuffle(numbers.begin(), numbers.end(), std::minstd_rand(5));
    return numbers;
  }
  template <class T>
  void swap_if_mirrored(T& left, T& right) const {
    if (mirrored) std::swap(left, right);
  }
};

/// Nodes of a lattice of columns x rows cells: which node of the flow stands where in the twin.
struct TwinLattice {
  std::size_t columns, rows;
  std::vector<std::size_t> node;

  TwinLattice(std::size_t columns_, std::size_t rows_, const Twin& twin) : columns(columns_), rows(rows_) {
    for (std::size_t j = 0; j <= rows; ++j) {
      for (std::size_t i = 0; i <= columns; ++i) node.push_back(j * (columns + 1) + twin.in_row(i, columns + 1));
    }
    for (int k = 0; k < twin.turns; ++k) {
      std::vector<std::size_t> turned;
      for (std::size_t i = 0; i <= columns; ++i) {
        for (std::size_t j = rows + 1; j-- > 0;) turned.push_back(node[j * (columns + 1) + i]);
      }
      node.swap(turned);
      std::swap(columns, rows);
    }
  }
};

/// A flow at its end, in its own frame and order: places, and velocities.
class Seen {
 public:
  explicit Seen(std::size_t count) : lengths_(2 * count), speeds_(2 * count) {}

  void at(std::size_t k, Point place, Point velocity) {
    lengths_[2 * k] = place.x;
    lengths_[2 * k + 1] = place.y;
    speeds_[2 * k] = velocity.x;
    speeds_[2 * k + 1] = velocity.y;
  }
  void at(std::size_t k, const Twin& twin, Point place, Point velocity, double time) {
    at(k, twin.place_back(place, time / twin.time), twin.velocity_back(velocity));
  }
  /// Largest difference of places over their extent, or of velocities over the largest one.
  [[nodiscard]] double difference(const Seen& other) const {
    return worst(std::array{relative(lengths_, other.lengths_), relative(speeds_, other.speeds_)});
  }

 private:
  [[nodiscard]] static double relative(const std::vector<double>& one, const std::vector<double>& other) {
    if (one.size() != other.size()) return std::numeric_limits<double>::infinity();
    Worst difference, scale;
    for (std::size_t k = 0; k < one.size(); ++k) {
      difference.add(one[k] - other[k]);
      scale.add(one[k]);
    }
    return difference.value() / scale.value();
  }

  std::vector<double> lengths_, speeds_;
};

}  // namespace seiche::verification
