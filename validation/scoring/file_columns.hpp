#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/scoring/submitted.hpp"

namespace seiche::validation {

/// Whether a number stands for no value: submitted_from() says which do.
bool is_missing(double value);

/// The columns of a file by the names and in the units that a table asks for.
class FileColumns {
 public:
  /// @param alone  whether no other table is asked for: what is left then is the one quantity
  FileColumns(const io::Table& file, const WantedTable& wanted, bool alone, Understanding& understood)
      : file_(file), wanted_(wanted), alone_(alone), understood_(understood) {}

  /// The name of a wanted column in the file: as --map says, the same, or one of the usual others; what is left where
  /// one quantity alone is asked for.
  [[nodiscard]] const std::optional<std::string>& find(const Column& column) const;
  /// A column of the file in the wanted unit. @param in_file  its name there, where find() does not know it
  [[nodiscard]] const std::vector<double>& values(const Column& column, const std::string& in_file = {}) const;

  [[noreturn]] void fail(const Column& column, const std::string& what) const;
  [[noreturn]] void fail(const Column& column, std::size_t row, const std::string& what) const;
  /// Says once what was made of the file.
  void note(const std::string& what) const;

 private:
  [[nodiscard]] std::optional<std::string> found(const Column& column) const;
  [[nodiscard]] bool is_wanted(const std::string& name) const;
  [[nodiscard]] bool means_another(const std::string& name) const;

  const io::Table& file_;
  const WantedTable& wanted_;
  bool alone_;
  Understanding& understood_;
  mutable std::map<std::string, std::optional<std::string>> found_;
  mutable std::map<std::string, std::vector<double>> converted_;
};

}  // namespace seiche::validation
