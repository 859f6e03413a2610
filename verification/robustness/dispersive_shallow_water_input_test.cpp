// What the dispersive shallow-water model refuses, and how it says so.
#include <memory>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::dispersive_shallow_water_input_test {

using namespace dispersive_shallow_water_1d;

Channel level_channel() {
  return {.bottom = std::make_shared<LevelBottom>(1.0)};
}

Channel channel_over(std::vector<double> x, std::vector<double> elevation, End right = End::wall) {
  return {.bottom = std::make_shared<PiecewiseLinearBottom>(std::move(x), std::move(elevation)), .right = right};
}

void flow_over(const Channel& channel, const std::vector<double>& labels) {
  Flow flow(channel, still_markers(channel, labels));
}

Markers still_water() {
  return still_markers(level_channel(), {0, 1, 2, 3, 4, 5});
}

TEST_CASE("bad constants of a channel are rejected with name, value and range", "[robustness]") {
  Check check("dispersive_bad_channel", "Bad channels of the dispersive model",
              "Each constant of a channel out of its range, one at a time.");
  Refusals refusals(check);
  const auto refused = refusals.of(level_channel(), [&](Channel channel) { Flow flow(channel, still_water()); });
  refused({"bottom"}, [](Channel& c) { c.bottom = nullptr; });
  refusals.outside_ranges("Channel",
                          "period non-negative and finite; gravity positive and finite; density positive and finite; "
                          "alpha positive and finite; slope_energy finite; gamma non-negative and finite; depth_power "
                          "finite; reference_depth positive and finite",
                          level_channel(), [&](const Channel& channel) { Flow(channel, still_water()); });
  refusals.outside_ranges(
      "Breaking", "onset_slope positive and finite; ceasing_froude at least 1 and finite; share positive and finite",
      Breaking{}, [&](const Breaking& breaking) {
        Channel channel = level_channel();
        channel.breaking = breaking;
        Flow(channel, still_water());
      });
  refused({"friction coefficient", "= -0.01", "non-negative"}, [](Channel& c) { c.friction.coefficient = -0.01; });
  refused({"x[5]", "= 5", "period"}, [](Channel& c) { c.period = 4; });
  refused({"green_naghdi", "alpha", "1/4"}, [](Channel& c) {
    c.kinetics = Kinetics::green_naghdi;
    c.alpha = 0.2;
  });
  for (Channel channel :
       {Channel{.bottom = std::make_shared<CosineBottom>(1, 0.1, 1)}, channel_over({0, 4.5}, {-1, -1})}) {
    channel.period = 5;
    refusals.refused({"period", "bottom"}, [&] { flow_over(channel, {0, 1, 2, 3, 4}); });
  }
}

TEST_CASE("bad bottoms are rejected with name, value and range", "[robustness]") {
  Check check("dispersive_bad_bottom", "Bad bottoms of the dispersive model",
              "Tables that do not define a function, constants out of range, and slopes too steep for nodes.");
  Refusals refusals(check);
  refusals.refused({"bottom x[2]", "= 1", "above x[1] = 1"}, [] { PiecewiseLinearBottom({0, 1, 1}, {-1, -1, -1}); });
  refusals.refused({"3 places", "2 elevations"}, [] { PiecewiseLinearBottom({0, 1, 2}, {-1, -1}); });
  refusals.refused({"1 places", "at least 2"}, [] { PiecewiseLinearBottom({0}, {-1}); });
  refusals.refused({"bottom elevation[1]", "nan", "finite"}, [] { PiecewiseLinearBottom({0, 1}, {-1, not_a_number}); });
  refusals.refused({"depth", "= -1", "positive"}, [] { LevelBottom bottom(-1); });
  refusals.refused({"wavenumber", "= 0", "positive"}, [] { CosineBottom(1, 0.1, 0); });
  refusals.refused({"slope"}, [] { SmoothBottom([](double) { return -1.0; }, {}, 0, 1); });
  refusals.refused({"begin", "1", "end"},
                   [] { SmoothBottom([](double) { return -1.0; }, [](double) { return 0.0; }, 1, 0); });
  const auto with_slope = [](double slope) {
    flow_over({.bottom = std::make_shared<SmoothBottom>([](double) { return -1.0; },
                                                        [slope](double x) { return x < 0.5 ? slope : 0.0; }, -1, 9)},
              {0, 1, 2, 3, 4, 5});
  };
  refusals.refused({"slope", "inf", "finite"}, [&] { with_slope(infinity); });
  refusals.refused({"slope", "nan", "finite"}, [&] { with_slope(not_a_number); });
  refusals.refused({"bottom"}, [] { still_markers(Channel{}, {0, 1, 2}); });
}

