#include "validation/laboratory/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Cholesky>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/minima.hpp>

#include "seiche/samples.hpp"
#include "validation/case/claims.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation::laboratory {
namespace {

/// For ids: no points, and a word for a minus.
std::string plain(std::string text, const char* minus) {
  std::replace(text.begin(), text.end(), '.', '_');
  if (const auto at = text.find('-'); at != std::string::npos) text.replace(at, 1, minus);
  return text;
}

/// Root mean square of the measured curve: what an incident wave that is off by a share makes of a misfit.
double size_of(const Measured& measured, Window window) {
  Mean square;
  for (const std::size_t i : inside(measured.x, window)) square.add(std::pow(measured.y[i], 2));
  return std::sqrt(square.value());
}

const SubmittedGroup* group_of(const Submitted& computed, const Series& part, double group) {
  const auto found = computed.find(part.name);
  if (found == computed.end()) return nullptr;
  for (const SubmittedGroup& one : found->second) {
    if (!part.group || std::abs(one.value - group) <= 1e-6 * std::max(1.0, std::abs(group))) return &one;
  }
  return nullptr;
}

/// A part's clock; where its group was not submitted, the same at the first of those that were, in its misfit's window.
std::optional<Clock> clock_of(const Submitted& computed, const Series& part) {
  if (!part.clock || group_of(computed, part, part.clock->group) != nullptr) return part.clock;
  const auto other = std::ranges::find_if(part.readings, [&](const Reading& one) {
    return one.misfit() && group_of(computed, part, one.group) != nullptr;
  });
  if (other == part.readings.end()) return std::nullopt;
  return Clock{.group = other->group, .range = part.clock->range, .window = other->window};
}

/// Whether no reading with a sign tells an amplitude, so that misfits alone do.
bool by_misfits_alone(const std::vector<Question>& all) {
  return std::ranges::none_of(all, [](const Question& one) { return one.size != 0 && !one.reading.misfit(); });
}

/// Names of the parts that a factor changes.
std::vector<std::string> scaled_parts(const std::vector<Question>& all) {
  const bool misfits = by_misfits_alone(all);
  std::set<std::string> names;
  for (const Question& one : all) {
    if (one.size != 0 && (misfits || !one.reading.misfit())) names.insert(one.part.name);
  }
  return {names.begin(), names.end()};
}

/// Of `freedom` degrees, exceeded by one of two independent parts in 1 - sqrt(0.95) of draws.
double chi_squared(std::size_t freedom) {
  return boost::math::quantile(boost::math::chi_squared(static_cast<double>(freedom)), std::sqrt(0.95));
}

/// Covariances of the data of readings with a sign.
Eigen::MatrixXd covariance(const std::vector<Question>& all, const std::vector<std::size_t>& index) {
  const auto n = static_cast<Eigen::Index>(index.size());
  Eigen::MatrixXd v = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Question& a = all[index[static_cast<std::size_t>(i)]];
    for (Eigen::Index j = 0; j < i; ++j) {
      const Question& b = all[index[static_cast<std::size_t>(j)]];
      if (a.part.name != b.part.name) continue;
      const bool clocked = a.part.kind == WantedTable::Kind::series;
      if (clocked && a.reading.along && b.reading.along) v(i, j) = a.measured->u_x * b.measured->u_x;
      if (a.reading.group == b.reading.group) v(i, j) += a.datum * b.datum;
      v(j, i) = v(i, j);
    }
    v(i, i) = std::pow(a.u_data, 2);
  }
  return v;
}

}  // namespace

Question::Question(const Series& from, const Reading& what, std::shared_ptr<const Measured> curve)
    : part(from),
      reading(what),
      measured(std::move(curve)),
      expected(reading.expected(*measured)),
      u_data(reading.uncertainty(*measured)) {
  if (reading.along) return;
  size = reading.misfit() ? size_of(*measured, reading.window) : expected;
  if (reading.misfit() || part.kind != WantedTable::Kind::series) return;
  datum = std::numbers::sqrt2 / 2 * std::clamp(reading.shifted(*measured), -u_data, u_data);
}

