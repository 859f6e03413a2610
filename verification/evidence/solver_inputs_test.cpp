// Files that other solvers read, read back.
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "seiche/io/atomic_file.hpp"
#include "validation/scoring/solver_inputs.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"
#include "verification/message_of.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::solver_inputs_test {

const std::string header = "FoamFile\n{\n    version 2.0;\n    format %;\n    class volVectorField;\n}\n";

std::string centres_file(const std::string& list, const std::string& format = "ascii") {
  std::string text = header;
  text.replace(text.find('%'), 1, format);
  return text + "dimensions [0 1 0 0 0 0 0];\ninternalField   nonuniform " + list +
         "boundaryField\n{\n    wall { type calculated; value nonuniform List<vector> 1((9 9 9)); }\n}\n";
}

std::vector<validation::Vector3> read(const std::string& text) {
  const ScratchFolder scratch("seiche_solver_inputs_test");
  const std::filesystem::path file = scratch.path() / "C";
  io::write_file(file, text);
  return validation::read_openfoam_centres(file);
}

std::string refusal(const std::string& text) {
  return message_of([&] { read(text); });
}

TEST_CASE("files for other solvers are in the formats that these read", "[evidence]") {
  Check check("solver_inputs", "Initial states for other solvers",
              "Lists of OpenFOAM, grids of GeoClaw, a motion for DualSPHysics and a legacy VTK file, read back number "
              "by number.");
  const auto is = [&](const auto&... words) { says(check, words..., "the format"); };
  const auto exactly = [&](const std::string& text, double value, double expected) {
    check.holds(text, {value}, Bound{0, "17 digits hold a number", expected});
  };
  const std::string three = "List<vector>\n3\n(\n(0.1 0 0.5)\n(0.1 0 1.5)\n(0.1 0 3.5)\n)\n;\n";
  const std::vector<validation::Vector3> centres = read(centres_file(three));
  exactly("Centres inside are read, and centres of boundaries are not.", static_cast<double>(centres.size()), 3);
  exactly("The last entry of the list is read whole.", centres.at(2)[2], 3.5);
  is("A binary field is rejected with its reason.", refusal(centres_file(three, "binary")), "writeFormat ascii");
  is("A field that is cut short is rejected.", refusal(centres_file("List<vector> 4((1 1 1)(2 2 2)(3 3 3));\n")),
     "holds 3 centres, must be 4");
  is("A uniform field, which has no list, is rejected.", refusal(centres_file("uniform (0 0 0);\n")),
     "no nonuniform List<vector>");

  const auto edges = validation::heights_of_cells(centres, 2);
  exactly("The lowest cell ends half a cell below its centre.", edges.at(0).first, 0);
  exactly("Cell edges are halfway between the cells' centres.", edges.at(1).second, 2.5);
  exactly("The highest cell ends as far above its centre as below.", edges.at(2).second, 4.5);
  is("A column of one cell is rejected.", message_of([] {
       validation::heights_of_cells({{0, 0, 0}, {1, 0, 1}}, 2);
     }),
     "one cell alone at x = 0");

  const std::vector<double> scalars{0.1, 1.0 / 3};
  std::istringstream list(validation::openfoam_field(scalars));
  std::string word;
  double number = 0;
  while (word != "(") list >> word;
  list >> number >> number;
  exactly("A scalar is written with all its digits.", number, 1.0 / 3);
  is("Vectors of OpenFOAM are written in brackets.",
     validation::openfoam_field(std::vector<validation::Vector3>{{1, 0, -0.0}}), "List<vector>\n1\n(\n(1 0 0)\n)\n;");

  // Two rows in y, three in x: GeoClaw begins in the north-west.
  const std::vector<double> x{0, 1, 2}, y{10, 20}, z{1, 2, 3, 4, 5, 6};
  is("Rows of GeoClaw are ordered from north to south.", validation::geoclaw_grid(x, y, z),
     "0 20 4\n1 20 5\n2 20 6\n0 10 1\n");
  is("A paddle's motion is written as time;position.",
     validation::dualsphysics_motion(std::vector<double>{0, 0.5}, std::vector<double>{0, 0.25}), "\n0;0\n0.5;0.25\n");
  const std::string vtk = validation::legacy_vtk("t", {2, 1, 1}, std::vector<validation::Vector3>{{0, 0, 0}, {1, 0, 0}},
                                                 std::vector<validation::NamedField>{{"eta", {0.5, NAN}}});
  is("VTK names counts, points and fields.", vtk,
     "DIMENSIONS 2 1 1\nPOINTS 2 double\n0 0 0\n1 0 0\nPOINT_DATA 2\nSCALARS eta double 1\nLOOKUP_TABLE "
     "default\n0.5\nnan\n");
}

}  // namespace seiche::verification::solver_inputs_test
