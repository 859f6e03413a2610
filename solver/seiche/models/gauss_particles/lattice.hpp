/// The background lattice on which stream functions are splines, and how it follows the water.
///
/// Heights are counted from the bottom where there is one: the stream function is Phi(x, eta), eta = y - b(x), and the
/// velocity (Phi_eta, -Phi_x + b' Phi_eta), solenoidal and along the bottom at eta = 0. Every conservation law of the
/// method holds step by step: the lattice may be another one at every step, moved, shifted at random, refined, grown.
///
/// When not to use it: bottoms with corners, at which the velocities would jump. Over an uneven bottom linear velocity
/// fields are not in the space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::gauss_particles {

// B-splines of degree 2, 3 or 4 along one direction of a lattice of equal cells.
//
// Places are in units of a cell, counted from the first line of the lattice: cell c is [c, c + 1], on it the functions
// c ... c + degree are not zero. Knots are uniform; at a wall they are clamped, so that the first function alone is
// not zero there. On a periodic axis indices are taken modulo the number of cells.
//
// Functions are taken 2^p p! times, p the degree: their coefficients are then whole numbers on uniform knots, and sums
// that must be linear are so without the rounding of thirds and sixths, which a long run would gather.
//
// Function i that is to continue the spline beyond the functions i0 ... i0 + q gets the weights with which every
// polynomial of degree q continues itself: the blossom of the polynomial piece at the knots of function i (de Boor's
// algorithm), by Marsden's identity.
//
// References: de Boor, A Practical Guide to Splines (1978), IX-X; Hoellig, Reif & Wipper, Weighted extended B-spline
// approximation of Dirichlet problems, SIAM J. Numer. Anal. 39 (2001) 442.

inline constexpr int lowest_degree = 2;
inline constexpr int highest_degree = 4;

/// What is at the two ends of an axis.
enum class Ends { free, wall_below, wall_above, walls, periodic };

/// Polynomials of the functions of one cell, in z = place - c - 1/2, as packed coefficients of ascending powers.
struct CellPolynomials {
  static constexpr std::size_t most = highest_degree + 1;
  /// [function][power], degree + 1 powers.
  std::array<double, most* most> function = {};
  /// Products of two functions i <= k and of their derivatives, [pair][power], 2 degree + 1 powers.
  std::array<double, most*(most + 1) / 2 * (2 * most - 1)> product = {};
  std::array<double, most*(most + 1) / 2 * (2 * most - 1)> derivative_product = {};
  /// Derivative of i times k, [i (degree + 1) + k][power], 2 degree + 1 powers.
  std::array<double, most * most*(2 * most - 1)> mixed_product = {};
};

class SplineAxis {
 public:
  /// @param begin  place of the first line [m]. @param cell  width [m]. @param first  index of the first cell among
  /// those of lattices that grow and shrink with the water
  /// Throws std::invalid_argument: degree not 2, 3, 4; cell not positive; fewer cells than 1 (periodic: 2 degree + 1).
  SplineAxis(int degree, double begin, double cell, long cells, Ends ends, long first = 0);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double cell() const { return cell_; }
  [[nodiscard]] long cells() const { return cells_; }
  [[nodiscard]] long first() const { return first_; }
  [[nodiscard]] bool periodic() const { return ends_ == Ends::periodic; }
  [[nodiscard]] bool wall_below() const { return ends_ == Ends::wall_below || ends_ == Ends::walls; }
  [[nodiscard]] bool wall_above() const { return ends_ == Ends::wall_above || ends_ == Ends::walls; }
  [[nodiscard]] long functions() const { return periodic() ? cells_ : cells_ + degree_; }
  [[nodiscard]] double end() const { return begin_ + cell_ * static_cast<double>(cells_); }
  /// The function whose index, on a periodic axis, may lie outside 0 ... functions - 1.
  [[nodiscard]] long wrapped(long function) const {
    return periodic() ? (function % cells_ + cells_) % cells_ : function;
  }
  /// Cells of one kind have the same polynomials.
  [[nodiscard]] std::size_t kind(long cell) const;
  [[nodiscard]] std::size_t kinds() const {
    return static_cast<std::size_t>(degree_) * static_cast<std::size_t>(degree_);
  }

  /// Weights of the functions i0 ... i0 + q, q = weights.size() - 1 <= degree, in function i.
  void extend(long i, long i0, std::span<double> weights) const;

  /// Line of the lattice at which knot k lies; function i spans knots i ... i + degree + 1.
  [[nodiscard]] double knot(long k) const;

 private:
  [[nodiscard]] bool uniform(long from, long to) const;

  int degree_;
  double begin_;
  double cell_;
  long cells_;
  Ends ends_;
  long first_;
};

/// The polynomials of all axes of a degree, by the kind of the cell.
std::span<const CellPolynomials> cell_polynomials(int degree);

/// b(x) with a continuous slope, or level.
struct Ground {
  double level = 0;                                        ///< b of a level bottom; 0 where there is none [m]
  std::shared_ptr<const BottomProfile> profile = nullptr;  ///< uneven bottom, instead of the level
};

struct Lattice {
  SplineAxis x;
  SplineAxis y;  ///< along eta
};

/// The rectangle of the particles; heights above the ground.
struct Bounds {
  double left = 0;
  double right = 0;
  double low = 0;
  double high = 0;
};

/// The lattice of a step: that which begins at when.begin and in whose middle the water is within the bounds.
using LatticeAt = std::function<Lattice(mechanics::Interval when, const Bounds& water)>;

/// Empty cells between the water and a free end of a lattice, at least.
inline constexpr long free_margin = 2;

/// A lattice of given cells between walls and around the water where there is none.
struct LatticePlan {
  int degree = 3;
  double cell_x = 0.1;  ///< [m]
  double cell_y = 0;    ///< [m]; 0: as cell_x
  std::optional<double> left_wall = {};
  std::optional<double> right_wall = {};
  /// [m]; of the periodic channel that begins at left_wall, or at 0. Instead of walls.
  double period = 0;
  bool bottom = false;  ///< a wall at eta = 0
  Ground ground = {};
  bool shift =
      false;  ///< moves the lattice along directions without walls, by another random part of a cell at each step
  std::uint64_t seed = 1;

  /// Throws std::invalid_argument with name, value and range: cells not positive, walls or a period that are not a
  /// whole number of cells apart, walls in a periodic channel, a bottom with a corner.
  void check() const;
  /// The lattice for water within the bounds. The shift depends on the middle of the interval and the seed alone.
  [[nodiscard]] Lattice operator()(mechanics::Interval when, const Bounds& water) const;
};

/// Throws std::invalid_argument, with the place, where the slope of a profile jumps within [begin, end].
void require_continuous_slope(const BottomProfile& profile, double begin, double end);

}  // namespace seiche::gauss_particles
