/// Speed of the fluid on a regular lattice, for frames: mean of the particles around, weighted with the kernel; nothing
/// where no particle is near.
#pragma once

#include <string>
#include <vector>

#include "reports/evidence/figure.hpp"
#include "seiche/models/wcsph/particles.hpp"

namespace seiche::validation {

struct SpeedField {
  std::size_t columns, rows;
  std::vector<double> x, z, speed;
  [[nodiscard]] evidence::Lattice lattice() const { return {columns, rows, x, z, speed}; }
};

struct Frame {
  double left, right, bottom, top;  ///< [m]
};

/// @param spacing  of the particles; the lattice has half of it
SpeedField speed_field(const wcsph::Particles& particles, double spacing, const Frame& frame);

/// Largest speed of the fluid [m/s].
double fastest(const wcsph::Particles& particles);

/// One panel: the field, and the walls as points.
/// @param unit  of lengths in the panel [m], named in `unit_name`
struct SpeedPanel {
  std::string title;
  Frame frame;
  double unit = 1;
  std::string unit_name = "m";
};
void draw_speed(evidence::Figure& figure, const wcsph::Particles& particles, double spacing, const SpeedPanel& panel);

}  // namespace seiche::validation
