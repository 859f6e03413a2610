/// Flows and their twins (twin.hpp): what must not change a computation, for every model and its main options.
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/conservation/twin.hpp"

namespace seiche::verification::metamorphic {

constexpr int steps = 24;

template <class Flow>
void take_steps(Flow& flow, double tau) {
  for (int k = 0; k < steps; ++k) flow.advance(tau);
}

inline double hump(double x, double at) {
  return std::exp(-(x - at) * (x - at));
}

inline Point sloshed(Point r) {
  return {0.05 * std::sin(r.x) * std::cosh(r.y + 1), -0.05 * std::cos(r.x) * std::sinh(r.y + 1)};
}

/// Points in a plane at the end of a flow. @param order  their numbers in the flow
inline Seen seen_in_plane(const Twin& twin, const std::vector<std::size_t>& order, const auto& x, const auto& y,
                          const auto& u, const auto& v, double time) {
  Seen seen(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) seen.at(order[k], twin, {x[k], y[k]}, {u[k], v[k]}, time);
  return seen;
}

/// Nodes of layers that are lattices in plan.
inline Seen seen_in_space(const Twin& twin, const TwinLattice& nodes, const auto& flow) {
  const auto x = flow.x(), y = flow.y(), z = flow.z(), u = flow.u(), v = flow.v(), w = flow.w();
  Seen seen(2 * x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t n = nodes.node.size(), base = k / n * n + nodes.node[k % n];
    seen.at(2 * base, twin, {x[k], y[k]}, {u[k], v[k]}, flow.time());
    seen.at(2 * base + 1, {z[k] / twin.length, 0}, {w[k] / twin.speed(), 0});
  }
  return seen;
}

struct Transformation {
  std::string id, what;
  Twin twin;
  bool binary = false;  ///< powers of two only
};

inline const std::vector<Transformation> transformations{
    {"mirror", "in a mirror", {.mirrored = true}},
    {"turned", "turned by 90 degrees", {.turns = 1}},
    {"units-128",
     "in units 1/128 as long, 1/16 as lasting, 1/4 as dense",
     {.length = 128, .time = 16, .density = 4},
     true},
    {"units-4096", "in units 4096 as long, 64 as lasting", {.length = 1.0 / 4096, .time = 1.0 / 64}, true},
    {"units-100",
     "in units 1/100 as long, 1/10 as lasting, 1/1000 as dense",
     {.length = 100, .time = 10, .density = 1000}},
    {"origin", "64 to the right and 32 below", {.origin = {64, -32}}},
    {"along", "64 to the right", {.origin = {64, 0}}},
    {"moving", "from a frame that moves at 1/4", {.drift = 0.25}},
    {"permuted", "with its particles in another order", {.permuted = true}},
};

using Which = std::set<std::string>;
inline Which and_units(Which some) {
  some.insert({"units-128", "units-4096", "units-100"});
  return some;
}

struct Option {
  std::string name;
  std::function<Seen(const Twin&)> run;
  Which which;          ///< transformations
  bool rounds = false;  ///< by powers and roots that take a power of two apart
};

inline const std::string of_solves =
    "each of 24 steps some hundred roundings, times 20 for the solution of its equations";
inline const std::string of_sums = "each of 24 steps some hundred roundings";

/// A model, and by what its roundings grow.
struct Subject {
  std::string id, name;
  double growth = 20;
  std::string reason = of_solves;
  std::vector<Option> options = {};

  /// @param flow  flow(twin) runs the flow as its twin. The twin of other units is one of those of every option.
  void add(const std::string& option, const Which& which, std::function<Seen(const Twin&)> flow, bool rounds = false) {
    options.push_back({option, std::move(flow), and_units(which), rounds});
  }
};

/// Of what throws: more than any limit.
inline double difference(const Option& option, const Twin& twin) {
  try {
    return option.run({}).difference(option.run(twin));
  } catch (const std::exception& failure) {
    UNSCOPED_INFO(option.name << ": " << failure.what());
    return 1;
  }
}

/// Every subject is a check.
inline void judge(const std::vector<Subject>& subjects) {
  for (const Subject& subject : subjects) {
    Check check(
        "metamorphic_" + subject.id, fmt::format("The flow of {} and its twin", subject.name),
        "A small flow with each main option of the model, some 24 steps, and its twin: mirrored; rotated by 90 "
        "degrees; in other units; at another position; in a moving frame; with its particles in another order. The "
        "twin's results, transformed back, equal the flow's: bitwise with powers of two as units, except where a power "
        "or a root is not exact (friction after Manning, viscosity of breaking fronts, the side of a cube); else to "
        "round-off. Left out: mirrors of MacCormack's scheme, which takes its differences to one side first; turns and "
        "moving frames of Gauss-principle particles, whose cells stand still and are continued along columns before "
        "rows. Differences are of a position over the extent or of a velocity over the largest.");
    for (const Transformation& t : transformations) {
      const double far = 1 + std::hypot(t.twin.origin.x, t.twin.origin.y);
      const evidence::Criterion rounded = Roundoff{100.0 * steps, subject.growth * far,
                                                   subject.reason + "; positions as far from the origin as they are"};
      const evidence::Criterion bits = Bound{0, "the same operations on the same mantissas"};
      for (const Option& option : subject.options) {
        if (!option.which.contains(t.id)) continue;
        check.holds(fmt::format("{}: the same {}.", option.name, t.what), {difference(option, t.twin)},
                    t.binary && !option.rounds ? bits : rounded);
      }
    }
  }
}

}  // namespace seiche::verification::metamorphic
