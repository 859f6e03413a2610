/// Dam breaks and the hydraulic jump at rest by the names of their parts: views of exact/shallow_water/riemann.hpp.
///
/// References: Ritter, Die Fortpflanzung der Wasserwellen, Zeitschrift des VDI 36 (1892); Stoker, Water Waves (1957),
/// 10.6-10.8.
#pragma once

#include <cmath>

#include <numbers>
#include <vector>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {

/// Dam break onto a dry bed, water on the left: c = (2 c1 - (x - dam)/t)/3 between x - dam = -c1 t and 2 c1 t.
class Ritter : public Riemann {
 public:
  /// @param depth  depth behind the dam h1 [m], positive;  @param dam  its position [m]. Throws std::invalid_argument.
  Ritter(double gravity, double depth, double dam = 0)
      : Riemann(gravity, {(require_positive("depth", depth), depth), 0}, {0, 0}, dam) {}

  /// Position of the dry front, dam + 2 c1 t [m].
  [[nodiscard]] double front(double t) const { return jump() + left_wave().fastest * t; }
  /// Position of the wave that runs back into the water at rest, dam - c1 t [m].
  [[nodiscard]] double tail(double t) const { return jump() + left_wave().slowest * t; }
  /// Discharge (8/27) h1 c1 [m^2/s] at the dam, where the depth is 4 h1/9 and the velocity 2 c1/3, constant for t > 0.
  [[nodiscard]] double discharge_at_dam() const {
    return 8.0 / 27.0 * left().depth * shallow_water::celerity(gravity(), left().depth);
  }
};

/// Dam break onto shallower water at rest: a fan upstream, a bore downstream, a plateau between.
class Stoker : public Riemann {
 public:
  /// @param upstream, downstream  depths [m], 0 < downstream < upstream. Throws std::invalid_argument.
  Stoker(double gravity, double upstream, double downstream, double dam = 0)
      : Riemann(gravity, {upstream, 0}, {below(downstream, upstream), 0}, dam) {}

  /// Depth and velocity of the plateau.
  [[nodiscard]] State plateau() const { return star(); }
  [[nodiscard]] double bore_speed() const { return right_wave().fastest; }
  [[nodiscard]] double bore_position(double t) const { return jump() + bore_speed() * t; }
  /// Where the fan meets the plateau [m].
  [[nodiscard]] double fan_end(double t) const { return jump() + left_wave().fastest * t; }

  /// (8/27) h1 c1 [m^2/s] while downstream/upstream <= critical_ratio(): the flow at the dam is then critical and does
  /// not feel the water downstream; h* u* above it.
  [[nodiscard]] double discharge_at_dam() const {
    const double h1 = left().depth;
    if (right().depth <= critical_ratio() * h1) return 8.0 / 27.0 * h1 * shallow_water::celerity(gravity(), h1);
    return plateau().depth * plateau().velocity;
  }

  /// Depth ratio 0.138270141... below which the flow at the dam is critical: u* = c* at the dam forces h* = 4 h1/9,
  /// and the bore condition then gives s^3 - s^2 - 3 s + 1 = 0 for the ratio (4/9) s.
  static double critical_ratio() {
    const double root = std::sqrt(10.0);
    const double angle = (std::acos(1 / (10 * root)) + 4 * std::numbers::pi) / 3;
    return 4.0 / 9.0 * (1.0 / 3.0 + 2 * root / 3 * std::cos(angle));
  }

 private:
  static double below(double downstream, double upstream) {
    require_positive("upstream", upstream);
    require_positive("downstream", downstream);
    require_that(downstream < upstream, "downstream = {:.17g} is out of range: must be below upstream = {:g}",
                 downstream, upstream);
    return downstream;
  }
};

/// Hydraulic jump at rest in water that flows to the right: supercritical of depth `shallow` upstream, subcritical of
/// depth `deep` downstream.
class StationaryJump {
 public:
  /// @param shallow, deep  depths h0, h1 [m], 0 < shallow < deep;  @param position  of the jump [m].
  /// Throws std::invalid_argument.
  StationaryJump(double gravity, double shallow, double deep, double position = 0)
      : bore_(gravity, shallow, deep), position_(position) {
    require_finite("position", position);
  }

  [[nodiscard]] shallow_water::State at(double x, double t = 0) const {
    require_finite("x", x);
    require_not_negative("t", t);
    return x < position_ ? upstream() : downstream();
  }
  [[nodiscard]] std::vector<double> breakpoints(double /*t*/ = 0) const { return {position_}; }

  /// u0 = a = sqrt(g h1 (h1 + h0)/(2 h0)) upstream, u1 = a h0/h1 downstream.
  [[nodiscard]] shallow_water::State upstream() const { return flow(bore_.ahead().depth); }
  [[nodiscard]] shallow_water::State downstream() const { return flow(bore_.behind().depth); }
  /// Discharge [m^2/s], and energy lost as by the bore that it is seen from the water upstream.
  [[nodiscard]] double mass_flux() const { return bore_.mass_flux(); }
  [[nodiscard]] double energy_loss_rate() const { return bore_.energy_loss_rate(); }

 private:
  [[nodiscard]] shallow_water::State flow(double depth) const { return {depth, mass_flux() / depth}; }

  Bore bore_;
  double position_;
};

}  // namespace seiche::exact
