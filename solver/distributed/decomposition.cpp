#include "distributed/decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <petscdmda.h>

#include "seiche/require_that.hpp"

namespace seiche::distributed {

namespace {

// Nodes owned east of a patch's own lie up to two further on: node (i + 1) of the last own cell, and of the ring.
constexpr PetscInt rim = 2;

PetscInt index(std::size_t value) {
  return static_cast<PetscInt>(value);
}

/// Part of a grid: first place and extents.
struct Block {
  PetscInt i, j, columns, rows;
  [[nodiscard]] std::size_t place(std::size_t column, std::size_t row) const {
    return (row - static_cast<std::size_t>(j)) * static_cast<std::size_t>(columns) + column -
           static_cast<std::size_t>(i);
  }
  [[nodiscard]] Range along_x() const { return {static_cast<std::size_t>(i), static_cast<std::size_t>(i + columns)}; }
  [[nodiscard]] Range along_y() const { return {static_cast<std::size_t>(j), static_cast<std::size_t>(j + rows)}; }
};

Block owned(DM grid) {
  Block block{};
  check(DMDAGetCorners(grid, &block.i, &block.j, nullptr, &block.columns, &block.rows, nullptr));
  return block;
}

Block with_ring(DM grid) {
  Block block{};
  check(DMDAGetGhostCorners(grid, &block.i, &block.j, nullptr, &block.columns, &block.rows, nullptr));
  return block;
}

Grid grid(plan_lattice::Shape shape, std::size_t numbers, PetscInt width, PetscInt across, PetscInt along,
          const PetscInt* columns, const PetscInt* rows) {
  Grid made;
  check(DMDACreate2d(PETSC_COMM_WORLD, DM_BOUNDARY_NONE, DM_BOUNDARY_NONE, DMDA_STENCIL_BOX, index(shape.columns),
                     index(shape.rows), across, along, index(numbers), width, columns, rows, made.place()));
  return made;
}

double reduced(double value, MPI_Op operation) {
  double result = value;
  if (MPI_Allreduce(&value, &result, 1, MPI_DOUBLE, operation, PETSC_COMM_WORLD) != MPI_SUCCESS) {
    throw PetscFailure("MPI_Allreduce failed");
  }
  return result;
}

}  // namespace

plan_lattice::Sides Patch::sides(const plan_lattice::Sides& of_lattice) const {
  plan_lattice::Sides result = of_lattice;
  if (columns.begin > 0) result.west = plan_lattice::FreeSide{};
  if (columns.end < lattice.columns) result.east = plan_lattice::FreeSide{};
  if (rows.begin > 0) result.south = plan_lattice::FreeSide{};
  if (rows.end < lattice.rows) result.north = plan_lattice::FreeSide{};
  return result;
}

Decomposition::Decomposition(plan_lattice::Shape lattice, std::size_t node_numbers, std::size_t cell_numbers)
    : node_numbers_(node_numbers), cell_numbers_(cell_numbers) {
  cells_ = grid(lattice, cell_numbers, 1, PETSC_DECIDE, PETSC_DECIDE, nullptr, nullptr);
  check(DMSetOptionsPrefix(cells_, "seiche_"));
  check(DMSetFromOptions(cells_));
  check(DMSetUp(cells_));

  // Nodes are shared out as cells are; the last block has one more of them.
  PetscInt blocks_x = 0;
  PetscInt blocks_y = 0;
  check(DMDAGetInfo(cells_, nullptr, nullptr, nullptr, nullptr, &blocks_x, &blocks_y, nullptr, nullptr, nullptr,
                    nullptr, nullptr, nullptr, nullptr));
  const PetscInt* columns = nullptr;
  const PetscInt* rows = nullptr;
  check(DMDAGetOwnershipRanges(cells_, &columns, &rows, nullptr));
  std::vector<PetscInt> node_columns(columns, columns + blocks_x);
  std::vector<PetscInt> node_rows(rows, rows + blocks_y);
  require_that((blocks_x == 1 || *std::min_element(node_columns.begin(), node_columns.end()) >= rim) &&
                   (blocks_y == 1 || *std::min_element(node_rows.begin(), node_rows.end()) >= rim),
               "a lattice of {} x {} cells in {} x {} blocks; allowed: blocks of at least {} x {} cells, so use "
               "fewer processes",
               lattice.columns, lattice.rows, blocks_x, blocks_y, rim, rim);
  ++node_columns.back();
  ++node_rows.back();
  const plan_lattice::Shape lattice_nodes{lattice.columns + 1, lattice.rows + 1};
  nodes_ = grid(lattice_nodes, node_numbers, rim, blocks_x, blocks_y, node_columns.data(), node_rows.data());
  check(DMSetUp(nodes_));
  check(DMDACreateCompatibleDMDA(nodes_, 1, single_.place()));

  check(DMCreateGlobalVector(cells_, cells_own_.place()));
  check(DMCreateLocalVector(cells_, cells_ring_.place()));
  check(DMCreateGlobalVector(nodes_, nodes_own_.place()));
  check(DMCreateLocalVector(nodes_, nodes_ring_.place()));
  check(DMCreateGlobalVector(single_, single_own_.place()));

  const Block own = owned(cells_);
  const Block ring = with_ring(cells_);
  const Block own_nodes = owned(nodes_);
  const Block ring_nodes = with_ring(nodes_);
  patch_ = {.lattice = lattice,
            .owned_columns = own.along_x(),
            .owned_rows = own.along_y(),
            .columns = ring.along_x(),
            .rows = ring.along_y(),
            .node_columns = own_nodes.along_x(),
            .node_rows = own_nodes.along_y()};
  const plan_lattice::Shape shape = patch_.shape();
  for (std::size_t j = 0; j < shape.rows; ++j) {
    for (std::size_t i = 0; i < shape.columns; ++i) {
      const std::size_t k = j * shape.columns + i;
      const std::size_t column = patch_.columns.begin + i;
      const std::size_t row = patch_.rows.begin + j;
      all_cells_.push_back({k, ring.place(column, row)});
      if (patch_.owns_cell(i, j)) owned_cells_.push_back({k, own.place(column, row)});
    }
  }
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    for (std::size_t i = 0; i <= shape.columns; ++i) {
      const std::size_t k = shape.node(i, j);
      const std::size_t column = patch_.columns.begin + i;
      const std::size_t row = patch_.rows.begin + j;
      if (patch_.owns_node(i, j)) {
        owned_nodes_.push_back({k, own_nodes.place(column, row)});
      } else {
        rim_nodes_.push_back({k, ring_nodes.place(column, row)});
      }
    }
  }
}

