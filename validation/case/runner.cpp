#include "validation/case/runner.hpp"

#include <omp.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "reports/evidence/record_lock.hpp"
#include "validation/case/child.hpp"

namespace seiche::validation {
namespace {

std::string bar(double fraction, int width) {
  const int full = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * width));
  std::string text;
  for (int k = 0; k < width; ++k) text += k < full ? "█" : "·";
  return text;
}

/// Shows a run: on a terminal a bar per running case, redrawn in place; elsewhere a line per finished case.
class Display {
 public:
  explicit Display(std::size_t total) : total_(total), terminal_(isatty(STDOUT_FILENO) != 0) {}

  void skipped(const std::string& name) { line("=", name, "unchanged, kept"); }
  void finished(const std::string& name, const Ending& ending, double seconds) {
    constexpr std::array marks{"✓", "✗", "?", "!"};  // by exit status
    line(marks.at(static_cast<std::size_t>(exit_status(ending.outcome))), name,
         fmt::format("{:7.2f} s  {}", seconds, ending.message));
  }
  void running(const std::vector<std::unique_ptr<Child>>& children) {
    if (!terminal_) return;
    erase_bars();
    for (const auto& child : children) {
      fmt::print("          {:<34} {} {:5.1f} s\n", child->job().stem(), bar(child->progress(), 30), child->seconds());
    }
    bars_ = children.size();
    std::fflush(stdout);
  }

 private:
  void erase_bars() {
    for (; bars_ > 0; --bars_) fmt::print("\033[1A\033[2K");
  }
  void line(const char* sign, const std::string& name, const std::string& rest) {
    erase_bars();
    fmt::print("[{:>3}/{}] {} {:<34} {}\n", ++done_, total_, sign, name, rest);
    std::fflush(stdout);
  }

  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t bars_ = 0;  ///< lines of bars now on the terminal
  bool terminal_;
};

/// Set by the signal handler, the one thing that such a handler may do.
volatile std::sig_atomic_t interrupted = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void on_interrupt(int /*signal*/) {
  interrupted = 1;
}

/// Wrong input is worst, then what did not finish.
Outcome worse(Outcome a, Outcome b) {
  constexpr std::array severity{0, 1, 3, 2};  // by exit status
  const auto of = [&](Outcome outcome) { return severity.at(static_cast<std::size_t>(exit_status(outcome))); };
  return of(a) >= of(b) ? a : b;
}

}  // namespace

Outcome run_all(const std::vector<Job>& jobs, const RunOptions& options) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);

  // The children inherit it. Cases side by side keep to a core each.
  if (options.threads > 0) {
    omp_set_num_threads(options.threads);
  } else if (jobs.size() > 1) {
    omp_set_num_threads(1);
  }
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
    std::erase_if(children, [&](const std::unique_ptr<Child>& child) {
      const std::optional<Ending> ending = child->poll();
      if (!ending) return false;
      written = written || ending->outcome != Outcome::wrong_input;
      display.finished(child->job().stem(), *ending, child->seconds());
      worst = worse(worst, ending->outcome);
      return true;
    });
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
