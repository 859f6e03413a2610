#include "seiche/exact/shallow_water/steady_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace sw = shallow_water;
namespace quadrature = boost::math::quadrature;

namespace {

constexpr double smallest_share = 1e-6;  // of the crest's position, which its half-width may be

constexpr std::size_t panels = 64;
using GaussRule = quadrature::gauss<double, 15>;

/// Boost integrates from the lower to the upper limit only; left of the channel the sign is turned by hand.
template <class Function>
double from_to(const Function& f, double from, double to) {
  return to >= from ? GaussRule::integrate(f, from, to) : -GaussRule::integrate(f, to, from);
}

}  // namespace

SteadyBump::SteadyBump(double gravity, double discharge, Bump bump)
    : gravity_(gravity), discharge_(discharge), bump_(bump), critical_(std::cbrt(discharge * discharge / gravity)) {
  require_all_positive({{"gravity", gravity},
                        {"discharge", discharge},
                        {"bump height", bump.height},
                        {"bump half_width", bump.half_width},
                        {"length", bump.length}});
  require_within("bump crest", bump.crest, bump.half_width, bump.length - bump.half_width);
  require_that(bump.half_width >= smallest_share * bump.crest,
               "bump half_width = {:g} is out of range: must be at least {:g} of the crest's position {:g}, or "
               "the rounding of positions shows",
               bump.half_width, smallest_share, bump.crest);
}

