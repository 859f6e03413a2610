// What the dispersive shallow-water model refuses, and how it says so.
#include <cmath>
#include <limits>
#include <memory>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "verification/robustness/refusals.hpp"

namespace dispersive_shallow_water_input_test {

using namespace seiche;
using namespace seiche::dispersive_shallow_water_1d;
using namespace seiche::verification;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Channel level_channel() {
  return {.bottom = std::make_shared<LevelBottom>(1.0)};
}

Channel channel_over(std::vector<double> x, std::vector<double> elevation, End right = End::wall) {
  return {.bottom = std::make_shared<PiecewiseLinearBottom>(std::move(x), std::move(elevation)), .right = right};
}

Markers still_water() {
  return still_markers(level_channel(), {0, 1, 2, 3, 4, 5});
}

TEST_CASE("bad constants of a channel are refused with name, value and range", "[robustness]") {
  Check check("dispersive_bad_channel", "Bad channels of the dispersive model",
              "Each constant of a channel out of its range, one at a time.");
  Refusals refusals(check);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      Channel channel = level_channel();
      change(channel);
      Flow flow(channel, still_water());
    });
  };
  refused("No bottom.", {"bottom"}, [](Channel& c) { c.bottom = nullptr; });
  refused("Gravity that is not positive.", {"gravity", "= 0", "positive"}, [](Channel& c) { c.gravity = 0; });
  refused("Density that is not positive.", {"density", "= -1", "positive"}, [](Channel& c) { c.density = -1; });
  refused("No vertical inertia.", {"alpha", "= 0", "positive"}, [](Channel& c) { c.alpha = 0; });
  refused("A vertical inertia that is not a number.", {"alpha", "nan", "finite"},
          [](Channel& c) { c.alpha = not_a_number; });
  refused("An infinite slope energy.", {"slope_energy", "inf", "finite"},
          [](Channel& c) { c.slope_energy = infinity; });
  refused("Negative improved dispersion.", {"gamma", "-0.1", "non-negative"}, [](Channel& c) { c.gamma = -0.1; });
  refused("A power of depth that is not a number.", {"depth_power", "nan", "finite"},
          [](Channel& c) { c.depth_power = not_a_number; });
  refused("A reference depth of zero.", {"reference_depth", "= 0", "positive"},
          [](Channel& c) { c.reference_depth = 0; });
  refused("Friction that drives.", {"friction coefficient", "= -0.01", "non-negative"},
          [](Channel& c) { c.friction.coefficient = -0.01; });
  refused("Fronts that break when level.", {"onset_slope", "= 0", "positive"},
          [](Channel& c) { c.breaking = Breaking{.onset_slope = 0}; });
  refused("A bore slower than any.", {"ceasing_froude", "= 0.9", "[1"},
          [](Channel& c) { c.breaking = Breaking{.ceasing_froude = 0.9}; });
  refused("A viscosity that drives.", {"share", "= -1", "positive"},
          [](Channel& c) { c.breaking = Breaking{.share = -1}; });
  refused("A negative period.", {"period", "= -6", "non-negative"}, [](Channel& c) { c.period = -6; });
  refused("A period shorter than the water.", {"x[5]", "= 5", "period"}, [](Channel& c) { c.period = 4; });
  refused("A kinetic energy that is negative over steep slopes.", {"green_naghdi", "alpha", "1/4"}, [](Channel& c) {
    c.kinetics = Kinetics::green_naghdi;
    c.alpha = 0.2;
  });
  refusals.refused("A bottom that is not periodic with the channel.", {"period", "bottom"}, [] {
    Channel channel{.bottom = std::make_shared<CosineBottom>(1, 0.1, 1), .period = 5};
    Flow flow(channel, still_markers(channel, {0, 1, 2, 3, 4}));
  });
  refusals.refused("A bottom that ends before the period does.", {"period", "bottom"}, [] {
    Channel channel = channel_over({0, 4.5}, {-1, -1});
    channel.period = 5;
    Flow flow(channel, still_markers(channel, {0, 1, 2, 3, 4}));
  });
}

