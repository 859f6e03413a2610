/// Right-hand sides of weakly compressible SPH, summed over all pairs straight from the formulas.
///
///     d rho_a/dt = sum m_b u_ab . grad W_ab                                                                      (2)
///     d u_a/dt   = -sum m_b (P_a/rho_a^2 + P_b/rho_b^2 + Pi_ab) grad W_ab + g                                    (3)
///     or with    + sum m_b (tau_a/rho_a^2 + tau_b/rho_b^2) . grad W_ab
///                + sum m_b 4 nu_0 r_ab . grad W_ab/((rho_a + rho_b)(r_ab^2 + 0.01 h_ab^2)) u_ab                  (4)
///     d r_a/dt   = u_a - eps sum (m_b/rho_ab) u_ab W_ab                                                          (6)
///
/// Slow, and independent of every list, tile and lane of Flow, which it judges. Numbering as in flow.hpp.
///
/// When not to use it: anything but checks; N^2 operations.
///
/// References: Monaghan, J. Comput. Phys. 110 (1994) 399; Lo and Shao, Appl. Ocean Res. 24 (2002) 275; Colagrossi and
/// Landrini, J. Comput. Phys. 191 (2003) 448; Adami, Hu and Adams, J. Comput. Phys. 231 (2012) 7057; Antuono,
/// Colagrossi, Marrone and Molteni, Free-surface flows solved by means of SPH schemes with numerical diffusive terms,
/// Comput. Phys. Comm. 181 (2010) 532.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Dense>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification {

class DirectSums {
 public:
  using Vector = Eigen::Vector2d;
  using Matrix = Eigen::Matrix2d;

  DirectSums(wcsph::Particles particles, double spacing, const wcsph::Settings& settings)
      : p_(std::move(particles)), spacing_(spacing), settings_(settings) {
    derive();
    if (settings_.walls != wcsph::WallPressure::extrapolated) return;
    for (std::size_t a = 0; a < p_.size(); ++a) {
      if (!fluid(a)) p_.density[a] = extrapolated_density(a);
    }
    derive();
  }

  /// Walls have a rate of density alone, their other rates are 0.
  [[nodiscard]] wcsph::Rates rates() const {
    const std::size_t count = p_.size();
    const std::vector<Matrix> stress = eddy_stress();
    const std::vector<Vector> gradient = density_gradient();
    wcsph::Rates rates;
    for (auto* array : {&rates.dx, &rates.dz, &rates.du, &rates.dw, &rates.ddensity}) array->assign(count, 0.0);
    for (std::size_t a = 0; a < count; ++a) {
      Vector motion = velocity(a);
      Vector acceleration(0, -settings_.gravity);
      double compression = 0;
      neighbours(a, [&](std::size_t b, const Pair& pair) {
        const double m = p_.mass[b];
        const Vector u = velocity(a) - velocity(b);
        const double pull = pressure_[a] / (p_.density[a] * p_.density[a]) +
                            pressure_[b] / (p_.density[b] * p_.density[b]) + artificial(a, b, u, pair);
        compression += m * u.dot(pair.gradient) + diffusion(a, b, gradient, pair);
        acceleration += -m * pull * pair.gradient + m * laminar(a, b, pair) * u +
                        m * (stress[a] / p_.density[a] + stress[b] / p_.density[b]) * pair.gradient;
        motion -= settings_.xsph * m / mean_density(a, b) * pair.weight * u;
      });
      rates.ddensity[a] = compression;
      if (!fluid(a)) {
        if (settings_.walls == wcsph::WallPressure::extrapolated) rates.ddensity[a] = 0;
        continue;
      }
      rates.dx[a] = motion.x();
      rates.dz[a] = motion.y();
      rates.du[a] = acceleration.x();
      rates.dw[a] = acceleration.y();
    }
    return rates;
  }

  /// Ordered pairs within the support.
  [[nodiscard]] long long pairs() const {
    long long count = 0;
    for (std::size_t a = 0; a < p_.size(); ++a) neighbours(a, [&](std::size_t, const Pair&) { ++count; });
    return count;
  }

  /// Densities by moving least squares of first order, sum m_b (beta_0 + beta . r_ab) W_ab with itself, all from the
  /// old ones, for the fluid; Shepard's mean where fewer than 5 neighbours or a singular matrix leave no other,
  /// unchanged where fewer than 3 do, or where the new value is outside [0.9, 1.1] rho_0.
  [[nodiscard]] std::vector<double> filtered_density() const {
    std::vector<double> result = p_.density;
    for_fluid([&](std::size_t a) {
      const FilterSums sums = filter_sums(a);
      if (sums.neighbours < 3) return;
      const double value =
          sums.regular ? sums.beta().dot(sums.mass_moments) : sums.mass_moments(0) / sums.moments(0, 0);
      if (std::abs(value / settings_.density - 1) <= 0.1) result[a] = value;
    });
    return result;
  }

