#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "validation/case/data_folder.hpp"
#include "validation/command/commands.hpp"

namespace seiche::command {
namespace {

struct Options {
  std::string evidence = "evidence";
  std::string out;
  std::string pdf;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

/// The interpreter that the build was configured with, unless the user names another.
std::string python() {
  const char* chosen = std::getenv("SEICHE_PYTHON");  // NOLINT(concurrency-mt-unsafe): no threads here
  return chosen != nullptr && *chosen != '\0' ? chosen : SEICHE_PYTHON;
}

int report(const Options& options) {
  if (!std::filesystem::is_directory(options.evidence)) {
    throw std::invalid_argument(
        fmt::format("report: folder {} does not exist: 'seiche run --tier quick --out {}' makes it", options.evidence,
                    options.evidence));
  }
  const std::string out =
      options.out.empty() ? (std::filesystem::path(options.evidence) / "report").string() : options.out;
  std::vector<std::string> words{python(), validation::data_folder("render").string(), options.evidence, "--out", out,
                                 "--jobs", std::to_string(options.jobs)};
  if (!options.pdf.empty()) words.insert(words.end(), {"--pdf", options.pdf});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  throw std::runtime_error(fmt::format("cannot start the Python interpreter {}: {}; SEICHE_PYTHON names another",
                                       words.front(), std::strerror(errno)));
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Make the HTML report from records");
  command->add_option("DIR", options->evidence, "folder with the records")->capture_default_str();
  command->add_option("--out", options->out, "folder for the report; DIR/report if not given");
  command->add_option("--pdf", options->pdf, "also print the report to this PDF file (needs Chromium)");
  command->add_option("--jobs,-j", options->jobs, "how many figures are drawn at once")->check(CLI::Range(1U, 1024U));
  command->footer(
      "The environment's SEICHE_PYTHON names the Python interpreter, which needs numpy, h5py, matplotlib, jinja2 and\n"
      "markdown.");
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace seiche::command
