#include "validation/case/reference_source.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "validation/case/data_folder.hpp"

namespace seiche::validation {
namespace {

/// One table of a source.toml, read key by key; finish() rejects keys that nobody asked for.
class Reader {
 public:
  Reader(std::string file, const toml::table& table) : file_(std::move(file)), table_(table) {}

  template <class T>
  void read(const std::string& key, T& value) {
    known_.push_back(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    const auto found = node->value<T>();
    if (!found) reject(key, "has the wrong type");
    value = *found;
  }

  void read(const std::string& key, std::vector<std::string>& names) {
    known_.push_back(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    if (!node->is_array()) reject(key, "must be an array of strings");
    for (const toml::node& entry : *node->as_array()) {
      const auto name = entry.value<std::string>();
      if (!name) reject(key, "must be an array of strings");
      names.push_back(*name);
    }
  }

  /// Calls each(name, reader of that table) for every subtable of `key`.
  template <class Each>
  void tables(const std::string& key, Each each) {
    for_entries(key, [&](const std::string& name, const toml::node& node) {
      if (!node.is_table()) reject(key + "." + name, "must be a table");
      Reader inner(file_, *node.as_table());
      each(name, inner);
    });
  }

  void read(const std::string& key, std::map<std::string, std::string>& texts) {
    for_entries(key, [&](const std::string& name, const toml::node& node) {
      const auto text = node.value<std::string>();
      if (!text) reject(key + "." + name, "must be a string");
      texts[name] = *text;
    });
  }

  void all(std::map<std::string, std::string>& texts) {
    for (const auto& entry : table_) read(std::string(entry.first), texts[std::string(entry.first)]);
  }

  void finish() const {
    for (const auto& entry : table_) {
      const std::string key(entry.first);
      if (std::find(known_.begin(), known_.end(), key) == known_.end()) reject(key, "is not known");
    }
  }

 private:
  [[noreturn]] void reject(const std::string& key, const std::string& why) const {
    throw std::invalid_argument(fmt::format("{}: {} {}", file_, key, why));
  }

  template <class Each>
  void for_entries(const std::string& key, Each each) {
    known_.push_back(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    if (!node->is_table()) reject(key, "must be a table");
    for (const auto& entry : *node->as_table()) each(std::string(entry.first), entry.second);
  }

  std::string file_;
  const toml::table& table_;
  std::vector<std::string> known_;
};

}  // namespace

std::filesystem::path reference_folder() {
  return data_folder("reference_data");
}

std::vector<std::string> reference_sources() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(reference_folder())) {
    if (std::filesystem::exists(entry.path() / "source.toml")) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

ReferenceSource reference_source(const std::string& name) {
  const std::string file = (reference_folder() / name / "source.toml").string();
  if (!std::filesystem::is_regular_file(file)) throw std::invalid_argument(file + " does not exist");
  const toml::table table = toml::parse_file(file);
  ReferenceSource source;
  Reader reader(file, table);
  reader.read("citation", source.citation);
  reader.read("what", source.what);
  reader.read("obtained", source.obtained);
  reader.read("licence", source.licence);
  reader.read("uncertainty", source.uncertainty);
  reader.read("uncertainty_reason", source.uncertainty_reason);
  reader.read("remarks", source.remarks);
  reader.read("recorded", source.recorded);
  reader.read("sha256", source.sha256);
  reader.read("abscissa", source.abscissa);
  reader.read("abscissa_repeats", source.abscissa_repeats);
  reader.read("group", source.group);
  reader.read("parameters", source.parameters);
  reader.read("units", source.units);
  reader.tables("standard_uncertainty", [&](const std::string& column, Reader& entry) {
    ColumnUncertainty& uncertainty = source.standard_uncertainty[column];
    entry.read("value", uncertainty.value);
    entry.read("relative", uncertainty.relative);
    entry.read("assumed", uncertainty.assumed);
    entry.read("reason", uncertainty.reason);
    entry.finish();
  });
  reader.tables("codes", [&](const std::string& column, Reader& names) { names.all(source.codes[column]); });
  reader.finish();
  return source;
}

}  // namespace seiche::validation
