/// An empty folder for the files of a test, gone when the test ends.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace seiche::verification {

class ScratchFolder {
 public:
  /// @param name  what the folder's name begins with; tests that run at once may use the same
  explicit ScratchFolder(const std::string& name) {
    std::string unique = (std::filesystem::temp_directory_path() / (name + ".XXXXXX")).string();
    if (mkdtemp(unique.data()) == nullptr) throw std::runtime_error("no scratch folder can be made: " + unique);
    path_ = unique;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace seiche::verification
