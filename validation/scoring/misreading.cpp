#include "validation/scoring/misreading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/parameter.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

using Kind = Misreading::Kind;

constexpr double material = 0.01;     ///< of the reference's range
constexpr double still_there = 0.75;  ///< of the points, after a change
constexpr std::size_t fewest = 10;
constexpr double fitted_handicap = 1.25;

constexpr std::array factors{1000.0,   1 / 1000.0, 100.0,       1 / 100.0, 10.0,
                             1 / 10.0, 3.28084,    1 / 3.28084, 9.81,      1 / 9.81};
constexpr std::array clocks{1000.0, 1 / 1000.0, 100.0, 1 / 100.0, 60.0, 1 / 60.0};

/// What stands at the reference's abscissa x, after a change.
using Changed = std::function<double(double x)>;

struct Compared {
  std::vector<double> x, r;

  /// Root mean square over the points that are known after the change; NaN for less than `needed` of them.
  [[nodiscard]] double rms(const Changed& changed, std::size_t needed) const {
    double sum = 0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double value = changed(x[i]);
      if (std::isnan(value)) continue;
      sum += std::pow(value - r[i], 2);
      ++known;
    }
    return known < needed || known == 0 ? nan : std::sqrt(sum / static_cast<double>(known));
  }
};

/// Where the reference is known, all of it or what the submitted curve covers.
Compared known_points(Curve reference, const std::function<bool(double x)>& covered) {
  Compared points;
  for (std::size_t i = 0; i < reference.x.size(); ++i) {
    if (std::isnan(reference.y[i]) || !covered(reference.x[i])) continue;
    points.x.push_back(reference.x[i]);
    points.r.push_back(reference.y[i]);
  }
  return points;
}
Compared covered_points(Curve submitted, Curve reference) {
  return known_points(reference, [&](double x) { return !std::isnan(linear_at(submitted, x)); });
}

/// Mean of a piecewise linear curve over a stretch about x, cut at its ends.
class Smoothed {
 public:
  explicit Smoothed(Compared points) : points_(std::move(points)), integral_{0} {
    for (std::size_t i = 1; i < points_.x.size(); ++i) {
      integral_.push_back(integral_.back() +
                          0.5 * (points_.x[i] - points_.x[i - 1]) * (points_.r[i] + points_.r[i - 1]));
    }
  }
  [[nodiscard]] double at(double x, double width) const {
    const double from = std::max(x - width / 2, points_.x.front());
    const double to = std::min(x + width / 2, points_.x.back());
    return to > from ? (integral(to) - integral(from)) / (to - from) : linear_at({points_.x, points_.r}, x);
  }

 private:
  [[nodiscard]] double integral(double x) const {
    const auto above = std::upper_bound(points_.x.begin(), points_.x.end() - 1, x) - points_.x.begin();
    const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above, 1)) - 1;
    const double here = linear_at({points_.x, points_.r}, x);
    return integral_[k] + 0.5 * (x - points_.x[k]) * (here + points_.r[k]);
  }

  Compared points_;
  std::vector<double> integral_;
};

/// The number in [-reach, reach] that leaves least; of several that leave nearly the same the one nearest to zero, as
/// periodic curves have. @param left  NaN where it says nothing
double best_near_zero(double reach, const std::function<double(double)>& left) {
  constexpr int grid = 250;
  double best = 0;
  double least = left(0);
  const auto look_at = [&](std::initializer_list<double> candidates, double better) {
    for (const double candidate : candidates) {
      const double here = left(candidate);
      if (std::abs(candidate) > reach || !(here < better * least)) continue;
      best = candidate;
      least = here;
    }
  };
  for (int k = 1; k <= grid; ++k) look_at({reach * k / grid, -reach * k / grid}, 0.98);
  double step = reach / grid;
  for (int halving = 0; halving < 30; ++halving, step /= 2) look_at({best - step, best + step}, 1);
  return best;
}

