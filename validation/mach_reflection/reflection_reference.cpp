#include "validation/mach_reflection/reflection_reference.hpp"

namespace seiche::validation {

std::vector<KnownReflection> known_reflections(const Values& values) {
  const io::Table table = values.table("mach_reflection_model2");
  std::vector<KnownReflection> all;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto at = [&](const char* column) { return table.column(column)[k]; };
    all.push_back({at("a_nominal"), at("psi_i_deg"), at("aw_over_ai"), at("ar_over_ai"), at("psi_r_deg"),
                   at("stem_angle_deg"), at("rel_growth_last_20pct")});
  }
  return all;
}

}  // namespace seiche::validation