std::string Question::id() const {
  const std::string suffix = part.group ? fmt::format("-{}", plain(fmt::format("{:g}", reading.group), "m")) : "";
  return fmt::format("{}-{}{}", part.name, plain(reading.id, "-"), suffix);
}

std::string Question::unit() const {
  if (reading.along) return part.abscissa.unit;
  return reading.id == "impulse" && part.quantity.unit != "1" ? part.quantity.unit + " s" : part.quantity.unit;
}

double Question::answer(const Submitted& computed, double factor) const {
  const SubmittedGroup* group = group_of(computed, part, reading.group);
  if (group == nullptr) return nan;
  const bool scalar = part.kind == WantedTable::Kind::scalars;
  std::vector<double> y = group->values.at(part.quantity.name);
  for (double& one : y) one /= factor;
  return reading.of({scalar ? measured->x : group->abscissa, y}, *measured);
}

std::optional<double> Question::stated(const std::map<std::string, StatedUncertainty>& uncertainty) const {
  const auto of_y = uncertainty.find(part.quantity.name);
  const auto of_x = uncertainty.find(part.abscissa.name);
  if (of_y == uncertainty.end() && of_x == uncertainty.end()) return std::nullopt;
  Measured as_stated = *measured;
  const double u = of_y == uncertainty.end() ? 0 : of_y->second.of(worst(as_stated.y));
  std::ranges::fill(as_stated.u, u);
  as_stated.u_x = of_x == uncertainty.end() ? 0 : of_x->second.of(as_stated.x.back() - as_stated.x.front());
  if (u == 0 && as_stated.u_x == 0) return 0;
  const double all = reading.uncertainty(as_stated);
  return std::isnan(all) ? std::nullopt : std::optional(all);
}

std::optional<Question> Question::within(const SubmittedGroup& record) const {
  if (record.abscissa.empty()) return *this;
  Reading there = reading;
  there.window = {std::max(reading.window.from, record.abscissa.front()),
                  std::min(reading.window.to, record.abscissa.back())};
  const std::vector<double>& x = measured->x;
  const std::vector<double> held = each(inside(x, there.window), [&](std::size_t i) { return x[i]; });
  if (held.empty() || std::isnan(there.of(measured->curve(), *measured))) return {};
  const Curve given{record.abscissa, record.values.at(part.quantity.name)};
  const std::vector<double> between = each(held, [&](double at) { return linear_at(given, at); });
  const bool sparse = std::isnan(there.of(given, *measured)) && !std::isnan(there.of({held, between}, *measured));
  if (sparse) return {};
  const auto asked = static_cast<std::size_t>(std::ranges::distance(inside(x, reading.window)));
  return held.size() == asked ? *this : Question(part, there, measured);
}

std::vector<Question> questions(const Experiment& experiment, const Values& values, bool calibration) {
  std::vector<Question> all;
  for (const Series& part : experiment.parts) {
    for (const Measured& curve : measured(part, values)) {
      const auto kept = std::make_shared<const Measured>(curve);
      for (const Reading& reading : part.readings) {
        const bool calibrates =
            !reading.misfit() && std::ranges::find(part.calibrating, reading.group) != part.calibrating.end();
        if (calibrates == calibration && (!part.group || reading.group == curve.group)) {
          all.emplace_back(part, reading, kept);
        }
      }
    }
  }
  return all;
}

Submitted on_the_clock(const Experiment& experiment, const Values& values, const Submitted& computed,
                       std::map<std::string, double>& shifts) {
  Submitted shifted = computed;
  for (const Series& part : experiment.parts) {
    if (!shifted.contains(part.name)) continue;
    std::vector<SubmittedGroup>& groups = shifted.at(part.name);
    for (SubmittedGroup& one : groups) {
      if (part.still) set_zero(one.abscissa, one.values.at(part.quantity.name), *part.still);
    }
    const std::optional<Clock> clock = clock_of(shifted, part);
    const SubmittedGroup* group = clock ? group_of(shifted, part, clock->group) : nullptr;
    if (group == nullptr) continue;
    for (const Measured& curve : measured(part, values)) {
      if (part.group && curve.group != clock->group) continue;
      const Curve given{group->abscissa, group->values.at(part.quantity.name)};
      const Window window = clock->window;
      const bool whole = given.x.front() <= std::max(window.from, curve.x.front()) &&
                         given.x.back() >= std::min(window.to, curve.x.back());
      double lag = whole || clock->by ? clock->lag(given, curve) : nan;
      if (std::isnan(lag)) {  // by what the record holds of the window at every lag
        const Window held{std::max(window.from, given.x.front() + clock->range),
                          std::min(window.to, given.x.back() - clock->range)};
        lag = lag_of(given, curve, held, clock->range);
      }
      shifts[part.name] = lag;
      if (std::isnan(lag)) continue;
      for (SubmittedGroup& one : groups) {
        for (double& x : one.abscissa) x -= lag;
      }
    }
  }
  return shifted;
}

