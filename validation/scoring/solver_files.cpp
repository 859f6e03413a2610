#include "validation/scoring/solver_files.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "seiche/io/hdf5_table.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/case/refusal.hpp"
#include "validation/scoring/gauge_files.hpp"
#include "validation/scoring/geoclaw_grids.hpp"
#include "validation/scoring/openfoam_files.hpp"
#include "validation/scoring/tecplot_files.hpp"

namespace seiche::validation {
namespace {

bool is_station(const std::filesystem::path& file) {
  return file.filename().string().starts_with("sta_");
}

std::string recognised(const io::Text& text) {
  const std::filesystem::path file = text.file;
  if (is_openfoam_set(file)) return "openfoam";
  if (is_geoclaw_grid(file)) return "geoclaw";
  if (text.lines.empty()) return "csv";
  const std::string& first = text.lines.front();
  if (first.starts_with("# Probe") || first.starts_with("# Location")) return "openfoam";
  if (first.find("gauge_id=") != std::string::npos) return "geoclaw";
  if (first.starts_with("number of gauges:")) return "reef3d";
  if (first.find("PosX [m]:") != std::string::npos) return "dualsphysics";
  if (first.starts_with("# 1:t ")) return "gerris";
  if (std::ranges::any_of(text.lines, names_tecplot_variables)) return "tecplot";
  const auto by_swash = [](const std::string& line) {
    return line.starts_with('%') && line.find("SWASH") != line.npos;
  };
  if (std::ranges::any_of(text.lines, by_swash)) return "swash";
  if (is_station(file)) return "funwave";
  for (const std::string& line : text.lines) {
    if (line.starts_with("#") || line.find_first_not_of(" \t") == std::string::npos) continue;
    const bool commas = line.find(',') != std::string::npos;
    return commas && line.find(';') == std::string::npos && !io::is_comment(line) ? "csv" : "delimited";
  }
  return "csv";
}

io::Table read_text(const std::filesystem::path& file, const std::string& format,
                    const std::vector<std::string>& columns) {
  if (format == "openfoam" && is_openfoam_set(file)) return read_openfoam_set(file);
  if (format == "geoclaw" && is_geoclaw_grid(file)) return read_geoclaw_grid(file);
  const io::Text text = io::text_of(file);
  if (text.lines.empty()) fail("{}: no rows of numbers", file.string());
  if (format == "openfoam") return read_openfoam(text);
  if (format == "geoclaw") return read_geoclaw(text);
  if (format == "reef3d") return read_reef3d(text);
  if (format == "dualsphysics") return read_measuretool(text);
  if (format == "tecplot") return read_tecplot(text);
  return io::read_text_table(text, columns, [&](std::size_t count) {
    if (format != "funwave" || count != 4) return std::vector<std::string>{};
    return std::vector<std::string>{"t [s]", "eta [m]", "u [m/s]", "v [m/s]"};
  });
}

ResultFile read_file(const std::filesystem::path& file, const Reading& how) {
  if (how.format == "hdf5" || (how.format == "auto" && io::is_hdf5(file))) {
    return {.table = io::read_hdf5(file, how.wanted), .format = "hdf5", .path = file, .files = {file}};
  }
  for (const char* adapted : {".vtk", ".vtu", ".vtp", ".vts", ".vti", ".pvd", ".nc", ".sww", ".mat", ".npz", ".61"}) {
    if (file.extension() == adapted && how.format == "auto")
      fail("{}: 'python3 -m seiche.adapt' makes a table of it, as its --help says", file.string());
  }
  std::string chosen = how.format;
  constexpr std::size_t opening = 4096;  // [byte]
  if (chosen == "auto") chosen = how.columns.empty() ? recognised(io::text_of(file, opening)) : "delimited";
  return {.table = read_text(file, chosen, how.columns), .format = chosen, .path = file, .files = {file}};
}

/// Stations and gauges, a file each, of a folder.
std::vector<std::filesystem::path> stations_in(const std::filesystem::path& folder) {
  return files_in(folder, [](const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    return is_station(file) || (name.starts_with("gauge") && name.ends_with(".txt"));
  });
}

std::vector<ResultFile> read_folder(const std::filesystem::path& folder, const Reading& how) {
  std::vector<ResultFile> results;
  const bool grids = is_geoclaw_output(folder);
  if (const auto stations = stations_in(folder); !grids && !stations.empty()) {
    for (const auto& file : stations) results.push_back(read_file(file, how));
    return results;
  }
  const FolderTables read = grids ? read_geoclaw_output(folder) : read_openfoam_folder(folder);
  for (const io::Table& table : merged(read.tables)) {
    results.push_back({.table = table, .format = read.format, .path = folder});
  }
  results.front().files = read.files;
  if (how.format != "auto" && how.format != read.format)
    fail("{}: --format {}: is a folder of {}", folder.string(), how.format, read.format);
  return results;
}

}  // namespace

const std::vector<std::string>& solver_formats() {
  static const std::vector<std::string> names{"csv",          "hdf5",  "delimited", "openfoam", "geoclaw", "reef3d",
                                              "dualsphysics", "swash", "funwave",   "gerris",   "tecplot"};
  return names;
}

std::vector<ResultFile> read_results(const std::filesystem::path& path, const Reading& how) {
  if (std::filesystem::is_directory(path)) return read_folder(path, how);
  return {read_file(path, how)};
}

}  // namespace seiche::validation
