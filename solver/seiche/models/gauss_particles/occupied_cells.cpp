#include "seiche/models/gauss_particles/occupied_cells.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"

namespace seiche::gauss_particles {

void OccupiedCells::sample(const BottomProfile& profile, std::span<const double> x) {
  ground_slope_.resize(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double place = std::clamp(x[k], profile.begin(), profile.end());
    double ground = 0;
    profile.sample({&place, 1}, {&ground, 1}, {&ground_slope_[k], 1});
    height_[k] -= ground;
  }
}

Bounds OccupiedCells::survey(const Ground& ground, std::span<const double> x, std::span<const double> y) {
  for (const std::span<const double> places : {x, y}) {
    if (const std::size_t bad = mechanics::first_not_finite(places); bad < places.size()) {
      throw mechanics::Infeasible(x[bad], "particle {} is at ({:g}, {:g})", bad, x[bad], y[bad]);
    }
  }
  height_.assign(y.begin(), y.end());
  if (ground.profile) {
    sample(*ground.profile, x);
  } else {
    for (double& height : height_) height -= ground.level;
  }
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(height_.begin(), height_.end());
  return {*left, *right, *low, *high};
}

void OccupiedCells::locate(const Lattice& lattice, std::span<const double> x) {
  const std::size_t n = x.size();
  column_place_.resize(n);
  row_place_.resize(n);
  cell_of_.resize(n);
  const auto along = [&](const SplineAxis& axis, double place, const char* name, double at) {
    double s = (place - axis.begin()) / axis.cell();
    const auto cells = static_cast<double>(axis.cells());
    if (axis.periodic()) {
      s -= cells * std::floor(s / cells);
      return s < cells ? s : 0.0;
    }
    if ((axis.wall_below() && s < 0) || (axis.wall_above() && s > cells)) return std::clamp(s, 0.0, cells);
    const double low = axis.wall_below() ? 0 : static_cast<double>(free_margin);
    const double high = axis.wall_above() ? cells : cells - static_cast<double>(free_margin);
    if (!(s >= low && s <= high)) {
      throw mechanics::Infeasible(at, "particle at {} = {:g}; the lattice with its margin is [{:g}, {:g}]", name, place,
                                  axis.begin() + low * axis.cell(), axis.begin() + high * axis.cell());
    }
    return s;
  };
  for (std::size_t k = 0; k < n; ++k) {
    column_place_[k] = along(lattice.x, x[k], "x", x[k]);
    row_place_[k] = along(lattice.y, height_[k], "height", x[k]);
    const auto cell = [](double place, const SplineAxis& axis) {
      return std::min(static_cast<long>(place), axis.cells() - 1);
    };
    cell_of_[k] = static_cast<std::size_t>(cell(column_place_[k], lattice.x) * lattice.y.cells() +
                                           cell(row_place_[k], lattice.y));
  }
}

void OccupiedCells::sort(const Lattice& lattice, std::span<const double> x, std::span<const double> mass) {
  locate(lattice, x);
  count_.assign(static_cast<std::size_t>(lattice.x.cells() * lattice.y.cells()), 0);
  for (const std::size_t cell : cell_of_) ++count_[cell];
  cells_.clear();
  std::size_t place = 0;
  for (std::size_t c = 0; c < count_.size(); ++c) {
    if (count_[c] == 0) continue;
    const auto rows = static_cast<std::size_t>(lattice.y.cells());
    const std::size_t places = (count_[c] + lanes - 1) / lanes * lanes;
    cells_.push_back({.x = static_cast<long>(c / rows),
                      .y = static_cast<long>(c % rows),
                      .begin = place,
                      .places = places,
                      .count = count_[c]});
    count_[c] = place;
    place += places;
  }
  across_.assign(place, 0);
  up_.assign(place, 0);
  mass_.assign(place, 0);
  slope_.assign(ground_slope_.empty() ? 0 : place, 0);
  particle_.assign(place, nobody);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t to = count_[cell_of_[k]]++;
    particle_[to] = k;
    mass_[to] = mass[k];
    if (!slope_.empty()) slope_[to] = ground_slope_[k];
  }
  for (Cell& cell : cells_) {
    for (std::size_t i = cell.begin; i < cell.begin + cell.count; ++i) {
      across_[i] = column_place_[particle_[i]] - static_cast<double>(cell.x) - 0.5;
      up_[i] = row_place_[particle_[i]] - static_cast<double>(cell.y) - 0.5;
      cell.mass += mass_[i];
    }
  }
}

}  // namespace seiche::gauss_particles
