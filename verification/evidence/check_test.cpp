// What every test here stands on: a claim that does not come out as declared fails its test, and the record is kept.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "reports/evidence/record_files.hpp"
#include "verification/check.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification {
namespace {

const Bound half{0.5, "half of the expected value"};

/// Records of this scope go to a folder of their own.
class Elsewhere {
 public:
  Elsewhere() : before_(std::getenv("SEICHE_EVIDENCE") == nullptr ? "" : std::getenv("SEICHE_EVIDENCE")) {
    setenv("SEICHE_EVIDENCE", folder_.path().c_str(), 1);
  }
  ~Elsewhere() { before_.empty() ? unsetenv("SEICHE_EVIDENCE") : setenv("SEICHE_EVIDENCE", before_.c_str(), 1); }
  [[nodiscard]] std::filesystem::path file(const std::string& record) const {
    return folder_.path() / (record + ".json");
  }
  [[nodiscard]] bool has(const std::string& record) const { return std::filesystem::exists(file(record)); }

 private:
  ScratchFolder folder_{"check"};
  std::string before_;
};

struct Checked : Elsewhere {
  Check check{"checked", "Checked", "What must fail does."};
};

/// Errors of first order.
evidence::ObservedOrder first() {
  Convergence errors;
  for (const double size : {1.0, 0.5, 0.25, 0.125}) errors.add(size, size);
  return errors.order();
}

TEST_CASE("a record is written, also after an exception") {
  const Elsewhere elsewhere;
  { Check("kept", "Kept", "Written at the end.").that("a", "A is small.", "a", {.value = 0.1}, half); }
  CHECK(elsewhere.has("kept"));
  try {
    const Check broken("broken", "Broken", "Written at the end.");
    throw std::runtime_error("on purpose");
  } catch (const std::runtime_error&) {
    CHECK(elsewhere.has("broken"));
  }
}

TEST_CASE("a claim has the source and resolution stated for it, otherwise its check's") {
  const Elsewhere elsewhere;
  {
    Check check("sources", "Sources", "What each claim says of itself.", "of the check");
    check.from("of the claim").that("a", "A is small.", "a [m]", {.value = 0.1, .resolution = "10 cells"}, half);
    check.at("20 cells");
    check.that("b", "B is small.", "b", {.value = 0.2}, half);
  }
  const auto claims = nlohmann::json::parse(std::ifstream(elsewhere.file("sources")))["claims"];
  REQUIRE(claims.size() == 2);
  CHECK((claims[0]["source"] == "of the claim" && claims[1]["source"] == "of the check"));
  CHECK((claims[0]["resolution"] == "10 cells" && claims[1]["resolution"] == "20 cells"));
  CHECK((claims[0]["quantity"] == "a" && claims[0]["unit"] == "m" && claims[1]["unit"] == "1"));
}

TEST_CASE("a claim that is not met fails its test", "[!shouldfail]") {
  Checked{}.check.that("a", "A is small.", "a", {.value = 0.6}, half);
}

TEST_CASE("a value that is not a number fails its test", "[!shouldfail]") {
  Checked{}.check.that("a", "A is small.", "a", {.value = std::numeric_limits<double>::quiet_NaN()}, half);
}

TEST_CASE("an order that is not met fails its test", "[!shouldfail]") {
  Checked{}.check.that("a", "The order is 2.", "order", first(), Order{.theory = 2, .reason = "another order"});
}

TEST_CASE("an assertion that does not hold fails its test", "[!shouldfail]") {
  Checked{}.check.holds("a", {.value = 0.6}, half);
}

TEST_CASE("an order that an assertion misses fails its test", "[!shouldfail]") {
  Checked{}.check.holds("a", first(), Order{.theory = 2, .reason = "another order"});
}

TEST_CASE("a known failure that passes fails its test", "[!shouldfail]") {
  Checked{}.check.known_failure("a", "A is small.", "a", {.value = 0.1}, half, {.reason = "none"});
}

}  // namespace
}  // namespace seiche::verification
