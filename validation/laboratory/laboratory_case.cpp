#include "validation/laboratory/laboratory_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation::laboratory {
namespace {

constexpr std::size_t most_panels = 10;

/// Whether every reading of the questions passes with the curve in the place of the measured one.
bool all_pass(const std::vector<const Question*>& asked, Curve curve) {
  return std::all_of(asked.begin(), asked.end(),
                     [&](const Question* one) { return one->passes(one->reading().of(curve, one->measured())); });
}

std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

std::vector<Trial> trials_of(const Experiment& experiment, const Values& values) {
  std::map<std::string, std::map<double, std::vector<const Question*>>> asked;
  const std::vector<Question> all = questions(experiment, values);
  for (const Question& one : all) asked[one.part().name][one.measured().group].push_back(&one);
  std::vector<Trial> trials;
  for (const Series& part : experiment.parts) {
    Trial trial{.part = part.name};
    const auto& groups = asked[part.name];
    trial.groups = static_cast<long>(groups.size());
    for (auto at = groups.begin(); at != groups.end(); ++at) {
      const Measured& own = at->second.front()->measured();
      if (all_pass(at->second, {own.x, times(-1, own.y)})) ++trial.upside_down;
      if (all_pass(at->second, {own.x, times(0.5, own.y)})) ++trial.half;
      const auto next = std::next(at);
      if (next != groups.end() && all_pass(at->second, next->second.front()->measured().curve())) ++trial.alike;
      for (const Question* one : at->second) {
        const double expanded = 2 * std::hypot(one->data_uncertainty(), one->input_uncertainty());
        if (!(expanded / one->useful() <= trial.dullest)) {
          trial.dullest = expanded / one->useful();
          trial.where = one->claim().id;
        }
      }
    }
    trials.push_back(trial);
  }
  return trials;
}

void claim_trials(const Experiment& experiment, const Claims<Computed>& claims) {
  for (std::size_t k = 0; k < experiment.parts.size(); ++k) {
    const Series& part = experiment.parts[k];
    const auto trial = claims.of([k](const Computed& r) -> const Trial& { return r.trials.at(k); }).at("the data");
    const auto count = [&](const std::string& id, const std::string& text, long Trial::*groups, long limit,
                           const std::string& reason) {
      trial.from(experiment.source)
          .check(
              fmt::format("{}-{}", part.name, id), text, "groups that pass",
              [groups](const Trial& t) { return static_cast<double>(t.*groups); },
              Bound{.limit = static_cast<double>(limit), .reason = reason});
    };
    trial.from(experiment.source)
        .check(
            part.name + "-decides", fmt::format("The {} is known well enough to decide.", part.quantity.meaning),
            "largest expanded uncertainty of a reading over what still decides",
            [](const Trial& t) -> Measurement { return {.value = t.dullest, .where = t.where}; },
            Bound{.limit = 1, .reason = "beyond it agreement says nothing"});
    if (part.group) {
      count("neighbour",
            fmt::format("The {} of a neighbouring {} fails the comparison.", part.quantity.meaning, part.group->name),
            &Trial::alike, part.alike, part.alike_reason);
    }
    count("inverted", fmt::format("The {} with the wrong sign fails the comparison.", part.quantity.meaning),
          &Trial::upside_down, 0, "the readings see signs");
    count("half", fmt::format("The {} scaled by 0.5 fails the comparison.", part.quantity.meaning), &Trial::half, 0,
          "an expanded uncertainty of half of a value or less decides");
  }
}

const Cause* cause_of(const std::vector<Cause>& causes, const Question& question) {
  const auto found = std::ranges::find_if(causes, [id = question.claim().id](const Cause& cause) {
    return std::ranges::find(cause.claims, id) != cause.claims.end();
  });
  return found == causes.end() ? nullptr : &*found;
}

/// A cause of what is not asked has been forgotten.
void require_asked(const std::vector<Cause>& causes, const std::vector<Question>& asked) {
  for (const Cause& cause : causes) {
    for (const std::string& id : cause.claims) {
      if (std::ranges::none_of(asked, [&](const Question& one) { return one.claim().id == id; })) {
        throw std::logic_error(fmt::format("a failure of {} is declared, which is no claim", id));
      }
    }
  }
}

void draw(const Series& part, const std::vector<Measured>& data, const Computed& computed, const std::string& model,
          evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure(part.name, fmt::format("{}: {}", part.name, part.quantity.meaning),
                                fmt::format("Measured points{}.", computed.fine.empty() ? "" : " and the model"));
  const auto own = computed.fine.find(part.name);
  for (std::size_t k = 0; k < std::min(data.size(), most_panels); ++k) {
    const Measured& curve = data[k];
    auto& panel =
        figure.panel({.x = fmt::format("{} [{}]", part.abscissa.name, part.abscissa.unit),
                      .y = fmt::format("{} [{}]", part.quantity.name, part.quantity.unit),
                      .title = part.group ? fmt::format("{} = {:g}", part.group->name, curve.group) : std::string()});
    if (own != computed.fine.end()) {
      for (const SubmittedGroup& one : own->second) {
        if (part.group && one.value != curve.group) continue;
        std::vector<double> x, y;
        for (std::size_t i = 0; i < one.abscissa.size(); ++i) {
          if (one.abscissa[i] < curve.x.front() || one.abscissa[i] > curve.x.back()) continue;
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

void list_uncertainties(const std::vector<Question>& all, evidence::Exhibit& exhibit) {
  evidence::Table table{
      .id = "readings",
      .title = "What is judged",
      .caption = "Readings of the measured curves, with standard uncertainties of the data and from the incident wave.",
      .columns = table_columns({"claim", "measured [1]", "u_data [1]", "u_input [1]", "unit"})};
  for (const Question& one : all) {
    table.rows.push_back(
        {one.claim().id, one.expected(), one.data_uncertainty(), one.input_uncertainty(), one.claim().unit});
  }
  exhibit.table(std::move(table));
}

}  // namespace

void claim_experiment(const Experiment& experiment, const Values& values, const Claims<Computed>& claims) {
  claim_trials(experiment, claims);
  if (!experiment.compute) return;
  const std::vector<Question> asked = questions(experiment, values);
  require_asked(experiment.misses, asked);
  require_asked(experiment.undecided, asked);
  for (const Question& one : asked) {
    const auto answer = [one](const Computed& r) -> Measurement {
      const double fine = one.answer(r.fine);
      const double coarse = one.answer(r.coarse);
      Measurement measurement{.value = fine, .uncertainty = std::abs(coarse - fine)};
      double input = one.input_uncertainty();
      for (const Submitted& changed : r.changed) input = std::hypot(input, one.answer(changed) - coarse);
      if (!r.changed.empty()) measurement.told.input = input;
      return measurement;
    };
    const Cause* open = cause_of(experiment.undecided, one);
    const auto judged =
        claims.at(experiment.model + ", two spacings").only_if(open == nullptr, open == nullptr ? "" : open->reason);
    const Uncertainty criterion = experiment.known_within.empty() ? one.criterion() : one.criterion_of_run();
    if (const Cause* miss = cause_of(experiment.misses, one)) {
      constexpr double no_band = std::numeric_limits<double>::infinity();
      judged.known_failure(one.claim(), answer, criterion, {.width = no_band, .reason = miss->reason});
    } else {
      judged.check(one.claim(), answer, criterion);
    }
  }
}

Computed compute_experiment(const Experiment& experiment, const Run& run) {
  Computed r{.trials = trials_of(experiment, run)};
  if (!experiment.compute) return r;
  std::map<std::string, double> unused;
  r.fine = on_the_clock(experiment, run, experiment.compute(run, 1), r.shifts);
  run.progress(0.7);
  r.coarse = on_the_clock(experiment, run, experiment.compute(run, 2), unused);
  for (const auto& [parameter, factor] : experiment.known_within) {
    Run other = run;
    other.set(parameter, Value(run.real(parameter) / factor));
    r.changed.push_back(on_the_clock(experiment, run, experiment.compute(other, 2), unused));
  }
  return r;
}

void show_experiment(const Experiment& experiment, const Computed& computed, const Values& values,
                     evidence::Exhibit& exhibit) {
  for (const auto& [part, shift] : computed.shifts) exhibit.measure(part + "_time_shift", shift);
  const std::vector<Question> all = questions(experiment, values);
  list_uncertainties(all, exhibit);
  if (experiment.compute) {
    std::vector<Question> answered;
    std::vector<std::optional<double>> numerical;
    for (const Question& one : all) {
      if (!computed.fine.contains(one.part().name)) continue;
      answered.push_back(one);
      numerical.emplace_back(0.5 * std::abs(one.answer(computed.coarse) - one.answer(computed.fine)));
    }
    show_readings(answered, computed.fine, numerical, experiment.model, exhibit);
    show_calibration(experiment, values, computed.fine, exhibit);
  }
  for (const Series& part : experiment.parts) draw(part, measured(part, values), computed, experiment.model, exhibit);
}

}  // namespace seiche::validation::laboratory
