#include "validation/case/runner.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "reports/evidence/record_lock.hpp"
#include "validation/case/child.hpp"
#include "validation/case/display.hpp"

namespace seiche::validation {
namespace {

/// Set by the signal handler, the one thing that such a handler may do.
volatile std::sig_atomic_t interrupted = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void on_interrupt(int /*signal*/) {
  interrupted = 1;
}

int severity(Outcome outcome) {
  switch (outcome) {
    case Outcome::as_declared:
      return 0;
    case Outcome::failed:
      return 1;
    case Outcome::unfinished:
      return 2;
    case Outcome::wrong_input:
      return 3;
  }
  return 3;
}

Outcome worse(Outcome a, Outcome b) {
  return severity(a) >= severity(b) ? a : b;
}

}  // namespace

Outcome run_all(const std::vector<Job>& jobs, const RunOptions& options) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);

  namespace fs = std::filesystem;
  const bool made = !fs::exists(options.directory);
  std::vector<evidence::RecordLock> locks;
  for (const Job& job : jobs) locks.emplace_back(options.directory, job.stem());

  Display display(jobs.size());
  Outcome worst = Outcome::as_declared;
  bool written = !made;
  std::vector<std::unique_ptr<Child>> children;
  auto next = jobs.begin();
  while ((next != jobs.end() || !children.empty()) && interrupted == 0) {
    while (next != jobs.end() && children.size() < options.jobs) {
      const Job& job = *next++;
      if (options.resume && is_done(job, options.directory)) {
        const auto file = options.directory / (job.stem() + ".json");
        evidence::refresh_article(file, job.definition->article);
        const auto old = evidence::read_summary(file);
        worst = worse(worst, old.as_declared() ? Outcome::as_declared : Outcome::failed);
        written = true;
        display.skipped(job.stem());
      } else {
        children.push_back(
            std::make_unique<Child>(job, options.directory, Keeping{options.resume, options.checkpoint_every},
                                    options.most_seconds.value_or(job.definition->time_limit.at(job.values.tier()))));
      }
    }
    for (auto child = children.begin(); child != children.end();) {
      const std::optional<Ending> ending = (*child)->poll();
      if (!ending) {
        ++child;
        continue;
      }
      written = written || ending->outcome != Outcome::wrong_input;
      display.finished((*child)->job().stem(), *ending, (*child)->seconds());
      worst = worse(worst, ending->outcome);
      child = children.erase(child);
    }
    display.running(children);
    // Short enough that a case of milliseconds is not waited for, long enough to cost nothing.
    if (!children.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  children.clear();  // kills what an interrupt left running
  if (interrupted != 0) {
    fmt::print(stderr, "interrupted: run again with --resume to do the rest\n");
    return Outcome::unfinished;
  }
  if (written) evidence::write_junit(options.directory);
  locks.clear();
  std::error_code not_empty;
  if (made) fs::remove(options.directory, not_empty);
  return worst;
}

}  // namespace seiche::validation
