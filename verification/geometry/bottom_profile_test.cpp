// Bottom profiles: elevations, slopes, and exact means over intervals of any length.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "verification/check.hpp"

namespace seiche::verification::bottom_profile_test {

const std::vector<double> knots = {-10, -6.5, -6.4, -3, -2.9, 0, 4, 10};
const std::vector<double> heights = {-1, -1.4, -0.3, -0.3, -1.9, 0, 0.5, 0.2};

/// A bottom, where it may be asked, its corners, and how long intervals may be.
struct Profile {
  std::string id;
  std::shared_ptr<const BottomProfile> bottom;
  std::vector<double> corners = {};
  double longest = 10;
};

double wave(double x) {
  return -1 + 0.4 * std::sin(1.3 * x) - 0.1 * std::exp(-x * x / 8);
}
double wave_slope(double x) {
  return 0.52 * std::cos(1.3 * x) + 0.025 * x * std::exp(-x * x / 8);
}

std::vector<Profile> profiles() {
  return {{"level", std::make_shared<LevelBottom>(1.25)},
          {"broken", std::make_shared<PiecewiseLinearBottom>(knots, heights), knots},
          {"cosine", std::make_shared<CosineBottom>(1, 0.7, 1.1, 0.4)},
          {"smooth", std::make_shared<SmoothBottom>(wave, wave_slope, -10, 10), {}, 0.5}};
}

/// Mean of a function over an interval by Gauss's rule between corners, on pieces no longer than a half.
double quadrature_mean(const Profile& profile, double from, double to, const std::function<double(double)>& f) {
  const double left = std::min(from, to), right = std::max(from, to);
  if (left == right) return f(left);
  std::vector<double> ends = {left, right};
  for (const double corner : profile.corners) {
    if (corner > left && corner < right) ends.push_back(corner);
  }
  for (double x = std::ceil(2 * left) / 2; x < right; x += 0.5) {
    if (x > left) ends.push_back(x);
  }
  std::ranges::sort(ends);
  double mean = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    mean += boost::math::quadrature::gauss<double, 15>::integrate(f, ends[k - 1], ends[k]) / (right - left);
  }
  return mean;
}

struct Interval {
  double from, to;
};

/// Lengths from 1e-12 to the longest, a third of them about a corner, half of them from right to left.
std::vector<Interval> intervals(const Profile& profile, int count) {
  std::minstd_rand random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Interval> result;
  for (int k = 0; k < count; ++k) {
    const double length = std::pow(10, between(-12, std::log10(profile.longest)));
    double from = between(-10, 10 - length);
    if (!profile.corners.empty() && k % 3 == 0) {
      const auto corner = static_cast<std::size_t>(k) % profile.corners.size();
      from = std::clamp(profile.corners[corner] - length * between(0, 1), -10.0, 10 - length);
    }
    const double to = std::min(from + length, 10.0);
    result.push_back(k % 2 == 0 ? Interval{from, to} : Interval{to, from});
  }
  return result;
}

TEST_CASE("means of a bottom and of its square are exact over any interval", "[geometry]") {
  Check check("bottom_profile", "Means of a bottom over an interval",
              "Models that conserve volume and energy to round-off need the means of $b$ and $b^2$ over cells and over "
              "the displacement of a node in a step, which may be $10^{-12}$ long, may cross corners, and may be run "
              "from right to left. Compared with Gauss's rule of 15 points between corners; the steepest slope of the "
              "broken bottom is 16; a rounded position there is an error of the height.");
  for (const Profile& profile : profiles()) {
    const BottomProfile& bottom = *profile.bottom;
    const bool broken = profile.id == "broken";
    Worst mean, square;
    Largest additive;
    long one_sided = 0;
    for (const auto [from, to] : intervals(profile, 3000)) {
      const auto b = [&](double x) { return bottom.elevation(x); };
      const auto b2 = [&](double x) { return bottom.elevation(x) * bottom.elevation(x); };
      mean.add(bottom.mean(from, to) - quadrature_mean(profile, from, to, b));
      square.add(bottom.mean_square(from, to) - quadrature_mean(profile, from, to, b2));
      const double middle = from + 0.3 * (to - from);
      const double parts = (middle - from) * bottom.mean(from, middle) + (to - middle) * bottom.mean(middle, to);
      additive.add(std::abs((to - from) * bottom.mean(from, to) - parts) / std::abs(to - from));
      one_sided += bottom.mean(from, to) != bottom.mean(to, from) ? 1 : 0;
      one_sided += bottom.mean_square(from, to) != bottom.mean_square(to, from) ? 1 : 0;
    }
    const double steepest = broken ? 16 : profile.id == "level" ? 0 : 1;
    const auto claim = [&](const std::string& text, double value, double height, double slope) {
      check.holds(
          text + " (" + profile.id + ")", {value},
          Roundoff{
              (broken ? 70.0 : 10.0) + std::pow(10 * slope / 2, 2), height,
              "ten roundings per piece of heights up to 2, and one of a position up to 10, times the slope an error of "
              "the height; squares add up. Of a broken bottom all means are taken at the same positions"});
    };
    INFO(profile.id);
    CHECK(one_sided == 0);  // from right to left is the same to the last bit, except by Gauss's rule
    claim("The mean elevation of the bottom equals quadrature.", mean.value(), 2, steepest);
    claim("The mean square elevation of the bottom equals quadrature.", square.value(), 8, steepest);
    claim("Means over two parts make the mean over the whole.", additive.value(), 2, broken ? 0 : steepest);
  }
}

