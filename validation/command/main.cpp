/// The command line, option by option. All in one file: the parser's header takes longer to compile than all
/// commands together.
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <omp.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "reports/evidence/build_facts.hpp"
#include "seiche/io/text_table.hpp"
#include "seiche/wording.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/exact_inputs.hpp"
#include "validation/command/streams.hpp"
#include "validation/scoring/solver_files.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::command {
namespace {

/// A positive number, and of lengths one in another unit than metres: "0.1", "10cm". The text becomes the number alone.
CLI::Validator positive(const std::string& unit) {
  return CLI::Validator(
      [unit](std::string& text) -> std::string {
        const std::size_t end = std::min(text.size(), text.find_last_of("0123456789.") + 1);
        const auto number = io::number_in(text.substr(0, end));
        const auto factor = end == text.size() ? std::optional(1.0) : validation::conversion(text.substr(end), unit);
        if (!number || !factor || !(*number * *factor > 0) || !std::isfinite(*number * *factor)) {
          return fmt::format("{}: must be a positive number [{}]", text, unit);
        }
        text = fmt::format("{}", *number * *factor);
        return {};
      },
      "", "positive");
}

/// Help whose lines end before column 80.
class Narrow : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override {
    std::istringstream words(option->get_description());
    std::string text;
    std::size_t used = 0;
    for (std::string word; words >> word; used += word.size() + 1) {
      if (used + word.size() > 79 - column_width_) {
        text += '\n';
        used = 0;
      } else if (used > 0) {
        text += ' ';
      }
      text += word;
    }
    return text;
  }
};

/// What is called after parsing: set by the subcommand that was named.
using Action = std::function<int()>;

void add_list(CLI::App& app, Action& action) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* command = app.add_subcommand("list", "List cases, scored cases and as-published parameter sets");
  command->group("Run and report");
  command->add_option("CASE", options->claims, "Case whose claims are listed, as --claims");
  command->add_flag("--json", options->json, "Print JSON, with every parameter, or of CASE its claims");
  command->add_flag("--scores", options->scores, "List cases that accept external results, with tables and columns");
  command->add_flag("--published", options->published,
                    "List as-published parameter sets, and whether they reproduce their figures");
  command->add_option("--claims", options->claims, "List the claims of this case, with limits and reasons");
  command->add_option("--tier", options->tier, "Tier, with --claims: quick, full or paper [quick]");
  command->add_option("--set", options->settings, "Parameter of the case, with --claims, as name=value")
      ->allow_extra_args(false);
  command->add_option("--ctest", options->ctest, "write add_test entries for ctest to this file")->group("");
  command->add_option("--evidence", options->evidence, "folder that those tests write to")->group("");
  command->add_option("--most-seconds", options->most_seconds, "limit of those tests; cases stopped by it are skipped")
      ->group("");
  command->callback([options, &action] { action = [options] { return list(*options); }; });
}

