// What acts on the markers: gravity, the energy of improved dispersion, surface pressure, body forces.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

}  // namespace seiche::dispersive_shallow_water_1d
