#include "validation/run_up/beach_profiles.hpp"

#include <cmath>

#include "validation/instruments/agreement.hpp"

namespace seiche::validation {
namespace {

const std::string source = "Synolakis (1987)";

evidence::Bound benchmark() {
  return {.limit = 0.05,
          .reason =
              "5 %, the tolerance of analytical benchmarks in Synolakis et al., NOAA Tech. Memo. OAR PMEL-135 (2007)"};
}

}  // namespace

Profiles profiles_of(const Values& values, const std::string& name, const std::string& group,
                     const std::string& abscissa) {
  const io::Table table = values.table(name);
  Profiles profiles;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    Surface& surface = profiles[table.column(group)[k]];
    surface.x.push_back(table.column(abscissa)[k]);
    surface.y.push_back(table.column("eta_over_d")[k]);
  }
  return profiles;
}

Difference difference(const Surface& model, const Surface& reference, double scale) {
  Difference result;
  for (std::size_t k = 0; k < reference.x.size(); ++k) {
    const double x = reference.x[k];
    if (x > model.x.back()) continue;  // farther offshore than the surface is tabulated
    const bool dry = x < model.x.front();
    if (dry) ++result.dry;
    const double y = dry ? -x / beach_cot_slope : scale * linear_at({model.x, model.y}, x);
    result.off.add(y - reference.y[k]);
    result.size.add(reference.y[k]);
  }
  result.range = largest(reference.y) - smallest(reference.y);
  return result;
}

Differences differences(const Profiles& model, const Profiles& reference) {
  Differences found;
  for (const auto& [t, surface] : reference) {
    found[t] = model.contains(t) ? difference(model.at(t), surface) : Difference{};
  }
  return found;
}

double relative_distance(const Differences& profiles) {
  double square = 0;
  double scale = 0;
  for (const auto& [t, d] : profiles) {
    const auto points = static_cast<double>(d.off.count());
    square += points * d.off.rms() * d.off.rms();
    scale += points * d.size.rms() * d.size.rms();
  }
  return std::sqrt(square / scale);
}

Worst largest_over_range(const Differences& profiles) {
  Worst worst;
  for (const auto& [t, d] : profiles) worst.add(d.off.rms() / d.range, t);
  return worst;
}

BeachClaim all_profiles() {
  return {{"analytic-profiles",
           "The surface profiles from t = 35 to 70 agree together with the exact shallow-water solution within 5 %.",
           "rms distance over rms elevation, all points of all profiles", "1", source},
          benchmark()};
}

BeachClaim each_profile() {
  return {{.id = "analytic-profile-each",
           .text = "Each surface profile from t = 35 to 70 agrees with the exact shallow-water solution.",
           .quantity = "largest rms distance over the range of the profile",
           .source = source},
          benchmark()};
}

}  // namespace seiche::validation
