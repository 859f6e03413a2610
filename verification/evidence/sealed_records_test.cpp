// A record and the files beside it are one: whatever is changed, exchanged or missing is seen, and one process writes
// it.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "reports/evidence/record_files.hpp"
#include "reports/evidence/record_lock.hpp"
#include "reports/evidence/seal.hpp"
#include "seiche/io/atomic_file.hpp"
#include "verification/check.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::sealed_records_test {

using namespace evidence;

Record sample(double depth) {
  Record record;
  record.name = "sample";
  record.group = "evidence";
  record.title = "A sample";
  record.article = "An article.";
  record.check({.id = "a", .text = "a \x1b[31mholds", .quantity = "a", .unit = "m", .source = "s"}, {.value = depth},
               Bound{1, "r"});
  const std::vector<double> x{0, 1, 2};
  const std::vector<double> h{depth, depth, depth};
  record.figure("profile", "Profile", "A line.").panel({.x = "x [m]", .y = "h [m]"}).line("exact", x, h, Role::exact);
  record.snapshot({.time = 1, .x = x, .z = h, .unit = "m", .fields = {{"depth", "m", h}}});
  return record;
}

/// A record as it was written, to be spoilt.
struct Written {
  Written() {
    write(sample(0.25), scratch.path());
    json = scratch.path() / "sample.json";
  }
  [[nodiscard]] std::string error(Reading reading = Reading::all_files) const {
    return read_summary(json, reading).error;
  }
  void replace(const std::string& text, const std::string& by) const {
    std::string content = io::read_file(json);
    const std::size_t place = content.find(text);
    REQUIRE(place != std::string::npos);
    io::write_file(json, content.replace(place, text.size(), by));
  }

  ScratchFolder scratch{"seiche_sealed_records"};
  std::filesystem::path json;
};

TEST_CASE("an unchanged record is whole", "[record]") {
  const Written written;
  const Summary summary = read_summary(written.json, Reading::all_files);
  CHECK(summary.error.empty());
  CHECK(summary.sealed);
  CHECK(summary.files.size() == 2);
  CHECK(is_sealed(io::read_file(written.json)));
}

TEST_CASE("a number that was changed in a record is seen", "[record]") {
  const Written written;
  written.replace("\"measured\": 0.25", "\"measured\": 0.24");
  CHECK(written.error(Reading::json).find("changed after it was written") != std::string::npos);
  CHECK_FALSE(read_summary(written.json).sealed);
}

TEST_CASE("content appended after a record's digest is detected", "[record]") {
  const Written written;
  io::write_file(written.json, io::read_file(written.json) + "\n");
  CHECK_FALSE(written.error(Reading::json).empty());
}

TEST_CASE("arrays of another run are not taken for a record's own", "[record]") {
  const Written written;
  const ScratchFolder other("seiche_sealed_records_other");
  write(sample(0.5), other.path());
  std::filesystem::copy_file(other.path() / "sample.h5", written.scratch.path() / "sample.h5",
                             std::filesystem::copy_options::overwrite_existing);
  CHECK(written.error(Reading::json).empty());
  CHECK(written.error().find("sample.h5 is not the file") != std::string::npos);
}

TEST_CASE("arrays that are gone, or only linked to, are missed", "[record]") {
  const Written written;
  const auto arrays = written.scratch.path() / "sample.h5";
  std::filesystem::rename(arrays, written.scratch.path() / "elsewhere.h5");
  CHECK(written.error().find("sample.h5 is missing") != std::string::npos);
  std::filesystem::create_symlink("elsewhere.h5", arrays);
  CHECK(written.error().find("sample.h5 is missing") != std::string::npos);
}

TEST_CASE("a record with a new article is sealed again", "[record]") {
  const Written written;
  refresh_article(written.json, "Another article.");
  const Summary summary = read_summary(written.json, Reading::all_files);
  CHECK(summary.error.empty());
  CHECK(summary.sealed);
  CHECK(io::read_file(written.json).find("Another article.") != std::string::npos);
  written.replace("\"measured\": 0.25", "\"measured\": 0.24");
  refresh_article(written.json, "Another article.");
  CHECK_FALSE(written.error(Reading::json).empty());
}

TEST_CASE("a record without a digest is distinguished from a changed one", "[record]") {
  const Written written;
  std::string text = io::read_file(written.json);
  text = text.substr(0, text.rfind(",\n \"digest\"")) + "\n}\n";
  io::write_file(written.json, text);
  CHECK(written.error().empty());
  CHECK_FALSE(read_summary(written.json).sealed);
}

TEST_CASE("escape sequences of a record do not reach the terminal", "[record]") {
  const Written written;
  CHECK(read_summary(written.json).claims.at(0).text == "a ?[31mholds");
}

TEST_CASE("a record has one writer, and its lock goes with it", "[record]") {
  const ScratchFolder scratch("seiche_record_lock");
  const auto files = [&] { return std::distance(std::filesystem::directory_iterator(scratch.path()), {}); };
  std::ofstream(scratch.path() / ".sample.json.4242.part") << "half a rec";
  std::ofstream(scratch.path() / ".sample@full.json.4242.part") << "of another record";
  {
    const RecordLock mine(scratch.path(), "sample");
    CHECK_THROWS_WITH(RecordLock(scratch.path(), "sample"), Catch::Matchers::Contains("another process"));
    CHECK_NOTHROW(RecordLock(scratch.path(), "other"));
    write(sample(0.25), scratch.path());
  }
  CHECK(files() == 4);  // the record's three, and what is not its own
  CHECK_NOTHROW(RecordLock(scratch.path(), "sample"));
}

}  // namespace seiche::verification::sealed_records_test