TEST_CASE("bad nodes are rejected with name, value and range", "[robustness]") {
  Check check(
      "dispersive_bad_markers", "Bad nodes of the dispersive model",
      "Nodes that are too few, out of order, not finite, below or beyond the bottom; and water of zero volume.");
  Refusals refusals(check);
  const auto refused = refusals.of(still_water(), [&](Markers markers) { Flow flow(level_channel(), markers); });
  refused({"2 markers", "at least 3"}, [](Markers& m) {
    for (auto* array : {&m.x, &m.y, &m.u, &m.v}) array->resize(2);
  });
  refused({"5 u", "6 x"}, [](Markers& m) { m.u.pop_back(); });
  refused({"x[3]", "1.5", "above x[2] = 2"}, [](Markers& m) { m.x[3] = 1.5; });
  refused({"x[3]", "= 2", "above x[2] = 2"}, [](Markers& m) { m.x[3] = 2; });
  refused({"x[2]", "nan", "finite"}, [](Markers& m) { m.x[2] = not_a_number; });
  refused({"y[0]", "inf", "finite"}, [](Markers& m) { m.y[0] = infinity; });
  refused({"u[4]", "nan", "finite"}, [](Markers& m) { m.u[4] = not_a_number; });
  refused({"v[1]", "nan", "finite"}, [](Markers& m) { m.v[1] = not_a_number; });
  refused({"y[2]", "-1.5", "above the bottom, -1"}, [](Markers& m) { m.y[2] = -1.5; });
  refused({"y[2]", "-1", "above the bottom"}, [](Markers& m) { m.y[2] = -1; });
  refusals.refused({"x[3]", "= 3", "[0, 2.5]"}, [] { still_markers(channel_over({0, 2.5}, {-1, -1}), {0, 1, 2, 3}); });
  refusals.refused({"y[2]", "= 0", "-0.5"}, [] { still_markers(channel_over({0, 4}, {-1, 0}, End::tip), {0, 1, 2}); });
  refusals.refused({"y[1]", "= 0", "above the bottom"}, [] {
    Channel channel = channel_over({0, 4}, {0, 0}, End::tip);
    channel.left = End::tip;
    flow_over(channel, {0, 1, 2});
  });
  refusals.refused({"volume of cell 1", "> 0"}, [] {
    flow_over(channel_over({0, 1.1, 1.5, 1.9, 4}, {-1, -1, 3, -1, -1}), {0, 1, 2, 3, 4});
  });
  refusals.refused({"mass", "marker 2", "> 0"}, [] {
    flow_over(channel_over({0, 1.55, 1.75, 1.95, 2.05, 2.25, 2.45, 4}, {-1, -1, 4, -1, -1, 4, -1, -1}),
              {0, 0.5, 2, 3.5, 4});
  });
}

TEST_CASE("bad starts, schemes and steps are rejected with name, value and range", "[robustness]") {
  Check check("dispersive_bad_start", "Bad starts and steps of the dispersive model",
              "Invalid waves and labels, unknown names of schemes, and lengths of steps. A rejected step leaves the "
              "state unchanged.");
  Refusals refusals(check);
  const Channel channel = level_channel();
  refusals.refused({"cells", "= 1", "at least 2"}, [&] { equal_labels(channel, 0, 1, 1); });
  refusals.refused({"spacing", "= 0", "positive"}, [&] { solitary_markers(channel, 0, 60, 0, {}); });
  refusals.refused({"end", "= -1", "begin"}, [&] { solitary_markers(channel, 0, -1, 0.25, {}); });
  refusals.refused({"crest", "70", "[0, 60]"}, [&] { solitary_markers(channel, 0, 60, 0.25, {.crest = 70}); });
  refusals.refused({"amplitude", "-0.1"},
                   [&] { solitary_markers(channel, 0, 60, 0.25, {.amplitude = -0.1, .crest = 30}); });
  refusals.refused({"two tips", "one tip at most"}, [] {
    Channel bowl = channel_over({-22, 0, 42}, {0.1, -1, 1.1}, End::tip);
    bowl.left = End::tip;
    solitary_markers(bowl, -20, 20, 0.25, {.amplitude = 0.1, .crest = 0});
  });
  // The rounding of a tip's place on a slope grows with the depth.
  constexpr double deep = 1e5;
  for (int k = 0; k < 50; ++k) {
    const double foot = -deep * (3 + 0.1 * k);
    const Channel beach = channel_over({2 * foot, foot, -foot}, {-deep, -deep, deep}, End::tip);
    CHECK_NOTHROW(still_markers(beach, {1.5 * foot, 0.5 * foot, 0}));
  }
  refusals.refused({"leapfrog", "one_step", "conservative"}, [] { stepping_named("leapfrog"); });
  refusals.refused({"yoshida", "triple_jump", "suzuki"}, [] { composition_named("yoshida"); });
  refusals.refused({"fixed_sweeps", "= -1", "non-negative"}, [] {
    Flow flow(level_channel(), still_water(), {.stepping = Stepping::conservative, .fixed_sweeps = -1});
  });
  Flow flow(channel, still_water());
  for (const double bad : {0.0, -0.1, not_a_number, infinity}) {
    refusals.refused({"tau", "positive and finite"}, [&] { stable_steps(flow, bad); });
    refusals.refused({"courant", "positive and finite"}, [&] { stable_steps(flow, 0.1, bad); });
  }
}

}  // namespace seiche::verification::dispersive_shallow_water_input_test