double coverage(const std::vector<Question>& all) {
  return std::sqrt(chi_squared(scaled_parts(all).size()));
}

double Metric::noticed() const {
  return coverage * std::hypot(data, input, numerical);
}

Metric metric(const std::vector<Question>& all, const Submitted& computed, const Sources& sources) {
  const bool misfits_alone = by_misfits_alone(all);
  std::vector<std::size_t> index;  // of the readings that a covariance is known of
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].reading.misfit() || misfits_alone) index.push_back(k);
  }
  const auto gather = [&](const auto& value) {
    Eigen::VectorXd gathered(static_cast<Eigen::Index>(index.size()));
    for (std::size_t i = 0; i < index.size(); ++i) gathered[static_cast<Eigen::Index>(i)] = value(index[i]);
    return gathered;
  };
  const auto input = [&](std::size_t k) { return all[k].part.input * all[k].size; };
  const auto numerical = [&](std::size_t k) { return sources.numerical.empty() ? 0 : sources.numerical[k]; };
  const std::vector<std::string> parts = scaled_parts(all);
  Eigen::MatrixXd sizes(static_cast<Eigen::Index>(index.size()), static_cast<Eigen::Index>(parts.size()));
  for (std::size_t p = 0; p < parts.size(); ++p) {
    sizes.col(static_cast<Eigen::Index>(p)) =
        gather([&](std::size_t k) { return all[k].part.name == parts[p] ? all[k].size : 0; });
  }
  const Eigen::VectorXd size = sizes.rowwise().sum();
  const Eigen::VectorXd incident = gather(input);
  const Eigen::VectorXd error =
      gather([&](std::size_t k) { return all[k].reading.misfit() ? 0 : all[k].answer(computed) - all[k].expected; });
  Eigen::MatrixXd v = covariance(all, index);
  // Of a common factor, from the readings as well as these covariances let it be told.
  const auto of_factor = [&] { return 1 / std::sqrt(size.dot(v.llt().solve(size))); };
  const auto more = [](double total, double before) {
    return std::sqrt(std::max(total * total - before * before, 0.0));
  };
  Metric result{.coverage = coverage(all)};
  result.data = of_factor();
  v += incident * incident.transpose();
  for (const auto& changes : sources.shared) {
    const Eigen::VectorXd change = gather([&](std::size_t k) { return changes[k]; });
    v += change * change.transpose();
  }
  const double before = of_factor();
  result.input = more(before, result.data);
  const Eigen::VectorXd own = gather(numerical);
  v.diagonal() += own.cwiseAbs2();
  result.numerical = more(of_factor(), before);
  Worst share;
  for (const auto& of_part : sizes.colwise()) {
    share.add(of_part.cwiseSign().cwiseAbs().dot(own) / of_part.cwiseAbs().sum());
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double telling = std::max(all[k].part.telling, 2 * all[k].u_data);
    if (all[k].reading.along && 2 * numerical(k) > telling) share.add(std::numeric_limits<double>::infinity());
  }
  result.shared = share.value();

  const Eigen::LLT<Eigen::MatrixXd> factors = v.llt();
  const Eigen::VectorXd weighted = factors.solve(error);
  const Eigen::VectorXd pull = sizes.transpose() * weighted;
  const double by_factors = pull.dot((sizes.transpose() * factors.solve(sizes)).llt().solve(pull));
  const auto own_uncertainty = [&](std::size_t k) {
    double u = std::hypot(all[k].u_data, numerical(k));
    for (const auto& changes : sources.shared) u = std::hypot(u, changes[k]);
    return u;
  };
  const auto misfit = [&](std::size_t k, double amplitude) {
    return all[k].answer(computed, 1 + amplitude * all[k].part.input) / own_uncertainty(k);
  };
  const auto left_by = [&](double amplitude) {
    double sum = amplitude * amplitude;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].reading.misfit()) sum += std::pow(misfit(k, amplitude), 2);
    }
    return sum;
  };
  // Of the incident amplitude, in its standard uncertainties.
  double explained = incident.dot(weighted);
  if (misfits_alone && incident.squaredNorm() > 0) {
    constexpr int digits = 20;
    explained = boost::math::tools::brent_find_minima(left_by, -3.0, 3.0, digits).first;
  }
  double rest = error.dot(weighted) - by_factors + (misfits_alone ? explained * explained : 0);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Question& one = all[k];
    if (one.reading.misfit()) {
      result.scores.push_back(misfit(k, explained));
      rest += std::pow(result.scores.back(), 2);
    } else {
      result.scores.push_back((one.answer(computed) - one.expected) / std::hypot(own_uncertainty(k), input(k)));
    }
  }
  const std::size_t left = all.size() - (misfits_alone ? 0 : parts.size());
  const double beyond = left > 0 ? std::sqrt(std::max(rest, 0.0) / chi_squared(left)) : 0;
  const double off = std::max(std::sqrt(by_factors) / result.coverage, beyond);
  result.difference = std::isnan(rest) ? nan : off * result.noticed();
  return result;
}

