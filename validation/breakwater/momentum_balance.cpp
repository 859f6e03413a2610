#include "validation/breakwater/momentum_balance.hpp"

#include <cmath>
#include <numeric>

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;
using lagrangian_mesh_2d::Slide;

MomentumBalance::MomentumBalance(const Flow& flow, double tau) : flow_(&flow), tau_(tau) {
  remember();
}

void MomentumBalance::remember() {
  q_ = flow_->state().q;
  u_ = flow_->state().u;
  time_ = flow_->time();
}

MomentumBalance::Forces MomentumBalance::forces(const std::vector<double>& middle) const {
  const auto& model = flow_->model();
  const Mesh& mesh = model.mesh();
  const std::size_t n = mesh.nodes();
  const double weight = model.settings().density * model.settings().gravity;
  const auto x = [&](std::size_t k) { return middle[k]; };
  const auto y = [&](std::size_t k) { return middle[n + k]; };
  const double mean_area =
      std::accumulate(model.first_volumes().begin(), model.first_volumes().end(), 0.0) / static_cast<double>(mesh.cells());
  const double stiffness = model.settings().hourglass * weight * std::sqrt(mean_area);
  Forces f{.x = std::vector<double>(n, 0.0), .y = std::vector<double>(n, 0.0)};
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto r = mesh.corners(cell);
    const double lambda = flow_->multipliers()[cell];
    for (std::size_t c = 0; c < 4; ++c) {
      // dV/dr of corner c: half the diagonal between its neighbours, turned.
      const std::size_t next = r[(c + 1) % 4];
      const std::size_t last = r[(c + 3) % 4];
      f.x[r[c]] += 0.5 * lambda * (y(next) - y(last));
      f.y[r[c]] -= 0.5 * lambda * (x(next) - x(last));
    }
    const auto alternating = [&](const auto& at) { return at(r[0]) - at(r[1]) + at(r[2]) - at(r[3]); };
    const double hx = stiffness * (alternating(x) - alternating([&](std::size_t k) { return mesh.x[k]; }));
    const double hy = stiffness * (alternating(y) - alternating([&](std::size_t k) { return mesh.y[k]; }));
    for (std::size_t c = 0; c < 4; ++c) {
      f.x[r[c]] -= c % 2 == 0 ? hx : -hx;
      f.y[r[c]] -= c % 2 == 0 ? hy : -hy;
    }
  }
  for (std::size_t i = 0; i < mesh.columns; ++i) {
    const std::size_t a = mesh.node(i, mesh.rows);
    const std::size_t b = a + 1;
    const double push = weight * (y(a) * y(a) + y(a) * y(b) + y(b) * y(b)) / 6;
    f.x[a] += push;
    f.x[b] -= push;
    f.y[a] -= weight * (x(b) - x(a)) * (2 * y(a) + y(b)) / 6;
    f.y[b] -= weight * (x(b) - x(a)) * (y(a) + 2 * y(b)) / 6;
  }
  return f;
}

MomentumBalance::Step MomentumBalance::after_step() {
  const auto& model = flow_->model();
  const Mesh& mesh = model.mesh();
  const std::size_t n = mesh.nodes();
  const auto& q = flow_->state().q;
  const auto& u = flow_->state().u;
  std::vector<double> middle(q_.size());
  for (std::size_t i = 0; i < 2 * n; ++i) middle[i] = q_[i] + 0.5 * tau_ * u_[i];
  const auto slides = model.nodes().slides();
  for (std::size_t i = 0; i < slides.size(); ++i) {
    const Slide& slide = slides[i];
    const Point before = slide.curve->tangent(q_[2 * n + i]);
    const double speed = before.x * u_[slide.node] + before.y * u_[n + slide.node];
    middle[2 * n + i] = q_[2 * n + i] + 0.5 * tau_ * speed;
    const Point place = slide.curve->position(middle[2 * n + i]);
    middle[slide.node] = place.x;
    middle[n + slide.node] = place.y;
  }
  const Forces f = forces(middle);
  Step step{.time = time_ + 0.5 * tau_};
  for (std::size_t j = 0; j <= mesh.rows; ++j) {
    step.left -= f.x[mesh.node(0, j)];
    step.right -= f.x[mesh.node(mesh.columns, j)];
  }
  for (std::size_t i = 0; i < slides.size(); ++i) {
    const std::size_t k = slides[i].node;
    const Point t0 = slides[i].curve->tangent(q_[2 * n + i]);
    const Point t = slides[i].curve->tangent(middle[2 * n + i]);
    const Point t1 = slides[i].curve->tangent(q[2 * n + i]);
    const double speed0 = t0.x * u_[k] + t0.y * u_[n + k];
    const double speed1 = t1.x * u[k] + t1.y * u[n + k];
    const double along = f.x[k] * t.x + f.y[k] * t.y;
    const double turning = (speed1 * (t1.x - t.x) - speed0 * (t0.x - t.x)) / tau_;
    step.bottom += along * t.x - f.x[k] + model.nodes().mass()[k] * turning;
  }
  for (std::size_t k = 0; k < n; ++k) step.rate += model.nodes().mass()[k] * (u[k] - u_[k]) / tau_;
  remember();
  return step;
}

}  // namespace seiche::validation
