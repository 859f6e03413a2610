// What an interrupted run has kept is used where it is whole and of the same program, and nowhere else.
#include "validation/case/checkpoints.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "seiche/io/atomic_file.hpp"
#include "verification/check.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::checkpoints_test {

using namespace validation;

struct Gauge {
  std::string name;
  std::optional<double> height;
  std::vector<std::vector<double>> samples;
};

void exchange(Tape& tape, Gauge& gauge) {
  tape(gauge.name, gauge.height, gauge.samples);
}

const Keeping resuming{.resume = true, .every = std::chrono::seconds(0)};
const Keeping afresh{.resume = false, .every = std::chrono::seconds(0)};

class Folder {
 public:
  [[nodiscard]] std::filesystem::path path() const { return scratch_.path() / "all" / "case"; }
  Checkpoints* open(const Keeping& keeping, const std::string& fingerprint = "f") {
    opened_ = std::make_unique<Checkpoints>(path(), fingerprint, keeping);
    return opened_.get();
  }

 private:
  verification::ScratchFolder scratch_{"seiche_checkpoints_test"};
  std::unique_ptr<Checkpoints> opened_;
};

double eleven(const Checkpoints& checkpoints, int& computed) {
  return Part(checkpoints, "h = 0.5, 30 deg").result<double>([&] {
    ++computed;
    return 11.0;
  });
}

TEST_CASE("a tape is read back as it was written", "[checkpoints]") {
  std::vector<Gauge> written{{"left", 0.1, {{1, 2}, {}}}, {"", std::nullopt, {}}};
  Tape tape;
  tape(written);
  Tape back(tape.bytes());
  std::vector<Gauge> read;
  back(read);
  CHECK(back.at_end());
  REQUIRE(read.size() == 2);
  CHECK(read[0].name == "left");
  CHECK(read[0].height == 0.1);
  CHECK(read[0].samples == written[0].samples);
  CHECK_FALSE(read[1].height);
  Tape torn(tape.bytes().substr(0, tape.bytes().size() - 1));
  CHECK_THROWS_AS(torn(read), std::out_of_range);
  Tape huge(std::string(8, '\xff'));
  CHECK_THROWS_AS(huge(read), std::out_of_range);
}

TEST_CASE("an unfinished part is kept no oftener than asked", "[checkpoints]") {
  Folder folder;
  int state = 1;
  const auto exchange_state = [&](Tape& tape) { tape(state); };
  Part part(*folder.open({.resume = true, .every = std::chrono::seconds(1)}), "run");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  part.keep(exchange_state);
  state = 2;
  part.keep(exchange_state);
  CHECK(Part(*folder.open(resuming), "run").resume(exchange_state));
  CHECK(state == 1);
}

