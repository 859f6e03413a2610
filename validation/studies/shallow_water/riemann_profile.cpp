#include "validation/studies/shallow_water/riemann_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

constexpr double most_cells = 2000;    ///< over the channel, of those that limits are for
constexpr double most_of_time = 0.25;  ///< beyond it a celerity says nothing
constexpr double wet_share = 1e-3;     ///< of the deepest water

/// Integral of a quantity that is a polynomial of degree 5 at most between the waves: exact but for rounding.
double integral_of(const exact::Riemann& solution, double time, double from, double to,
                   const std::function<double(const State&)>& quantity) {
  constexpr std::array points{0.112701665379258311, 0.5, 0.887298334620741689};  // Gauss and Legendre
  constexpr std::array weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  std::vector<double> ends{from, to};
  for (const double wave : solution.breakpoints(time)) {
    if (wave > from && wave < to) ends.push_back(wave);
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      sum += (ends[i + 1] - ends[i]) * weights[k] *
             quantity(solution.at(std::lerp(ends[i], ends[i + 1], points[k]), time));
    }
  }
  return sum;
}

/// Where one wave alone is meant, the other is a jump of the height of rounding.
bool visible_jump(const exact::Riemann& solution, const exact::Riemann::Wave& wave, const State& outer) {
  const double middle = solution.star().depth;
  return wave.kind == exact::Riemann::Kind::jump && middle - outer.depth > 1e-9 * middle;
}

double fastest(const State& state, double gravity) {
  return std::abs(state.velocity) + std::sqrt(gravity * state.depth);
}

/// Of the fastest wave [m].
double way(const exact::Riemann& solution, double time) {
  return worst(each(solution.breakpoints(time), [&](double place) { return place - solution.jump(); }));
}

/// What Rusanov's scheme makes of it: of first order, and the most viscous of those in use. Cells beyond the channel's
/// ends let waves leave.
ProfilePoints by_rusanov(const exact::Riemann& solution, double time, double start, double end, double cell,
                         double viscosity) {
  const double g = solution.gravity();
  const auto beyond = static_cast<std::size_t>(std::ceil(way(solution, time) / cell)) + 8;
  const auto inside = static_cast<std::size_t>(std::max(4.0, std::round((end - start) / cell)));
  const double dx = (end - start) / static_cast<double>(inside);
  const std::size_t n = inside + 2 * beyond;
  const auto centre = [&](std::size_t i) {
    return start + (static_cast<double>(i) + 0.5 - static_cast<double>(beyond)) * dx;
  };
  std::vector<double> h(n), q(n), mass(n + 1), thrust(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double left = std::clamp((solution.jump() - centre(i)) / dx + 0.5, 0.0, 1.0);
    h[i] = std::lerp(solution.right().depth, solution.left().depth, left);
    q[i] = std::lerp(solution.right().depth * solution.right().velocity,
                     solution.left().depth * solution.left().velocity, left);
  }
  const auto velocity = [&](std::size_t i) { return h[i] > 0 ? q[i] / h[i] : 0.0; };
  constexpr double courant = 0.4;  // below what codes run with, 0.45 to 0.9: the loss grows as it falls
  for (double left = time; left > 0;) {
    Largest speed;
    for (std::size_t f = 1; f < n; ++f) {
      const State l{h[f - 1], velocity(f - 1)};
      const State r{h[f], velocity(f)};
      const double s = viscosity * std::max(fastest(l, g), fastest(r, g));
      speed.add(s);
      mass[f] = 0.5 * (q[f - 1] + q[f] - s * (r.depth - l.depth));
      thrust[f] = 0.5 * (shallow_water::thrust(g, l.depth) + q[f - 1] * l.velocity + shallow_water::thrust(g, r.depth) +
                         q[f] * r.velocity - s * (q[f] - q[f - 1]));
    }
    const double tau = std::min(courant * dx / speed.value(), left);
    left -= tau;
    for (std::size_t i = 1; i + 1 < n; ++i) {
      h[i] -= tau / dx * (mass[i + 1] - mass[i]);
      q[i] -= tau / dx * (thrust[i + 1] - thrust[i]);
    }
  }
  ProfilePoints points;
  for (std::size_t i = beyond; i < beyond + inside; ++i) points.add(centre(i), {h[i], velocity(i)});
  return points;
}

