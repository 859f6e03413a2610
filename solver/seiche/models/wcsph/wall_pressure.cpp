#include "seiche/models/wcsph/wall_pressure.hpp"

#include <algorithm>

namespace seiche::wcsph {

void ExtrapolatedWalls::apply(const std::function<std::array<double, 2>(std::size_t i)>& gravity, Stage& stage,
                              const Neighbours& neighbours) {
  means_.resize(neighbours.order().size());
  const WallPressureWork work{
      .records = stage.records().data(), .clusters = neighbours.clusters().data(), .means = means_.data()};
  const WallPressureLoop sum = pair_loops().wall_pressure(kernel_);
  // Walls list fluid only, so no wall density that is being set is read.
  neighbours.share(neighbours.fluid_clusters(), neighbours.clusters().size(), [&](std::size_t first, std::size_t last) {
    sum(work, first, last);
    const Cluster& end = neighbours.clusters()[last - 1];
    const auto behind = static_cast<std::size_t>(end.first + end.count);
    for (auto i = static_cast<std::size_t>(neighbours.clusters()[first].first); i < behind; ++i) {
      const auto [gravity_x, gravity_z] = gravity(i);
      const double extrapolated = means_[i].pressure + gravity_x * means_[i].lever_x + gravity_z * means_[i].lever_z;
      // Beyond it Tait's law has no density; a run that comes there stops by its own checks.
      stage.set_density(i, fluid_.density_at(std::max(extrapolated, -0.99 * fluid_.stiffness())));
    }
  });
  stage.refresh_images();
}

}  // namespace seiche::wcsph
