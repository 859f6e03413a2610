#include "seiche/io/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "seiche/require_that.hpp"

#ifdef SEICHE_COVERAGE
extern "C" void __gcov_dump();  // GCC's own, declared by <gcov.h> of the compiler's plugins alone
#endif

namespace seiche::io {
namespace {

constexpr std::string_view partial_extension = ".part";

std::string partial_suffix(long process) {
  return fmt::format(".{}{}", process, partial_extension);
}

std::string in_words(std::filesystem::file_type type) {
  using Type = std::filesystem::file_type;
  if (type == Type::symlink) return "a symbolic link";
  if (type == Type::directory) return "a folder";
  return type == Type::none || type == Type::unknown ? "out of reach" : "a device or a pipe";
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  require_that<std::runtime_error>(!failure, "cannot make folder {}: {}", folder.string(), failure.message());
}

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)),
      partial_(target_.parent_path() / ("." + target_.filename().string() + partial_suffix(getpid()))) {
  if (target_.has_parent_path()) make_folder(target_.parent_path());
  // The file takes the place of what has the name: of an older file, not of a device or of what a link leads to.
  std::error_code unreachable;
  const std::filesystem::file_type there = std::filesystem::symlink_status(target_, unreachable).type();
  require_that<std::runtime_error>(
      there == std::filesystem::file_type::regular || there == std::filesystem::file_type::not_found,
      "cannot write {}: it is {}, must be a file or not there", target_.string(), in_words(there));
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

void AtomicFile::write(std::string_view text) const {
  std::ofstream out(partial_, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  require_that<std::runtime_error>(out.good(), "cannot write {}: {}", target_.string(),
                                   std::generic_category().message(errno));
}

void write_file(const std::filesystem::path& target, std::string_view text) {
  AtomicFile file(target);
  file.write(text);
  file.commit();
}

std::string read_file(const std::filesystem::path& path) {
  std::error_code unreachable;
  require_that<std::runtime_error>(std::filesystem::is_regular_file(path, unreachable),
                                   "cannot read {}: it is not a file", path.string());
  std::ifstream in(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  require_that<std::runtime_error>(!in.fail(), "cannot read {}", path.string());
  return text;
}

void remove_partial_files(const std::filesystem::path& target) {
  const std::string begin = "." + target.filename().string() + ".";
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(target.parent_path(), failure)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin) || !name.ends_with(partial_extension)) continue;
    const std::string_view process =
        std::string_view(name).substr(begin.size(), name.size() - begin.size() - partial_extension.size());
    if (process.find_first_not_of("0123456789") == std::string_view::npos) {
      std::filesystem::remove(entry.path(), failure);
    }
  }
}

void remove_partial_files(const std::filesystem::path& directory, long process) {
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(directory, failure)) {
    if (entry.path().filename().string().ends_with(partial_suffix(process))) {
      std::filesystem::remove(entry.path(), failure);
    }
  }
}

void leave(int status) {
#ifdef SEICHE_COVERAGE
  __gcov_dump();
#endif
  _exit(status);
}

}  // namespace seiche::io
