/*
A hump of water at the end of a long tank is released and becomes a solitary wave that outruns the small waves behind
it. Frank (1994, chapter 2) generated solitary waves in this way, and gives their height $A$ and speed $C$ and a figure
of the profile.

**Set-up.** Depth and gravity are 1; the tank is 170 long. The initial surface is $a_0\,\mathrm{sech}^2(x/w)$, symmetric
about the wall $x = 0$, with the water at rest. The crest is followed until $t = 130$. From $t = 65$ on, $A$ is its mean
height and $C$ the slope of a straight line through its positions. In shorter tanks $C$ is too large by some tenths of a
per cent, because the small waves have not separated. Four starts give four heights.

**What is compared.** Speeds with the source's table, with $\sqrt{1 + A}$, and with the exact waves of the Euler
equations. Profiles with the second approximation of shallow-water theory (Laitone 1960),

$$\eta = A S - \tfrac34 A^2 S (1 - S), \quad S = \mathrm{sech}^2\left(\sqrt{\tfrac{3A}{4}}\,(1 - \tfrac58
A)\,x\right),$$

and with the exact wave of the same height. The error of the second approximation is 0.01 at $A = 0.3$ and 0.05 at $A =
0.5$: the exact wave is the reference.

**What to look at.** On cells one depth wide and half a depth high, which the source recommends for long waves, heights
and speeds agree with its table, slightly below $\sqrt{1 + A}$. The profile is near the second approximation, as in the
source's figure, because the errors of mesh and series are alike. On finer meshes speed and profile depart from the
series and converge to the exact wave.

The lowest wave of the source's table differs most, being slower by 0.004 than computed here and by 0.003 than the exact
wave; the cause is unknown.

The highest wave leaves the first column of the coarsest mesh sheared; it tangles long after the wave has left.
*/
#include <algorithm>
#include <array>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/reference_source.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/mesh/crest_track.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "validation/instruments/mesh/mesh_solitary_wave.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::solitary_birth {

using exact::AsymptoticSolitary;
using exact::SolitaryWave;
using lagrangian_mesh_2d::Flow;

const std::string source = "Frank (1994), chapter 2, figure 1 and table";

constexpr double birth_tank = 170;  // length
constexpr double birth_duration = 130;
constexpr double birth_separated = 65;  // from then on the crest is measured
constexpr double birth_reach = 6;       // of the profile, from the crest

/// a0 sech^2(x/w).
struct Hump {
  double height, width;
};

constexpr std::array<Hump, 4> starts{{{0.39, 3}, {0.56, 3}, {0.77, 3}, {0.98, 2.7}}};

struct Born {
  CrestTrack track;
  double amplitude = 0;
  double speed = 0;
  double from_exact = 0;    ///< largest distance of the profile from the exact wave as high as its crest
  double from_laitone = 0;  ///< the same, second approximation

  [[nodiscard]] double end_amplitude() const { return track.elevation.back(); }
};

/// All starts on one mesh.
struct Family {
  std::string label;
  MeshResolution mesh;
  std::vector<Born> waves;

  /// A quantity at a height, linear between the waves.
  template <class Quantity>
  [[nodiscard]] double at(double amplitude, const Quantity& quantity) const {
    std::size_t k = 1;
    while (k + 1 < waves.size() && waves[k].amplitude < amplitude) ++k;
    const Born& low = waves[k - 1];
    const Born& high = waves[k];
    const double w = (amplitude - low.amplitude) / (high.amplitude - low.amplitude);
    return (1 - w) * quantity(low) + w * quantity(high);
  }
  [[nodiscard]] double speed_at(double amplitude) const { return at(amplitude, std::mem_fn(&Born::speed)); }
};

Flow raised(const Hump& hump, const MeshResolution& mesh, double hourglass) {
  lagrangian_mesh_2d::Layer layer = tank(birth_tank, 1, mesh);
  layer.elevation = [&](double x) {
    const double s = 1 / std::cosh(x / hump.width);
    return hump.height * s * s;
  };
  return Flow(layer_mesh(layer), {}, {}, lagrangian_mesh_2d::Settings{.hourglass = hourglass});
}

