/*
A round drop without gravity rotates, $\mathbf{u} = \omega (1 - r^2)(-y, x)$: an exact steady flow, in which shear
separates neighbours indefinitely. The case measures for how long overlapping particles behave as a fluid; the source
reports a "stochastic regime" from regular initial data (section 5.1).

**Set-up.** Staggered rows of particles in the unit disc, $\omega$ = `rate`, steps of `tau`. Beside this flow, `seeds`
copies with random initial displacements of $10^{-8}$.

**What is compared.** Statistics, never trajectories: the fraction of kinetic energy outside the exact flow $\mathbf{F}$
at the particle positions, $1 - (\mathbf{u} \cdot \mathbf{F})^2/(u^2 F^2)$ ("incoherent"); the kurtosis of the
velocities minus the exact flow, 3 for Gaussian ones; the rate at which copies diverge from the first flow, from twice
the initial distance to 0.1, in positions and velocities. Means over the copies with 95 % intervals; energy and angular
momentum.

**What to look at.** After a third of a revolution of the centre a quarter of the energy is incoherent, after two thirds
nearly all. Copies diverge at 13.9 e-foldings per time unit. The final state is an equilibrium: Gaussian velocities,
statistics common to all copies, positions common to none, with energy and angular momentum conserved to the last digits
throughout.

**What this means.** The model represents smooth flow for less than one revolution of an eddy; then the flow
thermalises, and its energy passes into motions of single particles. The model is unsuitable for sustained shear, and
has no viscosity by which this could be explained. The time step is not the cause: with half the step copies diverge at
12.2 instead of 13.9 e-foldings per time unit and reach the same equilibrium.
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

#include "seiche/models/overlapping_particles/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/straight_line.hpp"

namespace seiche::validation::cases::vortex_overlapping {

using overlapping_particles::Flow;
using overlapping_particles::Particles;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 5.1";

constexpr double first_distance = 1e-8;
constexpr double last_distance = 0.1;  ///< of the growth

struct SetUp {
  double spacing, tau, rate, at, end;
  long seeds;

  [[nodiscard]] long steps() const { return std::lround(end / tau); }
  [[nodiscard]] std::size_t step_of_statistics() const { return static_cast<std::size_t>(std::lround(at / tau)); }
  /// About as many as the rows hold.
  [[nodiscard]] double particles() const { return 2 * std::numbers::pi / std::numbers::sqrt3 / (spacing * spacing); }
  [[nodiscard]] Point exact(Point r) const {
    const double turning = rate * std::fmax(0, 1 - r.x * r.x - r.y * r.y);
    return {-turning * r.y, turning * r.x};
  }
};

/// Throws std::invalid_argument where statistics would be read after the end.
SetUp set_up(const Values& values) {
  const SetUp s{values.real("spacing"), values.real("tau"),  values.real("rate"),
                values.real("at"),      values.real("time"), values.integer("seeds")};
  if (s.at + s.tau > s.end) {
    throw std::invalid_argument(fmt::format("at = {:g} is out of range: a step before time = {:g}", s.at, s.end));
  }
  return s;
}

/// Mean of some samples, with the half-width of its interval of 95 per cent.
struct Estimate {
  double mean = 0, half_width = 0;

  explicit Estimate(const std::vector<double>& samples) {
    const auto count = static_cast<double>(samples.size());
    mean = over<Mean>(samples, std::identity{}).value();
    const auto squares = over<Mean>(samples, [&](double sample) { return (sample - mean) * (sample - mean); });
    half_width =
        boost::math::quantile(boost::math::students_t(count - 1), 0.975) * std::sqrt(squares.value() / (count - 1));
  }
  [[nodiscard]] Measurement measured() const { return {.value = mean, .uncertainty = half_width}; }
};

/// What one flow says of itself after every step.
struct Course {
  std::vector<double> incoherent;
  std::vector<std::vector<double>> states = {};  ///< places and velocities
  Mean kurtosis = {};                            ///< after `at`
  std::vector<double> residual = {};             ///< at `at`: velocities without the exact flow, over their deviation
  double energy = 0, angular_momentum = 0;       ///< largest defects
  std::vector<double> distances = {};            ///< of a copy, from the flow that was not disturbed
};

/// The exact flow taken out of the velocities.
struct Parts {
  double incoherent;
  std::vector<double> residual;
};

Parts parts_of(const Flow& flow, const SetUp& s) {
  const std::size_t n = flow.x().size();
  std::vector<double> exact(2 * n);
  double uu = 0;
  double uf = 0;
  double ff = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Point f = s.exact({flow.x()[k], flow.y()[k]});
    exact[k] = f.x;
    exact[n + k] = f.y;
    uu += flow.u()[k] * flow.u()[k] + flow.v()[k] * flow.v()[k];
    uf += flow.u()[k] * f.x + flow.v()[k] * f.y;
    ff += f.x * f.x + f.y * f.y;
  }
  Parts parts{1 - uf * uf / (uu * ff), flow.state().u};
  for (std::size_t i = 0; i < 2 * n; ++i) parts.residual[i] -= uf / ff * exact[i];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += parts.residual[axis * n + k];
    for (std::size_t k = 0; k < n; ++k) parts.residual[axis * n + k] -= sum / static_cast<double>(n);
  }
  return parts;
}

double kurtosis_of(const std::vector<double>& centred) {
  double second = 0;
  double fourth = 0;
  for (const double v : centred) {
    second += v * v;
    fourth += v * v * v * v;
  }
  return fourth / (second * second) * static_cast<double>(centred.size());
}

Course run_course(const SetUp& s, Particles particles) {
  Flow flow(std::move(particles), [&](Point r) { return s.exact(r); });
  Course course;
  const auto keep = [&] {
    std::vector<double> state = flow.state().q;
    state.insert(state.end(), flow.state().u.begin(), flow.state().u.end());
    course.states.push_back(std::move(state));
    Parts parts = parts_of(flow, s);
    course.incoherent.push_back(parts.incoherent);
    if (flow.time() < s.at - s.tau / 2) return;
    course.kurtosis.add(kurtosis_of(parts.residual));
    if (!course.residual.empty()) return;
    const double size = over<Mean>(parts.residual, std::identity{}).rms();
    course.residual = each(parts.residual, [&](double v) { return v / size; });
  };
  keep();
  const double kinetic = flow.energy();
  for (long step = 0; step < s.steps(); ++step) {
    flow.advance(s.tau);
    flow.observe();
    keep();
  }
  course.energy = flow.ledger().largest_defect("energy") / kinetic;
  course.angular_momentum = flow.ledger().largest_defect("angular");
  return course;
}

/// Every place moved at random, by 1e-8 in all.
Particles moved(Particles particles, long seed) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  const auto noise = [&] { return 0x1p-52 * static_cast<double>(generator() >> 11) - 1; };
  std::vector<double> steps(2 * particles.size());
  double square = 0;
  for (double& step : steps) {
    step = noise();
    square += step * step;
  }
  for (std::size_t k = 0; k < particles.size(); ++k) {
    particles.x[k] += first_distance / std::sqrt(square) * steps[k];
    particles.y[k] += first_distance / std::sqrt(square) * steps[particles.size() + k];
  }
  return particles;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

/// Slope of the logarithm of a copy's distances, from twice the first one until they reach 0.1.
double growth_rate(const std::vector<double>& distances, double tau) {
  std::vector<double> time, logarithm;
  for (std::size_t n = 0; n < distances.size() && distances[n] < last_distance; ++n) {
    if (distances[n] < 2 * distances.front()) continue;
    time.push_back(tau * static_cast<double>(n));
    logarithm.push_back(std::log(distances[n]));
  }
  return straight_line(time, logarithm).slope;
}

struct Results {
  SetUp set_up;
  Course first;  ///< of the flow that was not disturbed
  std::vector<Course> copies = {};

  template <class Get>
  [[nodiscard]] Estimate over_copies(const Get& get) const {
    return Estimate(each(copies, get));
  }
  /// Of all flows.
  [[nodiscard]] Worst largest(double Course::*defect) const {
    Worst largest = over<Worst>(copies, defect);
    largest.add(first.*defect);
    return largest;
  }
};

void claims(const Values& values, const Claims<Results>& all) {
  const SetUp s = set_up(values);
  const Claims<Results> claims = all.at(fmt::format("h = {:g}, tau = {:g}, {} copies", s.spacing, s.tau, s.seeds));
  const Claims<Results> settled =
      claims.only_if(s.at * s.rate >= 6, "before two thirds of a revolution the flow is not in equilibrium");
  settled.check(
      "incoherent", "The incoherent part of the kinetic energy exceeds 90 % after two thirds of a revolution.",
      "incoherent part of the energy, mean over the copies",
      [step = s.step_of_statistics()](const Results& r) {
        return r.over_copies([=](const Course& copy) { return copy.incoherent.at(step); }).measured();
      },
      Bound{.limit = 0.1,
            .reason = "10 % of the energy corresponds to the exact flow at a third of its velocity: below that no eddy "
                      "can be identified",
            .expected = 1});
  settled.check(
      "kurtosis", "The kurtosis of the velocities minus the exact flow equals the Gaussian value, 3.",
      "kurtosis, mean over the copies and the rest of the run",
      [](const Results& r) {
        return r.over_copies([](const Course& copy) { return copy.kurtosis.value(); }).measured();
      },
      Bound{.limit = 2 * std::sqrt(24 / (2 * s.particles())),
            .reason = "2 sqrt(24/2N), two standard deviations of the kurtosis of 2N Gaussian velocities; uniform ones "
                      "have 1.8, an oscillation 1.5",
            .expected = 3});
  const double operations = 40 * static_cast<double>(s.steps());
  const Claims<Results> conserved = claims.from("Frank (1994), chapter 1");
  conserved.check(
      "energy", "The energy of the disordered flow is conserved to round-off.",
      "largest energy error of all flows, over the energy", [](const Results& r) { return r.largest(&Course::energy); },
      Roundoff{.operations = operations,
               .scale = 1,
               .reason = "in every step the multipliers of a particle's forty volumes, rounded"});
  conserved.check(
      "angular_momentum", "Angular momentum is conserved to round-off (overlapping particles).",
      "largest error of all flows", [](const Results& r) { return r.largest(&Course::angular_momentum); },
      Roundoff{.operations = operations,
               .scale = s.rate / std::sqrt(s.particles()),
               .reason = "as for the energy; scale: sum of m |r| |u|, with particles up to 3 away at speeds of "
                         "a third of the rate, mass pi; over sqrt N, for independent roundings of particles"});
}

Results compute(const Run& run) {
  const SetUp s = set_up(run);
  const Particles particles = overlapping_particles::staggered_disc(1, s.spacing);
  Results r{.set_up = s, .first = run_course(s, particles)};
  for (long seed = 1; seed <= s.seeds; ++seed) {
    run.progress(static_cast<double>(seed) / static_cast<double>(s.seeds + 1));
    Course& copy = r.copies.emplace_back(run_course(s, moved(particles, seed)));
    copy.distances =
        each(indices(copy.states.size()), [&](std::size_t n) { return distance(copy.states[n], r.first.states[n]); });
    copy.states.clear();
  }
  return r;
}

void draw_history(const Results& r, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure(
      "history", "From an eddy to noise",
      "Incoherent part of the energy, of the first flow and of copies; distances of the copies from the first flow.",
      {"frank-overlapping"});
  const std::vector<double> time =
      each(indices(r.first.incoherent.size()), [&](std::size_t n) { return r.set_up.tau * static_cast<double>(n); });
  auto& incoherent = figure.panel({.x = "t", .y = "incoherent part"});
  auto& distances = figure.panel({.x = "t", .y = "distance", .log_y = true});
  incoherent.line("first flow", time, r.first.incoherent, Role::computed);
  for (std::size_t c = 0; c < std::min<std::size_t>(3, r.copies.size()); ++c) {
    incoherent.line(fmt::format("copy {}", c + 1), time, r.copies[c].incoherent);
    distances.line(fmt::format("copy {}", c + 1), time, r.copies[c].distances);
  }
  // When a quarter of the first flow's energy was noise.
  const auto noisy = std::ranges::find_if(r.first.incoherent, [](double part) { return part > 0.25; });
  if (noisy == r.first.incoherent.end()) return;
  exhibit.measure("quarter_incoherent_time", time[static_cast<std::size_t>(noisy - r.first.incoherent.begin())]);
}

void draw_velocities(const Results& r, evidence::Exhibit& exhibit) {
  constexpr int bins = 32;
  constexpr double reach = 4;
  constexpr double width = 2 * reach / bins;
  std::vector<double> residual;
  for (const Course& copy : r.copies) std::ranges::copy(copy.residual, std::back_inserter(residual));
  const auto middle =
      each(indices(bins), [](std::size_t b) { return -reach + (static_cast<double>(b) + 0.5) * width; });
  const auto gaussian = each(middle, [](double v) { return std::exp(-v * v / 2) / std::sqrt(2 * std::numbers::pi); });
  std::vector<double> density(bins, 0.0);
  for (const double v : residual) {
    const double b = std::floor((v + reach) / width);
    if (b < 0 || b >= bins) continue;
    density[static_cast<std::size_t>(b)] += 1 / (width * static_cast<double>(residual.size()));
  }
  auto& panel = add_panel(exhibit, "velocities", "Velocities without the exact flow",
                          "Of all particles of all copies, over their standard deviation.",
                          {.x = "velocity", .y = "density"}, {"frank-overlapping"});
  panel.points(fmt::format("t = {:g}", r.set_up.at), middle, density, Role::computed);
  panel.line("Gaussian", middle, gaussian, Role::exact);
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  draw_history(r, exhibit);
  draw_velocities(r, exhibit);
  const auto estimate = [&](const std::string& name, const auto& of_copy) {
    const Estimate of = r.over_copies(of_copy);
    exhibit.measure(name, of.mean);
    exhibit.measure(name + "_half_width", of.half_width);
  };
  estimate("growth_rate", [&](const Course& copy) { return growth_rate(copy.distances, r.set_up.tau); });
  estimate("distance_at_end", [](const Course& copy) { return copy.distances.back(); });
}

void vortex_overlapping(Case& c) {
  c.title = "Decay of a vortex into noise: overlapping particles";
  c.source = source;
  c.parameters = {
      real("spacing", 0.125, "1", {0.03, 0.3}, "of the particles, in radii"),
      real("rate", 3.0, "1", {0.1, 30}, "initial angular velocity at the centre"),
      integer("seeds", 10, {2, 100}, "copies with random displacements of 1e-8"),
      real("at", 2.0, "1", {0.1, 100},
           "time at which the incoherent part is evaluated, and from which on the kurtosis"),
      real("tau", 0.02, "1", {1e-4, 0.1}, "time step"),
      real("time", 3.0, "1", {0.2, 100}, "end of the run"),
  };
  c.published = {{.tiles = {"frank-overlapping"}, .differs = "a smooth kernel, not balls"}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::vortex_overlapping