SteadyBump::SteadyBump(double gravity, double discharge, double outflow_depth, Bump bump)
    : SteadyBump(gravity, discharge, bump) {
  require_positive("outflow_depth", outflow_depth);
  require_that(outflow_depth > critical_,
               "outflow_depth = {:.17g} is out of range: must exceed the critical depth {:g}; no steady state "
               "with this outflow",
               outflow_depth, critical_);
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
  const auto momentum = [&](double h) { return discharge_ * discharge_ / h + 0.5 * gravity_ * h * h; };
  const auto imbalance = [&](double x) {
    const double drop = drop_from_crest(x);
    return momentum(depth_from_excess(drop, Branch::supercritical)) -
           momentum(depth_from_excess(std::max(drop + downstream_excess_, 0.0), Branch::subcritical));
  };
  // The downstream flow reaches up to where it would be critical; the jump lies between there and the bump's foot.
  const double highest = bump_.crest + bump_.half_width * std::sqrt(-downstream_excess_ / bump_.height);
  const double foot = bump_.crest + bump_.half_width;
  require_that(imbalance(foot) <= 0,
               "outflow_depth = {:.17g} is out of range: the jump would be swept off the bump, no steady state "
               "with a jump on it",
               outflow_depth);
  jump_ = root_at_end(imbalance, highest, foot);
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

double SteadyBump::depth_after_jump() const {
  return regime_ == Regime::with_jump
             ? depth_from_excess(drop_from_crest(jump_) + downstream_excess_, Branch::subcritical)
             : jump_;
}

Bed SteadyBump::bed() const {
  return {[self = *this](double x) { return self.elevation(x); },
          [bump = bump_](double x) {
            const double s = std::clamp((x - bump.crest) / bump.half_width, -1.0, 1.0);
            return bump.height * bump.half_width * s * (1 - s * s / 3);
          }};
}

SelfTest SteadyBump::self_test() const {
  const auto head = [&](double x) {
    const auto state = at(x);
    return elevation(x) + state.depth + state.velocity * state.velocity / (2 * gravity_);
  };
  SelfTest tests{
      {"the head is constant upstream of the crest",
       worst(0, 2, [&](int i) { return (head(bump_.crest - (0.2 + 0.3 * i) * bump_.half_width) - head(0)) / head(0); }),
       4 * epsilon * std::sqrt(60),
       "two heads of 30 roundings: 20 of the root of a cubic by cosines, a subcritical depth that the head "
       "follows at most one to one, and 10 of the bed and the velocity head"}};
  if (regime_ == Regime::with_jump) {
    auto jump = jump_identities("the jump", gravity_, {depth_before_jump(), discharge_ / depth_before_jump()},
                                {depth_after_jump(), discharge_ / depth_after_jump()}, 0);
    // The bed pushes with g h dz/dx, dz/dx up to 2 H/w: over the rounding of the jump's place that is a share of the
    // thrust g h^2/2 of up to 4 (H/h)(dx/w).
    const double placed = 4 * epsilon * bump_.height / depth_after_jump() * jump_ / bump_.half_width;
    jump.back().accuracy += placed;
    jump.back().reason += fmt::format("; {:.2g} for the rounding of the place, of which the bed makes a push", placed);
    tests.insert(tests.end(), jump.begin(), jump.end());
  }
  return tests;
}

MacDonald::MacDonald(double gravity, std::function<double(double)> depth, std::function<double(double)> slope,
                     double discharge, double manning, double length)
    : gravity_(gravity),
      depth_(std::move(depth)),
      slope_(std::move(slope)),
      discharge_(discharge),
      manning_(manning),
      length_(length) {
  require_all_positive({{"gravity", gravity}, {"discharge", discharge}});
  require_not_negative("manning", manning);
  require_positive("length", length);
  require_that(depth_ && slope_, "profile: depth and slope must both be given");

  auto table = std::make_shared<Table>();
  table->elevation.assign(panels + 1, 0.0);
  table->primitive.assign(panels + 1, 0.0);
  const double width = length_ / static_cast<double>(panels);
  const auto z_prime = [this](double x) { return bed_slope(x); };
  std::vector<double> rise(panels);
  std::vector<double> moment(panels);  // integral of (right end - x) z'
  double defect = 0;
  double range = 0;
  for (std::size_t k = 0; k < panels; ++k) {
    const double a = width * static_cast<double>(k);
    const double b = a + width;
    rise[k] = GaussRule::integrate(z_prime, a, b);
    moment[k] = GaussRule::integrate([&](double x) { return (b - x) * bed_slope(x); }, a, b);
    double estimate = 0;
    const double reference = quadrature::gauss_kronrod<double, 31>::integrate(z_prime, a, b, 5, 1e-14, &estimate);
    defect += std::abs(reference - rise[k]);
    range += std::abs(rise[k]) + std::abs(depth_(b) - depth_(a));  // near critical the depth's slope cancels
  }
  require_that(defect <= 1e-12 * range,
               "profile: bed integrated only to {:g}, must be to 1e-12; make the depth smoother", defect);
  // z from its value 0 at the downstream end, Z from its value 0 at the upstream end.
  for (std::size_t k = panels; k-- > 0;) table->elevation[k] = table->elevation[k + 1] - rise[k];
  for (std::size_t k = 0; k < panels; ++k) {
    table->primitive[k + 1] = table->primitive[k] + table->elevation[k] * width + moment[k];
  }
  table_ = std::move(table);
}

MacDonald MacDonald::smooth_rise(double gravity, double discharge, double manning, double length, double crest) {
  require_all_positive({{"gravity", gravity}, {"discharge", discharge}, {"length", length}});
  require_within("crest", crest, -0.9, 10);
  const double base = std::cbrt(discharge * discharge / gravity);
  const auto bump = [=](double x) {
    const double s = x / length - 0.5;
    return crest * std::exp(-16 * s * s);
  };
  return {gravity,
          [=](double x) { return base * (1 + bump(x)); },
          [=](double x) { return -32 * base / length * (x / length - 0.5) * bump(x); },
          discharge,
          manning,
          length};
}

double MacDonald::bed_slope(double x) const {
  const double h = depth_(x);
  require_positive("depth of the profile", h);
  const double q2 = discharge_ * discharge_;
  const double cube = h * h * h;
  return (q2 / (gravity_ * cube) - 1) * slope_(x) - manning_ * manning_ * q2 / (cube * std::cbrt(h));
}

MacDonald::Panel MacDonald::panel_of(double x) const {
  const double place = x / length_ * static_cast<double>(panels);
  const auto k = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(panels - 1)));
  return {k, length_ / static_cast<double>(panels) * static_cast<double>(k)};
}

double MacDonald::elevation(double x) const {
  const auto [k, begin] = panel_of(x);
  return table_->elevation[k] + from_to([this](double s) { return bed_slope(s); }, begin, x);
}

double MacDonald::primitive(double x) const {
  const auto [k, begin] = panel_of(x);
  const double moment = from_to([&](double s) { return (x - s) * bed_slope(s); }, begin, x);
  return table_->primitive[k] + table_->elevation[k] * (x - begin) + moment;
}

sw::State MacDonald::at(double x, double /*t*/) const {
  require_within("x", x, 0, length_);
  const double h = depth_(x);
  return {h, discharge_ / h};
}

Bed MacDonald::bed() const {
  return {[self = *this](double x) { return self.elevation(x); },
          [self = *this](double x) { return self.primitive(x); }};
}

