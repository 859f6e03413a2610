/// What a user may set in a case, declared once: unit, default, range, meaning. Every error message follows from it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "seiche/io/table.hpp"
#include "validation/case/tier.hpp"

namespace seiche::validation {

using Value = std::variant<double, long, bool, std::string>;

struct Parameter {
  std::string name;
  std::string unit;
  std::string meaning;
  ByTier<Value> standard;  ///< default per tier
  double lowest = 0;       ///< closed range of a number
  double highest = 0;
  std::vector<std::string> choices;  ///< of a text

  /// "in [0, 100]" or "one of G1, M2, H2".
  [[nodiscard]] std::string range() const;
};

struct Range {
  double lowest;
  double highest;
};

/// Declarations. Ranges are closed; NaN and infinities are never accepted.
Parameter real(std::string name, ByTier<double> standard, std::string unit, Range range, std::string meaning);
Parameter integer(std::string name, ByTier<long> standard, Range range, std::string meaning);
Parameter choice(std::string name, ByTier<std::string> standard, std::vector<std::string> choices, std::string meaning);
Parameter toggle(std::string name, ByTier<bool> standard, std::string meaning);

/// Values for a set of declared parameters.
class Values {
 public:
  /// All defaults of a tier.
  Values(std::vector<Parameter> declared, Tier tier);

  /// Sets one from text, as on the command line. @throws std::invalid_argument naming parameter, value and range
  void set(std::string_view name, const std::string& text);
  /// Sets one from a typed value, as from a configuration file; an integer serves as a real.
  void set(std::string_view name, const Value& value);

  [[nodiscard]] double real(std::string_view name) const { return get<double>(name); }
  [[nodiscard]] long integer(std::string_view name) const { return get<long>(name); }
  [[nodiscard]] bool toggle(std::string_view name) const { return get<bool>(name); }
  [[nodiscard]] const std::string& text(std::string_view name) const { return get<std::string>(name); }

  [[nodiscard]] const std::vector<Parameter>& declared() const { return declared_; }
  [[nodiscard]] const std::map<std::string, Value, std::less<>>& all() const { return values_; }
  [[nodiscard]] Tier tier() const { return tier_; }
  /// Whether every parameter has its quick default, which is the publication's own where there is one.
  [[nodiscard]] bool as_published() const { return canonical() == Values(declared_, Tier::quick).canonical(); }
  /// Whether every parameter has the default of its own tier.
  [[nodiscard]] bool standard() const { return canonical() == Values(declared_, tier_).canonical(); }
  /// "name=value" per line with 17 digits: equal text means equal run.
  [[nodiscard]] std::string canonical() const;

  /// A table of reference_data/. What was read is kept, for the record. @throws std::runtime_error as reference_table()
  [[nodiscard]] io::Table table(const std::string& source) const;
  /// Path -> SHA-256 of the tables read with these values and their copies.
  [[nodiscard]] const std::map<std::string, std::string>& tables_read() const { return *tables_read_; }

 private:
  [[nodiscard]] const Parameter& find(std::string_view name) const;
  /// @throws std::logic_error when a case asks for a parameter it did not declare, or for another type
  template <class T>
  [[nodiscard]] const T& get(std::string_view name) const;

  std::vector<Parameter> declared_;
  std::map<std::string, Value, std::less<>> values_;
  Tier tier_;
  std::shared_ptr<std::map<std::string, std::string>> tables_read_ =
      std::make_shared<std::map<std::string, std::string>>();
};

}  // namespace seiche::validation
