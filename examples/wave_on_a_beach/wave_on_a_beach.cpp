// A solitary wave runs up a beach of slope 1:20: the shoreline against time, as CSV.
#include <cstdio>
#include <memory>

#include <seiche/models/dispersive_shallow_water_1d/flow.hpp>

int main() {
  using namespace seiche;
  using namespace seiche::dispersive_shallow_water_1d;

  // Depth 0.5 m from x = -60 m to the toe of the beach at -10 m; still shoreline at 0.
  const Channel channel{
      .bottom = std::make_shared<PiecewiseLinearBottom>(std::vector{-60.0, -10.0, 0.0, 10.0},
                                                        std::vector{-0.5, -0.5, 0.0, 0.5}),
      .left = End::wall,
      .right = End::tip,
      .gravity = 9.81,
      .tip_mass = TipMass::consistent,
  };
  const SolitaryStart wave{.amplitude = 0.01, .crest = -20, .depth = 0.5};
  Flow flow(channel, solitary_markers(channel, -50, 0, 0.125, wave));

  std::puts("t,shoreline_x,shoreline_y,energy");
  for (int k = 0; k <= 60; ++k) {
    march(flow, 0.25 * k, stable_steps(flow, 0.02));
    std::printf("%g,%.6g,%.6g,%.9g\n", flow.time(), flow.x().back(), flow.y().back(), flow.energy());
  }
}
