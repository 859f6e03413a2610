#include "seiche/mechanics/scheme.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace seiche::mechanics {

Stepping stepping_named(std::string_view name) {
  if (name == "one_step") return Stepping::one_step;
  if (name == "one_step_feedback") return Stepping::one_step_feedback;
  if (name == "conservative") return Stepping::conservative;
  throw std::invalid_argument(fmt::format("scheme = \"{}\"; allowed: one_step, one_step_feedback, conservative", name));
}

TimeComposition composition_named(std::string_view name) {
  if (name == "none") return TimeComposition::none;
  if (name == "triple_jump") return TimeComposition::triple_jump;
  if (name == "suzuki") return TimeComposition::suzuki;
  throw std::invalid_argument(fmt::format("composition = \"{}\"; allowed: none, triple_jump, suzuki", name));
}

}  // namespace seiche::mechanics
