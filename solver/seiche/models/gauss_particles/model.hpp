/// Gauss's principle of least constraint on free particles (Frank 1994, chapter 6, formulas 15 to 23).
///
/// Particles of constant mass carry places and velocities. At every instant the accelerations are as near to those of
/// free particles as a space N of smooth solenoidal fields along the walls allows:
///
/// @f[ \sum_k m_k \left( \frac{d \mathbf{v}(\mathbf{r}_k)}{dt} - \mathbf{F}_k \right) \cdot \mathbf{w}(\mathbf{r}_k) =
/// 0
///     \quad \text{for all } \mathbf{w} \in N, \qquad \dot{\mathbf{r}}_k = \mathbf{v}(\mathbf{r}_k), \quad
///     \mathbf{v} \in N \tag{20} @f]
///
/// The reaction, orthogonal to N, is the gradient of a pressure that vanishes on the free surface; there is no pressure
/// among the unknowns, no mesh among the particles, and no condition at the surface.
///
/// The class is what mechanics::OneStep and mechanics::ProjectedStep step: q = (x of all particles, y of all), u =
/// (velocities along x, along y). OneStep is the fully conservative scheme: the velocity is reflected at N,
///
/// @f[ \tilde{\mathbf{u}} = P_q \left( \mathbf{u}^n + \frac{\tau}{2} \mathbf{F} \right), \qquad
///     \mathbf{u}^{n+1} = 2 \tilde{\mathbf{u}} - \mathbf{u}^n, \qquad
///     \mathbf{r}^{n+1} = \mathbf{r}^n + \tau \tilde{\mathbf{u}}, \qquad
///     q = \mathbf{r}^n + \frac{\tau}{2} \mathbf{u}^n @f]
///
/// and energy is exact for any N, also another one at every step, if the forces are those of gravity; else the work is.
/// Momentum and angular momentum are exact, for all states, if and only if N holds the translation and the rotation.
/// ProjectedStep is Frank's (21) to (23), of first order: it loses (tau/2) sum m |acceleration|^2 per unit of time.
///
/// Markers, which have no mass, ride on the field and are never reflected. Where water is thinner than a cell it flies
/// freely.
///
/// When not to use it: under gravity for longer than a wave's period without the penalty (spline_space.hpp) or
/// gravity on the surface (SurfaceGravity): sums over particles are no exact integrals, and small eddies grow.
/// Sprays and jets thinner than a cell are not resolved.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 6; Frank &
/// Ogorodnikov, Dokl. Akad. Nauk 326 (1992) 958. The same reflection: Ferraro, Iglesias & Martin de Diego, Nonlinearity
/// 21 (2008) 1911; Zehnder, Narain & Thomaszewski, ACM Trans. Graph. 37 (2018) 85.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/curve.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/particles.hpp"
#include "seiche/ranges.hpp"

namespace seiche::gauss_particles {

// Gravity as a force on the surface: the potential energy of the water below the line of markers.
//
// @f[ \Pi = \rho g \int \frac{y^2}{2} \, dx = \rho g \sum_{ab} \frac{(x_b - x_a)(y_a^2 + y_a y_b + y_b^2)}{6} @f]
//
// over the pieces ab of the line, y counted from the still-water level y = 0. Its forces act on the markers, and by
// the fields on the water. Sums m g y over particles are no exact integrals: an eddy inside, which moves no marker,
// meets forces of gravity there, and the smallest eddies grow. Here it meets none: five periods of a wave of moderate
// height need no penalty. What this costs: Pi is cubic and markers have no mass, so that the energy errs by O(tau^2);
// with `exact_energy` the force is the discrete gradient of Pi over the markers' way, and the energy is exact again.
// The momentum along x is exact either way, for Pi does not change when all markers move along x together.
//
// Take the inner cells 0.9 full (SplineSpace::Settings): functions that hang on fewer particles are pushed by the
// line but hardly weighed by the particles. Waves of 90 per cent of the greatest height need ten particles to a cell's
// side, or the penalty: with either, and 24 cells to a wavelength, the surface is off by 0.8 per cent of the height
// after five periods. Masses fitted to the moments of cut cells at the beginning are no cure, for the water carries
// them to other cells.
//
// When not to use it: fewer than six particles to a cell's side or masses that are not end-corrected (particles.hpp),
// with which line and particles part; surfaces that meet themselves; fewer than ten markers to a cell; dissipative
// stepping, which would have no force.
//
// Reference for the discrete gradient: McLachlan, Quispel & Robidoux, Phil. Trans. R. Soc. A 357 (1999) 1021.

/// The markers, in their order and with the water on their right-hand side, are the surface.
struct SurfaceLine {
  double period =
      0;  ///< of a periodic channel: the line goes on from its last marker to the first [m]; 0: it ends there
  /// The force is the mean over the markers' way, found by iteration: the energy is exact, at the cost of some more
  /// solutions with the factors of the step; the phase lags by (omega tau)^2/12 instead of leading by as much.
  bool exact_energy = false;
};

class SurfaceGravity {
 public:
  /// @param weight  rho g. Throws std::invalid_argument: fewer than two markers, a negative period.
  SurfaceGravity(SurfaceLine line, const Particles& particles, double weight);

