/// Conservative particle method for the one-dimensional shallow-water equations
///
/// @f[ \frac{\partial h}{\partial t} + \frac{\partial (h u)}{\partial x} = 0 @f]
/// @f[ \frac{\partial (h u)}{\partial t} + \frac{\partial}{\partial x} \left( h u^2 + \frac{g h^2}{2} \right)
///     = -g h \frac{\partial z}{\partial x} + h f(x, t) - g n^2 \frac{u |u|}{h^{1/3}} @f]
///
/// Particle i is the water between edges X_i < X_(i+1); it keeps its mass m_i. Each edge k gets one velocity u*_k and
/// one thrust p*_k = g h*^2/2 per step, and with a bed reaction R_i
///
/// @f[ X_k \leftarrow X_k + \tau u^*_k, \qquad m_i u_i \leftarrow m_i u_i + \tau (p^*_i - p^*_{i+1} + R_i) @f]
///
/// Whatever u* and p* are, mass is exact, and momentum changes by booked impulses only. In the rules of Bogomolov,
/// Zakharov and Zerkal (overlap: rebuild the particle of smaller density; gap: rebuild the faster one) the shared edge
/// takes the velocity of the particle that is not rebuilt; here u* and p* come from one Riemann problem, and "the jump
/// is handed from one particle to the next" holds for momentum as well as for mass (collision.hpp).
///
///     ParticleFlow flow(equal_widths(...), {Wall{}, Vacuum{}});
///     march(flow, 3);
///
/// Long rows (linear/worth_threads.hpp) take all threads, unless a bed or a body force is to be asked; results are the
/// same bits for any number.
///
/// When not to use it: flows that dry out in the middle (particles always touch), and Galilean-fixed meshes.
///
/// Sources: Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, formulas (1)-(11);
/// Toro, Shock-capturing methods for free-surface shallow flows (2001).
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/model.hpp"
#include "seiche/models/shallow_water_particles/collision.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/models/shallow_water_particles/reconstruction.hpp"
#include "seiche/models/shallow_water_particles/row_kernels.hpp"
#include "seiche/ranges.hpp"
#include "seiche/samples.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

// Choices of the conservative particle method that do not change the equations, what happens at the two ends of a row
// of particles, what acts on all of it, and its books.

/// How an edge between two particles gets its velocity and pressure.
enum class Level {
  godunov,  ///< G1: Riemann problem of the two particle means; first order, a jump is 3-4 particles wide
  muscl,    ///< M2: limited linear reconstruction and a half-step predictor; second order, a jump is 1-3 particles wide
  hand_over  ///< H2: M2 with the jump kept inside one particle and handed from one to the next; isolated jumps are
             ///< exact
};

inline constexpr double hard_courant = 0.9;  ///< tau c / w of a step that is not refused

/// Numerical parameters with the values recommended for all flows.
struct Scheme {
  Level level = Level::hand_over;
  double theta = 2;      ///< generalised minmod: 1 most dissipative, 2 monotonised central
  double courant = 0.4;  ///< largest tau c / w that largest_step() proposes

  static constexpr auto ranges() {
    return std::array{Number{"theta", &Scheme::theta, Range::within(1, 2)},
                      Number{"courant", &Scheme::courant, Range{0, hard_courant, true}}};
  }
};

/// Smallest relative depth jump that is handed over.
inline constexpr double jump_threshold = 0.02;

/// Fixed wall.
struct Wall {};

/// Wall moving with velocity(t) [m/s]. A piston at the inflow velocity is the way to let a uniform stream enter: the
/// whole domain translates, and nothing needs to be injected before a disturbance arrives at it.
struct Piston {
  std::function<double(double)> velocity;
};

/// The uniform state of the end particle continues outside.
struct Free {};

/// Dry bed outside: a front on a flat bed, a shoreline on an uneven one.
struct Vacuum {};

/// Fixed section that water passes, in either direction. The end particle keeps one edge there, grows or shrinks by the
/// mass that passes, and is split or merged with its neighbour when its width leaves (1/2, 2) of the initial one.
///
/// Give the discharge for a subcritical inlet, the depth for a subcritical outlet, both for a supercritical inlet and
/// neither for a supercritical outlet; what is not given follows from the characteristic that leaves the flow.
struct Open {
  std::function<double(double)> discharge;  ///< h u(t) [m^2/s], positive along +x
  std::function<double(double)> depth;      ///< h(t) [m]
};

using End = std::variant<Wall, Piston, Free, Vacuum, Open>;

struct Ends {
  End left = Wall{};
  End right = Wall{};
};

/// What acts on the water: gravity [m/s^2], an uneven bed, Manning friction n [s/m^(1/3)], a body force f(x,t) [m/s^2].
struct Forcing {
  double gravity = 9.81;
  std::optional<Bed> bed;
  double manning = 0;
  std::function<double(double, double)> body_force;

  static constexpr auto ranges() {
    return std::array{Number{"gravity", &Forcing::gravity, Range::positive()},
                      Number{"manning", &Forcing::manning, Range::not_negative()}};
  }
};

