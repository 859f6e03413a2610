#include "seiche/models/variable_mass/control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::variable_mass {

namespace {

using free_lagrangian::Held;
using free_lagrangian::Mesh;

constexpr std::size_t stencil = 5;  // nodes of a slope
constexpr double flat = 1e-10;      // standard deviation of the height over the depth below which no beta is sought

/// dy/dx at entry `here` of the polynomial through the nodes first, ..., first + count - 1.
double slope(Places at, std::span<const int> nodes, std::size_t first, std::size_t count, std::size_t here) {
  const auto x = [&](std::size_t i) { return at[nodes[first + i]].x; };
  const std::size_t m = here - first;
  double sum = 0;
  for (std::size_t j = 0; j < count; ++j) {
    if (j == m) continue;
    // Derivative of Lagrange's polynomial j at node m; those of all sum to zero.
    double weight = 1 / (x(j) - x(m));
    for (std::size_t l = 0; l < count; ++l) {
      if (l != j && l != m) weight *= (x(m) - x(l)) / (x(j) - x(l));
    }
    sum += weight * (at[nodes[first + j]].y - at[nodes[here]].y);
  }
  return sum;
}

}  // namespace

Surface::Surface(const Mesh& mesh) : outline_(mesh.outline) {
  const auto n = static_cast<std::ptrdiff_t>(outline_.size());
  const auto node = [&](std::ptrdiff_t e) { return outline_[static_cast<std::size_t>((e % n + n) % n)]; };
  const auto free = [&](std::ptrdiff_t e) { return mesh.held[index(node(e))].one == Held::by_none; };
  for (std::ptrdiff_t e = 0; e < n; ++e) {
    if (free(e) || !free(e + 1)) continue;
    require_that(nodes_.empty(), "two free stretches of the outline, at nodes {} and {}; allowed: one",
                 nodes_.empty() ? 0 : nodes_.back(), node(e));
    for (std::ptrdiff_t s = e;; ++s) {
      nodes_.push_back(node(s));
      if (s > e && !free(s)) break;
    }
  }
  std::reverse(nodes_.begin(), nodes_.end());
  if (nodes_.empty()) return;
  try {
    require_single_valued(mesh.places());
  } catch (const mechanics::Infeasible& failure) {
    throw std::invalid_argument(failure.what());
  }
  Mean height;
  for (const int k : nodes_) height.add(mesh.y[index(k)]);
  level_ = height.value();
}

void Surface::require_single_valued(Places at) const {
  for (std::size_t s = 1; s < nodes_.size(); ++s) {
    if (!(at[nodes_[s]].x > at[nodes_[s - 1]].x)) {
      const Point r = at[nodes_[s]];
      throw mechanics::Infeasible(r.x, "the surface goes back in x at node {} at ({:g}, {:g})", nodes_[s], r.x, r.y);
    }
  }
}

double Surface::along(Places at, std::span<const double> quantity, double x) const {
  const auto after = std::partition_point(nodes_.begin(), nodes_.end(), [&](int k) { return at[k].x < x; });
  if (after == nodes_.begin()) return quantity[index(nodes_.front())];
  if (after == nodes_.end()) return quantity[index(nodes_.back())];
  const int right = *after;
  const int left = *std::prev(after);
  const double part = (x - at[left].x) / (at[right].x - at[left].x);
  return (1 - part) * quantity[index(left)] + part * quantity[index(right)];
}

void Surface::slide(Places at, std::span<const double> cx, std::span<double> cy) const {
  const std::size_t count = std::min(stencil, nodes_.size());
  for (std::size_t s = 0; s < nodes_.size(); ++s) {
    const std::size_t first = std::min(s < count / 2 ? 0 : s - count / 2, nodes_.size() - count);
    cy[index(nodes_[s])] = cx[index(nodes_[s])] * slope(at, nodes_, first, count, s);
  }
  correct(at, cx, cy);
}

