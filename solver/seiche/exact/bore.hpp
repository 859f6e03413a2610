/// Hydraulic jumps between two uniform depths: a bore that runs into still (or moving) water, a jump that stands still.
///
/// Jump conditions: h1 (u1 - a) = h0 (u0 - a),  h1 (u1 - a)(u1 - u0) = (g/2)(h0^2 - h1^2), with h1 > h0 behind.
///
/// When not to use them: undular bores (h1/h0 below about 1.3 in reality), friction.
///
/// References: Stoker, Water Waves (1957), 10.6-10.7; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves
/// by the particle method, formula (11).
#pragma once

#include <vector>

#include "seiche/exact/provenance.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

/// Bore that runs to the right into water of depth `ahead`.
class Bore {
 public:
  /// @param ahead, behind    depths h0, h1 [m], 0 < ahead < behind: a fall of depth would gain energy and is refused
  /// @param ahead_velocity   u0 [m/s]
  /// @param start            position at t = 0 [m]
  /// Throws std::invalid_argument.
  Bore(double gravity, double ahead, double behind, double ahead_velocity = 0, double start = 0);

  /// Bore with a given particle velocity u1 > 0 behind it, into water at rest: finds h0 from h1 and u1.
  static Bore from_velocity(double gravity, double behind, double behind_velocity, double start = 0);

  [[nodiscard]] shallow_water::State at(double x, double t) const;
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return {position(t)}; }
  [[nodiscard]] double position(double t) const { return start_ + speed() * t; }

  [[nodiscard]] shallow_water::State ahead() const { return ahead_; }
  [[nodiscard]] shallow_water::State behind() const { return behind_; }
  [[nodiscard]] double gravity() const { return gravity_; }
  /// Speed of the bore a = u0 + sqrt(g h1 (h1 + h0)/(2 h0)) [m/s].
  [[nodiscard]] double speed() const { return ahead_.velocity + mass_flux() / ahead_.depth; }
  /// Particle velocity behind the bore u1 = u0 + (a - u0)(1 - h0/h1) [m/s].
  [[nodiscard]] double behind_velocity() const { return behind_.velocity; }
  /// Mass swept per unit time sqrt(g h0 h1 (h0 + h1)/2) [m^2/s], the same for every observer.
  [[nodiscard]] double mass_flux() const { return flux_; }
  /// Energy lost per unit time, width and density, M g (h1 - h0)^3/(4 h0 h1) [m^4/s^3].
  [[nodiscard]] double energy_loss_rate() const;

  static Provenance provenance();

 private:
  double gravity_;
  shallow_water::State ahead_;
  double start_;
  double flux_;
  shallow_water::State behind_;
};

/// Hydraulic jump at rest: supercritical flow of depth `shallow` upstream, subcritical of depth `deep` downstream.
class StationaryJump {
 public:
  enum class Flow { rightwards, leftwards };

  /// @param shallow, deep  depths h0, h1 [m], 0 < shallow < deep;  @param position  of the jump [m].
  /// Throws std::invalid_argument.
  StationaryJump(double gravity, double shallow, double deep, double position = 0, Flow flow = Flow::rightwards);

  [[nodiscard]] shallow_water::State at(double x, double t = 0) const;
  [[nodiscard]] std::vector<double> breakpoints(double t = 0) const;

  /// u0 = a = sqrt(g h1 (h1 + h0)/(2 h0)) upstream, u1 = a h0/h1 downstream; signed by the direction of the flow.
  [[nodiscard]] shallow_water::State upstream() const { return upstream_; }
  [[nodiscard]] shallow_water::State downstream() const { return downstream_; }
  /// Magnitude of the discharge [m^2/s].
  [[nodiscard]] double mass_flux() const { return flux_; }
  [[nodiscard]] double energy_loss_rate() const;

  static Provenance provenance();

 private:
  double gravity_;
  double position_;
  Flow flow_;
  double flux_;
  shallow_water::State upstream_;
  shallow_water::State downstream_;
};

}  // namespace seiche::exact