void add_run(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run cases and write their results (JSON, HDF5)");
  command->group("Run and report");
  command->add_option("CASE", options->cases, "Names of cases ('seiche list'), or patterns such as 'dam*'");
  command->add_option("--tier", options->tier,
                      "Tier: quick, full or paper [quick]; without CASE, all cases of the tier");
  command->add_option("--as", options->as,
                      "Run with as-published parameters, e.g. bzz-fig-6 ('seiche list --published')");
  command->add_option("--set", options->settings, "Parameter of the case, as name=value; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--config", options->config, "TOML file with parameters; tables [CASE] for single cases");
  command->add_option("--jobs,-j", options->run.jobs, "Number of concurrent cases")->check(CLI::Range(1U, 1024U));
  command
      ->add_option("--threads", options->run.threads,
                   "Threads of each case [1; one per core for a single case]; results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command->add_option("--out", options->run.directory, "Folder for the records")->capture_default_str();
  command->add_flag("--resume", options->run.resume, "Keep finished results and continue from checkpoints");
  command
      ->add_option_function<long>(
          "--checkpoint-every",
          [options](long seconds) { options->run.checkpoint_every = std::chrono::seconds(seconds); },
          "Time between checkpoints of a long computation [120 s]")
      ->check(CLI::Range(0L, 86400L));
  command
      ->add_option_function<long>(
          "--most-seconds", [options](long seconds) { options->run.most_seconds = std::chrono::seconds(seconds); },
          "Stop a case after this wall-clock time and mark it incomplete [limit of the tier]")
      ->check(CLI::Range(1L, 100000000L));
  command->add_flag("--help-parameters", options->help_parameters, "Print the parameters of the cases, then exit");
  command->footer(
      "Examples:\n"
      "  seiche run riemann --set right_depth=0.1 --set scheme=M2 --out evidence\n"
      "  seiche run dry_dam_break --as bzz-fig-6");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

void add_report(CLI::App& app, Action& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Write the HTML report (optionally PDF)");
  command->group("Run and report");
  command->add_option("DIR", options->evidence, "Folder with the records")->capture_default_str();
  command->add_option("--out", options->out, "Folder for the report [DIR/report]");
  command->add_option("--pdf", options->pdf, "Also print the report to this PDF file (needs Chromium)");
  command->add_flag("--with-data", options->with_data, "Also copy the records and their arrays into the report");
  command->add_option("--jobs,-j", options->jobs, "Number of figures drawn concurrently")->check(CLI::Range(1U, 1024U));
  command->footer(
      "Environment variable SEICHE_PYTHON: the Python interpreter, with numpy, h5py,\n"
      "matplotlib, jinja2 and markdown.");
  command->callback([options, &action] { action = [options] { return report(*options); }; });
}

void add_exact(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExactOptions>();
  CLI::App* command = app.add_subcommand("exact", "Evaluate an exact solution at points or on a grid");
  command->group("Score and compare");
  command->add_option("NAME", options->name, "Name of the solution, or list ('seiche exact list' shows all)")
      ->required();
  command->add_option("--set", options->settings, "Parameters, as name=value; may be repeated");
  command->add_option("--at", options->points, "Points, as x=1,y=-0.2,t=2; may be repeated");
  command->add_option("--grid", options->grid, "Points, as x=-10:10:401,t=2 (FROM:TO:COUNT); NaN outside the water");
  CLI::Option* format = command->add_option("--format", options->format, "Output format: csv, json or hdf5")
                            ->check(CLI::IsMember({"csv", "json", "hdf5"}))
                            ->capture_default_str();
  command->add_option("--out", options->out, "Output file [standard output; for HDF5 NAME.h5]");
  command
      ->add_option(
          "--write", options->write,
          "Write initial conditions for another solver into the folder --out [.]. openfoam: alpha.water.internalField "
          "and U.internalField, to be included in 0/alpha.water and 0/U; needs --centres, and --at t=... unless t = 0. "
          "geoclaw: topo.xyz, eta.xyz for qinit_type 4, hu.xyz, and hv.xyz if the solution depends on y (topotype 1), "
          "on --grid. dualsphysics: paddle.csv, time;position of a piston started from rest, for mvrectfile with "
          "fields 2, fieldtime 0, fieldx 1; of solitary, solitary_asymptotic and wavemaker, whose stroke grows over "
          "the first period; times from 0, as --grid t=0:20:2001. vtk: legacy structured grid, on --grid. csv: on "
          "--grid")
      ->check(CLI::IsMember(input_formats()))
      ->excludes(format);
  command->add_option("--centres", options->centres,
                      "Cell centres, with --write openfoam: field C of 'postProcess -func writeCellCentres', in text");
  command->add_option("--up", options->up, "Axis that points upward, with --write openfoam: y or z")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  command
      ->add_option("--origin", options->origin,
                   "X,Z: coordinates of the solution's origin in the other solver, with --write")
      ->delimiter(',')
      ->expected(2);
  command
      ->add_option("--width", options->width,
                   "Width in y of a solution that does not depend on y, with --write geoclaw [m]")
      ->transform(positive("m"))
      ->capture_default_str();
  command->add_flag("--integrals", options->integrals, "Also print scalar results and the numerical uncertainty");
  command->add_flag("--self-test", options->self_test,
                    "Print the residuals of the solution's built-in identities, then exit");
  command->footer(
      "Examples:\n"
      "  seiche exact solitary --set amplitude=0.3 --at x=0,y=-0.5,t=0 --integrals\n"
      "  seiche exact riemann --set right_depth=0.1 --grid x=-10:10:401,t=2\n"
      "  seiche exact stokes --grid x=0:6.28:65,y=-1:0.4:29,t=0 --format hdf5\n"
      "  seiche exact solitary --set gravity=9.81 --write dualsphysics --out case\n"
      "  seiche exact solitary --write openfoam --centres 0/C --origin 10,0.4 --out 0");
  command->callback([options, &action] { action = [options] { return exact_command(*options); }; });
}

void add_score(CLI::App& app, Action& action) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "Compare your solver's results with a reference");
  command->group("Score and compare");
  command->add_option("CASE", options->name, "Name of a case that accepts external results ('seiche list --scores')")
      ->required();
  command->add_option("FILE", options->files, "Result file, as --data")->check(CLI::ExistingPath);
  command
      ->add_option(
          "--data", options->data,
          "Result file: CSV, HDF5, a solver's own format (--format), or its folder of times; repeat for several "
          "tables or one file per gauge")
      ->allow_extra_args(false)
      ->check(CLI::ExistingPath);
  command
      ->add_option(
          "--format", options->format,
          "Format of the files: auto (by content), " + fmt::format("{}", fmt::join(validation::solver_formats(), ", ")))
      ->capture_default_str();
  command->add_option("--columns", options->columns, "Column names of a file without a header, as t,eta");
  command
      ->add_option("--gauges", options->gauges,
                   "NAME=6,...: gauge of the column or file NAME: number or position in the template, or X:Y [m]")
      ->allow_extra_args(false);
  command->add_option("--solver", options->solver, "Name of the solver in the report")->capture_default_str();
  command
      ->add_option("--map", options->map,
                   "column=quantity,...: quantity of a column (dataset) with another name; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--uncertainty", options->uncertainty,
                   "quantity=value,...: standard numerical uncertainty of your result, in the unit of the template or "
                   "relative to the largest reference value, as h=1%; without it comparisons with measurements are "
                   "inconclusive")
      ->allow_extra_args(false);
  command->add_option("--set", options->settings, "Parameters of the case, as name=value,...; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--config", options->config, "TOML file with parameters");
  command->add_option("--out", options->out, "Folder for the record")->capture_default_str();
  command->add_option("--dx", options->cell, "Cell size or particle spacing of your run [m]")->transform(positive("m"));
  command
      ->add_option(
          "--sizes", options->sizes,
          "H1,H2,H3,...: cell sizes of three or more grids [m], with one set of --data each; reports order and "
          "cost, scores the finest")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(positive("m"));
  command
      ->add_option("--repeats", options->repeats,
                   "Number of repeated runs, with one set of --data each; scores their mean, adds their scatter to the "
                   "uncertainty")
      ->check(CLI::Range(2, 1000));
  command->add_option("--seconds", options->seconds, "Processor time of your run [s]; with --sizes T1,T2,T3")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(positive("s"));
  command->add_option("--threads", options->threads, "Number of threads of your run")
      ->check(CLI::Range(1L, 100000000L));
  command->add_flag("--template", options->template_only, "Print the CSV file to fill in, then exit");
  command->add_flag("--resolving-power", options->resolving_power,
                    "Print the smallest change of the reference that the case detects, then exit");
  command->add_option("--table", options->table,
                      "Table to print with --template, or to score alone, of a case with several");
  CLI::Option* baseline = command->add_option("--baseline", options->baseline,
                                              "Folder, not --out, with an earlier result of the same case, parameters "
                                              "and solver. Exit status 1 if an error grew "
                                              "beyond both uncertainties, 0 otherwise, whatever the verdicts");
  command->add_flag("--bless", options->bless, "Accept this result as the new baseline")->needs(baseline);
  command->add_flag("--json", options->json, "Print verdict, notes, diagnosis and record as JSON");
  command->footer(
      "Results are interpolated linearly to the reference points, never extrapolated.\n"
      "A further file with columns t and volume, energy or momentum is checked for\n"
      "conservation.\n"
      "Examples:\n"
      "  seiche score riemann --template > mine.csv          # fill it in\n"
      "  seiche score riemann --data mine.csv --solver mine --out evidence\n"
      "  seiche score riemann --data a.csv --data b.csv --data c.csv --sizes 1,0.5,0.25");
  command->callback([options, &action] {
    options->data.insert(options->data.begin(), options->files.begin(), options->files.end());
    action = [options] { return score(*options); };
  });
}

