#include "validation/studies/shallow_water/riemann_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

/// Largest less smallest value of a quantity of the exact states, fans included.
double range_of(const exact::Riemann& solution, double time, const std::function<double(const State&)>& quantity) {
  Largest highest;
  Smallest lowest;
  const auto add = [&](const State& state) {
    highest.add(quantity(state));
    lowest.add(quantity(state));
  };
  for (const State& state : {solution.left(), solution.star(), solution.right()}) add(state);
  const std::vector<double> waves = solution.breakpoints(time);
  constexpr int samples = 256;
  for (int k = 0; k <= samples; ++k)
    add(solution.at(std::lerp(waves.front(), waves.back(), k / double{samples}), time));
  return highest.value() - lowest.value();
}

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

/// What a scheme of first order loses at the waves.
struct Lost {
  double depth = 0;      ///< integral of |h - exact| [m^2]
  double discharge = 0;  ///< of |h u - exact| [m^3/s]
  double sent = 0;       ///< volume of it that fans have sent and the other wave has received [m^2]
  double bore = 0;       ///< height of the higher jump [m]; NaN where there is none
};

/// On a ray x = speed t of a fan h_x = 2 c/(3 g t) and (h u)_x = speed h_x. A viscosity s dx/2 rounds the fan from its
/// birth, one cell wide, until it is n cells wide; the integral of the viscosity times |h_xx| over place and time is
/// ln(n) s dx/2 times the variation of t h_x: its corners, and what is between. What is displaced between travels with
/// the other family. @param later  when that arrives at the other wave, over when it left
void add_fan(Lost& lost, const exact::Riemann& solution, const exact::Riemann::Wave& fan, double cells, double later,
             double per_speed) {
  const double wide = std::log1p(cells);
  const double arrived = std::log1p(cells / later);
  const double g = solution.gravity();
  constexpr int samples = 64;
  double before = 0;
  double before_discharge = 0;
  const auto add = [&](double s, double slope, double speed) {
    lost.depth += per_speed * wide * s * std::abs(slope - before);
    lost.discharge += per_speed * wide * s * std::abs(speed * slope - before_discharge);
    before = slope;
    before_discharge = speed * slope;
  };
  double last = 0;
  for (int k = 0; k <= samples; ++k) {
    const double speed = std::lerp(fan.slowest, fan.fastest, k / double{samples});
    const State state = solution.sample(speed);
    last = std::max(fastest(state, g), std::abs(speed));  // the speed alone at a dry front
    const double slope = 2 * std::sqrt(g * state.depth) / (3 * g);
    if (k > 0) lost.sent += per_speed * arrived * last * std::abs(slope - before);
    add(last, slope, speed);
  }
  add(last, 0, 0);
}

/// When what leaves a fan's inner end arrives at the wave on the other side, over when it left: it crosses the uniform
/// middle as the family of that wave, which is faster than a jump of its own.
double arrives_later(const exact::Riemann& solution, bool fan_is_left) {
  const exact::Riemann::Wave fan = fan_is_left ? solution.left_wave() : solution.right_wave();
  const exact::Riemann::Wave other = fan_is_left ? solution.right_wave() : solution.left_wave();
  if (other.kind != exact::Riemann::Kind::jump) return 1;
  const double celerity = std::sqrt(solution.gravity() * solution.star().depth);
  const double carried = solution.star().velocity + (fan_is_left ? celerity : -celerity);
  const double left_at = fan_is_left ? fan.fastest : fan.slowest;
  return (carried - left_at) / (carried - other.fastest);
}

