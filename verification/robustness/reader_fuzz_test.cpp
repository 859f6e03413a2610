// Damaged files: readers must succeed or refuse in one line, whatever the bytes.
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_file.hpp"
#include "seiche/io/hdf5_table.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/case/configuration.hpp"
#include "validation/case/registry.hpp"
#include "validation/scoring/solver_files.hpp"
#include "verification/check.hpp"
#include "verification/robustness/fuzzing.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::reader_fuzz_test {

void claim(Check& check, const std::string& format, const Tally& tally) {
  const long count = tally.accepted + tally.refused + tally.misbehaved;
  INFO(format << ": " << tally.example);
  check.holds(fmt::format("Every damaged {} input is read or rejected in one line.", format),
              {static_cast<double>(tally.misbehaved)}, Bound{0, "no input may make a reader do anything else"});
  check.holds(format + "-both: The damage is neither always fatal nor always harmless, so that both ways are tried.",
              {static_cast<double>(tally.refused) / static_cast<double>(count)},
              Bound{0.49, "between 1 % and 99 %", 0.5});
}

std::string hdf5_bytes(const std::filesystem::path& path) {
  const std::vector<double> x{0.5, 1.5, 2.5, 3.5};
  io::Hdf5File file(path);
  file.array("/x", x, "x", "m", "position");
  file.array("/h", x, "h", "m", "depth");
  file.group("/run");
  file.array("/run/u", x, "u", "m/s", "velocity");
  file.close();
  return io::read_file(path);
}

/// A record as the program writes it.
std::string record_bytes(const ScratchFolder& scratch) {
  evidence::Record record;
  record.name = "sample";
  record.group = "evidence";
  record.title = "A sample";
  record.parameters["depth"] = {.value = 0.1, .standard = 1.0, .unit = "m", .meaning = "still-water depth"};
  record.check({.id = "a", .text = "a holds", .quantity = "a", .unit = "m", .source = "s"}, {.value = 0.25},
               Bound{1, "r"});
  record.measure("speed", 3.5);
  evidence::write(record, scratch.path());
  return io::read_file(scratch.path() / "sample.json");
}

/// A file as a solver writes it.
struct SolverFile {
  struct {
    std::string id, format, name;  ///< name: where in a folder, where that tells the reader something
  } file;
  std::vector<std::string> texts;
};

const std::vector<SolverFile> solver_files{
    {{"delimited", "delimited", "profile.dat"}, {"# x h u\n0.5 1 0\n1.5\t0.9 0.1\n", "x;h [m]\n0.5;1\n1.5;1e-3\n"}},
    {{"openfoam", "openfoam", "U"},
     {"# Probe 0 (0.1 -0.5 0.5)\n# Probe 1 (1 -0.5 0.5)\n# Probe 0 1\n# Time\n0.5 (1 0 0) (2 0 -1e-3)\n1 (0.5 0 0) (1 "
      "0 0)\n",
      "# Location 0 : (0.5 0 0)\n# hB : Interface height above the boundary\n# Time\thB hL\n0 1 0\n0.5\t0.9 -0.1\n"}},
    {{"openfoam_set", "openfoam", "sets/6/line_h.xy"}, {"0.5 \t0.96\n1.5 \t0.94\n2.5 \t0.93\n"}},
    {{"geoclaw_gauge", "geoclaw", "gauge00001.txt"},
     {"# gauge_id= 1 location=( 0.5 0.0 ) num_var= 4\n# Columns: level, time, h, hu, hv, eta\n 1 0.0 1 0 0 1\n 2 0.5 "
      "0.9 0.1 0 0.9\n"}},
    {{"geoclaw_grid", "geoclaw", "grids/fort.q0001"},
     {"1 grid_number\n1 AMR_level\n3 mx\n0.0 xlow\n1.0 dx\n\n1 0 1\n0.9 0.1 0.9\n0.8 0.2 0.8\n\n2 grid_number\n2 "
      "AMR_level\n2 mx\n1.0 xlow\n0.5 dx\n\n0.9 0.1 0.9\n0.8 0.2 0.8\n\n"}},
    {{"reef3d", "reef3d", "REEF3D-CFD-WSF-HG.dat"},
     {"number of gauges:  2\n\nx_coord     y_coord\n1\t 0.5\t 0.005\n2\t 1.5\t 0.005\n\n\ntime\t P1\t P2\n\n0\t 1\t "
      "1\n0.5\t 0.9\t 1.1\n"}},
    {{"dualsphysics", "dualsphysics", "elevation.csv"},
     {" ;PosX [m]:;0.5;1.5\n ;PosY [m]:;0;0\n ;PosZ [m]:;0;0\nPart;Time [s];Elevation_0 [m];Elevation_1 "
      "[m]\n0;0;1;1\n1;0.5;0.9;1.1\n"}},
    {{"swash", "swash", "gauge.tbl"},
     {"%\n% Run:001 Table:GAUGE SWASH version:7.01\n%\n%  Tsec  Watlev\n%  [sec]  [m]\n%\n 0.0 0.1\n 0.5 -0.1\n"}},
    {{"funwave", "funwave", "sta_0001"}, {"  0.0  0.1  0.0  0.0\n  0.5  -0.1  0.2  0.0\n"}},
    {{"gerris", "gerris", "profile.txt"}, {"# 1:t 2:x 3:y 4:P 5:H\n6 0.5 0 0.94 0.94\n6 1.5 0 0.93 0.93\n"}},
};

/// All that a reader of files makes of damaged ones.
template <class Reader>
Tally fuzz_file(const std::filesystem::path& path, const std::vector<std::string>& valid, long count,
                std::uint64_t seed, Reader read) {
  return fuzz(valid, count, seed, [&](const std::string& input) {
    std::filesystem::remove(path);  // a file that is written anew waits for the disk
    std::ofstream(path, std::ios::binary) << input;
    read(path);
  });
}

