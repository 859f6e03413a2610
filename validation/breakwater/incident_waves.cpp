#include "validation/breakwater/incident_waves.hpp"

#include <array>
#include <cmath>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/breakwater/berm_history.hpp"
#include "validation/breakwater/harmonic.hpp"

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;

double IncidentWaves::piston(double time) const {
  const double z = std::min(1.0, time / rise);
  return half_stroke * z * z * z * z * (35 + z * (-84 + z * (70 - 20 * z))) * std::sin(omega * time);
}

double IncidentWaves::piston_velocity(double time) const {
  const double z = std::min(1.0, time / rise);
  const double r = z * z * z * z * (35 + z * (-84 + z * (70 - 20 * z)));
  const double rate = 140 * std::pow(z * (1 - z), 3) / rise;
  return half_stroke * (rate * std::sin(omega * time) + r * omega * std::cos(omega * time));
}

Antinode antinode_before(const Berm& berm, const SurfaceMode& mode) {
  const auto columns = static_cast<double>(mode.elevation.size() - 1);
  const auto place = [&](std::size_t i) { return berm.length * (static_cast<double>(i) / columns - 1); };
  Antinode found{.place = place(0), .relative = 1};
  for (std::size_t i = 1; i + 1 < mode.elevation.size() && place(i) <= -berm.width - 2; ++i) {
    const double here = mode.elevation[i];
    if (std::abs(here) >= std::abs(mode.elevation[i - 1]) && std::abs(here) >= std::abs(mode.elevation[i + 1])) {
      found = {.place = place(i), .relative = here / mode.elevation.front()};
    }
  }
  return found;
}

TankHistory run_tank(const Berm& basin, const BermResolution& mesh, const IncidentWaves& waves,
                     const Antinode& antinode) {
  const std::size_t columns = mesh.columns(basin);
  const double width = basin.length / static_cast<double>(columns);
  const auto more = static_cast<std::size_t>(std::lround(waves.sea / width));
  Berm tank = basin;
  tank.length += width * static_cast<double>(more);
  Mesh water = tank.mesh(columns + more, mesh.rows);
  water.sides.left = lagrangian_mesh_2d::MovingWall{
      .place = [waves, begin = -tank.length](double t) { return begin + waves.piston(t); },
      .velocity = [waves](double t) { return waves.piston_velocity(t); }};
  Flow flow(std::move(water));
  BermGauge gauge(flow, tank);
  TankHistory history;
  double between = 0;
  march(flow, waves.end, waves.tau, [&] {
    if (const auto reading = gauge.after_step()) {
      history.time.push_back(reading->time);
      history.front.push_back(reading->load.front);
      history.rear.push_back(reading->load.rear);
      history.antinode.push_back(between);
    }
    between = elevation_at(flow, std::array{antinode.place}).front();
  });
  return history;
}

TankHistory::Settled settled(const TankHistory& history, const IncidentWaves& waves, const Antinode& antinode) {
  const auto part = [&](const std::vector<double>& values) {
    return harmonic(history.time, values, waves.omega, waves.settled_periods);
  };
  const std::complex<double> far = part(history.antinode) / antinode.relative;
  return {.antinode = far, .front = part(history.front) / far, .rear = part(history.rear) / far};
}

}  // namespace seiche::validation