void add_compare(CLI::App& app, Action& action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Compare two sets of results, or the solvers in one set");
  command->group("Score and compare");
  command->add_option("A", options->before, "Folder with records, the earlier one of two")->required();
  command->add_option("B", options->after, "Folder with the later records; with --record a table");
  command
      ->add_option("--factor", options->factor,
                   "Factor of growth of an error, beyond its uncertainty, that counts as worse")
      ->capture_default_str()
      ->check([](const std::string& text) {
        double factor = 0;
        const bool number = CLI::detail::lexical_cast(text, factor) && factor >= 1 && factor <= 1e6;  // NaN is neither
        return number ? std::string() : fmt::format("factor = {} is out of range: must be in [1, 1e6]", text);
      });
  CLI::Option* record = command->add_flag("--record", options->record,
                                          "Compare A with the baseline: table B, or the table of this version");
  command->add_flag("--whole", options->whole, "Treat claims missing from A as changed, with --record")->needs(record);
  command->footer(
      "Exit status 1. Two sets: a verdict or an error got worse. One set: a claim is\n"
      "not as expected. With --record: a value changed beyond its uncertainty.");
  command->add_option("--tier", options->tier, "Tier, with --record: quick, full or paper")
      ->capture_default_str()
      ->needs(record);
  command->callback([options, &action] {
    action = [options] { return options->record ? compare_with_record(*options) : compare(*options); };
  });
}

