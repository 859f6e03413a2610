#include "validation/studies/side_by_side/contest.hpp"
#include "validation/instruments/each.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation {
namespace {

/// Standard error of the rms of so many points.
double standard_error(const std::vector<double>& off) {
  const auto squares = over<Mean>(off, [](double one) { return one * one; });
  const double variance = squares.rms() * squares.rms() - squares.value() * squares.value();
  const double root = std::sqrt(squares.value());
  return root > 0 ? std::sqrt(std::max(variance, 0.0) / static_cast<double>(off.size())) / (2 * root) : 0;
}

/// What went wrong, without its time and place, which the table has beside it.
std::string cause_of(const Divergence& divergence) {
  const std::string words = divergence.what();
  return words.substr(0, words.rfind(" at x = "));
}

/// One racer on its way.
Attempt attempt(const Contender& contender, long resolution, const Trial& trial) {
  Attempt result{.error = nan, .uncertainty = nan, .energy = nan, .momentum = nan, .asked = trial.last};
  double began = processor_seconds();
  try {
    const Racer racer = contender.start(resolution);
    result.seconds = processor_seconds() - began;
    const Sight first = racer.look();
    const double interval = trial.last / static_cast<double>(trial.looks);
    bool at_end = false;
    for (long n = 1; n <= trial.looks && (result.cause.empty() || !at_end);) {
      const double look = interval * static_cast<double>(n);
      const double to = at_end ? look : std::min(look, trial.end);
      began = processor_seconds();
      racer.advance_to(to);
      if (!at_end) result.seconds += processor_seconds() - began;
      const Sight sight = racer.look();
      const double error = over<Mean>(sight.off, std::identity{}).rms();
      if (!at_end && to >= trial.end) {
        at_end = true;
        result.error = error;
        result.uncertainty = std::hypot(standard_error(sight.off), trial.reference_uncertainty);
        result.energy = (sight.energy - first.energy) / trial.energy_scale;
        result.momentum = std::abs(sight.momentum - first.momentum) / trial.momentum_scale;
      }
      const bool known = at_end || !sight.off.empty();
      if (known && !(error <= trial.useless) && result.cause.empty()) {
        result.cause = std::isnan(error) ? "its surface has vanished" : trial.useless_in_words;
      }
      if (result.cause.empty()) result.lasted = to;
      if (to >= look) ++n;
    }
  } catch (const Divergence& divergence) {
    if (result.cause.empty()) {
      result.lasted = divergence.time();
      result.cause = cause_of(divergence);
    }
  } catch (const std::invalid_argument& refusal) {
    if (!contender.may_refuse) throw;
    result.cause = fmt::format("cannot start: {}", refusal.what());
  }
  return result;
}

}  // namespace

evidence::ObservedOrder Entry::order() const {
  return evidence::observed_order(each(attempts, &Attempt::size), each(attempts, &Attempt::error));
}

const Entry& Contest::of(const std::string& id) const {
  const auto found = std::ranges::find(entries_, id, &Entry::id);
  if (found != entries_.end()) return *found;
  throw std::logic_error("unknown model of the comparison \"" + id + "\"");
}

Contest contest(const Run& run, const std::vector<Contender>& contenders, const Trial& trial) {
  if (trial.end > trial.last) {
    throw std::invalid_argument(
        fmt::format("time: errors are compared at t = {:g}; must not be later than the last = {:g}, until which the "
                    "models are followed",
                    trial.end, trial.last));
  }
  std::vector<Entry> entries;
  std::vector<std::function<void()>> work;
  entries.reserve(contenders.size());
  for (const Contender& one : contenders) {
    Entry& entry = entries.emplace_back(Entry{one.id, one.name, one.size_of, one.role, {}});
    for (const long n : one.resolutions) {
      work.emplace_back([&entry, &one, &trial, n] {
        entry.attempts.push_back(attempt(one, n, trial));
        entry.attempts.back().size = one.size(n);
      });
    }
  }
  one_by_one(run, work);
  return {std::move(entries), trial};
}

