#include "validation/command/streams.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "seiche/wording.hpp"

namespace seiche::command {

void prepare_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest free number is the stream's own. Standard output is opened for reading: it was closed, and what is
    // written to it shall be missed.
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) {
      const int nowhere = open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
      if (nowhere < 0) return;
    }
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

void complain(std::string_view sentence) {
  std::string text = "seiche: ";
  while (!sentence.empty()) {
    const std::size_t end = sentence.find('\n');
    text += printable(sentence.substr(0, end)) + "\n";
    sentence.remove_prefix(end == std::string_view::npos ? sentence.size() : end + 1);
  }
  std::fputs(text.c_str(), stderr);
}

}  // namespace seiche::command
