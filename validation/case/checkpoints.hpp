/// What a long computation keeps in a folder while it runs, so that an interrupted one can be resumed with the same
/// numbers to the last bit. A case that may run for more than ten minutes has parts:
///
///     r.waves[k] = run.part("spacing 0.1").result<Wave>([&] { return make_waves(0.1); });
///
/// A part that takes long itself says now and then where it is:
///
///     Part part = run.part("spacing 0.1");
///     const auto state = [&](Tape& tape) { tape(n, wave); exchange(tape, flow); };
///     for (part.resume(state); n < steps; ++n) {
///       part.keep(state);
///       ...
///     }
///
/// What a part computes depends on its name and the parameters of the run alone. See Tape for how results become bytes.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "validation/case/tape.hpp"

namespace seiche::validation {

/// How checkpoints are dealt with.
struct Keeping {
  bool resume = false;  ///< use what an interrupted run has left; otherwise it is removed
  std::chrono::seconds every = std::chrono::minutes(2);  ///< how often a part keeps its state
};

/// The folder of one run. A file appears in it when it is whole, under the digest of its bytes and the fingerprint of
/// all that decides the numbers; one that is damaged or another program's is not used, which a note says. That a file
/// cannot be written is a note too: the computation goes on without.
class Checkpoints {
 public:
  /// Keeps nothing.
  Checkpoints() = default;
  Checkpoints(std::filesystem::path folder, std::string fingerprint, const Keeping& keeping);

  [[nodiscard]] std::optional<std::string> read(const std::string& name) const;
  void write(const std::string& name, std::string_view bytes) const;
  void remove(const std::string& name) const;
  /// Removes all: the run has its record.
  void remove_all() const;

  /// Whether anything is kept.
  [[nodiscard]] bool active() const { return !folder_.empty(); }
  [[nodiscard]] std::chrono::seconds every() const { return every_; }
  /// What the run has taken so far [s], with what an interrupted one had taken for what was read of it.
  [[nodiscard]] double seconds() const;
  /// What the user should know, once for each kind.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  [[nodiscard]] std::filesystem::path file(const std::string& name) const;
  void note(const std::string& text) const;

  std::filesystem::path folder_;
  std::string fingerprint_;
  std::chrono::seconds every_{};
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  mutable std::vector<std::string> notes_;
  mutable double before_ = 0;  ///< seconds of an interrupted run
};

/// A part of a run that is computed by itself; parts of one run may be computed by several threads.
class Part {
 public:
  Part(const Checkpoints& checkpoints, std::string name);

  /// What compute() returns, now or when an interrupted run had finished the part.
  template <class Result, class Compute>
  Result result(const Compute& compute) const {
    Result result{};
    if (read(name_, [&](Tape& tape) { tape(result); })) return result;
    result = compute();
    write(name_, [&](Tape& tape) { tape(result); });
    checkpoints_->remove(name_ + unfinished);
    return result;
  }

  /// Reads the state that an interrupted run has left in the midst of the part; false if there is none.
  bool resume(const std::function<void(Tape&)>& state) const;
  /// Keeps the state if the last time is long enough ago.
  void keep(const std::function<void(Tape&)>& state);

 private:
  static constexpr const char* unfinished = ", unfinished";

  bool read(const std::string& name, const std::function<void(Tape&)>& state) const;
  void write(const std::string& name, const std::function<void(Tape&)>& state) const;

  const Checkpoints* checkpoints_;
  std::string name_;
  std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
};

}  // namespace seiche::validation
