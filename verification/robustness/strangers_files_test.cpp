// Files and texts that others prepared: nothing is read from elsewhere, nothing else is overwritten, nothing strange is
// shown, and what only claims to be large takes no memory.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <hdf5.h>
#include <sys/stat.h>

#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_file.hpp"
#include "seiche/io/hdf5_table.hpp"
#include "seiche/wording.hpp"
#include "verification/check.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::strangers_files_test {

/// An HDF5 file that `fill` writes by the library's own functions, for what ours cannot.
template <class Fill>
std::filesystem::path hdf5_of(const ScratchFolder& scratch, Fill fill) {
  const std::filesystem::path path = scratch.path() / "prepared.h5";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  fill(file);
  H5Fclose(file);
  return path;
}

/// Datasets of doubles whose layout and storage `arrange` decides; the numbers of "h" where some are given.
template <class Arrange>
std::filesystem::path dataset(const ScratchFolder& scratch, hsize_t length, Arrange arrange,
                              const std::vector<const char*>& names = {"h"}, const std::vector<double>& numbers = {}) {
  return hdf5_of(scratch, [&](hid_t file) {
    const hid_t space = H5Screate_simple(1, &length, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    arrange(properties, space);
    for (const char* name : names) {
      const hid_t set = H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
      if (!numbers.empty()) H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
      H5Dclose(set);
    }
    H5Pclose(properties);
    H5Sclose(space);
  });
}

void in_chunks(hid_t properties, hid_t /*space*/) {
  const hsize_t chunk = 1U << 20U;
  H5Pset_chunk(properties, 1, &chunk);
}

std::string reason_of(const std::filesystem::path& path) {
  const io::Table table = io::read_hdf5(path);
  CHECK(table.names.empty());
  const auto found = table.unusable.find("h");
  return found == table.unusable.end() ? "none" : found->second;
}

TEST_CASE("numbers of an HDF5 file that lie in another file are not read", "[robustness]") {
  using Catch::Matchers::Contains;
  const ScratchFolder scratch("seiche_strangers");
  const auto secret = scratch.path() / "secret";
  std::ofstream(secret) << "of nobody's business, eight numbers long, and then some more of it";
  const auto stored_elsewhere =
      dataset(scratch, 8, [&](hid_t properties, hid_t) { H5Pset_external(properties, secret.c_str(), 0, 64); });
  CHECK_THAT(reason_of(stored_elsewhere), Contains("another file"));
  const auto virtual_dataset = dataset(scratch, 8, [&](hid_t properties, hid_t space) {
    H5Pset_virtual(properties, space, secret.c_str(), "x", space);
  });
  CHECK_THAT(reason_of(virtual_dataset), Contains("another file"));
  const auto link = hdf5_of(
      scratch, [&](hid_t file) { H5Lcreate_external(secret.c_str(), "/h", file, "h", H5P_DEFAULT, H5P_DEFAULT); });
  CHECK_THAT(reason_of(link), Contains("another file"));
}

TEST_CASE("a dataset that only claims to be large is rejected before it is read", "[robustness]") {
  const ScratchFolder scratch("seiche_strangers");
  const auto large = dataset(scratch, 2'000'000'000, in_chunks);
  CHECK(std::filesystem::file_size(large) < 1'000'000);
  CHECK_THAT(reason_of(large), Catch::Matchers::Contains("2000000000 elements"));
}

TEST_CASE("the limit is one of the file, not of each dataset", "[robustness]") {
  const ScratchFolder scratch("seiche_strangers");
  const io::Table table = io::read_hdf5(dataset(scratch, 30'000'000, in_chunks, {"a", "h"}));
  CHECK(table.has("a"));
  CHECK(table.unusable.count("h") == 1);
}

TEST_CASE("damage to numbers that carry checksums is seen", "[robustness]") {
  const ScratchFolder scratch("seiche_strangers");
  const auto path = scratch.path() / "ours.h5";
  const std::vector<double> h{1.25, 2.5, 3.75};
  {
    io::Hdf5File file(path);
    file.array("/h", h, "h", "m", "depth");
    file.array("/none", std::vector<double>(), "none", "m", "an empty array");
    file.close();
  }
  CHECK(io::has_checksums(path));
  std::string bytes = io::read_file(path);
  const std::string stored(reinterpret_cast<const char*>(h.data()), h.size() * sizeof(double));
  const std::size_t place = bytes.find(stored);
  REQUIRE(place != std::string::npos);
  bytes[place + 6] = static_cast<char>(bytes[place + 6] ^ 1);
  std::ofstream(path, std::ios::binary) << bytes;
  CHECK(io::read_hdf5(path).unusable.count("h") == 1);

  CHECK_FALSE(io::has_checksums(dataset(
      scratch, h.size(), [](hid_t, hid_t) {}, {"h"}, h)));
}

TEST_CASE("a file takes the place of a file, not of a pipe, a folder or a link", "[robustness]") {
  using Catch::Matchers::Contains;
  const ScratchFolder scratch("seiche_strangers");
  const auto pipe = scratch.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_WITH(io::write_file(pipe, "text"), Contains("pipe"));
  CHECK(std::filesystem::is_fifo(pipe));
  CHECK_THROWS_WITH(io::read_file(pipe), Contains("not a file"));
  const auto link = scratch.path() / "link";
  std::filesystem::create_symlink("target", link);
  CHECK_THROWS_WITH(io::write_file(link, "text"), Contains("symbolic link"));
  CHECK(std::filesystem::is_symlink(link));
  CHECK_THROWS_WITH(io::write_file(scratch.path(), "text"), Contains("folder"));
}

TEST_CASE("untrusted text is shown in printable characters", "[robustness]") {
  CHECK(printable("depth η = 3.5 m, \xF0\x9F\x8C\x8A") == "depth η = 3.5 m, \xF0\x9F\x8C\x8A");
  CHECK(printable("\x1b[2Jgone\r\n\t\x7f") == "?[2Jgone????");
  CHECK(printable("C1: \xC2\x9B") == "C1: ?");                               // CSI in one character
  CHECK(printable("\xE2\x80\xAEtxt.exe") == "?txt.exe");                     // right-to-left override
  CHECK(printable("\x9B|\xC0\xAF|\xED\xA0\x80|\xE2\x82") == "?|??|???|??");  // no UTF-8
  CHECK(printable("").empty());
}

}  // namespace seiche::verification::strangers_files_test
