/// Which splines of a lattice are unknowns at a step, and how the others follow from them at cut cells.
///
/// A function is
///
///     fixed    zero on the walls, which meet: they are one
///     inner    its support holds a cell with at least f times the mass of a full one: an unknown
///     outer    it touches a particle, but only of cut cells: its coefficient continues the polynomial of the nearest
///              q + 1 inner or fixed functions of its column or row, or else of the nearest complete block of (q +
///              1)^2, q = degree, else 2
///     spare    as outer without a block near it, next to a wall: an unknown, or thin layers would fall through
///     free     as spare, but away from walls: particles of its cells fly freely in this step, as do markers of cells
///              around which there is no mass
///
/// Conditioning then does not depend on how the surface cuts the cells, and every polynomial of degree 2 stays in the
/// space.
///
/// Reference: Hoellig, Reif & Wipper, Weighted extended B-spline approximation of Dirichlet problems, SIAM J. Numer.
/// Anal. 39 (2001) 442.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "seiche/models/gauss_particles/occupied_cells.hpp"

namespace seiche::gauss_particles {

class ActiveFunctions {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Term {
    std::size_t unknown;
    double weight;
  };

  /// @param full_mass  of a full cell [kg/m]. @param fraction  f, of it
  /// Throws mechanics::Infeasible for a lattice between two walls that do not meet: the stream function of the second
  /// would be a constant that is not known.
  void choose(const Lattice& lattice, const OccupiedCells& cells, double full_mass, double fraction);

  [[nodiscard]] std::size_t unknowns() const { return places_.size(); }
  [[nodiscard]] std::size_t inner_cells() const { return inner_cells_; }
  /// The function at (i, j) of the lattice, counted along y first; i is wrapped.
  [[nodiscard]] std::size_t index(long i, long j) const {
    return static_cast<std::size_t>((i >= columns_ ? i - columns_ : i) * rows_ + j);
  }
  [[nodiscard]] std::size_t functions() const { return state_.size(); }
  /// Column and row of an unknown's function.
  struct Place {
    long i;
    long j;
  };
  [[nodiscard]] Place place(std::size_t unknown) const { return places_[unknown]; }
  /// The unknown that a function is itself, or none.
  [[nodiscard]] std::size_t unknown(std::size_t function) const { return unknown_[function]; }
  /// What a function consists of: itself, nothing if it is zero, or a continuation.
  [[nodiscard]] std::span<const Term> terms(std::size_t function) const {
    return {terms_.data() + begin_[function], begin_[function + 1] - begin_[function]};
  }
  /// Whether all functions of the occupied cell are unknowns or zero.
  [[nodiscard]] bool plain(std::size_t cell) const { return plain_[cell] != 0; }
  /// Whether the particles of the occupied cell fly freely.
  [[nodiscard]] bool free(std::size_t cell) const { return free_[cell] != 0; }
  /// c = E z: coefficients of all functions from the unknowns.
  void extend(std::span<const double> z, std::span<double> c) const;
  /// r = E^T b.
  void restrict(std::span<const double> b, std::span<double> r) const;

 private:
  enum class State : std::uint8_t { untouched, zero, inner, outer, continued, lost };
  /// Functions i ... i + columns - 1, j ... j + rows - 1.
  struct Block {
    long i, j, columns, rows;
  };

  void fix_walls(const Lattice& lattice);
  void find_stray(const Lattice& lattice, const OccupiedCells& cells);
  void mark(const OccupiedCells& cells, double least_mass);
  void find_blocks();
  void free_cells(const Lattice& lattice, const OccupiedCells& cells);
  void number();
  void write_terms(const Lattice& lattice);
  [[nodiscard]] bool known(long i, long j) const;
  [[nodiscard]] bool complete(const Block& block) const;
  bool nearest_run(long i, long j, long side, Block& block) const;
  bool nearest_block(long i, long j, long side, Block& block) const;
  template <class Visit>
  void visit(const OccupiedCells::Cell& cell, Visit&& visit_function) const;

  long degree_ = 0;
  long columns_ = 0;
  long rows_ = 0;
  bool periodic_ = false;
  std::size_t inner_cells_ = 0;
  std::vector<State> state_;
  std::vector<std::size_t> unknown_;
  std::vector<Place> places_;
  std::vector<std::size_t> begin_;
  std::vector<Term> terms_;
  std::vector<std::uint8_t> plain_, free_;  // of occupied cells
  std::vector<std::uint8_t> near_mass_;     // of all cells: whether they or a neighbour hold mass

  struct Continuation {
    std::size_t function;
    long i, j;
    Block block;
  };
  std::vector<Continuation> continuations_;  // in the order of their functions
};

}  // namespace seiche::gauss_particles
