/// What free particles under Gauss's principle and the markers of their surface show at an instant.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/models/gauss_particles/flow.hpp"

namespace seiche::validation {

struct GaussFrame {
  double time = 0;
  std::vector<double> x, y, u, v;      ///< particles
  std::vector<double> line_x, line_y;  ///< markers

  /// @param from  particles and markers of smaller x are left out
  explicit GaussFrame(const gauss_particles::Flow& flow, double from = -std::numeric_limits<double>::infinity());
  GaussFrame() = default;

  /// @param length  the unit of lengths; that of velocities is the root of it and gravity
  void add_to(evidence::Exhibit& exhibit, const std::string& length) const;
};

}  // namespace seiche::validation
