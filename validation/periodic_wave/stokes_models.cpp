/*
Which model suits a steep periodic wave? One wave travels over one wavelength, computed with four models:
Gauss-principle particles, the Lagrangian mesh, dispersive shallow water in one dimension, and weakly compressible SPH.
The reference is the exact wave of the Euler equations; processor time is shown beside the error.

**Set-up.** Depth, gravity and density are 1; $L = 2\pi$, $H = 0.2$, a third of the maximum height. Gauss-principle
particles and SPH run in a periodic channel, from exact velocities (SPH: and pressures). Meshes are not periodic: over
three wavelengths the end nodes follow their exact paths, and the middle wave counts; errors of the ends travel at the
group velocity and do not reach it in this time. The dispersive model starts from the exact wave of its own equations
with the same height and length (`seiche exact serre_cnoidal`). Each model is refined in space and time together.

**What is compared.** Elevations of nodes or of the surface curve with the exact wave: rms over the height, and
the phase. The errors of particles and mesh converge to zero at second order, and so does the error of the dispersive
model against the wave of its own equations. Against the Euler equations it converges to the distance of the two exact
waves, mostly a difference of celerity, known beforehand. Times are shown and never scored.

**What to look at.** For waves of $L/h$ of 6 or more and a phase error of 1 %, the dispersive model suffices: it takes
milliseconds. For a smaller error Gauss-principle particles are the most accurate for their time. The mesh has twice
their error or more at equal time, and gives wall pressures. SPH takes a hundred times as long for an error as large as
the error of the dispersive model, most of it lost height, which hardly falls with the spacing; its use is water that
impacts on itself. Gauss-principle particles, too, continue when the surface overturns (`breaking_gauss`).

**Limits of this test.** Walls, shores, breaking and long times are not covered: Gauss-principle particles conserve
energy, SPH does not. A longer wave has less dispersion, and the dispersive model a smaller error.
*/
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "reports/evidence/claim.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/fine_limit.hpp"
#include "validation/periodic_wave/surface_fit.hpp"
#include "validation/periodic_wave/travelling_models.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation::cases::stokes_models {

using exact::SerreCnoidal;
using exact::StokesWave;

const std::string source = "Frank (1994), chapters 2, 3 and 6; Schwartz (1974)";
const std::string serre_source = "Serre (1953); Schwartz (1974)";

struct Waves {
  StokesWave euler;
  SerreCnoidal serre;

  [[nodiscard]] double length() const { return euler.wavelength(); }
  [[nodiscard]] double height() const { return 2 * euler.amplitude(); }
  [[nodiscard]] double period() const { return length() / euler.phase_speed(); }
  /// Of the crest of Serre's wave after one period of the other.
  [[nodiscard]] double serre_crest() const { return serre.phase_speed() * period(); }
  [[nodiscard]] Elevation elevation() const {
    return [wave = euler](double x) { return wave.elevation(x); };
  }
  [[nodiscard]] Elevation serre_elevation() const {
    return [wave = serre](double x) { return wave.elevation(x); };
  }
};

Waves waves_of(const Values& values) {
  const double height = values.real("height");
  const double length = values.real("length");
  return {StokesWave(height / 2, length, 1, 1), SerreCnoidal(height, length, 1, 1)};
}

/// What one model gives, from coarse to fine.
struct Ladder {
  std::vector<double> size, error, lead, seconds;  ///< error over the height, lead in wavelengths
  std::vector<Point> surface;                      ///< the finest
  double energy_change = 0;                        ///< of the finest

  void add(const Waves& waves, const Followed& followed) {
    size.push_back(followed.size);
    seconds.push_back(followed.seconds);
    surface = followed.last().surface;
    error.push_back(surface_rms(waves.elevation(), surface, waves.length()) / waves.height());
    lead.push_back(surface_lead(waves.elevation(), waves.length(), surface, waves.length()));
    energy_change = followed.last().energy_change;
  }
  [[nodiscard]] evidence::ObservedOrder order() const { return evidence::observed_order(size, error); }
};

struct Results {
  Waves waves;
  Ladder particles = {}, mesh = {}, dispersive = {}, sph = {};
  std::vector<double> own_error = {};  ///< of the dispersive model, against the wave of its own equations
};

std::vector<long> cells_of(const Values& values) {
  return ladder_to(values.integer("cells"), {5.0 / 14, 0.5, 5.0 / 7, 1});
}

