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
  /// @param source   where claims come from that do not say it themselves
  Check(const std::string& name, const std::string& title, const std::string& article, std::string source = {},
        std::source_location where = std::source_location::current());
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;
  Check(Check&&) = delete;
  Check& operator=(Check&&) = delete;
  /// Writes the record; a test that ends by an exception writes it as an error.
  ~Check();

  /// Where the claims that follow come from, if they do not say it themselves.
  void source(const std::string& text) { source_ = text; }
  /// Where the next claim comes from.
  Check& from(const std::string& text) {
    next_source_ = text;
    return *this;
  }
  /// The resolution of the measurements that follow, if they do not say it themselves.
  void at(const std::string& text) { resolution_ = text; }
  /// Judges, records, and fails the Catch2 test unless the verdict is pass.
  ///
  /// @param quantity  what is measured, with its unit in brackets unless that is 1: "run-up [depth]"
  void that(const std::string& id, const std::string& text, const std::string& quantity,
            const evidence::Measurement& measurement, const evidence::Criterion& criterion) {
    that(claim(id, text, quantity), measurement, criterion);
  }
  void that(const std::string& id, const std::string& text, const std::string& quantity,
            const evidence::ObservedOrder& observed, const evidence::Order& criterion) {
    that(claim(id, text, quantity), observed, criterion);
  }
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
  void known_failure(const std::string& id, const std::string& text, const std::string& quantity,
                     const evidence::Measurement& measurement, const evidence::Criterion& criterion,
                     const evidence::KnownFailure& failure) {
    known_failure(claim(id, text, quantity), measurement, criterion, failure);
  }
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
  [[nodiscard]] evidence::Claim claim(const std::string& id, const std::string& text, const std::string& quantity);
  [[nodiscard]] evidence::Claim sourced(evidence::Claim claim) const {
    if (claim.source.empty()) claim.source = source_;
    return claim;
  }
  [[nodiscard]] evidence::Measurement resolved(evidence::Measurement measurement) const {
    if (measurement.resolution.empty()) measurement.resolution = resolution_;
    return measurement;
  }

  evidence::Table assertions_;
  Worst used_;  ///< of the limits of the assertions
  std::chrono::steady_clock::time_point begin_;
  int exceptions_;
  std::string source_, next_source_, resolution_;
};

}  // namespace seiche::verification