/// Collects the changes and keeps the best.
class Search {
 public:
  Search(Compared points, double before)
      : points_(std::move(points)),
        before_(before),
        needed_(static_cast<std::size_t>(std::ceil(still_there * static_cast<double>(points_.x.size())))) {}

  [[nodiscard]] double left(const Changed& changed) const { return points_.rms(changed, needed_) / before_; }

  /// @param changed  of the number, whether it is given or fitted
  void given(Kind kind, double amount, const Changed& changed, double handicap = 1) {
    const Misreading candidate{kind, amount, left(changed)};
    if (!(candidate.left < explained_below)) return;  // NaN is no explanation
    if (best_ && handicap * candidate.left >= cost_) return;
    best_ = candidate;
    cost_ = handicap * candidate.left;
  }
  void fitted(Kind kind, double amount, const Changed& changed) { given(kind, amount, changed, fitted_handicap); }

  [[nodiscard]] const Compared& points() const { return points_; }
  [[nodiscard]] std::optional<Misreading> best() const { return best_; }

 private:
  Compared points_;
  double before_;
  std::size_t needed_;
  std::optional<Misreading> best_;
  double cost_ = 0;
};

void try_given(Search& search, Curve submitted) {
  const double both_ends = search.points().x.front() + search.points().x.back();
  for (const double f : factors) search.given(Kind::unit, f, [=](double x) { return linear_at(submitted, x) / f; });
  search.given(Kind::inverted, 0, [=](double x) { return -linear_at(submitted, x); });
  search.given(Kind::backwards, 0, [=](double x) { return linear_at(submitted, both_ends - x); });
}

void try_fitted(Search& search, Curve submitted) {
  const Compared& points = search.points();
  const double first = points.x.front();
  const double range = points.x.back() - first;
  double difference = 0, sum = 0, product = 0, square = 0;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const double s = linear_at(submitted, points.x[i]);
    difference += s - points.r[i];
    sum += points.r[i];
    product += s * points.r[i];
    square += s * s;
  }
  const auto n = static_cast<double>(points.x.size());
  const double level = difference / n;
  search.fitted(Kind::level, level, [=](double x) { return linear_at(submitted, x) - level; });
  if (product > 0) {
    const double f = square / product;
    search.fitted(Kind::scaled, f, [=](double x) { return linear_at(submitted, x) / f; });
  }
  const auto fit = [&](Kind kind, double reach, const std::function<Changed(double)>& changed) {
    const double amount = best_near_zero(reach, [&](double a) { return search.left(changed(a)); });
    search.fitted(kind, amount, changed(amount));
  };
  fit(Kind::shift, range / 4,
      [=](double d) -> Changed { return [=](double x) { return linear_at(submitted, x + d); }; });
  fit(Kind::slow, 0.25, [=](double f) -> Changed {
    return [=](double x) { return linear_at(submitted, first + (1 + f) * (x - first)); };
  });
  // What the reference loses by smoothing is added to the curve.
  fit(Kind::smeared, 0.25, [=, smooth = Smoothed(points), r = points](double w) -> Changed {
    return [=, width = std::abs(w) * range](double x) {
      return linear_at(submitted, x) + linear_at({r.x, r.r}, x) - smooth.at(x, width);
    };
  });
  const double middle = sum / n;
  fit(Kind::dying, 3, [=](double b) -> Changed {
    return [=](double x) { return middle + (linear_at(submitted, x) - middle) * std::exp(b * (x - first) / range); };
  });
}

constexpr double to_five_per_cent = 0.05;

struct KnownUnit {
  double factor;  ///< by which a number in it is larger
  std::string_view unit, words;
};

