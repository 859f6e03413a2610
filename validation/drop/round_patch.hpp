/// The square |xi|, |eta| <= 1 mapped on the disc of radius 1, by which meshes of squares become those of a round drop.
#pragma once

#include <cmath>
#include <vector>

namespace seiche::validation {

/// x = xi sqrt(1 - eta^2/2), y = eta sqrt(1 - xi^2/2): the four corners get a straight angle on the outline.
inline void make_round(std::vector<double>& x, std::vector<double>& y) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double xi = x[k];
    const double eta = y[k];
    x[k] = xi * std::sqrt(1 - eta * eta / 2);
    y[k] = eta * std::sqrt(1 - xi * xi / 2);
  }
}

}  // namespace seiche::validation
