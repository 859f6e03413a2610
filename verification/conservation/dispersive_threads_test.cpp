// Two threads, one from either end of a channel, leave no trace.
#include <omp.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/exact/solitary_asymptotic.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "verification/check.hpp"

namespace dispersive_threads_test {

using namespace seiche;
using namespace seiche::dispersive_shallow_water_1d;

constexpr std::size_t cells = 140000;
constexpr double spacing = 0.25;
constexpr double tau = 0.05;
constexpr long steps = 4;
const std::string resolution = "140 000 cells, 4 steps";

/// A solitary wave in the middle of a channel between walls, or before a beach at its end.
std::pair<Channel, Markers> channel_with_wave(bool beach) {
  const double begin = -spacing * cells;
  Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  if (beach) {
    channel = {.bottom = std::make_shared<PiecewiseLinearBottom>(std::vector<double>{begin - 100, -20, 20},
                                                                 std::vector<double>{-1, -1, 1}),
               .left = End::wall,
               .right = End::tip};
  }
  const SolitaryStart wave{.amplitude = 0.1, .crest = beach ? -15 : begin / 2};
  return {channel, solitary_markers(channel, begin, 0, spacing, wave)};
}

struct Ending {
  mechanics::State state;
  std::string failure;

  [[nodiscard]] bool same_as(const Ending& other) const {
    return state.q == other.state.q && state.u == other.state.u && state.multipliers == other.state.multipliers &&
           failure == other.failure;
  }
};

Ending with_threads(int threads, const Channel& channel, const Markers& markers, Stepping stepping) {
  const int usual = omp_get_max_threads();
  omp_set_num_threads(threads);
  // Threads inherit how their maker treats denormal numbers: these are made here, as by a program that computes with
  // them.
  int made = 0;
#pragma omp parallel reduction(+ : made)
  ++made;
  REQUIRE(made == threads);
  Flow flow(channel, markers, {.stepping = stepping});
  Ending ending;
  try {
    for (long k = 0; k < steps; ++k) flow.advance(tau);
  } catch (const Divergence& divergence) {
    ending.failure = divergence.what();
  }
  ending.state = flow.state();
  omp_set_num_threads(usual);
  return ending;
}

TEST_CASE("two threads that meet in a dispersive channel leave no trace", "[conservation]") {
  verification::Check check(
      "dispersive_threads", "Dispersive shallow water: two threads",
      "A solitary wave in a long channel between walls, and before a beach. Long channels are "
      "worth two threads, which begin at the two ends and meet in the middle. Then still water of which "
      "one marker moves, and a tip that leaves its bottom.");
  const auto claim = [&](const std::string& id, const std::string& text, bool holds, const std::string& expected) {
    check.that({.id = id,
                .text = text,
                .quantity = "same bits",
                .source = "the same sums in the same order, whoever takes them"},
               {.value = holds ? 1.0 : 0.0, .resolution = resolution},
               evidence::Qualitative{expected, "results must not depend on the machine's load"});
  };
  for (const bool beach : {false, true}) {
    const auto [channel, markers] = channel_with_wave(beach);
    for (const std::string name : {"one_step", "one_step_feedback", "conservative"}) {
      const Stepping stepping = mechanics::stepping_named(name);
      const Ending alone = with_threads(1, channel, markers, stepping);
      const Ending together = with_threads(2, channel, markers, stepping);
      claim((beach ? "beach-" : "walls-") + name, "Results of one and two threads are bitwise identical.",
            alone.failure.empty() && alone.same_as(together), "equal places, rates and multipliers");
    }
  }
  auto [level, still] = channel_with_wave(false);
  for (std::vector<double>* values : {&still.y, &still.u, &still.v}) values->assign(still.size(), 0.0);
  still.v[cells / 8] = 1e-3;
  claim("denormals", "What decays into numbers too small for a processor's usual arithmetic is zero to either thread.",
        with_threads(1, level, still, Stepping::one_step).same_as(with_threads(2, level, still, Stepping::one_step)),
        "equal places, rates and multipliers");
  auto [channel, markers] = channel_with_wave(true);
  markers.u.back() = 1e9;
  const Ending alone = with_threads(1, channel, markers, Stepping::one_step);
  const Ending together = with_threads(2, channel, markers, Stepping::one_step);
  claim("failure", "A tip that leaves the bottom is reported the same by either thread.",
        !alone.failure.empty() && alone.same_as(together), "one message, with its place; the state as before the step");
}

}  // namespace dispersive_threads_test
