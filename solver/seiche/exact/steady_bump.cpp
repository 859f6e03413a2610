#include "seiche/exact/steady_bump.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/exact/jump_identities.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

constexpr double smallest_share = 1e-6;  // of the crest's position, which its half-width may be

}  // namespace

SteadyBump::SteadyBump(double gravity, double discharge, Bump bump)
    : gravity_(gravity), discharge_(discharge), bump_(bump), critical_(std::cbrt(discharge * discharge / gravity)) {
  require_positive("gravity", gravity);
  require_positive("discharge", discharge);
  require_positive("bump height", bump.height);
  require_positive("bump half_width", bump.half_width);
  require_positive("length", bump.length);
  require_within("bump crest", bump.crest, bump.half_width, bump.length - bump.half_width);
  if (!(bump.half_width >= smallest_share * bump.crest)) {
    throw std::invalid_argument(fmt::format(
        "bump half_width = {:g} is out of range: must be at least {:g} of the crest's position {:g}, or the "
        "rounding of positions shows",
        bump.half_width, smallest_share, bump.crest));
  }
}

SteadyBump SteadyBump::transcritical(double gravity, double discharge, Bump bump) {
  return SteadyBump(gravity, discharge, bump);
}

SteadyBump::SteadyBump(double gravity, double discharge, double outflow_depth, Bump bump)
    : SteadyBump(gravity, discharge, bump) {
  require_positive("outflow_depth", outflow_depth);
  if (!(outflow_depth > critical_)) {
    throw std::invalid_argument(
        fmt::format("outflow_depth = {:.17g} is out of range: must exceed the critical depth {:g}; no steady state "
                    "with this outflow",
                    outflow_depth, critical_));
  }
  // E - 1.5 h_c at the outflow, where z = 0, from the factored form (h - h_c)^2 (h + h_c/2)/h^2: exact near h_c.
  const double outflow_excess = (outflow_depth - critical_) * (outflow_depth - critical_) *
                                (outflow_depth + 0.5 * critical_) / (outflow_depth * outflow_depth);
  downstream_excess_ = outflow_excess - bump.height;
  if (downstream_excess_ >= 0) {
    regime_ = Regime::subcritical;
    upstream_excess_ = downstream_excess_;
    return;
  }
  regime_ = Regime::with_jump;
  place_jump(outflow_depth);
}

double SteadyBump::drop_from_crest(double x) const {
  const double s = (x - bump_.crest) / bump_.half_width;
  return std::abs(s) < 1 ? bump_.height * s * s : bump_.height;
}

double SteadyBump::elevation(double x) const {
  const double s = (x - bump_.crest) / bump_.half_width;
  return std::abs(s) < 1 ? bump_.height * (1 - s) * (1 + s) : 0.0;
}

/// Root of h^3 - e h^2 + q^2/(2g) = 0 with e = 1.5 h_c + excess. With sin^2(phi) = 27 q^2/(8 g e^3) = (1.5 h_c/e)^3 and
/// a = 2 phi/3: upper root e (1 + 2 cos a)/3, middle root e (1 + 2 cos(a - 2 pi/3))/3. Both sine and cosine of phi are
/// formed from the excess, so that neither branch loses digits at critical flow.
double SteadyBump::depth_from_excess(double excess, Branch branch) const {
  const double e = 1.5 * critical_ + excess;
  const double ratio = 1.5 * critical_ / e;
  const double sine = ratio * std::sqrt(ratio);
  const double cosine = std::sqrt(excess / e * (1 + ratio + ratio * ratio));
  const double a = 2.0 / 3.0 * std::atan2(sine, cosine);
  if (branch == Branch::subcritical) return e / 3 * (1 + 2 * std::cos(a));
  const double half = std::sin(0.5 * a);
  return e / 3 * (2 * half * half + std::numbers::sqrt3 * std::sin(a));
}