std::optional<double> numerical_uncertainty(const std::vector<Question>& all, const Submitted& computed,
                                            Sources sources, double ceiling) {
  const Metric found = metric(all, computed, sources);
  if (found.coverage * found.shared <= ceiling) return found.coverage * found.numerical;
  for (const std::string& part : scaled_parts(all)) {
    std::vector<double>& shared = sources.shared.emplace_back();
    for (std::size_t k = 0; k < all.size(); ++k) {
      shared.push_back(all[k].part.name == part ? sources.numerical[k] : 0);
    }
  }
  const bool explained = found.passes() || metric(all, computed, sources).passes();
  return explained ? std::nullopt : std::optional(found.coverage * found.numerical);
}

evidence::Claim claim_of(const Experiment& experiment) {
  std::vector<std::string> parts;
  for (const Series& part : experiment.parts) parts.push_back(part.quantity.meaning);
  return {"agreement",
          fmt::format("All readings of {} agree with the measurement within their combined uncertainty.",
                      fmt::join(parts, ", ")),
          "common factor, minus 1, equivalent to the differences of the readings", "1", experiment.source};
}

Uncertainty criterion_of(const Experiment& experiment, Amount data, Amount input, double coverage) {
  std::string reason = "ASME V&V 20.1-2024, all readings together: validation/laboratory/verdicts.hpp; u_data from";
  for (const Series& part : experiment.parts) reason += fmt::format(" reference_data/{}", part.table);
  for (const Series& part : experiment.parts) {
    if (part.input > 0) {
      reason += fmt::format("; u_input {:g} % of {}: {}", 100 * part.input, part.name, part.input_reason);
    }
  }
  return {.data = data,
          .input = input,
          .useful = experiment.ceiling,
          .reason = fmt::format("{}; ceiling: {}", reason, experiment.ceiling_reason),
          .coverage = coverage};
}

void show_readings(const std::vector<Question>& all, const Submitted& computed, const std::vector<double>& numerical,
                   const std::vector<double>& scores, const std::string& solver, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(exhibit, "laboratory-readings", solver,
                                     "Measured and computed readings, with standard uncertainties, and their "
                                     "difference over the combined uncertainty; arrivals count from the origin.",
                                     {"quantity", "reading", "measured [1]", "u measured [1]", "computed [1]",
                                      "u computed [1]", "origin [1]", "E/u [1]"});
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Question& one = all[k];
    table.rows.push_back({name(one.reading.kind), one.id(), one.expected,
                          std::hypot(one.u_data, one.part.input * one.size), one.answer(computed), numerical[k],
                          one.reading.along ? one.part.origin : 0.0, scores[k]});
  }
}

