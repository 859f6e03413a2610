#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "reports/evidence/provenance.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/case/reference_source.hpp"
#include "verification/check.hpp"
#include "verification/message_of.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::reference_data_test {

using validation::ReferenceSource;

const std::set<std::string> known_units = {"1", "m", "cm", "s", "1/s", "m/s", "m^2", "m^2/s", "deg", "rad", "Pa"};

/// What is wrong with a folder of reference_data; empty if nothing.
class Faults {
 public:
  explicit Faults(const std::string& name)
      : name_(name),
        folder_(validation::reference_folder() / name),
        source_(validation::reference_source(name)),
        table_(io::read_csv(folder_ / "table.csv")) {
    texts();
    columns();
    units();
    uncertainties();
    codes();
    for (const std::string& abscissa : source_.abscissa) {
      if (has(abscissa)) order(abscissa);
    }
  }

  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }
  [[nodiscard]] std::size_t numbers() const { return table_.rows() * table_.names.size(); }
  [[nodiscard]] std::size_t assumed() const {
    const auto assumed = [](const auto& entry) { return entry.second.assumed; };
    return static_cast<std::size_t>(std::ranges::count_if(source_.standard_uncertainty, assumed));
  }

 private:
  void fault(const std::string& what) { list_.push_back(name_ + ": " + what); }
  [[nodiscard]] bool has(const std::string& column) const { return std::ranges::count(table_.names, column) > 0; }

  void texts() {
    for (const auto& [field, text] :
         {std::pair{"citation", source_.citation}, std::pair{"what", source_.what},
          std::pair{"obtained", source_.obtained}, std::pair{"uncertainty", source_.uncertainty},
          std::pair{"uncertainty_reason", source_.uncertainty_reason}, std::pair{"recorded", source_.recorded}}) {
      if (text.size() < 3) fault(std::string(field) + " is missing");
    }
    if (source_.sha256 != evidence::sha256_of_file(folder_ / "table.csv"))
      fault("sha256 differs from the digest of table.csv");
  }

  /// Every column has a role, and every name in source.toml is a column.
  void columns() {
    std::set<std::string> roles;
    for (const auto* names : {&source_.abscissa, &source_.group, &source_.parameters}) {
      roles.insert(names->begin(), names->end());
    }
    for (const auto& entry : source_.standard_uncertainty) roles.insert(entry.first);
    for (const std::string& column : table_.names) {
      if (roles.count(column) == 0) fault(column + " has neither a role nor an uncertainty");
    }
    for (const auto& entry : source_.units) roles.insert(entry.first);
    for (const auto& entry : source_.codes) roles.insert(entry.first);
    for (const std::string& column : roles) {
      if (!has(column)) fault(column + " is not a column");
    }
    if (source_.standard_uncertainty.empty()) fault("no column has an uncertainty");
    if (table_.rows() > 1 && source_.abscissa.empty()) fault("no abscissa");
  }

  /// The unit in the header is the one in source.toml.
  void units() {
    for (const std::string& column : table_.names) {
      const auto unit = source_.units.find(column);
      if (unit == source_.units.end()) {
        fault(column + " has no unit");
        continue;
      }
      if (known_units.count(unit->second) == 0) fault(column + " has the unknown unit " + unit->second);
      if (table_.unit(column) != unit->second) fault(column + " has another unit in the header of table.csv");
    }
  }

  void uncertainties() {
    for (const auto& [column, uncertainty] : source_.standard_uncertainty) {
      if (!(uncertainty.value > 0 && std::isfinite(uncertainty.value))) fault(column + " has no positive uncertainty");
      if (uncertainty.relative && uncertainty.value >= 1) fault(column + " has a relative uncertainty of 1 or more");
      if (uncertainty.reason.size() < 3) fault(column + " has an uncertainty without a reason");
    }
  }

  void codes() {
    for (const auto& [column, names] : source_.codes) {
      if (!has(column)) continue;
      for (const double entry : table_.column(column)) {
        if (names.count(std::to_string(std::lround(entry))) == 0 || entry != std::round(entry)) {
          fault(column + " has the entry " + std::to_string(entry) + " without a meaning");
        }
      }
    }
  }

  void order(const std::string& abscissa) {
    const std::vector<double>& x = table_.column(abscissa);
    std::map<std::vector<double>, double> last;
    for (std::size_t row = 0; row < x.size(); ++row) {
      std::vector<double> series;
      for (const std::string& group : source_.group) {
        if (has(group)) series.push_back(table_.column(group)[row]);
      }
      const auto before = last.find(series);
      if (before != last.end() && !(source_.abscissa_repeats ? x[row] >= before->second : x[row] > before->second)) {
        fault(abscissa + " does not increase at row " + std::to_string(row + 1));
      }
      last[series] = x[row];
    }
  }

  std::string name_;
  std::filesystem::path folder_;
  ReferenceSource source_;
  io::Table table_;
  std::vector<std::string> list_;
};

