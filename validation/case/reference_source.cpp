#include "validation/case/reference_source.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "validation/case/data_folder.hpp"
#include "validation/case/refusal.hpp"

namespace seiche::validation {
namespace {

/// One table of a source.toml, read key by key; finish() rejects keys that nobody asked for.
class Reader {
 public:
  Reader(std::string file, const toml::table& table) : file_(std::move(file)), table_(table) {}

  template <class T>
  void read(const std::string& key, T& value) {
    known_.push_back(key);
    if (const toml::node* node = table_.get(key)) take(key, *node, value);
  }

  void finish() const {
    for (const auto& [key, node] : table_) {
      if (std::ranges::find(known_, key.str()) == known_.end()) reject(std::string(key), "is not known");
    }
  }

 private:
  [[noreturn]] void reject(const std::string& key, const std::string& why) const { fail("{}: {} {}", file_, key, why); }

  template <class T>
  T value_of(const std::string& key, const toml::node& node, const char* otherwise) const {
    const auto found = node.value<T>();
    if (!found) reject(key, otherwise);
    return *found;
  }

  template <class T>
  void take(const std::string& key, const toml::node& node, T& value) const {
    value = value_of<T>(key, node, "has the wrong type");
  }
  void take(const std::string& key, const toml::node& node, std::vector<std::string>& names) const {
    constexpr const char* otherwise = "must be an array of strings";
    if (!node.is_array()) reject(key, otherwise);
    for (const toml::node& entry : *node.as_array()) names.push_back(value_of<std::string>(key, entry, otherwise));
  }
  template <class T>
  void take(const std::string& key, const toml::node& node, std::map<std::string, T>& entries) const {
    if (!node.is_table()) reject(key, "must be a table");
    for (const auto& [name, entry] : *node.as_table()) {
      take_entry(key + "." + std::string(name), entry, entries[std::string(name)]);
    }
  }

  void take_entry(const std::string& key, const toml::node& node, std::string& text) const {
    text = value_of<std::string>(key, node, "must be a string");
  }
  void take_entry(const std::string& key, const toml::node& node, ColumnUncertainty& uncertainty) const {
    Reader entry = table_in(key, node);
    entry.read("value", uncertainty.value);
    entry.read("relative", uncertainty.relative);
    entry.read("assumed", uncertainty.assumed);
    entry.read("reason", uncertainty.reason);
    entry.finish();
  }
  void take_entry(const std::string& key, const toml::node& node, std::map<std::string, std::string>& names) const {
    Reader entry = table_in(key, node);
    for (const auto& [name, text] : entry.table_) entry.read(std::string(name), names[std::string(name)]);
  }
  [[nodiscard]] Reader table_in(const std::string& key, const toml::node& node) const {
    if (!node.is_table()) reject(key, "must be a table");
    return {file_, *node.as_table()};
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
  if (!std::filesystem::is_regular_file(file)) fail("{} does not exist", file);
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
  reader.read("standard_uncertainty", source.standard_uncertainty);
  reader.read("codes", source.codes);
  reader.finish();
  return source;
}

}  // namespace seiche::validation
