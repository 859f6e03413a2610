#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/evidence/record_files.hpp"
#include "seiche/io/atomic_file.hpp"

namespace seiche::evidence {
namespace {

double number(const nlohmann::json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Summary::Outcome outcome_from(const nlohmann::json& claim) {
  return {.id = claim.at("id"),
          .text = claim.at("text"),
          .unit = claim.at("unit"),
          .resolution = claim.at("resolution"),
          .kind = claim.at("criterion").at("kind"),
          .verdict = claim.at("verdict"),
          .declared = claim.at("declared"),
          .declared_reason = claim.at("declared_reason"),
          .note = claim.at("note"),
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

Summary read_summary(const std::filesystem::path& json_file) {
  try {
    const auto json = nlohmann::json::parse(io::read_file(json_file));
    Summary s;
    s.name = json.at("case");
    s.kind = json.at("kind");
    s.group = json.at("group");
    s.tier = json.at("tier");
    s.set = json.value("set", "");  // absent before sets were published
    s.shows = shown_set(json);
    s.standard = !s.set.empty() || has_defaults(json);
    s.solver = json.at("solver");
    s.error = json.at("error");
    s.fingerprint = json.at("fingerprint");
    const auto& provenance = json.at("provenance");
    s.commit = provenance.at("commit").get<std::string>() + (provenance.at("dirty").get<bool>() ? "-dirty" : "");
    s.date = provenance.at("date");
    s.wall_time = number(json.at("wall_time"));
    for (const auto& claim : json.at("claims")) s.claims.push_back(outcome_from(claim));
    for (const auto& [quantity, value] : json.at("measurements").items()) s.measurements[quantity] = number(value);
    s.reference_data = provenance.at("reference_data").get<std::map<std::string, std::string>>();
    return s;
  } catch (const nlohmann::json::exception& failure) {
    throw std::runtime_error(fmt::format("{} is not a record: {}", json_file.string(), failure.what()));
  }
}

std::vector<Summary> read_summaries(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory)) {
    throw std::runtime_error(fmt::format("{} is not a folder", directory.string()));
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Summary> summaries;
  summaries.reserve(files.size());
  for (const auto& file : files) summaries.push_back(read_summary(file));
  return summaries;
}

}  // namespace seiche::evidence
