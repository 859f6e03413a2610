#include "validation/studies/wcsph/sound_rule.hpp"

#include <variant>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

/// Sound speed of the second run over the largest speed of the first.
constexpr double enough = 12.5;

}  // namespace

Parameter sound_rule(const std::string& given) {
  return choice("sound_from", std::string("largest_speed"), {"largest_speed", given},
                fmt::format("largest_speed: 12.5 times that of a first run with the sound speed of {0}; {0}: given by "
                            "the parameter sound",
                            given));
}

bool by_sound_rule(const Values& values) {
  return values.text("sound_from") == "largest_speed";
}

wcsph::Settings with_sound_for(wcsph::Settings settings, double largest_speed) {
  const double before = settings.sound_speed;
  settings.sound_speed = enough * largest_speed;
  if (auto* artificial = std::get_if<wcsph::ArtificialViscosity>(&settings.viscosity)) {
    artificial->alpha *= before / settings.sound_speed;
  }
  return settings;
}

}  // namespace seiche::validation
