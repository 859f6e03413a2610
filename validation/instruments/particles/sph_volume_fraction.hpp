/// Fraction of the volume that is water, as the particles see it, and the elevation that follows from it.
///
///     f(r) = (1/c) sum (m_b/rho_b) W(|r - r_b|, h)      over fluid particles
///
/// c is the part of the kernel's weight that lies inside the basin: with c = 1 the fraction would fall to 1/2 along
/// walls as it does along a free surface. Inside water f = 1 to the quadrature of the lattice, on a free surface 1/2; a
/// lone particle, with f < 0.3, is not water.
///
/// When not to use it: c supposes straight walls along the axes. Near a paddle the fraction is too low by up to 1/2.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::wcsph {

class VolumeFraction {
 public:
  /// @param smoothing_length  h [m], the same for all
  /// @param basin             effective walls; infinite where there is none, and at both ends of a period
  VolumeFraction(const Particles& particles, double smoothing_length, const Box& basin = unbounded,
                 KernelName kernel = KernelName::cubic_spline, const Period& period = {});

  /// 0 outside the basin.
  [[nodiscard]] double at(double x, double z) const;
  /// At the points (left + i step, bottom + j step), i fastest.
  [[nodiscard]] std::vector<double> on_grid(double left, double bottom, double step, long columns, long rows) const;

  /// Level where the fraction on the vertical falls to 1/2: the highest one. Nothing where there is no water.
  [[nodiscard]] std::optional<double> elevation(double x) const;
  /// Mean elevation over [left, right], from points h/2 apart or nearer; dry points count as the lower end of the
  /// basin, and are left out if it has none. Nothing where all are dry.
  [[nodiscard]] std::optional<double> mean_elevation(double left, double right) const;

  /// Of the places of the fluid particles.
  [[nodiscard]] const Box& extents() const { return extents_; }

 private:
  struct Sample {
    double x, z, volume;
  };
  [[nodiscard]] std::vector<Sample> samples_of(const Particles& particles);
  void sort(std::vector<Sample> samples);
  /// Weight of the kernel inside the basin.
  [[nodiscard]] double coverage(double x, double z) const;

  double h_;
  Box basin_;
  KernelName kernel_;
  Period period_;
  Box extents_{};
  double left_ = 0;                 ///< of the first strip, each 2h wide
  std::vector<Sample> samples_;     ///< images of periodic boxes included, sorted by strips and upwards in each
  std::vector<std::size_t> begin_;  ///< of each strip's samples
};

}  // namespace seiche::wcsph