/// Both waves that a profile is compared with, of its crest's height.
struct Theory {
  explicit Theory(double amplitude) : exact(amplitude), laitone(AsymptoticSolitary::Theory::laitone, amplitude) {}
  SolitaryWave exact;
  AsymptoticSolitary laitone;
};

/// Follows the crest to the end.
Born follow(Flow& flow, double tau, const std::function<void()>& after_step = {}) {
  Born born{.track = follow_crest(flow, birth_duration, tau, after_step)};
  born.amplitude = born.track.mean_elevation(birth_separated);
  born.speed = born.track.speed(birth_separated);
  const Theory theory(born.end_amplitude());
  const auto distance_from = [&](const auto& wave) {
    return largest_profile_error(flow, born.track.place.back(), birth_reach,
                                 [&](double s) { return wave.elevation(s); });
  };
  born.from_exact = distance_from(theory.exact);
  born.from_laitone = distance_from(theory.laitone);
  return born;
}

/// The meshes of a tier, without their waves.
std::vector<Family> families(Tier tier) {
  std::vector<MeshResolution> meshes = {{1, 2, 0.1}, {0.5, 4, 0.1}};
  if (tier != Tier::quick) meshes.push_back({0.25, 8, 0.05});
  std::vector<Family> all;
  for (const MeshResolution& mesh : meshes) {
    all.push_back({fmt::format("h1 = {:g}, h2 = {:g}", mesh.column_width, 0.5 * mesh.column_width), mesh, {}});
  }
  return all;
}

/// Speed of exact waves of heights 0.1 to 0.65: between eight of them, which take a tenth of a second each, by a
/// rational function, to 1e-6.
using EulerSpeed = boost::math::barycentric_rational<double>;
EulerSpeed euler_speed() {
  const std::vector<double> heights = evenly(0.1, 0.65, 8);
  const std::vector<double> speeds = each(heights, [](double a) { return SolitaryWave(a).speed(); });
  return {heights.data(), speeds.data(), heights.size(), 5};
}

/// The surface on the way.
struct Surface {
  double time;
  std::vector<double> x, y;
};

struct Results {
  Flow flow;  ///< of the wave of the parameters, at the end
  Born own = {};
  std::vector<Surface> birth = {};
  EulerSpeed euler = euler_speed();
  std::vector<Family> families;
  Born from_exact = {};  ///< the exact wave, let run on the coarsest mesh

  [[nodiscard]] const Family& coarsest() const { return families.front(); }
};

MeshResolution own_mesh(const Values& values) {
  return {values.real("h1"), values.integer("rows"), values.real("tau")};
}

Flow exact_wave(const MeshResolution& resolution) {
  const SolitaryWave wave(0.3);
  const PlacedWave placed{wave, 12};
  const lagrangian_mesh_2d::Mesh mesh = placed.mesh(birth_tank, resolution);
  return Flow(mesh, impulsive_start(mesh, [&](double x) { return placed.surface_potential(x); }));
}

Results compute(const Run& run) {
  Results r{.flow = raised({run.real("elevation"), run.real("width")}, own_mesh(run), run.real("hourglass")),
            .families = families(run.tier())};
  double next = 0;
  const auto keep = [&] {
    if (r.flow.time() < next - 1e-9) return;
    const auto& [x, y] = surface_nodes(r.flow, {});
    r.birth.push_back({next, x, y});
    next = next < 30 ? next + 10 : next + 50;
  };
  keep();
  r.own = follow(r.flow, run.real("tau"), keep);
  if (r.own.track.tangled) throw Divergence(*r.own.track.tangled);
  for (Family& family : r.families) {
    for (const Hump& hump : starts) {
      Flow flow = raised(hump, family.mesh, 0);
      family.waves.push_back(follow(flow, family.mesh.tau));
    }
    run.progress(static_cast<double>(&family - r.families.data() + 1) / static_cast<double>(r.families.size() + 1));
  }
  Flow exact = exact_wave(r.coarsest().mesh);
  r.from_exact = follow(exact, r.coarsest().mesh.tau);
  return r;
}