void SteadyBump::place_jump(double outflow_depth) {
  const auto momentum = [&](double h) { return discharge_ * discharge_ / h + 0.5 * gravity_ * h * h; };
  const auto imbalance = [&](double x) {
    const double drop = drop_from_crest(x);
    return momentum(depth_from_excess(drop, Branch::supercritical)) -
           momentum(depth_from_excess(std::max(drop + downstream_excess_, 0.0), Branch::subcritical));
  };
  // The downstream flow reaches up to where it would be critical; the jump lies between there and the bump's foot.
  const double highest = bump_.crest + bump_.half_width * std::sqrt(-downstream_excess_ / bump_.height);
  const double foot = bump_.crest + bump_.half_width;
  if (!(imbalance(foot) <= 0)) {
    throw std::invalid_argument(
        fmt::format("outflow_depth = {:.17g} is out of range: the jump would be swept off the bump, no steady state "
                    "with a jump on it",
                    outflow_depth));
  }
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(imbalance, highest, foot,
                                                        boost::math::tools::eps_tolerance<double>(53), iterations);
  jump_ = std::abs(imbalance(a)) < std::abs(imbalance(b)) ? a : b;
}

sw::State SteadyBump::at(double x, double /*t*/) const {
  require_within("x", x, 0, bump_.length);
  const double drop = drop_from_crest(x);
  double h = 0;
  if (regime_ == Regime::subcritical || x <= bump_.crest) {
    h = depth_from_excess(drop + upstream_excess_, Branch::subcritical);
  } else if (regime_ == Regime::with_jump && x > jump_) {
    h = depth_from_excess(drop + downstream_excess_, Branch::subcritical);
  } else {
    h = depth_from_excess(drop, Branch::supercritical);
  }
  return {h, discharge_ / h};
}

std::vector<double> SteadyBump::breakpoints(double /*t*/) const {
  std::vector<double> points{bump_.crest - bump_.half_width, bump_.crest};
  if (regime_ == Regime::with_jump) points.push_back(jump_);
  points.push_back(bump_.crest + bump_.half_width);
  return points;
}

double SteadyBump::depth_before_jump() const {
  return regime_ == Regime::with_jump ? depth_from_excess(drop_from_crest(jump_), Branch::supercritical) : jump_;
}

double SteadyBump::depth_after_jump() const {
  return regime_ == Regime::with_jump
             ? depth_from_excess(drop_from_crest(jump_) + downstream_excess_, Branch::subcritical)
             : jump_;
}

Bed SteadyBump::bed() const {
  const Bump bump = bump_;
  const SteadyBump self = *this;
  return {[self](double x) { return self.elevation(x); },
          [bump](double x) {
            const double s = std::min(std::max((x - bump.crest) / bump.half_width, -1.0), 1.0);
            return bump.height * bump.half_width * s * (1 - s * s / 3);
          }};
}

double SteadyBump::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest SteadyBump::self_test() const {
  const auto head = [&](double x) {
    const auto state = at(x);
    return elevation(x) + state.depth + state.velocity * state.velocity / (2 * gravity_);
  };
  SelfTest tests;
  Largest defect;
  for (const double share : {0.2, 0.5, 0.8}) {
    const double x = bump_.crest - share * bump_.half_width;
    defect.add(std::abs(head(x) - head(0)) / head(0));
  }
  tests.push_back({"the head is constant upstream of the crest", defect.value(),
                   4 * std::numeric_limits<double>::epsilon() * std::sqrt(60),
                   "two heads of 30 roundings: 20 of the root of a cubic by cosines, a subcritical depth that the head "
                   "follows at most one to one, and 10 of the bed and the velocity head"});
  if (regime_ == Regime::with_jump) {
    auto jump = jump_identities("the jump", gravity_, {depth_before_jump(), discharge_ / depth_before_jump()},
                                {depth_after_jump(), discharge_ / depth_after_jump()}, 0);
    // The bed pushes with g h dz/dx, dz/dx up to 2 H/w: over the rounding of the jump's place that is a share of the
    // thrust g h^2/2 of up to 4 (H/h)(dx/w).
    const double placed =
        4 * std::numeric_limits<double>::epsilon() * bump_.height / depth_after_jump() * jump_ / bump_.half_width;
    jump.back().accuracy += placed;
    jump.back().reason += fmt::format("; {:.2g} for the rounding of the place, of which the bed makes a push", placed);
    tests.insert(tests.end(), jump.begin(), jump.end());
  }
  return tests;
}

Provenance SteadyBump::provenance() {
  return {"Goutal and Maurel (1997); Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269, section 3.1",
          "h^3 - (E - z) h^2 + q^2/(2g) = 0; q^2/h + g h^2/2 continuous at the jump"};
}

static_assert(ReferenceSolution<SteadyBump>);

}  // namespace seiche::exact
