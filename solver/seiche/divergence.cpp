#include "seiche/divergence.hpp"

#include <fmt/format.h>

namespace seiche {

Divergence::Divergence(const std::string& quantity, double time, long step, double place)
    : std::runtime_error(fmt::format("{} at x = {:.6g}, t = {:.6g}, after {} steps", quantity, place, time, step)),
      time_(time),
      step_(step),
      place_(place) {}

}  // namespace seiche
