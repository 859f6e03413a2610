#include "validation/case/data_folder.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {

std::filesystem::path data_folder(const std::filesystem::path& program, const std::string& name) {
  const std::filesystem::path folder = program.parent_path();
  const std::filesystem::path built = folder / "share/seiche" / name;
  const std::filesystem::path installed = folder.parent_path() / "share/seiche" / name;
  for (const std::filesystem::path& place : {built, installed}) {
    if (std::filesystem::is_directory(place)) return place;
  }
  throw std::runtime_error(fmt::format("{} of {} is neither at {} nor at {}: install it with its share/seiche", name,
                                       program.string(), installed.string(), built.string()));
}

std::filesystem::path data_folder(const std::string& name) {
  return data_folder(running_program(), name);
}

std::vector<std::vector<std::string>> recorded_rows(const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream file(data_folder("record") / name);
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::istringstream fields(line);
    auto& row = rows.emplace_back();
    for (std::string word; std::getline(fields, word, ',');) row.push_back(word);
  }
  return rows;
}

std::filesystem::path running_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

}  // namespace seiche::validation
