#include "seiche/models/wcsph/density_filter.hpp"

#include <cmath>

#include "seiche/models/wcsph/neighbour_sums.hpp"

namespace seiche::wcsph {
namespace {

/// The determinant of A over h_0^4 A_00^3 is about 0.1 inside the fluid.
constexpr double least_determinant = 2e-5;
constexpr int least_neighbours = 5;
constexpr int least_neighbours_of_mean = 3;
/// Largest change that is believed.
constexpr double tolerated = 0.1;

/// Sums of one particle; m0, mx, mz carry masses in place of volumes.
struct Moments {
  double a00 = 0, ax = 0, az = 0, axx = 0, axz = 0, azz = 0;
  double m0 = 0, mx = 0, mz = 0;
  int neighbours = 0;

  /// The filtered density; NaN where there is none.
  [[nodiscard]] double density(double smoothing) const {
    const double c00 = axx * azz - axz * axz;
    const double c0x = axz * az - ax * azz;
    const double c0z = ax * axz - axx * az;
    const double determinant = a00 * c00 + ax * c0x + az * c0z;
    const double scale = std::pow(smoothing, 4) * a00 * a00 * a00;
    if (neighbours >= least_neighbours && std::abs(determinant) >= least_determinant * scale) {
      return (c00 * m0 + c0x * mx + c0z * mz) / determinant;
    }
    return neighbours >= least_neighbours_of_mean ? m0 / a00 : NAN;
  }
};

template <class Kernel>
void filter(double smoothing, double reference, const Stage& stage, const Neighbours& neighbours,
            std::vector<double>& density) {
  for_each_particle(neighbours, 0, neighbours.fluid_clusters(), [&](std::size_t i, const Cluster& cluster) {
    Moments sums;
    for_each_neighbour(stage, cluster, i, [&](std::size_t j, double x, double z, double r, double h) {
      const double mass_weight = stage.mass()[j] * weight<Kernel>(r, h);
      const double volume_weight = mass_weight / stage.records()[j].density;
      sums.neighbours += j == i ? 0 : 1;
      sums.a00 += volume_weight;
      sums.ax += volume_weight * x;
      sums.az += volume_weight * z;
      sums.axx += volume_weight * x * x;
      sums.axz += volume_weight * x * z;
      sums.azz += volume_weight * z * z;
      sums.m0 += mass_weight;
      sums.mx += mass_weight * x;
      sums.mz += mass_weight * z;
    });
    const double filtered = sums.density(smoothing);
    if (std::abs(filtered - reference) <= tolerated * reference) density[i] = filtered;
  });
}

}  // namespace

void filter_density(KernelName kernel, double smoothing, double reference, const Stage& stage,
                    const Neighbours& neighbours, std::vector<double>& density) {
  if (kernel == KernelName::cubic_spline) {
    filter<CubicSpline>(smoothing, reference, stage, neighbours, density);
  } else {
    filter<WendlandC2>(smoothing, reference, stage, neighbours, density);
  }
}

}  // namespace seiche::wcsph
