#include "seiche/models/wcsph/right_hand_side.hpp"

#include <algorithm>

namespace seiche::wcsph {

RightHandSide::RightHandSide(const Settings& settings, double spacing)
    : loops_(&pair_loops(settings.kernel)), gravity_(settings.gravity), xsph_(settings.xsph) {
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
  for (auto* values : {&rates_.dx, &rates_.dz, &rates_.du, &rates_.dw, &rates_.ddensity}) values->assign(particles, 0);
}

void RightHandSide::evaluate(Stage& stage, const Neighbours& neighbours, bool limited) {
  limit_.resize(neighbours.clusters().size());
  PairWork work = stage.work(neighbours);
  work.dx = rates_.dx.data();
  work.dz = rates_.dz.data();
  work.du = rates_.du.data();
  work.dw = rates_.dw.data();
  work.ddensity = rates_.ddensity.data();
  work.limit = limit_.data();
  work.stress = stage.stress().data();
  work.gravity = gravity_;
  work.xsph = xsph_;
  work.sound_scale = sound_scale_;
  work.kinematic_viscosity = kinematic_viscosity_;
  work.eddy_factor = eddy_factor_;
  work.isotropic_factor = isotropic_factor_;

  // Step 1: stresses of unresolved eddies (4).
  if (friction_ == Friction::turbulent) {
    stage.refresh_volumes();
    neighbours.over_fluid(loops_->strain, work);
    stage.refresh_image_stresses();
  }
  // Step 2: rates of the fluid and density of the walls.
  const std::size_t fluid = neighbours.fluid_clusters();
  const PairLoop fluid_rates = loops_->fluid[static_cast<std::size_t>(friction_)][limited ? 1 : 0];
  const PairLoop wall_rates = loops_->wall[limited ? 1 : 0];
  neighbours.share(0, neighbours.clusters().size(), [&](std::size_t first, std::size_t last) {
    fluid_rates(work, first, std::min(last, fluid));
    wall_rates(work, std::max(first, fluid), last);
  });
  if (!limited) return;
  const auto most = std::max_element(limit_.begin(), limit_.end());
  largest_limit_ = *most;
  most_limited_ =
      static_cast<std::size_t>(neighbours.clusters()[static_cast<std::size_t>(most - limit_.begin())].first);
}

}  // namespace seiche::wcsph
