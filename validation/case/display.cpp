#include "validation/case/display.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

namespace seiche::validation {
namespace {

std::string bar(double fraction, int width) {
  const int full = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * width));
  std::string text;
  for (int k = 0; k < width; ++k) text += k < full ? "█" : "·";
  return text;
}

const char* mark(Outcome outcome) {
  switch (outcome) {
    case Outcome::as_declared:
      return "✓";
    case Outcome::failed:
      return "✗";
    case Outcome::wrong_input:
      return "?";
    case Outcome::unfinished:
      return "!";
  }
  return "!";
}

}  // namespace

Display::Display(std::size_t total) : total_(total), terminal_(isatty(STDOUT_FILENO) != 0) {}

void Display::erase_bars() {
  for (; bars_ > 0; --bars_) fmt::print("\033[1A\033[2K");
}

void Display::line(const char* sign, const std::string& name, const std::string& rest) {
  erase_bars();
  fmt::print("[{:>3}/{}] {} {:<34} {}\n", ++done_, total_, sign, name, rest);
  std::fflush(stdout);
}

void Display::skipped(const std::string& name) {
  line("=", name, "unchanged, kept");
}

void Display::finished(const std::string& name, const Ending& ending, double seconds) {
  line(mark(ending.outcome), name, fmt::format("{:7.2f} s  {}", seconds, ending.message));
}

void Display::running(const std::vector<std::unique_ptr<Child>>& children) {
  if (!terminal_) return;
  erase_bars();
  for (const auto& child : children) {
    fmt::print("          {:<34} {} {:5.1f} s\n", child->job().stem(), bar(child->progress(), 30), child->seconds());
  }
  bars_ = children.size();
  std::fflush(stdout);
}

}  // namespace seiche::validation
