#include "validation/laboratory/laboratory_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <boost/math/distributions/binomial.hpp>

#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/fine_limit.hpp"

namespace seiche::validation::laboratory {
namespace {

constexpr std::size_t most_panels = 10;
constexpr long draws = 200;

using Curves = std::map<std::string, std::vector<Measured>>;

/// The measured records times a factor with one draw of everything that is not known of them, as verdicts.hpp has it:
/// one incident amplitude, one clock per part that has no other, for a gauge half of the variance in its calibration
/// and half slowly varying, between independent values a tenth of what is judged apart, for a profile value and
/// abscissa of each point.
Submitted drawn(const Experiment& experiment, const Curves& curves, double factor,
                const std::function<double()>& normal) {
  Submitted records;
  const double amplitude = normal();
  for (const Series& part : experiment.parts) {
    const double clock = part.clock ? 0 : normal();
    for (const Measured& curve : curves.at(part.name)) {
      Smallest first;
      Largest last;
      for (const Reading& reading : part.readings) {
        first.add(std::max(reading.window.from, curve.x.front()));
        last.add(std::min(reading.window.to, curve.x.back()));
      }
      const bool gauge = part.kind == WantedTable::Kind::series;
      const double calibration = normal();
      constexpr std::size_t tenths = 10;
      std::array<double, tenths + 1> slow{};
      std::ranges::generate(slow, normal);
      SubmittedGroup record{.value = curve.group, .abscissa = curve.x};
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double place = gauge ? tenths * (curve.x[i] - first.value()) / (last.value() - first.value()) : 0;
        const auto k = static_cast<std::size_t>(std::clamp(place, 0.0, tenths - 1e-9));
        const double on = std::clamp(place - static_cast<double>(k), 0.0, 1.0);
        const double varying = std::lerp(slow.at(k), slow.at(k + 1), on) / std::hypot(on, 1 - on);
        const double noise = gauge ? (calibration + varying) / std::numbers::sqrt2 : normal();
        const double off = gauge ? 0 : normal() * curve.u_x;
        const double y = linear_at(curve.curve(), std::clamp(curve.x[i] - off, curve.x.front(), curve.x.back()));
        record.values[part.quantity.name].push_back((factor + amplitude * part.input) * y + noise * curve.u[i]);
        if (gauge) record.abscissa[i] += clock * curve.u_x;
      }
      records[part.name].push_back(std::move(record));
    }
  }
  return records;
}

/// What the measured records decide, as judged: on their clock, with nothing of numerical uncertainty.
Computed told_by_data(const Experiment& experiment, const Values& values, const std::vector<Question>& all) {
  Curves curves;
  for (const Series& part : experiment.parts) curves[part.name] = measured(part, values);
  const auto passes = [&](double factor, const std::function<double()>& normal) {
    std::map<std::string, double> unused;
    Submitted records = on_the_clock(experiment, values, drawn(experiment, curves, factor, normal), unused);
    for (auto& [part, groups] : records) {
      for (std::size_t g = 0; g < groups.size(); ++g) {  // a clock moves no end of a record into what is judged
        std::vector<double>& x = groups[g].abscissa;
        const std::vector<double>& asked = curves.at(part)[g].x;
        if (x.front() > asked.front()) x.front() = asked.front();
        if (x.back() < asked.back()) x.back() = asked.back();
      }
    }
    return metric(all, records, {}).passes();
  };
  Computed r{.noticed = 1};
  double below = 0;
  const auto exact = [] { return 0.0; };
  for (int bisections = 0; bisections < 16; ++bisections) {
    const double middle = (below + r.noticed) / 2;
    (passes(1 + middle, exact) || passes(1 - middle, exact) ? below : r.noticed) = middle;
  }
  std::mt19937_64 random(51);
  std::normal_distribution<double> normal;
  for (long k = 0; k < draws; ++k) {
    if (!passes(1, [&] { return normal(random); })) r.failing += 1.0 / draws;
  }
  return r;
}

/// Standard numerical uncertainty of a value on the finest of the grids.
double numerical_of(const Question& one, const Experiment& experiment, const Computed& computed) {
  std::vector<double> sizes, values;
  for (std::size_t k = 0; k < computed.grids.size(); ++k) {
    const double value = one.answer(computed.grids[k]);
    if (k > 1 && std::isnan(value)) break;  // of the coarsest grid alone a reading may be missing
    sizes.push_back(experiment.coarsenings[k]);
    values.push_back(value);
  }
  return 0.5 * fine_limit(sizes, values, experiment.order).uncertainty;
}

Sources sources_of(const std::vector<Question>& all, const Experiment& experiment, const Computed& computed) {
  return {.numerical = each(all, [&](const Question& one) { return numerical_of(one, experiment, computed); })};
}

void draw(const Series& part, const std::vector<Measured>& data, const Computed& computed, const std::string& model,
          evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure(part.name, fmt::format("{}: {}", part.name, part.quantity.meaning),
                                fmt::format("Measured points{}.", computed.grids.empty() ? "" : " and the model"));
  const Submitted none;
  const Submitted& fine = computed.grids.empty() ? none : computed.grids.front();
  const auto own = fine.find(part.name);
  for (std::size_t k = 0; k < std::min(data.size(), most_panels); ++k) {
    const Measured& curve = data[k];
    auto& panel =
        figure.panel({.x = fmt::format("{} [{}]", part.abscissa.name, part.abscissa.unit),
                      .y = fmt::format("{} [{}]", part.quantity.name, part.quantity.unit),
                      .title = part.group ? fmt::format("{} = {:g}", part.group->name, curve.group) : std::string()});
    if (own != fine.end()) {
      for (const SubmittedGroup& one : own->second) {
        if (part.group && one.value != curve.group) continue;
        if (part.kind == WantedTable::Kind::scalars) {
          panel.points(model, std::vector{curve.x.front()}, one.values.at(part.quantity.name), Role::computed);
          continue;
        }
        std::vector<double> x, y;
        for (const std::size_t i : inside(one.abscissa, {curve.x.front(), curve.x.back()})) {
          x.push_back(one.abscissa[i]);
          y.push_back(one.values.at(part.quantity.name)[i]);
        }
        panel.line(model, x, y, Role::computed);
      }
    }
    constexpr std::size_t dense = 60;  // points whose error bars would hide what they stand for
    panel.points("measured", curve.x, curve.y, Role::data, curve.x.size() > dense ? std::vector<double>{} : curve.u);
  }
}

}  // namespace

