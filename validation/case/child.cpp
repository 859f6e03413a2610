#include "validation/case/child.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "seiche/io/atomic_file.hpp"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace seiche::validation {
namespace {

/// What a child says: "p" with its progress, "m" with its closing message, one line each.
void say(int pipe, char kind, const std::string& text) {
  std::string line = kind + text;
  for (char& c : line) c = c == '\n' ? ' ' : c;
  line += '\n';
  // A parent that is gone cannot be told anything; the child dies of that elsewhere.
  if (write(pipe, line.data(), line.size()) < 0) return;
}

[[noreturn]] void live(const Job& job, const std::filesystem::path& directory, const Keeping& keeping, int pipe) {
  double said = -1;
  const auto progress = [&](double fraction) {
    if (fraction - said < 0.005) return;
    said = fraction;
    say(pipe, 'p', fmt::format("{:.4f}", fraction));
  };
  const Ending ending = run_job(job, directory, keeping, progress);
  say(pipe, 'm', ending.message);
#ifdef __SANITIZE_ADDRESS__
  __lsan_do_leak_check();  // a process looks for its leaks at its exit, which leave() is not
#endif
  io::leave(exit_status(ending.outcome));
}

}  // namespace

Child::Child(const Job& job, const std::filesystem::path& directory, const Keeping& keeping, std::chrono::seconds limit)
    : job_(job), directory_(directory), limit_(limit), begin_(std::chrono::steady_clock::now()) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe for a child process");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) {
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error(fmt::format("cannot start a child process: {}", std::strerror(errno)));
  }
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(3);  // the parent died before the request above
    std::signal(SIGINT, SIG_IGN);       // the parent decides what an interrupt means
    close(ends[0]);
    live(job, directory, keeping, ends[1]);
  }
  close(ends[1]);
  pipe_ = ends[0];
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  if (process_ > 0) stop();
  if (pipe_ >= 0) close(pipe_);
}

void Child::stop() {
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  io::remove_partial_files(directory_, process_);
  process_ = -1;
}

double Child::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Child::listen() {
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = read(pipe_, buffer.data(), buffer.size())) > 0;) {
    unread_.append(buffer.data(), static_cast<std::size_t>(n));
  }
  for (std::size_t end = 0; (end = unread_.find('\n')) != std::string::npos;) {
    if (unread_[0] == 'p') progress_ = std::strtod(unread_.c_str() + 1, nullptr);
    if (unread_[0] == 'm') message_ = unread_.substr(1, end - 1);
    unread_.erase(0, end + 1);
  }
}

Ending Child::died(const std::string& reason) {
  try {
    write_error_record(job_, directory_, reason, seconds());
  } catch (const std::exception& failure) {
    return {Outcome::unfinished, fmt::format("{}; its record could not be written: {}", reason, failure.what())};
  }
  return {Outcome::unfinished, reason};
}

std::optional<Ending> Child::poll() {
  listen();
  int status = 0;
  const pid_t ended = waitpid(process_, &status, WNOHANG);
  if (ended == 0) {
    if (seconds() < static_cast<double>(limit_.count())) return std::nullopt;
    stop();
    return died(fmt::format("stopped at its time limit of {} s, {:.0f} % done", limit_.count(), 100 * progress_));
  }
  io::remove_partial_files(directory_, process_);
  process_ = -1;
  listen();
  if (WIFSIGNALED(status)) {
    return died(fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))));
  }
  const int exit = WEXITSTATUS(status);
  if (exit > exit_status(Outcome::unfinished)) return died(fmt::format("ended with exit status {}", exit));
  return Ending{static_cast<Outcome>(exit), message_};
}

}  // namespace seiche::validation
