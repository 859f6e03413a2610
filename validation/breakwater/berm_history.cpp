#include "validation/breakwater/berm_history.hpp"

#include <cmath>

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;

BermWave run_berm_wave(const Berm& berm, std::size_t columns, std::size_t rows, const SurfaceMode& mode,
                       const BermRunSettings& settings) {
  const double width = berm.length / static_cast<double>(columns);
  const auto elevation = [&](double x) {
    const auto i = static_cast<std::size_t>(std::lround((x + berm.length) / width));
    return settings.height * mode.elevation[i] / mode.elevation.front();
  };
  BermWave wave{.flow = Flow(berm.mesh(columns, rows, elevation), {}, {}, {.hourglass = settings.hourglass}),
                .history = {}};
  Flow& flow = wave.flow;
  BermHistory& history = wave.history;
  const double still = 0.5 * (1 - berm.rise) * (1 - berm.rise);
  // The mean of two steps' multipliers belongs to the nodes' places between them.
  std::vector<double> y_between(flow.y().begin(), flow.y().end());
  double time_between = 0;
  flow.advance_to(settings.time, settings.tau, [&] {
    if (flow.steps() > 1) {
      BermLoad load = berm_load(flow.model().mesh(), y_between, flow.dynamic_pressure());
      load.rear = flow.wall_load(Flow::WallSide::right).force - still;
      history.time.push_back(time_between);
      history.front.push_back(load.front / settings.height);
      history.rear.push_back(load.rear / settings.height);
      history.total.push_back(load.total() / settings.height);
    }
    y_between.assign(flow.y().begin(), flow.y().end());
    time_between = flow.time();
  });
  return wave;
}

}  // namespace seiche::validation
