#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "validation/case/job.hpp"

namespace seiche::validation {

/// A job in a process of its own: whatever happens to it happens to nobody else.
class Child {
 public:
  /// Starts the job. The child dies with its parent. @param limit  wall time after which it is stopped
  Child(const Job& job, const std::filesystem::path& directory, const Keeping& keeping, std::chrono::seconds limit);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  Child(Child&&) = delete;
  Child& operator=(Child&&) = delete;
  /// Kills the process if it still runs.
  ~Child();

  /// Reads what the child has said and looks whether it ended; a child over its time limit is killed. Once it has
  /// ended, returns how; a job that died gets an error record.
  std::optional<Ending> poll();

  [[nodiscard]] double progress() const { return progress_; }
  [[nodiscard]] double seconds() const;
  [[nodiscard]] const Job& job() const { return job_; }

 private:
  void listen();
  void stop();
  [[nodiscard]] Ending died(const std::string& reason);

  const Job& job_;
  std::filesystem::path directory_;
  std::chrono::seconds limit_;
  std::chrono::steady_clock::time_point begin_;
  int process_ = -1;
  int pipe_ = -1;
  std::string unread_;
  double progress_ = 0;
  std::string message_;
};

}  // namespace seiche::validation
