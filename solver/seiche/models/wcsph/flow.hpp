/// Weakly compressible smoothed particle hydrodynamics in a vertical plane, with and without sub-particle-scale
/// turbulence.
///
/// @f[ \frac{d\rho_a}{dt} = \sum_b m_b \, \mathbf{u}_{ab} \cdot \nabla W_{ab} \tag{2} @f]
/// @f[ \frac{d\mathbf{u}_a}{dt} = -\sum_b m_b \left( \frac{P_a}{\rho_a^2} + \frac{P_b}{\rho_b^2} + \Pi_{ab} \right)
///                                \nabla W_{ab} + \mathbf{g} \tag{3} @f]
/// @f[ \frac{d\mathbf{r}_a}{dt} = \mathbf{u}_a - \epsilon \sum_b \frac{m_b}{\rho_{ab}} \mathbf{u}_{ab} W_{ab}
///     \tag{6} @f]
///
/// with Pi_ab the artificial viscosity or, in its place, laminar viscosity and the stress of unresolved eddies (4), the
/// equation of state of settings.hpp, h_ab the mean of both smoothing lengths, and the explicit midpoint rule
/// (7), (8). Walls are dynamic particles: they obey (2) and (5) and stand where they are, or go with a paddle. Mass is
/// constant; momentum of a free body is conserved to round-off; angular momentum and energy by the equations in
/// continuous time, by the steps to their order.
///
///     Flow flow(dam.particles(), dam.spacing, {.sound_speed = 15, .viscosity = ArtificialViscosity{0.3}});
///     march(flow, 0.25);
///
/// Evaluation: particles are kept sorted in tiles, so that few consecutive ones (a cluster, one SIMD register) share a
/// list of candidates within 2h and a skin. Every particle gathers its own sums: no write conflicts, the same bytes
/// from any number of threads.
///
/// When not to use it: incompressible flow to more than about a per cent; pressures at walls without
/// WallPressure::extrapolated and density diffusion; vortices at Reynolds numbers above
/// about 30 without particle shifting.
///
/// References: Monaghan (1994), cited in settings.hpp; Dalrymple and Rogers, Numerical modeling of water waves
/// with the SPH method, Coastal Eng. 53 (2006) 141; Lo and Shao, Simulation of near-shore solitary wave mechanics by an
/// incompressible SPH method, Appl. Ocean Res. 24 (2002) 275 (SPS); Colagrossi and Landrini (2003) J. Comput. Phys. 191
/// (density filter).
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "seiche/model.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/right_hand_side.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

/// Sums over the fluid; energies per unit width [J/m].
struct Totals {
  double mass = 0;
  std::array<double, 2> momentum{};
  double angular_momentum = 0;   ///< sum m (x w - z u)
  double absolute_momentum = 0;  ///< sum m |u|, the scale of rounding
  double kinetic = 0;
  double elastic = 0;
  double potential = 0;  ///< sum m g z
  [[nodiscard]] double energy() const { return kinetic + elastic + potential; }
};

/// Largest and smallest values of the run so far, and counts of what happened.
struct Extremes {
  double mach = 0;  ///< max |u|/c_0 of the fluid: above 0.1 the rule for c_0 was violated
  double lowest_density = std::numeric_limits<double>::infinity();  ///< of the fluid, over rho_0
  double highest_density = 0;
  long rebuilds = 0;           ///< sortings with new candidate lists
  long long interactions = 0;  ///< ordered pairs within the support, at rebuilds, times evaluations since: useful work
};

struct FlowState;

class Flow {
 public:
  /// @param particles  fluid and walls, at time 0; order is free
  /// @param spacing    dx [m], which h_0 and the filter of the turbulence model refer to
  /// Throws std::invalid_argument: settings out of range, values not finite or not positive, two fluid particles closer
  /// than 1e-6 dx, a fluid particle nearer than dx/2 to a wall's, a period shorter than three supports, a paddle
  /// particle without its paddle.
  Flow(Particles particles, double spacing, Settings settings, std::vector<Paddle> paddles = {});
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;
  Flow(Flow&&) noexcept = default;
  Flow& operator=(Flow&&) noexcept = default;
  ~Flow() = default;

