#include "validation/case/data_folder.hpp"

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

std::filesystem::path running_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

}  // namespace seiche::validation
