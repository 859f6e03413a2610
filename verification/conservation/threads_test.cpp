// Any number of threads gives the same bits: every model at a size that is worth threads, one check.
#include <omp.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "verification/check.hpp"
#include "verification/conservation/long_rows.hpp"
#include "verification/message_of.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::threads_test {

using mechanics::Stepping;

using Numbers = std::vector<double>;

template <class... Arrays>
Numbers joined(const Arrays&... arrays) {
  Numbers all;
  (all.insert(all.end(), arrays.begin(), arrays.end()), ...);
  return all;
}

Numbers numbers(const mechanics::State& state) {
  return joined(state.q, state.u, state.multipliers);
}

/// Threads inherit how their maker treats denormal numbers: these are made here, as by a program that computes with
/// them.
void make_threads(int count) {
  omp_set_num_threads(count);
  int made = 0;
#pragma omp parallel reduction(+ : made)
  ++made;
  REQUIRE(made == count);
}

/// What a run ends with is the same with one thread and with others. @param run  run(count): numbers at the end
template <class Run>
void same_for_threads(Check& check, const std::string& what, const Run& run, const std::vector<int>& others = {2, 3}) {
  const int usual = omp_get_max_threads();
  make_threads(1);
  const Numbers one = run(1);
  bool same = !one.empty();
  for (const int count : others) {
    make_threads(count);
    const Numbers other = run(count);
    same =
        same && one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0;
  }
  omp_set_num_threads(usual);
  check.holds(what, {same ? 1.0 : 0.0},
              Qualitative{"equal bytes of all positions, rates, multipliers and books at the end",
                          "sums are taken in one order: results must not depend on the machine's load"});
}

/// The first step with one thread, the others with as many as there are.
template <class Flow>
Numbers stepped(Flow flow, int threads, int steps, double tau) {
  omp_set_num_threads(1);
  flow.advance(tau);
  omp_set_num_threads(threads);
  for (int n = 1; n < steps; ++n) flow.advance(tau);
  return numbers(flow.state());
}

std::string name_of(Stepping stepping) {
  return stepping == Stepping::one_step ? "one-step" : stepping == Stepping::conservative ? "conservative" : "feedback";
}

double hump(double x, double y, double at, double across, double steepness) {
  return std::exp(-steepness * ((x - at) * (x - at) + (y - across) * (y - across)));
}

void plan(Check& check, Stepping stepping) {
  using namespace dispersive_shallow_water_2d;
  constexpr std::size_t rows = 241, columns = linear::worth_threads / rows + 20;
  Rectangle water{.end = 0.5 * columns, .north = 0.5 * rows, .columns = columns, .rows = rows};
  water.elevation = [](double x, double y) { return 0.3 * hump(x, y, 9, 80, 0.02); };
  const auto run = [&](int count) {
    Flow flow(rectangular_lattice(water), {}, {.stepping = stepping}, {.tolerance = 1e-7});
    return stepped(std::move(flow), count, stepping == Stepping::one_step ? 10 : 2, 0.2);
  };
  same_for_threads(check, "Dispersive 2DH, " + name_of(stepping), run, {2});
}

void hexahedra(Check& check, Stepping stepping) {
  using namespace lagrangian_mesh_3d;
  constexpr std::size_t rows = 60, columns = linear::worth_threads / (2 * rows) + 20;
  Layer layer{.end = 0.5 * columns, .north = 0.5 * rows, .columns = columns, .rows = rows, .layers = 2};
  layer.elevation = [](double x, double y) { return 0.2 * hump(x, y, 5, 12, 0.05); };
  layer.bottom = polynomial_bottom({{-1, 0, 0}, {1e-4, 1, 0}});
  same_for_threads(check, "Hexahedra, " + name_of(stepping), [&](int count) {
    return stepped(Flow(layer_mesh(layer), {}, {.stepping = stepping}, {.tolerance = 1e-7}), count, 3, 0.2);
  });
}