TEST_CASE("a finished part is computed once, and removed with the folder", "[checkpoints]") {
  Folder folder;
  int computed = 0;
  CHECK(eleven(*folder.open(resuming), computed) == 11);
  CHECK(eleven(*folder.open(resuming), computed) == 11);
  CHECK(computed == 1);
  folder.open(resuming)->remove_all();
  CHECK_FALSE(std::filesystem::exists(folder.path().parent_path()));
  CHECK(eleven(*folder.open(resuming), computed) == 11);
  CHECK(computed == 2);
  SECTION("existing parts are removed without resumption") {
    CHECK(eleven(*folder.open(afresh), computed) == 11);
    CHECK(computed == 3);
  }
  SECTION("another program's is not used, and a note says so") {
    const Checkpoints* other = folder.open(resuming, "g");
    CHECK(eleven(*other, computed) == 11);
    CHECK(computed == 3);
    REQUIRE(other->notes().size() == 1);
    CHECK(other->notes().front().find("another program") != std::string::npos);
  }
  SECTION("a damaged one is not used, whichever byte is wrong") {
    const auto file = std::filesystem::directory_iterator(folder.path())->path();
    const std::string whole = io::read_file(file);
    for (std::size_t k = 0; k < whole.size(); ++k) {
      std::string damaged = whole;
      damaged[k] = static_cast<char>(damaged[k] ^ 1);
      io::write_file(file, damaged);
      const Checkpoints* checkpoints = folder.open(resuming);
      computed = 0;
      CHECK(eleven(*checkpoints, computed) == 11);
      CHECK(computed == 1);
      CHECK(checkpoints->notes().size() == 1);
    }
    for (const std::size_t length : {std::size_t{0}, std::size_t{20}, whole.size() - 1}) {
      io::write_file(file, whole.substr(0, length));
      computed = 0;
      CHECK(eleven(*folder.open(resuming), computed) == 11);
      CHECK(computed == 1);
    }
  }
  SECTION("one that cannot be read is not used, and a note says so") {
    const auto file = std::filesystem::directory_iterator(folder.path())->path();
    std::filesystem::remove(file);
    std::filesystem::create_directories(file / "in the way");
    const Checkpoints* checkpoints = folder.open(resuming);
    CHECK(eleven(*checkpoints, computed) == 11);
    CHECK(computed == 3);
    REQUIRE(checkpoints->notes().size() == 2);
    CHECK_THAT(checkpoints->notes()[0], Catch::Contains("cannot read"));
    CHECK_THAT(checkpoints->notes()[1], Catch::Contains("cannot write"));
  }
  SECTION("partial files of a killed process are removed") {
    std::ofstream(folder.path() / ".h.checkpoint.4711.part") << "half";
    folder.open(resuming);
    CHECK_FALSE(std::filesystem::exists(folder.path() / ".h.checkpoint.4711.part"));
  }
}

TEST_CASE("a part that holds more than is read of it is the program's error", "[checkpoints]") {
  Folder folder;
  const Part part(*folder.open(resuming), "two");
  CHECK(part.result<std::string>([] { return std::string("seven"); }) == "seven");
  CHECK_THROWS_WITH(part.result<std::size_t>([] { return std::size_t{0}; }),
                    "checkpoint 'two' holds more than is read of it");
}

TEST_CASE("a part continues from its last state", "[checkpoints]") {
  Folder folder;
  const auto sum_to = [](Part part, long last, long breaks_at) {
    long n = 1;
    double sum = 0;
    const auto state = [&](Tape& tape) { tape(n, sum); };
    const long first = part.resume(state) ? n : 0;
    for (; n <= last; ++n) {
      part.keep(state);
      if (n == breaks_at) throw std::runtime_error("killed");
      sum += 1.0 / static_cast<double>(n);
    }
    return std::pair(sum, first);
  };
  const double whole = sum_to(Part(Checkpoints(), "sum"), 100, -1).first;
  CHECK_THROWS(sum_to(Part(*folder.open(afresh), "sum"), 100, 60));
  const auto [sum, first] = sum_to(Part(*folder.open(resuming), "sum"), 100, -1);
  CHECK(first == 60);
  CHECK(sum == whole);
}

TEST_CASE("the time of an interrupted run is the sum over its processes", "[checkpoints]") {
  Folder folder;
  const auto wait = [&](const Checkpoints& checkpoints, const std::string& part) {
    return Part(checkpoints, part).result<double>([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      return checkpoints.seconds();
    });
  };
  const double first = wait(*folder.open(afresh), "one");
  CHECK(first >= 0.03);
  CHECK(wait(*folder.open(resuming), "one") == first);
  const Checkpoints* third = folder.open(resuming);
  wait(*third, "one");
  CHECK(wait(*third, "two") >= 0.06);
  CHECK(folder.open(resuming, "g")->seconds() < 0.03);
}

TEST_CASE("a folder that cannot be written gives a note and does not stop the run", "[checkpoints]") {
  const verification::ScratchFolder scratch("seiche_checkpoints_test");
  io::write_file(scratch.path() / "file", "not a folder");
  const Checkpoints checkpoints(scratch.path() / "file" / "case", "f", resuming);
  int computed = 0;
  CHECK(eleven(checkpoints, computed) == 11);
  CHECK(checkpoints.notes().size() == 1);
}

}  // namespace seiche::verification::checkpoints_test
