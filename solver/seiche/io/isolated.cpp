#include "seiche/io/isolated.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "seiche/io/atomic_file.hpp"
#include "seiche/require_that.hpp"

namespace seiche::io {
namespace {

constexpr char returned = 'r';
constexpr char threw = 't';

void limit(__rlimit_resource resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

void send(int pipe, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = write(pipe, text.data() + sent, text.size() - sent);
    if (count < 0 && errno != EINTR) leave(1);
    if (count > 0) sent += static_cast<std::size_t>(count);
  }
}

std::string receive(int pipe) {
  std::string text;
  std::array<char, 1 << 16> buffer{};
  for (ssize_t count = 0; (count = read(pipe, buffer.data(), buffer.size())) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

[[noreturn]] void live(const std::function<std::string()>& action, unsigned seconds, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose shadow memory is larger than any limit
  limit(RLIMIT_AS, rlim_t{4} << 30);
#endif
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(crash, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  std::string answer;
  try {
    answer = returned + action();
  } catch (const std::exception& failure) {
    answer = threw + std::string(failure.what());
  }
  send(pipe, answer);
  leave(0);
}

}  // namespace

std::string isolated(const std::function<std::string()>& action, unsigned seconds) {
  std::array<int, 2> ends{};
  require_that<std::runtime_error>(pipe2(ends.data(), O_CLOEXEC) == 0, "cannot make a pipe for a child process");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    live(action, seconds, ends[1]);
  }
  const int fork_error = errno;
  close(ends[1]);
  const std::string answer = child > 0 ? receive(ends[0]) : "";
  close(ends[0]);
  require_that<std::runtime_error>(child >= 0, "cannot start a child process: {}", std::strerror(fork_error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool too_long = signal == SIGXCPU || signal == SIGKILL;
    throw std::runtime_error(too_long ? fmt::format("the child process did not end within {} s", seconds)
                                      : fmt::format("the child process crashed by signal {}", signal));
  }
  require_that<std::runtime_error>(status == 0 && !answer.empty(), "the child process crashed without an answer");
  if (answer.front() == threw) throw std::invalid_argument(answer.substr(1));
  return answer.substr(1);
}

}  // namespace seiche::io
