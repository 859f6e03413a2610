#include "seiche/models/wcsph/density_filter.hpp"

#include <cmath>

#include "seiche/models/wcsph/pair_loops.hpp"

namespace seiche::wcsph {
namespace {

/// The determinant of A over h_0^4 A_00^3 is about 0.1 inside the fluid.
constexpr double least_filter_determinant = 2e-5;
constexpr int least_neighbours = 5;
constexpr int least_neighbours_of_mean = 3;
/// Largest change that is believed.
constexpr double tolerated = 0.1;

/// The filtered density; NaN where there is none.
double filtered(const FilterMoments& m, double smoothing) {
  const auto [a00, ax, az, axx, axz, azz, m0, mx, mz, neighbours] = m;
  const double c00 = axx * azz - axz * axz;
  const double c0x = axz * az - ax * azz;
  const double c0z = ax * axz - axx * az;
  const double determinant = a00 * c00 + ax * c0x + az * c0z;
  const double scale = std::pow(smoothing, 4) * a00 * a00 * a00;
  if (neighbours >= least_neighbours && std::abs(determinant) >= least_filter_determinant * scale) {
    return (c00 * m0 + c0x * mx + c0z * mz) / determinant;
  }
  return neighbours >= least_neighbours_of_mean ? m0 / a00 : NAN;
}

}  // namespace

void filter_density(KernelName kernel, double smoothing, double reference, const Stage& stage,
                    const Neighbours& neighbours, std::vector<double>& density) {
  std::vector<FilterMoments> moments(neighbours.fluid());
  const FilterWork work{.records = stage.records().data(),
                        .mass = stage.mass().data(),
                        .clusters = neighbours.clusters().data(),
                        .moments = moments.data()};
  const FilterLoop sum = pair_loops().filter(kernel);
  neighbours.share(0, neighbours.fluid_clusters(),
                   [&](std::size_t first, std::size_t last) { sum(work, first, last); });
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double changed = filtered(moments[i], smoothing);
    if (std::abs(changed - reference) <= tolerated * reference) density[i] = changed;
  }
}

}  // namespace seiche::wcsph
