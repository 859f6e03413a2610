#include "validation/case/study.hpp"

#include <cmath>
#include <new>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

/// Judges what was measured; whatever keeps it from being measured is the claim's own error.
evidence::JudgedClaim judged(const DeclaredClaim& declared, const void* results) {
  evidence::JudgedClaim claim{declared.claim, declared.criterion, {}, declared.known_failure};
  try {
    const DeclaredClaim::Measured measured = declared.measured(results);
    if (const auto* order = std::get_if<evidence::ObservedOrder>(&measured)) {
      claim.judgement = judge(*order, std::get<Order>(declared.criterion));
    } else {
      const auto& measurement = std::get<Measurement>(measured);
      claim.criterion = settled(declared.criterion, measurement.told);
      claim.judgement = judge(measurement, claim.criterion);
    }
  } catch (const std::exception& failure) {
    claim.judgement = evidence::error(failure.what());
  }
  return claim;
}

void leave_out(const std::vector<DeclaredClaim>& claims, evidence::Record& record) {
  for (const DeclaredClaim& declared : claims) {
    if (!declared.left_out.empty()) record.leave_out({declared.claim, declared.left_out});
  }
}

}  // namespace

void fail_all(const std::vector<DeclaredClaim>& claims, const std::string& why, evidence::Record& record) {
  for (const DeclaredClaim& declared : claims) {
    if (!declared.left_out.empty()) continue;
    record.keep({declared.claim, declared.criterion, evidence::error("the run did not finish: " + why),
                 declared.known_failure});
  }
  leave_out(claims, record);
}

std::pair<std::string, std::string> name_and_unit(const std::string& text) {
  const auto bracket = text.rfind(" [");
  if (bracket == std::string::npos || text.back() != ']') return {text, ""};
  return {text.substr(0, bracket), text.substr(bracket + 2, text.size() - bracket - 3)};
}

evidence::Table& add_table(evidence::Exhibit& exhibit, std::string id, std::string title, std::string caption,
                           const std::vector<std::string>& columns, std::vector<std::string> tiles) {
  evidence::Table table{std::move(id), std::move(title), std::move(caption), {}, {}, std::move(tiles)};
  for (const std::string& column : columns) table.columns.push_back(name_and_unit(column));
  return exhibit.table(std::move(table));
}

evidence::Panel& add_panel(evidence::Exhibit& exhibit, const std::string& id, const std::string& title,
                           const std::string& caption, evidence::Axes axes, const std::vector<std::string>& tiles) {
  return exhibit.figure(id, title, caption, tiles).panel(std::move(axes));
}

Cell rounded(double value, double scale) {
  if (std::isnan(value)) return std::string();
  return std::round(value * scale) / scale;
}

DeclaredClaim::Measured detail::as_measured(const Worst& worst, const std::string& where) {
  return Measurement{.value = worst.value(), .where = fmt::format(fmt::runtime(where), worst.where())};
}

std::vector<DeclaredClaim> Study::claims(const Values& values) const {
  std::vector<DeclaredClaim> list = claims_(values);
  std::set<std::string> ids;
  bool any = false;
  for (const DeclaredClaim& declared : list) {
    if (!ids.insert(declared.claim.id).second) {
      throw std::logic_error(fmt::format("claim '{}' is declared twice", declared.claim.id));
    }
    any = any || declared.left_out.empty();
  }
  if (!any) throw std::logic_error("the case makes no claim at these parameters");
  return list;
}

void Study::run(const Run& run, evidence::Record& record) const {
  const std::vector<DeclaredClaim> list = claims(run);
  const auto broken = [&](const std::exception& failure) {
    record.error = failure.what();
    fail_all(list, record.error, record);
  };
  Computed results;
  try {
    results = compute_(run);
  } catch (const std::invalid_argument& refused) {
    // At a tier's own parameters there is no wrong input: the computation has gone wrong.
    if (!run.standard()) throw;
    return broken(refused);
  } catch (const std::bad_alloc&) {
    return broken(std::runtime_error("out of memory; reduce cells or particles, or store fewer time steps"));
  } catch (const std::exception& failure) {
    return broken(failure);
  }
  for (const DeclaredClaim& declared : list) {
    if (declared.left_out.empty()) record.keep(judged(declared, results.get()));
  }
  leave_out(list, record);
  try {
    show_(results.get(), run, record);
    if (record.figures().empty() && record.tables().empty()) throw std::logic_error("no figure and no table");
  } catch (const std::exception& failure) {
    record.error = fmt::format("its results could not be shown: {}", failure.what());
  }
}

}  // namespace seiche::validation
