#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "reports/evidence/record_files.hpp"
#include "reports/evidence/record_lock.hpp"
#include "seiche/io/atomic_file.hpp"

namespace seiche::evidence {
namespace {

/// XML 1.0 has no control characters but tab and line ends, not even escaped.
std::string printable(std::string text) {
  const auto forbidden = [](unsigned char c) { return c < 0x20 && c != '\t' && c != '\n' && c != '\r'; };
  std::replace_if(text.begin(), text.end(), forbidden, '?');
  return text;
}

void set(pugi::xml_node node, const char* attribute, const std::string& value) {
  node.append_attribute(attribute) = printable(value).c_str();
}

std::string seconds(double time) {
  return fmt::format("{:.3f}", std::isfinite(time) ? time : 0.0);
}

void add_properties(pugi::xml_node parent, const std::vector<std::pair<const char*, std::string>>& properties) {
  pugi::xml_node list = parent.append_child("properties");
  for (const auto& [name, value] : properties) {
    if (value.empty()) continue;
    pugi::xml_node property = list.append_child("property");
    set(property, "name", name);
    set(property, "value", value);
  }
}

struct Totals {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
  double time = 0;

  Totals& operator+=(const Totals& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    skipped += other.skipped;
    time += other.time;
    return *this;
  }
};

void set_totals(pugi::xml_node node, const Totals& totals) {
  node.append_attribute("tests") = totals.tests;
  node.append_attribute("failures") = totals.failures;
  node.append_attribute("errors") = totals.errors;
  node.append_attribute("skipped") = totals.skipped;
  set(node, "time", seconds(totals.time));
}

/// A test case of a suite. The suite's name qualifies it: claims of several records of one case share their ids.
pugi::xml_node add_case(pugi::xml_node suite, const std::string& id, double time) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", suite.attribute("name").value());
  set(test, "name", id);
  set(test, "time", seconds(time));
  return test;
}

/// An outcome other than passed. Some systems show the attribute `message`, others the element's text.
void add_outcome(pugi::xml_node test, const char* element, const std::string& type, const std::string& message) {
  pugi::xml_node outcome = test.append_child(element);
  set(outcome, "type", type);
  set(outcome, "message", message);
  outcome.text() = printable(message).c_str();
}

std::string in_numbers(const Summary::Outcome& claim) {
  const std::string spread = std::isnan(claim.uncertainty) ? "" : fmt::format(" +- {:.3g}", claim.uncertainty);
  return fmt::format("{} Measured {:.6g}{}, expected {:.6g} within {:.3g}{}{}.{}{}", claim.text, claim.measured, spread,
                     claim.expected, claim.limit, claim.unit == "1" ? "" : " ", claim.unit == "1" ? "" : claim.unit,
                     claim.note.empty() ? "" : " ", claim.note);
}

void add_claim(pugi::xml_node suite, const Summary::Outcome& claim, Totals& totals) {
  pugi::xml_node test = add_case(suite, claim.id, 0);
  add_properties(
      test, {{"measured", fmt::format("{}", claim.measured)},
             {"uncertainty", std::isnan(claim.uncertainty) ? "not estimated" : fmt::format("{}", claim.uncertainty)},
             {"expected", fmt::format("{}", claim.expected)},
             {"limit", fmt::format("{}", claim.limit)},
             {"unit", claim.unit},
             {"resolution", claim.resolution},
             {"verdict", claim.verdict},
             {"declared", claim.declared},
             {"declared_reason", claim.declared_reason}});
  ++totals.tests;
  if (claim.verdict == "error") {
    ++totals.errors;
    add_outcome(test, "error", "error", in_numbers(claim));
  } else if (!claim.as_declared) {
    ++totals.failures;
    const bool undeclared_pass = claim.verdict == "pass";
    add_outcome(test, "failure", undeclared_pass ? "undeclared pass" : claim.verdict,
                fmt::format("{}, declared {}: {}", claim.verdict, claim.declared, in_numbers(claim)));
  } else if (claim.verdict != "pass") {
    ++totals.skipped;
    add_outcome(test, "skipped", "declared " + claim.verdict,
                fmt::format("declared {}: {} Reason: {}", claim.verdict, in_numbers(claim), claim.declared_reason));
  }
}

Totals add_suite(pugi::xml_node root, const Summary& record) {
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", record.group + "." + record.stem());
  set(suite, "timestamp", record.date.substr(0, std::string_view("2026-01-02T03:04:05").size()));
  add_properties(suite, {{"wall_time", fmt::format("{}", record.wall_time)},
                         {"kind", record.kind},
                         {"tier", record.tier},
                         {"solver", record.solver},
                         {"commit", record.commit}});
  Totals totals{.tests = 1, .time = std::isfinite(record.wall_time) ? record.wall_time : 0};
  pugi::xml_node run = add_case(suite, "run", totals.time);
  if (!record.error.empty()) {
    totals.errors = 1;
    add_outcome(run, "error", "unfinished", record.error);
  }
  for (const Summary::Outcome& claim : record.claims) add_claim(suite, claim, totals);
  set_totals(suite, totals);
  return totals;
}

Summary summary_or_error(const std::filesystem::path& file) {
  try {
    return read_summary(file);
  } catch (const std::runtime_error& no_record) {
    Summary broken;
    broken.group = "broken";
    broken.name = file.stem().string();
    broken.tier = "quick";
    broken.solver = "seiche";
    broken.error = no_record.what();
    return broken;
  }
}

}  // namespace

void write_junit(const std::filesystem::path& directory) {
  const FolderLock moment(directory);
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", "seiche");
  Totals totals;
  for (const std::filesystem::path& file : record_files(directory)) totals += add_suite(root, summary_or_error(file));
  set_totals(root, totals);
  std::ostringstream text;
  document.save(text, "  ");
  io::write_file(directory / "junit.xml", text.str());
}

}  // namespace seiche::evidence
