#include "seiche/plan_lattice/window.hpp"

#include <stdexcept>

namespace seiche::plan_lattice {

void require_movable(const Window& window, const Sides& sides) {
  if (!window.reach || std::holds_alternative<WallSide>(sides.west) || std::holds_alternative<HeldSide>(sides.west)) {
    return;
  }
  throw std::invalid_argument("a moving window over a west side that is free or driven; allowed: WallSide, HeldSide");
}

}  // namespace seiche::plan_lattice
