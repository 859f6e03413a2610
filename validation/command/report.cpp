#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "validation/command/commands.hpp"

namespace seiche::command {
namespace {

struct Options {
  std::string evidence = "evidence";
  std::string out;
  std::string pdf;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

/// The renderer of the checkout this program was built from, or the installed one.
std::string renderer() {
  for (const char* place : {SEICHE_RENDERER, SEICHE_INSTALLED_RENDERER}) {
    if (std::filesystem::exists(std::filesystem::path(place) / "__main__.py")) return place;
  }
  throw std::runtime_error(
      fmt::format("the report's renderer is neither at {} nor at {}", SEICHE_RENDERER, SEICHE_INSTALLED_RENDERER));
}

int report(const Options& options) {
  if (!std::filesystem::is_directory(options.evidence)) {
    throw std::invalid_argument(
        fmt::format("report: folder {} does not exist: 'seiche run --tier quick --out {}' makes it", options.evidence,
                    options.evidence));
  }
  const std::string out =
      options.out.empty() ? (std::filesystem::path(options.evidence) / "report").string() : options.out;
  std::vector<std::string> words{
      SEICHE_PYTHON, renderer(), options.evidence, "--out", out, "--jobs", std::to_string(options.jobs)};
  if (!options.pdf.empty()) words.insert(words.end(), {"--pdf", options.pdf});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(SEICHE_PYTHON, arguments.data());
  throw std::runtime_error(fmt::format("cannot start {}: {}", SEICHE_PYTHON, std::strerror(errno)));
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Make the HTML report from records");
  command->add_option("DIR", options->evidence, "folder with the records")->capture_default_str();
  command->add_option("--out", options->out, "folder for the report; DIR/report if not given");
  command->add_option("--pdf", options->pdf, "also print the report to this PDF file (needs Chromium)");
  command->add_option("--jobs,-j", options->jobs, "how many figures are drawn at once")->check(CLI::Range(1U, 1024U));
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

}  // namespace seiche::command
