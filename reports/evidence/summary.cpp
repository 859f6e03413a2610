#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/evidence/provenance.hpp"
#include "reports/evidence/record_files.hpp"
#include "reports/evidence/seal.hpp"
#include "seiche/io/atomic_file.hpp"
#include "seiche/wording.hpp"

namespace seiche::evidence {
namespace {

using Files = std::map<std::string, std::string>;

constexpr std::uintmax_t largest_record = 8U << 20U;  // [byte], sixty times the largest of ours

/// @throws std::runtime_error where the file is a link, which may lead anywhere, no file, or larger than any record
std::string text_of(const std::filesystem::path& json_file) {
  std::error_code unreachable;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(json_file, unreachable))) {
    throw std::runtime_error(fmt::format("{} is not a record: links and pipes are not followed", json_file.string()));
  }
  const std::uintmax_t size = std::filesystem::file_size(json_file, unreachable);
  if (size > largest_record) {
    throw std::runtime_error(fmt::format("{} is not a record: {} bytes, more than the {} that one may have",
                                         json_file.string(), size, largest_record));
  }
  return io::read_file(json_file);
}

/// Which of the files beside a record is not as it was written, in words; nothing where all are.
std::string changed(const std::filesystem::path& json_file, const Files& beside) {
  for (const auto& [name, digest] : beside) {
    const std::filesystem::path file = json_file.parent_path() / std::filesystem::path(name).filename();
    std::error_code unreachable;
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, unreachable))) {
      return fmt::format("{} is missing, which was written with the record", printable(name));
    }
    if (sha256_of_file(file) != digest) {
      return fmt::format("{} is not the file that was written with the record: its digest differs", printable(name));
    }
  }
  return {};
}

std::string word(const nlohmann::json& text) {
  return printable(text.get<std::string>());
}

double number(const nlohmann::json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Scalar scalar(const nlohmann::json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<long>();
  if (value.is_string()) return word(value);
  return number(value);
}

Summary::Outcome outcome_from(const nlohmann::json& claim) {
  return {.id = word(claim.at("id")),
          .text = word(claim.at("text")),
          .unit = word(claim.at("unit")),
          .resolution = word(claim.at("resolution")),
          .kind = word(claim.at("criterion").at("kind")),
          .verdict = word(claim.at("verdict")),
          .declared = word(claim.at("declared")),
          .declared_reason = word(claim.at("declared_reason")),
          .note = word(claim.at("note")),
          // Records written before failures were declared with a band.
          .as_declared = claim.value("as_declared", claim.at("verdict") == claim.at("declared")),
          .measured = number(claim.at("measured")),
          .uncertainty = number(claim.at("uncertainty")),
          .limit = number(claim.at("criterion").at("limit")),
          .expected = number(claim.at("expected")),
          .band = claim.value("declared_band", nlohmann::json()).is_array() ? number(claim["declared_band"].at(1))
                                                                            : number(nullptr)};
}

/// The first tile of a published set that the parameters are equal to.
std::string shown_set(const nlohmann::json& record) {
  std::string shown = record.value("set", "");
  for (const auto& set : record.value("published", nlohmann::json::array())) {
    if (shown.empty() && set.at("here").get<bool>()) shown = set.at("tiles").at(0);
  }
  return shown;
}

bool has_defaults(const nlohmann::json& record) {
  const auto& parameters = record.at("parameters");
  return std::all_of(parameters.begin(), parameters.end(),
                     [](const auto& p) { return p.at("value") == p.at("default"); });
}

}  // namespace

bool Summary::as_declared() const {
  return error.empty() && std::all_of(claims.begin(), claims.end(), [](const Outcome& c) { return c.as_declared; });
}

Summary read_summary(const std::filesystem::path& json_file, Reading reading) {
  try {
    const std::string content = text_of(json_file);
    const auto json = nlohmann::json::parse(content);
    Summary s;
    s.name = word(json.at("case"));
    s.kind = word(json.at("kind"));
    s.group = word(json.at("group"));
    s.tier = word(json.at("tier"));
    s.set = printable(json.value("set", ""));  // absent before sets were published
    s.shows = printable(shown_set(json));
    s.standard = !s.set.empty() || has_defaults(json);
    s.solver = word(json.at("solver"));
    s.error = word(json.at("error"));
    s.fingerprint = word(json.at("fingerprint"));
    const auto& provenance = json.at("provenance");
    s.commit = word(provenance.at("commit")) + (provenance.at("dirty").get<bool>() ? "-dirty" : "");
    s.date = word(provenance.at("date"));
    s.wall_time = number(json.at("wall_time"));
    for (const auto& [name, parameter] : json.at("parameters").items()) {
      s.parameters[printable(name)] = scalar(parameter.at("value"));
    }
    for (const auto& claim : json.at("claims")) s.claims.push_back(outcome_from(claim));
    for (const auto& [quantity, value] : json.at("measurements").items())
      s.measurements[printable(quantity)] = number(value);
    s.reference_data = provenance.at("reference_data").get<std::map<std::string, std::string>>();
    s.files = json.value("files", std::map<std::string, std::string>());
    s.sealed = is_sealed(content);
    std::string change;
    if (json.contains("digest") && !s.sealed) {
      change = "the record was changed after it was written: its digest differs";
    } else if (reading == Reading::all_files) {
      change = changed(json_file, s.files);
    }
    if (!change.empty()) s.error = change;
    return s;
  } catch (const nlohmann::json::exception& failure) {
    throw std::runtime_error(
        fmt::format("{} is not a record: {}", json_file.string(), printable(failure.what()).substr(0, 300)));
  }
}

std::vector<std::filesystem::path> record_files(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory)) {
    throw std::invalid_argument(fmt::format("{} is not a folder", directory.string()));
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Summary> read_summaries(const std::filesystem::path& directory, Reading reading) {
  std::vector<Summary> summaries;
  for (const auto& file : record_files(directory)) summaries.push_back(read_summary(file, reading));
  return summaries;
}

}  // namespace seiche::evidence
