#include "validation/studies/gauss_particles/gauss_frame.hpp"

#include <fmt/format.h>

namespace seiche::validation {

GaussFrame::GaussFrame(const gauss_particles::Flow& flow, double from) : time(flow.time()) {
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

void GaussFrame::add_to(evidence::Exhibit& exhibit, const std::string& length) const {
  const std::string speed = fmt::format("sqrt(g {})", length);
  exhibit.snapshot(
      {.time = time, .x = x, .z = y, .unit = length, .fields = {{"u", speed, u}, {"w", speed, v}}, .joined = false});
}

}  // namespace seiche::validation
