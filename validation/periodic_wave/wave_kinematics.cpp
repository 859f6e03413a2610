/*
Loads on piles and pipes follow from the velocities below a wave, which may be wrong under a correct surface. Below a
periodic or a solitary wave of the Euler equations `seiche exact stokes` and `seiche exact solitary` give them to
round-off, up to the surface.

**What is compared.** The case shows horizontal and vertical velocity over the depth. It accepts external results: start
from the exact surface and velocities with a crest at $x = 0$ (`seiche exact ... --grid`; the periodic wave in one
wavelength), run the wave over the distance `way`, and submit $u$ and $v$ over the depth in four sections: at the crest,
on its front, and ahead. Heights count from the mean level.

**What to look at.** Linear theory beside the crest: too low above the mean level, too high at the bed. A depth-averaged
dispersive solver has one velocity over the depth.
*/
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::wave_kinematics {

const std::string source = "Cokelet (1977); Longuet-Higgins and Fenton (1974)";
constexpr std::size_t fewest = 8;  ///< points of a section: with two, lines hide what changes over the depth

/// What either wave says of itself.
struct Wave {
  std::function<double(double x)> elevation;  ///< of the distance from the crest
  std::function<exact::Velocity(double x, double y)> velocity;
  double speed = 0, depth = 0, crest_velocity = 0;
  std::vector<double> sections;  ///< distances from the crest
  double period = 0;             ///< in x; 0 without one
  std::string command;
  exact::SelfTest identities;
};

Wave wave_of(const Values& values) {
  const double height = values.real("height");
  const double depth = values.real("depth");
  const double gravity = values.real("gravity");
  const std::string words = fmt::format("depth={:.17g},gravity={:.17g}", depth, gravity);
  const auto described = [depth](const auto& wave, double speed, const std::vector<double>& sections, double period,
                                 const std::string& command) -> Wave {
    return {.elevation = [wave](double x) { return wave.elevation(x); },
            .velocity = [wave](double x, double y) { return wave.velocity(x, y); },
            .speed = speed,
            .depth = depth,
            .crest_velocity = wave.crest_velocity(),
            .sections = sections,
            .period = period,
            .command = command,
            .identities = wave.self_test()};
  };
  if (values.text("wave") == "solitary") {
    const exact::SolitaryWave wave(height, depth, gravity);
    return described(wave, wave.speed(), {0, depth / 2, depth, 2 * depth}, 0,
                     fmt::format("seiche exact solitary --set amplitude={:.17g},{}", height, words));
  }
  const double length = values.real("wavelength");
  const exact::StokesWave wave(height / 2, length, depth, gravity);
  return described(
      wave, wave.phase_speed(), {0, length / 8, length / 4, length / 2}, length,
      fmt::format("seiche exact stokes --set amplitude={:.17g},wavelength={:.17g},{}", height / 2, length, words));
}

/// Heights in a section, from a twentieth of the water's depth there to nineteen.
std::vector<double> heights(const Wave& wave, double from_crest) {
  std::vector<double> y;
  for (const double share : evenly(0.05, 0.95, 19))
    y.push_back(share * (wave.depth + wave.elevation(from_crest)) - wave.depth);
  return y;
}

void claims(const Values& values, const Claims<Wave>& claims) {
  claim_identities(claims.from(source).of(&Wave::identities), wave_of(values).identities);
}

Wave compute(const Run& run) {
  return wave_of(run);
}

void show(const Wave& wave, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("crest_velocity", wave.crest_velocity);
  exhibit.measure("speed", wave.speed);
  auto& figure = exhibit.figure("velocities", "Velocities over the depth",
                                "In four sections, from the crest on; for a periodic wave also the linear wave of the "
                                "same height below the crest.");
  auto& along = figure.panel({.x = "u [m/s]", .y = "y [m]"});
  auto& upwards = figure.panel({.x = "v [m/s]", .y = "y [m]"});
  for (const double section : wave.sections) {
    const std::vector<double> y = heights(wave, section);
    const std::string label = fmt::format("{:g} m ahead of the crest", section);
    along.line(label, each(y, [&](double at) { return wave.velocity(section, at).u; }), y, Role::exact);
    upwards.line(label, each(y, [&](double at) { return wave.velocity(section, at).v; }), y, Role::exact);
  }
  if (wave.period == 0) return;
  const double k = 2 * std::numbers::pi / wave.period;
  const double omega = exact::AiryDispersion(values.real("gravity"), wave.depth).frequency(k);
  const std::vector<double> y = heights(wave, 0);
  const auto linear = [&](double at) {
    return values.real("height") / 2 * omega * std::cosh(k * (at + wave.depth)) / std::sinh(k * wave.depth);
  };
  along.line("linear, crest", each(y, linear), y, Role::guide);
}

std::vector<WantedTable> wanted(const Values& values) {
  const Wave wave = wave_of(values);
  const double way = values.real("way");
  if (wave.period > 0) {
    const double off = std::abs(std::remainder(way, wave.period));
    if (off < 0.1 * wave.period) {
      throw std::invalid_argument(
          fmt::format("way = {:g} is out of range: must differ from whole multiples of the wavelength {:g} by a tenth "
                      "of it or more, or a stationary wave would be correct",
                      way, wave.period));
    }
  }
  const double time = way / wave.speed;
  // Within the one wavelength of a periodic wave.
  const auto place = [&](double section) {
    return wave.period > 0 ? std::fmod(way + section, wave.period) : way + section;
  };
  const auto from_crest = [wave, way](double x) {
    return wave.period > 0 ? std::remainder(x - way, wave.period) : x - way;
  };
  Worst vertical;
  for (const double section : wave.sections) {
    for (const double y : heights(wave, section)) vertical.add(wave.velocity(section, y).v);
  }
  const auto close = [&](double largest) {
    return std::vector<Requirement>{
        {.measure = Measure::largest_error,
         .criterion = Bound{.limit = values.real("tolerance") * largest,
                            .reason = "the case's parameter `tolerance`, of the largest such velocity in the sections; "
                                      "by default 3.5 %, equivalent to 7 % of a drag force"},
         .text = "The velocity over the depth agrees with the exact wave within the tolerance, by default 3.5 % of the "
                 "largest.",
         .source = source}};
  };
  std::vector<std::string> exact;
  for (const double section : wave.sections) {
    const std::vector<double> y = heights(wave, section);
    exact.push_back(fmt::format("{} --grid x={:.17g},y={:.17g}:{:.17g}:{},t={:.17g}", wave.command, place(section),
                                y.front(), y.back(), y.size(), time));
  }
  return {{
      .name = "velocities",
      .kind = WantedTable::Kind::profile,
      .group = Column{"x", "m", fmt::format("position of the section, at t = {:.10g} s", time)},
      .abscissa = Column{"y", "m", "height above the mean level"},
      .quantities = {{.column = {"u", "m/s", "horizontal velocity, positive in the wave direction"},
                      .reference = [=](Place p) { return wave.velocity(from_crest(p.group), p.abscissa).u; },
                      .requirements = close(wave.crest_velocity)},
                     {.column = {"v", "m/s", "vertical velocity, positive upwards"},
                      .reference = [=](Place p) { return wave.velocity(from_crest(p.group), p.abscissa).v; },
                      .requirements = close(vertical.value())}},
      .groups = each(wave.sections, place),
      .points = [=](double x) { return heights(wave, from_crest(x)); },
      .exact = exact,
  }};
}

void judge(const Values& /*values*/, const Submitted& submitted, const SolverFacts& /*facts*/,
           evidence::Record& record) {
  Smallest points;
  for (const SubmittedGroup& section : submitted.at("velocities")) {
    if (section.abscissa.size() < fewest) {
      throw std::invalid_argument(fmt::format("column y: {} points in the section x = {:g} m, must be at least {}",
                                              section.abscissa.size(), section.value, fewest));
    }
    points.add(static_cast<double>(section.abscissa.size()));
  }
  record.measure("fewest_points", points.value());
}

void wave_kinematics(Case& c) {
  c.title = "Velocities below a periodic and a solitary wave";
  c.source =
      "E. D. Cokelet, Phil. Trans. R. Soc. A 286 (1977) 183; M. S. Longuet-Higgins, J. D. Fenton, Proc. R. Soc. A 340 "
      "(1974) 471";
  c.parameters = {
      choice("wave", "stokes", {"stokes", "solitary"}, "a periodic wave, or a solitary one"),
      real("height", 0.3, "m", {1e-6, 1e6}, "from trough to crest; of a solitary wave above still water"),
      real("wavelength", 8.0, "m", {1e-6, 1e6}, "of the periodic wave"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "mean depth"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("way", 22.0, "m", {1e-6, 1e6}, "distance travelled when the velocities are requested"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show);
  c.submission = {.tables = wanted, .judge = judge};
}

}  // namespace seiche::validation::cases::wave_kinematics