/// Of the distances of speeds from the Euler equations' on a mesh and on the one before, the largest ratio.
double speeds_approach(const Results& r, std::size_t mesh) {
  Largest ratio;
  for (const double amplitude : {0.2, 0.3, 0.4, 0.5}) {
    const auto excess = [&](const Family& family) {
      return std::abs(family.at(amplitude, [&](const Born& wave) { return wave.speed - r.euler(wave.amplitude); }));
    };
    ratio.add(excess(r.families.at(mesh)) / excess(r.families.at(mesh - 1)));
  }
  return ratio.value();
}

/// The same of profiles.
double profiles_approach(const Results& r, std::size_t mesh) {
  const auto distance = [&](std::size_t on, std::size_t wave) { return r.families.at(on).waves.at(wave).from_exact; };
  return over<Largest>(indices(starts.size()), [&](std::size_t k) { return distance(mesh, k) / distance(mesh - 1, k); })
      .value();
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<Family> all = families(values.tier());
  const Claims<Family> coarsest = claims.at(all.front().label).of(&Results::coarsest);
  const Bound nearer{.limit = 1, .reason = "nearer means less than 1"};
  coarsest.check(
      "source-table",
      "The wave speeds agree with the table of Frank (1994) at equal height within 0.005 sqrt(g h), its printed digits "
      "and mesh error.",
      "largest difference [sqrt(g depth)]",
      [published = values.table("frank_1994_celerity")](const Family& coarse) {
        return over<Worst>(indices(published.rows()), [&](std::size_t k) {
          return coarse.speed_at(published.column("A")[k]) - published.column("C")[k];
        });
      },
      Bound{.limit = 0.005,
            .reason = "half a unit of the last digit of A changes C by 0.002, half a unit of C is 0.0005; the source "
                      "does not state its mesh: one twice as fine changes C by up to 0.003 at the same height"});
  for (std::size_t m = 1; m < all.size(); ++m) {
    const auto claim = [&](const char* id, const char* what, double (*approach)(const Results&, std::size_t)) {
      claims.at(all[m].label)
          .check(
              fmt::format("euler-{}-{}", id, all[m].mesh.rows),
              fmt::format("The {} with {} rows are nearer to the Euler equations than with half as many rows.", what,
                          all[m].mesh.rows),
              "largest ratio of the distances", [=](const Results& r) { return approach(r, m); }, nearer);
    };
    claim("speed", "speeds at equal height", speeds_approach);
    claim("profile", "profiles", profiles_approach);
  }
  coarsest.check(
      "second-approximation",
      "The profiles on cells one depth wide are nearer to the second approximation than to the exact wave, as in the "
      "figure of Frank (1994).",
      "largest ratio of the distances",
      [](const Family& coarse) {
        return over<Largest>(coarse.waves, [](const Born& wave) { return wave.from_laitone / wave.from_exact; })
            .value();
      },
      nearer);
  // The same wave however it was made: the exact one ends on the curve of waves born from humps.
  claims
      .at([](const Results& r) {
        return r.coarsest().label + fmt::format(", A = {:.4f} at last", r.from_exact.amplitude);
      })
      .from("a mesh has a single solitary wave of each height")
      .check(
          "one-curve", "The final height and speed of the exact Euler wave started with A = 0.3 lie on the same curve.",
          "difference of C [sqrt(g depth)]",
          [](const Results& r) { return std::abs(r.from_exact.speed - r.coarsest().speed_at(r.from_exact.amplitude)); },
          Bound{.limit = 7e-4,
                .reason = "linear interpolation between heights 0.1 apart: 3e-4 at most; change of the heights by 1e-3 "
                          "during averaging: 4e-4"});
  coarsest
      .fails({.value = 117.1,
              .width = 0.5,
              .reason = "the shear of the first column grows after the wave has left: no force stops it; it grows "
                        "slowly, so that tangling occurs a few steps earlier or later"})
      .check(
          "tangle",
          "The run with the highest hump on cells one depth wide reaches its end time without an inverted corner.",
          "end of the run [sqrt(depth/g)]", [](const Family& coarse) { return coarse.waves.back().track.time.back(); },
          Bound{
              .limit = 1e-9, .reason = "the requested time, to the rounding of its steps", .expected = birth_duration});
}

