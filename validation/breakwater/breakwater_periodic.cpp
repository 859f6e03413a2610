/*
Periodic waves arrive at a breakwater whose front and rear walls are loaded in antiphase (Frank 1994, section 2.3). A
distant piston generates them; they are reflected, and a standing wave forms before the breakwater.

**Set-up.** Depth, gravity and density are 1. The breakwater is the one of the case `breakwater`: a berm 2 wide under
water of depth 0.4 before the rear wall. The piston is at a distance of 50 from the wall. Its motion ramps up over 28
time units, four periods of a wave of $L/h = 6$, and generates waves of half the height of the intended standing wave.
The run ends before re-reflection from the paddle reaches the breakwater: little of it travels faster than $0.6\,c_g +
0.4$, between the group velocity and the maximum group velocity, 1. The last whole periods, two or more, are analysed,
with a window $1 - \cos$.

**What is compared.** Amplitude and phase of the forces on front and rear, per elevation at an antinode, with small
standing waves from the eigenvalues of the same mesh. The frequencies are eigenfrequencies of a basin of length 14,
whose far wall is an antinode, hence a plane of symmetry, of the standing wave in the tank too; the piston has the
frequency of that wave in the one-step scheme, so that cells and steps contribute no difference. Two errors remain. The
first is the transient of the start, which linear piston theory predicts for the way to the antinode, the way back and
the re-reflection from the paddle. The second is the drift of the mesh with the square of the height, which tangles it
at the edge of the berm under high waves; the waves are therefore low. `breakwater_high_wave` runs a wave of height 0.2
on a rezoned mesh. The height of the standing wave is compared with twice the theory of the piston.

**What to look at.** The berm is half a wavelength wide for $L/h$ of about 6. Front and rear are then loaded in
antiphase, and their sum, for which the structure must be designed, is less than a tenth of the force on a plain wall.
Waves of $L/h = 15$ load both in phase.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <iterator>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/wavemaker.hpp"
#include "validation/breakwater/berm_history.hpp"
#include "validation/breakwater/berm_load.hpp"
#include "validation/breakwater/incident_waves.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::breakwater_periodic {

using std::numbers::pi;
using Complex = std::complex<double>;

// How far a tank has settled in linear theory: the wave of a piston that starts softly, at a distance, analysed over
// the same periods as the run's (harmonic.hpp), over the settled wave.
//
// The piston's motion up to the end of the run is taken apart into frequencies; each travels as Airy's wave of its
// wavenumber, with Havelock's height per stroke. Waves that decay with the distance from the paddle are left out.
//
// When not to use it: within two depths of the paddle; distances that a part of the motion has not left behind.
//
// The share is the amplitude at a distance from the piston over that of the settled wave, its phase taken out: 1 when
// settled, 0 before anything arrives.
std::function<Complex(double distance)> settled_share(const IncidentWaves& waves) {
  const exact::AiryDispersion airy(1, 1);
  const auto height = [](double omega) {
    return exact::Wavemaker(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{omega}).height_per_stroke();
  };
  struct Part {
    double wavenumber;
    Complex forward, backward;  // weights of the wave and of its conjugate
  };
  std::vector<Part> parts;
  // A sum over frequencies repeats itself after 2 pi/spacing: four runs, in which shorter waves do not come so far.
  const double spacing = 2 * pi / (4 * waves.end);
  constexpr double fastest = 4;
  const auto steps = static_cast<long>(std::ceil(waves.end / (pi / fastest) * 4));
  const double dt = waves.end / static_cast<double>(steps);
  const double window = 2 * pi / waves.omega * static_cast<double>(waves.settled_periods);
  const double settled = waves.half_stroke * height(waves.omega);
  for (double omega = spacing; omega < fastest; omega += spacing) {
    Complex motion = 0;
    Complex same = 0;
    Complex opposite = 0;
    double weights = 0;
    for (long n = 1; n <= steps; ++n) {
      const double t = static_cast<double>(n) * dt;
      motion += waves.piston(t) * std::polar(dt, -omega * t);
      if (t <= waves.end - window) continue;
      const double weight = 1 - std::cos(2 * pi * (t - waves.end) / window);
      weights += weight;
      same += weight * std::polar(1.0, (waves.omega - omega) * t);
      opposite += weight * std::polar(1.0, (waves.omega + omega) * t);
    }
    // The elevation, the sum of Re share exp(i (omega t - k x)), is ahead of the piston's place by a quarter period.
    const Complex share = Complex(0, 1) * motion * (spacing / pi) * height(omega) / settled;
    parts.push_back({airy.wavenumber(omega), share * opposite / weights, std::conj(share) * same / weights});
  }
  return [parts, wavenumber = airy.wavenumber(waves.omega)](double distance) {
    Complex sum = 0;
    for (const Part& part : parts) {
      const Complex travel = std::polar(1.0, part.wavenumber * distance);
      sum += part.forward * std::conj(travel) + part.backward * travel;
    }
    return sum * std::polar(1.0, -wavenumber * distance);
  };
}

const std::string source = "Frank (1994), section 2.3";
constexpr double largest_limit = 0.02;
// A wave of this height at an antinode tangles the mesh at the edge of the berm within these periods.
constexpr double tangling_height = 0.02;
constexpr double tangling_periods = 2;

/// What the parameters decide.
struct SetUp {
  Berm berm;
  BermResolution mesh;
  double sea, height;
  long steps;
  std::vector<double> wavelengths;  ///< the first: the berm is half a wave wide; the last: a long wave

  explicit SetUp(const Values& values)
      : mesh(berm_mesh_of(values)),
        sea(values.real("sea")),
        height(values.real("height")),
        steps(values.integer("steps")),
        wavelengths(values.tier() == Tier::quick ? std::vector<double>{6, 5, 15}
                                                 : std::vector<double>{6, 4.2, 5, 7.6, 10, 15}) {}

  [[nodiscard]] std::string name() const {
    Berm tank = berm;
    tank.length += sea;
    return fmt::format("{}, {} steps in a period", mesh.name(tank), steps);
  }
};

/// One frequency.
struct Periodic {
  BasinWave small;
  IncidentWaves waves;
  TankHistory history;
  TankHistory::Settled settled;
  double unsettled = 0;  ///< by the linear theory of the start, relative to the settled wave

  [[nodiscard]] double larger_force() const {
    return std::max(std::abs(small.load.force.front), std::abs(small.load.force.rear));
  }
  /// Of a force over the larger one: the start in the force and in the elevation; the mesh that is carried away.
  [[nodiscard]] double limit(const SetUp& s) const {
    const double periods = waves.end * waves.omega / (2 * std::numbers::pi);
    return 2 * unsettled + std::pow(s.height / tangling_height, 2) * periods / tangling_periods;
  }
  /// Of a phase, by which the smaller force is off more.
  [[nodiscard]] double phase_limit(const SetUp& s) const {
    return limit(s) * larger_force() / std::min(std::abs(small.load.force.front), std::abs(small.load.force.rear));
  }
  /// Largest difference of a force from that of small waves, over the larger one.
  [[nodiscard]] double difference() const {
    return worst(std::array{std::abs(settled.front - small.sense() * small.load.force.front),
                            std::abs(settled.rear - small.sense() * small.load.force.rear)}) /
           larger_force();
  }
  /// Largest phase from that of small waves.
  [[nodiscard]] double phase() const {
    return worst(std::array{std::arg(settled.front * small.sense() * small.load.force.front),
                            std::arg(settled.rear * small.sense() * small.load.force.rear)});
  }
  /// |total| over the force on a plain wall.
  [[nodiscard]] double relative() const { return std::abs(settled.total()) / small.load.plain_wall; }
};

using Results = std::vector<Periodic>;

/// The wave that is farthest beyond, or least within, its own limit; judged by that limit.
template <class Value, class Limit>
Measurement farthest(const Results& r, Value value, Limit limit) {
  Largest share;
  for (std::size_t n = 0; n < r.size(); ++n) {
    share.add(std::invoke(value, r[n]) / limit(r[n]), static_cast<double>(n));
  }
  const Periodic& one = r[static_cast<std::size_t>(share.where())];
  return {.value = std::invoke(value, one),
          .where = fmt::format("waves of L/h = {:.3g}", one.small.load.wavelength),
          .told = {.limit = limit(one)}};
}

const std::string reason =
    "twice the unsettled part of linear theory, in force and elevation, on the way in, back, and once more around; and "
    "the mesh drift, proportional to the square of the height: a height of 0.02 tangles the mesh at the edge of the "
    "berm within two periods, so that (height/0.02)^2 of that drift accumulates every two periods";

void claim_loads(const Claims<Results>& claims, const SetUp& s) {
  const auto limit = [s](const Periodic& one) { return one.limit(s); };
  const auto phase_limit = [s](const Periodic& one) { return one.phase_limit(s); };
  claims.check(
      "forces",
      "The forces of periodic waves on front and rear agree with small standing waves within the unsettled start and "
      "the mesh drift, 2 % at most.",
      "largest difference, amplitude and phase, over the larger force",
      [limit](const Results& r) { return farthest(r, &Periodic::difference, limit); },
      Bound{.limit = Amount::told_by_run(largest_limit), .reason = reason});
  claims.check(
      "phases",
      "The phases of the forces on front and rear agree with small standing waves within start and mesh drift, 0.06 "
      "rad at most.",
      "largest difference of the phase from small standing waves [rad]",
      [phase_limit](const Results& r) { return farthest(r, &Periodic::phase, phase_limit); },
      Bound{.limit = Amount::told_by_run(3 * largest_limit), .reason = reason + "; of the smaller force"});
  claims.from("Havelock (1929)")
      .check(
          "antinode", "The height of the standing wave agrees with twice the incident height of linear piston theory.",
          "largest relative difference of the antinode from twice the theory of the piston",
          [s](const Results& r) {
            const double cell = std::max(1 / s.mesh.columns_per_depth, 1 / static_cast<double>(s.mesh.rows));
            return farthest(
                r, [&](const Periodic& one) { return std::abs(std::abs(one.settled.antinode) / s.height - 1); },
                [&](const Periodic& one) {
                  return std::pow(2 * std::numbers::pi / one.small.load.wavelength * cell, 2) + one.limit(s);
                });
          },
          Bound{.limit = Amount::told_by_run(0.1),
                .reason = "second order of the cells at the paddle, (k h)^2; and the unsettled part"});
}

void claim_statement(const Claims<Results>& claims, const SetUp& s) {
  const auto phase = [s](const Periodic& one) -> Measurement {
    return {.value = std::abs(std::arg(one.settled.front / one.settled.rear)),
            .told = {.limit = 2 * one.phase_limit(s)}};
  };
  claims.entry(0).check("antiphase",
                        "The forces on front and rear are in antiphase where the berm is half a wavelength wide.",
                        "phase between front and rear [rad]", phase,
                        Bound{.limit = Amount::told_by_run(6 * largest_limit),
                              .reason = "the phases of both, " + reason,
                              .expected = std::numbers::pi});
  claims.entry(0).check(
      "less-than-plain-wall",
      "The total force on a breakwater with a berm half a wavelength wide is below a tenth of the force on a plain "
      "wall.",
      "|total|/plain wall", &Periodic::relative, Bound{.limit = 0.1, .reason = "a tenth"});
  claims.last().check(
      "together",
      "The phase between the forces of the longest waves on front and rear is zero within the errors of both, 0.12 rad "
      "at most.",
      "phase between front and rear [rad]", phase,
      Bound{.limit = Amount::told_by_run(6 * largest_limit), .reason = "the phases of both, " + reason});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s(values);
  const auto here = claims.at(s.name());
  claim_loads(here, s);
  claim_statement(here, s);
}

/// When the tank has settled before the breakwater and nothing has come around once more.
IncidentWaves incident(const SetUp& s, const BasinWave& small) {
  IncidentWaves waves{.sea = s.sea};
  const auto steps = static_cast<double>(s.steps);
  waves.tau = 2 / small.mode.frequency * std::sin(std::numbers::pi / steps);
  const double period = steps * waves.tau;
  waves.omega = 2 * std::numbers::pi / period;
  const exact::Wavemaker paddle(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{waves.omega});
  waves.half_stroke = 0.5 * s.height / paddle.height_per_stroke();
  const exact::AiryDispersion airy(1, 1);
  const double group = airy.group_speed(airy.wavenumber(waves.omega));
  const double around = 3 * (s.berm.length + s.sea - s.berm.width);
  waves.end = period * std::floor(around / (0.4 + 0.6 * group) / period);
  waves.settled_periods = std::max(2L, std::lround(std::floor(waves.rise / period)));
  return waves;
}

/// Share of the wave that is missing, or too much, by the linear theory of the start: in what comes in, in what comes
/// back, and in what has come around.
double unsettled(const SetUp& s, const IncidentWaves& waves, const Antinode& antinode) {
  const auto share = settled_share(waves);
  const exact::AiryDispersion deep(1, 1);
  const exact::AiryDispersion shallow(1, 1 - s.berm.rise);
  const double slower =
      deep.group_speed(deep.wavenumber(waves.omega)) / shallow.group_speed(shallow.wavenumber(waves.omega));
  const double length = s.berm.length + s.sea;
  const double there = length + antinode.place;
  // As far in deep water as the berm takes time.
  const double back = length - s.berm.width + 2 * slower * s.berm.width + (-antinode.place - s.berm.width);
  const double around = 2 * (length - s.berm.width) + there;
  return std::abs(share(there) - 1.0) + std::abs(share(back) - 1.0) + std::abs(share(around));
}

Results compute(const Run& run) {
  const SetUp s(run);
  Results r;
  for (const double wavelength : s.wavelengths) {
    BasinWave small = basin_wave(s.berm, s.mesh, wavelength);
    const IncidentWaves waves = incident(s, small);
    const Antinode antinode = antinode_before(s.berm, small.mode);
    TankHistory history = run_tank(s.berm, s.mesh, waves, antinode);
    const TankHistory::Settled over = settled(history, waves, antinode);
    r.push_back({std::move(small), waves, std::move(history), over, unsettled(s, waves, antinode)});
    run.progress(static_cast<double>(r.size()) / static_cast<double>(s.wavelengths.size()));
  }
  return r;
}

void tabulate(const Results& r, const SetUp& s, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "forces", "Forces of periodic waves",
                "Amplitudes over the height of the antinode, and phase difference between front and rear. In brackets: "
                "small standing waves.",
                {"wavelength [depth]", "front [rho g depth]", "(front) [rho g depth]", "rear [rho g depth]",
                 "(rear) [rho g depth]", "phase [rad]", "total/plain wall [1]", "(total/plain wall) [1]",
                 "antinode/2 incident [1]", "not settled [1]"},
                {"frank-breakwater"});
  for (const Periodic& one : r) {
    const TankHistory::Settled& f = one.settled;
    const StandingLoad& load = one.small.load;
    table.rows.push_back({load.wavelength, std::abs(f.front), std::abs(load.force.front), std::abs(f.rear),
                          std::abs(load.force.rear), std::abs(std::arg(f.front / f.rear)), one.relative(),
                          load.relative(), std::abs(f.antinode) / s.height, one.unsettled});
  }
}

void draw_loads(const Results& r, const SetUp& s, evidence::Exhibit& exhibit) {
  constexpr double shortest = 4;
  std::vector<StandingLoad> standing = standing_loads(s.berm, s.mesh, shortest);
  std::erase_if(standing, [](const StandingLoad& one) { return one.wavelength > 17; });
  const std::vector<double> length = each(standing, &StandingLoad::wavelength);
  auto& panel = add_panel(exhibit, "loads", "Load of periodic waves",
                          "Total force over that on a plain wall: periodic waves from the paddle, and small standing "
                          "waves of a basin, joined by lines.",
                          {.x = "wavelength [depth]", .y = "|total|/plain wall"}, {"frank-breakwater"});
  panel.line("standing waves", length, each(standing, &StandingLoad::relative), Role::exact);
  panel.points("periodic waves", each(r, [](const Periodic& one) { return one.small.load.wavelength; }),
               each(r, &Periodic::relative), Role::computed);
  panel.line("a tenth", std::vector{length.back(), length.front()}, std::vector{0.1, 0.1}, Role::guide);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp s(values);
  tabulate(r, s, exhibit);
  draw_loads(r, s, exhibit);
  auto& figure =
      exhibit.figure("tank", "Arrival of periodic waves",
                     "Forces on front, rear and both, over the intended height of the antinode.", {"frank-breakwater"});
  for (const Periodic* one : {&r.front(), &r.back()}) {
    const auto relative = [&](double force) { return force / s.height; };
    const TankHistory& history = one->history;
    BermHistory forces{history.time, each(history.front, relative), each(history.rear, relative)};
    std::ranges::transform(forces.front, forces.rear, std::back_inserter(forces.total), std::plus{});
    const std::string title = fmt::format("waves of L/h = {:.3g}", one->small.load.wavelength);
    draw_forces(figure.panel({.x = "t [sqrt(depth/g)]", .y = "force/height [rho g depth]", .title = title}), forces);
  }
}

void breakwater_periodic(Case& c) {
  c.title = "Periodic waves on a breakwater whose front and rear are loaded in antiphase";
  c.source = literature::frank + ", section 2.3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("sea", 36.0, "depth", {20, 200}, "excess length of the tank over the basin of 14 h"),
      real("height", 1e-4, "depth", {1e-6, 1e-3}, "intended height of the standing wave at its antinodes"),
      real("columns_per_depth", 8.0, "1", {8, 32}, "columns of cells per depth"),
      integer("rows", 6, {6, 24}, "rows of cells"),
      integer("steps", 60, {60, 1000}, "time steps in a period"),
  };
  c.published = {{.tiles = {"frank-breakwater"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::breakwater_periodic
