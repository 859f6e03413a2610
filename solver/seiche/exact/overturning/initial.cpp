#include "seiche/exact/overturning/initial.hpp"

#include <cmath>

namespace seiche::exact::overturning {

State from_functions(std::size_t markers, const std::function<double(double)>& elevation,
                     const std::function<double(double)>& potential) {
  State state = still_water(markers);
  const auto surface = view(state);
  for (std::size_t j = 0; j < markers; ++j) {
    surface.y[j] = elevation(label(j, markers));
    surface.potential[j] = potential(label(j, markers));
  }
  return state;
}

State sinusoidal_wave(std::size_t markers, double amplitude, double depth) {
  const auto elevation = [&](double x) { return amplitude * std::cos(x); };
  return from_functions(markers, elevation, [&](double x) {
    const double y = elevation(x);
    // cosh(y + h)/cosh(h) without overflow in deep water.
    const double decay = (std::exp(y) + std::exp(-y - 2 * depth)) / (1 + std::exp(-2 * depth));
    return amplitude / std::sqrt(std::tanh(depth)) * decay * std::sin(x);
  });
}

}  // namespace seiche::exact::overturning
