// Files of solvers whose numbers are spread over folders, patches and columns: each ends up in its own row.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/scoring/solver_files.hpp"
#include "validation/scoring/submitted.hpp"
#include "verification/check.hpp"
#include "verification/message_of.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::solver_folders_test {

using validation::Reading;
using validation::ResultFile;
using Columns = std::vector<std::vector<double>>;

/// Names and rows as text: "t,x,h|0,1,2|0.5,1,3".
std::string text_of(const io::Table& table) {
  std::string text = fmt::format("{}", fmt::join(table.names, ","));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<double> entries;
    for (const std::vector<double>& column : table.columns) entries.push_back(column.at(row));
    text += fmt::format("|{}", fmt::join(entries, ","));
  }
  return text;
}

class Folder {
 public:
  explicit Folder(Check& check) : check_(check) {}

  void write(const std::string& name, const std::string& text) const {
    const auto path = scratch_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  [[nodiscard]] std::vector<ResultFile> read(const std::string& name, const Reading& how = {}) const {
    return validation::read_results(scratch_.path() / name, how);
  }

  void is(const std::string& id, const std::string& text, const std::string& name, const std::string& expected,
          const Reading& how = {}) const {
    std::string got;
    try {
      const std::vector<ResultFile> tables = read(name, how);
      got = tables.size() == 1 ? text_of(tables.front().table) : fmt::format("{} tables", tables.size());
    } catch (const std::invalid_argument& refusal) {
      got = refusal.what();
    }
    INFO(got << " / " << expected);
    check_.holds(id + ": " + text, {got == expected ? 1.0 : 0.0},
                 Qualitative{"every name and number of the table", "the file was written so"});
  }

  void refused(const std::string& id, const std::string& text, const std::string& name, const std::string& word,
               const Reading& how = {}) const {
    const std::string said = message_of([&] { (void)read(name, how); });
    INFO(said);
    check_.holds(id + ": " + text, {said.find(word) != std::string::npos ? 1.0 : 0.0},
                 Qualitative{"an error that says \"" + word + "\"", "nothing is made up"});
  }

 private:
  ScratchFolder scratch_{"seiche_solver_folders"};
  Check& check_;
};

TEST_CASE("numbers in folders, patches and wide tables get rows of their own", "[evidence]") {
  Check check("solver_folders", "Results that are spread over files",
              "OpenFOAM's folders of times and of restarts, GeoClaw's refined patches, gauges beside each other.");
  const Folder folder(check);

  folder.write("line/0.5/line_h_p_rgh.xy", "0 1 10\n1 2 20\n");
  folder.write("line/0.5/line_U.xy", "0 5 6 7\n1 8 9 10\n");
  folder.write("line/10/line_h_p_rgh.xy", "0 3 30\n");
  folder.write("line/10/line_U.xy", "0 11 12 13\n");
  folder.is("sets", "Sets of every time follow by number, scalars and vectors beside each other.", "line",
            "x,U_x,U_y,U_z,t,h,p_rgh|0,5,6,7,0.5,1,10|1,8,9,10,0.5,2,20|0,11,12,13,10,3,30");
  folder.write("points/1/line_h.xy", "# x y z h\n0 0.5 0 4\n");
  folder.write("points/2/line_h.xy", "0 0.5 0 5\n");
  folder.is("points", "Three coordinates are not interpreted as a vector.", "points",
            "x,y,z,h,t|0,0.5,0,4,1|0,0.5,0,5,2");
  folder.write("two/1/a_h.xy", "0 1\n");
  folder.write("two/1/b_h.xy", "5 1\n");
  folder.refused("several", "Sets of different points in one folder are not mixed.", "two", "2 sets");
  folder.refused("no-times", "A folder without times is rejected, with a list of its content.", "", "line");

  // The second start repeats t = 1; two of the probes stand above each other.
  const std::string probes = "# Probe 0 (1 0 0)\n# Probe 1 (1 0.5 0)\n# Time\n";
  folder.write("probes/0/h", probes + "0 10 11\n1 12 13\n2 14 15\n");
  folder.write("probes/0/p", probes + "0 1 2\n1 3 4\n2 5 6\n");
  folder.write("probes/0.5/h", probes + "1 22 23\n");
  folder.write("probes/0.5/p", probes + "1 7 8\n");
  folder.is("restart", "Rows repeated by a restart follow the earlier rows.", "probes",
            "x,y,z,t,h,p|1,0,0,0,10,1|1,0.5,0,0,11,2|1,0,0,1,12,3|1,0.5,0,1,13,4|1,0,0,2,14,5|1,0.5,0,2,15,6|1,0,0,1,"
            "22,7|1,0.5,0,1,23,8");
  const validation::RowOrder order = validation::in_order({0, 1, 2, 3, 1, 2, 3, 4}, {0, 1, 2, 3, 4, 5, 6, 7});
  check.holds("Rows repeated by a restart replace the earlier rows.",
              {order.rows == std::vector<std::size_t>{0, 4, 5, 6, 7} ? 1.0 : 0.0},
              Qualitative{"rows 0, 4, 5, 6, 7", "the later rows count"});

  const std::string coarse = "1 grid_number\n1 AMR_level\n3 mx\n0 xlow\n1 dx\n\n1 0 1\n9 9 9\n3 0 3\n\n";
  const std::string fine = "2 grid_number\n2 AMR_level\n2 mx\n1 xlow\n0.5 dx\n\n4 0 4\n5 0 5\n";
  folder.write("_output/fort.q0002", coarse + fine);
  folder.write("_output/fort.t0002", "  7.0 time\n");
  folder.is("patches", "The finer of two patches counts, in the order of x.", "_output",
            "x,t,h,hu,eta|0.5,7,1,0,1|1.25,7,4,0,4|1.75,7,5,0,5|2.5,7,3,0,3");
  folder.write("plan/fort.q0000",
               "1 grid_number\n1 AMR_level\n2 mx\n2 my\n0 xlow\n0 ylow\n1 dx\n2 dy\n\n1 2 3 4\n5 6 7 8\n\n9 10 11 "
               "12\n13 14 15 16\n");
  folder.write("plan/fort.t0000", "0 time\n");
  folder.is("plan", "The index x runs fastest in two dimensions.", "plan",
            "x,y,t,h,hu,hv,eta|0.5,1,0,1,2,3,4|1.5,1,0,5,6,7,8|0.5,3,0,9,10,11,12|1.5,3,0,13,14,15,16");
  folder.write("mixed/fort.q0000",
               coarse + "2 grid_number\n2 AMR_level\n1 mx\n1 my\n0 xlow\n0 ylow\n1 dx\n1 dy\n\n1 0 0 1\n");
  folder.write("mixed/fort.t0000", "0 time\n");
  folder.refused("mixed", "Patches of one and of two dimensions are not mixed.", "mixed", "must all be alike");
  folder.write("layers/gauge00001.txt",
               "# gauge_id= 1 location=( 2 3 ) num_var= 8\n# Columns: level, time, q[ 1 2 3 4 5 6 ], eta, aux[]\n1 0 1 "
               "2 3 4 5 6 0.5 0.25\n");
  folder.is("layers", "A gauge of several layers has the surface after them.", "layers/gauge00001.txt",
            "level,t,q1,q2,q3,q4,q5,q6,eta,eta2,x,y|1,0,1,2,3,4,5,6,0.5,0.25,2,3");
  folder.write("names/6/_.xy", "0 1 2\n1 1 2\n");
  folder.refused("underscore", "The columns follow from the name of the set.", "names/6/_.xy", "do not fit the name");
  folder.write("nowhere.csv", " ;PosX [m]:\n ;PosY [m]:\n ;PosZ [m]:\nPart;Time [s]\n0;0.0\n1;1.0\n");
  folder.refused("nowhere", "MeasureTool without a position is rejected.", "nowhere.csv", "no positions");
  folder.write("cut/fort.q0000", coarse.substr(0, coarse.size() - 7));
  folder.write("cut/fort.t0000", "0 time\n");
  folder.refused("cut", "A patch with missing rows is rejected.", "cut", "1 cells before the patch does");

  folder.write("sta_0007", "0 1 2 3\n");
  folder.is("station", "The columns of a station are its four quantities.", "sta_0007", "t,eta,u,v|0,1,2,3");
  folder.write("table.tbl", "%\n% Run:1 Table:T SWASH\n%\n% Tsec Xp Watlev\n% [sec] [m] [m]\n%\n0 1 2\n");
  folder.is("swash", "The columns of a SWASH table follow from its header.", "table.tbl", "Tsec,Xp,Watlev|0,1,2");
  folder.write("points.txt", "# 1:t 2:x 3:T\n0 1 0.5\n");
  folder.is("gerris", "A table of Gerris is read with the columns that its header names.", "points.txt",
            "t,x,T|0,1,0.5");
}

}  // namespace seiche::verification::solver_folders_test
