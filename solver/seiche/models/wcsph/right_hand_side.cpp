#include "seiche/models/wcsph/right_hand_side.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::wcsph {

RightHandSide::RightHandSide(const Settings& settings, double spacing)
    : loops_(&pair_loops(settings.kernel, settings.lanes)),
      constants_{.gravity = settings.gravity, .xsph = settings.xsph} {
  if (const auto* artificial = std::get_if<ArtificialViscosity>(&settings.viscosity);
      artificial && artificial->alpha > 0) {
    friction_ = Friction::artificial;
    constants_.sound_scale = -0.5 * artificial->alpha;
  } else if (const auto* sps = std::get_if<LaminarSps>(&settings.viscosity)) {
    const bool turbulent = sps->smagorinsky > 0 || sps->isotropic > 0;
    friction_ = turbulent ? Friction::turbulent : Friction::laminar;
    constants_.kinematic_viscosity = sps->kinematic_viscosity;
    constants_.eddy_factor = sps->smagorinsky * spacing * sps->smagorinsky * spacing;
    constants_.isotropic_factor = 2.0 / 3 * sps->isotropic * spacing * spacing;
  }
  constants_.inverse_density = 1 / settings.density;
  constants_.sound_speed = constants_.sound_scale * settings.sound_speed;
}

void RightHandSide::resize(std::size_t particles) {
  for (auto* values : {&rates_.dx, &rates_.dz, &rates_.du, &rates_.dw, &rates_.ddensity}) values->assign(particles, 0);
}

void RightHandSide::evaluate(Stage& stage, const Neighbours& neighbours, bool limited) {
  limit_.resize(neighbours.clusters().size());
  PairWork work = stage.work(neighbours, constants_);
  work.dx = rates_.dx.data();
  work.dz = rates_.dz.data();
  work.du = rates_.du.data();
  work.dw = rates_.dw.data();
  work.ddensity = rates_.ddensity.data();
  if (limited) work.limit = limit_.data();
  work.stress = stage.stress().data();

  // Step 1: stresses of unresolved eddies (4).
  if (friction_ == Friction::turbulent) {
    stage.refresh_volumes();
    neighbours.over_fluid(loops_->strain, work);
    neighbours.copy_to_images(stage.stress());
  }
  // Step 2: rates of the fluid and density of the walls.
  const std::size_t fluid = neighbours.fluid_clusters();
  const PairLoop fluid_rates = loops_->fluid[static_cast<std::size_t>(friction_)];
  neighbours.share(0, neighbours.clusters().size(), [&](std::size_t first, std::size_t last) {
    fluid_rates(work, first, std::min(last, fluid));
    loops_->wall(work, std::max(first, fluid), last);
  });
  if (!limited) return;
  const auto most = std::max_element(limit_.begin(), limit_.end());
  largest_limit_ = *most;
  most_limited_ =
      static_cast<std::size_t>(neighbours.clusters()[static_cast<std::size_t>(most - limit_.begin())].first);
}

namespace {

/// The determinant of A over h_0^4 A_00^3 is about 0.1 inside the fluid.
constexpr double least_filter_determinant = 2e-5;
constexpr int least_neighbours = 5;
constexpr int least_neighbours_of_mean = 3;
/// Largest change of the filter, over rho_0, that is believed.
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

Corrections::Corrections(const Settings& settings, double spacing)
    : loops_(&pair_loops(settings.kernel, settings.lanes)),
      fluid_(settings.density, settings.sound_speed),
      diffusion_(settings.density_diffusion * settings.sound_speed),
      spacing_(spacing),
      smoothing_(settings.smoothing * spacing) {}

void Corrections::add_diffusion(const Stage& stage, const Neighbours& neighbours, std::vector<double>& ddensity) {
  if (diffusion_ == 0) return;
  const std::size_t records = stage.records().size();
  gradients_.resize(records);
#pragma omp parallel for schedule(static) if (records > 2048)
  for (std::size_t i = 0; i < records; ++i) {
    gradients_[i] = {0, 0, neighbours.is_fluid(i) ? stage.records()[i].mass / stage.records()[i].density : 0};
  }
  PairWork work = stage.work(neighbours);
  work.gradients = gradients_.data();
  work.ddensity = ddensity.data();
  work.diffusion = diffusion_;
  neighbours.over_fluid(loops_->density_gradient, work);
  neighbours.copy_to_images(gradients_);
  neighbours.over_fluid(loops_->diffusion, work);
}

void Corrections::filter(const Stage& stage, const Neighbours& neighbours, std::vector<double>& density) const {
  std::vector<FilterMoments> moments(neighbours.fluid());
  PairWork work = stage.work(neighbours);
  work.moments = moments.data();
  neighbours.over_fluid(loops_->filter, work);
  const double reference = fluid_.reference_density();
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double changed = filtered(moments[i], smoothing_);
    if (std::abs(changed - reference) <= tolerated * reference) density[i] = changed;
  }
}

void Corrections::shift(double tau, const Stage& stage, const Neighbours& neighbours, Particles& particles) {
  at_surface_.assign(stage.records().size(), 0);
  double fastest = 0;
  for (std::size_t i = 0; i < neighbours.fluid(); ++i) {
    const Record& record = stage.records()[i];
    fastest = std::max(fastest, record.u * record.u + record.w * record.w);
  }
  PairWork work = stage.work(neighbours);
  work.at_surface = at_surface_.data();
  work.x = particles.x.data();
  work.z = particles.z.data();
  work.u = particles.u.data();
  work.w = particles.w.data();
  work.density = particles.density.data();
  work.spacing = spacing_;
  work.travel = 4 * std::sqrt(fastest) * tau;
  neighbours.over_fluid(loops_->surface, work);
  neighbours.copy_to_images(at_surface_);
  neighbours.over_fluid(loops_->shift, work);
}

void Corrections::extrapolate(const std::function<std::array<double, 2>(std::size_t i)>& gravity, Stage& stage,
                              const Neighbours& neighbours) {
  const std::size_t fluid = neighbours.fluid();
  means_.resize(neighbours.particles() - fluid);
  PairWork work = stage.work(neighbours);
  work.means = means_.data();
  work.first_wall = static_cast<std::int32_t>(fluid);
  neighbours.share(neighbours.fluid_clusters(), neighbours.clusters().size(),
                   [&](std::size_t first, std::size_t last) { loops_->wall_pressure(work, first, last); });
  const auto extrapolated = [&](std::size_t i) {
    const auto [gravity_x, gravity_z] = gravity(i);
    const WallMeans& mean = means_[i - fluid];
    const double pressure = mean.pressure + gravity_x * mean.lever_x + gravity_z * mean.lever_z;
    // Beyond it Tait's law has no density; a run that comes there stops by its own checks.
    return fluid_.density_at(std::max(pressure, -0.99 * fluid_.stiffness()));
  };
  stage.fill(
      [&](std::size_t first, std::size_t count, StateBlock& block) {
        for (std::size_t k = 0; k < count; ++k) {
          const Record& wall = stage.records()[first + k];
          block.x[k] = wall.x;
          block.z[k] = wall.z;
          block.u[k] = wall.u;
          block.w[k] = wall.w;
          block.density[k] = extrapolated(first + k);
        }
      },
      fluid);
}

}  // namespace seiche::wcsph
