/*
A breakwater whose front and rear walls are loaded in antiphase bears a smaller total force than a plain wall (Frank
1994, section 2.3). The case `breakwater` shows it for small waves; here the wave is high.

**Set-up.** The basin of `breakwater`: depth 1, a berm under water of depth 0.4 before the rear wall, a far wall at $x =
-14$. A standing wave of $L/h$ about 6, for which the berm is half a wavelength wide, starts from rest with the height
0.1 at the far wall: a quarter of the depth over the berm. Gravity and density are 1. Frank's mesh tangles at the edge
of the berm within two periods, for heights of $0.02$ already. It is therefore rezoned, before the plain wall too: when
a node has moved by more than a fifth of its cell, the columns are set upright again and the motion is remapped (Hirt et
al. 1974).

**What is compared.** First, in every step, the rate of change of the water's horizontal momentum with the forces of
walls and bed. These forces are computed from the cell pressures, including the hydrostatic part, and from the reaction
that turns the flow along the bed, independently of the motion; the scheme must balance them to round-off in every step
before which the mesh was not rezoned. Second, these reactions with the forces read off the edges of front and rear, as
for small waves: the difference measures the resolution of the front face. Third, the energy with the band of the
one-step scheme, and the energy that rezoning takes. Last, the statement itself: the maximum total force of the wave
over the force of the same wave on a plain wall.

For small waves at most a tenth of the force is left. A wave that crosses the berm steepens, and by Airy's shallow-water
theory its second harmonic grows by $\tfrac34 k B \alpha^2/d$ over the distance $B$ in the depth $d$, where $\alpha$,
the height of the wave propagating in one direction, is half of the height $\eta_r$ at the rear wall. The wall doubles
it. For the second harmonic the berm is a whole wavelength wide: it loads front and rear in phase, with fractions $(1 -
d)$ and $d$ of $\tfrac38 k B \eta_r^2/d$, and the moving contact point adds $\tfrac12\eta_r^2$. The total may therefore
reach a tenth of the force on a plain wall and

$$ \tfrac12 \eta_r^2 + \tfrac38 k B \eta_r^2/d . $$

**What to look at.** Front and rear are still loaded in antiphase, but not sinusoidally: crests push harder and for a
shorter time than troughs pull. The component at the wave frequency nearly cancels in the total; about as much of the
remainder has twice the frequency.
*/
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/breakwater/berm_history.hpp"
#include "validation/breakwater/berm_load.hpp"
#include "validation/breakwater/harmonic.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::breakwater_high_wave {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;
using lagrangian_mesh_2d::Slide;

// Balance of the horizontal momentum of water between vertical walls over a curved bottom, step by step of Frank's
// one-step scheme on the Lagrangian mesh.
//
// What the walls and the bottom exert is found from the pressures of the step, not from what the water did. At the
// configuration q~ of the step, cells of dynamic pressure lambda, the free surface (the hydrostatic part, counted from
// the still-water level: the forces of still water cancel) push a node by
//
//     F = sum lambda dV/dr - dPi/dr .
//
// A node on a vertical wall does not move along x: the wall exerts -F_x. A node that slides along the bottom, with
// tangent t and speed s', keeps F.t; the bottom exerts the rest of F, reversed, and what turns the node's way along
// the curve, m [s'_1 (t_1 - t~) - s'_0 (t_0 - t~)]/tau, index 0 before and 1 after the step: the centripetal force.
// The forces of all other nodes cancel, for cells and potentials know no place: the rate of the water's momentum is
// the sum of the reactions, to rounding.
//
// When not to use it: driven walls, other bottoms than curves, compositions and the energy-exact step; hourglass
// potential, corner barriers and forcing, which it does not know; steps before which the mesh was rezoned.

class MomentumBalance {
 public:
  /// @param flow  must outlive this; any time between two steps
  /// @param tau  length of its steps: differences of times are rounded
  MomentumBalance(const lagrangian_mesh_2d::Flow& flow, double tau) : flow_(&flow), tau_(tau) { remember(); }