void claim_experiment(const Experiment& experiment, const Values& values, const Claims<Computed>& claims) {
  const auto data = claims.from(experiment.source).at("the data");
  data.check("resolves",
             fmt::format("A common factor of {:g} on all readings is detected as wrong.", 1 + experiment.ceiling),
             "smallest detected common factor, minus 1", &Computed::noticed,
             Bound{.limit = experiment.ceiling, .reason = experiment.ceiling_reason});
  const boost::math::binomial_distribution<double> perfect(draws, 0.05);
  data.check("perfect-solver",
             "A perfect solver agrees with the measurement in 95 % of draws of its stated uncertainty.",
             fmt::format("share of {} draws that fail", draws), &Computed::failing,
             Bound{.limit = std::ceil(boost::math::quantile(perfect, 0.999)) / draws,
                   .reason = "99.9 % of a binomial distribution of 5 %"});
  if (!experiment.compute) return;
  const auto agree = [experiment, values](const Computed& r) -> Measurement {
    const std::vector<Question> all = questions(experiment, values);
    const Sources sources = sources_of(all, experiment, r);
    const Metric found = metric(all, r.grids.front(), sources);
    Measurement measurement{.value = found.difference,
                            .uncertainty = numerical_uncertainty(all, r.grids.front(), sources, experiment.ceiling),
                            .resolution = fmt::format("{} readings, {} spacings", all.size(), r.grids.size())};
    measurement.told.data = found.data;
    measurement.told.input = found.input;
    return measurement;
  };
  const Uncertainty criterion =
      criterion_of(experiment, Amount::told_by_run(experiment.ceiling), Amount::told_by_run(experiment.ceiling),
                   coverage(questions(experiment, values)));
  evidence::Claim claim = claim_of(experiment);
  claim.text.insert(claim.text.size() - 1, fmt::format(" ({})", experiment.model));
  if (experiment.miss.empty()) return claims.check(claim, agree, criterion);
  claims.fails({.width = std::numeric_limits<double>::infinity(), .reason = experiment.miss})
      .check(claim, agree, criterion);
}

Computed compute_experiment(const Experiment& experiment, const Run& run) {
  const std::vector<Question> all = questions(experiment, run);
  Computed r = told_by_data(experiment, run, all);
  if (!experiment.compute) return r;
  std::map<std::string, double> unused;
  for (const double coarsening : experiment.coarsenings) {
    r.grids.push_back(
        on_the_clock(experiment, run, experiment.compute(run, coarsening), r.grids.empty() ? r.shifts : unused));
    run.progress(0.7);
  }
  return r;
}

void show_experiment(const Experiment& experiment, const Computed& computed, const Values& values,
                     evidence::Exhibit& exhibit) {
  for (const auto& [part, shift] : computed.shifts) exhibit.measure(part + "_time_shift", shift);
  const std::vector<Question> all = questions(experiment, values);
  if (computed.grids.empty()) {
    const std::vector<double> none(all.size(), nan);
    show_readings(all, {}, none, none, "", exhibit);
  } else {
    const Sources sources = sources_of(all, experiment, computed);
    show_readings(all, computed.grids.front(), sources.numerical, metric(all, computed.grids.front(), sources).scores,
                  experiment.model, exhibit);
    show_calibration(experiment, values, computed.grids.front(), exhibit);
  }
  for (const Series& part : experiment.parts) draw(part, measured(part, values), computed, experiment.model, exhibit);
}

}  // namespace seiche::validation::laboratory
