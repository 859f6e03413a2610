// Damaged files: readers must succeed or refuse in one line, whatever the bytes.
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "seiche/io/atomic_file.hpp"
#include "seiche/io/csv_table.hpp"
#include "seiche/io/hdf5_file.hpp"
#include "seiche/io/hdf5_table.hpp"
#include "seiche/io/isolated.hpp"
#include "seiche/samples.hpp"
#include "validation/case/configuration.hpp"
#include "validation/case/registry.hpp"
#include "verification/check.hpp"

namespace {

using namespace seiche;
using evidence::Bound;
using evidence::Qualitative;
using verification::Check;

/// Marsaglia's xorshift64: the same inputs in every run.
class Xorshift {
 public:
  explicit Xorshift(std::uint64_t seed) : state_(seed) {}
  /// Uniform in [0, bound).
  std::size_t below(std::size_t bound) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::size_t>(state_ % bound);
  }

 private:
  std::uint64_t state_;
};

/// Tokens that readers stumble over more often than over random bytes.
const std::vector<std::string> awkward{"nan",
                                       "inf",
                                       "-",
                                       "1e999",
                                       "[",
                                       "]",
                                       "\"",
                                       "'''",
                                       ",,",
                                       "\r",
                                       "\n",
                                       "#",
                                       "=",
                                       "{",
                                       "}",
                                       "0x",
                                       "1e",
                                       "+",
                                       ".",
                                       "\\u",
                                       "\t",
                                       "\xff",
                                       "\xEF\xBB\xBF",
                                       std::string(1, '\0'),
                                       "99999999999999999999",
                                       "[[a]]",
                                       "a.b.c"};

/// One to six changes: bytes flipped, replaced, removed, put in, cut off, or a piece of another input spliced in.
std::string mutated(std::string bytes, const std::vector<std::string>& others, Xorshift& random) {
  for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) {
    if (bytes.empty()) bytes = others[random.below(others.size())];
    const std::size_t place = random.below(bytes.size());
    const std::size_t length = std::min(bytes.size() - place, 1 + random.below(16));
    switch (random.below(8)) {
      case 0:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.below(8)));
        break;
      case 1:
        bytes[place] = static_cast<char>(random.below(256));
        break;
      case 2:
        bytes.erase(place, length);
        break;
      case 3:
        bytes.insert(place, 1 + random.below(8), static_cast<char>(random.below(256)));
        break;
      case 4:
        bytes.insert(place, awkward[random.below(awkward.size())]);
        break;
      case 5:
        bytes.insert(place, bytes.substr(random.below(bytes.size()), length * 4));
        break;
      case 6: {
        const std::string& other = others[random.below(others.size())];
        bytes = bytes.substr(0, place) + other.substr(random.below(other.size()));
        break;
      }
      default:
        if (random.below(4) == 0) bytes.resize(place);
    }
  }
  return bytes;
}

/// What became of the inputs of one reader.
struct Tally {
  long accepted = 0;
  long refused = 0;
  long misbehaved = 0;  ///< another exception, a message of several lines, or an empty one
  long crashes = 0;     ///< of a child process
  Largest slowest;      ///< [s]
  std::string example;
};

