#pragma once

#include <filesystem>
#include <string>

namespace seiche::evidence {

/// One writer for one record: held from the beginning of a run until its record is written. What the holder starts
/// holds it too; it ends with all of them, however they end. The lock is that of a file `.<stem>.lock` (flock), which
/// goes with it.
class RecordLock {
 public:
  /// @throws std::runtime_error if another process holds it, or where the folder cannot be made
  RecordLock(const std::filesystem::path& directory, const std::string& stem);
  RecordLock(const RecordLock&) = delete;
  RecordLock& operator=(const RecordLock&) = delete;
  RecordLock(RecordLock&& other) noexcept;
  RecordLock& operator=(RecordLock&&) = delete;
  ~RecordLock();

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

/// The moment in which files of a folder are put in place: others wait. Where the file system knows no locks, nobody
/// does.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& directory);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  int folder_ = -1;
};

}  // namespace seiche::evidence