void quadrilaterals(Check& check, Stepping stepping) {
  using namespace lagrangian_mesh_2d;
  constexpr std::size_t rows = 60, columns = linear::worth_threads / rows + 200;
  const double length = static_cast<double>(columns) / rows;
  // On so fine a mesh a direct solver rounds more than sweeps wait for.
  const int sweeps = stepping == Stepping::conservative ? 4 : 0;
  const auto wave = [length](double x) { return 0.25 * std::cos(std::acos(-1.0) * x / length); };
  const Layer layer{.end = length, .columns = columns, .rows = rows, .elevation = wave};
  for (const auto& [name, method] :
       {std::pair{"banded", linear::SolverMethod::banded}, {"iterative", linear::SolverMethod::iterative}}) {
    const auto run = [&, solver = method](int) {
      Flow flow(layer_mesh(layer), {}, {.stepping = stepping, .fixed_sweeps = sweeps},
                {.solver = solver, .tolerance = 1e-10});
      for (int n = 0; n < 3; ++n) flow.advance(0.5 * flow.stable_step());
      return numbers(flow.state());
    };
    same_for_threads(check, fmt::format("Lagrangian mesh, {}, {} solver", name_of(stepping), name), run, {2});
  }
}

void drop(Check& check) {
  using namespace gauss_particles;
  same_for_threads(check, "Gauss-principle particles", [](int) {
    const auto vortical = [](Point r) {
      const double along = 2 * r.x, up = 1.5 * r.y;
      return Point{-0.45 * std::sin(along) * std::sin(up) + 0.3, -0.6 * std::cos(along) * std::cos(up)};
    };
    Flow flow(disc(1, 220), std::make_unique<SplineSpace>(LatticePlan{.cell_x = 0.04}), vortical,
              {.gravity = 1, .penalty = 0.01});
    for (int k = 0; k < 3; ++k) flow.advance(2e-3);
    return numbers(flow.state());
  });
}

void particles_of_sph(Check& check) {
  using namespace wcsph;
  const Settings plain{.sound_speed = 15, .viscosity = ArtificialViscosity{0.3}, .filter_every = 20};
  Settings stressed = plain, options = plain;
  stressed.viscosity = LaminarSps{};
  options.density_diffusion = 0.1;
  options.walls = WallPressure::extrapolated;
  options.particle_shifting = true;
  constexpr double a = 0.057;
  for (const auto& [name, settings] : {std::pair{std::string("artificial viscosity, filter"), plain},
                                       {"sub-particle-scale stress", stressed},
                                       {"options", options}}) {
    const Scene scene = dam_break(
        {.width = a, .height = 2 * a, .tank_length = 4 * a, .wall_height = 3.5 * a, .spacing = a / 16}, settings);
    same_for_threads(check, "WCSPH, " + name, [&scene = scene, &settings = settings](int) {
      Flow flow(scene.particles, scene.spacing, settings);
      for (int step = 0; step < 60; ++step) flow.advance(flow.stable_step());
      const Particles& p = flow.particles();
      return joined(p.x, p.z, p.u, p.w, p.density, p.identity);
    });
  }
}

void volumes(Check& check) {
  using namespace shallow_water_finite_volume;
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    same_for_threads(check, "Finite volumes, " + std::string(name(scheme)), [&](int) {
      FiniteVolumeFlow flow = long_channel(scheme, 0, 140000);
      for (int k = 0; k < 5; ++k) flow.advance(0.05);
      const auto books = flow.ledger();
      return joined(flow.depth(), flow.discharge(),
                    Numbers{books.mass_left, books.mass_right, books.impulse_left, books.impulse_right,
                            books.impulse_bed, books.impulse_friction, flow.largest_courant()});
    });
  }
}

