/// What a user may set in a case, declared once: unit, default, range, meaning. Every error message follows from it.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "seiche/io/text_table.hpp"
#include "seiche/ranges.hpp"
#include "validation/case/tier.hpp"

namespace seiche::validation {

/// Of what was not measured, or is not known.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Value = std::variant<double, long, bool, std::string>;

struct Parameter {
  std::string name;
  std::string unit;
  std::string meaning;
  ByTier<Value> standard;  ///< default per tier
  double lowest = 0;       ///< closed range of a number
  double highest = 0;
  std::vector<std::string> choices = {};  ///< of a text

  /// "in [0, 100]" or "one of G1, M2, H2".
  [[nodiscard]] std::string range() const;
};

/// Declarations. Ranges are closed; NaN and infinities are never accepted.
Parameter real(std::string name, ByTier<double> standard, std::string unit, Range range, std::string meaning);
Parameter integer(std::string name, ByTier<long> standard, Range range, std::string meaning);
Parameter choice(std::string name, ByTier<std::string> standard, std::vector<std::string> choices, std::string meaning);
Parameter choice(std::string name, const char* standard, std::vector<std::string> choices, std::string meaning);
Parameter toggle(std::string name, ByTier<bool> standard, std::string meaning);

/// Parameters by name, with values.
using NamedValues = std::vector<std::pair<std::string, Value>>;

/// The parameters with which a source computed what a tile of the atlas shows. A tier is how much a run may cost, a
/// published set what the source did.
struct Published {
  std::vector<std::string>
      tiles;                ///< of reports/atlas.toml that a run with these values shows; the first names the set
  NamedValues values;       ///< what differs from the defaults of the tier
  Tier tier = Tier::quick;  ///< in which the set is run: the least one that can afford it
  std::vector<std::string> stated;  ///< parameters whose values the source states; about the others it is silent
  std::map<std::string, std::string> different;  ///< parameters with another value than the source's, and that
  std::string differs;                           ///< where the method is not the source's, and why; empty if nowhere
  std::vector<std::string> contradicted;         ///< claims of the source whose declared failure proves it wrong

  [[nodiscard]] const std::string& name() const { return tiles.front(); }
  [[nodiscard]] bool shows(std::string_view tile) const;
  /// Where a parameter's value comes from: "stated", "chosen", or "different" from the source's.
  [[nodiscard]] std::string origin(const std::string& parameter) const;
};

/// Values for a set of declared parameters.
class Values {
 public:
  using Sets = std::shared_ptr<const std::vector<Published>>;

  /// All defaults of a tier. @param sets  the published sets that these parameters may agree with
  Values(std::vector<Parameter> declared, Tier tier, Sets sets = {});
  /// The values of a published set.
  Values(std::vector<Parameter> declared, const Published& set, Sets sets);

  /// Sets one from text, as on the command line. @throws std::invalid_argument naming parameter, value and range
  void set(std::string_view name, const std::string& text);
  /// Sets one from a typed value, as from a configuration file; an integer serves as a real.
  void set(std::string_view name, const Value& value);

  [[nodiscard]] double real(std::string_view name) const { return get<double>(name); }
  [[nodiscard]] long integer(std::string_view name) const { return get<long>(name); }
  /// An integer as a real number, or as a size.
  [[nodiscard]] double number(std::string_view name) const { return static_cast<double>(integer(name)); }
  [[nodiscard]] std::size_t count(std::string_view name) const { return static_cast<std::size_t>(integer(name)); }
  [[nodiscard]] bool toggle(std::string_view name) const { return get<bool>(name); }
  [[nodiscard]] const std::string& text(std::string_view name) const { return get<std::string>(name); }

  [[nodiscard]] const std::vector<Parameter>& declared() const { return declared_; }
  [[nodiscard]] const std::map<std::string, Value, std::less<>>& all() const { return values_; }
  [[nodiscard]] Tier tier() const { return tier_; }
  /// Whether a run with these values shows that tile with the parameters of its source: those of the tile's set, in its
  /// tier or a longer one. @throws std::logic_error where no published set of the case shows the tile
  [[nodiscard]] bool as_published(std::string_view tile) const;
  /// Whether they are those of a published set, in its tier or a longer one.
  [[nodiscard]] bool are(const Published& set) const;
  /// Whether these parameters have these values.
  [[nodiscard]] bool are(const NamedValues& settings) const;
  /// The published sets of the case.
  [[nodiscard]] const std::vector<Published>& sets() const { return *sets_; }
  /// The set of this tier that they are, where they are not the tier's defaults: what names the run's record.
  [[nodiscard]] std::string set_name() const;
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
  Sets sets_;
  std::shared_ptr<std::map<std::string, std::string>> tables_read_ =
      std::make_shared<std::map<std::string, std::string>>();
};

}  // namespace seiche::validation