TEST_CASE("bad bottoms are refused with name, value and range", "[robustness]") {
  Check check("dispersive_bad_bottom", "Bad bottoms of the dispersive model",
              "Tables that are no function, constants out of range, and slopes on which no marker can stand.");
  Refusals refusals(check);
  refusals.refused("A table of places that do not ascend.", {"bottom x[2]", "= 1", "above x[1] = 1"}, [] {
    PiecewiseLinearBottom({0, 1, 1}, {-1, -1, -1});
  });
  refusals.refused("As many places as elevations.", {"3 places", "2 elevations"}, [] {
    PiecewiseLinearBottom({0, 1, 2}, {-1, -1});
  });
  refusals.refused("A table of one place.", {"1 places", "at least 2"}, [] { PiecewiseLinearBottom({0}, {-1}); });
  refusals.refused("An elevation that is not a number.", {"bottom elevation[1]", "nan", "finite"}, [] {
    PiecewiseLinearBottom({0, 1}, {-1, not_a_number});
  });
  refusals.refused("A level bottom above the water.", {"depth", "= -1", "positive"}, [] { LevelBottom bottom(-1); });
  refusals.refused("A cosine without a wavelength.", {"wavenumber", "= 0", "positive"},
                   [] { CosineBottom(1, 0.1, 0); });
  refusals.refused("A smooth bottom without a slope.", {"slope"},
                   [] { SmoothBottom([](double) { return -1.0; }, {}, 0, 1); });
  refusals.refused("A smooth bottom that ends before it begins.", {"begin", "1", "end"},
                   [] { SmoothBottom([](double) { return -1.0; }, [](double) { return 0.0; }, 1, 0); });
  const auto with_slope = [](double slope) {
    Channel channel{.bottom = std::make_shared<SmoothBottom>(
                        [](double) { return -1.0; }, [slope](double x) { return x < 0.5 ? slope : 0.0; }, -1, 9)};
    Flow flow(channel, still_markers(channel, {0, 1, 2, 3, 4, 5}));
  };
  refusals.refused("A wall where the bottom is vertical.", {"slope", "inf", "finite"}, [&] { with_slope(infinity); });
  refusals.refused("A slope that is not a number.", {"slope", "nan", "finite"}, [&] { with_slope(not_a_number); });
  refusals.refused("Still water in a channel without a bottom.", {"bottom"}, [] {
    still_markers(Channel{}, {0, 1, 2});
  });
}

TEST_CASE("bad markers are refused with name, value and range", "[robustness]") {
  Check check(
      "dispersive_bad_markers", "Bad markers of the dispersive model",
      "Markers that are too few, out of order, not finite, under the bottom or off it; and water of no volume.");
  Refusals refusals(check);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      Markers markers = still_water();
      change(markers);
      Flow flow(level_channel(), markers);
    });
  };
  refused("Fewer than three markers.", {"2 markers", "at least 3"}, [](Markers& m) {
    for (auto* array : {&m.x, &m.y, &m.u, &m.v}) array->resize(2);
  });
  refused("Arrays of different lengths.", {"5 u", "6 x"}, [](Markers& m) { m.u.pop_back(); });
  refused("Markers that do not ascend.", {"x[3]", "1.5", "above x[2] = 2"}, [](Markers& m) { m.x[3] = 1.5; });
  refused("Markers at one place.", {"x[3]", "= 2", "above x[2] = 2"}, [](Markers& m) { m.x[3] = 2; });
  refused("A place that is not a number.", {"x[2]", "nan", "finite"}, [](Markers& m) { m.x[2] = not_a_number; });
  refused("An elevation that is infinite.", {"y[0]", "inf", "finite"}, [](Markers& m) { m.y[0] = infinity; });
  refused("A velocity that is not a number.", {"u[4]", "nan", "finite"}, [](Markers& m) { m.u[4] = not_a_number; });
  refused("A vertical velocity that is not a number.", {"v[1]", "nan", "finite"},
          [](Markers& m) { m.v[1] = not_a_number; });
  refused("A marker under the bottom.", {"y[2]", "-1.5", "above the bottom, -1"}, [](Markers& m) { m.y[2] = -1.5; });
  refused("A marker on the bottom that is not a tip.", {"y[2]", "-1", "above the bottom"},
          [](Markers& m) { m.y[2] = -1; });
  refusals.refused("A marker outside the table of the bottom.", {"x[3]", "= 3", "[0, 2.5]"}, [] {
    still_markers(channel_over({0, 2.5}, {-1, -1}), {0, 1, 2, 3});
  });
  refusals.refused("A tip that is above the bottom.", {"y[2]", "= 0", "-0.5"}, [] {
    still_markers(channel_over({0, 4}, {-1, 0}, End::tip), {0, 1, 2});
  });
  refusals.refused("Shorelines at both ends and no water between.", {"y[1]", "= 0", "above the bottom"}, [] {
    Channel channel = channel_over({0, 4}, {0, 0}, End::tip);
    channel.left = End::tip;
    Flow flow(channel, still_markers(channel, {0, 1, 2}));
  });
  refusals.refused("A cell filled by a ridge.", {"volume of cell 1", "> 0"}, [] {
    const Channel channel = channel_over({0, 1.1, 1.5, 1.9, 4}, {-1, -1, 3, -1, -1});
    Flow flow(channel, still_markers(channel, {0, 1, 2, 3, 4}));
  });
  refusals.refused("A marker whose share of water is negative, beside a ridge.", {"mass", "marker 2", "> 0"}, [] {
    const Channel channel = channel_over({0, 1.55, 1.75, 1.95, 2.05, 2.25, 2.45, 4}, {-1, -1, 4, -1, -1, 4, -1, -1});
    Flow flow(channel, still_markers(channel, {0, 0.5, 2, 3.5, 4}));
  });
}

