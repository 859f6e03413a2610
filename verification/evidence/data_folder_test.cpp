#include <fstream>
#include <stdexcept>

#include "validation/case/data_folder.hpp"
#include "verification/check.hpp"
#include "verification/message_of.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::data_folder_test {

using validation::data_folder;

std::filesystem::path made(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  return folder;
}

TEST_CASE("a program finds its data beside itself, wherever the tree is moved", "[data_folder]") {
  const verification::ScratchFolder scratch("seiche_data_folder_test");
  const auto installed = made(scratch.path() / "prefix/share/seiche/render");
  CHECK(data_folder(scratch.path() / "prefix/bin/seiche", "render") == installed);

  std::filesystem::rename(scratch.path() / "prefix", scratch.path() / "moved");
  CHECK(data_folder(scratch.path() / "moved/bin/seiche", "render") == scratch.path() / "moved/share/seiche/render");
  CHECK_THROWS_AS(data_folder(scratch.path() / "prefix/bin/seiche", "render"), std::runtime_error);
}

TEST_CASE("a program in the build tree prefers the build tree's data", "[data_folder]") {
  const verification::ScratchFolder scratch("seiche_data_folder_test");
  const auto built = made(scratch.path() / "build/share/seiche/render");
  made(scratch.path() / "share/seiche/render");
  CHECK(data_folder(scratch.path() / "build/seiche", "render") == built);
  CHECK(data_folder(scratch.path() / "build/verification/verify_evidence", "render") == built);
}

TEST_CASE("a program without its data names the folders searched", "[data_folder]") {
  const verification::ScratchFolder scratch("seiche_data_folder_test");
  std::ofstream(made(scratch.path() / "prefix/share/seiche") / "render") << "a file, not a folder";
  const std::string prefix = (scratch.path() / "prefix").string();
  const std::string message =
      message_of<std::runtime_error>([&] { data_folder(scratch.path() / "prefix/bin/seiche", "render"); });
  CHECK(message.find(prefix + "/bin/seiche") != std::string::npos);
  CHECK(message.find(prefix + "/share/seiche/render") != std::string::npos);
  CHECK(message.find(prefix + "/bin/share/seiche/render") != std::string::npos);
}

}  // namespace seiche::verification::data_folder_test
