/// Instantaneous failure of a dam on a flat frictionless bed: onto a dry bed (Ritter) and onto shallower water
/// (Stoker).
///
/// Both are Riemann problems of water at rest; these classes name their particular quantities.
///
/// References: Ritter, Die Fortpflanzung der Wasserwellen, Zeitschrift des VDI 36 (1892); Stoker, Water Waves
/// (1957), 10.8; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method.
#pragma once

#include <vector>

#include "seiche/exact/riemann.hpp"

namespace seiche::exact {

/// Dam break onto a dry bed, water on the left: c = (2 c1 - (x - dam)/t)/3 between x - dam = -c1 t and 2 c1 t.
class Ritter {
 public:
  /// @param depth  depth behind the dam h1 [m], positive;  @param dam  its position [m]. Throws std::invalid_argument.
  Ritter(double gravity, double depth, double dam = 0);

  [[nodiscard]] shallow_water::State at(double x, double t) const { return problem_.at(x, t); }
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return problem_.breakpoints(t); }

  /// Position of the dry front, dam + 2 c1 t [m].
  [[nodiscard]] double front(double t) const;
  /// Position of the wave that runs back into the water at rest, dam - c1 t [m].
  [[nodiscard]] double tail(double t) const;
  /// Depth 4 h1/9 [m], velocity 2 c1/3 [m/s] and discharge (8/27) h1 c1 [m^2/s] at the dam, constant for t > 0.
  [[nodiscard]] double depth_at_dam() const;
  [[nodiscard]] double velocity_at_dam() const;
  [[nodiscard]] double discharge_at_dam() const;

  static Provenance provenance();

 private:
  Riemann problem_;
};

/// Dam break onto shallower water at rest: a fan upstream, a bore downstream, a plateau between.
class Stoker {
 public:
  /// @param upstream, downstream  depths [m], 0 < downstream < upstream. Throws std::invalid_argument.
  Stoker(double gravity, double upstream, double downstream, double dam = 0);

  [[nodiscard]] shallow_water::State at(double x, double t) const { return problem_.at(x, t); }
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return problem_.breakpoints(t); }

  /// Depth and velocity of the plateau.
  [[nodiscard]] shallow_water::State plateau() const { return problem_.star(); }
  [[nodiscard]] double bore_speed() const { return problem_.right_wave().fastest; }
  [[nodiscard]] double bore_position(double t) const { return problem_.jump() + bore_speed() * t; }
  /// Edges of the fan [m].
  [[nodiscard]] double fan_start(double t) const { return problem_.jump() + problem_.left_wave().slowest * t; }
  [[nodiscard]] double fan_end(double t) const { return problem_.jump() + problem_.left_wave().fastest * t; }

  /// (8/27) h1 c1 [m^2/s] while downstream/upstream <= critical_ratio(): the flow at the dam is then critical and does
  /// not feel the water downstream; h* u* above it.
  [[nodiscard]] double discharge_at_dam() const;

  /// Depth ratio 0.138270141... below which the flow at the dam is critical: u* = c* at the dam forces h* = 4 h1/9,
  /// and the bore condition then gives s^3 - s^2 - 3 s + 1 = 0 for the ratio (4/9) s.
  static double critical_ratio();

  static Provenance provenance();

 private:
  Riemann problem_;
};

}  // namespace seiche::exact
