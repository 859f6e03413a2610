#include "reports/evidence/record_lock.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "seiche/io/atomic_file.hpp"

namespace seiche::evidence {
namespace {

/// Whether the open file is still the one of that name: its last holder may have removed it meanwhile.
bool is_at(int file, const std::filesystem::path& path) {
  struct stat open_one {};
  struct stat named {};
  return fstat(file, &open_one) == 0 && stat(path.c_str(), &named) == 0 && open_one.st_ino == named.st_ino &&
         open_one.st_dev == named.st_dev;
}

}  // namespace

RecordLock::RecordLock(const std::filesystem::path& directory, const std::string& stem)
    : path_(directory / ("." + stem + ".lock")) {
  io::make_folder(directory);
  do {
    if (file_ >= 0) close(file_);
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) {
      throw std::runtime_error(fmt::format("cannot write into {}: {}", directory.string(), std::strerror(errno)));
    }
    if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(file_);
      throw std::runtime_error(
          fmt::format("{} is being written by another process: wait for it, or give another folder by --out",
                      (directory / (stem + ".json")).string()));
    }
  } while (!is_at(file_, path_));
  for (const char* extension : {".json", ".h5", ".xdmf"}) io::remove_partial_files(directory / (stem + extension));
}

RecordLock::RecordLock(RecordLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

RecordLock::~RecordLock() {
  if (file_ < 0) return;
  std::error_code ignored;  // a folder that is gone needs no cleaning
  std::filesystem::remove(path_, ignored);
  close(file_);
}

FolderLock::FolderLock(const std::filesystem::path& directory)
    : folder_(open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  while (folder_ >= 0 && flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace seiche::evidence
