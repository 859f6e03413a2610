#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "validation/case/child.hpp"

namespace seiche::validation {

/// Shows a run: on a terminal a bar per running case, redrawn in place; elsewhere a line per finished case.
class Display {
 public:
  explicit Display(std::size_t total);

  void skipped(const std::string& name);
  void finished(const std::string& name, const Ending& ending, double seconds);
  void running(const std::vector<std::unique_ptr<Child>>& children);

 private:
  void erase_bars();
  void line(const char* mark, const std::string& name, const std::string& rest);

  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t bars_ = 0;  ///< lines of bars now on the terminal
  bool terminal_;
};

}  // namespace seiche::validation
