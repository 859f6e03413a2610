#include "seiche/models/lagrangian_mesh_2d/model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/linear/cosine_lattice.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

std::vector<double> areas_of(const Mesh& mesh) {
  std::vector<double> areas(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) areas[cell] = cell_area(mesh, mesh.x, mesh.y, cell);
  return areas;
}

/// Speed along the curve of the velocity d s'.
double speed_along(Point direction, Point velocity) {
  return dot(direction, velocity) / dot(direction, direction);
}

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The undeformed lattice nearest to a mesh, which preconditions its large systems: columns of the mesh's mean width,
/// rows of their mean heights; empty unless the mesh lies between walls at the left and right and on a bottom, under a
/// free surface.
std::optional<linear::UndeformedLattice> undeformed_lattice(const Mesh& mesh, double density) {
  const auto free = [](const Side& side) { return std::holds_alternative<FreeSide>(side); };
  if (!free(mesh.sides.top) || free(mesh.sides.left) || free(mesh.sides.right) || free(mesh.sides.bottom)) return {};
  double area = 0;
  double height = 0;
  std::vector<double> heights(mesh.rows, 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto [r0, r1, r2, r3] = mesh.corners(cell);
    heights[cell / mesh.columns] +=
        0.5 * (mesh.y[r3] + mesh.y[r2] - mesh.y[r0] - mesh.y[r1]) / static_cast<double>(mesh.columns);
    area += cell_area(mesh, mesh.x, mesh.y, cell);
  }
  for (const double row : heights) height += row;
  const double width = area / (height * static_cast<double>(mesh.columns));
  return linear::UndeformedLattice{.shape = {.nx = mesh.columns, .nz = 1, .layers = mesh.rows},
                                   .matrix = linear::hexahedral_lattice(width, 1, heights, density)};
}

}  // namespace

Model::Model(Mesh mesh, Settings settings, Forcing forcing)
    : Water{lattice::valid_cells(mesh, settings, {mesh.columns, mesh.rows}),
            areas_of(mesh),
            {mesh.columns, mesh.rows, settings.solver, undeformed_lattice(mesh, settings.density), settings.tolerance},
            settings.tolerance},
      mesh_(std::move(mesh)),
      settings_(settings),
      forcing_(std::move(forcing)),
      nodes_(mesh_, volume_, settings.density, settings.tuned_surface_inertia),
      edges_(mesh_),
      hourglass_(mesh_, settings.hourglass * settings.density * settings.gravity *
                            std::sqrt(sum(volume_) / static_cast<double>(mesh_.cells()))),
      barrier_(settings.corner_barrier * settings.density * settings.gravity) {
  require_that(!edges_.empty(), "the mesh has no free side; allowed: at least one");
  require_that(settings.lowest_corner < 1, "lowest_corner = {:g}; allowed: below 1", settings.lowest_corner);
  lowest_triangle_ = settings.lowest_corner * std::ranges::max(volume_);
  const bool everywhere = hourglass_.active() || barrier_.active() || forcing_.body_force;
  first_pushed_row_ = everywhere ? 0 : edges_.first_node() / (mesh_.columns + 1);
  for (const Slide& slide : nodes_.slides()) held_.push_back({.node = slide.node});
}

mechanics::State Model::state(const InitialVelocity& velocity, double time) const {
  mechanics::State state{
      .q = lattice::joined({mesh_.x, mesh_.y}), .u = std::vector<double>(rates(), 0.0), .time = time};
  const auto given = lattice::nodal(velocity, n_, [&](const VelocityAt& at, std::size_t k) {
    return at({mesh_.x[k], mesh_.y[k]});
  });
  for (std::size_t k = 0; k < n_; ++k) {
    // A node that is held in one direction, or slides, keeps what it may do.
    state.u[k] = nodes_.wx()[k] > 0 ? given[k].x : 0.0;
    state.u[n_ + k] = nodes_.wy()[k] > 0 ? given[k].y : 0.0;
  }
  for (const Slide& slide : nodes_.slides()) {
    const double s = slide.curve->arc_length_at({mesh_.x[slide.node], mesh_.y[slide.node]});
    const Point tangent = slide.curve->tangent(s);
    put_point(dot(tangent, given[slide.node]) * tangent, state.u, n_, slide.node);
    // On the curve to the last bit, where it will be put after every step.
    put_point(slide.curve->position(s), state.q, n_, slide.node);
    state.q.push_back(s);
  }
  settle({time, 0}, state.q, state.u);
  return state;
}

Input Model::with_driven(Input q) {
  if (nodes_.driven().empty()) return q;
  patched_.assign(q.begin(), q.end());
  for (const Driven& node : nodes_.driven()) {
    node.put(0.5 * (node.place(when_.begin) + node.place(when_.end())), patched_, n_);
  }
  return patched_;
}

void Model::gather(Input q0, Input q1, Input middle, int /*sweep*/) {
  turn_slides(q0, q1);
  const bool instant = q0.data() == q1.data();
  const Input at = with_driven(middle);
  measure(at);
  // Simpson's mean of the gradient of a cubic is exact.
  gather_forces(at, instant ? 1 : 4.0 / 6);
  if (!instant) gather_forces(q0, 1.0 / 6);
  if (!instant) gather_forces(q1, 1.0 / 6);
  if (forcing_.body_force) {
    push_bodies([&](std::size_t k) {
      const Point force = forcing_.body_force({mesh_.x[k], mesh_.y[k]}, when_.middle());
      return std::array{force.x, force.y};
    });
  }
}

