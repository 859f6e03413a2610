/// What free particles under Gauss's principle and the markers of their surface show at an instant.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/record.hpp"
#include "seiche/models/gauss_particles/flow.hpp"

namespace seiche::validation {

struct GaussFrame {
  double time = 0;
  std::vector<double> x, y, u, v;      ///< particles
  std::vector<double> line_x, line_y;  ///< markers

  /// @param from  particles and markers of smaller x are left out
  explicit GaussFrame(const gauss_particles::Flow& flow, double from = -std::numeric_limits<double>::infinity())
      : time(flow.time()) {
    const std::vector<Point> markers = flow.markers();
    for (std::size_t k = 0; k < flow.model().size() - markers.size(); ++k) {
      if (flow.x()[k] < from) continue;
      x.push_back(flow.x()[k]);
      y.push_back(flow.y()[k]);
      u.push_back(flow.u()[k]);
      v.push_back(flow.v()[k]);
    }
    for (const Point& marker : markers) {
      if (marker.x < from) continue;
      line_x.push_back(marker.x);
      line_y.push_back(marker.y);
    }
  }
  GaussFrame() = default;

  /// @param length  the unit of lengths; that of velocities is the root of it and gravity
  void add_to(evidence::Exhibit& exhibit, const std::string& length) const {
    const std::string speed = fmt::format("sqrt(g {})", length);
    exhibit.snapshot(
        {.time = time, .x = x, .z = y, .unit = length, .fields = {{"u", speed, u}, {"w", speed, v}}, .joined = false});
  }
};

}  // namespace seiche::validation