  /// What cancels in moving least squares: the largest sum of V_b W_ab (|beta_0| + |beta_x x_ab| + |beta_z z_ab|), the
  /// sum without magnitudes being 1.
  [[nodiscard]] double filter_cancellation() const {
    Largest largest;
    for_fluid([&](std::size_t a) {
      const FilterSums sums = filter_sums(a);
      if (!sums.regular) return;
      const Eigen::Vector3d beta = sums.beta().cwiseAbs();
      double magnitudes = beta(0) * p_.mass[a] / p_.density[a] * weight(0, smoothing_[a]);
      neighbours(a, [&](std::size_t b, const Pair& pair) {
        const Eigen::Vector3d basis(1, std::abs(pair.r.x()), std::abs(pair.r.y()));
        magnitudes += volume(b) * pair.weight * beta.dot(basis);
      });
      largest.add(magnitudes);
    });
    return largest.value();
  }

  /// The fluid after particle shifting over a time tau: -4 h u_max tau sum V_b [1 + 0.2 (W_ab/W(dx))^4] grad W_ab, at
  /// most dx/10, with velocities and densities that follow their gradients; without the free surface, where
  /// -sum V_b r_ab . grad W_ab < 1.5, and all that have such a neighbour.
  [[nodiscard]] wcsph::Particles shifted(double tau) const {
    std::vector<double> divergence(p_.size(), 2.0);
    Largest fastest;
    for_fluid([&](std::size_t a) {
      fastest.add(velocity(a).norm());
      divergence[a] = 0;
      neighbours(a, [&](std::size_t b, const Pair& pair) { divergence[a] -= volume(b) * pair.r.dot(pair.gradient); });
    });
    wcsph::Particles result = p_;
    for_fluid([&](std::size_t a) {
      bool surface = divergence[a] < 1.5;
      Vector crowd = Vector::Zero(), density = Vector::Zero();
      Matrix flow = Matrix::Zero();
      neighbours(a, [&](std::size_t b, const Pair& pair) {
        surface = surface || divergence[b] < 1.5;
        crowd += volume(b) * (1 + 0.2 * std::pow(pair.weight / weight(spacing_, smoothing_[a]), 4)) * pair.gradient;
        flow += volume(b) * (velocity(b) - velocity(a)) * pair.gradient.transpose();
        density += volume(b) * (p_.density[b] - p_.density[a]) * pair.gradient;
      });
      if (surface) return;
      Vector shift = -4 * smoothing_[a] * fastest.value() * tau * crowd;
      if (shift.norm() > 0.1 * spacing_) shift *= 0.1 * spacing_ / shift.norm();
      const Vector change = flow * shift;
      result.x[a] += shift.x();
      result.z[a] += shift.y();
      result.u[a] += change.x();
      result.w[a] += change.y();
      result.density[a] += density.dot(shift);
    });
    return result;
  }

  /// max |h u_ab . r_ab/(r_ab^2 + 0.01 h^2)| added to the sound speed, over the smoothing length: 1/dt is its maximum
  /// over the Courant number.
  [[nodiscard]] double largest_step() const {
    Largest fastest;
    for (std::size_t a = 0; a < p_.size(); ++a) {
      Worst shear;
      shear.add(0);  // of the particle and itself
      neighbours(a, [&](std::size_t b, const Pair& pair) { shear.add(approach(velocity(a) - velocity(b), pair)); });
      fastest.add((sound_speed_[a] + shear.value()) / smoothing_[a]);
    }
    return settings_.courant / fastest.value();
  }

 private:
  struct Pair {
    Vector r;
    double square, h, weight;
    Vector gradient;  ///< of W with respect to the position of the first
  };

  /// Sums of moving least squares about a particle, itself included.
  struct FilterSums {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    Eigen::Vector3d mass_moments = Eigen::Vector3d::Zero();
    int neighbours = 0;
    bool regular = false;

    [[nodiscard]] Eigen::Vector3d beta() const { return moments.ldlt().solve(Eigen::Vector3d::UnitX()); }
  };
  [[nodiscard]] FilterSums filter_sums(std::size_t a) const {
    FilterSums sums;
    const auto add = [&](std::size_t b, const Vector& r, double weight) {
      const Eigen::Vector3d basis(1, r.x(), r.y());
      sums.moments += p_.mass[b] / p_.density[b] * weight * basis * basis.transpose();
      sums.mass_moments += p_.mass[b] * weight * basis;
    };
    add(a, Vector::Zero(), weight(0, smoothing_[a]));
    neighbours(a, [&](std::size_t b, const Pair& pair) {
      add(b, pair.r, pair.weight);
      ++sums.neighbours;
    });
    const double h = settings_.smoothing * spacing_;
    sums.regular = sums.neighbours >= 5 &&
                   std::abs(sums.moments.determinant()) >= 2e-5 * std::pow(h, 4) * std::pow(sums.moments(0, 0), 3);
    return sums;
  }

