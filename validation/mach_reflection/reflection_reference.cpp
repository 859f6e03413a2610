#include "validation/mach_reflection/reflection_reference.hpp"

#include <algorithm>
#include <cmath>

#include "validation/case/reference_source.hpp"

namespace seiche::validation {
namespace {

bool is_this(const KnownReflection& one, double amplitude, double angle) {
  return std::abs(one.amplitude - amplitude) < 1e-9 && std::abs(one.angle - angle) < 1e-6;
}

}  // namespace

std::vector<KnownReflection> known_reflections(const Values& values) {
  const io::Table table = values.table(known_reflections_table);
  const ReferenceSource source = reference_source(known_reflections_table);
  const auto known = [&](const std::string& column, std::size_t row) {
    const double value = table.column(column)[row];
    return Known{.value = value, .uncertainty = source.standard_uncertainty.at(column).of(value)};
  };
  std::vector<KnownReflection> all;
  for (std::size_t k = 0; k < table.column("a_nominal").size(); ++k) {
    KnownReflection one{.amplitude = table.column("a_nominal")[k],
                        .angle = table.column("psi_i_deg")[k],
                        .end = table.column("t_end")[k],
                        .wall_ratio = known("aw_over_ai", k),
                        .reflected_ratio = known("ar_over_ai", k),
                        .reflected_angle = known("psi_r_deg", k),
                        .stem_angle = known("stem_angle_deg", k),
                        .growth = table.column("rel_growth_last_20pct")[k]};
    const double growing = std::abs(one.growth) * one.wall_ratio.value;
    if (growing > one.wall_ratio.uncertainty) one.wall_ratio.uncertainty = growing;
    if (is_this(one, 0.097, 16)) {
      one.reflected_angle.doubt = evidence::KnownFailure{.value = 1.87,  // 1.6 deg over 0.6 deg, stated and ours
                                                         .width = 0.1,
                                                         .reason =
                                                             "the reference's 29.30 deg lies 1.6 deg off the line "
                                                             "through its own next rows (27.07 at 20 deg, 26.48 at 24 "
                                                             "deg), and its incident amplitude, 1 % above theirs, had "
                                                             "not settled; ours is the same at t = 748 and t = "
                                                             "1300"};
    }
    all.push_back(one);
  }
  return all;
}

std::optional<KnownReflection> known_reflection(const std::vector<KnownReflection>& all, double amplitude,
                                                double angle) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const KnownReflection& one) { return is_this(one, amplitude, angle); });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

evidence::Measurement wall_ratio_until(const Reflection& reflection, double time) {
  evidence::Measurement ratio = reflection.wall_ratio();
  ratio.value *= reflection.wall_at(time) / reflection.wall.back();
  return ratio;
}

}  // namespace seiche::validation
