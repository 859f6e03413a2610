/// Identities that every dispersion law satisfies.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

/// The group speed integrates to the frequency: largest relative defect over the eighths of [0, k_highest].
template <class Law>
Identity group_speed_identity(const Law& law, double k_highest) {
  constexpr int intervals = 8;
  Largest defect;
  double sum = 0;
  for (int i = 0; i < intervals; ++i) {
    const double from = k_highest * i / intervals;
    const double to = k_highest * (i + 1) / intervals;
    sum +=
        boost::math::quadrature::gauss<double, 30>::integrate([&](double k) { return law.group_speed(k); }, from, to);
    defect.add(std::abs(sum - law.frequency(to)) / law.frequency(to));
  }
  return {"integral of the group speed over k = frequency", defect.value(),
          4 * std::numeric_limits<double>::epsilon() * std::sqrt(90),
          "30-point Gauss on eighths of the interval resolves the law to round-off; 90 roundings: 38 additions, the "
          "abscissae, weights and values of the points, the frequency"};
}

/// The wavenumber of a frequency has that frequency, for k doubling from `lowest` to `highest`. (The wavenumbers
/// themselves are as much worse known as the group speed is below the phase speed.)
template <class Law>
Identity wavenumber_identity(const Law& law, double lowest, double highest) {
  Worst defect;
  double k = lowest;
  while (k <= highest) {
    const double omega = law.frequency(k);
    defect.add(law.frequency(law.wavenumber(omega)) / omega - 1);
    k *= 2;
  }
  return {"frequency(wavenumber(omega)) = omega", defect.value(), 4e-15, "18 ulp: 15 roundings there and back"};
}

}  // namespace seiche::exact
