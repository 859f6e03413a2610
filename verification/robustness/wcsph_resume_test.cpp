// A flow that goes on from a kept state is the flow that was not interrupted, to the last bit.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_resume_test {

using namespace wcsph;

struct Problem {
  std::string name;
  Scene scene;
  Settings settings;

  [[nodiscard]] Flow flow() const { return {scene.particles, scene.spacing, settings, scene.paddles}; }
};

std::vector<Problem> problems() {
  const double a = 0.057;
  const DamBreak column{.width = a, .height = 2 * a, .tank_length = 4 * a, .wall_height = 3.5 * a, .spacing = a / 16};
  const Settings filtered{.sound_speed = 15, .viscosity = LaminarSps{}, .filter_every = 20};
  Settings shifted = filtered;
  shifted.density_diffusion = 0.1;
  shifted.walls = WallPressure::extrapolated;
  shifted.particle_shifting = true;
  const Settings fast{.sound_speed = 10, .viscosity = ArtificialViscosity{0.1}};
  const Scene flume_scene =
      flume({.length = 0.4, .depth = 0.1, .stroke = 0.05, .frequency = 12, .spacing = 0.005}, fast);
  PeriodicLayer wave{.period = 0.5, .depth = 0.1, .spacing = 0.005};
  wave.elevation = [](double x) { return 0.02 * std::cos(4 * std::numbers::pi * x); };
  wave.velocity = [](double, double) { return Velocity{0.5, 0}; };
  wave.pressure = [](double, double z) { return 9810 * (0.1 - z); };
  const Scene layer = periodic_layer(wave, fast);
  Settings periodic = fast;
  periodic.period = layer.period;
  return {{"dam break, stress of eddies and filter", dam_break(column, filtered), filtered},
          {"extrapolated walls, diffusion and shifting", dam_break(column, shifted), shifted},
          {"flume with a flap", flume_scene, fast},
          {"periodic layer", layer, periodic}};
}

bool same(const Flow& a, const Flow& b) {
  const auto bytes = [](const Flow& flow) {
    const Particles& p = flow.particles();
    std::string all;
    for (const auto* array : {&p.x, &p.z, &p.u, &p.w, &p.density}) {
      all.append(reinterpret_cast<const char*>(array->data()), array->size() * sizeof(double));
    }
    return all;
  };
  const auto rest = [](const Flow& flow) {
    const Particles& p = flow.particles();
    const Extremes& e = flow.extremes();
    return std::tuple{p.identity,        p.kind,     p.body,        flow.time(), flow.steps(), e.mach, e.lowest_density,
                      e.highest_density, e.rebuilds, e.interactions};
  };
  return bytes(a) == bytes(b) && rest(a) == rest(b);
}

TEST_CASE("a flow resumed from a saved state gives the same bytes", "[robustness]") {
  constexpr int steps = 300, apart = 37;
  Check check(
      "wcsph_resume", "A run that was interrupted",
      fmt::format(
          "Weakly compressible SPH, {} steps. Every {} steps the state is saved, and at the end new flows are resumed "
          "from each: in the same order, so that sums run in the same order. No bit of any particle differs.",
          steps, apart));
  for (const Problem& problem : problems()) {
    Flow whole = problem.flow();
    std::vector<FlowState> kept;
    for (int n = 0; n < steps; ++n) {
      if (n % apart == 0) kept.push_back(whole.state());
      whole.advance(whole.stable_step());
    }
    // Some were kept between two sortings, and are resumed across another.
    CHECK(whole.extremes().rebuilds > 2);
    CHECK(whole.extremes().rebuilds < steps);
    long different = 0;
    for (const FlowState& state : kept) {
      Flow resumed = problem.flow();
      resumed.resume(state);
      while (resumed.steps() < steps) resumed.advance(resumed.stable_step());
      if (!same(whole, resumed)) ++different;
    }
    check.holds(fmt::format("Resumed flows end in the same bytes ({}).", problem.name),
                {static_cast<double>(different)}, Bound{0, "equality of bytes, of counts and of extremes"});
  }
}

