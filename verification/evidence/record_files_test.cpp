#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

#include <H5Cpp.h>
#include <fmt/core.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "reports/evidence/provenance.hpp"
#include "reports/evidence/record_files.hpp"
#include "seiche/io/atomic_file.hpp"
#include "verification/check.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::record_files_test {

using namespace evidence;

Record sample() {
  Record record;
  record.name = "sample";
  record.group = "evidence";
  record.title = "A sample <with> \"marks\"";
  record.parameters["depth"] = {.value = 0.1, .standard = 1.0, .unit = "m", .meaning = "still-water depth"};
  record.check({.id = "a", .text = "a holds", .quantity = "a", .unit = "m", .source = "s"}, {.value = 0.1},
               Bound{1, "r"});
  record.check({.id = "b", .text = "b holds", .quantity = "b", .unit = "m", .source = "s"},
               {.value = std::numeric_limits<double>::quiet_NaN()}, Bound{1, "r"});
  record.measure("infinite", std::numeric_limits<double>::infinity());
  const std::vector<double> x{0, 1, 2};
  record.figure("profile", "Profile", "A line.").panel({.x = "x [m]", .y = "h [m]"}).line("exact", x, x, Role::exact);
  record.snapshot({.time = 1, .x = x, .z = x, .unit = "m", .fields = {{"depth", "m", x}}});
  return record;
}

TEST_CASE("a record is read back as it was written", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  write(sample(), scratch.path());
  CHECK(std::filesystem::exists(scratch.path() / "sample.h5"));
  CHECK(std::filesystem::exists(scratch.path() / "sample.xdmf"));
  const Summary summary = read_summary(scratch.path() / "sample.json");
  CHECK(summary.name == "sample");
  CHECK(summary.claims.size() == 2);
  CHECK(summary.claims[0].verdict == "pass");
  CHECK(summary.claims[0].measured == 0.1);
  CHECK(summary.claims[1].verdict == "error");
  CHECK_FALSE(summary.as_declared());
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    CHECK(entry.path().extension() != ".part");
  }
}

TEST_CASE("points of a snapshot are joined by a line or stand alone", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  Record record = sample();
  record.snapshot({.time = 2, .x = {0, 1}, .z = {0, 1}, .unit = "depth", .fields = {}, .joined = false});
  write(record, scratch.path());
  std::ifstream file(scratch.path() / "sample.xdmf");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t line = text.find("\"Polyline\"");
  const std::size_t particles = text.find("\"Polyvertex\"");
  REQUIRE(line != std::string::npos);
  REQUIRE(particles != std::string::npos);
  CHECK(line < particles);
  const H5::H5File h5((scratch.path() / "sample.h5").string(), H5F_ACC_RDONLY);
  const H5::Attribute attribute = h5.openDataSet("/snapshots/0001/points").openAttribute("unit");
  std::string unit;
  attribute.read(attribute.getDataType(), unit);
  CHECK(unit == "depth");
}

TEST_CASE("numbers that are not finite become null, not invalid JSON", "[record]") {
  const auto json = nlohmann::json::parse(to_json(sample()));
  CHECK(json.at("measurements").at("infinite").is_null());
  CHECK(json.at("claims").at(1).at("measured").is_null());
}

TEST_CASE("a damaged record is an error that names the file", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  io::write_file(scratch.path() / "broken.json", R"({"case": "brok)");
  CHECK_THROWS_WITH(read_summaries(scratch.path()), Catch::Contains("broken.json"));
}

TEST_CASE("a file that is not committed leaves the old file unchanged and no new one", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  const auto target = scratch.path() / "file.txt";
  io::write_file(target, "old");
  {
    const io::AtomicFile file(target);
    std::ofstream(file.path()) << "half of the n";
  }
  CHECK(io::read_file(target) == "old");
  CHECK_THROWS_WITH(io::AtomicFile(scratch.path()), Catch::Contains(scratch.path().string() + ": it is a"));
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path()), {}) == 1);
}

TEST_CASE("ids with other characters and figures named twice are rejected", "[record]") {
  Record record = sample();
  CHECK_THROWS_AS(record.figure("../x", "", ""), std::invalid_argument);
  CHECK_THROWS_AS(record.figure("profile", "", ""), std::invalid_argument);
  CHECK_THROWS_AS(record.check({.id = ""}, {.value = 1}, Bound{1, "r"}), std::invalid_argument);
}

TEST_CASE("provenance names the machine, and each library's version as its header has it", "[record]") {
  const Provenance here = provenance();
  CHECK((here.cores > 0 && here.threads > 0));
  CHECK(io::read_file("/proc/cpuinfo").find(": " + here.processor + "\n") != std::string::npos);
  const auto number = [&](const std::string& library, int major, int minor) {
    int a = 0, b = 0, c = 0;
    CHECK(std::sscanf(here.libraries.at(library).c_str(), "%d.%d.%d", &a, &b, &c) == 3);
    return a * major + b * minor + c;
  };
  CHECK(number("Boost", 100000, 100) == BOOST_VERSION);
  CHECK(number("fmt", 10000, 100) == FMT_VERSION);
}

TEST_CASE("SHA-256 of known texts", "[record]") {
  // FIPS 180-4, examples.
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace seiche::verification::record_files_test
