#include "seiche/io/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace seiche::io {
namespace {

std::string partial_suffix(long process) {
  return fmt::format(".{}.part", process);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)),
      partial_(target_.parent_path() / ("." + target_.filename().string() + partial_suffix(getpid()))) {
  if (target_.has_parent_path()) {
    std::error_code failure;
    std::filesystem::create_directories(target_.parent_path(), failure);
    if (failure) {
      throw std::runtime_error(
          fmt::format("cannot make folder {}: {}", target_.parent_path().string(), failure.message()));
    }
  }
}

AtomicFile::~AtomicFile() {
  if (!committed_) {
    std::error_code ignored;  // a file never opened is not there to be removed
    std::filesystem::remove(partial_, ignored);
  }
}

void AtomicFile::commit() {
  std::filesystem::rename(partial_, target_);
  committed_ = true;
}

void write_file(const std::filesystem::path& target, std::string_view text) {
  AtomicFile file(target);
  std::ofstream out(file.path(), std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", target.string(), std::generic_category().message(errno)));
  }
  file.commit();
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) throw std::runtime_error(fmt::format("cannot read {}", path.string()));
  return text;
}

void remove_partial_files(const std::filesystem::path& directory, long process) {
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(directory, failure)) {
    if (entry.path().filename().string().ends_with(partial_suffix(process))) {
      std::filesystem::remove(entry.path(), failure);
    }
  }
}

}  // namespace seiche::io