void tabulate_waves(evidence::Exhibit& exhibit, const Results& r) {
  evidence::Table& table =
      add_table(exhibit, "waves", "Generated waves", "Profiles: largest difference within 6 h of the crest.",
                {"h1 [depth]", "rows [1]", "a0 [depth]", "w [depth]", "A [depth]", "C [sqrt(g depth)]",
                 "sqrt(1 + A) [sqrt(g depth)]", "C, Euler [sqrt(g depth)]", "profile from Euler [depth]",
                 "profile from Laitone [depth]", "followed until [sqrt(depth/g)]"});
  for (const Family& family : r.families) {
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Born& wave = family.waves[k];
      table.rows.push_back({family.mesh.column_width, static_cast<double>(family.mesh.rows), starts[k].height,
                            starts[k].width, wave.amplitude, wave.speed, std::sqrt(1 + wave.amplitude),
                            r.euler(wave.amplitude), wave.from_exact, wave.from_laitone, wave.track.time.back()});
    }
  }
}

void show_celerity(evidence::Exhibit& exhibit, const Results& r, const io::Table& published) {
  const std::vector<double>& amplitude = published.column("A");
  const std::vector<double>& speed = published.column("C");
  const auto root = [](double a) { return std::sqrt(1 + a); };
  evidence::Table& table = add_table(exhibit, "celerity", "Height and speed of solitary waves",
                                     "The source's table beside waves computed here on cells one depth wide and half a "
                                     "depth high, interpolated linearly between heights.",
                                     {"A [depth]", "C, Frank (1994) [sqrt(g depth)]", "C, computed [sqrt(g depth)]",
                                      "sqrt(1 + A) [sqrt(g depth)]", "C, Euler [sqrt(g depth)]"},
                                     {"frank-table-celerity"});
  for (std::size_t k = 0; k < amplitude.size(); ++k) {
    const double a = amplitude[k];
    table.rows.push_back({a, speed[k], r.coarsest().speed_at(a), root(a), r.euler(a)});
  }
  auto& figure = exhibit.figure("celerity", "Speed against height of solitary waves",
                                "Frank's table, computed waves, the Euler equations; then the excess over the latter.",
                                {"frank-table-celerity"});
  auto& speeds = figure.panel({.x = "A [depth]", .y = "C [sqrt(g depth)]"});
  auto& excess = figure.panel({.x = "A [depth]", .y = "C - C_Euler [sqrt(g depth)]"});
  const std::vector<double> fine = evenly(0.1, 0.6, 51);
  speeds.line("Euler equations", fine, each(fine, r.euler), Role::exact);
  speeds.line("sqrt(1 + A)", fine, each(fine, root), Role::guide);
  excess.line("sqrt(1 + A)", fine, each(fine, [&](double a) { return root(a) - r.euler(a); }), Role::guide);
  const ColumnUncertainty uncertainty = reference_source("frank_1994_celerity").standard_uncertainty.at("C");
  const std::vector<double> error = each(speed, [&](double c) { return uncertainty.of(c); });
  speeds.points("Frank (1994)", amplitude, speed, Role::data, error);
  excess.points("Frank (1994)", amplitude,
                each(indices(speed.size()), [&](std::size_t k) { return speed[k] - r.euler(amplitude[k]); }),
                Role::data, error);
  for (const Family& family : r.families) {
    const std::vector<double> amplitudes = each(family.waves, &Born::amplitude);
    const auto over_euler = [&](const Born& wave) { return wave.speed - r.euler(wave.amplitude); };
    speeds.points(family.label, amplitudes, each(family.waves, &Born::speed), Role::computed);
    excess.points(family.label, amplitudes, each(family.waves, over_euler), Role::computed);
  }
}

