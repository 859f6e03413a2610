/// The normal equations of the unknown splines: assembled cell by cell, scaled, factorised.
///
/// The pattern is that of a slightly larger set of splines, in which those that are no unknowns at a step are left
/// alone; its symbolic factorisation is kept while the unknowns stay within the set, also when the lattice moves by
/// whole cells or fractions of one. The matrix is scaled to a diagonal of 1 and shifted by 1e-13: fields that vanish on
/// all particles then do no harm, and two corrections with the true residual take the shift out again.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "seiche/linear/sparse_cholesky.hpp"
#include "seiche/models/gauss_particles/active_functions.hpp"

namespace seiche::gauss_particles {

class GramSystem {
 public:
  /// Clears the matrix for these unknowns.
  void begin(const Lattice& lattice, const ActiveFunctions& functions);
  /// Adds the matrix of these unknowns, or none.
  void add(std::span<const std::size_t> unknowns, const double* matrix);
  /// False when unknowns were coupled that the pattern did not have; it has them now: begin and add once more.
  [[nodiscard]] bool complete() const { return complete_; }
  /// Throws linear::NotPositiveDefinite.
  void factor();
  /// z += (matrix)^-1 r, up to the shift. Returns the largest |r| with fields of norm 1.
  double correct(std::span<const double> r, std::span<double> z);
  /// Only the measure that correct returns.
  [[nodiscard]] double scaled_largest(std::span<const double> r) const;

  [[nodiscard]] long analyses() const { return analyses_; }
  [[nodiscard]] linear::FactorWork factor_work() const { return solver_ ? solver_->work() : linear::FactorWork{}; }

 private:
  struct Place {
    long i, j;  // absolute, on lattices that grow
    friend bool operator==(const Place&, const Place&) = default;
  };
  struct Coupling {
    Place a, b;
  };

  [[nodiscard]] Place absolute(const ActiveFunctions& functions, std::size_t unknown) const;
  [[nodiscard]] int slot(Place place) const;
  [[nodiscard]] long column_difference(long from, long to) const;
  void couple(Place a, Place b);
  [[nodiscard]] bool at_edge(Place place) const;
  [[nodiscard]] Place moved(Place from, long columns, long rows) const;
  bool fit(const ActiveFunctions& functions);
  void choose_slots(const Lattice& lattice, const ActiveFunctions& functions);
  void analyse();
  [[nodiscard]] int entry(int a, int b) const;

  long degree_ = 0;
  long columns_ = 0;    // of a periodic lattice, else 0
  Place offset_{0, 0};  // absolute place of function (0, 0)

  Place corner_{0, 0};  // of the window of slots
  long window_columns_ = 0;
  long window_rows_ = 0;
  std::vector<int> slot_at_;        // in the window; -1: none
  std::vector<Place> place_;        // of the slots
  std::vector<Coupling> extra_;     // of continued cells, beyond the reach of a cell's splines
  std::vector<Place> extra_reach_;  // differences of places so coupled: what one place needs its neighbours will need
  std::vector<int> stencil_;        // entry of a slot's coupling with its neighbours; -1: none
  std::vector<int> column_begin_, row_;
  std::vector<double> values_;
  std::unique_ptr<linear::SparseCholesky> solver_;
  long analyses_ = 0;

  std::vector<int> slot_of_;  // of the unknowns
  std::vector<double> scale_, work_;
  bool complete_ = true;
};

}  // namespace seiche::gauss_particles
