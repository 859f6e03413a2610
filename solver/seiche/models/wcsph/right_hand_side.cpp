#include "seiche/models/wcsph/right_hand_side.hpp"

#include <algorithm>

namespace seiche::wcsph {

RightHandSide::RightHandSide(const Settings& settings, double spacing)
    : kernel_(settings.kernel), diffusion_(settings), frozen_walls_(settings.walls == WallPressure::extrapolated) {
  work_.gravity = settings.gravity;
  work_.xsph = settings.xsph;
  work_.sound_scale = 1;
  if (const auto* artificial = std::get_if<ArtificialViscosity>(&settings.viscosity);
      artificial && artificial->alpha > 0) {
    friction_ = Friction::artificial;
    work_.sound_scale = -0.5 * artificial->alpha;
  } else if (const auto* sps = std::get_if<LaminarSps>(&settings.viscosity)) {
    const bool turbulent = sps->smagorinsky > 0 || sps->isotropic > 0;
    friction_ = turbulent ? Friction::turbulent : Friction::laminar;
    work_.kinematic_viscosity = sps->kinematic_viscosity;
    work_.eddy_factor = sps->smagorinsky * spacing * sps->smagorinsky * spacing;
    work_.isotropic_factor = 2.0 / 3 * sps->isotropic * spacing * spacing;
  }
}

void RightHandSide::resize(std::size_t particles) {
  for (std::vector<double>* values : {&dx, &dz, &du, &dw, &ddensity, &limit_}) values->assign(particles, 0);
  work_.dx = dx.data();
  work_.dz = dz.data();
  work_.du = du.data();
  work_.dw = dw.data();
  work_.ddensity = ddensity.data();
  work_.limit = limit_.data();
}

void RightHandSide::evaluate(Stage& stage, const Neighbours& neighbours, bool limited) {
  work_.records = stage.records().data();
  work_.mass = stage.mass().data();
  work_.stress = stage.stress().data();
  work_.clusters = neighbours.clusters().data();
  const std::size_t fluid = neighbours.fluid_clusters();
  const PairLoops& loops = pair_loops();

  // Step 1: stresses of unresolved eddies (4).
  if (friction_ == Friction::turbulent) {
    stage.refresh_volumes();
    const PairLoop strain = loops.strain(kernel_);
    neighbours.share(0, fluid, [&](std::size_t first, std::size_t last) { strain(work_, first, last); });
    stage.refresh_image_stresses();
  }
  // Step 2: rates of the fluid and density of the walls.
  const PairLoop rates = loops.fluid(kernel_, friction_, limited);
  const PairLoop wall_rates = loops.wall(kernel_, limited);
  neighbours.share(0, neighbours.clusters().size(), [&](std::size_t first, std::size_t last) {
    rates(work_, first, std::min(last, fluid));
    wall_rates(work_, std::max(first, fluid), last);
  });
  if (frozen_walls_) std::fill(ddensity.begin() + static_cast<std::ptrdiff_t>(neighbours.fluid()), ddensity.end(), 0.0);
  // Step 3: density diffusion.
  diffusion_.add(stage, neighbours, ddensity);
}

double RightHandSide::largest_limit() const {
  return limit_[most_limited()];
}

std::size_t RightHandSide::most_limited() const {
  return static_cast<std::size_t>(std::max_element(limit_.begin(), limit_.end()) - limit_.begin());
}

}  // namespace seiche::wcsph
