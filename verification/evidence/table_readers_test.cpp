// What the readers make of files that are as they should be: every number in its own place, with its own unit.
#include <sstream>
#include <string>
#include <vector>

#include "seiche/io/hdf5_file.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"
#include "verification/check.hpp"
#include "verification/evidence/submissions.hpp"
#include "verification/message_of.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::table_readers_test {

/// Entries that differ from those expected; what is missing or too much counts as well.
double wrong_entries(const std::vector<std::vector<double>>& found, const std::vector<std::vector<double>>& expected) {
  double wrong = 0;
  for (std::size_t k = 0; k < std::max(found.size(), expected.size()); ++k) {
    const std::vector<double> none;
    const std::vector<double>& a = k < found.size() ? found[k] : none;
    const std::vector<double>& b = k < expected.size() ? expected[k] : none;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      if (i >= a.size() || i >= b.size() || a[i] != b[i]) ++wrong;
    }
  }
  return wrong;
}

double wrong_words(const std::vector<std::string>& found, const std::vector<std::string>& expected) {
  if (found.size() != expected.size()) return static_cast<double>(std::max(found.size(), expected.size()));
  double wrong = 0;
  for (std::size_t k = 0; k < found.size(); ++k) wrong += found[k] == expected[k] ? 0 : 1;
  return wrong;
}

/// 1 if the table is refused.
double refused(const std::string& text) {
  return message_of([&] { file_of(text, "table.csv"); }).empty() ? 0 : 1;
}

/// A file of a submission, for the tables that are asked for.
validation::Submitted submitted(const std::string& text, const validation::WantedTable& wanted,
                                validation::Understanding how = {}) {
  std::istringstream in(text);
  return submitted_from({io::read_text_table(io::text_of(in, "mine.csv"))}, {wanted}, how);
}

class ReaderClaims {
 public:
  explicit ReaderClaims(Check& check) : check_(check) {}
  void none_wrong(const std::string& id, const std::string& text, double wrong) const {
    check_.holds(id + ": " + text, {wrong}, Bound{0, "numbers are read to their last bit"});
  }
  void is_refused(const std::string& id, const std::string& text, double value) const {
    check_.holds(id + ": " + text, {value}, Qualitative{"std::invalid_argument", "unreadable input gives no values"});
  }

 private:
  Check& check_;
};

TEST_CASE("a table has every number where the file has it", "[evidence]") {
  Check check("table_readers", "Tables as they are read",
              "CSV as people and programs write it (comments, blanks, quotes, a byte order mark, line ends of three "
              "kinds, no end after the last line), HDF5 of doubles and integers, and the columns of a submission under "
              "other names and in another order.");
  const ReaderClaims claims(check);
  // Every entry of its own: neither two rows nor two columns can be taken for each other.
  const std::vector<std::vector<double>> numbers = {{0, 0.1, 2e-3}, {-1.5, 1234567.25, 1. / 3}, {7, 8, 9}};
  const std::string text =
      "\xEF\xBB\xBF# a comment\r\n t [s] ,\"h [m]\", \"u, x\" \r\n0,-1.5,7\r\n\n0.1 , 1234567.25 ,+8\r# "
      "another\n\"2e-3\",0.33333333333333331,9";
  const io::Table csv = file_of(text, "table.csv");
  claims.none_wrong("csv-numbers", "The numbers of a CSV file are read into their rows and columns.",
                    wrong_entries(csv.columns, numbers));
  claims.none_wrong("csv-names", "Column names of a CSV file are read.", wrong_words(csv.names, {"t", "h", "u, x"}));
  claims.none_wrong("csv-units", "Units of CSV columns are read, and are empty where none is stated.",
                    wrong_words(csv.units, {"s", "m", ""}));
  claims.none_wrong("csv-lines", "Each row of a CSV file has its line number.",
                    wrong_entries({{csv.lines.begin(), csv.lines.end()}}, {{3, 5, 7}}));
  std::istringstream beginning("ab\r\ncdef\ngh");
  claims.none_wrong("most", "The number of bytes read is limited as requested.",
                    wrong_words(io::text_of(beginning, "table.csv", 6).lines, {"ab", "cd"}));
  claims.is_refused("comma", "Decimal commas between commas are rejected.", refused("t,h\n0,5,1,5\n"));
  claims.is_refused("missing", "A missing entry is rejected and does not become 0.", refused("t,h\n0,\n1,2\n"));
  claims.is_refused("trailing", "Text that follows a number is rejected.", refused("t,h\n0,1.5m\n"));
  claims.is_refused("nan", "An entry that is not a finite number is rejected.", refused("t,h\n0,nan\n"));
  claims.is_refused("twice", "A duplicate column is rejected.", refused("t,t\n0,1\n"));

  const ScratchFolder scratch("seiche_table_readers");
  const auto file = scratch.path() / "table";
  {
    io::Hdf5File hdf5(file);
    hdf5.array("t", numbers[0], "t", "s", "time");
    hdf5.array("h", numbers[1], "h", "m", "depth");
    hdf5.array("u", std::vector<std::int32_t>{7, 8, 9}, "u", "", "a count");
  }
  const io::Table hdf5 = io::read_table(file);
  std::vector<std::vector<double>> columns;
  std::vector<std::string> units;
  for (const char* name : {"t", "h", "u"}) {
    columns.push_back(hdf5.column(name));
    units.push_back(hdf5.unit(name));
  }
  claims.none_wrong("hdf5-numbers", "The numbers of an HDF5 file are read under their names.",
                    wrong_entries(columns, numbers));
  claims.none_wrong("hdf5-units", "Units of HDF5 datasets are read from their attributes.",
                    wrong_words(units, {"s", "m", ""}));
  claims.none_wrong("hdf5-wanted", "Datasets that are not requested are not read.",
                    wrong_words(io::read_table(file, {"h"}).names, {"h"}));
}

