/// The operators of smoothed particles on the periodic unit square, summed over all pairs.
///
///     interpolation         sum V f_b W_ab
///     difference gradient   sum V (f_b - f_a) grad_a W_ab
///     symmetric gradient    sum V (f_a + f_b) grad_a W_ab
///     laminar operator      sum 2 V r_ab . grad_a W_ab (f_a - f_b)/(r_ab^2 + 0.01 h^2)        (a Laplacian)
///     moving least squares  sum V f_b (beta_0 + beta . r_ab) W_ab,  beta = A^-1 (1, 0, 0),
///                           A = sum V W_ab (1, r_ab) (1, r_ab)^T
///
/// References: Monaghan, Smoothed particle hydrodynamics, Rep. Prog. Phys. 68 (2005) 1703; Colagrossi and Landrini,
/// Numerical simulation of interfacial flows by SPH, J. Comput. Phys. 191 (2003) 448.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "seiche/models/wcsph/kernel.hpp"
#include "verification/noise.hpp"

namespace seiche::verification {

/// Particles of equal volume on the unit square.
struct Cloud {
  std::vector<double> x, z;
  double volume = 0;
};

/// n x n particles in the middle of their cells, moved by up to jitter dx in each direction.
inline Cloud unit_square(std::size_t n, double jitter) {
  Cloud cloud;
  Noise noise(n);
  const double dx = 1 / static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      cloud.x.push_back((static_cast<double>(i) + 0.5 + jitter * noise()) * dx);
      cloud.z.push_back((static_cast<double>(j) + 0.5 + jitter * noise()) * dx);
    }
  }
  cloud.volume = dx * dx;
  return cloud;
}

struct Operators {
  double interpolation = 0;
  Eigen::Vector2d difference{0, 0};
  Eigen::Vector2d symmetric{0, 0};
  double laminar = 0, moving_least_squares = 0;
};

/// Distance to the nearest image in a unit period.
inline double nearest(double distance) {
  if (distance > 0.5) return distance - 1;
  return distance < -0.5 ? distance + 1 : distance;
}

/// All operators at each particle, of the values f of the field.
template <class Kernel>
std::vector<Operators> operators(const Cloud& cloud, double h, const std::vector<double>& f) {
  const std::size_t count = f.size();
  const double reach = wcsph::support * wcsph::support * h * h;
  std::vector<Operators> result(count);
  for (std::size_t a = 0; a < count; ++a) {
    Operators& at = result[a];
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    Eigen::Vector3d field_moments = Eigen::Vector3d::Zero();
    for (std::size_t b = 0; b < count; ++b) {
      const double x = nearest(cloud.x[a] - cloud.x[b]), z = nearest(cloud.z[a] - cloud.z[b]);
      const double square = x * x + z * z;
      if (square >= reach) continue;
      const double r = std::sqrt(square);
      const double weighted = cloud.volume * wcsph::weight<Kernel>(r, h);
      const Eigen::Vector3d basis(1, x, z);
      moments += weighted * basis * basis.transpose();
      field_moments += weighted * f[b] * basis;
      at.interpolation += weighted * f[b];
      if (b == a) continue;
      const Eigen::Vector2d gradient = cloud.volume * wcsph::radial_slope<Kernel>(r, h) / r * Eigen::Vector2d(x, z);
      at.difference += (f[b] - f[a]) * gradient;
      at.symmetric += (f[a] + f[b]) * gradient;
      at.laminar += 2 * (x * gradient.x() + z * gradient.y()) * (f[a] - f[b]) / (square + 0.01 * h * h);
    }
    const Eigen::Vector3d beta = moments.ldlt().solve(Eigen::Vector3d::UnitX());
    at.moving_least_squares = beta.dot(field_moments);
  }
  return result;
}

}  // namespace seiche::verification
