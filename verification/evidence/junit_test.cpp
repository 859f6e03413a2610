#include <map>
#include <string>

#include <pugixml.hpp>

#include "reports/evidence/record_files.hpp"
#include "seiche/io/atomic_file.hpp"
#include "verification/check.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::junit_test {

using namespace evidence;

/// One claim for every pair of verdict and declaration.
Record sample(const std::string& solver, const std::string& tier = "quick", const std::string& set = "") {
  Record record;
  record.tier = tier;
  record.set = set;
  record.name = "sample";
  record.group = "evidence";
  record.title = "Sample";
  record.solver = solver;
  record.wall_time = 1.5;
  const Bound bound{.limit = 1, .reason = "r"};
  const auto claim = [](const char* id) {
    return Claim{.id = id, .text = "It holds.", .quantity = "q", .unit = "m", .source = "s"};
  };
  record.check(claim("pass"), {.value = 0.5, .uncertainty = 0.1, .resolution = "N = 10"}, bound);
  record.check(claim("fail"), {.value = 2}, bound);
  record.check(claim("inconclusive"), {.value = 0.9, .uncertainty = 0.5}, bound);
  const KnownFailure tangles{.value = 3, .width = 0.5, .reason = "it tangles"};
  record.known_failure(claim("declared-fail"), {.value = 3}, bound, tangles);
  record.known_failure(claim("undeclared-pass"), {.value = 0.25}, bound, tangles);
  return record;
}

struct Junit {
  verification::ScratchFolder scratch{"seiche_junit_test"};
  pugi::xml_document document;

  pugi::xml_node read() {
    write_junit(scratch.path());
    REQUIRE(document.load_file((scratch.path() / "junit.xml").c_str()));
    return document.child("testsuites");
  }
};

pugi::xml_node find(pugi::xml_node parent, const std::string& name) {
  for (const pugi::xml_node child : parent.children()) {
    if (child.attribute("name").value() == name) return child;
  }
  return {};
}

std::string property(pugi::xml_node node, const std::string& name) {
  return find(node.child("properties"), name).attribute("value").value();
}

/// The element that says why a test case did not pass, with its type.
std::string outcome(pugi::xml_node test) {
  for (const char* element : {"failure", "error", "skipped"}) {
    if (const pugi::xml_node node = test.child(element)) {
      return std::string(element) + ": " + node.attribute("type").value();
    }
  }
  return "passed";
}

TEST_CASE("JUnit shows every verdict by its kind", "[junit]") {
  Junit junit;
  write(sample("seiche"), junit.scratch.path());
  const pugi::xml_node suite = find(junit.read(), "evidence.sample");
  std::map<std::string, std::string> shown;
  for (const pugi::xml_node test : suite.children("testcase")) shown[test.attribute("name").value()] = outcome(test);
  CHECK(shown == std::map<std::string, std::string>{{"run", "passed"},
                                                    {"pass", "passed"},
                                                    {"fail", "failure: fail"},
                                                    {"inconclusive", "failure: inconclusive"},
                                                    {"declared-fail", "skipped: declared fail"},
                                                    {"undeclared-pass", "failure: undeclared pass"}});
  const std::string reason = find(suite, "declared-fail").child("skipped").attribute("message").value();
  CHECK(reason.find("Measured 3, ") != std::string::npos);
  CHECK(reason.find("within 1 m") != std::string::npos);
  CHECK(reason.find("it tangles") != std::string::npos);
  CHECK(find(suite, "declared-fail").child("skipped").text().get() == reason);
}

TEST_CASE("JUnit carries the numbers of a claim and the facts of its run as properties", "[junit]") {
  Junit junit;
  write(sample("seiche"), junit.scratch.path());
  const pugi::xml_node suite = find(junit.read(), "evidence.sample");
  using Facts = std::map<std::string, std::string>;
  for (const auto& [name, value] : Facts{{"wall_time", "1.5"}, {"tier", "quick"}, {"solver", "seiche"}}) {
    CHECK(property(suite, name) == value);
  }
  CHECK_FALSE(property(suite, "commit").empty());
  for (const auto& [name, value] :
       Facts{std::pair{"measured", "0.5"}, std::pair{"uncertainty", "0.1"}, std::pair{"limit", "1"},
             std::pair{"expected", "0"}, std::pair{"unit", "m"}, std::pair{"resolution", "N = 10"},
             std::pair{"verdict", "pass"}, std::pair{"declared", "pass"}}) {
    CHECK(property(find(suite, "pass"), name) == value);
  }
}

TEST_CASE("JUnit totals equal the sums over suites, and tests of several records of one case have different names",
          "[junit]") {
  Junit junit;
  for (const Record& record : {sample("seiche"), sample("other"), sample("seiche", "full"),
                               sample("seiche", "full", "a"), sample("other", "full")}) {
    write(record, junit.scratch.path());
  }
  const pugi::xml_node root = junit.read();
  CHECK(std::string(root.attribute("time").value()) == "7.500");
  CHECK(root.attribute("tests").as_int() == 30);
  CHECK(root.attribute("failures").as_int() == 15);
  CHECK(root.attribute("skipped").as_int() == 5);
  CHECK(root.attribute("errors").as_int() == 0);
  std::map<std::string, int> names;
  for (const pugi::xml_node suite : root.children("testsuite")) {
    CHECK(suite.attribute("tests").as_int() == 6);
    for (const pugi::xml_node test : suite.children("testcase")) {
      ++names[std::string(test.attribute("classname").value()) + "." + test.attribute("name").value()];
    }
  }
  CHECK(names.size() == 30);
}

TEST_CASE("a JSON file that is not a record is an error of JUnit and hides no other record", "[junit]") {
  Junit junit;
  write(sample("seiche"), junit.scratch.path());
  io::write_file(junit.scratch.path() / "package.json", R"({"name": "somebody's"})");
  const pugi::xml_node root = junit.read();
  CHECK(find(root, "evidence.sample").attribute("tests").as_int() == 6);
  CHECK(outcome(find(find(root, "broken.package"), "run")) == "error: unfinished");
}

TEST_CASE("JUnit of a run that did not finish is an error, whatever bytes its message holds", "[junit]") {
  Junit junit;
  Record record;
  record.name = "broken";
  record.group = "evidence";
  record.error = "diverged\x1b[31m <at> \"t = 1\"";
  write(record, junit.scratch.path());
  const pugi::xml_node suite = find(junit.read(), "evidence.broken");
  CHECK(suite.attribute("errors").as_int() == 1);
  const pugi::xml_node error = find(suite, "run").child("error");
  CHECK(std::string(error.attribute("message").value()) == "diverged?[31m <at> \"t = 1\"");
}

}  // namespace seiche::verification::junit_test