Results compute(const Run& run) {
  Results r{.waves = waves_of(run)};
  const Waves& waves = r.waves;
  std::vector<std::function<void()>> work;
  const auto each = [&](const std::vector<long>& resolutions, Ladder& ladder, auto travel) {
    for (const long n : resolutions) work.push_back([&waves, &ladder, travel, n] { ladder.add(waves, travel(n)); });
  };
  each(ladder_to(run.integer("markers"), {0.125, 0.25, 0.5, 1}), r.dispersive, [&](long n) {
    Followed followed = follow_dispersive(waves.serre, waves.period(), n);
    r.own_error.push_back(surface_rms(waves.serre_elevation(), followed.last().surface, waves.serre_crest()) /
                          waves.height());
    return followed;
  });
  each(ladder_to(run.integer("rows"), {0.375, 0.5, 0.75, 1}), r.mesh,
       [&](long n) { return follow_mesh(waves.euler, n); });
  each(cells_of(run), r.particles, [&](long n) { return follow_particles(waves.euler, n); });
  each(ladder_to(run.integer("sph_rows"), {0.5, std::numbers::sqrt2 / 2, 1}), r.sph,
       [&](long n) { return follow_sph(waves.euler, n); });
  one_by_one(run, work);
  return r;
}

/// Of Serre's exact wave from that of the Euler equations after one period, over the height; equal weights for equal
/// water, as markers have.
double equations_apart(const Waves& waves) {
  constexpr int samples = 2000;
  double squares = 0;
  for (int k = 0; k < samples; ++k) {
    const double x = waves.length() * k / samples;
    const double serre = waves.serre.elevation(x - waves.serre_crest());
    squares += (1 + serre) * std::pow(serre - waves.euler.elevation(x), 2);
  }
  return std::sqrt(squares / samples) / waves.height();
}

std::vector<double> reversed(const std::vector<double>& values) {
  return {values.rbegin(), values.rend()};
}

void claim_orders(const Claims<Results>& all, const Values& values) {
  const auto second = [](const Claims<Results>& claims, const std::string& id, const std::string& text,
                         double tolerance, const std::string& why,
                         std::function<evidence::ObservedOrder(const Results&)> measure) {
    claims.check(id, text, "order of the rms error of the surface", std::move(measure),
                 Order{.theory = 2, .tolerance = tolerance, .reason = why});
  };
  const double coarsest = static_cast<double>(cells_of(values).front()) / values.real("length");
  const auto resolved = all.only_if(coarsest >= 1.5, "its coarsest grid has less than 1.5 cells over the depth")
                            .only_if(values.real("height") <= 0.25,
                                     "the third-order error of the splines is visible at the crests of higher waves");
  second(resolved, "particles-order", "The surface error of Gauss-principle particles converges at second order.", 0.3,
         "second-order steps, in proportion to the cells, and sums over the particles next to the surface; splines are "
         "third-order, a part of the error on coarse grids",
         [](const Results& r) { return r.particles.order(); });
  second(all, "mesh-order", "The surface error of the Lagrangian mesh converges at second order.", 0.2,
         "second order in space and time; the next, third-order term comes from the slip of surface nodes",
         [](const Results& r) { return r.mesh.order(); });
  second(all, "dispersive-order",
         "The dispersive model converges at second order to the exact periodic wave of its own equations.", 0.1,
         "second order in space and time, and even in both",
         [](const Results& r) { return evidence::observed_order(r.dispersive.size, r.own_error); });
}

/// Where the dispersive model ends, however fine it is.
void claim_dispersion(const Claims<Results>& claims, const Waves& waves) {
  const auto ends = [&](const std::string& id, const std::string& text, const std::string& quantity,
                        const std::string& unit, std::vector<double> Ladder::*numbers, double expected) {
    claims.from(serre_source)
        .check(
            id, text, fmt::format("{} [{}]", quantity, unit),
            [numbers](const Results& r) -> Measurement {
              const std::vector<double> values = reversed(r.dispersive.*numbers);
              return {.value = values.front(),
                      .uncertainty = fine_limit(reversed(r.dispersive.size), values).uncertainty};
            },
            Uncertainty{.expected = expected,
                        .useful = 0.1 * std::abs(expected),
                        .reason = "both exact waves are known to round-off; the claim requires a spacing error below a "
                                  "tenth of the equation error"});
  };
  ends("dispersive-error",
       "The error of the dispersive model against the Euler equations converges to the error of its equations.",
       "rms error over the height", "1", &Ladder::error, equations_apart(waves));
  ends("dispersive-phase",
       "The phase lag of the dispersive model behind the Euler wave is the celerity deficit of its equations.",
       "lead of the phase in one period", "wavelengths", &Ladder::lead,
       waves.serre.phase_speed() / waves.euler.phase_speed() - 1);
}

