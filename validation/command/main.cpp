#include <exception>
#include <stdexcept>

#include <fmt/format.h>

#include "reports/evidence/build_facts.hpp"
#include "validation/command/commands.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app{
      "seiche: verification and validation of free-surface water-wave solvers.\n"
      "Start with 'seiche list', then 'seiche run CASE' and 'seiche report'."};
  app.set_version_flag("--version", std::string(seiche::build_facts::version));
  app.require_subcommand(0, 1);
  app.footer(
      "Exit status: 0 every claim has its declared verdict, 1 a check failed, 2 wrong usage or input,\n"
      "3 the run could not finish (diverged, disk full, killed).");

  seiche::command::Action action;
  seiche::command::add_list(app, action);
  seiche::command::add_run(app, action);
  seiche::command::add_report(app, action);
  seiche::command::add_exact(app, action);
  seiche::command::add_score(app, action);
  seiche::command::add_compare(app, action);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& wrong) {
    fmt::print(stderr, "seiche: {}\n", wrong.what());
    return 2;
  }
  if (!action) {
    fmt::print(stderr, "{}", app.help());
    return 2;
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::invalid_argument& wrong) {
    fmt::print(stderr, "seiche: {}\n", wrong.what());
    return 2;
  } catch (const std::exception& failure) {
    fmt::print(stderr, "seiche: {}\n", failure.what());
    return 3;
  }
}
