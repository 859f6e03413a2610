#include "seiche/models/wcsph/density_diffusion.hpp"

namespace seiche::wcsph {

DensityDiffusion::DensityDiffusion(const Settings& settings)
    : strength_(settings.density_diffusion * settings.sound_speed), kernel_(settings.kernel) {}

void DensityDiffusion::add(const Stage& stage, const Neighbours& neighbours, std::vector<double>& ddensity) {
  if (strength_ == 0) return;
  const std::size_t records = stage.records().size();
  gradients_.resize(records);
#pragma omp parallel for schedule(static) if (records > 2048)
  for (std::size_t i = 0; i < records; ++i) {
    gradients_[i] = {0, 0, neighbours.is_fluid(i) ? stage.mass()[i] / stage.records()[i].density : 0};
  }
  const DiffusionWork work{.records = stage.records().data(),
                           .clusters = neighbours.clusters().data(),
                           .gradients = gradients_.data(),
                           .ddensity = ddensity.data(),
                           .strength = strength_};
  const auto run = [&](DiffusionLoop loop) {
    neighbours.share(0, neighbours.fluid_clusters(),
                     [&](std::size_t first, std::size_t last) { loop(work, first, last); });
  };
  run(pair_loops().density_gradient(kernel_));
  const std::size_t particles = neighbours.order().size();
  for (std::size_t k = 0; k < neighbours.images().size(); ++k) {
    gradients_[particles + k] = gradients_[static_cast<std::size_t>(neighbours.images()[k].source)];
  }
  run(pair_loops().diffusion(kernel_));
}

}  // namespace seiche::wcsph
