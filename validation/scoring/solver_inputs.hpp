/// Fields and motions in the forms in which other solvers read them.
///
/// - OpenFOAM: the entry internalField of a field file, which includes it; a nonuniform List, one entry per cell in the
///   order of the centres.
/// - GeoClaw: topography and initial perturbation (qinit) as topotype 1; x y z, rows from north to south, x ascending.
/// - DualSPHysics: the motion of a paddle for mvrectfile with fields 2, fieldtime 0, fieldx 1; time;position.
/// - ParaView: a structured grid as legacy VTK text.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace seiche::validation {

using Vector3 = std::array<double, 3>;

/// Centres of the cells as `postProcess -func writeCellCentres` writes them: the field C, as text.
/// @throws std::invalid_argument naming the file and what is wrong: binary, uniform, another count than it says
std::vector<Vector3> read_openfoam_centres(const std::filesystem::path& file);

/// "internalField nonuniform List<scalar> ...;"
std::string openfoam_field(std::span<const double> values);
std::string openfoam_field(std::span<const Vector3> values);

/// Bottom and top of every cell, from its neighbours in its column: edges halfway between the centres, the outermost as
/// far on the other side. Columns are what lies above each other to a millionth of the range.
/// @param up  the coordinate that points upward, 1 or 2
/// @throws std::invalid_argument for a column of one cell
std::vector<std::pair<double, double>> heights_of_cells(const std::vector<Vector3>& centres, std::size_t up);

/// @param z  [row from the first y][x]: z[j x.size() + i]
std::string geoclaw_grid(std::span<const double> x, std::span<const double> y, std::span<const double> z);

std::string dualsphysics_motion(std::span<const double> times, std::span<const double> positions);

struct NamedField {
  std::string name;
  std::vector<double> values;
};

/// @param counts  points along each direction, the first running fastest
std::string legacy_vtk(const std::string& title, const std::array<std::size_t, 3>& counts,
                       std::span<const Vector3> points, std::span<const NamedField> fields);

}  // namespace seiche::validation
