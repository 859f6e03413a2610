/// The subcommands of `seiche`. Each adds itself to the command line and, when called, returns the exit status:
/// 0 all as declared, 1 a check failed, 2 wrong usage or input, 3 the run could not finish.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace seiche::command {

/// What main() runs after parsing: set by the subcommand that was called.
using Action = std::function<int()>;

void add_list(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_exact(CLI::App& app, Action& action);
void add_score(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);

}  // namespace seiche::command