TEST_CASE("numbers as Fortran writes them are read", "[evidence]") {
  CHECK(file_of("a,b,c,d,e\n1.5D+02,2.d-1,0.25-103,.5+101,-3.E0\n", "table.csv").columns ==
        std::vector<std::vector<double>>{{150}, {0.2}, {0.25e-103}, {0.5e101}, {-3}});
}

TEST_CASE("units agree with the BIPM's brochure and CF", "[evidence]") {
  using validation::conversion;
  std::istringstream factors(
      "cm|m|0.01 millimetres|m|0.001 dm|m|0.1 kilometers|m|1000 feet|m|0.3048 in|m|0.0254 msec|s|0.001 mins|s|60 "
      "hr|s|3600 days|s|86400 kn|km/h|1.852 %|1|0.01 mbar|Pa|100 kPa|Pa|1000 bar|kPa|100 deg|rad|0.017453292519943295 "
      "N*m^-2|Pa|1 J/m^2|N/m|1 Hz|1/min|60 km/min|m*s**-1|16.666666666666667 cm2|m*m|0.0001 kg.m-3|kg/m3|1 "
      "ft3/s|m3.s-1|0.028316846592 m|s|0 m2/s|m/s|0 Pa|N|0 J|N|0 kg|N|0 rad|1|0 furlong|m|0 m|furlong|0");
  for (std::string entry; factors >> entry;) {  // 0: they measure different things
    INFO(entry);
    const std::vector<std::string> words = io::entries_of(entry, '|');
    const double value = std::stod(words.at(2));
    const auto factor = conversion(words.at(0), words.at(1));
    REQUIRE(factor.has_value() == (value != 0));
    if (factor) CHECK(std::abs(*factor / value - 1) < 1e-15);
  }
  CHECK(conversion("m s-1", "cm/s") == 100);
  const auto instant = validation::epoch_of("hours since 1970-02-03T04:05:06.5");
  REQUIRE(instant);
  CHECK(instant->unit == "hours");
  CHECK(instant->origin == 33 * 86400 + 4 * 3600 + 5 * 60 + 6.5);
  CHECK(validation::epoch_of("s since 2020-03-01").value().origin == 18322 * 86400.0);
  CHECK_FALSE(validation::epoch_of("seconds"));
  CHECK_FALSE(validation::epoch_of("seconds since then"));
}

