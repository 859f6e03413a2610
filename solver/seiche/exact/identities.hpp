/// What self-tests are made of: largest defects, integrals, identities that several solutions share.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

/// The largest magnitude of f(i), i = first .. last; NaN if one is.
template <class Function>
double worst(int first, int last, Function f) {
  Worst largest;
  for (int i = first; i <= last; ++i) largest.add(f(i));
  return largest.value();
}

/// Integral by Gauss's rule of so many points on equal panels.
template <int points, class Function>
double integral(Function f, double from, double to, int panels) {
  double sum = 0;
  for (int k = 0; k < panels; ++k) {
    sum += boost::math::quadrature::gauss<double, points>::integrate(f, from + (to - from) * k / panels,
                                                                     from + (to - from) * (k + 1) / panels);
  }
  return sum;
}

/// What nothing but the time steps changes, over the amplitude.
/// @param tolerance  of a step of a pair of fourth and fifth order, over the amplitude
/// @param times      2 of a square
inline Identity kept_by_steps(const std::string& name, double defect, double steps, double tolerance,
                              double times = 1) {
  return {name, defect, times * steps * std::pow(tolerance, 1.2),
          fmt::format("{:g} steps whose errors of fourth order are kept at {:.2g} of the amplitude and add up; the "
                      "solution of fifth order that is carried on errs less by a step, the fifth root of that; {} "
                      "times as much",
                      steps, tolerance, times)};
}

/// The group speed integrates to the frequency: largest relative defect over the eighths of [0, k_highest].
template <class Law>
Identity group_speed_identity(const Law& law, double k_highest) {
  double sum = 0;
  const double defect = worst(1, 8, [&](int i) {
    const double to = k_highest * i / 8;
    sum += integral<30>([&](double k) { return law.group_speed(k); }, k_highest * (i - 1) / 8, to, 1);
    return sum / law.frequency(to) - 1;
  });
  return {"integral of the group speed over k = frequency", defect, 4 * epsilon * std::sqrt(90),
          "30-point Gauss on eighths of the interval resolves the law to round-off; 90 roundings: 38 additions, the "
          "abscissae, weights and values of the points, the frequency"};
}

/// The wavenumber of a frequency has that frequency, for k doubling from `lowest` to `highest`. (The wavenumbers
/// themselves are as much worse known as the group speed is below the phase speed.)
template <class Law>
Identity wavenumber_identity(const Law& law, double lowest, double highest) {
  Worst defect;
  for (double k = lowest; k <= highest; k *= 2) {
    const double omega = law.frequency(k);
    defect.add(law.frequency(law.wavenumber(omega)) / omega - 1);
  }
  return {"frequency(wavenumber(omega)) = omega", defect.value(), 4e-15, "18 ulp: 15 roundings there and back"};
}

}  // namespace seiche::exact
