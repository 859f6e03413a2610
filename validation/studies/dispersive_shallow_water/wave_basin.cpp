#include "validation/studies/dispersive_shallow_water/wave_basin.hpp"

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <utility>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "validation/instruments/plan/plan_gauges.hpp"
#include "validation/instruments/plan/water_surface.hpp"
#include "validation/instruments/wave_source.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::laboratory {
namespace {

constexpr double gravity = 9.81;
constexpr double ramp = 2;           // periods
constexpr double lattice_rate = 20;  // [1/s], above what steep waves of 1 s make the lattice's pattern grow at

}  // namespace

double paddle_velocity(const PaddleWaves& waves) {
  const double omega = 2 * std::numbers::pi / waves.period;
  const double nu = omega * omega * waves.depth / gravity;
  const double kh = wavenumber(waves.depth, waves.period, gravity, improved) * waves.depth;
  const double of_markers = waves.amplitude / dispersive_shallow_water_1d::surface_of_wave(improved, kh);
  return of_markers * omega / kh * (1 + improved * std::pow(kh, 4) / nu);
}

dispersive_shallow_water_2d::Flow basin_flow(const Basin& basin, const PaddleWaves& waves) {
  const auto bottom = std::make_shared<SplineBottom>(SplineBottom::sampled({.begin = basin.begin - 3 * basin.raster,
                                                                            .end = basin.end + basin.raster,
                                                                            .south = basin.south - basin.raster,
                                                                            .north = basin.north + basin.raster,
                                                                            .spacing = basin.raster},
                                                                           basin.bottom));
  const auto cells = [&](double length) { return static_cast<std::size_t>(std::ceil(length / basin.spacing - 1e-9)); };
  const plan_lattice::DrivenSide paddle{
      [largest = paddle_velocity(waves), period = waves.period](plan_lattice::Place, double time) {
        const double grown =
            time < ramp * period ? std::pow(std::sin(0.5 * std::numbers::pi * time / (ramp * period)), 2) : 1;
        return Point{largest * grown * std::sin(2 * std::numbers::pi * time / period), 0};
      }};
  const auto absorption = [basin](Point at) {
    const double within = (at.x - basin.absorbed_from) / (basin.end - basin.absorbed_from);
    return within > 0 ? basin.absorption * within * within : 0.0;
  };
  return dispersive_shallow_water_2d::Flow(
      dispersive_shallow_water_2d::rectangular_lattice({.begin = basin.begin,
                                                        .end = basin.end,
                                                        .south = basin.south,
                                                        .north = basin.north,
                                                        .columns = cells(basin.end - basin.begin),
                                                        .rows = cells(basin.north - basin.south),
                                                        .sides = {.west = paddle},
                                                        .bottom = bottom}),
      {}, {},
      {.gravity = gravity,
       .inertia = 1.0 / 3 + improved,
       .gamma = improved,
       .tolerance = 1e-8,
       .drag = {.lattice_rate = lattice_rate, .absorption = absorption}});
}

std::vector<std::vector<double>> harmonics_at(dispersive_shallow_water_2d::Flow& flow, const std::vector<Point>& places,
                                              std::size_t orders, double period, long steps, long periods) {
  PlanGauges gauges(flow.shape(), places);
  WaterSurface surface(flow.shape(), flow.model().settings().gamma);
  std::vector<std::vector<std::complex<double>>> sums(orders, std::vector<std::complex<double>>(places.size()));
  const long samples = steps * periods;
  for (long sample = 0; sample < samples; ++sample) {
    flow.advance(period / static_cast<double>(steps));
    const std::span<const double> eta = gauges.read({flow.x(), flow.y(), surface.read(flow)});
    for (std::size_t order = 0; order < orders; ++order) {
      const double phase = 2 * std::numbers::pi * static_cast<double>(order + 1) * static_cast<double>(sample % steps) /
                           static_cast<double>(steps);
      const std::complex<double> turn = std::polar(2.0 / static_cast<double>(samples), -phase);
      for (std::size_t k = 0; k < places.size(); ++k) sums[order][k] += eta[k] * turn;
    }
  }
  std::vector<std::vector<double>> amplitudes(orders);
  for (std::size_t order = 0; order < orders; ++order) {
    for (const std::complex<double>& sum : sums[order]) amplitudes[order].push_back(std::abs(sum));
  }
  return amplitudes;
}

}  // namespace seiche::validation::laboratory