TEST_CASE("adjacent gauges are distinguished by the numbers in their names", "[evidence]") {
  using namespace validation;
  const WantedTable wanted = wanted_elevation("gauges", WantedTable::Kind::series, {}, {}, {-2.5, 6});
  for (const std::string names : {"x=-2.5,x=6", "-2.5,sta-6", "eta=-2.5,WG_06"}) {
    const Submitted groups = submitted("t," + names + "\n0,1,2\n1,3,4\n", wanted);
    INFO(names);
    REQUIRE(groups.at("gauges").size() == 2);
    CHECK(groups.at("gauges")[0].value == -2.5);
    CHECK(groups.at("gauges")[1].values.at("eta") == std::vector<double>{2, 4});
  }
}

TEST_CASE("a submission is read by the names and units of its columns", "[evidence]") {
  using namespace validation;
  Check check("submission_readers", "Submissions as they are read",
              "Two times of a profile, columns in another order and under other names, times not quite round.");
  const ReaderClaims claims(check);
  WantedTable wanted = wanted_elevation("profiles", WantedTable::Kind::profile, {}, {}, {1, 2});
  wanted.quantities = {{.column = {"h", "m", "depth"}}, {.column = {"u", "m/s", "velocity"}}};
  const auto read = [&](const std::string& text) {
    return submitted(text, wanted, {.renamed = {{"h", "depth"}}}).at("profiles");
  };
  const std::vector<SubmittedGroup> groups =
      read("u [m/s],depth [m],x [m],t [s]\n9,9,-5,0.5\n5,1,0,1\n7,3,0,2\n6,2,10,1.0000001\n8,4,10,2\n");
  claims.none_wrong("count", "Each time has its own profile.",
                    wrong_entries({{static_cast<double>(groups.size())}}, {{2}}));
  claims.none_wrong("first", "The first has its positions, depths and velocities.",
                    wrong_entries({groups.at(0).abscissa, groups.at(0).values.at("h"), groups.at(0).values.at("u")},
                                  {{0, 10}, {1, 2}, {5, 6}}));
  claims.none_wrong("second", "The second time has its positions, depths and velocities, the last row included.",
                    wrong_entries({groups.at(1).abscissa, groups.at(1).values.at("h"), groups.at(1).values.at("u")},
                                  {{0, 10}, {3, 4}, {7, 8}}));
  const auto not_accepted = [&](const std::string& text) {
    return message_of([&] { read(text); }).empty() ? 0.0 : 1.0;
  };
  const std::vector<SubmittedGroup> converted =
      read("u [km/h],depth [cm],x [m],t [ms]\n36,100,0,1000\n18,200,10,1000\n7,3,0,2000\n8,4,10,2000\n");
  claims.none_wrong("units", "Other units of the same kind are converted.",
                    wrong_entries({converted.at(0).values.at("h"), converted.at(0).values.at("u")}, {{1, 2}, {10, 5}}));
  claims.is_refused("unit", "A column in seconds is not interpreted as metres.",
                    not_accepted("u [m/s],depth [s],x [m],t [s]\n5,1,0,1\n6,2,10,1\n7,3,0,2\n8,4,10,2\n"));
  claims.is_refused("no-time", "A profile without its times is not taken for the profile at time 0.",
                    not_accepted("u,depth,x\n5,1,0\n6,2,10\n"));
  const std::vector<SubmittedGroup> sorted = read("u,depth,x,t\n6,2,10,1\n5,1,0,1\n7,3,0,2\n8,4,10,2\n");
  claims.none_wrong("order", "Decreasing positions are sorted.",
                    wrong_entries({sorted.at(0).abscissa, sorted.at(0).values.at("u")}, {{0, 10}, {5, 6}}));
  const std::vector<SubmittedGroup> part = read("u,depth,x,t\n7,3,0,2\n8,4,5,2\n,,7,2\n9,5,10,2\n");
  claims.none_wrong("part", "A submission of one time of two is read, and missing values are gaps.",
                    wrong_entries({{part.at(0).value, part.at(0).gaps.at(0).first, part.at(0).gaps.at(0).second},
                                   part.at(0).abscissa},
                                  {{2, 5, 10}, {0, 5, 10}}));
}

}  // namespace seiche::verification::table_readers_test
