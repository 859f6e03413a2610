/// What Flow consists of; internal.
#pragma once

#include <limits>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/flow_state.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/particle_shifting.hpp"
#include "seiche/models/wcsph/right_hand_side.hpp"
#include "seiche/models/wcsph/stage.hpp"
#include "seiche/models/wcsph/wall_pressure.hpp"

namespace seiche::wcsph {

/// A step this much shorter than the acoustic one means that the run has broken down.
inline constexpr double shortest_step = 1e-3;
/// Of the limit of a step by viscosity, dt <= 0.125 h^2/nu_0.
inline constexpr double viscous_courant = 0.125;

class Flow::Engine {
 public:
  Engine(Particles particles, double spacing, const Settings& settings, std::vector<Paddle> paddles);

  /// One step of length `tau`.
  void advance_by(double tau);
  /// One step of the rule's length, at most `longest`; returns it.
  double advance_at_most(double longest);
  void set_time(double time) { time_ = time; }
  [[nodiscard]] FlowState state() const;
  void resume(const FlowState& state);
  /// Rates at level n.
  [[nodiscard]] Rates rates();

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] double smoothing_length() const { return smoothing_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const TaitFluid& fluid() const { return fluid_; }
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }

 private:
  void check_start() const;
  void sort(double reserve);
  void fill_level();
  void evaluate(double time, std::vector<double>& density, bool limited);
  void evaluate_level(bool limited);
  [[nodiscard]] double step_by_rule() const;
  void finish_step(double tau);
  void move(double tau);
  void place_paddles(double time, std::vector<double>& x, std::vector<double>& z, std::vector<double>& u,
                     std::vector<double>& w) const;
  void commit(double tau);
  void rearrange(double tau);
  [[noreturn]] void report_bad_state() const;

  Settings settings_;
  double spacing_;
  TaitFluid fluid_;
  double smoothing_;  ///< h_0
  std::vector<Paddle> paddles_;
  Particles particles_;                            ///< level n
  std::vector<double> reference_x_, reference_z_;  ///< of paddle particles, in the pose {0, 0}
  std::vector<double> scratch_;
  double mean_spacing_;
  ExtrapolatedWalls walls_;
  RightHandSide rates_;
  ParticleShifting shifting_;
  Stage stage_;
  Neighbours neighbours_;
  State next_;                ///< what the step is moving to
  double reserve_;            ///< of the lists [m]
  FlowState::Listed listed_;  ///< what the present lists were made of
  double used_ = 0;           ///< of it, at level n
  double half_travel_ = 0;    ///< what half a step is going to use, by the last one
  Extremes extremes_;
  double time_ = 0;
  long steps_ = 0;
};

}  // namespace seiche::wcsph