Lost lost_in(const exact::Riemann& solution, double time, double cell, const Smearing& smearing) {
  Lost lost;
  Worst bores;
  const State star = solution.star();
  const auto add = [&](const exact::Riemann::Wave& wave, const State& outer, bool is_left) {
    if (wave.kind == exact::Riemann::Kind::jump) {
      const double width = smearing.cells_wide * cell / 4;
      lost.depth += width * std::abs(outer.depth - star.depth);
      lost.discharge += width * std::abs(outer.depth * outer.velocity - star.depth * star.velocity);
      bores.add(outer.depth - star.depth);
    } else if (wave.kind == exact::Riemann::Kind::fan) {
      const double cells = (wave.fastest - wave.slowest) * time / cell;
      add_fan(lost, solution, wave, cells, arrives_later(solution, is_left), smearing.viscosity * cell / 2);
    }
  };
  add(solution.left_wave(), solution.left(), true);
  add(solution.right_wave(), solution.right(), false);
  lost.bore = bores.value();
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
  if (solution.left().depth > 0 && solution.right().depth > 0) return std::numeric_limits<double>::quiet_NaN();
  if (particles) return solution.left().depth == 0 ? profile.edges.front() : profile.edges.back();
  Largest deepest;
  for (const State& mean : profile.means) deepest.add(mean.depth);
  if (!(deepest.value() > 0)) return std::numeric_limits<double>::quiet_NaN();
  const auto is_wet = [&](const State& mean) { return mean.depth > 1e-3 * deepest.value(); };
  if (solution.left().depth == 0) {
    const auto first = std::find_if(profile.means.begin(), profile.means.end(), is_wet) - profile.means.begin();
    return profile.edges[static_cast<std::size_t>(first)];
  }
  const auto last = profile.means.rend() - std::find_if(profile.means.rbegin(), profile.means.rend(), is_wet);
  return profile.edges[static_cast<std::size_t>(last)];
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
  const JudgedFront judged = judged_front(solution, time);
  errors.front = judged.is_jump ? front_position(points.cells(), judged.front) - judged.front.position
                                : std::numeric_limits<double>::quiet_NaN();
  return errors;
}

std::vector<RiemannRequirement> riemann_requirements(const exact::Riemann& solution, double time, double length,
                                                     double cell, const Smearing& smearing) {
  const double depths = range_of(solution, time, [](const State& s) { return s.depth; });
  const double discharges = range_of(solution, time, [](const State& s) { return s.depth * s.velocity; });
  const double deepest = std::max({solution.left().depth, solution.right().depth, solution.star().depth});
  const double rounding = 1e-12 * deepest;
  const Lost lost = lost_in(solution, time, cell, smearing);
  const MeanErrors untouched = errors_of_the_initial_state(solution, time, length);
  const std::string smeared = fmt::format(
      "a jump D smeared evenly over w = {:.3g} cells of {:.3g} m leaves D w dx/4; a fan rounded since its birth by "
      "{:.3g} times the viscosity of Rusanov's flux, s dx/2 with s = |u| + c, leaves ln(n) s dx/2 times the variation "
      "of its slope 2 c/(3 g), in discharge the characteristic speed times that, n cells within the fan. It decides "
      "while that is less than half of what water that never moved would leave",
      smearing.cells_wide, cell, smearing.viscosity);
  const auto mean = [&](double lost_there, double at_rest) {
    const double limit = std::max(lost_there / length, rounding);
    return evidence::Amount::at_most(limit, std::max(0.5 * at_rest, rounding));
  };
  const std::string printed =
      "conserved: what is left is how the points meet the jumps, half the range of the exact values over a cell at "
      "each of two waves";
  const double ends =
      std::max(fastest(solution.left(), solution.gravity()), fastest(solution.right(), solution.gravity()));
  std::vector<RiemannRequirement> all = {
      {"depth",
       "The depth agrees with the exact solution to within what first-order schemes lose.",
       "mean |h - exact|",
       "m",
       &RiemannErrors::depth,
       {.limit = mean(lost.depth, untouched.depth), .reason = smeared}},
      {"discharge",
       "The discharge agrees with the exact solution to within what first-order schemes lose.",
       "mean |h u - exact|",
       "m^2/s",
       &RiemannErrors::discharge,
       {.limit = mean(lost.discharge, untouched.discharge), .reason = smeared}},
      {"volume",
       "The water volume between the first and the last point equals the exact volume.",
       "volume less the exact one",
       "m^2",
       &RiemannErrors::volume,
       {.limit = std::max(cell * depths, rounding * length), .reason = printed}},
      {"momentum-held",
       "The momentum between the first and the last point equals the exact momentum.",
       "momentum less the exact one",
       "m^3/s",
       &RiemannErrors::momentum,
       {.limit = std::max(cell * (discharges + ends * depths), rounding * length),
        .reason = printed + "; and |u| + c times the volume that may be missing, where a smeared wave has left"}}};
  if (judged_front(solution, time).is_jump) {
    all.push_back(
        {"front",
         "The bore is where the exact one is.",
         "position less the exact one",
         "m",
         &RiemannErrors::front,
         {.limit = (smearing.cells_wide / 20 + 0.5) * cell + lost.sent / lost.bore,
          .reason =
              "half way up a jump that is smeared over w cells along a power of x is within w/20 of its centre, where "
              "conservation puts it, and is read to half a cell; what a fan's rounding displaces between its corners "
              "follows the bore and moves it by that volume over its height, as far as it has arrived"}});
  }
  return all;
}

}  // namespace seiche::validation