/// The wave of the parameters: its birth, and its profile at the end.
void draw_own(evidence::Exhibit& exhibit, const Results& r, const std::string& resolution) {
  auto& surface = add_panel(exhibit, "birth", "Evolution of a hump into a solitary wave",
                            "Surface nodes, " + resolution + ".", {.x = "x [depth]", .y = "elevation [depth]"});
  for (const Surface& s : r.birth) surface.line(fmt::format("t = {:.0f}", s.time), s.x, s.y, Role::computed);

  const double crest = r.own.track.place.back();
  const Theory theory(r.own.end_amplitude());
  const MeshWindow window{crest - birth_reach - 2, crest + birth_reach + 2};
  const std::vector<double> x = evenly(window.begin, window.end, 241);
  auto& figure = exhibit.figure(
      "profile", "Generated wave",
      fmt::format("Mesh and surface at t = {:g}, {}; exact wave and second approximation of the same height.",
                  birth_duration, resolution),
      {"frank-fig-1"});
  draw_mesh(figure.panel(mesh_axes("Mesh", window)), "", r.flow, window);
  auto& profile =
      figure.panel({.x = "x [depth]", .y = "elevation [depth]", .x_min = window.begin, .x_max = window.end});
  const auto elevation = [&](const auto& wave) {
    return each(x, [&](double at) { return wave.elevation(at - crest); });
  };
  profile.line("Euler equations", x, elevation(theory.exact), Role::exact);
  profile.line("second approximation", x, elevation(theory.laitone), Role::guide);
  const auto [nodes, heights] = surface_nodes(r.flow, window);
  profile.points("nodes", nodes, heights, Role::computed);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const Born& own = r.own;
  exhibit.measure("amplitude", own.amplitude);
  exhibit.measure("end_amplitude", own.end_amplitude());
  exhibit.measure("speed", own.speed);
  exhibit.measure("profile_from_exact", own.from_exact);
  exhibit.measure("profile_from_second_approximation", own.from_laitone);
  exhibit.measure("worst_corner", own.track.worst_corner);
  exhibit.measure("from_exact_amplitude", r.from_exact.amplitude);
  exhibit.measure("from_exact_speed", r.from_exact.speed);
  if (const auto& tangle = r.coarsest().waves.back().track.tangled) exhibit.measure("tangle_place", tangle->place());
  draw_own(exhibit, r, own_mesh(values).text());
  tabulate_waves(exhibit, r);
  show_celerity(exhibit, r, values.table("frank_1994_celerity"));
}

void solitary_birth(Case& c) {
  c.title = "Solitary wave from a local elevation";
  c.source = literature::frank + ", chapter 2, figure 1 and table; E. V. Laitone, J. Fluid Mech. 9 (1960) 430";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("elevation", 0.56, "depth", {0.05, 1.2}, "of the water at the wall"),
      real("width", 3.0, "depth", {0.5, 10}, "w of the elevation a0 sech^2(x/w)"),
      real("h1", 1.0, "depth", {0.05, 2}, "column width; adjusted to fill the tank"),
      integer("rows", 2, {1, 100}, "of cells over the depth"),
      real("tau", 0.1, "sqrt(depth/g)", {1e-3, 0.5}, "step"),
      real("hourglass", 0.0, "1", {0, 10}, "kappa_0 of the force against node motions (-1)^(i+j)"),
  };
  c.published = {{.tiles = {"frank-table-celerity", "frank-fig-1"}, .stated = {"h1", "rows"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::solitary_birth
