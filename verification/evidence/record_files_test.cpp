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
#include "reports/evidence/seal.hpp"
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

/// Every member with a value of its own, so that none can stand for another.
Record distinct() {
  Record r;
  r.name = "name";
  r.kind = "kind";
  r.group = "group";
  r.tier = "full";
  r.solver = "mine";
  r.title = "title";
  r.source = "source";
  r.article = "article";
  r.atlas = {"tile-1"};
  r.parameters = {{"depth", {0.25, 0.5, "m", "depth at rest"}},
                  {"cells", {3L, 4L, "1", "cells"}},
                  {"scheme", {std::string("H2"), std::string("M2"), "1", "scheme"}},
                  {"wet", {true, true, "1", "whether it is wet"}}};
  r.set = "set-2";
  r.published = {{.tiles = {"tile-3", "tile-4"},
                  .tier = "paper",
                  .values = {{"depth", 0.125}},
                  .origins = {{"depth", "stated"}},
                  .different = {{"depth", "0.1 m"}},
                  .differs = "another scheme",
                  .contradicted = {"flow"},
                  .here = true}};
  r.wall_time = 2.5;
  r.fingerprint = "fingerprint";
  r.reference_data = {{"table.csv", "digest of the table"}};
  const auto judged = [](double k, const char* id) {
    const std::string name = id;
    return Judgement{Verdict::fail, k, k + 0.5, k + 0.25, k + 0.125, name + " resolution", name + " note"};
  };
  r.keep({{"depth", "depth text", "depth quantity", "m", "depth source"},
          Roundoff{Amount::told_by_run(70).with(7), Amount::at_most(8, 80), "counted", Amount::at_most(9, 90)},
          judged(10, "depth")});
  r.keep(
      {{"order", "order text", "order quantity", "1", "order source"}, Order{3, 0.4, "theory"}, judged(20, "order")});
  r.keep({{"flow", "flow text", "flow quantity", "m^2/s", "flow source"},
          Bound{Amount::at_most(5, 50), "printed", Amount::at_most(6, 60), true},
          judged(30, "flow"),
          KnownFailure{30.5, 0.75, "declared"}});
  r.keep({{"wave", "shared text.", "wave quantity", "m", "wave source"},
          Uncertainty{Amount::at_most(1, 11), Amount::at_most(2, 12), Amount::at_most(3, 13), 4, "stated", 2.5},
          {Verdict::inconclusive, 40, std::nullopt, 41, 42, "wave resolution", "wave note"}});
  r.keep({{"crest", "shared text.", "crest quantity", "1", "crest source"},
          Qualitative{"detector", "seen", false},
          {Verdict::pass, 0, 0.0, 0, 0, "crest resolution", ""}});
  r.leave_out({{"bed", "bed text", "bed quantity", "m", "bed source"}, "it is dry"});
  for (const auto& [name, value] : {std::pair("h_relative_l1_x_1", 0.5), std::pair("h_relative_l1_x_2", -0.75),
                                    std::pair("u_relative_error", 0.125), std::pair("v_relative_l1x", 9.0)}) {
    r.measure(name, value);
  }
  const std::vector<double> x{0, 1};
  Figure& figure = r.figure("figure", "figure title", "figure caption", {"tile-5"});
  figure.drawing = "scene";
  figure.panel({.x = "x", .y = "y"}).line("line", x, x, Role::exact);
  r.table({"table", "table title", "table caption", {{"column", "s"}}, {{0.5}, {"entry"}}, {"tile-6"}});
  r.snapshot({.time = 1, .x = x, .z = x, .unit = "m", .fields = {}});
  return r;
}

