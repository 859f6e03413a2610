#include "seiche/models/wcsph/wall_pressure.hpp"

#include <algorithm>

#include "seiche/models/wcsph/neighbour_sums.hpp"

namespace seiche::wcsph {
namespace {

template <class Kernel>
void extrapolate(const TaitFluid& fluid, const std::function<std::array<double, 2>(std::size_t i)>& gravity,
                 Stage& stage, const Neighbours& neighbours, std::vector<double>& density) {
  // Walls list fluid only, so no wall density that is being set is read.
  for_each_particle(neighbours, neighbours.fluid_clusters(), neighbours.clusters().size(),
                    [&](std::size_t i, const Cluster& cluster) {
                      double pressure = 0, weights = 0, lever_x = 0, lever_z = 0;
                      for_each_neighbour(stage, cluster, i, [&](std::size_t j, double x, double z, double r, double h) {
                        const Record& b = stage.records()[j];
                        const double w = weight<Kernel>(r, h);
                        pressure += b.pressure * b.density * b.density * w;
                        lever_x += b.density * x * w;
                        lever_z += b.density * z * w;
                        weights += w;
                      });
                      double extrapolated = 0;
                      if (weights > 0) {
                        const auto [gravity_x, gravity_z] = gravity(i);
                        extrapolated = (pressure + gravity_x * lever_x + gravity_z * lever_z) / weights;
                      }
                      // Beyond it Tait's law has no density; a run that comes there stops by its own checks.
                      density[i] = fluid.density_at(std::max(extrapolated, -0.99 * fluid.stiffness()));
                      stage.set_density(i, density[i]);
                    });
}

}  // namespace

void extrapolate_to_walls(KernelName kernel, const TaitFluid& fluid,
                          const std::function<std::array<double, 2>(std::size_t i)>& gravity, Stage& stage,
                          const Neighbours& neighbours, std::vector<double>& density) {
  if (kernel == KernelName::cubic_spline) {
    extrapolate<CubicSpline>(fluid, gravity, stage, neighbours, density);
  } else {
    extrapolate<WendlandC2>(fluid, gravity, stage, neighbours, density);
  }
  stage.refresh_images();
}

}  // namespace seiche::wcsph
