// A solitary wave on coarse hexahedra keeps its amplitude, and its speed is the better the more layers there are.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::lagrangian_mesh_3d_soliton_test {

using namespace lagrangian_mesh_3d;

constexpr double amplitude = 0.3;
const double celerity = std::sqrt(1 + amplitude);
const double decay = std::sqrt(0.75 * amplitude / (1 + amplitude));

double elevation(double x) {
  return amplitude / std::pow(std::cosh(decay * x), 2);
}

/// Where the material column that was at `label` in still water stands in the wave at x = 0: x + int eta dx = label.
double place_of(double label) {
  double x = label;
  for (int n = 0; n < 50; ++n) {
    x -= (x + amplitude / decay * std::tanh(decay * x) - label) / (1 + elevation(x));
  }
  return x;
}

/// The wave of the Green-Naghdi equations on columns of equal volume.
Flow solitary_flow(std::size_t layers, double h, double begin, double end) {
  const auto columns = static_cast<std::size_t>(std::lround((end - begin) / h));
  Mesh mesh =
      layer_mesh({.begin = begin, .end = end, .south = 0, .north = h, .columns = columns, .rows = 1, .layers = layers});
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    mesh.x[k] = place_of(mesh.x[k]);
    mesh.z[k] += elevation(mesh.x[k]) * (1 + mesh.z[k]);
  }
  const auto velocity = [](Place r) {
    const double eta = elevation(r.x);
    const double u = celerity * eta / (1 + eta);
    const double slope = -2 * decay * std::tanh(decay * r.x) * eta;
    return Vector{u, 0, (u - celerity) * slope * (1 + r.z) / (1 + eta)};
  };
  return Flow(std::move(mesh), velocity, {}, {.tolerance = 1e-9});
}

struct Crest {
  double place, elevation;
};

/// Top of the parabola through the highest node and its neighbours.
Crest crest(const Flow& flow) {
  const auto x = flow.surface_x();
  const auto z = flow.surface_z();
  const std::size_t last = flow.shape().columns;
  const auto i = static_cast<std::size_t>(
      std::max_element(z.begin() + 1, z.begin() + static_cast<std::ptrdiff_t>(last)) - z.begin());
  const double left = (z[i] - z[i - 1]) / (x[i] - x[i - 1]);
  const double curvature = ((z[i + 1] - z[i]) / (x[i + 1] - x[i]) - left) / (x[i + 1] - x[i - 1]);
  const double top = 0.5 * (x[i] + x[i - 1] - left / curvature);
  return {top, z[i] + (top - x[i]) * (left + curvature * (top - x[i - 1]))};
}

/// Slope of the straight line through points, by least squares.
double slope(const std::vector<double>& t, const std::vector<double>& y) {
  const auto n = static_cast<double>(t.size());
  double st = 0, sy = 0, stt = 0, sty = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    st += t[k];
    sy += y[k];
    stt += t[k] * t[k];
    sty += t[k] * y[k];
  }
  return (n * sty - st * sy) / (n * stt - st * st);
}

TEST_CASE("a solitary wave on coarse hexahedra travels without change", "[dispersion]") {
  Check check(
      "lagrangian_mesh_3d_soliton", "Solitary wave on coarse hexahedra",
      "The solitary wave of the Green-Naghdi equations, amplitude 0.3, starts on columns of equal volume half a depth "
      "wide, with one, two and three layers, and runs to t = 100, over a hundred depths. It sheds what is not the "
      "mesh's own solitary wave and goes on unchanged: mean amplitude and speed of the second half.");
  struct Expected {
    std::size_t layers;
    double amplitude, speed;
  };
  const double h = 0.5;
  const double tau = 0.2;
  auto& figure =
      check.figure("crest", "Crest of a solitary wave on coarse hexahedra", "Elevation of the crest in time.");
  auto& panel = figure.panel({.x = "t sqrt(g/H)", .y = "crest / H"});
  for (const Expected& expected :
       {Expected{1, 0.2656, 1.1241}, Expected{2, 0.2925, 1.1360}, Expected{3, 0.3014, 1.1392}}) {
    Flow flow = solitary_flow(expected.layers, h, -30, 150);
    std::vector<double> all_times, all_tops, times, places, tops;
    const double energy = flow.energy();
    Worst energy_defect;
    march(flow, 100, tau, [&] {
      const Crest top = crest(flow);
      energy_defect.add(flow.energy() / energy - 1);
      all_times.push_back(flow.time());
      all_tops.push_back(top.elevation);
      if (flow.time() < 50) return;
      times.push_back(flow.time());
      places.push_back(top.place);
      tops.push_back(top.elevation);
    });
    double mean = 0;
    for (const double top : tops) mean += top / static_cast<double>(tops.size());
    const double speed = slope(times, places);
    const std::string id = fmt::format("{}-layers", expected.layers);
    panel.line(id, all_times, all_tops, Role::data);
    check.holds(id + ": mean amplitude.", {mean},
                Bound{0.0005,
                      "four digits, and the choice of the curve through the crest, which lies up to h^2/8 of its "
                      "curvature from the nodes",
                      expected.amplitude});
    check.holds(id + ": speed.", {speed},
                Bound{0.0005, "four digits, and the place of the crest, up to a tenth of a cell over 50 depths of way",
                      expected.speed});
    check.holds(id + ": no energy is lost.", {energy_defect.value()},
                Bound{2e-3, "(omega tau)^2/8 of the wave's shortest parts, omega = 0.6: bounded"});
  }
}

}  // namespace seiche::verification::lagrangian_mesh_3d_soliton_test