  /// Of one step: forces on the water along x, without those of still water.
  struct Step {
    double time = 0;       ///< the middle of the step
    double rate = 0;       ///< of the water's momentum
    double left = 0;       ///< force of the left wall
    double right = 0;      ///< of the right wall
    double bottom = 0;     ///< of the bottom
    bool rezoned = false;  ///< before it: the balance is not of this step alone
    [[nodiscard]] double forces() const { return left + right + bottom; }
    /// What is missing in the balance.
    [[nodiscard]] double defect() const { return rate - forces(); }
  };
  /// To be called after every step.
  Step after_step() {
    const auto& model = flow_->model();
    const Mesh& mesh = model.mesh();
    const std::size_t n = mesh.nodes();
    const auto& q = flow_->state().q;
    const auto& u = flow_->state().u;
    std::vector<double> middle(q_.size());
    for (std::size_t i = 0; i < 2 * n; ++i) middle[i] = q_[i] + 0.5 * tau_ * u_[i];
    const auto slides = model.nodes().slides();
    for (std::size_t i = 0; i < slides.size(); ++i) {
      const Slide& slide = slides[i];
      const Point before = slide.curve->tangent(q_[2 * n + i]);
      const double speed = before.x * u_[slide.node] + before.y * u_[n + slide.node];
      middle[2 * n + i] = q_[2 * n + i] + 0.5 * tau_ * speed;
      const Point place = slide.curve->position(middle[2 * n + i]);
      middle[slide.node] = place.x;
      middle[n + slide.node] = place.y;
    }
    const Forces f = forces(middle);
    Step step{.time = time_ + 0.5 * tau_, .rezoned = flow_->rezoning().done > rezoned_};
    for (std::size_t j = 0; j <= mesh.rows; ++j) {
      step.left -= f.x[mesh.node(0, j)];
      step.right -= f.x[mesh.node(mesh.columns, j)];
    }
    for (std::size_t i = 0; i < slides.size(); ++i) {
      const std::size_t k = slides[i].node;
      const Point t0 = slides[i].curve->tangent(q_[2 * n + i]);
      const Point t = slides[i].curve->tangent(middle[2 * n + i]);
      const Point t1 = slides[i].curve->tangent(q[2 * n + i]);
      const double speed0 = t0.x * u_[k] + t0.y * u_[n + k];
      const double speed1 = t1.x * u[k] + t1.y * u[n + k];
      const double along = f.x[k] * t.x + f.y[k] * t.y;
      const double turning = (speed1 * (t1.x - t.x) - speed0 * (t0.x - t.x)) / tau_;
      step.bottom += along * t.x - f.x[k] + model.nodes().mass()[k] * turning;
    }
    for (std::size_t k = 0; k < n; ++k) step.rate += model.nodes().mass()[k] * (u[k] - u_[k]) / tau_;
    remember();
    return step;
  }

 private:
  struct Forces {
    std::vector<double> x, y;
  };
  [[nodiscard]] Forces forces(const std::vector<double>& middle) const {
    const auto& model = flow_->model();
    const Mesh& mesh = model.mesh();
    const std::size_t n = mesh.nodes();
    const double weight = model.settings().density * model.settings().gravity;
    const auto x = [&](std::size_t k) { return middle[k]; };
    const auto y = [&](std::size_t k) { return middle[n + k]; };
    Forces f{.x = std::vector<double>(n, 0.0), .y = std::vector<double>(n, 0.0)};
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
      const auto r = mesh.corners(cell);
      const double lambda = flow_->multipliers()[cell];
      for (std::size_t c = 0; c < 4; ++c) {
        // dV/dr of corner c: half the diagonal between its neighbours, turned.
        const std::size_t next = r[(c + 1) % 4];
        const std::size_t last = r[(c + 3) % 4];
        f.x[r[c]] += 0.5 * lambda * (y(next) - y(last));
        f.y[r[c]] -= 0.5 * lambda * (x(next) - x(last));
      }
    }
    for (std::size_t i = 0; i < mesh.columns; ++i) {
      const std::size_t a = mesh.node(i, mesh.rows);
      const std::size_t b = a + 1;
      const double push = weight * (y(a) * y(a) + y(a) * y(b) + y(b) * y(b)) / 6;
      f.x[a] += push;
      f.x[b] -= push;
      f.y[a] -= weight * (x(b) - x(a)) * (2 * y(a) + y(b)) / 6;
      f.y[b] -= weight * (x(b) - x(a)) * (y(a) + 2 * y(b)) / 6;
    }
    return f;
  }

  void remember() {
    q_ = flow_->state().q;
    u_ = flow_->state().u;
    time_ = flow_->time();
    rezoned_ = flow_->rezoning().done;
  }

  const lagrangian_mesh_2d::Flow* flow_;
  std::vector<double> q_, u_;
  double tau_;
  double time_ = 0;
  long rezoned_ = 0;
};

