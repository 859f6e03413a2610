#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "seiche/io/csv_table.hpp"
#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"

namespace seiche::command {
namespace {

using validation::Case;
using validation::Column;
using validation::Values;

struct Options {
  std::string name;
  std::string data;
  std::string solver = "yours";
  std::vector<std::string> map;
  std::vector<std::string> settings;
  std::string config;
  std::string out = "evidence";
  bool template_only = false;
};

/// The columns the case asks for, from the file, under the names that --map gives them.
validation::Columns columns_for(const Case& one, const io::CsvTable& table, const std::vector<std::string>& map) {
  std::map<std::string, std::string> name_in_file;
  for (const Column& column : one.submission.columns) name_in_file[column.name] = column.name;
  for (const std::string& pair : map) {
    const auto [in_file, quantity] = split_setting(pair);
    if (name_in_file.count(quantity) == 0) {
      throw std::invalid_argument(fmt::format("--map {}: case {} has no quantity {}", pair, one.name, quantity));
    }
    name_in_file[quantity] = in_file;
  }
  validation::Columns columns;
  for (const auto& [quantity, in_file] : name_in_file) columns[quantity] = table.column(in_file);

  const Column& abscissa = one.submission.columns.front();
  const std::vector<double>& x = columns.at(abscissa.name);
  const auto disorder = std::adjacent_find(x.begin(), x.end(), [](double a, double b) { return !(a < b); });
  if (disorder != x.end()) {
    throw std::invalid_argument(fmt::format("column {}: row {}: {:g} follows {:g}, must increase strictly",
                                            name_in_file.at(abscissa.name), disorder - x.begin() + 2, *(disorder + 1),
                                            *disorder));
  }
  return columns;
}

int print_template(const Case& one, const Values& values) {
  fmt::print("# {}: {}\n# Fill in the values, then: seiche score {} --data FILE --solver NAME\n", one.name, one.title,
             one.name);
  std::string header;
  for (const Column& column : one.submission.columns) {
    fmt::print("# {}: {} [{}]\n", column.name, column.meaning, column.unit);
    header += fmt::format("{}{} [{}]", header.empty() ? "" : ",", column.name, column.unit);
  }
  fmt::print("{}\n", header);
  const std::string blanks(one.submission.columns.size() - 1, ',');
  for (const double x : one.submission.abscissae(values)) fmt::print("{:.17g}{}\n", x, blanks);
  return 0;
}

int score(const Options& options) {
  const Case& one = validation::find_case(options.name);
  if (!one.submission) {
    throw std::invalid_argument(
        fmt::format("score: case {} does not score others: 'seiche list' shows which do", one.name));
  }
  const Values values = values_for(one, validation::Tier::quick, options.config, options.settings);
  if (options.template_only) return print_template(one, values);
  if (options.data.empty()) throw std::invalid_argument("score: --data FILE is missing (or --template)");
  const bool plain = !options.solver.empty() &&
                     std::all_of(options.solver.begin(), options.solver.end(),
                                 [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
  if (!plain || options.solver == "seiche") {
    throw std::invalid_argument(
        fmt::format("--solver {}: must be letters, digits, '-' and '_', and not seiche", options.solver));
  }

  const auto begin = std::chrono::steady_clock::now();
  evidence::Record record = validation::Job{&one, values}.blank_record();
  record.solver = options.solver;
  record.reference_data[options.data] = evidence::sha256_of_file(options.data);
  try {
    one.submission.judge(values, columns_for(one, io::read_csv(options.data), options.map), record);
  } catch (const std::invalid_argument& wrong) {
    const std::string message = wrong.what();
    throw std::invalid_argument(message.starts_with(options.data) ? message : options.data + ": " + message);
  }
  record.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  evidence::write(record, options.out);

  for (const auto& [quantity, value] : record.measurements()) fmt::print("  {:<28} {:.6g}\n", quantity, value);
  for (const evidence::JudgedClaim& claim : record.claims()) {
    fmt::print("  {:<12} {} (measured {:.3g}, expected {:.3g} within {:.3g})\n",
               evidence::name(claim.judgement.verdict), claim.claim.text, claim.judgement.measured,
               claim.judgement.expected, claim.judgement.limit);
  }
  fmt::print("record: {}\n", (std::filesystem::path(options.out) / (record.stem() + ".json")).string());
  return record.as_declared() ? 0 : 1;
}

}  // namespace

void add_score(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("score", "Judge somebody else's result against a case's reference");
  command->add_option("CASE", options->name, "name of a case that scores others, see 'seiche list'")->required();
  command->add_option("--data", options->data, "CSV file with the result")->check(CLI::ExistingFile);
  command->add_option("--solver", options->solver, "what to call the solver in the report")->capture_default_str();
  command->add_option("--map", options->map, "column=quantity, where the file names a column differently")
      ->allow_extra_args(false);
  command->add_option("--set", options->settings, "parameter of the case, as name=value; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--config", options->config, "TOML file with parameters");
  command->add_option("--out", options->out, "folder for the record")->capture_default_str();
  command->add_flag("--template", options->template_only, "print the file to fill in, and stop");
  command->footer(
      "Example: seiche score riemann --template > mine.csv, fill it in, seiche score riemann --data mine.csv");
  command->callback([options, &action] { action = [options] { return score(*options); }; });
}

}  // namespace seiche::command
