/// How much a motion of a mesh changes the volumes that its cells have to keep.
#pragma once

#include <vector>

#include "seiche/mechanics/state.hpp"
#include "seiche/samples.hpp"

namespace seiche::verification {

/// Largest rate of a cell's volume, over its volume.
template <class Model>
double largest_relative_rate(Model& model, const mechanics::State& state) {
  model.linearise({}, state.q);
  std::vector<double> rates(model.constraints());
  model.constraint_rates(state.u, rates);
  for (std::size_t s = 0; s < rates.size(); ++s) rates[s] /= model.first_volumes()[s];
  return worst(rates);
}

}  // namespace seiche::verification
