#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "validation/case/job.hpp"

namespace seiche::validation {

struct RunOptions {
  std::filesystem::path directory = "evidence";
  unsigned jobs = 1;
  int threads = 0;      ///< of each case; 0: one, and for a case that runs alone all that OpenMP would take
  bool resume = false;  ///< keep what is done already, go on from checkpoints
  std::chrono::seconds checkpoint_every = Keeping{}.every;
  std::optional<std::chrono::seconds> most_seconds = {};  ///< of one case; without: the case's own limit in its tier
};

/// Runs the jobs, at most options.jobs at once, shows the progress, and writes junit.xml over all records of the
/// directory. Returns the worst outcome: wrong input before unfinished before failed. An interrupt (SIGINT, SIGTERM)
/// stops all children and leaves no half-written file.
/// @throws std::runtime_error before anything runs, if another process writes one of the records
Outcome run_all(const std::vector<Job>& jobs, const RunOptions& options);

}  // namespace seiche::validation