/// Impulses on the water per unit width and density [m^3/s], positive along +x, since the start of the run; inflows of
/// mass [m^2] count positive into the domain.
struct Ledger {
  double initial_mass = 0;
  double initial_momentum = 0;
  CompensatedSum left_impulse;
  CompensatedSum right_impulse;
  CompensatedSum bed_impulse;
  CompensatedSum friction_impulse;
  CompensatedSum source_impulse;
  CompensatedSum left_mass;
  CompensatedSum right_mass;

  [[nodiscard]] double booked_impulse() const {
    return left_impulse.value() + right_impulse.value() + bed_impulse.value() + friction_impulse.value() +
           source_impulse.value();
  }
  [[nodiscard]] double booked_mass() const { return left_mass.value() + right_mass.value(); }
};

using shallow_water::MeasuredProfile;

/// The largest admissible step and who limits it.
struct StepLimit {
  double tau = std::numeric_limits<double>::infinity();
  std::size_t particle = 0;
  std::string_view reason;  ///< "celerity", "jump in the particle", "edges would cross", an end that would cross it
};

/// Counters of events that a report may want.
struct Events {
  long collisions = 0;          ///< meetings of two jumps that were followed exactly
  long adjacent_discarded = 0;  ///< jumps dropped because their neighbour held a larger one of the same facing
  /// Largest part of their mass that, of such particles, seemed to lie on the far side of the jump: it is the same one,
  /// seen from a particle that it has just left or not yet entered and whose mean differs a little from the state
  /// beside the jump because the water there is not uniform. Without a sample where none was dropped.
  Largest discarded_inside = {};
};

class ParticleFlow {
 public:
  /// Throws std::invalid_argument for particles that do not validate, an inconsistent bed, non-positive gravity,
  /// parameters of `scheme` out of range, a piston without a velocity, or a wall or piston that leaves the water faster
  /// than it can follow.
  ParticleFlow(Particles initial, Ends ends = {}, Forcing forcing = {}, Scheme scheme = {});

  /// One step. Throws std::invalid_argument, before anything changes, when tau is not positive or exceeds the limits
  /// tau c/w <= 0.9, tau <= 0.8 m/M for a jump in a particle, tau <= 0.8 w/(u_i - u_(i+1)), also towards a
  /// wall, piston or fixed section, and when a wall or piston leaves
  /// the water, with 2 c or faster: beside it the bed would fall dry. The message names the particle.
  /// Throws seiche::Divergence when edges cross or a value is not finite after the step.
  void advance(double tau);

  void arrive(double time) { time_.add(time - time_.value()); }

  /// Largest step at the scheme's Courant number.
  [[nodiscard]] double stable_step() const { return step_limit(scheme_.courant, false).tau; }
  /// The same, and who limits it.
  [[nodiscard]] StepLimit largest_step() const { return step_limit(scheme_.courant, true); }