  /// The particles that are the line.
  [[nodiscard]] std::span<const std::size_t> markers() const { return markers_; }
  /// Pi at q = (x of all, y of all) [J/m].
  [[nodiscard]] double energy(std::span<const double> q) const;
  /// impulse -= h dPi/dq.
  void push(std::span<const double> q, double h, std::span<double> impulse) const;
  /// As push, with the mean of dPi/dq over the straight way from q0 to q1: its product with q1 - q0 is the difference
  /// of Pi, to round-off.
  void push_between(std::span<const double> q0, std::span<const double> q1, double h, std::span<double> impulse);

 private:
  template <class Visit>
  void each_piece(std::span<const double> q, Visit&& visit) const;

  double period_;
  double weight_;
  std::vector<std::size_t> markers_;
  std::vector<double> middle_;
};

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

struct Settings {
  double gravity = 1;  ///< [m/s^2]
  double density = 1;  ///< [kg/m^3]
  /// C of the penalty on gradients of vorticity; 0 for none, and no loss of energy. 0.001 is too weak for long runs,
  /// 0.1 no better than 0.01. Conservative stepping only.
  double penalty = 0.01;
  /// Gravity acts through the surface (SurfaceGravity) and not on every particle; conservative stepping only.
  std::optional<SurfaceLine> surface = {};

  static constexpr auto ranges() {
    return std::array{Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"density", &Settings::density, Range::positive()},
                      Number{"penalty", &Settings::penalty, Range::not_negative()}};
  }
};

/// What acts on the water besides gravity.
struct Forcing {
  /// Slope of the pressure on the surface along x [Pa/m], at place x and time t; empty for none. The same at all
  /// heights: the projection takes away the rest.
  std::function<double(double x, double time)> surface_pressure_slope = {};
  /// Force per unit mass at a place [m/s^2]; empty for none.
  std::function<Point(Point place, double time)> body_force = {};
};

class Model : public mechanics::PointMasses<Model> {
 public:
  /// Throws std::invalid_argument (particles.hpp; no space; settings out of range; what the space finds infeasible in
  /// the particles given).
  Model(Particles particles, std::unique_ptr<FieldSpace> space, Settings settings = {}, Forcing forcing = {});

  // What mechanics/constrained_model.hpp asks for. The first velocities are not projected: exact ones are best.
  void linearise(Interval when, Input q);
  void enter(Input q, Output u);
  void kick(double h, Output u) const;
  void advance(Input from, Input u, double h, Output to) const;
  void project(Output u, Input target, Output mu);
  void settle(Interval when, Output q, Output u);
  [[nodiscard]] double place(std::size_t rate) const;

  [[nodiscard]] std::span<const double> masses() const { return particles_.mass; }  ///< [kg/m]
  [[nodiscard]] double potential_energy(Input q) const;                             ///< from the first state's [J/m]

  /// Work done so far by forces other than gravity, and energy taken by the penalty [J/m]: the energy changes by their
  /// difference, to round-off, with OneStep.
  [[nodiscard]] double work() const { return work_.value(); }
  [[nodiscard]] double penalty_loss() const { return loss_.value(); }

  [[nodiscard]] std::size_t size() const { return particles_.size(); }
  [[nodiscard]] Places given() const { return {particles_.x, particles_.y}; }
  [[nodiscard]] const Particles& particles() const { return particles_; }  ///< at the beginning
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const FieldSpace& space() const { return *space_; }
  /// Velocities before the last projection: (2/tau)(w - u~) is the gradient of the pressure over the density.
  [[nodiscard]] std::span<const double> before_projection() const { return before_; }
  /// The last projection, u~.
  [[nodiscard]] std::span<const double> projected() const { return projected_; }
  /// Places at which it was taken.
  [[nodiscard]] std::span<const double> places() const { return places_; }

 private:
  void project_under_surface(Output u);
  void push_and_project(Output u);

  Particles particles_;
  std::unique_ptr<FieldSpace> space_;
  Settings settings_;
  Forcing forcing_;
  Interval when_;
  std::optional<SurfaceGravity> surface_;
  double first_potential_ = 0;  // of the surface
  double marker_lead_ = 0;
  std::vector<double> places_, force_, before_, projected_, previous_, impulse_;
  std::vector<double> start_, end_;  // of the step's way, for an exact energy of the surface
  double step_work_ = 0;
  CompensatedSum work_, loss_;
};

}  // namespace seiche::gauss_particles
