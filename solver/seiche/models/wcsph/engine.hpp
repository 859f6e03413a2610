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
  /// See FlowState.
  [[nodiscard]] std::vector<double> parameters(double time) const;
  void check_state(const FlowState& state) const;
  void adopt(const FlowState& state);
  void sort(double reserve);
  void check_extent() const;
  template <class SomeRecord>
  void list(double reserve);
  void fill_level();
  void evaluate(double time, bool limited);
  void evaluate_level(bool limited);
  [[nodiscard]] double step_by_rule() const;
  void finish_step(double tau);
  /// Where paddles are at one instant.
  struct PaddlePoses {
    std::vector<Pose> pose, rate;
  };
  [[nodiscard]] PaddlePoses paddles_at(double time) const;
  [[nodiscard]] PointMotion carried_by_paddle(std::size_t i, const PaddlePoses& poses) const;
  /// Level n and tau times the rates; particles of paddles as they are carried then.
  void moved(double tau, const PaddlePoses& poses, std::size_t first, std::size_t count, StateBlock& to) const;
  double fill_moved(double tau);
  void commit(double tau);
  void rearrange(double tau);
  [[noreturn]] void report_bad_state(double tau, const PaddlePoses& poses) const;

  Settings settings_;
  double spacing_;
  TaitFluid fluid_;
  double smoothing_;  ///< h_0
  std::vector<Paddle> paddles_;
  Particles particles_;                            ///< level n
  std::vector<double> reference_x_, reference_z_;  ///< of paddle particles, in the pose {0, 0}; empty without paddles
  double mean_spacing_;
  ExtrapolatedWalls walls_;
  RightHandSide rates_;
  ParticleShifting shifting_;
  Stage stage_;
  Neighbours neighbours_;
  double reserve_;          ///< of the lists [m]
  double listed_reserve_;   ///< of the present lists
  double half_travel_ = 0;  ///< what half a step is going to use, by the last one
  Extremes extremes_;
  double time_ = 0;
  long steps_ = 0;
};

}  // namespace seiche::wcsph
