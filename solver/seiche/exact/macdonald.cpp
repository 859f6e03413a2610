#include "seiche/exact/macdonald.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;
namespace quadrature = boost::math::quadrature;

namespace {

constexpr std::size_t panels = 64;
using GaussRule = quadrature::gauss<double, 15>;

}  // namespace

MacDonald::MacDonald(double gravity, std::function<double(double)> depth, std::function<double(double)> slope,
                     double discharge, double manning, double length)
    : gravity_(gravity),
      depth_(std::move(depth)),
      slope_(std::move(slope)),
      discharge_(discharge),
      manning_(manning),
      length_(length) {
  require_positive("gravity", gravity);
  require_positive("discharge", discharge);
  require_not_negative("manning", manning);
  require_positive("length", length);
  if (!depth_ || !slope_) throw std::invalid_argument("profile: depth and slope must both be given");

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
  if (!(defect <= 1e-12 * range)) {
    throw std::invalid_argument(
        fmt::format("profile: bed integrated only to {:g}, must be to 1e-12; make the depth smoother", defect));
  }
  // z from its value 0 at the downstream end, Z from its value 0 at the upstream end.
  for (std::size_t k = panels; k-- > 0;) table->elevation[k] = table->elevation[k + 1] - rise[k];
  for (std::size_t k = 0; k < panels; ++k) {
    table->primitive[k + 1] = table->primitive[k] + table->elevation[k] * width + moment[k];
  }
  table_ = std::move(table);
}

MacDonald MacDonald::smooth_rise(double gravity, double discharge, double manning, double length, double crest) {
  require_positive("gravity", gravity);
  require_positive("discharge", discharge);
  require_positive("length", length);
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

std::size_t MacDonald::panel_of(double x) const {
  const double place = x / length_ * static_cast<double>(panels);
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(panels - 1)));
}

double MacDonald::elevation(double x) const {
  const std::size_t k = panel_of(x);
  const double a = length_ / static_cast<double>(panels) * static_cast<double>(k);
  if (x == a) return table_->elevation[k];
  const auto z_prime = [this](double s) { return bed_slope(s); };
  // boost integrates from the lower to the upper limit only; left of the channel the sign is turned by hand.
  const double rise = x > a ? GaussRule::integrate(z_prime, a, x) : -GaussRule::integrate(z_prime, x, a);
  return table_->elevation[k] + rise;
}

double MacDonald::primitive(double x) const {
  const std::size_t k = panel_of(x);
  const double a = length_ / static_cast<double>(panels) * static_cast<double>(k);
  if (x == a) return table_->primitive[k];
  const auto arm = [&](double s) { return (x - s) * bed_slope(s); };
  const double moment = x > a ? GaussRule::integrate(arm, a, x) : -GaussRule::integrate(arm, x, a);
  return table_->primitive[k] + table_->elevation[k] * (x - a) + moment;
}

sw::State MacDonald::at(double x, double /*t*/) const {
  require_within("x", x, 0, length_);
  const double h = depth_(x);
  return {h, discharge_ / h};
}

Bed MacDonald::bed() const {
  const MacDonald self = *this;
  return {[self](double x) { return self.elevation(x); }, [self](double x) { return self.primitive(x); }};
}

double MacDonald::uncertainty() const {
  return 1e-12;
}

SelfTest MacDonald::self_test() const {
  // Momentum: the fall of the bed balances the change of q^2/(2 g h^2) + h and the loss by friction.
  const auto friction = [&](double x) {
    const double h = depth_(x);
    return manning_ * manning_ * discharge_ * discharge_ / std::pow(h, 10.0 / 3.0);
  };
  constexpr int parts = 32;
  double loss = 0;
  for (int k = 0; k < parts; ++k) {
    loss +=
        boost::math::quadrature::gauss<double, 30>::integrate(friction, length_ * k / parts, length_ * (k + 1) / parts);
  }
  const auto energy = [&](double x) {
    const double h = depth_(x);
    return elevation(x) + h + discharge_ * discharge_ / (2 * gravity_ * h * h);
  };
  const double fall = energy(0) - energy(length_);
  return {{"the fall of the head is the loss by friction", std::abs(fall - loss) / (std::abs(energy(0)) + loss), 1e-12,
           "the bed is integrated to 1e-12 of its range"}};
}

Provenance MacDonald::provenance() {
  return {
      "MacDonald, Baines, Nichols and Samuels, Analytic benchmark solutions for open-channel flows, J. Hydraul. Eng. "
      "123 "
      "(1997) 1041; Delestre et al., SWASHES (2013), section 3.2",
      "z' = (q^2/(g h^3) - 1) h' - n^2 q^2/h^(10/3)"};
}

static_assert(ReferenceSolution<MacDonald>);

}  // namespace seiche::exact
