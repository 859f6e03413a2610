#include "seiche/models/wcsph/particles.hpp"

#include <algorithm>

namespace seiche::wcsph {

void Particles::add(double x_, double z_, double mass_, double density_, Kind kind_, double u_, double w_,
                    std::int32_t body_) {
  identity.push_back(static_cast<std::int32_t>(size()));
  x.push_back(x_);
  z.push_back(z_);
  u.push_back(u_);
  w.push_back(w_);
  density.push_back(density_);
  mass.push_back(mass_);
  kind.push_back(kind_);
  body.push_back(body_);
}

std::size_t Particles::count(Kind wanted) const {
  return static_cast<std::size_t>(std::count(kind.begin(), kind.end(), wanted));
}

}  // namespace seiche::wcsph
