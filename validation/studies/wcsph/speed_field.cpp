#include "validation/studies/wcsph/speed_field.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/samples.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation {

SpeedField speed_field(const wcsph::Particles& particles, double spacing, const Frame& frame) {
  const double step = 0.5 * spacing;
  const auto columns = static_cast<long>(std::ceil((frame.right - frame.left) / step));
  const auto rows = static_cast<long>(std::ceil((frame.top - frame.bottom) / step));
  const auto nodes = static_cast<std::size_t>((columns + 1) * (rows + 1));
  // Water that is stretched along a jet still covers every node; a lone drop is drawn twice as wide as itself.
  const double reach = 1.1 * spacing;
  std::vector<double> weight(nodes, 0), sum(nodes, 0);
  std::vector<char> near(nodes, 0);
  const double h = spacing;
  const auto index = [](double place, double first, double width) { return (place - first) / width; };
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (particles.kind[p] != wcsph::Kind::fluid) continue;
    const double i0 = index(particles.x[p], frame.left, step);
    const double j0 = index(particles.z[p], frame.bottom, step);
    const double width = wcsph::support * h / step;
    const double speed = std::hypot(particles.u[p], particles.w[p]);
    for (long j = std::max(0L, std::lround(j0 - width)); j <= std::min(rows, std::lround(j0 + width)); ++j) {
      for (long i = std::max(0L, std::lround(i0 - width)); i <= std::min(columns, std::lround(i0 + width)); ++i) {
        const double distance = step * std::hypot(static_cast<double>(i) - i0, static_cast<double>(j) - j0);
        const auto node = static_cast<std::size_t>(j * (columns + 1) + i);
        const double w = wcsph::CubicSpline::shape(distance / h);
        weight[node] += w;
        sum[node] += w * speed;
        if (distance < reach) near[node] = 1;
      }
    }
  }
  SpeedField field{.columns = static_cast<std::size_t>(columns), .rows = static_cast<std::size_t>(rows)};
  for (long j = 0; j <= rows; ++j) {
    for (long i = 0; i <= columns; ++i) {
      const auto node = static_cast<std::size_t>(j * (columns + 1) + i);
      field.x.push_back(frame.left + static_cast<double>(i) * step);
      field.z.push_back(frame.bottom + static_cast<double>(j) * step);
      field.speed.push_back(near[node] ? sum[node] / weight[node] : nan);
    }
  }
  return field;
}

double fastest(const wcsph::Particles& particles) {
  Largest speed;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] == wcsph::Kind::fluid) speed.add(std::hypot(particles.u[i], particles.w[i]));
  }
  return speed.value();
}

void draw_speed(evidence::Figure& figure, const wcsph::Particles& particles, double spacing, const SpeedPanel& panel) {
  SpeedField field = speed_field(particles, spacing, panel.frame);
  for (double& x : field.x) x /= panel.unit;
  for (double& z : field.z) z /= panel.unit;
  auto& drawn = figure.panel({.x = fmt::format("x [{}]", panel.unit_name),
                              .y = fmt::format("z [{}]", panel.unit_name),
                              .z = "speed [m/s]",
                              .title = panel.title,
                              .equal_aspect = true});
  drawn.plan("water", field.lattice());
  std::vector<double> x, z;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (particles.kind[p] == wcsph::Kind::fluid) continue;
    if (particles.x[p] < panel.frame.left || particles.x[p] > panel.frame.right || particles.z[p] > panel.frame.top) {
      continue;
    }
    x.push_back(particles.x[p] / panel.unit);
    z.push_back(particles.z[p] / panel.unit);
  }
  if (!x.empty()) drawn.points("", x, z, evidence::Role::data);
}

}  // namespace seiche::validation
