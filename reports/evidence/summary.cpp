#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

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
          .verdict = claim.at("verdict"),
          .declared = claim.at("declared"),
          .note = claim.at("note"),
          .measured = number(claim.at("measured")),
          .limit = number(claim.at("criterion").at("limit")),
          .expected = number(claim.at("expected"))};
}

}  // namespace

bool Summary::as_declared() const {
  return error.empty() &&
         std::all_of(claims.begin(), claims.end(), [](const Outcome& c) { return c.verdict == c.declared; });
}

Summary read_summary(const std::filesystem::path& json_file) {
  try {
    const auto json = nlohmann::json::parse(io::read_file(json_file));
    Summary s;
    s.name = json.at("case");
    s.kind = json.at("kind");
    s.group = json.at("group");
    s.tier = json.at("tier");
    s.solver = json.at("solver");
    s.error = json.at("error");
    s.fingerprint = json.at("fingerprint");
    s.wall_time = number(json.at("wall_time"));
    for (const auto& claim : json.at("claims")) s.claims.push_back(outcome_from(claim));
    for (const auto& [quantity, value] : json.at("measurements").items()) s.measurements[quantity] = number(value);
    s.reference_data = json.at("provenance").at("reference_data").get<std::map<std::string, std::string>>();
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

void write_junit(const std::vector<Summary>& records, const std::filesystem::path& file) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = "seiche";
  for (const Summary& record : records) {
    pugi::xml_node suite = root.append_child("testsuite");
    suite.append_attribute("name") = (record.group + "." + record.name).c_str();
    suite.append_attribute("tests") = static_cast<int>(record.claims.size()) + (record.error.empty() ? 0 : 1);
    suite.append_attribute("time") = record.wall_time;
    int failures = 0;
    for (const Summary::Outcome& claim : record.claims) {
      pugi::xml_node test = suite.append_child("testcase");
      test.append_attribute("classname") = record.name.c_str();
      test.append_attribute("name") = claim.id.c_str();
      if (claim.verdict == claim.declared) continue;
      ++failures;
      pugi::xml_node failure = test.append_child("failure");
      failure.append_attribute("message") =
          fmt::format("{}: measured {:.17g}, expected {:.17g} within {:.3g}; verdict {}, declared {}", claim.text,
                      claim.measured, claim.expected, claim.limit, claim.verdict, claim.declared)
              .c_str();
    }
    suite.append_attribute("failures") = failures;
    suite.append_attribute("errors") = record.error.empty() ? 0 : 1;
    if (!record.error.empty()) {
      pugi::xml_node test = suite.append_child("testcase");
      test.append_attribute("classname") = record.name.c_str();
      test.append_attribute("name") = "run";
      test.append_child("error").append_attribute("message") = record.error.c_str();
    }
  }
  std::ostringstream text;
  document.save(text, "  ");
  io::write_file(file, text.str());
}

}  // namespace seiche::evidence