/// Ripples as long as a few particles, and a dam that breaks between a piston and dry ground.
void row_of_particles(Check& check) {
  using namespace shallow_water_particles;
  constexpr std::size_t many = 140000;
  const Ends piston{.left = Piston{[](double time) { return 0.2 * time; }}, .right = Vacuum{}};
  for (const auto& [level, name] :
       {std::pair{Level::godunov, "G1"}, std::pair{Level::muscl, "M2"}, std::pair{Level::hand_over, "H2"}}) {
    for (const bool dam : {false, true}) {
      const Scheme scheme{.level = level};
      same_for_threads(check, fmt::format("Shallow-water particles, {}, {}", name, dam ? "dam" : "ripples"), [&](int) {
        ParticleFlow flow(dam ? dam_break(0, 0.4, 1, {1, 0}, {0.5, 0}, many) : ripples(0, many), dam ? piston : Ends{},
                          {}, scheme);
        const double tau = 0.2 * flow.largest_step().tau;
        for (int k = 0; k < 6; ++k) flow.advance(tau);
        const StepLimit limit = flow.largest_step();
        return joined(flow.particles().edge, flow.particles().velocity,
                      Numbers{limit.tau, static_cast<double>(limit.particle), flow.largest_courant(),
                              flow.ledger().left_impulse.value(), flow.ledger().right_impulse.value(),
                              static_cast<double>(flow.structures().size())});
      });
    }
  }
}

namespace channel {
using namespace dispersive_shallow_water_1d;

constexpr std::size_t cells = 140000;

/// A solitary wave in the middle of a channel between walls, or before a beach at its end. Two threads begin at the two
/// ends and meet in the middle.
std::pair<Channel, Markers> with_wave(bool beach) {
  constexpr double spacing = 0.25, begin = -spacing * cells;
  Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  if (beach) {
    channel = {.bottom = std::make_shared<PiecewiseLinearBottom>(Numbers{begin - 100, -20, 20}, Numbers{-1, -1, 1}),
               .left = End::wall,
               .right = End::tip};
  }
  return {channel, solitary_markers(channel, begin, 0, spacing, {.amplitude = 0.1, .crest = beach ? -15 : begin / 2})};
}

/// A step that fails leaves its message, letter by letter, beside the state of before.
void same(Check& check, const std::string& what, const Channel& channel, const Markers& markers, Stepping stepping,
          bool fails = false) {
  same_for_threads(check, "Dispersive 1D, " + what,
                   [&](int) {
                     Flow flow(channel, markers, {.stepping = stepping});
                     const std::string failure = message_of<Divergence>([&] {
                       for (int k = 0; k < 4; ++k) flow.advance(0.05);
                     });
                     CHECK(failure.empty() != fails);
                     return joined(numbers(flow.state()), failure);
                   },
                   {2});
}

void all(Check& check) {
  for (const bool beach : {false, true}) {
    const auto [channel, markers] = with_wave(beach);
    for (const Stepping stepping : {Stepping::one_step, Stepping::one_step_feedback, Stepping::conservative}) {
      same(check, (beach ? "beach, " : "walls, ") + name_of(stepping), channel, markers, stepping);
    }
  }
  auto [level, still] = with_wave(false);
  for (Numbers* values : {&still.y, &still.u, &still.v}) values->assign(still.size(), 0.0);
  still.v[cells / 8] = 1e-3;
  same(check, "solutions that decay into denormal numbers", level, still, Stepping::one_step);
  auto [channel, markers] = with_wave(true);
  markers.u.back() = 1e9;
  same(check, "a tip that leaves the bottom", channel, markers, Stepping::one_step, true);
}
}  // namespace channel

const std::string article =
    "Every model that has threads, at a size that is worth them: some steps with one thread, and with two or three.";

TEST_CASE("meshes are bitwise identical with any number of threads", "[conservation]") {
  Check check("threads_meshes", "Any number of threads: meshes", article);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) plan(check, stepping);
  hexahedra(check, Stepping::one_step);
  quadrilaterals(check, Stepping::one_step);
}

TEST_CASE("conservative meshes are bitwise identical with any number of threads", "[conservation][full]") {
  Check check("threads_meshes", "Any number of threads: conservative meshes", article);
  hexahedra(check, Stepping::conservative);
  quadrilaterals(check, Stepping::conservative);
}

TEST_CASE("particles are bitwise identical with any number of threads", "[conservation]") {
  Check check("threads_particles", "Any number of threads: particles", article);
  drop(check);
  particles_of_sph(check);
}

TEST_CASE("shallow-water flows are bitwise identical with any number of threads", "[conservation]") {
  Check check("threads_shallow_water", "Any number of threads: shallow water", article);
  volumes(check);
  row_of_particles(check);
  channel::all(check);
}

}  // namespace seiche::verification::threads_test