TEST_CASE("every member of a record stands under its own name in JSON", "[record]") {
  auto json = nlohmann::json::parse(to_json(distinct(), {{"name.h5", "digest of the arrays"}}));
  const Provenance here = provenance();
  CHECK(json.at("provenance") == nlohmann::json{{"version", here.version},
                                                {"commit", here.commit},
                                                {"dirty", here.dirty},
                                                {"compiler", here.compiler},
                                                {"flags", here.flags},
                                                {"build_type", here.build_type},
                                                {"libraries", here.libraries},
                                                {"processor", here.processor},
                                                {"cores", here.cores},
                                                {"threads", here.threads},
                                                {"system", here.system},
                                                {"date", json["provenance"]["date"]},
                                                {"reference_data", {{"table.csv", "digest of the table"}}}});
  CHECK(json["provenance"]["date"].get<std::string>().substr(0, 13) == here.date.substr(0, 13));
  json.erase("provenance");
  json.erase("digest");
  CHECK(json == nlohmann::json::parse(R"({
    "schema": 3, "case": "name", "kind": "kind", "group": "group", "tier": "full", "solver": "mine", "title": "title",
    "source": "source", "article": "article", "status": "finished", "error": "", "set": "set-2", "atlas": ["tile-1"],
    "parameters": {"depth": {"value": 0.25, "default": 0.5, "unit": "m", "meaning": "depth at rest"},
                   "cells": {"value": 3, "default": 4, "unit": "1", "meaning": "cells"},
                   "scheme": {"value": "H2", "default": "M2", "unit": "1", "meaning": "scheme"},
                   "wet": {"value": true, "default": true, "unit": "1", "meaning": "whether it is wet"}},
    "published": [{"tiles": ["tile-3", "tile-4"], "tier": "paper", "values": {"depth": 0.125},
                   "origins": {"depth": "stated"}, "different": {"depth": "0.1 m"}, "differs": "another scheme",
                   "contradicted": ["flow"], "here": true}],
    "claims": [
      {"id": "depth", "text": "depth text", "quantity": "depth quantity", "unit": "m", "source": "depth source",
       "resolution": "depth resolution", "measured": 10.0, "uncertainty": 10.5, "expected": 10.25,
       "criterion": {"kind": "roundoff", "reason": "counted", "operations": 7.0, "scale": 8.0, "limit": 10.125,
                     "caps": {"operations": 70.0, "scale": 80.0, "expected": 90.0}},
       "verdict": "fail", "declared": "pass", "declared_reason": "", "declared_band": null, "as_declared": false,
       "note": "depth note"},
      {"id": "order", "text": "order text", "quantity": "order quantity", "unit": "1", "source": "order source",
       "resolution": "order resolution", "measured": 20.0, "uncertainty": 20.5, "expected": 20.25,
       "criterion": {"kind": "order", "reason": "theory", "theory": 3.0, "tolerance": 0.4, "limit": 20.125},
       "verdict": "fail", "declared": "pass", "declared_reason": "", "declared_band": null, "as_declared": false,
       "note": "order note"},
      {"id": "flow", "text": "flow text", "quantity": "flow quantity", "unit": "m^2/s", "source": "flow source",
       "resolution": "flow resolution", "measured": 30.0, "uncertainty": 30.5, "expected": 30.25,
       "criterion": {"kind": "bound", "reason": "printed", "relative": true, "limit": 30.125,
                     "caps": {"limit": 50.0, "expected": 60.0}},
       "verdict": "fail", "declared": "fail", "declared_reason": "declared", "declared_band": [30.5, 0.75],
       "as_declared": true, "note": "flow note"},
      {"id": "wave", "text": "shared text (wave).", "quantity": "wave quantity", "unit": "m", "source": "wave source",
       "resolution": "wave resolution", "measured": 40.0, "uncertainty": null, "expected": 41.0,
       "criterion": {"kind": "uncertainty", "reason": "stated", "data": 2.0, "input": 3.0, "coverage": 2.5,
                     "useful": 4.0, "limit": 42.0, "caps": {"expected": 11.0, "data": 12.0, "input": 13.0}},
       "verdict": "inconclusive", "declared": "pass", "declared_reason": "", "declared_band": null,
       "as_declared": false, "note": "wave note"},
      {"id": "crest", "text": "shared text (crest).", "quantity": "crest quantity", "unit": "1",
       "source": "crest source", "resolution": "crest resolution", "measured": 0.0, "uncertainty": 0.0,
       "expected": 0.0, "criterion": {"kind": "qualitative", "reason": "seen", "detector": "detector", "limit": 0.0},
       "verdict": "pass", "declared": "pass", "declared_reason": "", "declared_band": null, "as_declared": true,
       "note": ""}],
    "left_out": [{"id": "bed", "text": "bed text", "reason": "it is dry"}],
    "measurements": {"h_relative_l1_x_1": 0.5, "h_relative_l1_x_2": -0.75, "u_relative_error": 0.125,
                     "v_relative_l1x": 9.0},
    "standing": {"settings": "cells=3;depth=0.25;scheme=H2", "errors": {"h": 0.75, "u": 0.125}},
    "figures": [{"id": "figure", "title": "figure title", "caption": "figure caption", "drawing": "scene",
                 "atlas": ["tile-5"]}],
    "tables": [{"id": "table", "title": "table title", "caption": "table caption",
                "columns": [{"name": "column", "unit": "s"}], "rows": [[0.5], ["entry"]], "atlas": ["tile-6"]}],
    "data": "name@set-2.mine.h5", "fields": "name@set-2.mine.xdmf", "wall_time": 2.5, "fingerprint": "fingerprint",
    "files": {"name.h5": "digest of the arrays"}})"));
}