/// @param share  of the inputs of the tier full
void damage_files(double share) {
  const auto inputs = [share](double of_full) { return std::lround(share * of_full); };
  Check check("reader_fuzz", "Damaged files",
              "Valid CSV tables, TOML configurations, records, HDF5 files and files of every solver whose form is read "
              "are damaged at random: bytes flipped, replaced, removed, inserted, files cut off or spliced together, "
              "one to six such changes each, the same in every run. Every input must be read, or rejected with a "
              "message of one line; a crash or a hang would end the test. HDF5 is read in a child process, because the "
              "library itself crashes on some of these files: the number of such crashes is measured, and each must "
              "come out as a rejection like any other. `ci/checks/fuzz` does the same with ten times the inputs.");
  const std::vector<std::string> tables{
      "# a result\nx [m],h [m],u [m/s]\n0.5,1,0\n1.5,0.9,0.1\n2.5,1e-3,-2.5e+00\n",
      "t,eta\r\n0,0\r\n1,0.25\r\n2,-0.125\r\n",
      "\"runup [m]\", \"arrival [s]\"\n  3.25 ,\t+17\n",
  };
  claim(check, "csv", fuzz(tables, inputs(40'000), 0x9E3779B97F4A7C15U, [](const std::string& input) {
          std::istringstream in(input);
          io::read_csv(in, "damaged.csv");
        }));

  const validation::Case& one = validation::find_case("riemann");
  const std::vector<std::string> configurations{
      "particles = 50\nscheme = \"M2\"\n[riemann]\nright_depth = 0.5\n",
      "# comment\nleft_depth = 1.0e0\nspacing = 'masses'\ntime = 2\n",
      "[riemann]\nparticles = 1_000\nright_velocity = -0.5 # m/s\n[moving_bore]\nparticles = [1, 2, {a = true}]\n",
  };
  claim(check, "toml", fuzz(configurations, inputs(25'000), 0xD1B54A32D192ED03U, [&](const std::string& input) {
          validation::Values values = one.values(validation::Tier::quick);
          validation::apply_configuration(input, "damaged.toml", one, values);
        }));

  const ScratchFolder scratch("seiche_reader_fuzz");
  claim(check, "record",
        fuzz_file(scratch.path() / "damaged.json", {record_bytes(scratch)}, inputs(8'000), 0xBF58476D1CE4E5B9U,
                  [](const std::filesystem::path& path) { evidence::read_summary(path); }));

  std::filesystem::create_directories(scratch.path() / "sets/6");
  std::filesystem::create_directories(scratch.path() / "grids");
  std::ofstream(scratch.path() / "grids/fort.t0001") << "6.0 time\n";
  for (const auto& [file, texts] : solver_files) {
    long read = 0;
    claim(check, file.id,
          fuzz_file(scratch.path() / file.name, texts, inputs(3'000), 0xA0761D6478BD642FU,
                    [&](const std::filesystem::path& path) {
                      // Recognised by its content, and as what the user says.
                      validation::read_results(path, {.format = ++read % 2 == 0 ? "auto" : file.format});
                    }));
  }

  const auto path = scratch.path() / "damaged.h5";
  claim(check, "hdf5",
        fuzz_file(path, {hdf5_bytes(path)}, inputs(2'000), 0x94D049BB133111EBU,
                  [](const std::filesystem::path& damaged) { io::read_hdf5(damaged, {}, 1); }));
}

TEST_CASE("readers survive damaged files: they read or reject in one line", "[robustness]") {
  damage_files(0.2);
}

TEST_CASE("readers survive more damaged files", "[robustness][full]") {
  damage_files(1);
}

TEST_CASE("a crash or infinite loop of a child process is a rejection in the parent", "[robustness]") {
  Check check("isolated_readers", "Crashes stay in the child process",
              "The HDF5 library crashes on some damaged files and does not terminate on others. It reads in a child "
              "process, and any end of that process must become an ordinary exception.");
  const auto outcome = [](const std::function<std::string()>& action) -> std::string {
    try {
      return io::isolated(action, 1);
    } catch (const std::invalid_argument& refusal) {
      return std::string("invalid_argument: ") + refusal.what();
    } catch (const std::runtime_error& broken) {
      return std::string("runtime_error: ") + broken.what();
    }
  };
  const auto ends_in = [&](const std::string& id, const std::string& text, const std::string& expected,
                           const std::function<std::string()>& action) {
    const std::string got = outcome(action);
    INFO(id << ": " << got.substr(0, 200));
    check.holds(id + ": " + text, {got.starts_with(expected) ? 1.0 : 0.0},
                Qualitative{"result beginning with \"" + expected.substr(0, 60) + "\"", "stated in the interface"});
  };
  const std::string large(5'000'000, 'x');
  ends_in("text", "The child's text is returned whole.", large, [&] { return large; });
  ends_in("exception", "An exception in the child is thrown again by the parent.", "invalid_argument: no",
          []() -> std::string { throw std::runtime_error("no"); });
  ends_in("crash", "A crash of the child becomes an exception of the parent.",
          "runtime_error: the child process crashed by signal 11", []() -> std::string {
            std::raise(SIGSEGV);
            return {};
          });
  ends_in("endless", "An infinite loop in the child becomes an exception of the parent.",
          "runtime_error: the child process did not end within 1 s", []() -> std::string {
            for (volatile bool forever = true; forever;) {
            }
            return {};
          });
}

}  // namespace seiche::verification::reader_fuzz_test
