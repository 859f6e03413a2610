#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "validation/case/data_folder.hpp"
#include "validation/case/refusal.hpp"
#include "validation/case/registry.hpp"
#include "validation/command/commands.hpp"

namespace seiche::command {
namespace {

/// The interpreter that the build was configured with, unless the user names another.
std::string python() {
  const char* chosen = std::getenv("SEICHE_PYTHON");  // NOLINT(concurrency-mt-unsafe): no threads here
  return chosen != nullptr && *chosen != '\0' ? chosen : SEICHE_PYTHON;
}

/// "phenomenon/case,..." of all cases that score others.
std::string scorable() {
  std::vector<std::string> names;
  for (const validation::Case& one : validation::all_cases()) {
    if (one.submission) names.push_back(one.phenomenon + "/" + one.name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

}  // namespace

int report(const ReportOptions& options) {
  const std::filesystem::path folder = options.evidence;
  const auto is_record = [](const auto& entry) { return entry.path().extension() == ".json"; };
  if (!std::filesystem::is_directory(folder) ||
      std::none_of(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator(), is_record)) {
    validation::fail("report: {}: must be a folder with records, as 'seiche run' and 'seiche score' write them",
                     options.evidence);
  }
  const std::string out = options.out.empty() ? (folder / "report").string() : options.out;
  std::vector<std::string> words{python(), validation::data_folder("render").string(), options.evidence};
  words.insert(words.end(), {"--out", out, "--jobs", std::to_string(options.jobs), "--scorable", scorable()});
  if (options.with_data) words.emplace_back("--with-data");
  if (!options.pdf.empty()) words.insert(words.end(), {"--pdf", options.pdf});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  throw std::runtime_error(fmt::format("cannot start the Python interpreter {}: {}; SEICHE_PYTHON names another",
                                       words.front(), std::strerror(errno)));
}

}  // namespace seiche::command