const std::string source = "Frank (1994), section 2.3";
constexpr double shortest = 3;

/// What the parameters decide.
struct SetUp {
  Berm berm;
  BermResolution mesh;
  double height, tau, wavelength, rezone;
  long periods;

  explicit SetUp(const Values& values)
      : berm(berm_of(values)),
        mesh(berm_mesh_of(values)),
        height(values.real("height")),
        tau(values.real("tau")),
        wavelength(values.real("wavelength")),
        rezone(values.real("rezone")),
        periods(values.integer("periods")) {}
  /// The berm is half a wave wide.
  [[nodiscard]] bool half_wave() const { return berm.usual() && wavelength >= 4.5 && wavelength <= 8; }
  /// Of a run of the wave of a basin.
  [[nodiscard]] BermRunSettings run_of(const BasinWave& small) const {
    return {.height = height, .time = static_cast<double>(periods) * small.period(), .tau = tau, .rezone = rezone};
  }
  [[nodiscard]] std::string name() const { return fmt::format("{}, tau = {:g}", mesh.name(berm), tau); }
};

/// A wave and what is kept in it.
struct WatchedWave {
  BasinWave small;
  BermWave wave;
  std::vector<MomentumBalance::Step> steps = {};
  double first_energy = 0;
  Worst energy = {};   ///< change, less what rezoning took
  Worst fastest = {};  ///< velocity
};

struct Results {
  WatchedWave high;
  BasinWave plain_small;
  BermWave plain;

  /// Largest force on the plain wall over the height.
  [[nodiscard]] double plain_peak() const { return worst(plain.history.rear); }
  /// Height of the wave at the rear wall over that at the far wall, if it is small.
  [[nodiscard]] double rear_height() const {
    const std::vector<double>& eta = high.small.mode.elevation;
    return std::abs(eta.back() / eta.front());
  }
  /// The second harmonic at the rear wall by Airy's shallow water (the article).
  [[nodiscard]] double second_harmonic(const SetUp& s) const {
    const double depth = 1 - s.berm.rise;
    const double k = exact::AiryDispersion(1, depth).wavenumber(high.small.mode.frequency);
    return 0.375 * k * s.berm.width * std::pow(rear_height() * s.height, 2) / depth;
  }
};

/// Rounding of the momentum's rate: every node's velocity is rounded once per operation.
void claim_momentum(const Claims<Results>& claims, const SetUp& s) {
  const auto nodes = static_cast<double>((s.mesh.columns(s.berm) + 1) * (s.mesh.rows + 1));
  claims.from("Frank (1994), formulas 4 to 7")
      .check(
          "momentum",
          "The change of the water's horizontal momentum equals the impulse of the forces of walls and bed, to "
          "round-off, in every step before which the mesh is not rezoned.",
          "largest error of a step's momentum balance [rho g depth^2]",
          [s, nodes](const Results& r) -> Measurement {
            Worst defect;
            for (const auto& step : r.high.steps) {
              if (!step.rezoned) defect.add(step.defect(), step.time);
            }
            const double water = r.high.wave.flow.model().mass();
            return {.value = defect.value(),
                    .where = fmt::format("t = {:.3g}", defect.where()),
                    .told = {.scale = r.high.fastest.value() * water / nodes / s.tau}};
          },
          Roundoff{.operations = 20 * nodes,
                   .scale = Amount::told_by_run(10 * s.berm.length / nodes / s.tau),
                   .reason = "some twenty rounded operations per node and step, of the momentum at the maximum node "
                             "velocity, over the step"});
  const double cell = std::max(1 / s.mesh.columns_per_depth, 1 / static_cast<double>(s.mesh.rows));
  claims.check(
      "pressures",
      "The forces of the pressures on front and rear agree with the momentum balance to second order in half a cell "
      "over the front's length.",
      "largest difference over the largest force on the front",
      [s](const Results& r) -> Measurement {
        const BermHistory& history = r.high.wave.history;
        const auto& steps = r.high.steps;
        Worst off;
        // An entry of the history lies between two steps; there is none at a rezoning.
        for (std::size_t n = 0; n < history.time.size(); ++n) {
          const auto after = std::ranges::upper_bound(steps, history.time[n], {}, &MomentumBalance::Step::time);
          const auto before = after - 1;
          if (before->rezoned) continue;
          off.add(history.front[n] + 0.5 * (before->bottom + after->bottom) / s.height, history.time[n]);
          off.add(history.rear[n] + 0.5 * (before->right + after->right) / s.height, history.time[n]);
        }
        return {.value = off.value() / worst(history.front), .where = fmt::format("t = {:.3g}", off.where())};
      },
      Bound{.limit = 0.5 * std::pow(0.5 * cell / s.berm.steepness, 2),
            .reason = "a cell's pressure stands for that on its edge, half a cell away: the second order of half a "
                      "cell over the length of the front face"});
}