void Contest::show(evidence::Exhibit& exhibit, const Units& units) const {
  auto& cost =
      add_panel(exhibit, "cost", "Error against processor time",
                fmt::format("Of each model at its resolutions, coarse to fine, at t = {:.4g}.", trial_.end),
                {.x = "processor time [s]", .y = fmt::format("error [{}]", units.error), .log_x = true, .log_y = true});
  const auto in = [](const std::string& name, const std::string& unit) { return name + " [" + unit + "]"; };
  evidence::Table& table = add_table(exhibit, "side_by_side", "Comparison of the models",
                                     fmt::format("Error, processor time and change of energy and momentum until t = "
                                                 "{:.4g}; continued to t = {:.4g}, or until {}.",
                                                 trial_.end, trial_.last, trial_.useless_in_words),
                                     {"model", "size of", in("size", units.size), in("error", units.error),
                                      in("uncertainty", units.error), "processor time [s]", "energy [1]",
                                      "momentum [1]", in("lasted", units.time), in("asked", units.time), "broke by"});
  for (const Entry& entry : entries_) {
    for (const Attempt& one : entry.attempts) {
      table.rows.push_back({entry.name, entry.size_of, one.size, one.error, one.uncertainty, one.seconds, one.energy,
                            one.momentum, one.lasted, one.asked, one.cause});
    }
    auto known = entry.attempts | std::views::filter([](const Attempt& one) { return !std::isnan(one.error); });
    if (known.empty()) continue;
    cost.points(entry.name, each(known, &Attempt::seconds), each(known, &Attempt::error), entry.role,
                each(known, &Attempt::uncertainty));
  }
}

std::vector<long> ladder_to(long finest, const std::vector<double>& parts) {
  std::vector<long> all;
  for (const double part : parts) all.push_back(std::lround(static_cast<double>(finest) * part));
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Claims<Entry> claims_of(const Claims<Contest>& claims, const std::string& id) {
  return claims.of([id](const Contest& all) -> const Entry& { return all.of(id); });
}

double error_of_finest(const Entry& entry) {
  return entry.finest().error;
}
double energy_of_finest(const Entry& entry) {
  return entry.finest().energy;
}

void claim_lasts(const Claims<Entry>& claims, const Named& model, double last, const std::string& source) {
  claims.from(source).check(
      model.id + "-lasts", fmt::format("The time of the run equals the end time to 1e-9 ({}).", model.name),
      "time of breakdown", [](const Entry& entry) { return entry.finest().lasted; },
      Bound{.limit = 1e-9, .reason = "the requested time", .expected = last});
}

void claim_breaks(const Claims<Entry>& claims, const Named& model, const std::string& reason,
                  const std::string& source) {
  claims.from(source).check(
      model.id + "-breaks", fmt::format("The run breaks down before the end time ({}).", model.name),
      "a run at one of its resolutions breaks down earlier",
      [](const Entry& entry) { return std::ranges::any_of(entry.attempts, &Attempt::broke); },
      Qualitative{.detector = "the run stops, or its error exceeds the limit of the comparison", .reason = reason});
}

void claim_dissipates(const Claims<Entry>& claims, const Named& model, const std::string& reason,
                      const std::string& source) {
  claims.from(source).check(
      model.id + "-dissipates", fmt::format("The final energy is below the initial energy ({}).", model.name),
      "the energy falls at every resolution",
      [](const Entry& entry) {
        return std::ranges::all_of(entry.attempts, [](const Attempt& one) { return one.energy < 0; });
      },
      Qualitative{.detector = "final minus initial energy is negative", .reason = reason});
}

void claim_energy(const Claims<Entry>& claims, const Named& model, double operations, double scale,
                  const std::string& reason, const std::string& source) {
  claims.from(source).check(model.id + "-energy", fmt::format("The energy is conserved to round-off ({}).", model.name),
                            "relative change", energy_of_finest,
                            Roundoff{.operations = operations, .scale = scale, .reason = reason});
}

}  // namespace seiche::validation
