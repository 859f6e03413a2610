#include "seiche/models/dispersive_shallow_water_2d/rezone.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "seiche/mechanics/equal_steps.hpp"
#include "seiche/models/dispersive_shallow_water_2d/remap.hpp"
#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// What a sequence has of the pattern + - + -, by its fourth difference; it goes on symmetrically beyond its ends.
std::vector<double> pattern(const std::vector<double>& values) {
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  const auto at = [&](std::ptrdiff_t k) {
    return values[static_cast<std::size_t>(k < 0 ? -k : k > last ? 2 * last - k : k)];
  };
  std::vector<double> part;
  for (std::ptrdiff_t k = 0; k <= last; ++k) {
    part.push_back((at(k - 2) - 4 * at(k - 1) + 6 * at(k) - 4 * at(k + 1) + at(k + 2)) / 16);
  }
  return part;
}

}  // namespace

ShoreFollowing::ShoreFollowing(const Lattice& first) : shape_(first.shape) {
  if (!std::holds_alternative<plan_lattice::ShoreSide>(first.sides.south)) {
    throw std::invalid_argument("a lattice without a shoreline on its south side; allowed: one with it");
  }
  require_at_least("columns", static_cast<long>(shape_.columns), 3);
  for (std::size_t k = 0; k < shape_.nodes(); ++k) first_.push_back({first.x[k], first.y[k]});
  for (std::size_t i = 0; i <= shape_.columns; ++i) {
    const double length = distance(first_[i], outer(i));
    line_.push_back({(outer(i).x - first_[i].x) / length, (outer(i).y - first_[i].y) / length});
  }
}

ShoreFollowing::Places ShoreFollowing::places(Input q) const {
  const std::size_t n = shape_.nodes();
  const std::size_t count = shape_.columns + 1;
  Places places;
  for (std::size_t j = 0; j < shape_.rows; ++j) {
    const plan_lattice::RowCurve row(q.subspan(j * count, count), q.subspan(n + j * count, count));
    std::vector<double> away;
    for (std::size_t i = 0; i < count; ++i) {
      const bool end = i == 0 || i == shape_.columns;
      const Point place = end ? row.at(static_cast<double>(i)) : row.meet(i, first_[i], outer(i));
      places.x.push_back(place.x);
      places.y.push_back(place.y);
      const Point from = first_[shape_.node(i, j)];
      away.push_back((place.x - from.x) * line_[i].x + (place.y - from.y) * line_[i].y);
    }
    const std::vector<double> rough = pattern(away);
    for (std::size_t i = 0; i < count; ++i) {
      places.x[shape_.node(i, j)] -= rough[i] * line_[i].x;
      places.y[shape_.node(i, j)] -= rough[i] * line_[i].y;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    places.x.push_back(outer(i).x);
    places.y.push_back(outer(i).y);
  }
  return places;
}

double ShoreFollowing::drift(Input q, const Places& places) const {
  const std::size_t n = shape_.nodes();
  return plan_lattice::farthest(shape_, q.first(n), q.subspan(n, n), places);
}

RezonedFlow::RezonedFlow(Lattice lattice, const InitialVelocity& velocity, Scheme scheme, Settings settings,
                         RezoneSettings rezone)
    : following_(lattice),
      scheme_(scheme),
      settings_(rezone),
      flow_(std::make_unique<Flow>(std::move(lattice), velocity, scheme, std::move(settings), Forcing{}, Window{},
                                   false)) {
  require_within("drift", rezone.drift, 1e-6, 2);
  if (flow_->model().has_driven_sides()) throw std::invalid_argument("a rezoned lattice with driven sides");
}

void RezonedFlow::advance_to(double time, double tau, const std::function<void()>& after_step) {
  mechanics::State clock{.q = {}, .u = {}, .time = this->time(), .steps = steps()};
  mechanics::equal_steps_to(
      clock, time, tau,
      [&](double length) {
        const ShoreFollowing::Places places = following_.places(flow_->state().q);
        if (following_.drift(flow_->state().q, places) > settings_.drift) {
          try {
            rezone(places);
          } catch (const mechanics::Infeasible&) {
            ++refused_;
          } catch (const Divergence&) {  // a new flow that cannot begin
            ++refused_;
          }
        }
        try {
          flow_->advance(length);
        } catch (const Divergence& failure) {
          throw Divergence(failure.what(), this->time(), steps(), failure.place());
        }
        clock.time = this->time();
        clock.steps = steps();
      },
      after_step);
}

void RezonedFlow::rezone(const ShoreFollowing::Places& places) {
  const Model& model = flow_->model();
  const mechanics::State& state = flow_->state();
  Remapped now = remap(model, state.q, state.u, places.x, places.y);
  std::vector<Velocity> velocity;
  for (std::size_t k = 0; k < model.nodes(); ++k) velocity.push_back({now.u[k], now.v[k], now.w[k]});
  auto flow = std::make_unique<Flow>(std::move(now.lattice), std::move(velocity), scheme_, model.settings(), Forcing{},
                                     Window{}, false);
  // Of both lattices the potential counts from the first one's shoreline: its ways do not meet the bottom's moment.
  const mechanics::State& next = flow->state();
  const double before = flow_->energy();
  const double potential = model.potential_energy(next.q);
  const double after = flow->model().kinetic_energy(next.q, next.u) + potential;
  base_ += potential - flow->model().potential_energy(next.q);
  lost_ += before - after;
  begin_ += flow_->time();
  steps_ += flow_->steps();
  ++rezoned_;
  flow_ = std::move(flow);
}

}  // namespace seiche::dispersive_shallow_water_2d
