/// Velocity fields whose stream function is a spline on a lattice, continued across cut cells.
///
/// Holds every linear solenoidal field, to round-off, over level ground away from walls; in a channel with a level
/// bottom the uniform horizontal one. Fields are of class C^(degree - 1), the projection's error is O(h^degree) for any
/// set of particles.
///
/// Results do not depend on the number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/models/gauss_particles/cell_kernels.hpp"
#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/gram_system.hpp"
#include "seiche/models/gauss_particles/lattice.hpp"
#include "seiche/ranges.hpp"

namespace seiche::gauss_particles {

/// The penalty on gradients of vorticity that holds down the quadrature instability under gravity.
///
/// Sums over particles are no exact integrals: gravity does work on eddies of the lattice's size as if they had a small
/// negative potential energy, and they grow although the total energy is exact. The penalty adds, in the norm that the
/// projection minimises,
///
/// @f[ \frac{\tau}{2} \nu_4 \sum_c \min(1, M_c/(\rho h^2)) \, \rho \int_c |\nabla \Delta \Phi|^2, \qquad
///     \nu_4 = C h^{7/2} g^{1/2} @f]
///
/// over the occupied cells c. It vanishes for irrotational and for linear velocity fields, so that momenta stay exact;
/// the energy it takes is tau nu_4 times the form, known to round-off. Over uneven ground it is taken in (x, eta).
class VorticityPenalty {
 public:
  /// Computes again what depends on the cells, when they changed.
  void prepare(const Lattice& lattice);
  /// The integral of grad lap Phi_a . grad lap Phi_b over a full cell, (p + 1)^2 by (p + 1)^2.
  [[nodiscard]] std::span<const double> matrix(std::size_t kind_x, std::size_t kind_y);

 private:
  int degree_ = 0;
  double cell_x_ = 0;
  double cell_y_ = 0;
  std::vector<std::vector<double>> matrices_;  // of pairs of kinds; empty until asked for
};

class SplineSpace final : public FieldSpace {
 public:
  struct Settings {
    double density = 1;  ///< [kg/m^3]
    /// f: mass of an inner cell, of a full one; 0.25 to 0.3 for thin tongues, 0.9 with gravity on the surface
    double inner_fraction = 0.5;

    static constexpr auto ranges() {
      return std::array{Number{"density", &Settings::density, Range::positive()},
                        Number{"inner_fraction", &Settings::inner_fraction, Range::within(0.05, 1)}};
    }
  };

  /// Throws std::invalid_argument: what LatticePlan::check says, density not positive, fraction not in [0.05, 1].
  explicit SplineSpace(const LatticePlan& plan) : SplineSpace(plan, Settings()) {}
  SplineSpace(const LatticePlan& plan, Settings settings);
  /// @param at  any lattices, all of them over the ground
  SplineSpace(Ground ground, LatticeAt at, Settings settings);

  void place(mechanics::Interval when, std::span<const double> x, std::span<const double> y,
             std::span<const double> mass, double penalty) override;
  using FieldSpace::project;
  void project(std::span<double> u, std::span<double> v, std::span<const double> impulse_x,
               std::span<const double> impulse_y) override;
  [[nodiscard]] std::span<const std::uint8_t> free() const override { return free_; }
  [[nodiscard]] const SpaceFacts& facts() const override { return facts_; }
  [[nodiscard]] double resolution() const override;

  /// Of the last step.
  [[nodiscard]] const Lattice& lattice() const { return lattice_.front(); }
  [[nodiscard]] const ActiveFunctions& functions() const { return functions_; }
  /// Symbolic factorisations so far.
  [[nodiscard]] long analyses() const { return system_.analyses(); }
  /// Of the normal equations' factor.
  [[nodiscard]] linear::FactorWork factor_work() const { return system_.factor_work(); }

 private:
  void require_enough(std::span<const double> mass) const;
  void assemble();
  void add_cell(std::size_t c, const double* matrix);
  void add_continued_cell(std::size_t c, const double* matrix);
  [[nodiscard]] CellParticles particles(std::size_t c) const;
  [[nodiscard]] CellSplines splines(std::size_t c) const;
  void local_functions(std::size_t c, std::size_t* functions) const;
  double penalty_weight(std::size_t c) const;
  [[nodiscard]] std::span<const double> penalty_matrix(std::size_t c);
  /// use(function, its row of the cell's penalty times the coefficients) for the cell's functions.
  template <class Use>
  void penalty_load(std::size_t c, std::span<const std::size_t> functions, const Use& use);
  void take_impulses(std::span<const double> impulse_x, std::span<const double> impulse_y);
  /// Loads of w - field - penalty, restricted to the unknowns.
  void residual(std::span<double> r);
  void evaluate();
  [[nodiscard]] double penalty_form();
  template <class Work>
  void for_cells(Work&& work) const;
  template <class Work>
  void visit_cells(const Work& work) const;

  Ground ground_;
  LatticeAt at_;
  Settings settings_;
  std::vector<Lattice> lattice_;  // one, or none yet
  OccupiedCells cells_;
  ActiveFunctions functions_;
  GramSystem system_;
  VorticityPenalty penalty_;
  const CellKernels* kernels_ = nullptr;
  double penalty_factor_ = 0;
  double full_mass_ = 0;
  std::size_t local_ = 0;  // functions of a cell
  std::size_t particles_ = 0;
  SpaceFacts facts_;
  std::vector<std::uint8_t> free_;  // of particles; empty: none

  std::vector<double> matrices_;        // of a chunk of cells
  std::vector<double> half_, reduced_;  // of one continued cell
  std::vector<std::size_t> involved_;
  std::vector<std::size_t> column_of_;                      // of unknowns, in a continued cell
  std::vector<double> wx_, wy_, ux_, uy_, dx_, dy_, ones_;  // by places of the cells
  std::vector<double> loads_;                               // of all cells
  std::vector<double> function_load_, impulse_load_, coefficients_;
  std::vector<double> z_, r_;
};

}  // namespace seiche::gauss_particles
