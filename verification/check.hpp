/// A Catch2 test that writes a record: the report shows it beside the validation cases.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <chrono>
#include <source_location>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"

namespace seiche::verification {

using evidence::Bound;
using evidence::observed_order;
using evidence::Order;
using evidence::Qualitative;
using evidence::Role;
using evidence::Roundoff;

/// Mesh widths or steps, and the error with each.
struct Convergence {
  std::vector<double> sizes = {}, errors = {};

  void add(double size, double error) {
    sizes.push_back(size);
    errors.push_back(error);
  }
  /// @param floor  errors at or below it are round-off
  [[nodiscard]] evidence::ObservedOrder order(double floor = 0) const { return observed_order(sizes, errors, floor); }
};

class Check {
 public:
  /// @param name     name of the record, unique, [a-z0-9_]+
  /// @param title    what the page is called
  /// @param article  Markdown: what is checked and why the tolerances are what they are
  Check(const std::string& name, const std::string& title, const std::string& article,
        std::source_location where = std::source_location::current());
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;
  Check(Check&&) = delete;
  Check& operator=(Check&&) = delete;
  /// Writes the record; a test that ends by an exception writes it as an error.
  ~Check();

  /// Where claims come from that do not say it themselves.
  void source(const std::string& text) { source_ = text; }
  /// Judges, records, and fails the Catch2 test unless the verdict is pass.
  void that(const evidence::Claim& claim, const evidence::Measurement& measurement,
            const evidence::Criterion& criterion);
  void that(const evidence::Claim& claim, const evidence::ObservedOrder& observed, const evidence::Order& criterion);
  /// Judges, and fails the Catch2 test unless the verdict is pass. What holds for every one of many configurations, and
  /// what the tool owes its user, is one claim `assertions` of the check with a table of its own; its measure is the
  /// largest part of a limit that is used. @param what  a sentence, with the configuration in front where there are
  /// many
  void holds(const std::string& what, const evidence::Measurement& measurement, const evidence::Criterion& criterion);
  void holds(const std::string& what, const evidence::ObservedOrder& observed, const evidence::Order& criterion);
  /// Judges, records, and fails the Catch2 test unless the claim fails as declared.
  void known_failure(const evidence::Claim& claim, const evidence::Measurement& measurement,
                     const evidence::Criterion& criterion, const evidence::KnownFailure& failure);

  evidence::Figure& figure(const std::string& id, const std::string& title, const std::string& caption,
                           const std::vector<std::string>& tiles = {}) {
    return record_.figure(id, title, caption, tiles);
  }
  evidence::Table& table(evidence::Table table) { return record_.table(std::move(table)); }
  evidence::Record& record() { return record_; }

 private:
  /// Fails the Catch2 test unless the claim came out as declared.
  void expect(const std::string& id);
  void expect(const std::string& what, const char* kind, const std::string& reason,
              const evidence::Judgement& judgement);

  evidence::Record record_;
  [[nodiscard]] evidence::Claim sourced(evidence::Claim claim) const {
    if (claim.source.empty()) claim.source = source_;
    return claim;
  }

  evidence::Table assertions_;
  Worst used_;  ///< of the limits of the assertions
  std::chrono::steady_clock::time_point begin_;
  int exceptions_;
  std::string source_;
};

}  // namespace seiche::verification
