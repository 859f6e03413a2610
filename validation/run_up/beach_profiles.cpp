#include "validation/run_up/beach_profiles.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <ranges>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/solitary_runup.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

const std::string source = "Synolakis (1987)";
const evidence::Bound benchmark{
    .limit = 0.05,
    .reason = "5 %, the tolerance of analytical benchmarks in Synolakis et al., NOAA Tech. Memo. OAR PMEL-135 (2007)"};

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
          benchmark};
}

BeachClaim each_profile() {
  return {{.id = "analytic-profile-each",
           .text = "Each surface profile from t = 35 to 70 agrees with the exact shallow-water solution.",
           .quantity = "largest rms distance over the range of the profile",
           .source = source},
          benchmark};
}

namespace {

constexpr double farthest_apart = 1;  ///< of submitted points in the mean, in depths or units of time

const std::string profile_table = "synolakis_1987_analytic_profiles";
const std::string gauge_table = "synolakis_1987_analytic_series";

/// Of what tsunami benchmarks allow height and phase together.
evidence::Bound shared() {
  evidence::Bound bound = benchmark;
  bound.limit = bound.limit.value() / std::numbers::sqrt2;
  bound.reason += ", shared in quadrature by height and phase, so that 5 % of either is detected";
  return bound;
}

Profiles exact_gauges(const Values& values) {
  return profiles_of(values, gauge_table, "x_over_d", "t");
}

WantedTable wanted_curves(const Profiles& curves, WantedTable table, const Column& quantity, const std::string& file) {
  const auto kept = std::make_shared<const Profiles>(curves);
  table.groups = each(std::views::keys(curves), std::identity{});
  table.quantities = {{.column = quantity, .reference = [kept](Place p) {
                         const Surface& curve = kept->at(p.group);
                         return linear_at({curve.x, curve.y}, p.abscissa);
                       }}};
  table.points = [kept](double group) { return kept->at(group).x; };
  table.exact = {fmt::format("reference_data/{}/table.csv", file)};
  return table;
}

std::vector<WantedTable> wanted(const Values& values) {
  const Lazy<double> run_up(
      [] { return exact::SolitaryRunup(1, 1, beach_theory_amplitude, beach_cot_slope).highest().elevation; });
  const Column time{"t", "1", "time t sqrt(g/d)"};
  const Column place{"x_over_d", "1", "distance from the shoreline at rest, positive offshore"};
  evidence::Bound near = shared();
  near.expected = to_be_told();
  near.relative = true;
  return {wanted_curves(profiles_of(values, profile_table),
                        {.name = "profiles", .kind = WantedTable::Kind::profile, .group = time, .abscissa = place},
                        {"eta_over_d", "1", "surface elevation; empty, or the beach, where dry"}, profile_table),
          wanted_curves(exact_gauges(values),
                        {.name = "gauges", .kind = WantedTable::Kind::series, .group = place, .abscissa = time},
                        {"gauge_over_d", "1", "surface elevation at a gauge"}, gauge_table),
          {.name = "numbers",
           .quantities = {{.column = {"R_over_d", "1", "maximum shoreline elevation above still water"},
                           .reference = [run_up](Place) { return *run_up; },
                           .requirements = {{.measure = Measure::value,
                                             .criterion = near,
                                             .text = "Maximum run-up agrees with the exact solution within 5 %.",
                                             .source = source}}}},
           .exact = {fmt::format("seiche exact solitary_runup --set amplitude={:g},cot_slope={:g} --integrals",
                                 beach_theory_amplitude, beach_cot_slope)}}};
}

/// Fewer points hide what is between them. A gauge may be dry for a while, and show nothing.
Profiles submitted_curves(const std::vector<SubmittedGroup>& groups, const std::string& column,
                          const std::string& abscissa) {
  Profiles curves;
  for (const SubmittedGroup& group : groups) {
    const double length = group.abscissa.back() - group.abscissa.front();
    const double fewest = std::ceil(length / farthest_apart);
    const auto points = static_cast<double>(group.abscissa.size());
    if (points < fewest) {
      throw std::invalid_argument(
          fmt::format("column {}: {:g} points over {:.3g}, must be at least {:g}", abscissa, points, length, fewest));
    }
    curves[group.value] = {group.abscissa, group.values.at(column)};
  }
  return curves;
}

/// Those of the curves that were submitted; the others are named by a claim of their own.
Profiles among(Profiles curves, const Profiles& own) {
  std::erase_if(curves, [&](const auto& one) { return !own.contains(one.first); });
  return curves;
}

/// rms difference over the rms of the record, at the gauge that is farthest off.
Worst gauge_distance(const Profiles& own, const Profiles& exact) {
  Worst worst;
  for (const auto& [place, series] : exact) {
    const Surface& computed = own.at(place);
    Mean off, size;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const double there = linear_at({computed.x, computed.y}, series.x[i]);
      if (std::isnan(there)) continue;  // how much is covered is a claim of its own
      off.add(there - series.y[i]);
      size.add(series.y[i]);
    }
    worst.add(off.rms() / size.rms(), place);
  }
  return worst;
}

void judge(const Values& values, const Submitted& submitted, const SolverFacts& /*facts*/, evidence::Record& record) {
  const auto check = [&](const BeachClaim& one, double value, const std::string& where) {
    record.check(one.claim, {.value = value, .where = where}, one.bound);
  };
  if (const auto found = submitted.find("profiles"); found != submitted.end()) {
    const Profiles own = submitted_curves(found->second, "eta_over_d", "x_over_d");
    const Differences off = differences(own, among(profiles_of(values, profile_table), own));
    BeachClaim all = all_profiles();
    all.bound = shared();
    check(all, relative_distance(off), {});
    const Worst worst = largest_over_range(off);
    check(each_profile(), worst.value(), fmt::format("t = {:g}", worst.where()));
  } else {
    for (const BeachClaim& one : {all_profiles(), each_profile()})
      record.leave_out({one.claim, "the table was not submitted"});
  }
  BeachClaim gauges{{"gauges", "Surface elevations at the gauges agree with the exact solution.",
                     "largest rms difference over the rms of the record", "1", source},
                    shared()};
  if (const auto found = submitted.find("gauges"); found != submitted.end()) {
    const Profiles own = submitted_curves(found->second, "gauge_over_d", "t");
    const Worst worst = gauge_distance(own, among(exact_gauges(values), own));
    check(gauges, worst.value(), fmt::format("x = {:g}", worst.where()));
  } else {
    record.leave_out({gauges.claim, "the table was not submitted"});
  }
}

}  // namespace

Submission beach_submission() {
  return {.tables = wanted, .judge = judge};
}

}  // namespace seiche::validation