  [[nodiscard]] const Particles& particles() const { return now_; }
  [[nodiscard]] double time() const { return time_.value(); }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] const Ledger& ledger() const { return ledger_; }
  [[nodiscard]] const Events& events() const { return events_; }
  [[nodiscard]] const Scheme& scheme() const { return scheme_; }
  [[nodiscard]] const Forcing& forcing() const { return forcing_; }
  /// Largest tau c/w of all steps so far.
  [[nodiscard]] double largest_courant() const { return largest_courant_; }

  [[nodiscard]] double mass() const { return compensated_sum(now_.mass); }                    ///< total [m^2]
  [[nodiscard]] double momentum() const { return total_momentum(now_.mass, now_.velocity); }  ///< total [m^3/s]
  [[nodiscard]] double mass_defect() const { return mass() - ledger_.initial_mass - ledger_.booked_mass(); }
  [[nodiscard]] double momentum_defect() const {
    return momentum() - ledger_.initial_momentum - ledger_.booked_impulse();
  }
  [[nodiscard]] std::vector<Invariant> invariants() const {
    return {{"mass", mass(), ledger_.booked_mass()}, {"momentum_x", momentum(), ledger_.booked_impulse()}};
  }

  /// Energy sum of m u^2/2 + g h^2 w/2 + g m z [m^4/s^2]; a particle that holds a jump counts with its two states,
  /// others with their means. Particle means alone are not monotone: they oscillate by the energy of the one
  /// transition particle as it fills.
  [[nodiscard]] double energy() const;
  [[nodiscard]] double mean_energy() const;  ///< the same from particle means alone

  /// Reconstructed profile at the present time.
  [[nodiscard]] Reconstruction reconstruction() const;
  /// Edges, means and reconstruction for error_measures.hpp; independent of this object afterwards.
  [[nodiscard]] MeasuredProfile measured_profile() const;
  /// Discharge h u [m^2/s] through the fixed section x, from the reconstruction.
  [[nodiscard]] double discharge(double x) const;
  /// Particles that hold a jump now, with their layers, from left to right.
  [[nodiscard]] const std::vector<Structure>& structures() const { return structures_; }
  /// Jumps found in particles now; those inside a followed collision are not among them.
  [[nodiscard]] const std::vector<InteriorJump>& jumps() const { return jumps_; }

 private:
  // An end seen from inside: index 0 is the end particle (edge), signs point outwards.
  struct Side {
    bool right;
    std::size_t count;
    [[nodiscard]] std::size_t particle(std::size_t k) const { return right ? count - 1 - k : k; }
    [[nodiscard]] std::size_t edge(std::size_t k) const { return right ? count - k : k; }
    [[nodiscard]] double outward() const { return right ? 1.0 : -1.0; }
    [[nodiscard]] std::size_t index() const { return right ? 1 : 0; }
  };
  struct Neighbour {
    double surface, velocity, distance;
    bool known;
  };
  struct Slopes {
    double surface, velocity;
  };

  [[nodiscard]] Side side(bool right) const { return {right, now_.size()}; }
  [[nodiscard]] const End& end(Side s) const { return s.right ? ends_.right : ends_.left; }
  template <class T>
  [[nodiscard]] bool end_is(Side s) const {
    return std::holds_alternative<T>(end(s));
  }
  [[nodiscard]] std::optional<double> wall_velocity(Side s, double time) const;
  [[nodiscard]] bool has_tip(Side s) const;
  [[nodiscard]] double celerity(std::size_t i) const { return shallow_water::celerity(forcing_.gravity, depth_[i]); }
  [[nodiscard]] double inv_width(std::size_t i) const { return 1 / now_.width(i); }
  [[nodiscard]] State state(std::size_t i) const { return {depth_[i], now_.velocity[i]}; }

  void validate() const;
  void resize_work();
  /// @param limits  of the row as it is, if they are known already
  void refresh(std::optional<RowLimits> limits = {});
  [[nodiscard]] StepLimit step_limit(double courant, bool named) const;
  void check_step(double tau) const;
  /// Throws std::invalid_argument where a wall's or piston's velocity at `time` leaves a vacuum beside it.
  void refuse_vacuum(Side s, double time) const;

  // particle_flow_edges.cpp: from means to the two averages of every edge
  [[nodiscard]] Neighbour neighbour(std::size_t i, bool to_right) const;
  [[nodiscard]] Slopes slopes(std::size_t i) const;
  [[nodiscard]] EdgePair edges_of(std::size_t i, double half_step) const;
  [[nodiscard]] EdgePair edges_on_bed(std::size_t i, Slopes s) const;
  [[nodiscard]] double acceleration(std::size_t i, double time) const;
  void solve_end(Side s, double tau);
  void solve_open_end(Side s, const Open& open, State inner, double tau);
  void hand_over_jumps(double tau);
  void react_bed(double tau);
  /// Returns the limits where particles were measured as they moved.
  std::optional<RowLimits> apply(double tau);
  void apply_friction(double tau);

  // particle_flow_rows.cpp: stretch by stretch, on threads where the row is long
  [[nodiscard]] std::size_t threads() const;
  [[nodiscard]] std::size_t stretches() const;
  [[nodiscard]] bool keeps_edge_values() const { return forcing_.bed || forcing_.manning > 0; }
  void predict_particles(double tau, std::size_t first, std::size_t last, EdgeValues& to) const;
  void solve_edges(double tau);
  void solve_stretch(double tau, std::size_t first, std::size_t last, EdgeValues& values);
  RowLimits move_and_measure(double tau);
  RowLimits measure(std::size_t first, std::size_t last);

  // particle_flow_jumps.cpp
  [[nodiscard]] const Structure* structure_at(std::size_t i) const;
  void detect_jumps();
  void detect_at_wall(Side s);
  void discard_adjacent();
  void start_collisions();
  void list_structures();

  // particle_flow_edges.cpp
  void regulate(Side s);
  void split(Side s);
  void merge(Side s);

  Particles now_;
  Ends ends_;
  Forcing forcing_;
  Scheme scheme_;
  Ledger ledger_;
  Events events_;
  CompensatedSum time_;
  long steps_ = 0;
  double largest_courant_ = 0;

  Array inv_mass_;
  Array depth_;
  Array surface_;                        // eta on an uneven bed
  Array bed_edge_;                       // z at the edges
  Array bed_area_;                       // Z at the edges
  Array bed_mean_;                       // mean z of each particle
  EdgeValues values_;                    // where they outlive their stretch: on a bed, with friction
  std::vector<EdgeValues> edge_values_;  // of a stretch, one per thread
  std::vector<RowLimits> stretch_limits_;
  Array edge_velocity_;
  Array edge_thrust_;
  Array reaction_;
  Array old_velocity_;        // for friction
  Array old_inv_width_;       // for friction
  double celerity_rate_ = 0;  // max c/w
  double closing_rate_ = 0;   // max (u_i - u_(i+1))/w_i

  std::vector<InteriorJump> jumps_;
  std::vector<Structure> structures_;
  std::vector<Collision> collisions_;
  std::array<State, 2> at_end_{};  // beside the end's edge, half a step on
  std::array<std::optional<State>, 2> ahead_at_wall_;
  std::array<double, 2> front_velocity_{};
  std::array<TipProfile, 2> tip_{};
  std::array<double, 2> open_width_{};
  std::array<double, 2> open_mass_flux_{};  // out of the domain
};

}  // namespace seiche::shallow_water_particles
