/*
A solitary wave passes over a step in the bed onto a shelf and splits into several: Frank's example for variable-mass
particles (1994, section 5.3). Depth before the step, gravity and density are 1.

**Set-up.** The exact solitary wave of the Euler equations starts before the step. Nodes have constant $x$ (`fixed_x`),
or follow the water and are drawn back (`mapped`); those below the height of the shelf keep their initial positions. The
corner is sharp, with a fixed node.

**Theory.** At the step a long wave changes its height by $T = 2/(1 + \sqrt{h})$ (Lamb); on the shelf it is no longer a
solitary wave. Inverse scattering of the Korteweg-de Vries equation gives the waves into which it splits:

$$\nu (\nu + 1) = \frac{2 T}{h^2}, \qquad \frac{a_n}{a_0} = h^2 (\nu - n + 1)^2 .$$

**What is compared.** The crests on the shelf and the reflected crest with that theory, whose own corrections are of
relative order $a_1/h$. Energy, and the dissipation of the stabilisation.

**What to look at.** The first wave grows over a distance of some 80 while it separates from the others, and ends a few
per cent below theory; the second is still separating from the third. The passage of the corner, where the flow is
singular, costs little energy; most dissipation occurs on the long way over the shelf, which has few rows for waves that
short. The reflected wave returns from the left wall and follows over the step.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <Eigen/QR>

#include "seiche/exact/mach_reflection.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation::cases::step_variable_mass {

using exact::SolitaryWave;
using exact::SolitonFission;

// The exact solitary wave in a channel of particles of variable mass, and what is read off on its way.
// Depth, gravity and density are 1.

const std::string source = "inverse scattering (Madsen & Mei 1969) after Lamb's step; model: Frank (1994), section 5.3";
constexpr std::size_t shown = 3;  // crests
constexpr double apart = 2;       // a crest is the highest place so far around it, for ripples are not waves
constexpr double smooth = 2;      // half of what the crest of the reflected wave, some six long, is read from
constexpr double interval = 2;    // between the surfaces that are kept

/// The surface at one instant, in ascending x.
struct SurfaceLine {
  double time = 0;
  std::vector<double> x = {}, y = {};

  /// Highest crest of a part of it; a height of NaN where there is none.
  [[nodiscard]] CurveCrest highest(double from, double to) const {
    const std::vector<CurveCrest> all = crests(-std::numeric_limits<double>::infinity(), from, to);
    const auto top = std::ranges::max_element(all, {}, &CurveCrest::height);
    return top == all.end() ? CurveCrest{nan, nan} : *top;
  }
  /// Crests above a threshold of a part of it: all, and those that are the highest place within a distance.
  [[nodiscard]] std::vector<CurveCrest> crests(double threshold, double from, double to) const {
    std::vector<CurveCrest> found = crests_above(threshold, x, y);
    std::erase_if(found, [&](const CurveCrest& one) { return !(one.place >= from && one.place <= to); });
    return found;
  }
  [[nodiscard]] std::vector<CurveCrest> waves(double threshold, double from, double to) const {
    std::vector<CurveCrest> found = crests(threshold, from, to);
    std::erase_if(found, [&](const CurveCrest& one) {
      const auto begin = std::lower_bound(x.begin(), x.end(), one.place - apart) - x.begin();
      const auto end = std::upper_bound(x.begin(), x.end(), one.place + apart) - x.begin();
      return std::any_of(y.begin() + begin, y.begin() + end, [&](double height) { return height > one.height; });
    });
    return found;
  }
  /// Top of the parabola, by least squares, through what is within a distance of a place: a crest with ripples on it.
  [[nodiscard]] double smoothed_height(double place, double within) const {
    const auto begin = std::lower_bound(x.begin(), x.end(), place - within) - x.begin();
    const auto end = std::upper_bound(x.begin(), x.end(), place + within) - x.begin();
    Eigen::MatrixXd powers(end - begin, 3);
    Eigen::VectorXd heights(end - begin);
    for (auto k = begin; k < end; ++k) {
      const double s = (x[static_cast<std::size_t>(k)] - place) / within;
      powers.row(k - begin) << 1, s, s * s;
      heights[k - begin] = y[static_cast<std::size_t>(k)];
    }
    const Eigen::Vector3d c = powers.colPivHouseholderQr().solve(heights);
    return c[0] - c[1] * c[1] / (4 * c[2]);
  }
};

/// A run on one mesh: surfaces at equal intervals and, with them, the budget of energy over the kinetic energy of the
/// beginning.
struct Passage {
  long rows = 0;
  std::vector<SurfaceLine> surfaces = {};
  std::vector<double> time = {}, kinetic = {}, potential = {}, dissipated = {};
  double energy_defect = 0;            ///< largest change of energy with what was booked, at any step
  double mass_defect = 0;              ///< largest, of the whole
  double drift = 0;                    ///< largest |A_i - m_i/rho| at the end over the square of a row's height
  std::vector<CurveCrest> peaks = {};  ///< on the shelf, from the highest back
  double reflected = 0;                ///< highest crest before the step when it is half way to the left wall

  /// The line nearest to a time.
  [[nodiscard]] const SurfaceLine& at(double when) const {
    return *std::ranges::min_element(surfaces, {}, [&](const SurfaceLine& one) { return std::abs(one.time - when); });
  }
  /// Height of crest n of those on the shelf; NaN where there are not as many.
  [[nodiscard]] double peak(std::size_t n) const { return n <= peaks.size() ? peaks[n - 1].height : nan; }
};

using variable_mass::Flow;

/// Surface and velocities of the wave with its crest at a place.
variable_mass::Start solitary_start(const SolitaryWave& wave, double crest) {
  const auto elevation = [&wave, crest](double x) { return wave.elevation(x - crest); };
  return {.elevation = elevation, .velocity = [&wave, crest, elevation](Point place) {
            // A surface node may be above the exact surface by its rounding.
            const double y = std::min(place.y, elevation(place.x));
            const auto [u, v] = wave.velocity(place.x - crest, y);
            return Point{u, v};
          }};
}

SurfaceLine surface_line(const Flow& flow) {
  SurfaceLine line{.time = flow.time()};
  for (const int k : flow.control().surface().nodes()) {
    const Point r = flow.nodes()[k];
    line.x.push_back(r.x);
    line.y.push_back(r.y);
  }
  return line;
}

/// @param rest  the mesh of the flow under a flat surface, from which potential energies count
Passage follow(Flow& flow, const free_lagrangian::Mesh& rest, long rows, double time, double tau,
               const std::function<void(double)>& progress) {
  Passage run{.rows = rows};
  const double still = free_lagrangian::potential_energy(rest.places(), rest.outline, flow.water().weight());
  const double kinetic = flow.kinetic_energy();
  const double energy = flow.energy();
  const double mass = flow.water().mass();
  const auto keep = [&] {
    run.surfaces.push_back(surface_line(flow));
    run.time.push_back(flow.time());
    run.kinetic.push_back(flow.kinetic_energy() / kinetic);
    run.potential.push_back((flow.potential_energy() - still) / kinetic);
    run.dissipated.push_back((flow.stabilisation_loss() - flow.drift_work()) / kinetic);
  };
  keep();
  Worst energies, masses;
  const auto parts = static_cast<long>(std::ceil(time / interval));
  for (long part = 1; part <= parts; ++part) {
    march(flow, time * static_cast<double>(part) / static_cast<double>(parts), tau, [&] {
      energies.add((flow.energy() + flow.stabilisation_loss() - flow.drift_work() - energy) / kinetic);
      masses.add(flow.water().mass() - mass);
    });
    keep();
    progress(static_cast<double>(part) / static_cast<double>(parts));
  }
  run.energy_defect = energies.value();
  run.mass_defect = masses.value();
  run.drift = flow.largest_drift() * static_cast<double>(rows * rows);
  return run;
}

/// Rows: those of a ladder that are coarser than asked for, and these.
std::vector<long> meshes(const Values& values) {
  std::vector<long> rows{4, 6, 8, 12};
  std::erase_if(rows, [&](long n) { return n >= values.integer("ny"); });
  rows.push_back(values.integer("ny"));
  return rows;
}

struct Results {
  SolitaryWave wave;
  SolitonFission theory;
  double step = 0;
  std::vector<Passage> passages = {};
  [[nodiscard]] const Passage& own() const { return passages.back(); }
};

double step_length(const Values& values, long rows) {
  return values.real("courant") / static_cast<double>(rows);
}

Passage pass(const Run& run, const SolitaryWave& wave, long rows, const std::function<void(double)>& progress) {
  const double step = run.real("step");
  const free_lagrangian::Mesh rest = free_lagrangian::stepped_channel_mesh({.begin = 0,
                                                                            .step = step,
                                                                            .end = step + run.real("shelf_length"),
                                                                            .bottom = -1,
                                                                            .shelf = -run.real("shelf_depth"),
                                                                            .level = 0,
                                                                            .rows = static_cast<int>(rows)});
  variable_mass::Flow flow(rest, solitary_start(wave, run.real("crest")),
                           {.kind = variable_mass::control_named(run.text("control")),
                            .rate = run.real("rate"),
                            .surface_rate = run.real("surface_rate")},
                           {.stabilisation = run.real("stabilisation")});
  Passage p = follow(flow, rest, rows, run.real("time"), step_length(run, rows), progress);
  const SurfaceLine& last = p.surfaces.back();
  const CurveCrest first = last.highest(step, last.x.back());
  // Behind the waves that parted comes what was reflected twice.
  p.peaks = last.waves(0.03 * wave.amplitude(), step + 0.5 * (first.place - step), first.place);
  std::reverse(p.peaks.begin(), p.peaks.end());
  const double half_way = (step - run.real("crest")) / wave.speed() + 0.5 * step;
  const SurfaceLine& then = p.at(half_way);
  p.reflected = then.smoothed_height(then.highest(2, step - 2).place, smooth);
  return p;
}

void claim_theory(const Values& values, const Claims<Passage>& own) {
  const double depth = values.real("shelf_depth");
  const double amplitude = values.real("amplitude");
  const SolitonFission theory(depth);
  const double small = theory.amplitude(1) * amplitude / depth;
  const double k = SolitaryWave(amplitude).decay_rate();
  const auto parted = own.only_if(
      values.real("time") >= 80 && small <= 0.5 && depth <= 0.6,
      "waves separate after some 60 h on a shelf of depth 0.6 or less, and the theory holds for small waves");
  for (const auto& [n, share, why] :
       {std::tuple{1, 0.5, "half of it for the highest wave, which has nearly separated"},
        std::tuple{2, 1.0, "the whole of it for the second wave, which is still separating from the third"}}) {
    const auto number = static_cast<std::size_t>(n);
    parted.check(
        fmt::format("peak-{}", n),
        fmt::format("The height of wave {} on the shelf agrees with inverse scattering within {:.2g} %.", n,
                    100 * share * small),
        "height over the depth before the step", [number](const Passage& p) { return p.peak(number); },
        Bound{.limit = share * small,
              .reason = fmt::format("corrections of the theory are of relative order a_1/h = {:.2f}: {}", small, why),
              .expected = amplitude * theory.amplitude(n),
              .relative = true});
  }
  parted.check(
      "order-of-waves", "The waves on the shelf are ordered by height, the highest in front.",
      "leading waves, each higher than the next",
      [](const Passage& p) {
        const std::span front = std::span(p.peaks).first(std::min(p.peaks.size(), shown));
        return front.size() >= 2 &&
               std::ranges::adjacent_find(front, std::less_equal{}, &CurveCrest::height) == front.end();
      },
      Qualitative{"two crests or more in the front half of the shelf, the first three descending",
                  "higher waves are faster"});
  own.from("Lamb, Hydrodynamics (1932), 176")
      .check("reflected", "The height of the reflected crest agrees with long-wave theory.",
             "height over the depth before the step", &Passage::reflected,
             Bound{.limit = k * k,
                   .reason = "Lamb's theory holds for long waves: corrections of relative order (k H)^2, k the decay "
                             "rate of the tails",
                   .expected = amplitude * theory.reflection(),
                   .relative = true});
}

/// Throws std::invalid_argument where the first wave reaches the right wall.
void require_long_shelf(const Values& values) {
  const double amplitude = values.real("amplitude");
  const double depth = values.real("shelf_depth");
  const double first = amplitude * SolitonFission(depth).amplitude(1);
  const double arrival = (values.real("step") - values.real("crest")) / std::sqrt(1 + amplitude);
  constexpr double before_the_wall = 4;
  const double least = std::sqrt(depth + first) * (values.real("time") - arrival) + before_the_wall;
  if (!(values.real("shelf_length") >= least)) {
    throw std::invalid_argument(fmt::format(
        "shelf_length = {:g}; allowed: at least {:.1f} for a run of {:g}: the first wave must not reach the wall",
        values.real("shelf_length"), least, values.real("time")));
  }
}

void claims(const Values& values, const Claims<Results>& claims) {
  require_long_shelf(values);
  const long rows = values.integer("ny");
  const double tau = step_length(values, rows);
  const double depth = values.real("shelf_depth");
  const double amplitude = values.real("amplitude");
  const SolitonFission theory(depth);
  const auto own = claims.of(&Results::own).at(fmt::format("{} rows, tau = {:.3g}", rows, tau));
  claim_theory(values, own);
  // Of the first wave on the shelf: tails and speed.
  const double k = std::sqrt(3 * amplitude * theory.amplitude(1) / std::pow(depth, 3));
  const double omega = k * std::sqrt(depth + amplitude * theory.amplitude(1));
  own.check(
      "energy",
      "The energy plus the recorded losses changes by at most (omega tau)^2/8, the swing of the one-step scheme.",
      "largest change over the initial kinetic energy", &Passage::energy_defect,
      Bound{.limit = std::pow(omega * tau, 2) / 8,
            .reason = "(omega tau)^2/8, by which the energy of the one-step scheme oscillates; omega = k c of the "
                      "first wave on the shelf"});
  own.check(
      "dissipation", "The energy dissipated by the stabilisation is below 10 % of the initial kinetic energy.",
      "dissipated energy over the initial kinetic energy", [](const Passage& p) { return p.dissipated.back(); },
      Bound{.limit = 0.1,
            .reason = "solitary wave energy is proportional to a^(3/2): 10 % would reduce the height of the first wave "
                      "by 7 %, and the crests would measure the stabilisation"});
  const double area = values.real("step") + depth * values.real("shelf_length");
  own.check("mass", "The total mass of the variable-mass particles is conserved to round-off.",
            "largest change of the total", &Passage::mass_defect,
            Roundoff{.operations = 8 * values.real("time") / tau * area * std::pow(rows, 2),
                     .scale = std::pow(rows, -2),
                     .reason = "some eight exchanges per node and step, each rounding the node's mass, 1/ny^2"});
}

Results compute(const Run& run) {
  Results r{.wave = SolitaryWave(run.real("amplitude")),
            .theory = SolitonFission(run.real("shelf_depth")),
            .step = run.real("step")};
  const std::vector<long> rows = meshes(run);
  const auto cost = [](long n) { return std::pow(static_cast<double>(n), 3); };
  const double whole = over<Mean>(rows, cost).sum();
  double done = 0;
  for (const long n : rows) {
    r.passages.push_back(pass(run, r.wave, n, [&](double part) { run.progress((done + part * cost(n)) / whole); }));
    done += cost(n);
  }
  return r;
}

void draw_way(const Results& r, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("passage", "Solitary wave passing onto a shelf",
                                "Surfaces at equal intervals, stacked; below, the last surface with the heights of "
                                "inverse scattering as bars. The vertical line marks the step.",
                                {"frank-step"});
  auto& way = figure.panel({.x = "x [depth]", .y = "t [sqrt(depth/g)] + 40 elevation"});
  constexpr std::size_t every = 4;
  for (std::size_t k = 0; k < r.own().surfaces.size(); k += every) {
    const SurfaceLine& line = r.own().surfaces[k];
    way.line("", line.x, each(line.y, [&](double y) { return line.time + 40 * y; }));
  }
  way.vertical("", std::vector{r.step}, Role::guide);
  auto& profile = figure.panel({.x = "x [depth]", .y = "elevation [depth]", .x_min = r.step - 4});
  const SurfaceLine& last = r.own().surfaces.back();
  profile.line("computed", last.x, last.y);
  for (int n = 1; n <= std::min<int>(static_cast<int>(r.own().peaks.size()), r.theory.solitons()); ++n) {
    const double place = r.own().peaks[static_cast<std::size_t>(n - 1)].place;
    const double height = r.wave.amplitude() * r.theory.amplitude(n);
    profile.line(n == 1 ? "inverse scattering" : "", std::vector{place, place}, std::vector{0.0, height}, Role::exact);
  }
  profile.vertical("", std::vector{r.step}, Role::guide);
}

void draw_budget(const Results& r, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("budget", "Budget of energy",
                                "Over the initial kinetic energy. Dissipated: energy taken by the stabilisation, "
                                "recorded step by step; below, for all meshes.");
  const Passage& own = r.own();
  auto& parts = figure.panel({.x = "t [sqrt(depth/g)]", .y = "energy"});
  std::vector<double> sum = own.kinetic;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += own.potential[k] + own.dissipated[k];
  parts.line("kinetic", own.time, own.kinetic);
  parts.line("potential", own.time, own.potential);
  parts.line("dissipated", own.time, own.dissipated);
  parts.line("sum", own.time, sum, Role::guide);
  auto& losses = figure.panel({.x = "t [sqrt(depth/g)]", .y = "dissipated"});
  for (const Passage& p : r.passages) losses.line(fmt::format("{} rows", p.rows), p.time, p.dissipated);
}

void show(const Results& r, const Values&, evidence::Exhibit& exhibit) {
  draw_way(r, exhibit);
  draw_budget(r, exhibit);
  evidence::Table& meshes =
      add_table(exhibit, "meshes", "Crests on finer meshes", "At the end.",
                {"rows", "a_1 [depth]", "a_2 [depth]", "a_3 [depth]", "reflected [depth]", "dissipated [1]",
                 "energy plus recorded losses [1]", "largest drift of a cell [cell]"});
  const double a = r.wave.amplitude();
  for (const Passage& p : r.passages) {
    std::vector<Cell>& row = meshes.rows.emplace_back(1, fmt::format("{}", p.rows));
    for (std::size_t n = 1; n <= shown; ++n) {
      row.push_back(n <= p.peaks.size() ? Cell(p.peak(n)) : "not parted");
    }
    row.insert(row.end(), {p.reflected, p.dissipated.back(), p.energy_defect, p.drift});
  }
  meshes.rows.push_back({"theory", a * r.theory.amplitude(1), a * r.theory.amplitude(2), a * r.theory.amplitude(3),
                         a * r.theory.reflection(), 0.0, "", ""});
}

void step_variable_mass(Case& c) {
  c.title = "Solitary wave over a step in the bed";
  c.source = literature::frank + ", section 5.3; O. S. Madsen, C. C. Mei, J. Fluid Mech. 39 (1969) 781";
  c.tiers = {Tier::full};
  c.parameters = {
      real("amplitude", 0.1, "depth", {0.02, 0.3}, "of the wave before the step"),
      real("shelf_depth", 0.5, "depth", {0.2, 0.9}, "depth behind the step"),
      integer("ny", {6, 12, 12}, {4, 24}, "rows of cells over the depth on the finest mesh"),
      real("courant", 0.48, "1", {0.05, 0.6}, "step over the height of a row, in sqrt(depth/g) and depths"),
      choice("control", "fixed_x", {"none", "centroid", "mapped", "fixed_x"}, "of the nodes"),
      real("rate", 1.0, "sqrt(g/depth)", {0, 10}, "of the control"),
      real("surface_rate", 1.0, "sqrt(g/depth)", {0, 10}, "rate at which surface nodes slide back"),
      real("stabilisation", 0.01, "1", {0, 10}, "epsilon"),
      real("crest", 10.0, "depth", {5, 100}, "initial crest position"),
      real("step", 24.0, "depth", {15, 200}, "position of the step"),
      real("shelf_length", 70.0, "depth", {10, 500}, "behind it"),
      real("time", 92.0, "sqrt(depth/g)", {20, 500}, "of the run"),
  };
  c.published = {{.tiles = {"frank-step"}, .tier = Tier::full}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::step_variable_mass