void claim_energy(const Claims<Results>& claims, const SetUp& s) {
  const double k = 2 * std::numbers::pi / shortest;
  const double fastest = std::sqrt(k * std::tanh(k));
  claims.from("Frank (1994), chapter 1")
      .check(
          "energy",
          "The energy of the wave, with what rezoning took, changes by at most (omega tau)^2, four times the swing of "
          "the "
          "one-step scheme.",
          "largest change over the energy initial",
          [s](const Results& r) -> Measurement {
            return {.value = r.high.energy.value() / r.high.first_energy,
                    .where = fmt::format("t = {:.3g}", r.high.energy.where()),
                    .told = {.limit = std::pow(r.high.small.mode.frequency * s.tau, 2)}};
          },
          Bound{.limit = Amount::told_by_run(std::pow(fastest * s.tau, 2)),
                .reason =
                    "the one-step scheme conserves T + Pi - (tau^2/8) u.Ku in linear waves, so that T + Pi oscillates "
                    "by (omega tau)^2/4 of the energy; four times that, as if all energy were in the second harmonic"});
  claims.check(
      "rezoning", "Rezoning takes at most 5 % of the wave's energy.",
      "energy taken by rezoning over the energy initial",
      [](const Results& r) { return r.high.wave.flow.rezoning().lost / r.high.first_energy; },
      Bound{.limit = 0.05, .reason = "2.5 % of the height of the wave, what a wave gauge resolves"});
}

