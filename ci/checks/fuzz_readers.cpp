// Structured inputs for every reader of text files, by libFuzzer: its bytes choose among the words of a format's
// grammar, so that most inputs are nearly right. A reader gives a table or throws std::invalid_argument of one line;
// anything else, and any error that a sanitizer sees, ends the run. Built and run by ci/checks/fuzz.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "seiche/io/text_table.hpp"
#include "validation/scoring/gauge_files.hpp"
#include "validation/scoring/geoclaw_grids.hpp"
#include "validation/scoring/openfoam_files.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/tecplot_files.hpp"

using namespace seiche;

namespace {

/// Words chosen by the fuzzer's bytes; the first of the list when they are used up.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  [[nodiscard]] bool more() const { return left_ > 0; }
  std::size_t below(std::size_t bound) {
    if (left_ == 0) return 0;
    --left_;
    return *data_++ % bound;
  }
  std::string one(const std::vector<std::string>& words) { return words[below(words.size())]; }
  std::string number() {
    return one(
        {"0",   "1",     "2",    "0.5", "-1.5e-3", "1.5D+00", "1.5-103", "0,5", "nan", "-9999", "1e20",
         "inf", "1e999", "-",    "",    "7",       "\"3\"",   "x",       "[m]", "(1",  "1)",    "99999999999999999999",
         "NA",  "***",   "1.2.3"});
  }
  std::string row(std::size_t columns, const std::string& separator) {
    std::string text;
    for (std::size_t k = 0; k < columns + (below(16) == 1 ? 1 : 0); ++k) text += (k > 0 ? separator : "") + number();
    return text + one({"\n", "\n", "\r\n", "\r", separator + "\n"});
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

std::string table(Choices& choose) {
  const std::string separator = choose.one({",", ";", "\t", " ", "  "});
  const std::size_t columns = 1 + choose.below(5);
  std::string text = choose.one({"", "\xEF\xBB\xBF", "a title\n", "# a title\n\n", "%\n% SWASH\n"});
  if (choose.below(4) != 1) {
    text += choose.one({"", "# ", "% ", "// ", "# 1:"});
    for (std::size_t k = 0; k < columns; ++k) {
      text += (k > 0 ? separator : "") +
              choose.one({"t", "eta", "x", "y", "h", "hu", "u", "gauge", "6", "WG9", "time", "level"}) +
              choose.one({"", " [m]", "(s)", "[cm]", " [m", "[seconds since 2020-01-01 00:00:00]", " [m/s]", "[", "[]",
                          " (-)"});
    }
    text += "\n" + choose.one({"", "", "[s]" + separator + "[m]\n"});
  }
  while (choose.more())
    text += choose.below(16) == 1 ? choose.one({"# more\n", "\n", "t,eta\n"}) : choose.row(columns, separator);
  return text;
}

std::string rows(Choices& choose, const std::string& head, const std::string& separator) {
  std::string text = head;
  const std::size_t columns = 1 + choose.below(8);
  while (choose.more()) text += choose.row(columns, separator);
  return text;
}

std::string probes(Choices& choose) {
  std::string head;
  for (std::size_t k = choose.below(4); k > 0; --k) {
    head += choose.one({"# Probe 0 (", "# Location 0 : (", "# Probe ("}) + choose.number() + " 0" +
            choose.one({" 0)\n", ")\n", "\n"});
  }
  return rows(choose, head + "# Time\n", choose.one({" ", " (", ") "}));
}

std::string geoclaw_gauge(Choices& choose) {
  return rows(
      choose,
      "# gauge_id= 1 location=( " + choose.number() + " " + choose.number() + choose.one({" )", ""}) + "\n" +
          choose.one({"", "# Columns: level, time, q[ 1 2 3 ], eta\n", "# q[1 2 3 4 5 6], eta\n", "# q[\n", "# q[]\n"}),
      " ");
}

std::string geoclaw_grid(Choices& choose) {
  std::string text;
  while (choose.more()) {
    text += choose.number() + " AMR_level\n";
    for (const char* word : {"mx", "my", "xlow", "ylow", "dx", "dy"}) {
      if (choose.below(8) != 1) text += choose.one({"1", "2", "0.5", choose.number()}) + " " + word + "\n";
    }
    text += choose.one({"\n", "", "\n\n"});
    for (std::size_t k = choose.below(6); k > 0; --k) text += choose.row(1 + choose.below(4), " ");
    text += "\n";
  }
  return text;
}

std::string reef3d(Choices& choose) {
  std::string text = "number of gauges:  2\n\nx_coord y_coord\n";
  for (std::size_t k = choose.below(4); k > 0; --k) text += choose.row(3, " ");
  return rows(choose, text + choose.one({"time P1\n", ""}), " ");
}

std::string measuretool(Choices& choose) {
  const std::string separator = choose.one({";", ","});
  std::string text;
  for (const char* axis : {"X", "Y", "Z"}) {
    text += " " + separator + "Pos" + axis + " [m]:";
    for (std::size_t k = choose.below(4); k > 0; --k) text += separator + choose.number();
    text += "\n";
  }
  text += "Part" + separator + "Time [s]";
  for (std::size_t k = choose.below(4); k > 0; --k)
    text += separator + choose.one({"Elevation_0 [m]", "Vel", "_", "[", ""});
  return rows(choose, text + "\n", separator);
}

std::string tecplot(Choices& choose) {
  std::string text = choose.one({"", "TITLE = \"a, b\"\n"}) + "VARIABLES = ";
  for (std::size_t k = choose.below(4); k > 0; --k) {
    text += choose.one({"\"t\"", "\"X, m\"", "\"eta [m]\"", "h, ", "\"\"", "\"[", " u\n", ",", "\n\"x\""});
  }
  while (choose.more()) {
    text += "\nZONE ";
    for (std::size_t k = choose.below(5); k > 0; --k) {
      text += choose.one({"T=\"zone 1\"", "I=", "J = ", "F=POINT", "F=BLOCK", "DATAPACKING=BLOCK",
                          "SOLUTIONTIME=", "\n", "ZONETYPE=FEQUAD", "N=", "="}) +
              choose.one({"", ",", " 1 ", " 2, ", choose.number()});
    }
    text += "\n";
    for (std::size_t k = choose.below(6); k > 0; --k) text += choose.row(1 + choose.below(4), " ");
  }
  return text;
}

io::Text text_of(const std::string& content, const std::string& name) {
  std::istringstream in(content);
  return io::text_of(in, name);
}

/// What the command makes of a table: columns, units, gauges, gaps.
void submit(const io::Table& table) {
  using validation::WantedTable;
  const auto points = [](double) { return std::vector<double>{0, 1, 2}; };
  const auto none = [](validation::Place p) { return p.abscissa > 1 ? 0.0 : 1.0; };
  const std::vector<WantedTable> wanted{
      {.name = "gauges",
       .kind = WantedTable::Kind::series,
       .group = validation::Column{"gauge", "1", ""},
       .abscissa = validation::Column{"t", "s", ""},
       .quantities = {{.column = {"eta", "m", ""}, .reference = none}},
       .groups = {6, 9},
       .points = points,
       .places = std::map<double, std::pair<double, double>>{{6, {0.5, 0}}, {9, {1, 0}}}},
      {.name = "profile",
       .kind = WantedTable::Kind::profile,
       .abscissa = validation::Column{"x", "m", ""},
       .quantities = {{.column = {"h", "m", ""}, .reference = none}, {.column = {"u", "m/s", ""}, .reference = none}},
       .points = points}};
  validation::Understanding understood;
  validation::submitted_from({table}, wanted, understood);
}

io::Table read(const std::string& format, Choices& choose) {
  if (format == "probes") return validation::read_openfoam(text_of(probes(choose), "probes"));
  if (format == "geoclaw") return validation::read_geoclaw(text_of(geoclaw_gauge(choose), "gauge00001.txt"));
  if (format == "reef3d") return validation::read_reef3d(text_of(reef3d(choose), "WSF.dat"));
  if (format == "measuretool") return validation::read_measuretool(text_of(measuretool(choose), "m.csv"));
  if (format == "tecplot") return validation::read_tecplot(text_of(tecplot(choose), "t.dat"));
  if (format == "table") return io::read_text_table(text_of(table(choose), "table.csv"));
  // Readers of files, whose names tell something.
  const std::filesystem::path folder = std::getenv("SEICHE_FUZZ_FOLDER");  // NOLINT(concurrency-mt-unsafe)
  const bool grid = format == "grid";
  const std::filesystem::path file =
      folder / (grid ? "fort.q0001" : choose.one({"_", "__", "a_U", "a_p_rgh", "a_h", "a", "_h", "p_rgh"}) + ".xy");
  std::ofstream(file, std::ios::binary) << (grid ? geoclaw_grid(choose)
                                                 : rows(choose, choose.one({"", "# x h\n"}), " "));
  if (grid) std::ofstream(folder / "fort.t0001") << choose.number() << " time\n";
  return grid ? validation::read_geoclaw_grid(file) : validation::read_openfoam_set(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Choices choose(data, size);
  try {
    submit(read(std::getenv("SEICHE_FUZZ_READER"), choose));  // NOLINT(concurrency-mt-unsafe): one thread
  } catch (const std::invalid_argument& refusal) {
    const std::string said = refusal.what();
    if (said.empty() || std::any_of(said.begin(), said.end(), [](char c) { return c == '\n' || c == '\r'; }))
      std::abort();
  }
  return 0;
}
