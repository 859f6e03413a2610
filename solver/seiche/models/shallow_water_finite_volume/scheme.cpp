#include "seiche/models/shallow_water_finite_volume/scheme.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace seiche::shallow_water_finite_volume {
namespace {

constexpr std::array<std::pair<Scheme, std::string_view>, 4> names{{{Scheme::lax_friedrichs, "lax_friedrichs"},
                                                                    {Scheme::mac_cormack, "mac_cormack"},
                                                                    {Scheme::roe, "roe"},
                                                                    {Scheme::muscl_hll, "muscl_hll"}}};

}  // namespace

std::string_view name(Scheme scheme) {
  for (const auto& [value, text] : names) {
    if (value == scheme) return text;
  }
  throw std::invalid_argument("scheme: not one of the enumerators");
}

Scheme scheme_from(std::string_view name) {
  for (const auto& [value, text] : names) {
    if (text == name) return value;
  }
  throw std::invalid_argument(
      fmt::format("scheme = {} is unknown: must be lax_friedrichs, mac_cormack, roe or muscl_hll", name));
}

}  // namespace seiche::shallow_water_finite_volume