TEST_CASE("every member of a summary is read from its own place", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  write(distinct(), scratch.path());
  const std::filesystem::path file = scratch.path() / "name@set-2.mine.json";
  const Summary s = read_summary(file, Reading::all_files);
  const Provenance here = provenance();
  CHECK((s.name == "name" && s.kind == "kind" && s.group == "group" && s.tier == "full" && s.solver == "mine"));
  CHECK((s.set == "set-2" && s.shows == "set-2" && s.standard && s.error.empty() && s.sealed));
  CHECK((s.fingerprint == "fingerprint" && s.wall_time == 2.5 && s.stem() == "name@set-2.mine"));
  CHECK((s.commit == here.commit + (here.dirty ? "-dirty" : "") && s.date.substr(0, 13) == here.date.substr(0, 13)));
  CHECK(s.parameters ==
        std::map<std::string, Scalar>{{"depth", 0.25}, {"cells", 3L}, {"scheme", std::string("H2")}, {"wet", true}});
  CHECK(s.reference_data == std::map<std::string, std::string>{{"table.csv", "digest of the table"}});
  CHECK(s.measurements.at("h_relative_l1_x_2") == -0.75);
  for (const auto& [name, digest] : s.files) CHECK(digest == sha256_of_file(scratch.path() / name));
  CHECK(s.files.size() == 2);
  REQUIRE(s.claims.size() == 5);
  const Summary::Outcome& flow = s.claims[2];
  CHECK((flow.id == "flow" && flow.text == "flow text" && flow.unit == "m^2/s" && flow.kind == "bound"));
  CHECK((flow.resolution == "flow resolution" && flow.note == "flow note" && flow.declared_reason == "declared"));
  CHECK((flow.verdict == "fail" && flow.declared == "fail" && flow.as_declared && !s.as_declared()));
  CHECK((flow.measured == 30 && flow.uncertainty == 30.5 && flow.expected == 30.25 && flow.limit == 30.125));
  CHECK((flow.band == 0.75 && std::isnan(s.claims[0].band) && std::isnan(s.claims[3].uncertainty)));
  CHECK((s.claims[3].declared == "pass" && s.claims[3].verdict == "inconclusive" && !s.claims[3].as_declared));
  // What older records do not have, and what others have made of them.
  auto json = nlohmann::ordered_json::parse(io::read_file(file));
  const auto read = [&](auto change) {
    auto changed = json;
    changed.erase("digest");
    changed.erase("files");
    change(changed);
    io::write_file(file, changed.dump());
    return read_summary(file, Reading::all_files);
  };
  CHECK(read([](auto& j) { j.erase("set"); }).shows == "tile-3");
  CHECK_FALSE(read([](auto& j) { j.erase("set"); }).standard);
  CHECK(read([](auto& j) { j["set"] = "", j["published"][0]["here"] = false; }).shows.empty());
  CHECK(read([](auto& j) { j["claims"][2].erase("as_declared"); }).claims[2].as_declared);
  CHECK(std::isnan(read([](auto& j) { j["claims"][2].erase("declared_band"); }).claims[2].band));
  CHECK(read([](auto& j) { j["provenance"]["dirty"] = true; }).commit == here.commit + "-dirty");
  CHECK(read([](auto& j) { j["provenance"]["dirty"] = false; }).commit == here.commit);
  const Summary foreign = read([](auto& j) { j["title"] = "not ours"; });
  CHECK((!foreign.sealed && foreign.error.empty() && foreign.files.empty()));
  CHECK_THROWS_WITH(read([](auto& j) { j.erase("kind"); }), Catch::Contains(file.string() + " is not a record: "));
}

TEST_CASE("another article is put into a record, and the same one leaves its bytes", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  const std::filesystem::path file = scratch.path() / "r.json";
  const auto json = nlohmann::ordered_json::parse(to_json(distinct()));
  io::write_file(file, json.dump());  // in one line, as this program does not write it
  refresh_article(file, "article");
  CHECK(io::read_file(file) == json.dump());
  refresh_article(file, "another");
  auto expected = json;
  expected["article"] = "another";
  expected.erase("digest");
  CHECK(is_sealed(io::read_file(file)));
  auto found = nlohmann::ordered_json::parse(io::read_file(file));
  found.erase("digest");
  CHECK(found == expected);
}

TEST_CASE("a file larger than any record is not read, a link not followed", "[record]") {
  const verification::ScratchFolder scratch("seiche_record_files_test");
  const std::filesystem::path file = scratch.path() / "large.json";
  constexpr std::uintmax_t most = 8388608;
  io::write_file(file, "{}");
  std::filesystem::resize_file(file, most + 1);
  CHECK_THROWS_WITH(read_summary(file), Catch::Contains("8388609 bytes, more than the 8388608 that one may have"));
  std::filesystem::resize_file(file, most);
  CHECK_THROWS_WITH(read_summary(file), !Catch::Contains("bytes, more than"));
  std::filesystem::create_symlink(file, scratch.path() / "link.json");
  CHECK_THROWS_WITH(read_summary(scratch.path() / "link.json"), Catch::Contains("links and pipes are not followed"));
  CHECK_THROWS_WITH(record_files(file), Catch::Contains("is not a folder"));
}

TEST_CASE("SHA-256 of known texts", "[record]") {
  // FIPS 180-4, examples.
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace seiche::verification::record_files_test