template <class Reader>
Tally fuzz(const std::vector<std::string>& valid, long count, std::uint64_t seed, Reader read) {
  Xorshift random(seed);
  Tally tally;
  for (long k = 0; k < count; ++k) {
    const std::string input = mutated(valid[random.below(valid.size())], valid, random);
    const auto begin = std::chrono::steady_clock::now();
    std::string message = "ok";
    bool expected = true;
    try {
      read(input);
      ++tally.accepted;
    } catch (const std::invalid_argument& refusal) {
      message = refusal.what();
      ++tally.refused;
    } catch (const std::runtime_error& refusal) {
      message = refusal.what();
      ++tally.refused;
    } catch (const std::exception& other) {
      message = other.what();
      expected = false;
    }
    const bool one_line = !message.empty() && std::none_of(message.begin(), message.end(),
                                                           [](char c) { return (c >= 0 && c < ' ') || c == 0x7f; });
    if (!expected || !one_line) {
      ++tally.misbehaved;
      tally.example = message;
    }
    if (message.find("child process") != std::string::npos) ++tally.crashes;
    tally.slowest.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return tally;
}

void claim(Check& check, const std::string& format, const Tally& tally) {
  const long count = tally.accepted + tally.refused + tally.misbehaved;
  INFO(format << ": " << tally.example);
  check.measure(format + "_inputs", static_cast<double>(count));
  check.measure(format + "_accepted", static_cast<double>(tally.accepted));
  check.measure(format + "_slowest_s", tally.slowest.value());
  check.that({.id = format,
              .text = fmt::format("Every damaged {} input is read or refused in one line.", format),
              .quantity = "inputs that end otherwise",
              .source = "interface of the reader"},
             {.value = static_cast<double>(tally.misbehaved), .resolution = fmt::format("{} inputs", count)},
             Bound{.limit = 0, .reason = "no input may make a reader do anything else"});
  check.that({.id = format + "-both",
              .text = "The damage is neither always fatal nor always harmless, so that both ways are tried.",
              .quantity = "share refused",
              .source = "this test"},
             {.value = static_cast<double>(tally.refused) / static_cast<double>(count),
              .resolution = fmt::format("{} inputs", count)},
             Bound{.limit = 0.49, .reason = "between 1 % and 99 %", .expected = 0.5});
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

}  // namespace

TEST_CASE("readers survive damaged files: they read or refuse in one line", "[robustness]") {
  Check check("reader_fuzz", "Damaged files",
              "Valid CSV tables, TOML configurations and HDF5 files are damaged at random: bytes flipped, replaced, "
              "removed, inserted, files cut off or spliced together, one to six such changes each, the same in every "
              "run. Every input must be read, or refused with a message of one line; a crash or a hang would end the "
              "test. HDF5 is read in a child process, because the library itself crashes on some of these files: the "
              "number of such crashes is measured, and each must come out as a refusal like any other.");
  const std::vector<std::string> tables{
      "# a result\nx [m],h [m],u [m/s]\n0.5,1,0\n1.5,0.9,0.1\n2.5,1e-3,-2.5e+00\n",
      "t,eta\r\n0,0\r\n1,0.25\r\n2,-0.125\r\n",
      "\"runup [m]\", \"arrival [s]\"\n  3.25 ,\t+17\n",
  };
  const Tally csv = fuzz(tables, 70'000, 0x9E3779B97F4A7C15U, [](const std::string& input) {
    std::istringstream in(input);
    io::read_csv(in, "damaged.csv");
  });
  claim(check, "csv", csv);

  const validation::Case& one = validation::find_case("riemann");
  const std::vector<std::string> configurations{
      "particles = 50\nscheme = \"M2\"\n[riemann]\nright_depth = 0.5\n",
      "# comment\nleft_depth = 1.0e0\nspacing = 'masses'\ntime = 2\n",
      "[riemann]\nparticles = 1_000\nright_velocity = -0.5 # m/s\n[moving_bore]\nparticles = [1, 2, {a = true}]\n",
  };
  const Tally toml = fuzz(configurations, 32'000, 0xD1B54A32D192ED03U, [&](const std::string& input) {
    validation::Values values = one.values(validation::Tier::quick);
    validation::apply_configuration(input, "damaged.toml", one, values);
  });
  claim(check, "toml", toml);

  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("seiche-reader-fuzz-{}.h5", getpid());
  const std::vector<std::string> files{hdf5_bytes(path)};
  const Tally hdf5 = fuzz(files, 2'000, 0x94D049BB133111EBU, [&](const std::string& input) {
    std::ofstream(path, std::ios::binary) << input;
    io::read_hdf5(path, {}, 1);
  });
  std::filesystem::remove(path);
  check.measure("hdf5_library_crashes", static_cast<double>(hdf5.crashes));
  claim(check, "hdf5", hdf5);
}

TEST_CASE("what crashes or spins in a child process is a refusal in the parent", "[robustness]") {
  Check check(
      "isolated_readers", "Crashes stay in the child process",
      "The HDF5 library crashes on some damaged files and never ends on others. It reads in a child process, and "
      "whatever becomes of that process must come out as an ordinary exception.");
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
    check.that({.id = id, .text = text, .quantity = "comes out as stated", .source = "interface of io::isolated"},
               {.value = got.find(expected) == 0 ? 1.0 : 0.0},
               Qualitative{"result beginning with \"" + expected.substr(0, 60) + "\"", "stated in the interface"});
  };
  const std::string large(5'000'000, 'x');
  ends_in("text", "The child's text is returned whole.", large, [&] { return large; });
  ends_in("exception", "Its exception is thrown again.", "invalid_argument: no",
          []() -> std::string { throw std::runtime_error("no"); });
  ends_in("crash", "Its crash is an exception.", "runtime_error: the child process crashed by signal 11",
          []() -> std::string {
            std::raise(SIGSEGV);
            return {};
          });
  ends_in("endless", "Its endless loop is an exception.", "runtime_error: the child process did not end within 1 s",
          []() -> std::string {
            for (volatile bool forever = true; forever;) {
            }
            return {};
          });
}
