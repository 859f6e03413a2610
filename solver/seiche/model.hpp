/// What every flow of the library offers, and the only loop to a time.
///
///     march(flow, 20, 0.05);                               // equal steps of at most 0.05
///     march(flow, 20, 0.05, [&] { gauges.read(flow); });   // looked at after each
///     march(flow, 20);                                     // steps of flow.stable_step(), the last one cut
///     march(flow, 20, stable_steps(flow, 0.05));           // equal ones of at most 0.05, shorter where they must be
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/require.hpp"

namespace seiche {

/// A sum over a flow that changes by what is booked alone: value - booked is what it was at the beginning, to round-off
/// or to the order of the scheme, as the flow's header says.
struct Invariant {
  std::string name;   ///< mass, momentum_x, ..., energy
  double value = 0;   ///< now
  double booked = 0;  ///< what has come in since the beginning: through ends, by forces; losses are negative
};

/// A flow in time.
///
/// advance(tau) makes one step, tau > 0. Throws std::invalid_argument for tau, Divergence where the step cannot be
/// made; time and steps are then as before, and so is the state but where a flow's header says otherwise.
/// stable_step() is the longest step that the flow proposes by its present state, infinite where it knows of no limit.
/// arrive(time) is for `march`: the present time, without what rounding took.
template <class M>
concept AnyFlow = requires(M& flow, const M& seen, double tau) {
  flow.advance(tau);
  flow.arrive(tau);
  { seen.time() } -> std::convertible_to<double>;
  { seen.steps() } -> std::convertible_to<long>;
  { flow.stable_step() } -> std::convertible_to<double>;
  { seen.invariants() } -> std::same_as<std::vector<Invariant>>;
};

/// Steps until `time`, which is hit exactly; after() is called after each. Returns how many.
/// @param tau  a number: equal steps of at most that, byte for byte those of a loop of advance;
///             or tau(rest): the longest next step where `rest` is left, by the flow's present state
/// Throws std::invalid_argument for a time before the present one and for tau; Divergence as advance, and where steps
/// shrink to nothing.
template <AnyFlow M, class Tau, class After>
long march(M& flow, double time, const Tau& tau, const After& after) {
  const double begin = flow.time();
  const long before = flow.steps();
  if (!(time >= begin && std::isfinite(time))) {
    throw std::invalid_argument(fmt::format("time = {:g}; allowed: finite, at least the present {:g}", time, begin));
  }
  const auto step = [&](double length, bool last) {
    flow.advance(length);
    if (last) flow.arrive(time);
    after();
  };
  if constexpr (std::is_arithmetic_v<Tau>) {
    require_positive("tau", tau);
    const auto steps = static_cast<long>(std::ceil((time - begin) / tau - 1e-9));
    for (long k = 1; k <= steps; ++k) step((time - begin) / static_cast<double>(steps), k == steps);
  } else {
    while (flow.time() < time) {
      const double rest = time - flow.time();
      const double longest = tau(rest);
      if (!(longest > 1e-12 * (time - begin))) {
        throw Divergence("admissible time step shrinks to nothing", flow.time(), flow.steps(), 0);
      }
      step(std::min(longest, rest), longest >= rest);
    }
  }
  return flow.steps() - before;
}
template <AnyFlow M, class Tau>
long march(M& flow, double time, const Tau& tau) {
  return march(flow, time, tau, [] {});
}
/// Steps of flow.stable_step(), the last one cut.
template <AnyFlow M>
long march(M& flow, double time) {
  return march(flow, time, [&](double) { return flow.stable_step(); });
}

/// For march: equal steps of at most tau and of `courant` stable steps. No last one is a sliver, which would also spoil
/// the order of a scheme.
template <AnyFlow M>
auto stable_steps(M& flow, double tau, double courant = 0.3) {
  require_positive("tau", tau);
  require_positive("courant", courant);
  return [&flow, tau, courant](double rest) {
    return rest / std::max(1.0, std::ceil(rest / std::min(tau, courant * flow.stable_step()) - 1e-9));
  };
}

}  // namespace seiche