TEST_CASE("every reference table says where it comes from and how well it is known", "[evidence]") {
  Check check(
      "reference_data", "The reference tables",
      "One folder per source under `reference_data`: `table.csv`, numbers only, and `source.toml`. Every folder is "
      "checked: citation, meaning and origin of the numbers, checksum, units, the order of the abscissae within each "
      "series, and for every measured or computed column a standard uncertainty with its reason, marked where the "
      "source states none and it had to be assumed. Finite numbers and full rows are demanded by the reader.");
  const std::vector<std::string> names = validation::reference_sources();
  std::vector<std::string> faults;
  std::size_t numbers = 0;
  evidence::Table table{
      .id = "sources",
      .title = "Sources",
      .caption = "All reference tables; assumed: columns whose uncertainty the source does not state.",
      .columns = {{"table", ""}, {"numbers", "1"}, {"assumed", "1"}, {"citation", ""}}};
  for (const std::string& name : names) {
    const Faults found(name);
    faults.insert(faults.end(), found.list().begin(), found.list().end());
    numbers += found.numbers();
    table.rows.push_back({name, static_cast<double>(found.numbers()), static_cast<double>(found.assumed()),
                          validation::reference_source(name).citation});
  }
  check.table(table);
  for (const std::string& fault : faults) UNSCOPED_INFO(fault);
  check.holds("All " + std::to_string(names.size()) + " tables are complete, ordered, and agree with their checksums.",
              {static_cast<double>(faults.size())}, Bound{0, "a fault is a fault"});
  for (const auto& entry : std::filesystem::directory_iterator(validation::reference_folder())) {
    INFO(entry.path());
    CHECK((!entry.is_directory() || std::filesystem::exists(entry.path() / "source.toml")));
  }
}

TEST_CASE("an unknown reference table is rejected by name", "[evidence]") {
  CHECK_THROWS_AS(validation::reference_source("nobody_1900"), std::invalid_argument);
}

TEST_CASE("a source with a key that is not known, or of another type, is rejected by file and key", "[evidence]") {
  const ScratchFolder folder("seiche_reference_source");
  const auto refused = [&](const std::string& text) {
    std::ofstream(folder.path() / "source.toml") << "citation = \"a book\"\n" << text;
    return message_of([&] { validation::reference_source(folder.path()); });
  };
  const std::string file = (folder.path() / "source.toml").string();
  CHECK(refused("").empty());
  for (const auto& [text, said] :
       {std::pair("colour = \"blue\"\n", "colour is not known"), std::pair("what = 1\n", "what has the wrong type"),
        std::pair("units = \"m\"\n", "units must be a table"),
        std::pair("units = {x = 1}\n", "units.x must be a string"),
        std::pair("parameters = \"x\"\n", "parameters must be an array of strings"),
        std::pair("parameters = [\"x\", 1]\n", "parameters must be an array of strings"),
        std::pair("codes = {x = 1}\n", "codes.x must be a table"),
        std::pair("codes = {x = {a = 1}}\n", "a has the wrong type"),
        std::pair("standard_uncertainty = {x = {value = 1.0, colour = 1}}\n", "colour is not known")}) {
    CHECK(refused(text) == file + ": " + said);
  }
  CHECK(message_of([&] { validation::reference_source(folder.path() / "none"); }) ==
        (folder.path() / "none" / "source.toml").string() + " does not exist");
}

TEST_CASE("every key of a source is read into its own member, and what is not stated is empty", "[evidence]") {
  const ScratchFolder folder("seiche_reference_source");
  std::ofstream(folder.path() / "source.toml") << R"(citation = "a"
what = "b"
obtained = "c"
licence = "d"
uncertainty = "q"
uncertainty_reason = "e"
remarks = "f"
recorded = "g"
sha256 = "h"
abscissa = ["i", "j"]
abscissa_repeats = true
group = ["m"]
parameters = ["k", "l"]
units = {x = "m"}
codes = {x = {"1" = "n"}}
[standard_uncertainty]
x = {value = 0.25, relative = true, assumed = false, reason = "o"}
y = {reason = "p"}
)";
  const validation::ReferenceSource s = validation::reference_source(folder.path());
  CHECK((s.citation == "a" && s.what == "b" && s.obtained == "c" && s.licence == "d" && s.uncertainty == "q"));
  CHECK((s.uncertainty_reason == "e" && s.remarks == "f" && s.recorded == "g" && s.sha256 == "h"));
  CHECK((s.abscissa == std::vector<std::string>{"i", "j"} && s.abscissa_repeats));
  CHECK(s.group == std::vector<std::string>{"m"});
  CHECK(s.parameters == std::vector<std::string>{"k", "l"});
  CHECK((s.units.at("x") == "m" && s.units.size() == 1 && s.codes.at("x").at("1") == "n"));
  const auto& x = s.standard_uncertainty.at("x");
  const auto& y = s.standard_uncertainty.at("y");
  CHECK((x.value == 0.25 && x.relative && !x.assumed && x.reason == "o"));
  CHECK((y.value == 0 && !y.relative && y.assumed && y.reason == "p"));
  CHECK_FALSE(validation::ReferenceSource{}.abscissa_repeats);
}

}  // namespace seiche::verification::reference_data_test
