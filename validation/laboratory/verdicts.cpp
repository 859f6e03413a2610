#include "validation/laboratory/verdicts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/samples.hpp"
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
  for (std::size_t i = 0; i < measured.x.size(); ++i) {
    if (measured.x[i] >= window.from && measured.x[i] <= window.to) square.add(std::pow(measured.y[i], 2));
  }
  return std::sqrt(square.value());
}

/// What half of a misfit's range is taken of: the range of the measured curve.
double range_of(const Measured& measured, Window window) {
  const Reading top = highest(measured.group, window);
  const Reading bottom = lowest(measured.group, window);
  return top.expected(measured) - bottom.expected(measured);
}

const SubmittedGroup* group_of(const Submitted& computed, const Series& part, double group) {
  const auto found = computed.find(part.name);
  if (found == computed.end()) return nullptr;
  for (const SubmittedGroup& one : found->second) {
    if (!part.group || std::abs(one.value - group) <= 1e-6 * std::max(1.0, std::abs(group))) return &one;
  }
  return nullptr;
}

}  // namespace

Question::Question(std::string source, const Series& part, const Reading& reading,
                   std::shared_ptr<const Measured> measured)
    : part_(part), reading_(reading), source_(std::move(source)), measured_(std::move(measured)) {
  expected_ = reading.expected(*measured_);
  u_data_ = reading.uncertainty(*measured_);
  if (reading.along || (reading.kind == Kind::statistic && part.telling > 0)) {
    useful_ = part.telling;
    return;
  }
  const double size = reading.misfit() ? size_of(*measured_, reading.window) : std::abs(expected_);
  u_input_ = part.input * size;
  useful_ = part.useful * (reading.misfit() ? range_of(*measured_, reading.window) : size);
}

evidence::Claim Question::claim() const {
  const Column& quantity = part_.quantity;
  const std::string at =
      part_.group ? fmt::format(" at {} = {:g}{}", part_.group->name, reading_.group, after_number(part_.group->unit))
                  : "";
  const std::string suffix = part_.group ? fmt::format("-{}", plain(fmt::format("{:g}", reading_.group), "m")) : "";
  return {.id = fmt::format("{}-{}{}", part_.name, plain(reading_.id, "-"), suffix),
          .text = reading_.misfit() ? fmt::format("The {}{} agrees with the measured record within its uncertainty.",
                                                  quantity.meaning, at)
                                    : fmt::format("The {}{} agrees with the measurement within its uncertainty: {}.",
                                                  quantity.meaning, at, reading_.words),
          .quantity = reading_.words,
          .unit = reading_.along                                     ? part_.abscissa.unit
                  : reading_.id == "impulse" && quantity.unit != "1" ? quantity.unit + " s"
                                                                     : quantity.unit,
          .source = source_};
}

Uncertainty Question::criterion() const {
  std::string reason = fmt::format("u_data {} reference_data/{}",
                                   reading_.note.empty() ? "from" : reading_.note + ", beside", part_.table);
  if (u_input_ > 0) reason += fmt::format("; u_input, {:g} % of it: {}", 100 * part_.input, part_.input_reason);
  return {.expected = expected_, .data = u_data_, .input = u_input_, .useful = useful_, .reason = reason};
}

Uncertainty Question::criterion_of_run() const {
  Uncertainty criterion = this->criterion();
  criterion.input = Amount::told_by_run(useful_ / 2);
  criterion.reason += "; u_input holds what parameters change that no source states";
  return criterion;
}

double Question::answer(const Submitted& computed) const {
  const SubmittedGroup* group = group_of(computed, part_, reading_.group);
  if (group == nullptr) return std::numeric_limits<double>::quiet_NaN();
  const bool scalar = part_.kind == WantedTable::Kind::scalars;
  return reading_.of({scalar ? measured_->x : group->abscissa, group->values.at(part_.quantity.name)}, *measured_);
}

std::optional<double> Question::stated(const std::map<std::string, StatedUncertainty>& uncertainty) const {
  const auto of_y = uncertainty.find(part_.quantity.name);
  const auto of_x = uncertainty.find(part_.abscissa.name);
  if (of_y == uncertainty.end() && of_x == uncertainty.end()) return std::nullopt;
  Measured as_stated = *measured_;
  Worst largest;
  for (const double y : as_stated.y) largest.add(y);
  const double u = of_y == uncertainty.end() ? 0 : of_y->second.of(largest.value());
  std::fill(as_stated.u.begin(), as_stated.u.end(), u);
  as_stated.u_x = of_x == uncertainty.end() ? 0 : of_x->second.of(as_stated.x.back() - as_stated.x.front());
  if (u == 0 && as_stated.u_x == 0) return 0;
  return reading_.uncertainty(as_stated);
}

