#include "seiche/models/wcsph/kernel.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace seiche::wcsph {

KernelName kernel_named(std::string_view name) {
  for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
    if (name == name_of(kernel)) return kernel;
  }
  throw std::invalid_argument(
      fmt::format(R"(kernel = "{}" does not exist: must be "cubic_spline" or "wendland_c2")", name));
}

std::string_view name_of(KernelName kernel) {
  return kernel == KernelName::cubic_spline ? "cubic_spline" : "wendland_c2";
}

}  // namespace seiche::wcsph