  /// Pressures, sound speeds and smoothing lengths from densities (5).
  void derive() {
    for (auto* array : {&pressure_, &sound_speed_, &smoothing_}) array->clear();
    for (std::size_t a = 0; a < p_.size(); ++a) {
      const double s = p_.density[a] / settings_.density;
      const double pressure = stiffness() * (std::pow(s, wcsph::TaitFluid::exponent) - 1);
      const bool clamped = settings_.walls == wcsph::WallPressure::clamped && !fluid(a);
      pressure_.push_back(clamped ? std::max(pressure, 0.0) : pressure);
      sound_speed_.push_back(settings_.sound_speed * std::pow(s, 0.5 * (wcsph::TaitFluid::exponent - 1)));
      const bool keeps = settings_.walls == wcsph::WallPressure::extrapolated && !fluid(a);
      smoothing_.push_back(settings_.smoothing * spacing_ / (keeps ? 1 : std::sqrt(s)));
    }
  }

  [[nodiscard]] double stiffness() const {
    return settings_.density * settings_.sound_speed * settings_.sound_speed / wcsph::TaitFluid::exponent;
  }

  /// Of a wall at rest: P = sum [P_b + rho_b g . r_ab] W/sum W over the fluid, turned into a density.
  [[nodiscard]] double extrapolated_density(std::size_t a) const {
    double sum = 0, weights = 0;
    neighbours(a, [&](std::size_t b, const Pair& pair) {
      sum += (pressure_[b] - p_.density[b] * settings_.gravity * pair.r.y()) * pair.weight;
      weights += pair.weight;
    });
    const double pressure = weights > 0 ? sum / weights : 0;
    return settings_.density * std::pow(1 + pressure / stiffness(), 1 / wcsph::TaitFluid::exponent);
  }

  [[nodiscard]] bool fluid(std::size_t a) const { return p_.kind[a] == wcsph::Kind::fluid; }
  template <class Visit>
  void for_fluid(const Visit& visit) const {
    for (std::size_t a = 0; a < p_.size(); ++a) {
      if (fluid(a)) visit(a);
    }
  }
  [[nodiscard]] double volume(std::size_t a) const { return p_.mass[a] / p_.density[a]; }
  [[nodiscard]] Vector velocity(std::size_t a) const { return {p_.u[a], p_.w[a]}; }
  [[nodiscard]] double mean_density(std::size_t a, std::size_t b) const {
    return 0.5 * (p_.density[a] + p_.density[b]);
  }

  static double nearest(double distance, double period) {
    return std::isinf(period) ? distance : distance - period * std::round(distance / period);
  }

  /// Calls visit(b, pair) for all b within the support of a; walls do not see each other.
  template <class Visit>
  void neighbours(std::size_t a, const Visit& visit) const {
    for (std::size_t b = 0; b < p_.size(); ++b) {
      if (b == a || (!fluid(a) && !fluid(b))) continue;
      const double h = 0.5 * (smoothing_[a] + smoothing_[b]);
      const Vector r(nearest(p_.x[a] - p_.x[b], settings_.period.x), nearest(p_.z[a] - p_.z[b], settings_.period.z));
      const double distance = r.norm();
      if (distance >= wcsph::support * h) continue;
      visit(b, Pair{r, r.squaredNorm(), h, weight(distance, h), slope(distance, h) / distance * r});
    }
  }

  [[nodiscard]] bool spline() const { return settings_.kernel == wcsph::KernelName::cubic_spline; }
  [[nodiscard]] double weight(double r, double h) const {
    return spline() ? wcsph::weight<wcsph::CubicSpline>(r, h) : wcsph::weight<wcsph::WendlandC2>(r, h);
  }
  [[nodiscard]] double slope(double r, double h) const {
    return spline() ? wcsph::radial_slope<wcsph::CubicSpline>(r, h) : wcsph::radial_slope<wcsph::WendlandC2>(r, h);
  }

  /// h u_ab . r_ab/(r_ab^2 + 0.01 h^2)
  static double approach(const Vector& u, const Pair& pair) {
    return pair.h * u.dot(pair.r) / (pair.square + 0.01 * pair.h * pair.h);
  }

