#include "seiche/models/wcsph/density_diffusion.hpp"

#include <cmath>

#include "seiche/models/wcsph/neighbour_sums.hpp"

namespace seiche::wcsph {
namespace {

/// Below it the matrix of a particle, 1 inside the fluid, is taken as singular: 4 of about 20 neighbours on one side.
constexpr double least_determinant = 1e-2;

}  // namespace

DensityDiffusion::DensityDiffusion(const Settings& settings)
    : strength_(settings.density_diffusion * settings.sound_speed), kernel_(settings.kernel) {}

void DensityDiffusion::add(const Stage& stage, const Neighbours& neighbours, std::vector<double>& ddensity) {
  if (strength_ == 0) return;
  if (kernel_ == KernelName::cubic_spline) {
    gradients<CubicSpline>(stage, neighbours);
    diffuse<CubicSpline>(stage, neighbours, ddensity);
  } else {
    gradients<WendlandC2>(stage, neighbours);
    diffuse<WendlandC2>(stage, neighbours, ddensity);
  }
}

template <class Kernel>
void DensityDiffusion::gradients(const Stage& stage, const Neighbours& neighbours) {
  gradients_.resize(stage.mass().size());
  for_each_particle(neighbours, 0, neighbours.fluid_clusters(), [&](std::size_t i, const Cluster& cluster) {
    const double density = stage.records()[i].density;
    double xx = 0, xz = 0, zx = 0, zz = 0, difference_x = 0, difference_z = 0;
    for_each_neighbour(stage, cluster, i, [&](std::size_t j, double x, double z, double r, double h) {
      if (r == 0 || !neighbours.is_fluid(j)) return;
      const double volume_slope = stage.mass()[j] / stage.records()[j].density * radial_slope<Kernel>(r, h) / r;
      const double gradient_x = volume_slope * x;
      const double gradient_z = volume_slope * z;
      const double difference = stage.records()[j].density - density;
      xx -= x * gradient_x;
      xz -= x * gradient_z;
      zx -= z * gradient_x;
      zz -= z * gradient_z;
      difference_x += difference * gradient_x;
      difference_z += difference * gradient_z;
    });
    // sum V (rho_b - rho_a) grad_j W = g_i sum V (r_ba)_i grad_j W.
    const double determinant = xx * zz - xz * zx;
    gradients_[i] = determinant < least_determinant ? Gradient{0, 0}
                                                    : Gradient{(zz * difference_x - zx * difference_z) / determinant,
                                                               (xx * difference_z - xz * difference_x) / determinant};
  });
  const std::size_t particles = neighbours.order().size();
  for (std::size_t k = 0; k < neighbours.images().size(); ++k) {
    gradients_[particles + k] = gradients_[static_cast<std::size_t>(neighbours.images()[k].source)];
  }
}

template <class Kernel>
void DensityDiffusion::diffuse(const Stage& stage, const Neighbours& neighbours, std::vector<double>& ddensity) const {
  for_each_particle(neighbours, 0, neighbours.fluid_clusters(), [&](std::size_t i, const Cluster& cluster) {
    const double density = stage.records()[i].density;
    double sum = 0;
    for_each_neighbour(stage, cluster, i, [&](std::size_t j, double x, double z, double r, double h) {
      if (r == 0 || !neighbours.is_fluid(j)) return;
      const double other = stage.records()[j].density;
      const double slope = radial_slope<Kernel>(r, h) / r;
      // psi . grad W = slope (steep - linear), r_ba = -r_ab.
      const double steep = -2 * (other - density);
      const double linear = (gradients_[i].x + gradients_[j].x) * x + (gradients_[i].z + gradients_[j].z) * z;
      sum += h * stage.mass()[j] / other * slope * (steep - linear);
    });
    ddensity[i] += strength_ * sum;
  });
}

}  // namespace seiche::wcsph
