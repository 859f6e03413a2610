// What friction and breaking take, at a configuration that stays.
#include <algorithm>
#include <cmath>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

namespace seiche::dispersive_shallow_water_1d {

void Model::prepare_losses() {
  if (channel_.breaking) fronts_.emplace(*channel_.breaking, cells_);
  for (std::vector<double>* array :
       {&velocity_x_, &velocity_y_, &still_, &friction_rate_, &pair_diagonal_, &pair_coupling_}) {
    array->assign(n_, 0.0);
  }
  rates_.assign(2 * n_, 0.0);
  mobility_.assign(rows_.mobility_p.row() - 1, rows_.mobility_p.row() + n_ + 1);
  loss_impulse_.assign(cells_, 0.0);
}

Losses Model::lose(double h, Input q, Output u) {
  Losses lost;
  if (!loses()) return lost;
  place_at(q);
  if (fronts_ && (find_fronts(u) || unresolved())) {
    const double before = kinetic_energy(q, u);
    exchange_momentum(h, u);
    lost.breaking = before - kinetic_energy(q, u);
  }
  if (channel_.friction.active()) take_friction(h, u, lost);
  return lost;
}

/// Whether markers stand farther apart somewhere than the water is deep.
bool Model::unresolved() const {
  for (std::size_t j = 0; j < cells_; ++j) {
    const double width = rows_.width.row()[static_cast<std::ptrdiff_t>(j)];
    if (width * width > rest_volume_[j]) return true;
  }
  return false;
}

bool Model::find_fronts(Input u) {
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    advance_rows(rows_.bed, level(block), markers_of(block), still_.data(), still_.data(), u.data(), u.data() + n_, 1,
                 velocity_x_.data(), velocity_y_.data());
  }
  return fronts_->find({.x = {rows_.x.row(), n_},
                        .y = {rows_.y.row(), n_},
                        .u = velocity_x_,
                        .bed = {rows_.bed.elevation.row(), n_},
                        .gravity = channel_.gravity,
                        .period = channel_.period});
}

/// In fronts along the bottom, over unresolved water across it. Then volumes are constant again.
void Model::exchange_momentum(double h, Output u) {
  const double viscosity_of_depth = 2 * std::sqrt(channel_.alpha * channel_.gravity);
  const std::span<const double> damping = fronts_->damping();
  exchange(inertia_p_, u.first(n_), [&](std::size_t j, double width, double depth) {
    return h * channel_.density * damping[j] * viscosity_of_depth * depth * depth * std::sqrt(depth) / width;
  });
  const double rate_of_depth = std::sqrt(channel_.alpha * channel_.gravity / 12);
  exchange(inertia_r_, u.subspan(n_), [&](std::size_t, double width, double depth) {
    return width > depth ? h * channel_.density * rate_of_depth * width * width / std::sqrt(depth) : 0.0;
  });
  assemble_and_factor();
  project_rates(u);
}

/// (M + L) u' = M u, L the pairs of neighbours, by a factor of each cell: energy falls, and pairs keep momentum.
template <class PairFactor>
void Model::exchange(const std::vector<double>& inertia, Output u, const PairFactor& pair_factor) {
  for (std::size_t i = 0; i < n_; ++i) {
    const bool moves = inertia[i] > 0;
    pair_diagonal_[i] = moves ? inertia[i] : 1.0;
    rates_[i] = moves ? inertia[i] * u[i] : 0.0;
  }
  for (std::size_t j = 0; j < cells_; ++j) {
    const std::size_t k = j + 1 < n_ ? j + 1 : 0;
    const double width = rows_.width.row()[static_cast<std::ptrdiff_t>(j)];
    const bool pair = inertia[j] > 0 && inertia[k] > 0;
    const double factor = pair ? pair_factor(j, width, rest_volume_[j] / width) : 0.0;
    pair_diagonal_[j] += factor;
    pair_diagonal_[k] += factor;
    pair_coupling_[j] = -factor;
  }
  pairs_.factor(channel_.periodic(), pair_diagonal_, pair_coupling_);
  pairs_.solve({rates_.data(), n_}, u);
}

/// u' = 2 u~ - u,  J u~ = 0,  M (1 + h k/2) u~ = M u + J^T mu: takes h k M u~^2 along the bottom. k belongs to |u~|
/// by the second of two sweeps, and stays below the 2/h that would turn the water round.
void Model::take_friction(double h, Output u, Losses& lost) {
  const double* const width = rows_.width.row();
  double* const mobility = rows_.mobility_p.row();
  std::copy(u.begin(), u.end(), rates_.begin());
  for (int sweep = 0; sweep < 2; ++sweep) {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto k = static_cast<std::ptrdiff_t>(i);
      const bool first = i == 0 && !channel_.periodic();
      const bool last = i + 1 == n_ && !channel_.periodic();
      const double before = first ? 0.0 : rest_volume_[i == 0 ? cells_ - 1 : i - 1];
      const double after = last ? 0.0 : rest_volume_[i];
      const double depth = (before + after) / (width[k - 1] + width[k]);
      const double rate = channel_.friction.per_length(channel_.gravity, depth) * std::abs(rates_[i]);
      friction_rate_[i] = std::min(rate, 2 / h);
    }
    for (std::size_t i = 0; i < n_; ++i) {
      const double slowed = 1 / (1 + 0.5 * h * friction_rate_[i]);
      mobility[static_cast<std::ptrdiff_t>(i)] = mobility_[i + 1] * slowed;
      rates_[i] = u[i] * slowed;
      rates_[n_ + i] = u[n_ + i];
    }
    mobility[-1] = mobility[size_ - 1];
    mobility[size_] = mobility[0];
    assemble_and_factor();
    project_rates(rates_);
  }
  CompensatedSum energy;
  CompensatedSum impulse;
  for (std::size_t i = 0; i < n_; ++i) {
    const double lost_along = h * friction_rate_[i] * inertia_p_[i] * rates_[i];
    energy.add(lost_along * rates_[i]);
    impulse.add(lost_along);
    u[i] = 2 * rates_[i] - u[i];
    u[n_ + i] = 2 * rates_[n_ + i] - u[n_ + i];
  }
  lost.friction = energy.value();
  lost.friction_impulse = impulse.value();
  std::copy(mobility_.begin(), mobility_.end(), rows_.mobility_p.row() - 1);
}

void Model::take_back(const std::optional<BreakingFronts>& fronts) {
  fronts_ = fronts;
  std::copy(mobility_.begin(), mobility_.end(), rows_.mobility_p.row() - 1);
}

void Model::project_rates(Output u) {
  const std::span<double> defect(rows_.impulse.row(), cells_);
  constraint_rates(u, defect);
  for (double& d : defect) d = -d;
  solve(defect, loss_impulse_);
  react(loss_impulse_, u);
}

}  // namespace seiche::dispersive_shallow_water_1d
