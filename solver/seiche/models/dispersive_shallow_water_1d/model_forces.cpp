// What acts on the markers: gravity, the energy of improved dispersion, surface pressure, body forces.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

namespace seiche::dispersive_shallow_water_1d {

void Model::gather_forces(Interval when) {
  gravity_forces(rows_, {0, size_}, weights_, forces());
  if (forcing_.surface_pressure) add_pressure_forces(when.middle());
  if (forcing_.body_force) {
    along_.assign(n_, 0.0);
    across_.assign(n_, 0.0);
    forcing_.body_force(when.middle(), along_, across_);
  }
}

/// Every cell pushes its two markers in opposite directions.
void Model::add_cell_forces() {
  double* const fx = rows_.force_x.row();
  double* const fy = rows_.force_y.row();
  double* const x = push_x_.row();
  double* const y = push_y_.row();
  x[-1] = channel_.periodic() ? x[size_ - 1] : 0.0;
  y[-1] = channel_.periodic() ? y[size_ - 1] : 0.0;
  if (!channel_.periodic()) x[size_ - 1] = y[size_ - 1] = 0;
  for (std::ptrdiff_t i = 0; i < size_; ++i) {
    fx[i] += x[i - 1] - x[i];
    fy[i] += y[i - 1] - y[i];
  }
}

double Model::dispersion_energy_factor(std::size_t cell) const {
  const double s = channel_.depth_power;
  return channel_.gamma * std::pow(rest_volume_[cell], s) * std::pow(channel_.reference_depth, 2 - s);
}

/// Energy A d^2 X^-(1+s) of a cell of width X whose ends differ by d in height. Between two configurations
///
///     E1 - E0 = A (Y0 + Y1)/2 (d0 + d1) (d1 - d0) + A (d0^2 + d1^2)/2 (Y1 - Y0)/(X1 - X0) (X1 - X0),   Y = X^-(1+s),
///
/// whose factors are the discrete gradient; for q0 = q1 the gradient itself.
void Model::add_dispersion_forces(Input q0, Input q1) {
  const double power = 1 + channel_.depth_power;
  const double* const y0 = q0.data() + n_;
  const double* const y1 = q1.data() + n_;
  double* const push_x = push_x_.row();
  double* const push_y = push_y_.row();
  for (std::size_t j = 0; j < cells_; ++j) {
    const std::size_t k = j + 1 < n_ ? j + 1 : 0;
    const double width0 = cell_width(q0, j);
    const double width1 = cell_width(q1, j);
    const double d0 = y0[k] - y0[j];
    const double d1 = y1[k] - y1[j];
    const double inverse0 = std::pow(width0, -power);
    const double stretch = (width1 - width0) / width0;
    const double growth = std::expm1(-power * std::log1p(stretch));  // Y1/Y0 - 1, without loss for small stretch
    const double divided = stretch == 0 ? -power * inverse0 / width0 : inverse0 * growth / (width1 - width0);
    push_y[j] = -dispersion_weight_[j] * (d0 + d1) * inverse0 * (1 + 0.5 * growth);
    push_x[j] = -dispersion_weight_[j] * 0.5 * (d0 * d0 + d1 * d1) * divided;
  }
  add_cell_forces();
}

/// Pressure on the segments between markers, normal into the fluid: (p dy, -p dx), by Gauss's two points with linear
/// shape functions.
void Model::add_pressure_forces(double time) {
  const double offset = 0.5 / std::numbers::sqrt3;
  const std::array<double, 2> points{0.5 - offset, 0.5 + offset};
  const double* const x = rows_.x.row();
  const double* const y = rows_.y.row();
  double* const fx = rows_.force_x.row();
  double* const fy = rows_.force_y.row();
  const auto& pressure = forcing_.surface_pressure;
  for (std::ptrdiff_t j = 0; j < static_cast<std::ptrdiff_t>(cells_); ++j) {
    const std::ptrdiff_t k = j + 1 < size_ ? j + 1 : 0;
    const double dx = x[j + 1] - x[j];
    const double dy = y[j + 1] - y[j];
    double left = 0;
    double right = 0;
    for (const double s : points) {
      const double p = 0.5 * pressure(x[j] + s * dx, time);
      left += p * (1 - s);
      right += p * s;
    }
    fx[j] += left * dy;
    fy[j] -= left * dx;
    fx[k] += right * dy;
    fy[k] -= right * dx;
  }
}

// What friction and breaking take, at a configuration that stays.

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
  pairs_.factor({pair_diagonal_, pair_coupling_}, channel_.periodic());
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
