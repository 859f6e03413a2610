/// What source.toml says about a reference table: where its numbers come from, their units, how well they are known.
#pragma once

#include <cmath>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace seiche::validation {

/// Standard uncertainty of one column.
struct ColumnUncertainty {
  double value = 0;  ///< in the column's unit, or a fraction of the entry if relative
  bool relative = false;
  bool assumed = true;  ///< estimated by us because the source states none
  std::string reason;

  [[nodiscard]] double of(double entry) const { return relative ? value * std::abs(entry) : value; }
};

struct ReferenceSource {
  std::string citation;
  std::string what;      ///< what the numbers are
  std::string obtained;  ///< printed, digitised, formula, by whom
  std::string licence;   ///< of a published digitisation, else empty
  std::string uncertainty;
  std::string uncertainty_reason;
  std::string remarks;
  std::string recorded;
  std::string sha256;
  std::vector<std::string> abscissa;    ///< columns that increase from row to row
  bool abscissa_repeats = false;        ///< ... or stay
  std::vector<std::string> group;       ///< columns whose values name a series; abscissae increase within one
  std::vector<std::string> parameters;  ///< columns that describe the row and carry no uncertainty of their own
  std::map<std::string, std::string> units;
  std::map<std::string, ColumnUncertainty> standard_uncertainty;
  /// Meaning of the numbers in columns that encode names: column -> entry -> name.
  std::map<std::string, std::map<std::string, std::string>> codes;
};

/// The folder reference_data of this program. Throws std::runtime_error if there is none.
std::filesystem::path reference_folder();

/// Names of the tables, one per folder that holds source.toml, sorted.
std::vector<std::string> reference_sources();

/// Reads reference_data/<name>/source.toml. Fields that are absent stay empty.
/// @throws std::invalid_argument naming the file and the key for a field of the wrong type, a key that is not known, or
/// a name without a file
ReferenceSource reference_source(const std::string& name);

}  // namespace seiche::validation