/// What points lose that are joined by straight lines: half of their distance at a jump, and an eighth of its square
/// times the variation of the slope in a fan, which is 2 c/(3 g t), in discharge the speed of the ray times that.
RiemannErrors lost_between_points(const exact::Riemann& solution, double time, double length, double apart) {
  RiemannErrors lost;
  const State star = solution.star();
  for (const auto& [wave, outer] :
       {std::pair{solution.left_wave(), solution.left()}, std::pair{solution.right_wave(), solution.right()}}) {
    if (wave.kind == exact::Riemann::Kind::jump) {
      const double depth = std::abs(outer.depth - star.depth);
      const double discharge = std::abs(outer.depth * outer.velocity - star.depth * star.velocity);
      lost.depth += apart / 4 * depth / length;
      lost.discharge += apart / 4 * discharge / length;
      lost.volume += apart / 2 * depth;
      lost.momentum += apart / 2 * discharge;
    }
    if (wave.kind != exact::Riemann::Kind::fan) continue;
    constexpr int samples = 64;
    double before = 0;
    double before_discharge = 0;
    for (int k = 0; k <= samples + 1; ++k) {
      const double speed = std::lerp(wave.slowest, wave.fastest, std::min(k, samples) / double{samples});
      const double slope = k > samples ? 0
                                       : 2 * std::sqrt(solution.gravity() * solution.sample(speed).depth) /
                                             (3 * solution.gravity() * time);
      lost.volume += apart * apart / 8 * std::abs(slope - before);
      lost.momentum += apart * apart / 8 * std::abs(speed * slope - before_discharge);
      before = slope;
      before_discharge = speed * slope;
    }
  }
  lost.front = apart / 2;
  lost.celerity = apart / 2 / way(solution, time);
  return lost;
}

/// What is wrong with water that never moved, as means over a channel of this length.
MeanErrors errors_of_the_initial_state(const exact::Riemann& solution, double time, double length) {
  const std::vector<double> waves = solution.breakpoints(time);
  MeanErrors errors;
  constexpr int samples = 4096;
  const double from = std::min(waves.front(), solution.jump());
  const double width = (std::max(waves.back(), solution.jump()) - from) / samples;
  for (int k = 0; k < samples; ++k) {
    const double x = from + (k + 0.5) * width;
    const State exact = solution.at(x, time);
    const State& first = x < solution.jump() ? solution.left() : solution.right();
    errors.depth += std::abs(first.depth - exact.depth) * width / length;
    errors.discharge += std::abs(first.depth * first.velocity - exact.depth * exact.velocity) * width / length;
  }
  return errors;
}

}  // namespace

bool has_front(const exact::Riemann& solution) {
  return judged_front(solution, 1).is_jump || solution.left().depth == 0 || solution.right().depth == 0;
}

JudgedFront judged_front(const exact::Riemann& solution, double time) {
  const double middle = solution.star().depth;
  const auto place = [&](double speed) { return solution.jump() + speed * time; };
  // Half way from the jump to the nearest other wave.
  const double reach = 0.5 * time * (solution.right_wave().slowest - solution.left_wave().fastest);
  if (visible_jump(solution, solution.right_wave(), solution.right())) {
    return {{middle, solution.right().depth, place(solution.right_wave().fastest), reach}, true};
  }
  if (visible_jump(solution, solution.left_wave(), solution.left())) {
    return {{middle, solution.left().depth, place(solution.left_wave().slowest), reach}, true};
  }
  if (solution.left().depth == 0) return {{0, 0, solution.breakpoints(time).front(), 0}, false};
  return {{0, 0, solution.breakpoints(time).back(), 0}, false};
}