  /// One step of length tau > 0. Throws std::invalid_argument for tau and seiche::Divergence, with time, step and
  /// place: values not finite, density outside [0.5, 1.5] rho_0, too many neighbours. particles() then still holds the
  /// last good state.
  void advance(double tau);
  void arrive(double time) { time_ = time; }
  /// Length of the next step by the rule. Evaluates the rates that this step begins with. Throws seiche::Divergence
  /// where it is below 1e-3 of the acoustic one.
  [[nodiscard]] double stable_step();

  /// Everything that decides how it goes on.
  [[nodiscard]] FlowState state() const;
  /// Goes on from the state of a Flow that was made of the same particles, settings and paddles: the same bytes as
  /// that one would have given. Throws std::invalid_argument, with the parameter and both its values, where it was of
  /// others: settings, spacing, particles by identity, paddles by where they were. A throw leaves the flow as it was.
  void resume(const FlowState& state);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] double smoothing_length() const { return smoothing_; }  ///< h_0 [m]
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const TaitFluid& fluid() const { return fluid_; }
  /// Particles in the order of the last sorting: `identity` says which is which.
  [[nodiscard]] const Particles& particles() const { return particles_; }
  /// Pressure of each particle [Pa].
  [[nodiscard]] std::vector<double> pressure() const;
  /// Right-hand sides at the present state, for checks.
  [[nodiscard]] Rates rates();
  [[nodiscard]] Totals totals() const;
  /// Of a free body: what walls, paddles, gravity and viscosity do is not booked.
  [[nodiscard]] std::vector<Invariant> invariants() const;
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }
  /// Fluid particles outside the rectangle: left the domain. Nothing is deleted.
  [[nodiscard]] long outside(double left, double right, double bottom, double top) const;

 private:
  void check_start() const;
  /// See FlowState.
  [[nodiscard]] std::vector<double> parameters(double time) const;
  void check_state(const FlowState& state) const;
  void adopt(const FlowState& state);
  void sort(double reserve);
  /// Lists of particles that are in their order, of whose reserve so much is used up.
  void list(double reserve, double used);
  /// Records are those of the particles, here and between all steps.
  void refresh_lists();
  void evaluate(double time, bool limited);
  void evaluate_level(bool limited);
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
  RightHandSide rates_;
  Corrections corrections_;
  Stage stage_;
  Neighbours neighbours_;
  double reserve_;         ///< of the lists [m]
  double listed_reserve_;  ///< of the present lists
  long long listed_pairs_ = 0;
  double half_travel_ = 0;  ///< what half a step is going to use, by the last one
  Extremes extremes_;
  double time_ = 0;
  long steps_ = 0;
  bool level_known_ = false;  ///< whether rates_ are those of the present state
};

// All that decides how a Flow goes on, to the last bit: to be kept, and given to Flow::resume() of a Flow that was
// made of the same particles, settings and paddles.

struct FlowState {
  /// What the flow was made of besides its particles: settings, spacing, and paddles by their poses at `time`.
  std::vector<double> parameters;
  Particles particles;                           ///< in the order of the last sorting
  std::vector<double> reference_x, reference_z;  ///< of what paddles carry, in the pose {0, 0}; empty without paddles
  /// Of the candidate lists, which decide when particles are sorted next.
  struct Listed {
    double reserve = 0, used = 0;  ///< [m]
    long long pairs = 0;           ///< within the support when they were made
  } listed;
  double half_travel = 0;  ///< what half a step is going to use of the reserve, by the last one [m]
  double time = 0;
  long steps = 0;
  Extremes extremes;
};

}  // namespace seiche::wcsph
