/// How somebody else's result is judged by a case.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace seiche::evidence {
class Record;
}

namespace seiche::validation {

class Values;

struct Column {
  std::string name;
  std::string unit;
  std::string meaning;
};

/// Columns of equal length, by name.
using Columns = std::map<std::string, std::vector<double>>;

struct Submission {
  /// The first column is the abscissa, strictly increasing.
  std::vector<Column> columns;
  /// The abscissae at which a template asks for values.
  std::function<std::vector<double>(const Values&)> abscissae;
  /// Judges the columns and fills measurements, claims and figures of the record.
  std::function<void(const Values&, const Columns&, evidence::Record&)> judge;

  explicit operator bool() const { return static_cast<bool>(judge); }
};

}  // namespace seiche::validation
