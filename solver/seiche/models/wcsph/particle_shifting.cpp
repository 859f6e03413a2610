#include "seiche/models/wcsph/particle_shifting.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::wcsph {

void ParticleShifting::apply(double tau, const Stage& stage, const Neighbours& neighbours, Particles& particles) {
  at_surface_.assign(stage.records().size(), 0);
  double fastest = 0;
  for (std::size_t i = 0; i < neighbours.fluid(); ++i) {
    const Record& record = stage.records()[i];
    fastest = std::max(fastest, record.u * record.u + record.w * record.w);
  }
  fastest = std::sqrt(fastest);
  const ShiftWork work{.records = stage.records().data(),
                       .mass = stage.mass().data(),
                       .clusters = neighbours.clusters().data(),
                       .at_surface = at_surface_.data(),
                       .x = particles.x.data(),
                       .z = particles.z.data(),
                       .u = particles.u.data(),
                       .w = particles.w.data(),
                       .density = particles.density.data(),
                       .spacing = spacing_,
                       .travel = 4 * fastest * tau};
  const auto run = [&](ShiftLoop loop) {
    neighbours.share(0, neighbours.fluid_clusters(),
                     [&](std::size_t first, std::size_t last) { loop(work, first, last); });
  };
  run(pair_loops().surface(kernel_));
  const std::size_t count = particles.size();
  for (std::size_t k = 0; k < neighbours.images().size(); ++k) {
    at_surface_[count + k] = at_surface_[static_cast<std::size_t>(neighbours.images()[k].source)];
  }
  run(pair_loops().shift(kernel_));
}

}  // namespace seiche::wcsph
