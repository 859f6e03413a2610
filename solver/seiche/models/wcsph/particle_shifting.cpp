#include "seiche/models/wcsph/particle_shifting.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seiche/models/wcsph/neighbour_sums.hpp"

namespace seiche::wcsph {
namespace {

constexpr double strength = 4;
constexpr double repulsion = 0.2;
constexpr double surface_divergence = 1.5;
constexpr double longest_shift = 0.1;  ///< over dx

template <class Kernel>
void shift(double spacing, double tau, const Stage& stage, const Neighbours& neighbours, Particles& particles) {
  const std::size_t fluid_clusters = neighbours.fluid_clusters();
  std::vector<double> divergence(stage.mass().size(), 2.0);
  for_each_particle(neighbours, 0, fluid_clusters, [&](std::size_t i, const Cluster& cluster) {
    double sum = 0;
    for_each_neighbour(stage, cluster, i, [&](std::size_t j, double, double, double r, double h) {
      sum -= stage.mass()[j] / stage.records()[j].density * radial_slope<Kernel>(r, h) * r;
    });
    divergence[i] = sum;
  });
  const std::size_t count = particles.size();
  for (std::size_t k = 0; k < neighbours.images().size(); ++k) {
    divergence[count + k] = divergence[static_cast<std::size_t>(neighbours.images()[k].source)];
  }

  double fastest = 0;
  for (std::size_t i = 0; i < neighbours.fluid(); ++i) {
    fastest = std::max(fastest, std::hypot(stage.records()[i].u, stage.records()[i].w));
  }

  // Everything is read from the records, so that particles can be changed at once.
  for_each_particle(neighbours, 0, fluid_clusters, [&](std::size_t i, const Cluster& cluster) {
    const Record& a = stage.records()[i];
    const double usual = weight<Kernel>(spacing, a.smoothing);
    bool surface = false;
    double crowd_x = 0, crowd_z = 0, u_x = 0, u_z = 0, w_x = 0, w_z = 0, density_x = 0, density_z = 0;
    for_each_neighbour(stage, cluster, i, [&](std::size_t j, double x, double z, double r, double h) {
      surface = surface || divergence[j] < surface_divergence;
      if (r == 0) return;
      const Record& b = stage.records()[j];
      const double slope = stage.mass()[j] / b.density * radial_slope<Kernel>(r, h) / r;
      const double close = weight<Kernel>(r, h) / usual;
      const double crowd = slope * (1 + repulsion * close * close * close * close);
      crowd_x += crowd * x;
      crowd_z += crowd * z;
      u_x += slope * (b.u - a.u) * x;
      u_z += slope * (b.u - a.u) * z;
      w_x += slope * (b.w - a.w) * x;
      w_z += slope * (b.w - a.w) * z;
      density_x += slope * (b.density - a.density) * x;
      density_z += slope * (b.density - a.density) * z;
    });
    if (surface) return;
    const double factor = -strength * a.smoothing * fastest * tau;
    const double length = std::abs(factor) * std::hypot(crowd_x, crowd_z);
    const double limit = length > longest_shift * spacing ? longest_shift * spacing / length : 1;
    const double x = limit * factor * crowd_x;
    const double z = limit * factor * crowd_z;
    particles.x[i] += x;
    particles.z[i] += z;
    particles.u[i] += u_x * x + u_z * z;
    particles.w[i] += w_x * x + w_z * z;
    particles.density[i] += density_x * x + density_z * z;
  });
}

}  // namespace

void shift_particles(KernelName kernel, double spacing, double tau, const Stage& stage, const Neighbours& neighbours,
                     Particles& particles) {
  if (kernel == KernelName::cubic_spline) {
    shift<CubicSpline>(spacing, tau, stage, neighbours, particles);
  } else {
    shift<WendlandC2>(spacing, tau, stage, neighbours, particles);
  }
}

}  // namespace seiche::wcsph
