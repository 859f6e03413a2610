#include "seiche/models/gauss_particles/gram_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seiche::gauss_particles {

namespace {

constexpr double shift = 1e-13;

}  // namespace

GramSystem::Place GramSystem::absolute(const ActiveFunctions& functions, std::size_t unknown) const {
  const ActiveFunctions::Place place = functions.place(unknown);
  return {place.i + offset_.i, place.j + offset_.j};
}

int GramSystem::slot(Place place) const {
  const long i = place.i - corner_.i;
  const long j = place.j - corner_.j;
  if (i < 0 || i >= window_columns_ || j < 0 || j >= window_rows_) return -1;
  return slot_at_[static_cast<std::size_t>(i * window_rows_ + j)];
}

long GramSystem::column_difference(long from, long to) const {
  long difference = to - from;
  if (columns_ > 0) {
    if (2 * difference > columns_) difference -= columns_;
    if (2 * difference < -columns_) difference += columns_;
  }
  return difference;
}

void GramSystem::begin(const Lattice& lattice, const ActiveFunctions& functions) {
  const long columns = lattice.x.periodic() ? lattice.x.cells() : 0;
  const bool same = degree_ == lattice.x.degree() && columns == columns_;
  degree_ = lattice.x.degree();
  columns_ = columns;
  offset_ = {lattice.x.first(), lattice.y.first()};
  if (!same) {
    extra_.clear();
    extra_reach_.clear();
    place_.clear();
  }
  if (!complete_ || !same || !fit(functions)) {
    choose_slots(lattice, functions);
    analyse();
    fit(functions);
  }
  complete_ = true;
  std::fill(values_.begin(), values_.end(), 0.0);
}

/// Whether all unknowns have slots and these are not far too many.
bool GramSystem::fit(const ActiveFunctions& functions) {
  const std::size_t unknowns = functions.unknowns();
  if (place_.empty() || place_.size() > 2 * unknowns + 64) return false;
  slot_of_.resize(unknowns);
  for (std::size_t k = 0; k < unknowns; ++k) {
    slot_of_[k] = slot(absolute(functions, k));
    if (slot_of_[k] < 0) return false;
  }
  return true;
}

/// The unknowns and their next neighbours, except functions that walls hold.
void GramSystem::choose_slots(const Lattice& lattice, const ActiveFunctions& functions) {
  Place low = absolute(functions, 0);
  Place high = low;
  for (std::size_t k = 0; k < functions.unknowns(); ++k) {
    const Place place = absolute(functions, k);
    low = {std::min(low.i, place.i), std::min(low.j, place.j)};
    high = {std::max(high.i, place.i), std::max(high.j, place.j)};
  }
  corner_ = {columns_ > 0 ? 0 : low.i - 1, low.j - 1};
  window_columns_ = columns_ > 0 ? columns_ : high.i - low.i + 3;
  window_rows_ = high.j - low.j + 3;
  slot_at_.assign(static_cast<std::size_t>(window_columns_ * window_rows_), -1);
  const auto held = [&](long i, long j) {
    return (lattice.x.wall_below() && i == offset_.i) || (lattice.y.wall_below() && j == offset_.j) ||
           (lattice.x.wall_above() && i == offset_.i + lattice.x.functions() - 1) ||
           (lattice.y.wall_above() && j == offset_.j + lattice.y.functions() - 1);
  };
  for (std::size_t k = 0; k < functions.unknowns(); ++k) {
    const Place place = absolute(functions, k);
    for (long i = place.i - 1; i <= place.i + 1; ++i) {
      for (long j = place.j - 1; j <= place.j + 1; ++j) {
        if (held(i, j)) continue;
        const long column = columns_ > 0 ? (i + columns_) % columns_ : i - corner_.i;
        slot_at_[static_cast<std::size_t>(column * window_rows_ + j - corner_.j)] = 0;
      }
    }
  }
  place_.clear();
  for (long i = 0; i < window_columns_; ++i) {
    for (long j = 0; j < window_rows_; ++j) {
      int& number = slot_at_[static_cast<std::size_t>(i * window_rows_ + j)];
      if (number < 0) continue;
      number = static_cast<int>(place_.size());
      place_.push_back({i + corner_.i, j + corner_.j});
    }
  }
}

GramSystem::Place GramSystem::moved(Place from, long columns, long rows) const {
  const long column = from.i + columns;
  return {columns_ > 0 ? (column + columns_) % columns_ : column, from.j + rows};
}

bool GramSystem::at_edge(Place place) const {
  for (const long step : {-degree_, degree_}) {
    if (slot(moved(place, step, 0)) < 0 || slot(moved(place, 0, step)) < 0) return true;
  }
  return false;
}

void GramSystem::couple(Place a, Place b) {
  complete_ = false;
  extra_.push_back({a, b});
  Place reach{column_difference(a.i, b.i), b.j - a.j};
  if (reach.i < 0 || (reach.i == 0 && reach.j < 0)) reach = {-reach.i, -reach.j};
  if (std::find(extra_reach_.begin(), extra_reach_.end(), reach) == extra_reach_.end()) extra_reach_.push_back(reach);
}