TEST_CASE("a state of another flow is rejected by the name of the difference and leaves the flow unchanged",
          "[robustness]") {
  Check check("wcsph_resume_refusals", "States of other flows",
              "A flume with a flap, 20 steps old, is given foreign states: of another setting, paddle or particle, or "
              "damaged. Each is rejected with the name of the difference, and the flow then continues to the same "
              "bytes as an undisturbed one.");
  const Problem own = problems()[2];
  const auto changed = [&](const std::function<void(Problem&)>& change) {
    Problem other = own;
    change(other);
    return other.flow().state();
  };
  const auto damaged = [&](const std::function<void(FlowState&)>& damage) {
    Flow flow = own.flow();
    for (int n = 0; n < 30; ++n) flow.advance(flow.stable_step());
    FlowState state = flow.state();
    damage(state);
    return state;
  };
  const std::vector<std::pair<std::string, FlowState>> states{
      {"sound_speed = 12", changed([](Problem& p) { p.settings.sound_speed = 12; })},
      {"gravity = 3", changed([](Problem& p) { p.settings.gravity = 3; })},
      {"viscosity", changed([](Problem& p) { p.settings.viscosity = Inviscid{}; })},
      {"alpha = 0.2", changed([](Problem& p) { p.settings.viscosity = ArtificialViscosity{0.2}; })},
      {"spacing", changed([](Problem& p) { p.scene.spacing *= 1.01; })},
      {"paddles", changed([](Problem& p) {
         p.scene.paddles.clear();
         std::fill(p.scene.particles.kind.begin(), p.scene.particles.kind.end(), Kind::fluid);
       })},
      {"hinge, pose or rate of a paddle", changed([](Problem& p) { p.scene.paddles[0] = flap(0, 0, 0.1, 0.06, 12); })},
      {"hinge, pose or rate of a paddle", changed([](Problem& p) { p.scene.paddles[0].hinge_x += 1e-3; })},
      {"particles", changed([](Problem& p) { p.scene.particles.add(5, 5, 1, 1000); })},
      {"particles", changed([](Problem& p) { p.scene.particles.mass[7] *= 2; })},
      {"particle 3", damaged([](FlowState& s) { s.particles.u[3] = std::nan(""); })},
      {"arrays", damaged([](FlowState& s) { s.reference_x.clear(); })},
      {"arrays", damaged([](FlowState& s) { s.reference_z.pop_back(); })},
      {"order", damaged([](FlowState& s) {
         Particles& p = s.particles;
         for (auto* values : {&p.x, &p.z, &p.u, &p.w, &p.density, &p.mass}) std::swap(values->front(), values->back());
         for (auto* values : {&p.body, &p.identity}) std::swap(values->front(), values->back());
         std::swap(p.kind.front(), p.kind.back());
       })}};
  Flow plain = own.flow(), asked = own.flow();
  for (Flow* flow : {&plain, &asked}) {
    for (int n = 0; n < 20; ++n) flow->advance(flow->stable_step());
  }
  int accepted = 0;
  for (const auto& [word, state] : states) {
    INFO(word);
    try {
      asked.resume(state);
      ++accepted;
    } catch (const std::invalid_argument& refusal) {
      CHECK_THAT(refusal.what(), Catch::Contains(word));
    }
  }
  const bool kept = same(plain, asked);
  for (Flow* flow : {&plain, &asked}) {
    for (int n = 0; n < 40; ++n) flow->advance(flow->stable_step());
  }
  check.holds(fmt::format("The number of accepted states of {} other flows is zero.", states.size()),
              {static_cast<double>(accepted)}, Bound{0, "a count"});
  check.holds("The flow after a rejected state is unchanged, immediately and 40 steps later.",
              {(kept ? 0.0 : 1.0) + (same(plain, asked) ? 0 : 1)},
              Bound{0, "equality of bytes, of counts and of extremes"});
}

}  // namespace seiche::verification::wcsph_resume_test