void claim_statement(const Claims<Results>& claims, const SetUp& s) {
  const auto half = claims.only_if(s.half_wave(), "for a berm half a wavelength wide, the default");
  half.check(
      "antiphase",
      "The phase between the forces of the high wave on front and rear differs from pi by at most their ratio of "
      "second to first order.",
      "phase between front and rear [rad]",
      [s](const Results& r) -> Measurement {
        const BermHistory& h = r.high.wave.history;
        const double frequency = r.high.small.mode.frequency;
        const auto front = harmonic(h.time, h.front, frequency, s.periods);
        const auto rear = harmonic(h.time, h.rear, frequency, s.periods);
        const double second = s.berm.rise * r.second_harmonic(s);
        const double first = std::abs(r.high.small.load.force.front) * s.height;
        return {.value = std::abs(std::arg(front / rear)), .told = {.limit = second / first}};
      },
      Bound{.limit = Amount::told_by_run(0.5),
            .reason = "second-order over first-order force on the front, as if all of it had the wave frequency: free "
                      "waves are not harmonics",
            .expected = std::numbers::pi});
  half.check(
      "less-than-plain-wall",
      "The total force on the breakwater over that on a plain wall is at most 0.1 plus the second-order terms.",
      "largest total force over that on a plain wall",
      [s](const Results& r) -> Measurement {
        const double contact = 0.5 * std::pow(r.rear_height() * s.height, 2);
        const double second = (contact + r.second_harmonic(s)) / (r.plain_small.load.plain_wall * s.height);
        return {.value = worst(r.high.wave.history.total) / r.plain_peak(), .told = {.limit = 0.1 + second}};
      },
      Bound{.limit = Amount::told_by_run(1),
            .reason = "0.1 for small waves, and the second order: the contribution of the contact point and a second "
                      "harmonic, grown on the berm, that loads front and rear in phase; at 1 the breakwater would bear "
                      "as much as a plain "
                      "wall"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s(values);
  const auto here = claims.at(s.name());
  claim_momentum(here, s);
  claim_energy(here, s);
  claim_statement(here, s);
}

WatchedWave run_high(const SetUp& s, const Run& run) {
  BasinWave small = basin_wave(s.berm, s.mesh, s.wavelength);
  const BermRunSettings settings = s.run_of(small);
  const double end = settings.time;
  std::optional<MomentumBalance> balance;
  std::vector<MomentumBalance::Step> steps;
  double first_energy = 0;
  Worst energy, fastest;
  BermWave wave = run_berm_wave(s.berm, s.mesh, small.mode, settings, [&](const Flow& flow) {
    if (!balance) {
      balance.emplace(flow, end / std::ceil(end / s.tau - 1e-9));
      first_energy = flow.energy();
      return;
    }
    steps.push_back(balance->after_step());
    energy.add(flow.energy() + flow.rezoning().lost - first_energy, flow.time());
    for (const double u : flow.state().u) fastest.add(u);
    run.progress(0.9 * flow.time() / end);
  });
  return {std::move(small), std::move(wave), std::move(steps), first_energy, energy, fastest};
}

Results compute(const Run& run) {
  const SetUp s(run);
  WatchedWave high = run_high(s, run);
  // Two antinodes, a wave's length apart.
  const Berm plain{.rise = 0, .width = s.berm.width, .length = high.small.load.wavelength};
  BasinWave plain_small = basin_wave(plain, s.mesh, plain.length);
  BermWave plain_wave = run_berm_wave(plain, s.mesh, plain_small.mode, s.run_of(plain_small));
  return {std::move(high), std::move(plain_small), std::move(plain_wave)};
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp s(values);
  const BermHistory& history = r.high.wave.history;
  exhibit.measure("wavelength", r.high.small.load.wavelength);
  exhibit.measure("period", r.high.small.period());
  exhibit.measure("rear_height_over_far_height", r.rear_height());
  exhibit.measure("front_peak", worst(history.front));
  exhibit.measure("rear_peak", worst(history.rear));
  exhibit.measure("plain_wall_peak", r.plain_peak());
  exhibit.measure("plain_wall_of_small_waves", r.plain_small.load.plain_wall);
  exhibit.measure("rezoned", static_cast<double>(r.high.wave.flow.rezoning().done));
  exhibit.measure("worst_corner", r.high.wave.flow.worst_corner().shape);
  auto& panel = add_panel(
      exhibit, "history", "Forces of the high wave",
      fmt::format(
          "A standing wave of L/h = {:.3g} and height {:g} at the far wall; dashed: the same wave before a plain wall.",
          r.high.small.load.wavelength, s.height),
      {.x = "t [sqrt(depth/g)]", .y = "force/height [rho g depth]"}, {"frank-breakwater"});
  draw_forces(panel, history);
  panel.line("plain wall", r.plain.history.time, r.plain.history.rear, Role::guide);
  auto& balance = add_panel(exhibit, "momentum", "Balance of the horizontal momentum",
                            "Rate of the water's momentum, and the sum of the forces of far wall, rear wall and bottom "
                            "on the water, step by step, without the steps before which the mesh was rezoned.",
                            {.x = "t [sqrt(depth/g)]", .y = "force [rho g depth^2]"}, {"frank-breakwater"});
  std::vector<MomentumBalance::Step> steps = r.high.steps;
  std::erase_if(steps, [](const auto& step) { return step.rezoned; });
  const std::vector<double> time = each(steps, &MomentumBalance::Step::time);
  balance.line("forces", time, each(steps, &MomentumBalance::Step::forces), Role::exact);
  balance.line("rate of momentum", time, each(steps, &MomentumBalance::Step::rate), Role::computed);
  const MeshWindow window{-s.berm.width - 2.5, 0.1};
  draw_mesh(
      add_panel(exhibit, "mesh", "The mesh over the berm", "At the end of the high wave's run.", mesh_axes("", window)),
      "mesh", r.high.wave.flow, window);
}

void breakwater_high_wave(Case& c) {
  c.title = "A breakwater loaded in antiphase: a high wave";
  c.source = literature::frank + ", section 2.3";
  c.parameters = {
      real("berm_depth", 0.4, "depth", {0.2, 0.9}, "of still water over the berm"),
      real("berm_width", 2.0, "depth", {0.5, 6}, "from the middle of the front face to the rear wall"),
      real("columns_per_depth", 8.0, "1", {4, 32}, "columns of cells per depth"),
      integer("rows", 6, {2, 24}, "rows of cells"),
      real("wavelength", 6.0, "depth", {3.5, 30}, "of the wave: the nearest mode of the basin"),
      real("height", 0.1, "depth", {1e-6, 0.2}, "of the wave at the far wall"),
      integer("periods", 3, {2, 20}, "length of the run in periods"),
      real("tau", 0.02, "sqrt(depth/g)", {1e-3, 0.2}, "time step"),
      real("rezone", 0.2, "cell", {0.05, 1}, "drift of a node at which the mesh is rezoned"),
  };
  c.published = {{.tiles = {"frank-breakwater"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::breakwater_high_wave
