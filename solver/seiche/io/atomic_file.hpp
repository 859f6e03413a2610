#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace seiche::io {

/// A file that appears under its name only when it is whole: written beside it, renamed by commit(), removed by the
/// destructor otherwise. Readers never see half a file, and a failed run leaves none behind.
class AtomicFile {
 public:
  /// @throws std::runtime_error if the folder does not exist and cannot be made, or if the name is taken by anything
  /// but a file: a device, a pipe, a folder, a symbolic link
  explicit AtomicFile(std::filesystem::path target);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& path() const { return partial_; }
  /// Writes the whole text there. @throws std::runtime_error naming the file when it cannot
  void write(std::string_view text) const;
  /// Makes the file appear, replacing an older one.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
  bool committed_ = false;
};

/// Makes a folder and those above it, where they are missing. @throws std::runtime_error naming it and why not
void make_folder(const std::filesystem::path& folder);

/// Writes text atomically. @throws std::runtime_error naming the file when it cannot be written whole.
void write_file(const std::filesystem::path& target, std::string_view text);

/// Reads a whole file. @throws std::runtime_error naming the file when it cannot be read, or is a pipe or a device.
std::string read_file(const std::filesystem::path& path);

/// Removes the partial files of a process that died while writing.
void remove_partial_files(const std::filesystem::path& directory, long process);
/// Removes the partial files that anybody left of `target`: for the one who alone writes it now.
void remove_partial_files(const std::filesystem::path& target);

/// Ends a forked child at once: what its parent would destroy or print at its own end is left to the parent.
///
/// Where lines are counted (SEICHE_COVERAGE) the child's counts are written first.
[[noreturn]] void leave(int status);

}  // namespace seiche::io
