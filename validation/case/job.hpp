#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "validation/case/case.hpp"

namespace seiche::validation {

/// How a job ended, in the order of the command's exit statuses 0 to 3.
enum class Outcome {
  as_declared,  ///< finished, every claim has its declared verdict
  failed,       ///< finished, some claim has not
  wrong_input,  ///< refused before it computed; nothing written, an earlier record set aside
  unfinished,   ///< broke down, crashed, ran out of time or disk; the record says why
};

constexpr int exit_status(Outcome outcome) {
  return static_cast<int>(outcome);
}

/// One case with the values it shall run with.
struct Job {
  const Case* definition = nullptr;
  Values values;

  /// Of everything that decides the numbers but the reference tables: equal means that it need not run again.
  [[nodiscard]] std::string fingerprint() const;
  /// Names the files of the record: blank_record().stem().
  [[nodiscard]] std::string stem() const;
  /// A record with everything that is known before the case runs.
  [[nodiscard]] evidence::Record blank_record() const;
};

struct Ending {
  Outcome outcome = Outcome::unfinished;
  std::string message;
};

/// Runs a job in this process and writes its record. Checkpoints lie beside the records until it is written.
Ending run_job(const Job& job, const std::filesystem::path& directory, const Keeping& keeping,
               const Run::Progress& progress);

/// Writes the record of a job that could not write its own. Its claims are declared in a process of their own, with a
/// limit of time: that may be where the job died.
void write_error_record(const Job& job, const std::filesystem::path& directory, const std::string& reason,
                        double wall_time);

/// Whether the directory holds a finished record of exactly this job, with the reference tables it read and all of its
/// own files unchanged.
bool is_done(const Job& job, const std::filesystem::path& directory);

}  // namespace seiche::validation
