#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_1d {

Model::Model(Channel channel, const Markers& initial, Forcing forcing)
    : channel_(std::move(channel)), forcing_(std::move(forcing)), n_(initial.size()) {
  channel_.validate();
  initial.validate(channel_);
  cells_ = channel_.periodic() ? n_ : n_ - 1;
  size_ = static_cast<std::ptrdiff_t>(n_);
  rows_.resize(n_);
  for (GhostedArray* array : {&push_x_, &push_y_, &p_, &r_, &impulse_}) array->resize(n_);
  level_.assign(static_cast<std::size_t>(blocks()), 0);
  for (Desk& desk : desks_) {
    desk.bed.resize(static_cast<std::size_t>(block_size()));
    desk.slope.resize(static_cast<std::size_t>(block_size()));
  }
  shore_left_ = initial.x.front();
  shore_right_ = initial.x.back();
  const double weight = channel_.density * channel_.gravity;
  weights_ = {.gravity = weight, .slope_energy = channel_.slope_energy};
  weigh(initial);
  for (std::size_t j = 0; j < cells_; ++j) dispersion_weight_.push_back(0.5 * weight * dispersion_energy_factor(j));
  if (loses()) prepare_losses();
}

/// Elementary volumes: each cell is split at its middle abscissa between its two particles.
void Model::weigh(const Markers& initial) {
  const BottomProfile& bottom = *channel_.bottom;
  std::vector<double> volume(n_, 0.0);
  for (std::size_t j = 0; j < cells_; ++j) {
    const std::size_t k = j + 1 < n_ ? j + 1 : 0;
    const double x0 = initial.x[j];
    const double x1 = initial.x[k] + (k == 0 ? channel_.period : 0.0);
    const double half = 0.5 * (x1 - x0);
    const double middle = x0 + half;
    const double left = half * (0.75 * initial.y[j] + 0.25 * initial.y[k] - bottom.mean(x0, middle));
    const double right = half * (0.25 * initial.y[j] + 0.75 * initial.y[k] - bottom.mean(middle, x1));
    volume[j] += left;
    volume[k] += right;
    rest_volume_.push_back(2 * half * (0.5 * (initial.y[j] + initial.y[k]) - bottom.mean(x0, x1)));
    require_that(rest_volume_.back() > 0, "volume of cell {} at x = {:.6g} is {:.6g}; allowed: > 0", j, x0,
                 rest_volume_.back());
  }
  if (channel_.tip_mass == TipMass::consistent && !channel_.periodic()) {
    if (channel_.left == End::tip) volume.front() = rest_volume_.front() / 6;
    if (channel_.right == End::tip) volume.back() = rest_volume_.back() / 6;
  }
  for (std::size_t i = 0; i < n_; ++i) {
    mass_.push_back(channel_.density * volume[i]);
    require_that(mass_[i] > 0, "mass of marker {} at x = {:.6g} is {:.6g}; allowed: > 0", i, initial.x[i], mass_[i]);
  }
  inertia_p_ = mass_;
  inertia_r_ = mass_;
  for (double& m : inertia_r_) m *= channel_.alpha;
  if (!channel_.periodic()) {
    const auto bind = [&](End end, std::size_t i) {
      if (end == End::tip) inertia_r_[i] = 0;
      if (end == End::wall) {
        // The vertical velocity is r cos phi, the one along the bottom r sin phi (Frank); over a column that does not
        // move sideways the exact energy has alpha alone.
        const double slope = bottom.slope(initial.x[i]);
        const double sine_square = slope * slope / (1 + slope * slope);
        const double factor =
            channel_.kinetics == Kinetics::frank ? sine_square + channel_.alpha * (1 - sine_square) : channel_.alpha;
        inertia_p_[i] = 0;
        inertia_r_[i] = mass_[i] * factor;
      }
    };
    bind(channel_.left, 0);
    bind(channel_.right, n_ - 1);
  }
  for (std::size_t i = 0; i < n_; ++i) {
    rows_.mobility_p.row()[i] = inertia_p_[i] > 0 ? 1 / inertia_p_[i] : 0.0;
    rows_.mobility_r.row()[i] = inertia_r_[i] > 0 ? 1 / inertia_r_[i] : 0.0;
  }
  for (GhostedArray* array : {&rows_.mobility_p, &rows_.mobility_r}) {
    double* const row = array->row();
    row[-1] = row[size_ - 1];
    row[size_] = row[0];
  }
}

