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

#include "reports/evidence/record.hpp"

namespace seiche::verification {

using evidence::Role;

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

  /// Judges, records, and fails the Catch2 test unless the verdict is pass.
  void that(const evidence::Claim& claim, const evidence::Measurement& measurement,
            const evidence::Criterion& criterion);
  void that(const evidence::Claim& claim, const evidence::ObservedOrder& observed, const evidence::Order& criterion);
  /// Judges, records, and fails the Catch2 test unless the claim fails as declared.
  void known_failure(const evidence::Claim& claim, const evidence::Measurement& measurement,
                     const evidence::Criterion& criterion, const evidence::KnownFailure& failure);

  void measure(const std::string& quantity, double value) { record_.measure(quantity, value); }
  evidence::Figure& figure(const std::string& id, const std::string& title, const std::string& caption,
                           const std::vector<std::string>& tiles = {}) {
    return record_.figure(id, title, caption, tiles);
  }
  evidence::Table& table(evidence::Table table) { return record_.table(std::move(table)); }
  evidence::Record& record() { return record_; }

 private:
  /// Fails the Catch2 test unless the claim came out as declared.
  void expect(const std::string& id);

  evidence::Record record_;
  std::chrono::steady_clock::time_point begin_;
  int exceptions_;
};

}  // namespace seiche::verification
