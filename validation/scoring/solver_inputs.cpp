#include "validation/scoring/solver_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/atomic_file.hpp"
#include "seiche/samples.hpp"
#include "validation/case/refusal.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

std::string text_of(double value) {
  return fmt::format("{:.17g}", value + 0.0);  // 0 for -0
}
std::string text_of(const Vector3& value) {
  return fmt::format("({:.17g} {:.17g} {:.17g})", value[0] + 0.0, value[1] + 0.0, value[2] + 0.0);
}

template <class Value>
std::string field_of(std::span<const Value> values, const char* type) {
  std::string text = fmt::format("internalField   nonuniform List<{}>\n{}\n(\n", type, values.size());
  for (const Value& value : values) text += text_of(value) + "\n";
  return text + ")\n;\n";
}

}  // namespace

std::vector<Vector3> read_openfoam_centres(const std::filesystem::path& file) {
  const auto fail = [&](const std::string& what) { validation::fail("{}: {}", file.string(), what); };
  if (!std::filesystem::is_regular_file(file)) fail("cannot be read as a file");
  const std::string text = io::read_file(file);
  const std::size_t header = std::min(text.find("internalField"), text.size());
  const std::string opening = text.substr(0, header);
  if (opening.find("binary") != std::string::npos) fail("is binary: set writeFormat ascii and write the centres again");
  if (header == text.size()) fail("has no internalField: 'postProcess -func writeCellCentres' writes the field C");
  std::string body = text.substr(header);
  const std::size_t boundary = body.find("boundaryField");
  if (boundary != std::string::npos) body.resize(boundary);
  const std::string type = "List<vector>";
  const std::size_t list = body.find(type);
  if (list == std::string::npos) fail("internalField is no nonuniform List<vector>");
  body.erase(0, list + type.size());
  std::ranges::replace_if(
      body, [](char c) { return c == '(' || c == ')' || c == ';'; }, ' ');
  std::istringstream in(body);
  std::size_t count = 0;
  if (!(in >> count)) fail("List<vector> does not say how many");
  std::vector<Vector3> centres;
  for (Vector3 one{}; in >> one[0] >> one[1] >> one[2];) centres.push_back(one);
  if (centres.size() != count || !in.eof()) {
    fail(fmt::format("holds {} centres, must be {} numbers in threes", centres.size(), count));
  }
  return centres;
}

std::string openfoam_field(std::span<const double> values) {
  return field_of(values, "scalar");
}
std::string openfoam_field(std::span<const Vector3> values) {
  return field_of(values, "vector");
}

std::vector<std::pair<double, double>> heights_of_cells(const std::vector<Vector3>& centres, std::size_t up) {
  if (up != 1 && up != 2) fail("up = {}: must be 1 (y) or 2 (z)", up);
  const std::size_t across = 3 - up;
  const auto extent = [&](std::size_t axis) {
    const auto along = each(centres, [&](const Vector3& centre) { return centre[axis]; });
    return along.empty() ? 0 : largest(along) - smallest(along);
  };
  const double range = std::max(extent(0), extent(across));
  const double unit = range > 0 ? 1e-6 * range : 1;
  std::map<std::pair<long long, long long>, std::vector<std::size_t>> columns;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    columns[{std::llround(centres[i][0] / unit), std::llround(centres[i][across] / unit)}].push_back(i);
  }
  std::vector<std::pair<double, double>> edges(centres.size());
  for (auto& [place, cells] : columns) {
    if (cells.size() < 2) {
      fail("one cell alone at x = {:g}: cells must stand above each other, two or more, with {} upward",
           centres[cells.front()][0], up == 1 ? "y" : "z");
    }
    std::ranges::sort(cells, {}, [&](std::size_t cell) { return centres[cell][up]; });
    const auto height = [&, &cells = cells](std::size_t k) { return centres[cells[k]][up]; };
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const bool first = k == 0;
      const bool last = k + 1 == cells.size();
      const double below = first ? height(0) - 0.5 * (height(1) - height(0)) : 0.5 * (height(k - 1) + height(k));
      const double above = last ? height(k) + 0.5 * (height(k) - height(k - 1)) : 0.5 * (height(k) + height(k + 1));
      edges[cells[k]] = {below, above};
    }
  }
  return edges;
}

std::string geoclaw_grid(std::span<const double> x, std::span<const double> y, std::span<const double> z) {
  if (z.size() != x.size() * y.size()) fail("{} values for {} x {} points", z.size(), x.size(), y.size());
  std::string text;
  for (std::size_t j = y.size(); j-- > 0;) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      text += fmt::format("{:.17g} {:.17g} {:.17g}\n", x[i] + 0.0, y[j] + 0.0, z[j * x.size() + i] + 0.0);
    }
  }
  return text;
}

std::string dualsphysics_motion(std::span<const double> times, std::span<const double> positions) {
  if (times.size() != positions.size()) fail("{} times and {} positions", times.size(), positions.size());
  std::string text = "#time [s];position [m]\n";
  for (std::size_t k = 0; k < times.size(); ++k) text += fmt::format("{:.12g};{:.12g}\n", times[k], positions[k] + 0.0);
  return text;
}

std::string legacy_vtk(const std::string& title, const std::array<std::size_t, 3>& counts,
                       std::span<const Vector3> points, std::span<const NamedField> fields) {
  const std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t{1}, std::multiplies<>());
  if (points.size() != total) fail("{} points, must be {}", points.size(), fmt::join(counts, " x "));
  std::string text =
      fmt::format("# vtk DataFile Version 3.0\n{}\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS {}\nPOINTS {} double\n",
                  title.substr(0, 255), fmt::join(counts, " "), total);
  for (const Vector3& point : points) text += fmt::format("{:.17g}\n", fmt::join(point, " "));
  text += fmt::format("POINT_DATA {}\n", total);
  for (const NamedField& field : fields) {
    if (field.values.size() != total) fail("field {}: {} values for {} points", field.name, field.values.size(), total);
    text += fmt::format("SCALARS {} double 1\nLOOKUP_TABLE default\n", field.name);
    for (const double value : field.values) text += text_of(value) + "\n";
  }
  return text;
}

}  // namespace seiche::validation