void Decomposition::put(std::span<const Place> places, std::size_t numbers, std::span<const double> values, Vec to) {
  const std::size_t stride = values.size() / numbers;
  double* own = nullptr;
  check(VecGetArray(to, &own));
  for (const Place& place : places) {
    for (std::size_t c = 0; c < numbers; ++c) own[place.petsc * numbers + c] = values[c * stride + place.patch];
  }
  check(VecRestoreArray(to, &own));
}

void Decomposition::get(std::span<const Place> places, std::size_t numbers, Vec from, std::span<double> values) {
  const std::size_t stride = values.size() / numbers;
  const double* ring = nullptr;
  check(VecGetArrayRead(from, &ring));
  for (const Place& place : places) {
    for (std::size_t c = 0; c < numbers; ++c) values[c * stride + place.patch] = ring[place.petsc * numbers + c];
  }
  check(VecRestoreArrayRead(from, &ring));
}

void Decomposition::send_nodes(std::span<const double> values) {
  put(owned_nodes_, node_numbers_, values, nodes_own_);
  check(DMGlobalToLocalBegin(nodes_, nodes_own_, INSERT_VALUES, nodes_ring_));
  check(DMGlobalToLocalEnd(nodes_, nodes_own_, INSERT_VALUES, nodes_ring_));
}

void Decomposition::exchange_nodes(std::span<double> values) {
  if (ranks() == 1) return;
  send_nodes(values);
  get(rim_nodes_, node_numbers_, nodes_ring_, values);
}

double Decomposition::largest_rim_difference(std::span<const double> values) {
  send_nodes(values);
  std::vector<double> owners(values.begin(), values.end());
  get(rim_nodes_, node_numbers_, nodes_ring_, owners);
  double difference = 0;
  for (std::size_t k = 0; k < values.size(); ++k) difference = std::max(difference, std::abs(values[k] - owners[k]));
  return largest(difference);
}

void Decomposition::put_cells(std::span<const double> values, Vec distributed) const {
  put(owned_cells_, cell_numbers_, values, distributed);
}

void Decomposition::get_cells(Vec distributed, std::span<double> values) {
  check(DMGlobalToLocalBegin(cells_, distributed, INSERT_VALUES, cells_ring_));
  check(DMGlobalToLocalEnd(cells_, distributed, INSERT_VALUES, cells_ring_));
  get(all_cells_, cell_numbers_, cells_ring_, values);
}

void Decomposition::exchange_cells(std::span<double> values) {
  if (ranks() == 1) return;
  put_cells(values, cells_own_);
  get_cells(cells_own_, values);
}

DistributedVector Decomposition::in_order(std::span<const double> number) {
  put(owned_nodes_, 1, number, single_own_);
  DistributedVector ordered;
  check(DMDACreateNaturalVector(single_, ordered.place()));
  check(DMDAGlobalToNaturalBegin(single_, single_own_, INSERT_VALUES, ordered));
  check(DMDAGlobalToNaturalEnd(single_, single_own_, INSERT_VALUES, ordered));
  return ordered;
}

std::vector<double> Decomposition::gathered(std::span<const double> number) {
  const DistributedVector ordered = in_order(number);
  Scatter scatter;
  DistributedVector all;
  check(VecScatterCreateToZero(ordered, scatter.place(), all.place()));
  check(VecScatterBegin(scatter, ordered, all, INSERT_VALUES, SCATTER_FORWARD));
  check(VecScatterEnd(scatter, ordered, all, INSERT_VALUES, SCATTER_FORWARD));
  PetscInt size = 0;
  check(VecGetLocalSize(all, &size));
  const double* values = nullptr;
  check(VecGetArrayRead(all, &values));
  std::vector<double> result(values, values + size);
  check(VecRestoreArrayRead(all, &values));
  return result;
}

double Decomposition::sum(double value) {
  return reduced(value, MPI_SUM);
}

double Decomposition::least(double value) {
  return reduced(value, MPI_MIN);
}

double Decomposition::largest(double value) {
  return reduced(value, MPI_MAX);
}

}  // namespace seiche::distributed