mechanics::State Model::state_of(const Markers& markers) const {
  require_that(markers.size() == n_, "{} markers; needed: {}", markers.size(), n_);
  mechanics::State state;
  state.q = markers.x;
  state.q.insert(state.q.end(), markers.y.begin(), markers.y.end());
  state.u.resize(2 * n_);
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    Desk& desk = desks_.front();
    const bool level = sample(block, state.q.data(), desk.bed, 0, desk.slope);
    const Range range = markers_of(block);
    for (std::ptrdiff_t i = range.first; i < range.last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Frame f = level ? Frame{} : desk.bed.frame(i - range.first);
      // Walls and tips have one rate; the other column of their frame is empty or unused.
      const double determinant = f.xp * f.yr - f.xr * f.yp;
      if (inertia_p_[k] > 0 && inertia_r_[k] > 0) {
        state.u[k] = (f.yr * markers.u[k] - f.xr * markers.v[k]) / determinant;
        state.u[n_ + k] = (f.xp * markers.v[k] - f.yp * markers.u[k]) / determinant;
      } else if (inertia_p_[k] > 0) {
        state.u[k] = f.xp * markers.u[k] + f.yp * markers.v[k];
      } else {
        state.u[n_ + k] = markers.v[k];
      }
    }
  }
  return state;
}

void Model::velocities(Input q, Input rates, Output u, Output v) const {
  Desk& desk = desks_.front();
  const std::vector<double> origin(static_cast<std::size_t>(block_size()), 0.0);
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    const bool level = sample(block, q.data(), desk.bed, 0, desk.slope);
    const auto [first, last] = markers_of(block);
    const double* const p = rates.data() + first;
    advance_rows(desk.bed, level, {0, last - first}, origin.data(), origin.data(), p, p + n_, 1, u.data() + first,
                 v.data() + first);
  }
}

double Model::mass() const {
  return compensated_sum(mass_);
}

std::array<double, 1> Model::momentum(Input q, Input u) const {
  std::vector<double> along(n_);
  std::vector<double> up(n_);
  velocities(q, u, along, up);
  CompensatedSum sum;
  for (std::size_t i = 0; i < n_; ++i) sum.add(mass_[i] * along[i]);
  return {sum.value()};
}

double Model::kinetic_energy(Input, Input u) const {
  CompensatedSum sum;
  for (std::size_t i = 0; i < n_; ++i) {
    sum.add(0.5 * (inertia_p_[i] * u[i] * u[i] + inertia_r_[i] * u[n_ + i] * u[n_ + i]));
  }
  return sum.value();
}

double Model::cell_width(Input q, std::size_t j) const {
  return j + 1 < n_ ? q[j + 1] - q[j] : q[0] + channel_.period - q[j];
}

double Model::potential_energy(Input q) const {
  const double* const y = q.data() + n_;
  const double weight = 0.5 * channel_.density * channel_.gravity;
  CompensatedSum sum;
  for (std::size_t j = 0; j < cells_; ++j) {
    const std::size_t k = j + 1 < n_ ? j + 1 : 0;
    const double width = cell_width(q, j);
    const double mean = 0.5 * (y[j] + y[k]);
    const double tilt = y[k] - y[j];
    double energy = width * (mean * mean + 0.25 * channel_.slope_energy * tilt * tilt);
    if (channel_.gamma > 0)
      energy += dispersion_energy_factor(j) * tilt * tilt * std::pow(width, -1 - channel_.depth_power);
    sum.add(weight * energy);
  }
  if (!channel_.periodic()) {
    const BottomProfile& bottom = *channel_.bottom;
    if (channel_.right != End::wall) {
      sum.add(-weight * (q[n_ - 1] - shore_right_) * bottom.mean_square(shore_right_, q[n_ - 1]));
    }
    if (channel_.left != End::wall) {
      sum.add(weight * (q[0] - shore_left_) * bottom.mean_square(shore_left_, q[0]));
    }
  }
  return sum.value();
}

void Model::constraint_values(Input q, Output f) const {
  const double* const y = q.data() + n_;
  const BottomProfile& bottom = *channel_.bottom;
  for (std::size_t j = 0; j < cells_; ++j) {
    const std::size_t k = j + 1 < n_ ? j + 1 : 0;
    const double width = cell_width(q, j);
    f[j] = width * (0.5 * (y[j] + y[k]) - bottom.mean(q[j], q[j] + width)) - rest_volume_[j];
  }
}

double Model::place(std::size_t rate) const {
  return rows_.x.row()[rate % n_];
}

}  // namespace seiche::dispersive_shallow_water_1d