  /// Pi_ab of (3).
  [[nodiscard]] double artificial(std::size_t a, std::size_t b, const Vector& u, const Pair& pair) const {
    const auto* const model = std::get_if<wcsph::ArtificialViscosity>(&settings_.viscosity);
    if (model == nullptr || u.dot(pair.r) >= 0) return 0;
    const double sound = 0.5 * (sound_speed_[a] + sound_speed_[b]);
    return -model->alpha * sound * approach(u, pair) / mean_density(a, b);
  }

  /// Factor of m_b u_ab in the last sum of (4).
  [[nodiscard]] double laminar(std::size_t a, std::size_t b, const Pair& pair) const {
    const auto* const model = std::get_if<wcsph::LaminarSps>(&settings_.viscosity);
    if (model == nullptr) return 0;
    return 4 * model->kinematic_viscosity * pair.r.dot(pair.gradient) /
           ((p_.density[a] + p_.density[b]) * (pair.square + 0.01 * pair.h * pair.h));
  }

  /// tau/rho of unresolved eddies, 0 on walls.
  [[nodiscard]] std::vector<Matrix> eddy_stress() const {
    std::vector<Matrix> stress(p_.size(), Matrix::Zero());
    const auto* const model = std::get_if<wcsph::LaminarSps>(&settings_.viscosity);
    if (model == nullptr) return stress;
    for_fluid([&](std::size_t a) {
      Matrix gradient = Matrix::Zero();
      neighbours(a, [&](std::size_t b, const Pair& pair) {
        gradient -= volume(b) * (velocity(a) - velocity(b)) * pair.gradient.transpose();
      });
      const Matrix strain = 0.5 * (gradient + gradient.transpose());
      const double size = std::sqrt(2 * strain.squaredNorm());
      const double viscosity = std::pow(model->smagorinsky * spacing_, 2) * size;
      stress[a] = 2 * viscosity * (strain - strain.trace() / 3 * Matrix::Identity()) -
                  2.0 / 3 * model->isotropic * spacing_ * spacing_ * size * size * Matrix::Identity();
    });
    return stress;
  }

  /// Gradient of the density with the first-order correction of Antuono et al. (2010), of the fluid; 0 for particles
  /// with too few neighbours for the correction.
  [[nodiscard]] std::vector<Vector> density_gradient() const {
    std::vector<Vector> result(p_.size(), Vector::Zero());
    if (settings_.density_diffusion == 0) return result;
    for_fluid([&](std::size_t a) {
      Matrix moments = Matrix::Zero();
      Vector sum = Vector::Zero();
      neighbours(a, [&](std::size_t b, const Pair& pair) {
        if (!fluid(b)) return;
        moments -= volume(b) * pair.gradient * pair.r.transpose();
        sum += volume(b) * (p_.density[b] - p_.density[a]) * pair.gradient;
      });
      if (moments.determinant() >= 1e-2) result[a] = moments.inverse() * sum;
    });
    return result;
  }

  /// delta h c_0 V_b psi_ab . grad W_ab between fluid particles.
  [[nodiscard]] double diffusion(std::size_t a, std::size_t b, const std::vector<Vector>& gradient,
                                 const Pair& pair) const {
    if (settings_.density_diffusion == 0 || !fluid(a) || !fluid(b)) return 0;
    const Vector psi = -2 * (p_.density[b] - p_.density[a]) / pair.square * pair.r - (gradient[a] + gradient[b]);
    return settings_.density_diffusion * pair.h * settings_.sound_speed * p_.mass[b] / p_.density[b] *
           psi.dot(pair.gradient);
  }

  wcsph::Particles p_;
  double spacing_;
  wcsph::Settings settings_;
  std::vector<double> pressure_, sound_speed_, smoothing_;
};

/// Rates of a flow, whose present state has been reached by some steps, against the sums: the largest difference over
/// the largest rate, of places, of velocities or of densities.
inline double compare(wcsph::Flow& flow, double spacing) {
  const wcsph::Particles particles = flow.particles();
  const wcsph::Rates computed = flow.rates();
  const wcsph::Rates direct = DirectSums(particles, spacing, flow.settings()).rates();
  // Rates of walls other than that of their density belong to their motion.
  const auto difference = [&](std::vector<double> wcsph::Rates::*rate, bool walls) {
    std::vector<double> mine, theirs;
    for (std::size_t a = 0; a < particles.size(); ++a) {
      if (!walls && particles.kind[a] != wcsph::Kind::fluid) continue;
      mine.push_back((computed.*rate)[a]);
      theirs.push_back((direct.*rate)[a]);
    }
    return relative_difference(mine, theirs);
  };
  using wcsph::Rates;
  return seiche::worst(std::array{difference(&Rates::dx, false), difference(&Rates::dz, false),
                                  difference(&Rates::du, false), difference(&Rates::dw, false),
                                  difference(&Rates::ddensity, true)});
}

}  // namespace seiche::verification
