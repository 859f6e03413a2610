#include "seiche/models/variable_mass/control.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::variable_mass {

namespace {

using free_lagrangian::Held;
using free_lagrangian::Mesh;

/// Height of the highest corner between walls; of the lowest node where there is none.
double foot_of(const Mesh& mesh) {
  Largest corner;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    if (mesh.held[k].one != Held::by_none && mesh.held[k].other != Held::by_none) corner.add(mesh.y[k]);
  }
  return corner.count() > 0 ? corner.value() : smallest(mesh.y);
}

const Mesh& valid(const Mesh& mesh) {
  mesh.require_valid();
  return mesh;
}

}  // namespace

ControlKind control_named(std::string_view name) {
  if (name == "none") return ControlKind::none;
  if (name == "centroid") return ControlKind::centroid;
  if (name == "mapped") return ControlKind::mapped;
  if (name == "fixed_x") return ControlKind::fixed_x;
  throw std::invalid_argument(fmt::format("control = \"{}\"; allowed: none, centroid, mapped, fixed_x", name));
}

ControlVelocity::ControlVelocity(const Mesh& rest, Control control)
    : control_(control), rest_(valid(rest)), surface_(rest), freedom_(freedoms(rest)), controlled_(rest.nodes(), true) {
  require_not_negative("rate", control.rate);
  require_not_negative("surface_rate", control.surface_rate);
  if (!surface_.exists() && (lifts() || control.surface_rate > 0)) {
    throw std::invalid_argument(
        fmt::format("the mesh has no surface between two walls; allowed: control none or centroid with surface_rate = "
                    "0, not {:g}",
                    control.surface_rate));
  }
  for (const int k : rest.outline) {
    const auto node = static_cast<std::size_t>(k);
    if (rest.held[node].one == Held::by_none) controlled_[node] = false;
  }
  lift_.assign(rest.nodes(), 0.0);
  if (!surface_.exists()) return;
  for (const int k : {surface_.nodes().front(), surface_.nodes().back()})
    controlled_[static_cast<std::size_t>(k)] = false;
  const double foot = foot_of(rest);
  require_positive("level of the surface above the foot of the control", surface_.level() - foot);
  for (std::size_t k = 0; k < rest.nodes(); ++k) {
    lift_[k] = std::clamp((rest.y[k] - foot) / (surface_.level() - foot), 0.0, 1.0);
  }
}

Mesh ControlVelocity::raised(const std::function<double(double)>& elevation) const {
  Mesh mesh = rest_;
  if (!elevation) return mesh;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double lift = elevation(mesh.x[k]);
    require_finite(fmt::format("elevation at x = {:g}", mesh.x[k]), lift);
    mesh.y[k] += lift_[k] * lift;
  }
  return mesh;
}

void ControlVelocity::at(const MovingTriangulation& mesh, std::span<const double> u, std::span<double> c) const {
  std::fill(c.begin(), c.end(), 0.0);
  const Places at = mesh.nodes();
  const std::size_t n = at.x.size();
  if (surface_.exists()) slide(at, u, c);
  if (control_.kind == ControlKind::none) return;
  const std::vector<Point> centroids =
      control_.kind == ControlKind::centroid ? dirichlet_centroids(mesh.mesh(), at) : std::vector<Point>{};
  // Vertical velocity of the surface, of which the nodes below have their part.
  std::vector<double> rise(c.begin() + static_cast<std::ptrdiff_t>(n), c.end());
  for (std::size_t k = 0; k < n; ++k) rise[k] += u[n + k];
  for (std::size_t k = 0; k < n; ++k) {
    if (!controlled_[k]) continue;
    const Point r = at[static_cast<int>(k)];
    Point target{rest_.x[k], rest_.y[k]};
    Point along;
    if (control_.kind == ControlKind::centroid) {
      target = centroids[k];
    } else if (lift_[k] > 0) {
      target.y += lift_[k] * (surface_.along(at, at.y, r.x) - surface_.level());
    }
    if (control_.kind == ControlKind::fixed_x) {
      along = {-u[k], -u[n + k]};
      if (lift_[k] > 0) along.y += lift_[k] * surface_.along(at, rise, r.x);
    }
    const Point velocity =
        freedom_[k]({along.x + control_.rate * (target.x - r.x), along.y + control_.rate * (target.y - r.y)});
    c[k] = velocity.x;
    c[n + k] = velocity.y;
  }
}

void ControlVelocity::slide(Places at, std::span<const double> u, std::span<double> c) const {
  const bool fixed = control_.kind == ControlKind::fixed_x;
  if (control_.surface_rate == 0 && !fixed) return;
  surface_.require_single_valued(at);
  const auto nodes = surface_.nodes();
  for (const int k : nodes.subspan(1, nodes.size() - 2)) {
    const auto s = static_cast<std::size_t>(k);
    c[s] = control_.surface_rate * (rest_.x[s] - at.x[s]) - (fixed ? u[s] : 0.0);
  }
  surface_.slide(at, c.first(at.x.size()), c.last(at.x.size()));
}

}  // namespace seiche::variable_mass
