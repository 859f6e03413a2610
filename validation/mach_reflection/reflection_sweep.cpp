#include "validation/mach_reflection/reflection_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/on_threads.hpp"

namespace seiche::validation {

const Reflection& ReflectionSeries::highest() const {
  Largest ratio;
  for (std::size_t k = 0; k < reflections.size(); ++k) {
    ratio.add(reflections[k].wall_ratio().value, static_cast<double>(k));
  }
  return reflections.at(static_cast<std::size_t>(ratio.where()));
}

double ReflectionSeries::regular_ratio() const {
  Largest ratio;
  for (const Reflection& reflection : reflections) {
    if (reflection.pattern.reflected) ratio.add(reflection.reflected_ratio().value);
  }
  return ratio.value() > regular_from ? regular_from : regular_from_largest * ratio.value();
}

Measurement ReflectionSeries::boundary() const {
  const double regular = regular_ratio();
  for (std::size_t k = 1; k < reflections.size(); ++k) {
    const Measurement below = reflections[k - 1].reflected_ratio();
    const Measurement above = reflections[k].reflected_ratio();
    if (!(below.value < regular && above.value >= regular)) continue;
    const double slope = (above.value - below.value) / (angles[k] - angles[k - 1]);
    const double scatter = largest(std::array{below.half_width(), above.half_width()}) / slope;
    return {.value = angles[k - 1] + (regular - below.value) / slope,
            .uncertainty = std::min(scatter, angles[k] - angles[k - 1]),
            .resolution = fmt::format("h = {:g}, between {:g} and {:g} deg", spacing, angles[k - 1], angles[k])};
  }
  return {};
}

double resonant_angle(double amplitude) {
  const double s = std::sqrt(3 * amplitude);
  return degrees(std::asin((std::sqrt(1 + 4 * s * s) - 1) / (2 * s)));
}

AngleLaw angle_law(const ReflectionSeries& series, double last) {
  std::vector<double> square, amplitude;
  for (std::size_t k = 0; k < series.angles.size(); ++k) {
    const Reflection& reflection = series.reflections[k];
    if (series.angles[k] > last || !reflection.pattern.reflected) continue;
    square.push_back(reflection.run.angle * reflection.run.angle);
    amplitude.push_back(reflection.pattern.reflected->amplitude.value);
  }
  if (square.size() < 3) throw std::invalid_argument("a law of the angle needs three reflected waves or more");
  const double squares = std::inner_product(square.begin(), square.end(), square.begin(), 0.0);
  AngleLaw law{.factor = std::inner_product(amplitude.begin(), amplitude.end(), square.begin(), 0.0) / squares};
  double left = 0;
  Worst largest_residual;
  for (std::size_t k = 0; k < square.size(); ++k) {
    const double residual = amplitude[k] - law.factor * square[k];
    left += residual * residual;
    largest_residual.add(residual / amplitude[k]);
  }
  law.largest_residual = largest_residual.value();
  law.uncertainty = 2 * std::sqrt(left / static_cast<double>(square.size() - 1) / squares);
  return law;
}

void sweep(const Run& run, std::vector<ReflectionSeries>& series, double time) {
  struct Task {
    Reflection* reflection;
    double cost;
  };
  std::vector<Task> tasks;
  double all = 0;
  for (ReflectionSeries& one : series) {
    one.reflections.assign(one.angles.size(), Reflection{});
    for (std::size_t k = 0; k < one.angles.size(); ++k) {
      ReflectionRun& what = one.reflections[k].run;
      what = {.amplitude = one.amplitude, .angle = radians(one.angles[k]), .spacing = one.spacing, .time = time};
      // Cells in a window of so many width units across go like 1/(a h^2).
      tasks.push_back(
          {&one.reflections[k], what.duration() / what.tau() / (one.amplitude * one.spacing * one.spacing)});
      all += tasks.back().cost;
    }
  }
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.cost > b.cost; });
  on_threads(
      tasks.size(), workers_of(run.tier()),
      [&](std::size_t k) {
        Reflection& reflection = *tasks[k].reflection;
        reflection = reflect_as_part(run, ReflectionRun(reflection.run));
      },
      [&](std::size_t finished) {
        double done = 0;
        for (std::size_t k = 0; k < finished; ++k) done += tasks[k].cost / all;
        run.progress(done);
      });
}

}  // namespace seiche::validation