SelfTest MacDonald::self_test() const {
  // Momentum: the fall of the bed balances the change of q^2/(2 g h^2) + h and the loss by friction.
  const auto friction = [&](double x) {
    const double h = depth_(x);
    return manning_ * manning_ * discharge_ * discharge_ / std::pow(h, 10.0 / 3.0);
  };
  const double loss = integral<30>(friction, 0, length_, 32);
  const auto energy = [&](double x) {
    const double h = depth_(x);
    return elevation(x) + h + discharge_ * discharge_ / (2 * gravity_ * h * h);
  };
  const double fall = energy(0) - energy(length_);
  return {{"the fall of the head is the loss by friction", std::abs(fall - loss) / (std::abs(energy(0)) + loss), 1e-12,
           "the bed is integrated to 1e-12 of its range"}};
}

static_assert(ReferenceSolution<MacDonald>);

ExactSolution steady_bump_entry() {
  return Entry<SteadyBump>{
      .name = "steady_bump",
      .title = "Steady flow over a parabolic bump: subcritical, transcritical, with a hydraulic jump",
      .citation =
          "Goutal and Maurel (1997); Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269, section 3.1",
      .formula = "h^3 - (E - z) h^2 + q^2/(2g) = 0; q^2/h + g h^2/2 continuous at the jump",
      .parameters = {{"discharge", "m^2/s", 0.18, 1e-9, 1e6, "discharge per unit width"},
                     {"outflow_depth", "m", 0.33, 0, 1e6, "depth at the outflow; 0: supercritical outflow, no jump"},
                     gravity_parameter(),
                     {"height", "m", 0.2, 1e-9, 1e6, "height of the bump"},
                     {"crest", "m", 10, 0, 1e9, "position of the crest"},
                     {"half_width", "m", 2, 1e-9, 1e9, "half-width of the bump"},
                     {"length", "m", 25, 1e-9, 1e9, "length of the channel [0, length]"}},
      .inputs = {position_x},
      .outputs = {depth_h, {"u", "m/s", "velocity"}, {"z", "m", "bed elevation"}},
      .scalars = {{"critical_depth", "m", "(q^2/g)^(1/3)", &SteadyBump::critical_depth},
                  {"jump", "m", "place of the hydraulic jump, NaN without one", &SteadyBump::jump},
                  {"depth_before_jump", "m", "depth just upstream of it, NaN without one",
                   &SteadyBump::depth_before_jump},
                  {"depth_after_jump", "m", "depth just downstream of it, NaN without one",
                   &SteadyBump::depth_after_jump}},
      .make = made_by(
          [](double g, double discharge, double outflow, double height, double crest, double half_width,
             double length) {
            const SteadyBump::Bump bump{height, crest, half_width, length};
            return outflow > 0 ? SteadyBump(g, discharge, outflow, bump)
                               : SteadyBump::transcritical(g, discharge, bump);
          },
          "gravity", "discharge", "outflow_depth", "height", "crest", "half_width", "length"),
      .row = steady_row<SteadyBump>};
}

ExactSolution macdonald_entry() {
  return Entry<MacDonald>{
      .name = "macdonald",
      .title = "Steady flow with Manning friction over a bed made to fit a smooth rise of the depth",
      .citation =
          "MacDonald, Baines, Nichols and Samuels, Analytic benchmark solutions for open-channel flows, J. Hydraul. "
          "Eng. 123 (1997) 1041; Delestre et al., SWASHES (2013), section 3.2",
      .formula = "z' = (q^2/(g h^3) - 1) h' - n^2 q^2/h^(10/3)",
      .parameters = {{"discharge", "m^2/s", 2, 1e-9, 1e6, "discharge per unit width"},
                     {"manning", "s/m^(1/3)", 0.033, 0, 1, "Manning's coefficient"},
                     {"length", "m", 1000, 1e-6, 1e9, "length of the channel [0, length]"},
                     {"crest", "1", 0.5, -0.9, 10, "relative rise of the depth in the middle"},
                     gravity_parameter()},
      .inputs = {position_x},
      .outputs = {depth_h, {"u", "m/s", "velocity"}, {"z", "m", "bed elevation, 0 at the outflow"}},
      .scalars = {{"fall", "m", "fall of the bed over the channel",
                   [](const MacDonald& solution) {
                     return solution.elevation(0) - solution.elevation(solution.length());
                   }}},
      .make = made_by(&MacDonald::smooth_rise, "gravity", "discharge", "manning", "length", "crest"),
      .row = steady_row<MacDonald>};
}

}  // namespace seiche::exact
