#include "validation/case/reference_table.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "reports/evidence/provenance.hpp"
#include "validation/case/reference_source.hpp"

namespace seiche::validation {
io::Table reference_table(const std::string& source, std::map<std::string, std::string>& read) {
  const std::filesystem::path folder = reference_folder() / source;
  const std::filesystem::path table = folder / "table.csv";
  const toml::table description = toml::parse_file((folder / "source.toml").string());
  const std::string digest = evidence::sha256_of_file(table);
  if (description["sha256"].value_or<std::string>("") != digest) {
    throw std::runtime_error(
        fmt::format("{} has SHA-256 {}, which is not the one in source.toml", table.string(), digest));
  }
  read[table.string()] = digest;
  return io::read_csv(table);
}

namespace {

bool row_has(const io::Table& table, std::size_t row, const std::map<std::string, double>& numbers) {
  return std::ranges::all_of(
      numbers, [&](const auto& one) { return std::abs(table.column(one.first)[row] - one.second) < 1e-9; });
}

}  // namespace

std::optional<std::size_t> row_where(const io::Table& table, const std::map<std::string, double>& numbers) {
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (row_has(table, k, numbers)) return k;
  }
  return {};
}

io::Table rows_where(const io::Table& table, const std::map<std::string, double>& numbers) {
  io::Table found = table;
  for (std::vector<double>& column : found.columns) column.clear();
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (!row_has(table, k, numbers)) continue;
    for (std::size_t c = 0; c < found.columns.size(); ++c) found.columns[c].push_back(table.columns[c][k]);
  }
  return found;
}

std::optional<double> entry_where(const io::Table& table, const std::map<std::string, double>& numbers,
                                  const std::string& column) {
  const auto row = row_where(table, numbers);
  return row ? std::optional(table.column(column)[*row]) : std::nullopt;
}

}  // namespace seiche::validation