void Model::turn_slides(Input q0, Input q1) {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    Slide& slide = nodes_.slides()[i];
    const std::size_t k = slide.node;
    const double s0 = q0[2 * n_ + i];
    const double s1 = q1[2 * n_ + i];
    if (q0.data() == q1.data()) {
      slide.direction = slide.curve->tangent(s0);
      slide.bend = slide.curve->curvature(s0);
    } else {
      slide.direction = slide.curve->mean_tangent(s0, s1);  // makes areas and energy exact on curves too
    }
    const Point d = slide.direction;
    const double m = nodes_.mass()[k];
    held_[i].w = {d.x * d.x / m, d.y * d.y / m, d.x * d.y / m};
    if (slide.contact_sign == 0) continue;
    const double along =
        -slide.contact_sign * settings_.density * settings_.gravity * slide.curve->mean_moment_rate(s0, s1) / dot(d, d);
    add_point(along * d, push_, n_, k);
  }
}

void Model::measure(Input at) {
  std::atomic<bool> low = false;
  each_row([&](std::size_t j) {
    if (measure_row(mesh_.columns, around(j, at), gradients_.row(j)) <= lowest_triangle_) low = true;
  });
  // A flat corner between joined sides is none that counts.
  if (low && !(worst_corner(at).shape > settings_.lowest_corner)) throw_tangled(at, settings_.lowest_corner);
}

void Model::gather_forces(Input at, double weight) {
  edges_.push_down(at, weight * settings_.density * settings_.gravity, push_);
  if (forcing_.surface_pressure) {
    edges_.press([&](double place) { return forcing_.surface_pressure(place, when_.middle()); }, at, weight, push_);
  }
  hourglass_.push(mesh_, at, weight, push_);
  if (barrier_.active()) barrier_.push(mesh_, volume_, at, weight, push_);
}

void Model::advance_along(Input from, Input u, double h, Output to, bool by_tangents) const {
  Water::advance(from, u, h, to);
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double s = from[2 * n_ + i];
    const Point way = by_tangents ? slide.curve->tangent(s) : slide.direction;
    to[2 * n_ + i] = s + h * speed_along(way, point_at(u, n_, slide.node));
    put_point(slide.curve->position(to[2 * n_ + i]), to, n_, slide.node);
  }
}

void Model::enter(Input q, Output u) const {
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double speed = dot(slide.curve->tangent(q[2 * n_ + i]), point_at(u, n_, slide.node));
    put_point(speed * slide.direction, u, n_, slide.node);
  }
  for (const Driven& node : nodes_.driven()) node.put(node.rate(when_), u, n_);
}

void Model::settle(Interval when, Output q, Output u) const {
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double speed = speed_along(slide.direction, point_at(u, n_, slide.node));
    put_point(speed * slide.curve->tangent(q[2 * n_ + i]), u, n_, slide.node);
  }
  for (const Driven& node : nodes_.driven()) {
    node.put(node.place(when.end()), q, n_);
    node.put(node.velocity(when.end()), u, n_);
  }
}

void Model::curvature(Input u, Input v, Output b) const {
  // Areas are bilinear in x and y: their second derivative along u and v.
  for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
    b[cell] = cell_area(mesh_, u, v.subspan(n_), cell) + cell_area(mesh_, v, u.subspan(n_), cell);
  }
  for (const Slide& slide : nodes_.slides()) {
    const auto speed = [&](Input rates) { return dot(slide.direction, point_at(rates, n_, slide.node)); };
    const double product = speed(u) * speed(v);
    const Around cells = cells_around(slide.node);
    for (std::size_t a = 0; a < cells.count; ++a) {
      b[cells.cell[a]] += product * dot({cells.gradient[a][0], cells.gradient[a][1]}, slide.bend);
    }
  }
}

double Model::potential_energy(Input q) const {
  double moment = edges_.moment(q);
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    if (slide.contact_sign != 0) moment += slide.contact_sign * slide.curve->moment(q[2 * n_ + i]);
  }
  double energy = settings_.density * settings_.gravity * moment + hourglass_.energy(mesh_, q);
  if (barrier_.active()) energy += barrier_.energy(mesh_, volume_, q);
  return energy;
}

double longest_stable_step(const Model& model) {
  const Mesh& mesh = model.mesh();
  const Settings& settings = model.settings();
  const double area = sum(model.first_volumes());
  const double width = mesh.x[mesh.node(mesh.columns, 0)] - mesh.x[mesh.node(0, 0)];
  const bool layer = !std::holds_alternative<FreeSide>(mesh.sides.bottom) && width > 0;
  double gravity_square = 0;
  if (settings.gravity > 0 && layer) {
    const exact::LagrangianMeshDispersion law(
        settings.gravity, area / width, width / static_cast<double>(mesh.columns), mesh.rows,
        settings.tuned_surface_inertia ? exact::SurfaceInertia::tuned : exact::SurfaceInertia::nodal);
    gravity_square = std::pow(law.largest_frequency(), 2);
  }
  // r0 - r1 + r2 - r3 is four amplitudes in the fastest hourglass motion: omega^2 = 16 kappa/(rho cell's area).
  const double cell = area / static_cast<double>(mesh.cells());
  const double hourglass_square = 16 * settings.hourglass * settings.gravity / std::sqrt(cell);
  // Stiffnesses add, so the square of the fastest of their modes is at most the sum.
  const double square = gravity_square + hourglass_square;
  return square > 0 ? 2 / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

}  // namespace seiche::lagrangian_mesh_2d
