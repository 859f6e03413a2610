/// A lattice of columns x rows cells shared out among processes: one block of cells each, by PETSc's DMDA.
///
/// A process computes on a patch: the cells it owns and a ring of cells around them, which belong to its neighbours.
/// From consistent positions and velocities it finds, without its neighbours' help, whatever belongs to the nodes
/// around its own cells: masses, forces, coefficients of its rows of A. Nodes on the rim of the ring lack cells; theirs
/// come from their owners.
///
///     o---o---o---o---o     node (i, j) belongs to the owner of cell (i, j), those of the last column and row of the
///     | r | r | r | r |     lattice to the owner of the last cells
///     o---+---+---+---o
///     | r | own   | r |     o: nodes of the rim      r: cells of the ring
///     o---o---o---o---o
///
/// Arrays of a patch hold their numbers one after the other, each row by row: number c of node k at c nodes + k.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "distributed/petsc.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::distributed {

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t size() const { return end - begin; }
  [[nodiscard]] bool contains(std::size_t k) const { return begin <= k && k < end; }
};

/// What one process holds of the lattice; all numbers count from the lattice's first cell or node.
struct Patch {
  plan_lattice::Shape lattice;      ///< the whole
  Range owned_columns, owned_rows;  ///< of cells
  Range columns, rows;              ///< of cells, with the ring
  Range node_columns, node_rows;    ///< of owned nodes

  [[nodiscard]] plan_lattice::Shape shape() const { return {columns.size(), rows.size()}; }
  /// The lattice's sides where the patch reaches them, free ones elsewhere.
  [[nodiscard]] plan_lattice::Sides sides(const plan_lattice::Sides& of_lattice) const;
  /// Counted from the patch's first.
  [[nodiscard]] bool owns_cell(std::size_t i, std::size_t j) const {
    return owned_columns.contains(columns.begin + i) && owned_rows.contains(rows.begin + j);
  }
  [[nodiscard]] bool owns_node(std::size_t i, std::size_t j) const {
    return node_columns.contains(columns.begin + i) && node_rows.contains(rows.begin + j);
  }
};

class Decomposition {
 public:
  /// @param node_numbers  how many numbers a node has: 3 velocities, or 3 at each level
  /// @param cell_numbers  likewise for cells: 1, or the layers
  ///
  /// The option -seiche_da_processors_x (_y) sets the numbers of blocks. Throws std::invalid_argument when a block
  /// would be narrower than two cells, PetscFailure.
  Decomposition(plan_lattice::Shape lattice, std::size_t node_numbers, std::size_t cell_numbers);

  [[nodiscard]] const Patch& patch() const { return patch_; }
  [[nodiscard]] DM cells() const { return cells_; }

  /// Nodes that others own get their owners' numbers.
  void exchange_nodes(std::span<double> values);
  /// The same for cells of the ring.
  void exchange_cells(std::span<double> values);
  /// Largest difference between this process's numbers at nodes that others own and theirs: 0 after an exchange.
  double largest_rim_difference(std::span<const double> values);

  /// Owned cells of a patch's array into a distributed vector, and back with the ring.
  void put_cells(std::span<const double> values, Vec distributed) const;
  void get_cells(Vec distributed, std::span<double> values);

  /// One number per node of the whole lattice, row by row, as a PETSc vector in the lattice's order.
  [[nodiscard]] DistributedVector in_order(std::span<const double> number);
  /// The same on the process of rank 0; empty on others.
  [[nodiscard]] std::vector<double> gathered(std::span<const double> number);

  // Over all processes.
  [[nodiscard]] static double sum(double value);
  [[nodiscard]] static double least(double value);
  [[nodiscard]] static double largest(double value);

 private:
  /// Indices of one item in the patch's arrays and in one of PETSc's.
  struct Place {
    std::size_t patch;
    std::size_t petsc;
  };
  void send_nodes(std::span<const double> values);
  /// `numbers` of each item between a patch's array, where equal ones of all items lie together, and one of PETSc's.
  static void put(std::span<const Place> places, std::size_t numbers, std::span<const double> values, Vec to);
  static void get(std::span<const Place> places, std::size_t numbers, Vec from, std::span<double> values);

  std::size_t node_numbers_;
  std::size_t cell_numbers_;
  Patch patch_;
  Grid cells_, nodes_, single_;  // single_: nodes with one number each
  DistributedVector cells_own_, cells_ring_, nodes_own_, nodes_ring_, single_own_;
  std::vector<Place> owned_cells_, all_cells_, owned_nodes_, rim_nodes_;
};

}  // namespace seiche::distributed
