#include "validation/solitary_wave/serre_history.hpp"

namespace seiche::validation {

SerreHistory follow(dispersive_shallow_water_1d::Flow& flow, const SerreWave& wave, double spacing, double tau) {
  SerreHistory history;
  const double energy = flow.energy();
  const double momentum = flow.ledger().entry("momentum_x").initial;
  const auto defect = [&](const std::string& name, double scale) {
    return flow.ledger().entry(name).largest_defect / scale;
  };
  march(flow, wave.time, stable_steps(flow, tau), [&] {
    flow.observe();
    const SerreErrors errors = errors_of(flow, wave);
    history.time.push_back(flow.time());
    history.crest.push_back(errors.crest / wave.amplitude);
    history.phase.push_back(errors.phase);
    history.energy.push_back(defect("energy", energy));
    history.volume.push_back(defect("volume_worst", wave.depth * spacing));
    history.momentum.push_back(defect("momentum_x", momentum));
  });
  return history;
}

void draw_defects(evidence::Panel& panel, const std::string& label, const SerreHistory& history,
                  std::vector<double> SerreHistory::*quantity) {
  std::vector<double> time;
  std::vector<double> defect;
  for (std::size_t k = 0; k < history.time.size(); ++k) {
    if ((history.*quantity)[k] <= 0) continue;
    time.push_back(history.time[k]);
    defect.push_back((history.*quantity)[k]);
  }
  panel.line(label, time, defect, evidence::Role::computed);
}

}  // namespace seiche::validation