TEST_CASE("the mean over an interval of length zero is the elevation", "[geometry]") {
  for (const Profile& profile : profiles()) {
    const BottomProfile& bottom = *profile.bottom;
    std::vector<double> places = {-10, -6.45, -3.3, 0, 1.7, 10};
    places.insert(places.end(), profile.corners.begin(), profile.corners.end());
    for (const double x : places) {
      INFO(profile.id << " at " << x);
      const double b = bottom.elevation(x);
      const double roundoff = profile.id == "smooth" ? 4e-16 : 0;  // Gauss's weights add up to 2 to round-off
      CHECK(std::abs(bottom.mean(x, x) - b) <= roundoff);
      CHECK(std::abs(bottom.mean_square(x, x) - b * b) <= 4e-16 * std::max(1.0, b * b));
    }
  }
}

TEST_CASE("elevations of many positions equal elevations of single positions, across any number of corners",
          "[geometry]") {
  for (const Profile& profile : profiles()) {
    std::vector<double> x;
    for (int k = 0; k <= 4000; ++k) x.push_back(-10 + 0.005 * k);
    x.back() = 10;
    x.insert(x.end(), profile.corners.begin(), profile.corners.end());
    std::sort(x.begin(), x.end());
    std::vector<double> elevation(x.size()), slope(x.size());
    profile.bottom->sample(x, elevation, slope);
    long different = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      different += elevation[i] != profile.bottom->elevation(x[i]) || slope[i] != profile.bottom->slope(x[i]) ? 1 : 0;
    }
    INFO(profile.id);
    CHECK(different == 0);
  }
}

TEST_CASE("slopes are derivatives, at a corner from the right side", "[geometry]") {
  const PiecewiseLinearBottom broken(knots, heights);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const std::size_t piece = std::min(k, knots.size() - 2);
    CHECK(broken.slope(knots[k]) == (heights[piece + 1] - heights[piece]) / (knots[piece + 1] - knots[piece]));
    CHECK(broken.elevation(knots[k]) == Approx(heights[k]).margin(4e-16));
  }
  CHECK(broken.elevation(0) == 0);  // a shoreline at a corner is exactly at the still-water level
  const CosineBottom cosine(1, 0.7, 1.1, 0.4);
  constexpr double step = 1e-5;  // error of the difference: step^2/6 b''' and round-off/step
  for (const double x : {-7.0, -0.3, 0.0, 2.2, 9.0}) {
    CHECK(cosine.slope(x) ==
          Approx((cosine.elevation(x + step) - cosine.elevation(x - step)) / (2 * step)).margin(1e-10));
  }
}

TEST_CASE("a slope is reported as uniform only if it is", "[geometry]") {
  const PiecewiseLinearBottom broken(knots, heights);
  CHECK(broken.uniform_slope(-9, -7) == broken.slope(-8));
  CHECK(broken.uniform_slope(-7, -9) == broken.slope(-8));
  CHECK(broken.uniform_slope(-6.4, -6.4) == 0.0);
  CHECK(broken.uniform_slope(-6, -4) == 0.0);
  CHECK(broken.uniform_slope(4, 10) == broken.slope(10));
  // At a corner the slope is that of its right side.
  for (const auto& [from, to] : {Interval{-9, -6.45}, {-9, 9}, {-1, 0}}) CHECK_FALSE(broken.uniform_slope(from, to));
  CHECK(LevelBottom(1).uniform_slope(-1e9, 1e9) == 0.0);
  CHECK_FALSE(CosineBottom(1, 0.1, 1).uniform_slope(0, 1).has_value());
  CHECK_FALSE(SmoothBottom(wave, wave_slope, -10, 10).uniform_slope(0, 1).has_value());
}

TEST_CASE("a bottom rejects positions outside its extent, naming position and extent", "[geometry]") {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const PiecewiseLinearBottom broken(knots, heights);
  const SmoothBottom smooth(wave, wave_slope, -10, 10);
  for (const BottomProfile* bottom : std::initializer_list<const BottomProfile*>{&broken, &smooth}) {
    CHECK(bottom->begin() == -10);
    CHECK(bottom->end() == 10);
    CHECK_NOTHROW(bottom->elevation(-10));
    CHECK_NOTHROW(bottom->elevation(10));
    for (const double x : {-10.001, 10.001, not_a_number}) {
      CHECK_THROWS_AS(bottom->elevation(x), Infeasible);
      CHECK_THROWS_AS(bottom->slope(x), Infeasible);
      for (const auto& [from, to] : {Interval{0, x}, {x, 0}}) {
        CHECK_THROWS_AS(bottom->mean(from, to), Infeasible);
        CHECK_THROWS_AS(bottom->mean_square(from, to), Infeasible);
        CHECK_THROWS_AS(bottom->uniform_slope(from, to), Infeasible);
      }
    }
  }
  CHECK_THROWS_WITH(broken.elevation(12.5), Catch::Contains("12.5") && Catch::Contains("[-10, 10]"));
  CHECK_THROWS_MATCHES(broken.elevation(12.5), Infeasible,
                       Catch::Predicate<Infeasible>([](const Infeasible& at) { return at.place() == 12.5; }));
}

}  // namespace seiche::verification::bottom_profile_test
