#include "validation/instruments/plan/rezoned_flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "seiche/mechanics/state.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/plan_remap.hpp"

namespace seiche::validation {

using dispersive_shallow_water_2d::Flow, dispersive_shallow_water_2d::Lattice;
using mechanics::Input;

namespace {

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

constexpr double narrowest = 0.25;  // cell along its column, of what it was
constexpr double strain = 0.3;      // of an edge, in a step
constexpr int most_parts = 8;       // of a step, by its strain
constexpr int most_halvings = 5;    // of one that fails

}  // namespace

ShoreFollowing::ShoreFollowing(const Lattice& first, RezoneSettings settings)
    : shape_(first.shape), settings_(settings) {
  for (std::size_t k = 0; k < shape_.nodes(); ++k) first_.push_back({first.x[k], first.y[k]});
  for (std::size_t i = 0; i <= shape_.columns; ++i) {
    const double length = distance(first_[i], outer(i));
    const Point way = outer(i) - first_[i];
    line_.push_back({way.x / length, way.y / length});
  }
}

ShoreFollowing::Places ShoreFollowing::places(Input q, Input volumes) const {
  const std::size_t n = shape_.nodes();
  const std::size_t count = shape_.columns + 1;
  Places places{.x = std::vector<double>(n), .y = std::vector<double>(n)};
  for (std::size_t j = 0; j < shape_.rows; ++j) {
    const plan_lattice::RowCurve row(q.subspan(j * count, count), q.subspan(n + j * count, count));
    std::vector<double> away;
    for (std::size_t i = 0; i < count; ++i) {
      const bool end = i == 0 || i == shape_.columns;
      const std::size_t k = shape_.node(i, j);
      places.put(k, end ? row.at(static_cast<double>(i)) : row.meet(i, first_[i], outer(i)));
      away.push_back(dot(places[k] - first_[k], line_[i]));
    }
    const std::vector<double> rough = pattern(away);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = shape_.node(i, j);
      places.put(k, places[k] - rough[i] * line_[i]);
    }
  }
  for (std::size_t i = 0; i < count; ++i) places.put(shape_.node(i, shape_.rows), outer(i));
  if (settings_.edge_slope > 0) draw_back_films(q, volumes, places);
  if (settings_.shore_slope > 0) cut_tongues(places);
  keep_widths(places);
  return places;
}

/// The nodes of a column within a row come nearer to it: to a part of their distances.
void ShoreFollowing::draw_back(std::size_t column, std::size_t row, double part, Places& places) const {
  const std::size_t base = shape_.node(column, row);
  for (std::size_t k = column; k < base; k += shape_.columns + 1) {
    places.put(k, {std::lerp(places.x[base], places.x[k], part), std::lerp(places.y[base], places.y[k], part)});
  }
}

/// The cells beside a column, from the shoreline to a row, are a wedge of depth h over its width b; with its water it
/// has the depth over its width asked for when it is sqrt(h/(b edge_slope)) as wide. The film is the widest wedge that
/// is too thin, as long as all within it are.
void ShoreFollowing::draw_back_films(Input q, Input volumes, Places& places) const {
  const std::size_t count = shape_.columns + 1;
  for (std::size_t i = 0; i < count; ++i) {
    double water = 0;
    double area = 0;
    double part = 1;
    std::size_t film = 0;
    for (std::size_t row = 0; row + 1 < shape_.rows; ++row) {
      const std::size_t first = row * shape_.columns;
      for (const std::size_t cell : {first + (i > 0 ? i - 1 : 0), first + std::min(i, shape_.columns - 1)}) {
        water += volumes[cell];
        area += cell_area(shape_, q, q.subspan(shape_.nodes()), cell);
      }
      const double slope = 2 * water / area / distance(places[i], places[shape_.node(i, row + 1)]);
      if (!(slope < settings_.edge_slope)) break;
      part = std::sqrt(slope / settings_.edge_slope);
      film = row + 1;
    }
    draw_back(i, film, part, places);
  }
}

void ShoreFollowing::cut_tongues(Places& places) const {
  constexpr double least_left = 0.7;  // of a pressed cell's width
  const std::size_t count = shape_.columns + 1;
  const auto outwards = [&](std::size_t i, std::size_t j) {
    return dot(places[shape_.node(i, j)] - first_[i], line_[i]);
  };
  std::vector<double> shore(count);
  for (std::size_t i = 0; i < count; ++i) shore[i] = outwards(i, 0);
  const auto limit = [&](std::size_t i, std::size_t beside) {
    const double least = shore[beside] - settings_.shore_slope * distance(first_[i], first_[beside]);
    if (shore[i] < least) shore[i] = least;
  };
  for (std::size_t i = 1; i < count; ++i) limit(i, i - 1);
  for (std::size_t i = count - 1; i-- > 0;) limit(i, i + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double was = outwards(i, 0);
    if (!(shore[i] > was)) continue;
    std::size_t row = 1;
    while (row + 1 < shape_.rows && outwards(i, row) - shore[i] < least_left * (outwards(i, row) - was)) ++row;
    const double base = outwards(i, row);
    const double part = (base - shore[i]) / (base - was);
    draw_back(i, row, part, places);
  }
}