void add_record(CLI::App& app, Action& action) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = app.add_subcommand("record", "Write the baseline table of a tier");
  command->group("Maintenance");
  command->add_option("DIR", options->evidence, "Folder with the records of the whole tier")->capture_default_str();
  command->add_option("--tier", options->tier, "Tier: quick, full or paper")->capture_default_str();
  command->add_option("--out", options->out, "File to write [reports/record/TIER.csv of the project]");
  command->callback([options, &action] { action = [options] { return record(*options); }; });
}

/// The parser says of a mistyped command only that its arguments were not expected.
void require_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || *argv[1] == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return;
    known.push_back(command->get_name());
  }
  throw std::invalid_argument(
      fmt::format("unknown command '{}'{} 'seiche --help' shows all", argv[1], did_you_mean(argv[1], known)));
}

int parse_and_call(int argc, char** argv) {
  CLI::App app{
      fmt::format("seiche {}: verification and validation of free-surface water-wave solvers\n\n"
                  "Start here:\n"
                  " seiche list                                        what is available\n"
                  " seiche run riemann --out results                   one case, 0.1 s\n"
                  " seiche report results                              results/report/index.html\n"
                  " seiche score riemann --template > mine.csv         template for your results",
                  build_facts::version)};
  app.formatter(std::make_shared<Narrow>());
  app.set_version_flag("--version", std::string(build_facts::version));
  app.require_subcommand(0, 1);
  app.footer(
      "'seiche COMMAND --help' shows options; 'man seiche' the manual.\n"
      "Exit status: 0 all claims as expected; 1 at least one unexpected result;\n"
      "2 invalid input or usage; 3 run not completed (diverged, disk full, killed).");

  // Words that others use for options: seiche help, seiche help run, seiche version.
  for (const char* word : {"help", "version"}) {
    if (argc > 1 && argv[1] == std::string_view(word)) {
      std::string option = std::string("--") + word;
      std::vector<char*> words(argv, argv + argc);
      words.erase(words.begin() + 1);
      words.push_back(option.data());
      return parse_and_call(argc, words.data());
    }
  }
  Action action;
  add_list(app, action);
  add_run(app, action);
  add_report(app, action);
  add_exact(app, action);
  add_score(app, action);
  add_compare(app, action);
  add_record(app, action);
  require_command(app, argc, argv);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& wrong) {
    complain(wrong.what());
    return 2;
  }
  if (!action) {
    fmt::print(stderr, "{}", app.help());
    return 2;
  }
  return action();
}

/// Threads that wait sleep instead of spinning, unless the user has chosen: on a busy machine spinning ones take the
/// processor from those that work. The runtime reads this as it is loaded, hence the second start.
void let_waiting_threads_sleep(char** argv) {
  if (omp_get_max_threads() == 1 || std::getenv("OMP_WAIT_POLICY") != nullptr ||
      std::getenv("GOMP_SPINCOUNT") != nullptr) {
    return;
  }
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", argv);  // returns where there is no /proc: threads spin, the results are the same
}

}  // namespace
}  // namespace seiche::command

int main(int argc, char** argv) {
  seiche::command::let_waiting_threads_sleep(argv);
  using seiche::command::complain;
  try {
    seiche::command::prepare_streams();
    const int status = seiche::command::parse_and_call(argc, argv);
    std::cout.flush();
    const bool flushed = std::fflush(stdout) == 0;
    if (!flushed || std::ferror(stdout) != 0 || !std::cout) {  // an earlier flush may have failed, and forgotten why
      complain(std::string("standard output cannot be written") +
               (flushed ? "" : fmt::format(": {}", std::strerror(errno))));
      return 3;
    }
    return status;
  } catch (const std::invalid_argument& wrong) {
    complain(wrong.what());
    return 2;
  } catch (const std::exception& failure) {
    complain(failure.what());
    return 3;
  }
}
