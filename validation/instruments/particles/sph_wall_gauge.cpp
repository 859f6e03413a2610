#include "validation/instruments/particles/sph_wall_gauge.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

/// Heights on the face.
constexpr int nodes = 4;

struct Node {
  double z, share;
  double pressures = 0, weights = 0;
};

std::array<Node, nodes> face(const WallGauge& gauge) {
  std::array<Node, nodes> found{};
  for (int k = 0; k < nodes; ++k) {
    const double angle = std::numbers::pi * (k + 1) / (nodes + 1);
    // Shares of all nodes add up to 1.
    found.at(static_cast<std::size_t>(k)) = {.z = gauge.z + 0.5 * gauge.diameter * std::cos(angle),
                                             .share = 2 * std::pow(std::sin(angle), 2) / (nodes + 1)};
  }
  return found;
}

}  // namespace

double pressure_on(const WallGauge& gauge, const Flow& flow) {
  require_not_negative("diameter", gauge.diameter);
  const double h = flow.smoothing_length();
  const bool spline = flow.settings().kernel == KernelName::cubic_spline;
  const Particles& p = flow.particles();
  std::array<Node, nodes> heights = face(gauge);
  for (std::size_t b = 0; b < p.size(); ++b) {
    const double x = gauge.x - p.x[b];
    if (p.kind[b] != Kind::fluid || !(std::abs(x) < support * h) ||
        !(std::abs(gauge.z - p.z[b]) < support * h + 0.5 * gauge.diameter)) {
      continue;
    }
    const double pressure = flow.fluid().pressure(p.density[b]);
    for (Node& node : heights) {
      const double z = node.z - p.z[b];
      const double r = std::hypot(x, z);
      const double w = p.mass[b] / p.density[b] * (spline ? weight<CubicSpline>(r, h) : weight<WendlandC2>(r, h));
      node.pressures += (pressure - p.density[b] * flow.settings().gravity * z) * w;
      node.weights += w;
    }
  }
  double mean = 0;
  for (const Node& node : heights) mean += node.weights > 0 ? node.share * node.pressures / node.weights : 0;
  return mean;
}

}  // namespace seiche::wcsph
