#include "seiche/models/wcsph/right_hand_side.hpp"

#include <algorithm>

namespace seiche::wcsph {

RightHandSide::RightHandSide(const Settings& settings, double spacing)
    : storage_(settings.storage),
      kernel_(settings.kernel),
      diffusion_(settings),
      frozen_walls_(settings.walls == WallPressure::extrapolated),
      gravity_(settings.gravity),
      xsph_(settings.xsph) {
  if (const auto* artificial = std::get_if<ArtificialViscosity>(&settings.viscosity);
      artificial && artificial->alpha > 0) {
    friction_ = Friction::artificial;
    sound_scale_ = -0.5 * artificial->alpha;
  } else if (const auto* sps = std::get_if<LaminarSps>(&settings.viscosity)) {
    const bool turbulent = sps->smagorinsky > 0 || sps->isotropic > 0;
    friction_ = turbulent ? Friction::turbulent : Friction::laminar;
    kinematic_viscosity_ = sps->kinematic_viscosity;
    eddy_factor_ = sps->smagorinsky * spacing * sps->smagorinsky * spacing;
    isotropic_factor_ = 2.0 / 3 * sps->isotropic * spacing * spacing;
  }
}

void RightHandSide::resize(std::size_t particles) {
  const auto resize = [particles](auto& rates) {
    for (auto* values : {&rates.dx, &rates.dz, &rates.du, &rates.dw, &rates.ddensity}) values->assign(particles, 0);
  };
  if (storage_ == Storage::mixed) {
    resize(mixed_);
  } else {
    resize(full_);
  }
}

void RightHandSide::evaluate(Stage& stage, const Neighbours& neighbours, bool limited) {
  if (storage_ == Storage::mixed) {
    evaluate<MixedRecord>(stage, neighbours, limited, mixed_);
    return;
  }
  evaluate<Record>(stage, neighbours, limited, full_);
  if (frozen_walls_) {
    std::fill(full_.ddensity.begin() + static_cast<std::ptrdiff_t>(neighbours.fluid()), full_.ddensity.end(), 0.0);
  }
  // Step 3: density diffusion.
  diffusion_.add(stage, neighbours, full_.ddensity);
}

template <class SomeRecord, class Real>
void RightHandSide::evaluate(Stage& stage, const Neighbours& neighbours, bool limited, Arrays<Real>& rates) {
  const std::span<const Cluster> clusters = neighbours.clusters();
  rates.limit.resize(clusters.size());
  auto& held = stage.held<SomeRecord>();
  const RateWork<SomeRecord> work{.records = held.records.data(),
                                  .mass = held.mass.data(),
                                  .stress = held.stress.data(),
                                  .clusters = clusters.data(),
                                  .dx = rates.dx.data(),
                                  .dz = rates.dz.data(),
                                  .du = rates.du.data(),
                                  .dw = rates.dw.data(),
                                  .ddensity = rates.ddensity.data(),
                                  .limit = rates.limit.data(),
                                  .gravity = gravity_,
                                  .xsph = xsph_,
                                  .sound_scale = sound_scale_,
                                  .kinematic_viscosity = kinematic_viscosity_,
                                  .eddy_factor = eddy_factor_,
                                  .isotropic_factor = isotropic_factor_,
                                  .place_unit = stage.units().place * stage.units().per_length,
                                  .per_length = stage.units().per_length,
                                  .density_unit = stage.units().density};
  const std::size_t fluid = neighbours.fluid_clusters();
  const RateLoops<SomeRecord>& loops = rate_loops<SomeRecord>();

  // Step 1: stresses of unresolved eddies (4).
  if (friction_ == Friction::turbulent) {
    stage.refresh_volumes();
    const RateLoop<SomeRecord> strain = loops.strain(kernel_);
    neighbours.share(0, fluid, [&](std::size_t first, std::size_t last) { strain(work, first, last); });
    stage.refresh_image_stresses();
  }
  // Step 2: rates of the fluid and density of the walls.
  const RateLoop<SomeRecord> fluid_rates = loops.fluid(kernel_, friction_, limited);
  const RateLoop<SomeRecord> wall_rates = loops.wall(kernel_, limited);
  neighbours.share(0, clusters.size(), [&](std::size_t first, std::size_t last) {
    fluid_rates(work, first, std::min(last, fluid));
    wall_rates(work, std::max(first, fluid), last);
  });
  if (!limited) return;
  const auto most = std::max_element(rates.limit.begin(), rates.limit.end());
  largest_limit_ = *most;
  most_limited_ = static_cast<std::size_t>(clusters[static_cast<std::size_t>(most - rates.limit.begin())].first);
}

}  // namespace seiche::wcsph