void Surface::correct(Places at, std::span<const double> cx, std::span<double> cy) const {
  std::vector<Point> force(at.x.size());
  free_lagrangian::gravity_forces(at, outline_, 1, force);
  // Sums over the surface: the two conditions on c, and on the two corrections.
  double area = 0;
  double energy = 0;
  std::array<double, 2> of_area{};
  std::array<double, 2> of_energy{};
  double squares = 0;
  for (std::size_t s = 1; s + 1 < nodes_.size(); ++s) {
    const std::size_t k = index(nodes_[s]);
    const Point before = at[nodes_[s - 1]];
    const Point after = at[nodes_[s + 1]];
    const double height = at.y[k] - level_;
    const Point d_area{(before.y - after.y) / 2, (after.x - before.x) / 2};
    const Point d_energy{-force[k].x - level_ * d_area.x, -force[k].y - level_ * d_area.y};
    const double rate = std::abs(cx[k]);
    area += dot(d_area, {cx[k], cy[k]});
    energy += dot(d_energy, {cx[k], cy[k]});
    of_area[0] += d_area.y * rate;
    of_area[1] += d_area.y * rate * height;
    of_energy[0] += d_energy.y * rate;
    of_energy[1] += d_energy.y * rate * height;
    squares += d_area.y * rate * height * height;
  }
  if (!(of_area[0] > 0)) return;
  const double spread = squares / of_area[0] - std::pow(of_area[1] / of_area[0], 2);
  const double width = at[nodes_.back()].x - at[nodes_.front()].x;
  double alpha = -area / of_area[0];
  double beta = 0;
  if (spread > std::pow(flat * width, 2)) {
    const double determinant = of_area[0] * of_energy[1] - of_area[1] * of_energy[0];
    alpha = (of_area[1] * energy - of_energy[1] * area) / determinant;
    beta = (of_energy[0] * area - of_area[0] * energy) / determinant;
  }
  for (std::size_t s = 1; s + 1 < nodes_.size(); ++s) {
    const std::size_t k = index(nodes_[s]);
    cy[k] += std::abs(cx[k]) * (alpha + beta * (at.y[k] - level_));
  }
}

std::vector<double> Surface::handed_on(Places at, std::span<const double> cx, std::span<const double> cy) const {
  std::vector<double> gain(nodes_.size(), 0.0);
  for (std::size_t s = 0; s + 1 < nodes_.size(); ++s) {
    const std::size_t k = index(nodes_[s]);
    const std::size_t l = index(nodes_[s + 1]);
    const double nx = at.y[k] - at.y[l];
    const double ny = at.x[l] - at.x[k];
    const double here = nx * cx[k] + ny * cy[k];
    const double there = nx * cx[l] + ny * cy[l];
    gain[s] += 0.375 * here + 0.125 * there;
    gain[s + 1] += 0.125 * here + 0.375 * there;
  }
  // A node that gains by the outline has that from its neighbour, and so on: in the end the gains of all are nothing.
  for (std::size_t s = 1; s < gain.size(); ++s) gain[s] += gain[s - 1];
  if (!gain.empty()) gain.pop_back();
  return gain;
}

namespace {

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
  using enum ControlKind;
  return value_named<ControlKind>("control", name,
                                  {{"none", none}, {"centroid", centroid}, {"mapped", mapped}, {"fixed_x", fixed_x}});
}

ControlVelocity::ControlVelocity(const Mesh& rest, Control control)
    : control_(control), rest_(valid(rest)), surface_(rest), freedom_(freedoms(rest)), controlled_(rest.nodes(), true) {
  require_ranges(control);
  require_that(surface_.exists() || !(lifts() || control.surface_rate > 0),
               "the mesh has no surface between two walls; allowed: control none or centroid with surface_rate = "
               "0, not {:g}",
               control.surface_rate);
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
    const Point velocity = freedom_[k](along + control_.rate * (target - r));
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
