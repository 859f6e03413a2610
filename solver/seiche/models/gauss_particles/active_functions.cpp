#include "seiche/models/gauss_particles/active_functions.hpp"

#include <algorithm>
#include <array>

namespace seiche::gauss_particles {

namespace {

constexpr long search_radius = 6;  // cells, from a function to the block that continues it

/// From a function to the first function of a block of so many a side, nearest middles first.
std::vector<std::array<long, 2>> block_offsets(long side) {
  std::vector<std::array<long, 2>> offsets;
  const long reach = search_radius + side - 1;
  for (long i = -reach; i <= search_radius; ++i) {
    for (long j = -reach; j <= search_radius; ++j) offsets.push_back({i, j});
  }
  const auto distance = [=](const std::array<long, 2>& offset) {
    const auto [i, j] = offset;
    const long x = 2 * i + side - 1;
    const long y = 2 * j + side - 1;
    return x * x + y * y;
  };
  std::stable_sort(offsets.begin(), offsets.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return offsets;
}

const std::vector<std::array<long, 2>>& offsets_of(long side) {
  static const std::array<std::vector<std::array<long, 2>>, 3> all{block_offsets(3), block_offsets(4),
                                                                   block_offsets(5)};
  return all[static_cast<std::size_t>(side - 3)];
}

}  // namespace

template <class Visit>
void ActiveFunctions::visit(const OccupiedCells::Cell& cell, Visit&& visit_function) const {
  for (long i = cell.x; i <= cell.x + degree_; ++i) {
    for (long j = cell.y; j <= cell.y + degree_; ++j) visit_function(index(i, j));
  }
}

void ActiveFunctions::choose(const Lattice& lattice, const OccupiedCells& cells, double full_mass, double fraction) {
  degree_ = lattice.x.degree();
  columns_ = lattice.x.functions();
  rows_ = lattice.y.functions();
  periodic_ = lattice.x.periodic();
  state_.assign(static_cast<std::size_t>(columns_ * rows_), State::untouched);
  fix_walls(lattice);
  find_stray(lattice, cells);
  mark(cells, fraction * full_mass);
  find_blocks();
  free_cells(lattice, cells);
  number();
  write_terms(lattice);
  plain_.assign(cells.cells().size(), 1);
  for (std::size_t c = 0; c < plain_.size(); ++c) {
    visit(cells.cells()[c], [&](std::size_t f) {
      if (state_[f] != State::inner && state_[f] != State::zero) plain_[c] = 0;
    });
  }
}

/// Walls that meet are one wall, on which Phi = 0.
void ActiveFunctions::fix_walls(const Lattice& lattice) {
  const bool across = lattice.y.wall_below() || lattice.y.wall_above();
  const bool upright = lattice.x.wall_below() || lattice.x.wall_above();
  const SplineAxis& axis = across ? lattice.y : lattice.x;
  if (across != upright && axis.wall_below() && axis.wall_above()) {
    throw mechanics::Infeasible("a lattice between two walls that do not meet; allowed: a bottom between upright walls",
                                lattice.x.begin());
  }
  const auto column = [&](long i) {
    for (long j = 0; j < rows_; ++j) state_[index(i, j)] = State::zero;
  };
  const auto row = [&](long j) {
    for (long i = 0; i < columns_; ++i) state_[index(i, j)] = State::zero;
  };
  if (lattice.x.wall_above()) column(columns_ - 1);
  if (lattice.y.wall_above()) row(rows_ - 1);
  if (lattice.x.wall_below()) column(0);
  if (lattice.y.wall_below()) row(0);
}

/// Cells of markers alone, with no mass in the cells around them.
void ActiveFunctions::find_stray(const Lattice& lattice, const OccupiedCells& cells) {
  const long rows = lattice.y.cells();
  near_mass_.assign(static_cast<std::size_t>(lattice.x.cells() * rows), 0);
  for (const OccupiedCells::Cell& cell : cells.cells()) {
    if (cell.mass == 0) continue;
    for (long i = cell.x - 1; i <= cell.x + 1; ++i) {
      const long column = lattice.x.periodic() ? lattice.x.wrapped(i) : i;
      if (column < 0 || column >= lattice.x.cells()) continue;
      for (long j = std::max(cell.y - 1, 0L); j <= std::min(cell.y + 1, rows - 1); ++j) {
        near_mass_[static_cast<std::size_t>(column * rows + j)] = 1;
      }
    }
  }
  free_.assign(cells.cells().size(), 0);
  for (std::size_t c = 0; c < free_.size(); ++c) {
    const OccupiedCells::Cell& cell = cells.cells()[c];
    if (near_mass_[static_cast<std::size_t>(cell.x * rows + cell.y)] == 0) free_[c] = 1;
  }
}

void ActiveFunctions::mark(const OccupiedCells& cells, double least_mass) {
  inner_cells_ = 0;
  for (std::size_t c = 0; c < cells.cells().size(); ++c) {
    if (free_[c] != 0) continue;
    const OccupiedCells::Cell& cell = cells.cells()[c];
    const bool inner = cell.mass >= least_mass;
    inner_cells_ += inner ? 1 : 0;
    visit(cell, [&](std::size_t f) {
      State& state = state_[f];
      if (inner && (state == State::untouched || state == State::outer)) state = State::inner;
      if (!inner && state == State::untouched) state = State::outer;
    });
  }
}

bool ActiveFunctions::known(long i, long j) const {
  if (j < 0 || j >= rows_) return false;
  if (periodic_) {
    i = (i % columns_ + columns_) % columns_;
  } else if (i < 0 || i >= columns_) {
    return false;
  }
  const State state = state_[index(i, j)];
  return state == State::inner || state == State::zero;
}

bool ActiveFunctions::complete(const Block& block) const {
  for (long i = block.i; i < block.i + block.columns; ++i) {
    for (long j = block.j; j < block.j + block.rows; ++j) {
      if (!known(i, j)) return false;
    }
  }
  return true;
}

/// Along its own column or row: the continuation then couples few unknowns, and none far away.
bool ActiveFunctions::nearest_run(long i, long j, long side, Block& block) const {
  for (long gap = 1; gap <= search_radius; ++gap) {
    for (const Block& run : {Block{i, j - gap - side + 1, 1, side}, Block{i, j + gap, 1, side},
                             Block{i - gap - side + 1, j, side, 1}, Block{i + gap, j, side, 1}}) {
      if (!complete(run)) continue;
      block = run;
      return true;
    }
  }
  return false;
}

bool ActiveFunctions::nearest_block(long i, long j, long side, Block& block) const {
  for (const auto& [across, up] : offsets_of(side)) {
    block = {i + across, j + up, side, side};
    if (complete(block)) return true;
  }
  return false;
}

void ActiveFunctions::find_blocks() {
  continuations_.clear();
  for (long i = 0; i < columns_; ++i) {
    for (long j = 0; j < rows_; ++j) {
      State& state = state_[index(i, j)];
      if (state != State::outer) continue;
      Continuation found{.function = index(i, j), .i = i, .j = j, .block = {}};
      bool has_block = nearest_run(i, j, degree_ + 1, found.block) || nearest_block(i, j, degree_ + 1, found.block);
      if (!has_block && degree_ > 2) {
        has_block = nearest_run(i, j, 3, found.block) || nearest_block(i, j, 3, found.block);
      }
      if (has_block) continuations_.push_back(found);
      state = has_block ? State::continued : State::lost;
    }
  }
}

void ActiveFunctions::free_cells(const Lattice& lattice, const OccupiedCells& cells) {
  const auto at_wall = [](const SplineAxis& axis, long cell) {
    return (axis.wall_below() && cell == 0) || (axis.wall_above() && cell == axis.cells() - 1);
  };
  // What lies at walls first: its functions become unknowns, also for the cells above.
  for (const OccupiedCells::Cell& cell : cells.cells()) {
    if (cell.mass == 0 || (!at_wall(lattice.x, cell.x) && !at_wall(lattice.y, cell.y))) continue;
    visit(cell, [&](std::size_t f) {
      if (state_[f] == State::lost) state_[f] = State::inner;
    });
  }
  for (std::size_t c = 0; c < free_.size(); ++c) {
    visit(cells.cells()[c], [&](std::size_t f) {
      if (state_[f] == State::lost) free_[c] = 1;
    });
  }
}

void ActiveFunctions::number() {
  unknown_.assign(state_.size(), none);
  places_.clear();
  for (long i = 0; i < columns_; ++i) {
    for (long j = 0; j < rows_; ++j) {
      const std::size_t f = index(i, j);
      if (state_[f] != State::inner) continue;
      unknown_[f] = places_.size();
      places_.push_back({i, j});
    }
  }
}

void ActiveFunctions::write_terms(const Lattice& lattice) {
  begin_.assign(state_.size() + 1, 0);
  terms_.clear();
  auto next = continuations_.begin();
  const auto add = [&](std::size_t f, double weight) {
    if (state_[f] == State::inner) terms_.push_back({unknown_[f], weight});
  };
  for (std::size_t f = 0; f < state_.size(); ++f) {
    begin_[f] = terms_.size();
    if (state_[f] != State::continued) {
      add(f, 1);
      continue;
    }
    const Block& block = next->block;
    const auto columns = static_cast<std::size_t>(block.columns);
    const auto rows = static_cast<std::size_t>(block.rows);
    std::array<double, CellPolynomials::most> across{1};
    std::array<double, CellPolynomials::most> up{1};
    if (columns > 1) lattice.x.extend(next->i, block.i, {across.data(), columns});
    if (rows > 1) lattice.y.extend(next->j, block.j, {up.data(), rows});
    for (std::size_t a = 0; a < columns; ++a) {
      for (std::size_t b = 0; b < rows; ++b) {
        const double weight = across[a] * up[b];
        const long column = lattice.x.wrapped(block.i + static_cast<long>(a));
        if (weight != 0) add(index(column, block.j + static_cast<long>(b)), weight);
      }
    }
    ++next;
  }
  begin_.back() = terms_.size();
}

void ActiveFunctions::extend(std::span<const double> z, std::span<double> c) const {
  for (std::size_t f = 0; f < state_.size(); ++f) {
    double sum = 0;
    for (const Term& term : terms(f)) sum += term.weight * z[term.unknown];
    c[f] = sum;
  }
}

void ActiveFunctions::restrict(std::span<const double> b, std::span<double> r) const {
  std::fill(r.begin(), r.end(), 0.0);
  for (std::size_t f = 0; f < state_.size(); ++f) {
    for (const Term& term : terms(f)) r[term.unknown] += term.weight * b[f];
  }
}

}  // namespace seiche::gauss_particles
