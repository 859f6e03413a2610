/*
A solitary wave meets a wall at an angle $\psi_i$ (Frank 1994, section 4.3). At large angles reflection is regular: the
crests of incident and reflected wave intersect at the wall. At small angles a third wave, the *Mach stem*, forms normal
to the wall; its amplitude exceeds the sum of the other two, and its length grows indefinitely. Lengths are over the
depth, times over $\sqrt{\text{depth}/g}$.

For waves of small amplitude $a_i$ Miles (1977) found the final state as a function of $\kappa = \psi_i/\sqrt{3a_i}$:
for $\kappa < 1$ a stem of amplitude $a_w = (1+\kappa)^2 a_i$ and a reflected wave of amplitude $a_r = \kappa^2 a_i$ at
the angle $\psi_r = \sqrt{3a_i}$; for $\kappa > 1$ equal angles and amplitudes, and $a_w = 4a_i/(1 + \sqrt{1 -
\kappa^{-2}})$. Li, Yeh and Kodama (2011) replace $\kappa$ by $\tan\psi_i/(\sqrt{3a_i}\cos\psi_i)$, which holds at
larger angles.

**Set-up.** The wall is $y = 0$. The domain is a window moving with the crest. Serre's exact wave enters through the
north side, and initially crosses the window undisturbed. `model`: `plan`, water columns with nodes on the surface, or
`hexahedra`, layers of Lagrangian cells. Steps are half the spacing `h`.

**What is compared.** Amplitudes at the wall, of the incident and of the reflected wave; angles of the reflected wave
and of the path of the stem's end. Two configurations: `angle`, and `second_angle` beyond the transition, each on two or
more grids, whose differences give the numerical uncertainty. The theories are the reference.

**What to look at.** Theory with Miles's plain $\kappa$ is far too low for $a = 0.3$, with the $\kappa$ for finite
angles it agrees within a few per cent. The angle of reflection is larger than the angle of incidence, but smaller than
$\sqrt{3a_i}$. The ratio $a_w/a_i$ uses the measured $a_i$. Near the transition the stem grows for a very long time: a
run with a growth of more than 1 % in its last fifth is marked, and the limit of a fitted approach given instead.
*/
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/instruments/each.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation::cases::mach_reflection {

using exact::MachReflection;

const std::string source = "Frank (1994), section 4.3";

/// One quantity of a reflection, and how to measure it.
struct Quantity {
  std::string id;
  Measurement (*measured)(const Reflection&);
};

const std::vector<Quantity> quantities{
    {"a_w_over_a_i", [](const Reflection& r) { return r.wall_ratio(); }},
    {"a_r_over_a_i", [](const Reflection& r) { return r.reflected_ratio(); }},
    {"psi_r", [](const Reflection& r) { return r.reflected_angle(); }},
    {"stem_angle",
     [](const Reflection& r) {
       return Measurement{.value = degrees(r.stem.value),
                          .uncertainty = degrees(r.stem.half_width()),
                          .resolution = r.run.resolution()};
     }},
};

/// One angle on several lattices, the finest first.
struct Configuration {
  double angle = 0;  ///< [deg]
  std::vector<Reflection> ladder = {};

  [[nodiscard]] const Reflection& finest() const { return ladder.front(); }
};

using Results = std::vector<Configuration>;

/// Spacings over `h`, the finest first.
std::vector<double> lattices_of(const Values& values) {
  if (values.tier() == Tier::quick) return {1, 1.25};
  if (values.tier() == Tier::full) return {1, 1.4, 2};
  return {0.7, 1, 1.4, 2};
}

std::vector<double> angles_of(const Values& values) {
  std::vector<double> angles{values.real("angle")};
  if (values.real("second_angle") > 0) angles.push_back(values.real("second_angle"));
  if (angles.front() == angles.back() && angles.size() > 1) {
    throw std::invalid_argument("second_angle must differ from angle");
  }
  return angles;
}

ReflectionRun run_of(const Values& values, double angle, double factor = 1) {
  return {.amplitude = values.real("amplitude"),
          .angle = radians(angle),
          .spacing = factor * values.real("h"),
          .time = values.real("time"),
          .model = wave_model_named(values.text("model")),
          .layers = values.count("layers")};
}

Results compute(const Run& run) {
  const std::vector<double> factors = lattices_of(run);
  Results all;
  for (const double angle : angles_of(run)) all.push_back({angle, std::vector<Reflection>(factors.size())});
  const std::size_t count = all.size() * factors.size();
  on_threads(run, count, [&](std::size_t k) {
    Configuration& one = all[k % all.size()];
    one.ladder[k / all.size()] = reflect_as_part(run, run_of(run, one.angle, factors[k / all.size()]));
  });
  return all;
}

/// Until the stem should have settled.
bool long_enough(const ReflectionRun& run) {
  return run.time == 0 || run.time >= run.settled_time();
}

/// Theory is of leading order in the amplitude.
void claim_theory(const Claims<Configuration>& claims, double angle, const ReflectionRun& what) {
  const MachReflection finite = what.finite_angles();
  constexpr double cusp = 0.15;
  claims
      .only_if(std::abs(finite.kappa() - 1) >= cusp,
               "the theory has a cusp at kappa = 1 and is not compared within 0.15 of it")
      .only_if(long_enough(what), "a run shorter than the settling time of its stem has no known limit")
      .check(
          "theory-" + id_of(angle),
          fmt::format("The amplitude at the wall at {:g} deg agrees with small-wave theory, with the parameter for "
                      "finite angles.",
                      angle),
          "a_w/a_i for infinite time", [](const Configuration& one) { return one.finest().limit_ratio(); },
          Bound{.limit = finite.theory_uncertainty(),
                .reason = "the neglected terms are of the order of the incident amplitude; not compared within 0.15 of "
                          "kappa = 1, where the theory has a cusp",
                .expected = finite.wall_ratio(),
                .relative = true});
}

void claim_steady(const Claims<Configuration>& claims, double angle, const ReflectionRun& what) {
  claims
      .only_if(std::abs(what.kappa_finite_angle() - 1) > 0.25 && long_enough(what),
               "next to kappa = 1, and in runs shorter than the settling time, the stem still grows at the end")
      .from(source)
      .check(
          "steady-" + id_of(angle),
          fmt::format("The amplitude at the wall at {:g} deg is steady: its growth in the last fifth of the run is "
                      "below the limit.",
                      angle),
          "relative growth during the last fifth of the run",
          [](const Configuration& one) { return one.finest().limit.growth; },
          Bound{.limit = steady_growth,
                .reason = "at this rate the amplitude would change by 5 % in as long again, which is below the "
                          "neglected terms of the theory"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<double> angles = angles_of(values);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const ReflectionRun what = run_of(values, angles[k], lattices_of(values).front());
    const auto one = claims.at(what.resolution()).entry(k);
    claim_theory(one, angles[k], what);
    claim_steady(one, angles[k], what);
  }
}

void draw_surface(evidence::Exhibit& exhibit, const Configuration& one) {
  const Reflection& r = one.finest();
  auto& plan = add_panel(
      exhibit, "surface-" + id_of(one.angle), fmt::format("The pattern at {:g} deg", one.angle),
      fmt::format(
          "a_i = {:g}, {}; {}. x from the crest on the wall, y from the wall. Dots: measured crests; lines: fits.",
          r.run.amplitude, r.run.resolution(), r.growth_flag()),
      {.x = "x [depth]", .y = "y [depth]", .z = "elevation [depth]"});
  plan.plan("elevation", r.surface.lattice());
  const auto crests = [&](const std::string& name, const std::vector<Crest>& found, const StraightLine& line) {
    const double wall = r.pattern.wall.x;
    const std::vector<double> y = each(found, &Crest::y);
    plan.points(name, each(found, [&](const Crest& crest) { return crest.x - wall; }), y, Role::data);
    plan.line("fitted", each(y, [&](double at) { return line.at(at) - wall; }), y, Role::exact);
  };
  crests("incident crest", r.pattern.incident, r.pattern.incident_line);
  if (r.pattern.reflected) crests("reflected crest", r.pattern.reflected->crests, r.pattern.reflected->line);
}

void draw_history(evidence::Exhibit& exhibit, const std::vector<Configuration>& all) {
  auto& panel = add_panel(exhibit, "wall", "Amplitude at the wall",
                          "Over the measured incident amplitude, on the finest grid; dashed: the limit of an "
                          "exponential fitted to the last half.",
                          {.x = "t [sqrt(depth/g)]", .y = "a_w/a_i"});
  for (const Configuration& one : all) {
    const Reflection& r = one.finest();
    panel.line(fmt::format("{:g} deg, {}: {}", one.angle, r.run.resolution(), r.growth_flag()), r.time,
               each(r.wall, [&](double height) { return height / r.pattern.incident_amplitude.value; }));
    panel.line("limit", std::vector{0.0, r.time.back()}, std::vector(2, r.limit_ratio().value), Role::guide);
  }
}

void tabulate(evidence::Exhibit& exhibit, const std::vector<Configuration>& all) {
  evidence::Table& table =
      add_table(exhibit, "reflections", "Measured values and references",
                "Limit: for fine grids; theories: for small waves after infinite time, with Miles's kappa and with the "
                "kappa for finite angles.",
                {"angle [deg]", "quantity", "measured", "uncertainty", "limit", "Miles", "finite angles"});
  for (const Configuration& one : all) {
    const auto theory = [](const MachReflection& t) {
      return std::vector{t.wall_ratio(), t.reflected_ratio(), degrees(t.reflected_angle()), degrees(t.stem_angle())};
    };
    const std::vector<double> miles = theory(one.finest().run.miles());
    const std::vector<double> finite = theory(one.finest().run.finite_angles());
    for (std::size_t k = 0; k < quantities.size(); ++k) {
      const auto& [id, measured] = quantities[k];
      const Measurement finest = measured(one.finest());
      const FineLimit limit = limit_of_lattices(one.ladder, [&](const Reflection& r) { return measured(r).value; });
      // With the uncertainty of its measure and of the lattice.
      table.rows.push_back({one.angle, id, rounded(finest.value),
                            rounded(std::hypot(finest.half_width(), limit.uncertainty)), rounded(limit.value),
                            rounded(miles[k]), rounded(finite[k])});
    }
  }
}

void show(const Results& all, const Values& /*values*/, evidence::Exhibit& exhibit) {
  for (const Configuration& one : all) {
    const Reflection& finest = one.finest();
    const auto keep = [&](const std::string& name, double value) {
      exhibit.measure(name + (&one == &all.front() ? "" : "_second"), value);
    };
    keep("a_w", finest.wall.back());
    keep("a_i", finest.pattern.incident_amplitude.value);
    if (finest.pattern.reflected) keep("a_r", finest.pattern.reflected->amplitude.value);
    keep("kappa", finest.run.kappa());
    keep("kappa_finite_angle", finest.run.kappa_finite_angle());
    keep("stem_length", finest.pattern.stem_length.value);
    keep("end_time", finest.time.back());
    keep("worst_corner", finest.worst_corner);
    keep("cells", static_cast<double>(finest.cells));
    keep("iterations_per_step", finest.iterations);
    keep("processor_seconds", finest.seconds);
    draw_surface(exhibit, one);
  }
  draw_history(exhibit, all);
  tabulate(exhibit, all);
}

void mach_reflection(Case& c) {
  c.title = "Reflection of a solitary wave at a wall, with and without a Mach stem";
  c.source = literature::frank + ", section 4.3; " + literature::miles +
             "; W. Li, H. Yeh, Y. Kodama, J. Fluid Mech. 672 (2011) 326";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = {
      real("amplitude", 0.3, "depth", {0.01, 0.55}, "a_i of the incident wave"),
      real("angle", 30.0, "deg", {5, 75}, "psi_i between wave direction and wall"),
      real("second_angle", 42.0, "deg", {0, 75}, "of a second configuration; 0 for none"),
      real("h", {1, 0.5, 0.5}, "depth", {0.1, 1.5}, "initial grid spacing"),
      real("time", 0.0, "sqrt(depth/g)", {0, 20000}, "length of the run; 0: the theoretical settling time of the stem"),
      choice("model", "plan", {"plan", "hexahedra"}, "water columns or layers of hexahedra"),
      integer("layers", 2, {1, 8}, "of hexahedra"),
  };
  c.study = Study(claims, compute, show, "Miles (1977); Li, Yeh and Kodama (2011)");
}

}  // namespace seiche::validation::cases::mach_reflection
