#include "validation/breakwater/berm_history.hpp"

#include <cmath>

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;

BermGauge::BermGauge(const Flow& flow, const Berm& berm)
    : flow_(&flow),
      still_(0.5 * (1 - berm.rise) * (1 - berm.rise)),
      y_between_(flow.y().begin(), flow.y().end()),
      time_between_(flow.time()) {}

std::optional<BermGauge::Reading> BermGauge::after_step() {
  std::optional<Reading> reading;
  if (const auto wall = wall_.read(*flow_)) {
    reading = {.time = time_between_, .load = berm_load(flow_->model().mesh(), y_between_, flow_->dynamic_pressure())};
    reading->load.rear = wall->force - still_;
  }
  y_between_.assign(flow_->y().begin(), flow_->y().end());
  time_between_ = flow_->time();
  return reading;
}

void draw_forces(evidence::Panel& panel, const BermHistory& history) {
  panel.line("front", history.time, history.front, evidence::Role::computed);
  panel.line("rear", history.time, history.rear, evidence::Role::peer);
  panel.line("total", history.time, history.total, evidence::Role::exact);
}

BermWave run_berm_wave(const Berm& berm, const BermResolution& mesh, const SurfaceMode& mode,
                       const BermRunSettings& settings, const FlowWatcher& watch) {
  const double width = berm.length / static_cast<double>(mesh.columns(berm));
  const auto elevation = [&](double x) {
    const auto i = static_cast<std::size_t>(std::lround((x + berm.length) / width));
    return settings.height * mode.elevation[i] / mode.elevation.front();
  };
  BermWave wave{.flow = Flow(mesh.mesh(berm, elevation))};
  Flow& flow = wave.flow;
  if (settings.rezone > 0) flow.keep_upright(settings.rezone);
  BermHistory& history = wave.history;
  BermGauge gauge(flow, berm);
  watch(flow);
  march(flow, settings.time, settings.tau, [&] {
    if (const auto reading = gauge.after_step()) {
      history.time.push_back(reading->time);
      history.front.push_back(reading->load.front / settings.height);
      history.rear.push_back(reading->load.rear / settings.height);
      history.total.push_back(reading->load.total() / settings.height);
    }
    watch(flow);
  });
  return wave;
}

}  // namespace seiche::validation