double judged_position(const exact::Riemann& solution, const JudgedFront& judged, const Profile& profile,
                       bool particles) {
  if (judged.is_jump) return front_position(profile, judged.front);
  if (solution.left().depth > 0 && solution.right().depth > 0) return nan;
  if (particles) return solution.left().depth == 0 ? profile.edges.front() : profile.edges.back();
  const auto deepest = over<Largest>(profile.means, &State::depth);
  if (!(deepest.value() > 0)) return nan;
  const auto is_wet = [&](const State& mean) { return mean.depth > wet_share * deepest.value(); };
  if (solution.left().depth == 0) {
    const auto first = std::find_if(profile.means.begin(), profile.means.end(), is_wet) - profile.means.begin();
    return profile.edges[static_cast<std::size_t>(first)];
  }
  const auto last = profile.means.rend() - std::find_if(profile.means.rbegin(), profile.means.rend(), is_wet);
  return profile.edges[static_cast<std::size_t>(last)];
}

/// The factor of the time at which the exact depth is nearest to that of the points.
double celerity_of(const exact::Riemann& solution, double time, const ProfilePoints& points) {
  const auto off = [&](double factor, int samples) {
    const auto exact = [&](double place) { return solution.at(place, factor * time); };
    return mean_errors(points, exact, samples).depth;
  };
  constexpr int grid = 20;
  constexpr double reach = 0.5;
  constexpr int coarse = 16;
  constexpr int fine = 64;  // how closely a jump is placed
  Smallest least;
  for (int k = -grid; k <= grid; ++k) least.add(off(1 + reach * k / grid, coarse), 1 + reach * k / grid);
  double best = least.where();
  double lowest = off(best, fine);
  for (double step = reach / grid / 2; step > 1e-4; step /= 2) {
    for (const double candidate : {best - step, best + step}) {
      if (const double here = off(candidate, fine); here < lowest) {
        lowest = here;
        best = candidate;
      }
    }
  }
  return best;
}

/// How far water deeper than this reaches towards the dry side.
double wet_end(const ProfilePoints& points, double level, bool dry_left) {
  const auto& [x, h, u] = points;
  const std::size_t n = x.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = dry_left ? k : n - 1 - k;
    if (!(h[i] >= level)) continue;
    if (k == 0) return x[i];
    const std::size_t dry = dry_left ? i - 1 : i + 1;
    return std::lerp(x[i], x[dry], (h[i] - level) / (h[i] - h[dry]));
  }
  return nan;
}

/// Position of the bore, or of the end of the water, less the exact one.
double front_error(const exact::Riemann& solution, double time, const ProfilePoints& points) {
  const JudgedFront judged = judged_front(solution, time);
  if (judged.is_jump) return front_position(points.cells(), judged.front) - judged.front.position;
  if (!has_front(solution)) return nan;
  const bool dry_left = solution.left().depth == 0;
  const double level = wet_share * std::max(solution.left().depth, solution.right().depth);
  const exact::Riemann::Wave fan = dry_left ? solution.right_wave() : solution.left_wave();
  double wet = dry_left ? fan.fastest : fan.slowest;
  double dry = dry_left ? fan.slowest : fan.fastest;
  for (int k = 0; k < 60; ++k) {
    const double middle = std::midpoint(wet, dry);
    (solution.sample(middle).depth >= level ? wet : dry) = middle;
  }
  return wet_end(points, level, dry_left) - (solution.jump() + wet * time);
}

