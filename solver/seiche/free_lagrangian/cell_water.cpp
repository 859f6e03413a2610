#include "seiche/free_lagrangian/cell_water.hpp"

#include <algorithm>

#include "seiche/compensated_sum.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/step_parts.hpp"
#include "seiche/require.hpp"

namespace seiche::free_lagrangian {

namespace {

double mean_square(double a, double b) {
  return (a * a + a * b + b * b) / 6;
}

}  // namespace

double potential_energy(Places at, std::span<const int> outline, double weight) {
  CompensatedSum sum;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const Point a = at[outline[e]];
    const Point b = at[outline[e + 1 == outline.size() ? 0 : e + 1]];
    sum.add((a.x - b.x) * mean_square(a.y, b.y));
  }
  return weight * sum.value();
}

void gravity_forces(Places at, std::span<const int> outline, double weight, std::vector<Point>& force) {
  std::fill(force.begin(), force.end(), Point{});
  if (weight == 0) return;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const int a = outline[e];
    const int b = outline[e + 1 == outline.size() ? 0 : e + 1];
    const Point ra = at[a];
    const Point rb = at[b];
    Point& fa = force[static_cast<std::size_t>(a)];
    Point& fb = force[static_cast<std::size_t>(b)];
    const double along = weight * mean_square(ra.y, rb.y);
    const double width = weight * (ra.x - rb.x) / 6;
    fa.x -= along;
    fb.x += along;
    fa.y -= width * (2 * ra.y + rb.y);
    fb.y -= width * (2 * rb.y + ra.y);
  }
}

CellWater::CellWater(const Mesh& mesh, Settings settings)
    : settings_(settings),
      first_x_(mesh.x),
      first_y_(mesh.y),
      outline_(mesh.outline),
      pressure_(mesh, settings.stabilisation),
      freedom_(freedoms(mesh)),
      force_(mesh.nodes()) {
  require_not_negative("gravity", settings.gravity);
  require_positive("density", settings.density);
  std::vector<double> masses = first_areas(mesh, pressure_.triangulation().mesh());
  for (double& mass : masses) mass *= settings.density;
  set_masses(masses);
}

void CellWater::set_masses(std::span<const double> masses) {
  mass_.assign(masses.begin(), masses.end());
  mobility_.resize(mass_.size());
  for (std::size_t k = 0; k < mass_.size(); ++k) mobility_[k] = freedom_[k].over(mass_[k]);
}

mechanics::State CellWater::state(const VelocityAt& velocity, double time) const {
  const std::size_t n = nodes();
  mechanics::State state{.q = first_x_, .u = std::vector<double>(rates(), 0.0), .time = time};
  state.q.insert(state.q.end(), first_y_.begin(), first_y_.end());
  if (!velocity) return state;
  for (std::size_t k = 0; k < n; ++k) {
    const Point allowed = freedom_[k](velocity({first_x_[k], first_y_[k]}));
    state.u[k] = allowed.x;
    state.u[n + k] = allowed.y;
  }
  return state;
}

void CellWater::linearise(Interval /*when*/, Input q) {
  pressure_.measure(places(q));
  pressure_.factor(mobility_);
  gravity_forces(places(q), outline_, weight(), force_);
}

void CellWater::advance(Input from, Input u, double h, Output to) const {
  next_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) next_[i] = from[i] + h * u[i];
  pressure_.follow(places(next_));
  std::copy(next_.begin(), next_.end(), to.begin());
}

void CellWater::kick(double h, Output u) const {
  for (std::size_t k = 0; k < nodes(); ++k) {
    const Point acceleration = mobility_[k](force_[k]);
    u[k] += h * acceleration.x;
    u[nodes() + k] += h * acceleration.y;
  }
}

void CellWater::constraint_values(Input q, Output f) const {
  pressure_.areas(places(q), f);
  for (std::size_t k = 0; k < nodes(); ++k) f[k] -= mass_[k] / settings_.density;
}

std::vector<double> pressure_of_release(CellWater& water, const mechanics::State& rest) {
  mechanics::require_state(rest, water.coordinates(), water.rates());
  water.linearise({rest.time, 0}, rest.q);
  std::vector<double> acceleration(water.rates(), 0.0);
  std::vector<double> pressure(water.constraints(), 0.0);
  water.kick(1, acceleration);
  mechanics::Projection(water).project(acceleration, {}, pressure);
  return pressure;
}

}  // namespace seiche::free_lagrangian