void claims(const Values& values, const Claims<Results>& all) {
  const Waves waves = waves_of(values);
  const long cells = values.integer("cells");
  claim_orders(all, values);
  claim_dispersion(all.at(fmt::format("{} nodes, and three times half as many", values.integer("markers"))), waves);
  const double steps = std::ceil(static_cast<double>(cells) / particles_courant);
  const double turn = 2 * std::numbers::pi / steps;
  const double excess = excess_speed(waves.euler);
  const Claims<Ladder> particles = all.at(fmt::format("{} cells", cells)).of(&Results::particles);
  particles.from("Frank (1994), chapter 6; exact for every space and step")
      .check("particles-energy", "The energy of Gauss-principle particles is conserved to round-off.",
             "change over the kinetic energy", &Ladder::energy_change,
             Roundoff{.operations = steps,
                      .scale = 2,
                      .reason = "one rounding per step of the kinetic and of the potential energy"});
  const auto speed = [&](const Claims<Ladder>& claims, const std::string& id, const std::string& text, double expected,
                         double limit, const std::string& why) {
    claims.only_if(excess > 0.005, "the height of this wave adds less than 0.5 % to its celerity")
        .check(
            id, text, "lead of the phase in one period [wavelengths]",
            [](const Ladder& ladder) { return ladder.lead.back(); },
            Bound{.limit = limit * excess, .reason = why, .expected = expected});
  };
  speed(particles, "particles-phase",
        "The phase lag of Gauss-principle particles agrees with the lag of their steps, (omega tau)^2/12, within 2 % "
        "of the nonlinear excess speed.",
        -turn * turn / 12, 0.02,
        "2 % of the nonlinear excess celerity; expected: -(omega tau)^2/12, the lag of the discrete gradient");
  const std::string distinguished =
      "half of the nonlinear excess celerity, which distinguishes this wave from a low one";
  speed(all.at(fmt::format("{} rows", values.integer("rows"))).of(&Results::mesh), "mesh-phase",
        "The speed of the wave on the mesh agrees with a wave of its height within half of the nonlinear excess speed.",
        0, 0.5, distinguished);
  const Claims<Ladder> sph = all.at(fmt::format("{} rows", values.integer("sph_rows"))).of(&Results::sph);
  speed(sph, "sph-phase",
        "The speed of the SPH wave agrees with a wave of its height within half of the nonlinear excess speed.", 0, 0.5,
        distinguished);
  sph.check(
      "sph-falls", "The surface error of SPH at the finest spacing is smaller than at twice that spacing.", "it is",
      [](const Ladder& ladder) { return ladder.error.back() < ladder.error.front(); },
      Qualitative{.detector = "rms error of the surface",
                  .reason = "sums over neighbours converge, and the viscosity is proportional to the spacing: the "
                            "reduction must be visible at a quarter of the particle mass"});
}

struct Shown {
  std::string name, size;
  const Ladder& ladder;
  Role role;
};

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const std::vector<Shown> models{{"Gauss particles", "cell size", r.particles, Role::computed},
                                  {"Lagrangian mesh", "row height", r.mesh, Role::peer},
                                  {"dispersive shallow water", "node spacing", r.dispersive, Role::data},
                                  {"SPH", "particle spacing", r.sph, Role::guide}};
  auto& cost = add_panel(exhibit, "cost", "Error against processor time",
                         "Rms error of the surface after one period, over the height; coarse to fine.",
                         {.x = "processor time [s]", .y = "error", .log_x = true, .log_y = true});
  evidence::Table& table =
      add_table(exhibit, "models", "Error and processor time",
                "After one period; of the mesh, a third of the time for three waves.",
                {"model", "size of", "size [depth]", "rms error [height]", "phase [wavelengths]", "time [s]"});
  for (const Shown& model : models) {
    const Ladder& ladder = model.ladder;
    cost.points(model.name, ladder.seconds, ladder.error, model.role);
    for (std::size_t k = 0; k < ladder.size.size(); ++k) {
      table.rows.push_back(
          {model.name, model.size, ladder.size[k], ladder.error[k], ladder.lead[k], ladder.seconds[k]});
    }
  }
  exhibit.measure("equations_apart", equations_apart(r.waves));
  auto& profile = add_panel(exhibit, "profile", "The wave after one period", "The finest of each, and the exact wave.",
                            {.x = "(x - c t)/L", .y = "elevation"});
  const std::vector<double> at = evenly(-0.5, 0.5, 401);
  profile.line("exact", at, each(at, [&](double x) { return r.waves.euler.elevation(x * r.waves.length()); }),
               Role::exact);
  for (const Shown& model : models) {
    std::vector<double> x, y;
    for (const Point& point : model.ladder.surface) {
      const double place = point.x / r.waves.length() - 1;
      if (std::abs(place) > 0.5) continue;
      x.push_back(place);
      y.push_back(point.y);
    }
    profile.line(model.name, x, y, model.role);
  }
}

void stokes_models(Case& c) {
  c.title = "Model comparison: a steep periodic wave";
  c.source = literature::frank + ", chapters 2, 3 and 6";
  c.parameters = {
      real("height", 0.2, "depth", {0.05, 0.4}, "from trough to crest"),
      real("length", 2 * std::numbers::pi, "depth", {4, 15}, "of the wave"),
      integer("cells", {28, 42, 56}, {28, 140},
              "cells of the Gauss-principle particles per wavelength, finest of four"),
      integer("rows", {16, 32, 48}, {8, 96}, "of the mesh, finest of four"),
      integer("markers", {160, 320, 640}, {80, 2560}, "nodes of the dispersive model per wavelength, finest of four"),
      integer("sph_rows", {16, 32, 48}, {12, 96}, "SPH particles over the depth, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::stokes_models