void show_calibration(const Experiment& experiment, const Values& values, const Submitted& computed,
                      evidence::Exhibit& exhibit) {
  const std::vector<Question> all = questions(experiment, values, true);
  if (all.empty()) return;
  evidence::Table& table = add_table(exhibit, "calibration", "Calibration",
                                     "Readings of the gauges that set the input of a computation: no claims.",
                                     {"reading", "measured [1]", "computed [1]", "unit"});
  for (const Question& one : all) {
    table.rows.push_back({one.id(), one.expected, one.answer(computed), one.unit()});
  }
}

void judge(const Experiment& experiment, const Values& values, const Submitted& submitted, const SolverFacts& facts,
           evidence::Record& record) {
  std::map<std::string, double> shifts;
  const Submitted computed = on_the_clock(experiment, values, submitted, shifts);
  for (const auto& [part, shift] : shifts) record.measure(part + "_time_shift", shift);
  std::string set;  // whose phase is no evidence
  for (const Series& part : experiment.parts) {
    const std::optional<Clock> clock = clock_of(submitted, part);
    if (clock && part.group && clock->group != part.clock->group) {
      set += fmt::format(", clock set at {} = {:g}", part.group->name, clock->group);
    }
  }
  std::vector<Question> present;
  Sources sources;
  std::string open;  // why nothing is decided, unless it is clearly wrong
  for (const Question& one : questions(experiment, values)) {
    const SubmittedGroup* group = group_of(computed, one.part, one.reading.group);
    const std::optional<Question> asked = group == nullptr ? std::nullopt : one.within(*group);
    if (!asked) {
      const SubmittedGroup* given = group_of(submitted, one.part, one.reading.group);
      const bool by_clock = given != nullptr && one.within(*given).has_value();
      if (by_clock) open = ", readings outside the record on the measured clock";
      record.leave_out({{.id = one.id(),
                         .text = fmt::format("{}: {}", one.part.quantity.meaning, one.reading.words),
                         .quantity = one.reading.words,
                         .unit = one.unit(),
                         .source = experiment.source},
                        group == nullptr ? "no record was submitted"
                        : by_clock
                            ? "the record does not contain the reading on the measured clock: submit a longer one"
                            : "the record does not contain the reading, or too few points of it"});
      continue;
    }
    const std::optional<double> u = asked->stated(facts.uncertainty);
    if (!u) open = ", u_num not stated";
    present.push_back(*asked);
    sources.numerical.push_back(u.value_or(0));
  }
  const bool no_clock = std::ranges::any_of(shifts, [](const auto& one) { return std::isnan(one.second); });
  if (no_clock || std::ranges::all_of(present, [](const Question& one) { return one.size == 0; })) {
    record.keep({claim_of(experiment),
                 criterion_of(experiment, 0, 0, coverage(questions(experiment, values))),
                 {.verdict = evidence::Verdict::inconclusive,
                  .measured = nan,
                  .resolution = no_clock          ? "the record is too short to set its clock"
                                : present.empty() ? "no reading is taken of what was submitted"
                                                  : "no amplitude was submitted",
                  .note = "no quantity could be compared"}});
    return;
  }
  std::vector<std::string> lost;
  for (const Question& one : present) {
    if (std::isnan(one.answer(computed))) lost.push_back(one.id());
  }
  const Metric found = metric(present, computed, sources);
  const bool stated = open.empty();
  const auto u = stated ? numerical_uncertainty(present, computed, sources, experiment.ceiling) : std::nullopt;
  if (stated && !u) open = ", u_num too large to decide";
  if (!lost.empty()) open += fmt::format(", without {}", fmt::join(lost, ", "));
  record.check(claim_of(experiment),
               {.value = found.difference,
                .uncertainty = u,
                .resolution = fmt::format("{} readings{}{}", present.size(), set, open)},
               criterion_of(experiment, found.data, found.input, found.coverage));
  show_readings(present, computed, stated ? sources.numerical : std::vector<double>(present.size(), nan), found.scores,
                record.solver, record);
  show_calibration(experiment, values, computed, record);
}

}  // namespace seiche::validation::laboratory