RiemannErrors riemann_errors(const exact::Riemann& solution, double time, const ProfilePoints& points) {
  const auto& [x, h, u] = points;
  RiemannErrors errors{mean_errors(points, [&](double place) { return solution.at(place, time); })};
  double volume = 0;
  double momentum = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    volume += 0.5 * (x[i + 1] - x[i]) * (h[i] + h[i + 1]);
    momentum += 0.5 * (x[i + 1] - x[i]) * (h[i] * u[i] + h[i + 1] * u[i + 1]);
  }
  errors.volume = volume - integral_of(solution, time, x.front(), x.back(), [](const State& s) { return s.depth; });
  errors.momentum =
      momentum - integral_of(solution, time, x.front(), x.back(), [](const State& s) { return s.depth * s.velocity; });
  errors.front = front_error(solution, time, points);
  errors.celerity = celerity_of(solution, time, points) - 1;
  return errors;
}

std::vector<RiemannRequirement> riemann_requirements(const exact::Riemann& solution, double time, double start,
                                                     double end, double cell, double apart, double viscosity) {
  const double length = end - start;
  const double deepest = std::max({solution.left().depth, solution.right().depth, solution.star().depth});
  const double rounding = 1e-12 * deepest;
  const double finest = std::max(cell, length / most_cells);
  const RiemannErrors lost = riemann_errors(solution, time, by_rusanov(solution, time, start, end, finest, viscosity));
  const RiemannErrors between = lost_between_points(solution, time, length, std::max(finest, apart));
  const MeanErrors untouched = errors_of_the_initial_state(solution, time, length);
  const std::string reason = fmt::format(
      "the error of Rusanov's scheme, first-order and the most viscous in use, on cells of {:.3g} m{}, and the error "
      "of points {:.3g} m apart at a jump, half of that distance",
      finest, viscosity > 1 ? fmt::format(" with {:.3g} times its viscosity", viscosity) : "", std::max(finest, apart));
  // Integrals lose both; a celerity one or the other. A front loses both: its cells begin with the jump anywhere in
  // one.
  const auto sum = [&](double RiemannErrors::*error, double least) {
    return std::max(std::abs(lost.*error) + between.*error, least);
  };
  const auto either = [&](double RiemannErrors::*error) {
    const double here = std::abs(lost.*error);
    return std::isnan(here) ? between.*error : std::max(here, between.*error);
  };
  const auto within = [&](const evidence::Amount& limit) { return Bound{.limit = limit, .reason = reason}; };
  const auto mean = [&](double RiemannErrors::*error, double at_rest) {
    return Bound{.limit = evidence::Amount::at_most(sum(error, rounding), std::max(0.5 * at_rest, rounding)),
                 .reason = reason + ". Conclusive while below half of the error of water at rest"};
  };
  std::vector<RiemannRequirement> all = {
      {"depth", "The mean depth error is at most the error of Rusanov's first-order scheme on the same cells.",
       "mean |h - exact|", "m", &RiemannErrors::depth, mean(&RiemannErrors::depth, untouched.depth)},
      {"discharge", "The mean discharge error is at most the error of Rusanov's first-order scheme on the same cells.",
       "mean |h u - exact|", "m^2/s", &RiemannErrors::discharge, mean(&RiemannErrors::discharge, untouched.discharge)},
      {"volume", "The water volume between the first and the last point equals the exact volume.",
       "volume minus the exact volume", "m^2", &RiemannErrors::volume,
       within(sum(&RiemannErrors::volume, rounding * length))},
      {"momentum-held", "The momentum between the first and the last point equals the exact momentum.",
       "momentum minus the exact momentum", "m^3/s", &RiemannErrors::momentum,
       within(sum(&RiemannErrors::momentum, rounding * length))},
      {"celerity", "The distance that waves have travelled agrees with the exact solution.",
       "relative time shift of the best fit of the depth", "1", &RiemannErrors::celerity,
       within(evidence::Amount::at_most(either(&RiemannErrors::celerity), most_of_time))}};
  if (has_front(solution)) {
    all.push_back({"front", "The front position, of the bore or on a dry bed, agrees with the exact solution.",
                   "position minus the exact position", "m", &RiemannErrors::front,
                   within(either(&RiemannErrors::front) + between.front)});
  }
  return all;
}

}  // namespace seiche::validation