TEST_CASE("bad starts, schemes and steps are refused with name, value and range", "[robustness]") {
  Check check(
      "dispersive_bad_start", "Bad starts and steps of the dispersive model",
      "Waves and labels that make no sense, names of schemes that do not exist, and lengths of steps. A refused "
      "step changes nothing.");
  Refusals refusals(check);
  const Channel channel = level_channel();
  refusals.refused("Labels of one cell.", {"cells", "= 1", "at least 2"}, [&] { equal_labels(channel, 0, 1, 1); });
  refusals.refused("A spacing of zero.", {"spacing", "= 0", "positive"},
                   [&] { solitary_markers(channel, 0, 60, 0, {}); });
  refusals.refused("A channel that ends before it begins.", {"end", "= -1", "begin"},
                   [&] { solitary_markers(channel, 0, -1, 0.25, {}); });
  refusals.refused("A crest outside the channel.", {"crest", "70", "[0, 60]"},
                   [&] { solitary_markers(channel, 0, 60, 0.25, {.crest = 70}); });
  refusals.refused("A solitary wave of depression.", {"amplitude", "-0.1"},
                   [&] { solitary_markers(channel, 0, 60, 0.25, {.amplitude = -0.1, .crest = 30}); });
  refusals.refused("A solitary wave between two shores.", {"two tips", "one tip at most"}, [] {
    const Channel bowl{
        .bottom = std::make_shared<PiecewiseLinearBottom>(std::vector{-22.0, 0.0, 42.0}, std::vector{0.1, -1.0, 1.1}),
        .left = End::tip,
        .right = End::tip};
    solitary_markers(bowl, -20, 20, 0.25, {.amplitude = 0.1, .crest = 0});
  });
  // The rounding of a tip's place on a slope grows with the depth.
  constexpr double deep = 1e5;
  for (int k = 0; k < 50; ++k) {
    const double foot = -deep * (3 + 0.1 * k);
    const Channel beach{.bottom = std::make_shared<PiecewiseLinearBottom>(std::vector{2 * foot, foot, -foot},
                                                                          std::vector{-deep, -deep, deep}),
                        .right = End::tip};
    CHECK_NOTHROW(still_markers(beach, {1.5 * foot, 0.5 * foot, 0}));
  }
  refusals.refused("A scheme that does not exist.", {"leapfrog", "one_step", "conservative"},
                   [] { stepping_named("leapfrog"); });
  refusals.refused("A composition that does not exist.", {"yoshida", "triple_jump", "suzuki"},
                   [] { composition_named("yoshida"); });
  refusals.refused("A negative number of sweeps.", {"fixed_sweeps", "= -1", "non-negative"}, [] {
    Flow flow(level_channel(), still_water(), {.stepping = Stepping::conservative, .fixed_sweeps = -1});
  });
  Flow flow(channel, still_water());
  flow.advance(0.1);
  for (const double bad : {0.0, -0.1, not_a_number, infinity}) {
    refusals.refused("A length of many steps that is not positive and finite.", {"tau", "positive and finite"},
                     [&] { stable_steps(flow, bad); });
    refusals.refused("A Courant number that is not positive and finite.", {"courant", "positive and finite"},
                     [&] { stable_steps(flow, 0.1, bad); });
  }
}

}  // namespace dispersive_shallow_water_input_test
