#include "validation/instruments/error_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "seiche/samples.hpp"

namespace seiche::shallow_water {

namespace {

constexpr int parts = 8;
// Gauss-Legendre, 4 points on [0, 1].
constexpr std::array<double, 4> points = {0.06943184420297371, 0.33000947820757187, 0.6699905217924281,
                                          0.9305681557970263};
constexpr std::array<double, 4> weights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                           0.17392742256872693};

// Calls visit(x, weight) at quadrature points of [left, right], split at the sorted `breaks`.
template <class Visit>
void quadrature(double left, double right, const std::vector<double>& breaks, Visit visit) {
  auto next = std::upper_bound(breaks.begin(), breaks.end(), left);
  double start = left;
  while (start < right) {
    const double stop = next != breaks.end() && *next < right ? *next++ : right;
    const double width = (stop - start) / parts;
    for (int part = 0; part < parts; ++part) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        visit(start + (part + points[k]) * width, weights[k] * width);
      }
    }
    start = stop;
  }
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

class Accumulator {
 public:
  void add(double error, double weight) {
    absolute_ += weight * std::abs(error);
    squares_ += weight * error * error;
    worst_.add(error);
  }
  [[nodiscard]] Norms over(double length) const {
    return {absolute_ / length, std::sqrt(squares_ / length), worst_.value()};
  }

 private:
  double absolute_ = 0;
  double squares_ = 0;
  Worst worst_;
};

template <class Computed>
ProfileError pointwise_error(const MeasuredProfile& profile, const ExactProfile& exact, std::vector<double> breaks,
                             Computed computed) {
  breaks = sorted(std::move(breaks));
  Accumulator depth;
  Accumulator velocity;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    quadrature(profile.edges[i], profile.edges[i + 1], breaks, [&](double x, double weight) {
      const State reference = exact(x);
      const State here = computed(i, x);
      depth.add(here.depth - reference.depth, weight);
      if (reference.depth > 0) velocity.add(here.velocity - reference.velocity, weight);
    });
  }
  const double length = profile.edges.back() - profile.edges.front();
  return {depth.over(length), velocity.over(length)};
}

}  // namespace

ProfileError cell_error(const MeasuredProfile& profile, const ExactProfile& exact, const std::vector<double>& breaks) {
  const std::vector<double> ordered = sorted(breaks);
  Accumulator depth;
  Accumulator velocity;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    const double width = profile.edges[i + 1] - profile.edges[i];
    double mass = 0;
    double momentum = 0;
    quadrature(profile.edges[i], profile.edges[i + 1], ordered, [&](double x, double weight) {
      const State reference = exact(x);
      mass += weight * reference.depth;
      momentum += weight * reference.depth * reference.velocity;
    });
    depth.add(profile.means[i].depth - mass / width, width);
    if (mass > 0) velocity.add(profile.means[i].velocity - momentum / mass, width);
  }
  const double length = profile.edges.back() - profile.edges.front();
  return {depth.over(length), velocity.over(length)};
}

ProfileError piecewise_constant_error(const MeasuredProfile& profile, const ExactProfile& exact,
                                      const std::vector<double>& breaks) {
  return pointwise_error(profile, exact, breaks, [&](std::size_t i, double) { return profile.means[i]; });
}

ProfileError reconstruction_error(const MeasuredProfile& profile, const ExactProfile& exact,
                                  const std::vector<double>& breaks) {
  if (!profile.reconstruction) throw std::invalid_argument("profile: a reconstruction must be given");
  std::vector<double> all = breaks;
  all.insert(all.end(), profile.breaks.begin(), profile.breaks.end());
  return pointwise_error(profile, exact, std::move(all),
                         [&](std::size_t, double x) { return profile.reconstruction(x); });
}

int jump_width(const MeasuredProfile& profile, double behind, double ahead, double from, double to) {
  int width = 0;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    if (profile.edges[i + 1] <= from || profile.edges[i] >= to) continue;
    const double fraction = (profile.means[i].depth - ahead) / (behind - ahead);
    if (fraction > 0.05 && fraction < 0.95) ++width;
  }
  return width;
}

double jump_position(const MeasuredProfile& profile, double behind, double ahead, double from, double to) {
  double start = 0;
  double stop = 0;
  double volume = 0;
  bool any = false;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    if (profile.edges[i + 1] <= from || profile.edges[i] >= to) continue;
    if (!any) start = profile.edges[i];
    any = true;
    stop = profile.edges[i + 1];
    volume += profile.means[i].depth * (stop - profile.edges[i]);
  }
  if (!any) throw std::invalid_argument("jump_position: no cell between the given positions");
  return start + (volume - ahead * (stop - start)) / (behind - ahead);
}

}  // namespace seiche::shallow_water