std::optional<Question> Question::within(const SubmittedGroup& record) const {
  if (record.abscissa.empty()) return *this;
  Reading part = reading_;
  part.window = {std::max(reading_.window.from, record.abscissa.front()),
                 std::min(reading_.window.to, record.abscissa.back())};
  const std::vector<double>& x = measured_->x;
  const auto inside = [&](double at) { return at >= part.window.from && at <= part.window.to; };
  if (std::ranges::none_of(x, inside) || std::isnan(part.of(measured_->curve(), *measured_))) return {};
  if (std::ranges::count_if(x, inside) ==
      std::ranges::count_if(x, [&](double at) { return at >= reading_.window.from && at <= reading_.window.to; })) {
    return *this;
  }
  return Question(source_, part_, part, measured_);
}

bool Question::passes(double answer) const {
  return std::abs(answer - expected_) <= 2 * std::hypot(u_data_, u_input_);
}

std::vector<Question> questions(const Experiment& experiment, const Values& values, bool calibration) {
  std::vector<Question> all;
  for (const Series& part : experiment.parts) {
    for (const Measured& curve : measured(part, values)) {
      const auto kept = std::make_shared<const Measured>(curve);
      for (const Reading& reading : part.readings) {
        if (reading.calibration == calibration && (!part.group || reading.group == curve.group)) {
          all.emplace_back(experiment.source, part, reading, kept);
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
    if (!part.clock) continue;
    const SubmittedGroup* group = group_of(computed, part, part.clock->group);
    if (group == nullptr) continue;
    for (const Measured& curve : measured(part, values)) {
      if (part.group && curve.group != part.clock->group) continue;
      const double lag = part.clock->lag({group->abscissa, group->values.at(part.quantity.name)}, curve);
      shifts[part.name] = lag;
      for (SubmittedGroup& one : shifted.at(part.name)) {
        for (double& x : one.abscissa) x -= lag;
      }
    }
  }
  return shifted;
}

void show_readings(const std::vector<Question>& all, const Submitted& computed,
                   const std::vector<std::optional<double>>& numerical, const std::string& solver,
                   evidence::Exhibit& exhibit) {
  evidence::Table table{.id = "laboratory-readings",
                        .title = solver,
                        .caption =
                            "What was measured and computed, with standard uncertainties, in the units of the claims; "
                            "arrivals are counted from the last column.",
                        .columns = table_columns({"quantity", "claim", "measured [1]", "u measured [1]", "computed [1]",
                                                  "u computed [1]", "origin [1]"})};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Question& one = all[k];
    table.rows.push_back({name(one.reading().kind), one.claim().id, one.expected(),
                          std::hypot(one.data_uncertainty(), one.input_uncertainty()), one.answer(computed),
                          numerical.at(k).value_or(std::numeric_limits<double>::quiet_NaN()),
                          one.reading().along ? one.part().origin : 0.0});
  }
  exhibit.table(std::move(table));
}

void show_calibration(const Experiment& experiment, const Values& values, const Submitted& computed,
                      evidence::Exhibit& exhibit) {
  evidence::Table table{.id = "calibration",
                        .title = "Calibration",
                        .caption = "Readings of the gauges that set the input of a computation: no claims.",
                        .columns = table_columns({"reading", "measured [1]", "computed [1]", "unit"})};
  for (const Question& one : questions(experiment, values, true)) {
    table.rows.push_back({one.claim().id, one.expected(), one.answer(computed), one.claim().unit});
  }
  if (!table.rows.empty()) exhibit.table(std::move(table));
}

void judge(const Experiment& experiment, const Values& values, const Submitted& submitted, const SolverFacts& facts,
           evidence::Record& record) {
  std::map<std::string, double> shifts;
  const Submitted computed = on_the_clock(experiment, values, submitted, shifts);
  for (const auto& [part, shift] : shifts) record.measure(part + "_time_shift", shift);
  std::vector<Question> present;
  std::vector<std::optional<double>> numerical;
  for (Question one : questions(experiment, values)) {
    if (!computed.contains(one.part().name)) {
      record.leave_out({one.claim(), "the table was not submitted"});
      continue;
    }
    const SubmittedGroup* group = group_of(computed, one.part(), one.reading().group);
    const std::optional<Question> asked = group == nullptr ? std::nullopt : one.within(*group);
    if (!asked) {
      record.leave_out({one.claim(), group == nullptr ? "no record was submitted" : "the record does not hold it"});
      continue;
    }
    one = *asked;
    const std::optional<double> u = one.stated(facts.uncertainty);
    record.check(one.claim(),
                 {.value = one.answer(computed),
                  .uncertainty = u ? std::optional(2 * *u) : std::nullopt,
                  .resolution = u ? fmt::format("u_num = {:.3g}", *u) : "u_num not stated"},
                 one.criterion());
    present.push_back(one);
    numerical.push_back(u);
  }
  show_readings(present, computed, numerical, record.solver, record);
  show_calibration(experiment, values, computed, record);
}

}  // namespace seiche::validation::laboratory