void GramSystem::analyse() {
  const int slots = static_cast<int>(place_.size());
  std::vector<Eigen::Triplet<double>> couplings;
  const auto add = [&](int a, int b) {
    if (a >= 0 && b >= 0) couplings.emplace_back(std::max(a, b), std::min(a, b));
  };
  for (int a = 0; a < slots; ++a) {
    const Place at = place_[static_cast<std::size_t>(a)];
    for (long i = -degree_; i <= degree_; ++i) {
      for (long j = -degree_; j <= degree_; ++j) add(a, slot(moved(at, i, j)));
    }
    if (extra_reach_.empty() || !at_edge(at)) continue;
    for (const Place reach : extra_reach_) {
      add(a, slot(moved(at, reach.i, reach.j)));
      add(a, slot(moved(at, -reach.i, -reach.j)));
    }
  }
  for (const Coupling& coupling : extra_) add(slot(coupling.a), slot(coupling.b));
  Eigen::SparseMatrix<double> pattern(slots, slots);
  pattern.setFromTriplets(couplings.begin(), couplings.end());
  column_begin_.assign(pattern.outerIndexPtr(), pattern.outerIndexPtr() + slots + 1);
  row_.assign(pattern.innerIndexPtr(), pattern.innerIndexPtr() + pattern.nonZeros());
  values_.assign(row_.size(), 0.0);
  solver_ = std::make_unique<linear::SparseCholesky>(pattern);
  ++analyses_;
  const long reach = 2 * degree_ + 1;
  stencil_.assign(place_.size() * static_cast<std::size_t>(reach * reach), -1);
  for (std::size_t a = 0; a < place_.size(); ++a) {
    for (long i = -degree_; i <= degree_; ++i) {
      for (long j = -degree_; j <= degree_; ++j) {
        const int b = slot(moved(place_[a], i, j));
        if (b < 0) continue;
        stencil_[a * static_cast<std::size_t>(reach * reach) +
                 static_cast<std::size_t>((i + degree_) * reach + j + degree_)] = entry(static_cast<int>(a), b);
      }
    }
  }
}

/// Where the coupling of two slots is stored; -1: nowhere.
int GramSystem::entry(int a, int b) const {
  const auto column = static_cast<std::size_t>(std::min(a, b));
  const auto begin = row_.begin() + column_begin_[column];
  const auto end = row_.begin() + column_begin_[column + 1];
  const auto found = std::lower_bound(begin, end, std::max(a, b));
  return found != end && *found == std::max(a, b) ? static_cast<int>(found - row_.begin()) : -1;
}

void GramSystem::add(std::span<const std::size_t> unknowns, const double* matrix) {
  const std::size_t n = unknowns.size();
  const long reach = 2 * degree_ + 1;
  for (std::size_t a = 0; a < n; ++a) {
    if (unknowns[a] == ActiveFunctions::none) continue;
    const int from = slot_of_[unknowns[a]];
    const Place p = place_[static_cast<std::size_t>(from)];
    for (std::size_t b = 0; b <= a; ++b) {
      if (unknowns[b] == ActiveFunctions::none) continue;
      const int to = slot_of_[unknowns[b]];
      const Place q = place_[static_cast<std::size_t>(to)];
      const long i = column_difference(p.i, q.i);
      const long j = q.j - p.j;
      const bool near = std::abs(i) <= degree_ && std::abs(j) <= degree_;
      const int place = near ? stencil_[static_cast<std::size_t>((from * reach + i + degree_) * reach + j + degree_)]
                             : entry(from, to);
      if (place < 0) {
        couple(p, q);
      } else {
        values_[static_cast<std::size_t>(place)] += matrix[a * n + b];
      }
    }
  }
}

void GramSystem::factor() {
  const std::size_t slots = column_begin_.size() - 1;
  scale_.resize(slots);
  work_.resize(slots);
  for (std::size_t a = 0; a < slots; ++a) {
    double& diagonal = values_[static_cast<std::size_t>(column_begin_[a])];
    if (!(diagonal > 0)) diagonal = 1;  // no unknown of this step
    scale_[a] = 1 / std::sqrt(diagonal);
  }
  for (std::size_t a = 0; a < slots; ++a) {
    const auto begin = static_cast<std::size_t>(column_begin_[a]);
    const auto end = static_cast<std::size_t>(column_begin_[a + 1]);
    for (std::size_t k = begin; k < end; ++k) values_[k] *= scale_[a] * scale_[static_cast<std::size_t>(row_[k])];
    values_[begin] = 1 + shift;
  }
  solver_->factor(values_);
}

double GramSystem::scaled_largest(std::span<const double> r) const {
  double largest = 0;
  for (std::size_t k = 0; k < r.size(); ++k) {
    const double scaled = std::abs(r[k]) * scale_[static_cast<std::size_t>(slot_of_[k])];
    if (!(scaled <= largest)) largest = scaled;
  }
  return largest;
}

double GramSystem::correct(std::span<const double> r, std::span<double> z) {
  std::fill(work_.begin(), work_.end(), 0.0);
  for (std::size_t k = 0; k < r.size(); ++k) {
    const auto slot = static_cast<std::size_t>(slot_of_[k]);
    work_[slot] = r[k] * scale_[slot];
  }
  solver_->solve(work_, work_);
  for (std::size_t k = 0; k < z.size(); ++k) {
    const auto slot = static_cast<std::size_t>(slot_of_[k]);
    z[k] += work_[slot] * scale_[slot];
  }
  return scaled_largest(r);
}

}  // namespace seiche::gauss_particles