constexpr std::array known_units{KnownUnit{1000, "m", "millimetres for metres"},
                                 KnownUnit{100, "m", "centimetres for metres"},
                                 KnownUnit{3.28084, "m", "feet for metres"},
                                 KnownUnit{0.001, "m", "kilometres for metres"},
                                 KnownUnit{100, "m/s", "centimetres per second for metres per second"},
                                 KnownUnit{0.001, "Pa", "kilopascals for pascals"},
                                 KnownUnit{0.01, "Pa", "hectopascals for pascals"},
                                 KnownUnit{1000, "s", "milliseconds for seconds"},
                                 KnownUnit{1.0 / 60, "s", "minutes for seconds"}};

std::string unit_name(double factor, const std::string& unit) {
  const auto known = std::ranges::find_if(known_units, [&](const KnownUnit& one) {
    return one.unit == unit && std::abs(factor / one.factor - 1) < to_five_per_cent;
  });
  return known == known_units.end() ? fmt::format("a unit that is {:.6g} times smaller", factor)
                                    : std::string(known->words);
}

}  // namespace

double misfit(Curve submitted, Curve reference) {
  return covered_points(submitted, reference).rms([=](double x) { return linear_at(submitted, x); }, 1);
}

std::string unit_mistaken(double factor, const std::string& unit) {
  const auto off = [&](double known) { return std::abs(factor / known - 1); };
  const double nearest = *std::ranges::min_element(factors, {}, off);
  return off(nearest) < to_five_per_cent ? unit_name(nearest, unit) : "";
}

std::optional<Misreading> misreading(Curve submitted, Curve reference) {
  // An abscissa in another unit covers other points: those of the reference as they are.
  const Compared all = known_points(reference, [](double) { return true; });
  if (all.x.size() < fewest) return std::nullopt;
  const double range = largest(all.r) - smallest(all.r);
  const double before = misfit(submitted, reference);
  if (before <= material * range) return std::nullopt;
  Search clock(all, std::isnan(before) ? range : before);
  for (const double f : clocks) clock.given(Kind::abscissa, f, [=](double x) { return linear_at(submitted, f * x); });
  const Compared points = covered_points(submitted, reference);
  if (points.x.size() < fewest) return clock.best();
  Search search(points, before);
  try_given(search, submitted);
  try_fitted(search, submitted);
  if (!search.best() || (clock.best() && clock.best()->left < search.best()->left)) return clock.best();
  return search.best();
}

std::string Misreading::words(const std::string& unit, const std::string& abscissa_unit) const {
  const double percent = 100 * std::abs(amount);
  switch (kind) {
    case Kind::unit:
      return fmt::format("fits the reference divided by {:.6g}: {}?", amount, unit_name(amount, unit));
    case Kind::inverted:
      return "fits the reference with reversed sign";
    case Kind::backwards:
      return "fits the reference read backwards: its axis points the other way";
    case Kind::abscissa:
      return fmt::format("fits the reference with its abscissa divided by {:.6g}: {}?", amount,
                         unit_name(amount, abscissa_unit));
    case Kind::level:
      return fmt::format("lies {:.3g}{} {} than the reference everywhere: another datum?", std::abs(amount),
                         after_number(unit), amount > 0 ? "higher" : "lower");
    case Kind::shift:
      return fmt::format("fits the reference {:.3g}{} {}: another origin?", std::abs(amount),
                         after_number(abscissa_unit), amount > 0 ? "earlier" : "later");
    case Kind::slow:
      return fmt::format("runs {:.3g} % {} than the reference: it fits with its abscissa divided by {:.5g}", percent,
                         amount > 0 ? "slower" : "faster", 1 + amount);
    case Kind::scaled:
      return fmt::format("fits the reference divided by {:.4g}: its amplitude is wrong", amount);
    case Kind::smeared:
      return fmt::format("is the reference smeared over {:.2g} % of its length: too coarse, or too viscous", percent);
    case Kind::dying:
      return fmt::format("{} along the way: by a factor of {:.3g} from beginning to end",
                         amount > 0 ? "dies away" : "grows", std::exp(-amount));
  }
  return {};
}

}  // namespace seiche::validation