void ShoreFollowing::keep_widths(Places& places) const {
  for (std::size_t j = 1; j < shape_.rows; ++j) {
    for (std::size_t i = 0; i <= shape_.columns; ++i) {
      const std::size_t k = shape_.node(i, j);
      const std::size_t inner = shape_.node(i, j - 1);
      const double width = dot(places[k] - places[inner], line_[i]);
      const double lacking = narrowest * distance(first_[inner], first_[k]) - width;
      if (lacking > 0) places.put(k, places[k] + lacking * line_[i]);
    }
  }
}

RezonedFlow::RezonedFlow(Lattice lattice, const dispersive_shallow_water_2d::InitialVelocity& velocity,
                         mechanics::Scheme scheme, dispersive_shallow_water_2d::Settings settings,
                         RezoneSettings rezone)
    : following_(lattice, rezone),
      scheme_(scheme),
      settings_(rezone),
      flow_(std::make_unique<Flow>(std::move(lattice), velocity, scheme, std::move(settings),
                                   dispersive_shallow_water_2d::Forcing{}, plan_lattice::Window{}, false)) {}

std::vector<Invariant> RezonedFlow::invariants() const {
  std::vector<Invariant> all = flow_->invariants();
  const auto energy = std::find_if(all.begin(), all.end(), [](const Invariant& i) { return i.name == "energy"; });
  energy->value += base_;
  energy->booked -= lost_;
  return all;
}

void RezonedFlow::advance(double tau) {
  mechanics::require_step(tau);
  const double strained = std::ceil(rate_of_strain() * tau / strain);
  double step = tau / std::clamp(strained, 1.0, static_cast<double>(most_parts));
  double left = tau;
  bool failed = false;
  for (int halvings = 0; left > 1e-9 * tau;) {
    follow(failed);
    try {
      flow_->advance(std::min(step, left));
      left -= step;
      failed = false;
    } catch (const Divergence& failure) {
      if (halvings == most_halvings) throw Divergence(failure.what(), time(), steps(), failure.place());
      failed = true;
      halved_ += halvings == 0 ? 1 : 0;
      ++halvings;
      step /= 2;
    }
  }
}

/// Of the edges of all cells, by the velocities of their ends.
double RezonedFlow::rate_of_strain() const {
  const Input q = flow_->state().q;
  const Input u = flow_->state().u;
  const std::size_t n = flow_->shape().nodes();
  Largest fastest;
  flow_->shape().each_edge([&](std::size_t from, std::size_t to, std::size_t, std::size_t) {
    const double change = std::hypot(u[to] - u[from], u[n + to] - u[n + from]);
    fastest.add(change / distance({q[from], q[n + from]}, {q[to], q[n + to]}));
  });
  return fastest.value();
}

/// Rezones where nodes have drifted too far, or anyway.
void RezonedFlow::follow(bool anyway) {
  const ShoreFollowing::Places places = following_.places(flow_->state().q, flow_->model().first_volumes());
  if (!anyway && !(following_.drift(flow_->state().q, places) > settings_.drift)) return;
  try {
    rezone(places);
  } catch (const std::runtime_error&) {  // Infeasible, and Divergence of a new flow that cannot begin
    ++refused_;
  } catch (const std::invalid_argument&) {  // a surface that leaves a cell without water
    ++refused_;
  }
}

void RezonedFlow::rezone(const ShoreFollowing::Places& places) {
  const auto& model = flow_->model();
  const mechanics::State& state = flow_->state();
  auto now = remap(model, state.q, state.u, places.x, places.y);
  auto flow = std::make_unique<Flow>(std::move(now.lattice), std::move(now.velocity), scheme_, model.settings(),
                                     dispersive_shallow_water_2d::Forcing{}, plan_lattice::Window{}, false);
  flow->continue_breaking(*flow_);
  // Of both lattices the potential counts from the first one's shoreline: its ways do not meet the bottom's moment.
  const mechanics::State& next = flow->state();
  const double before = flow_->energy();
  const double potential = model.potential_energy(next.q);
  const double after = flow->model().kinetic_energy(next.q, next.u) + potential;
  base_ += potential - flow->model().potential_energy(next.q);
  lost_ += before - after;
  displaced_ += now.displaced;
  begin_ += flow_->time();
  steps_ += flow_->steps();
  ++rezoned_;
  flow_ = std::move(flow);
}

}  // namespace seiche::validation
