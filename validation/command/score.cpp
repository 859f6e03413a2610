#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/evidence/record_files.hpp"
#include "seiche/io/table.hpp"
#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"
#include "validation/scoring/diagnosis.hpp"
#include "validation/scoring/score.hpp"
#include "validation/scoring/solver_files.hpp"
#include "validation/scoring/submitted.hpp"

namespace seiche::command {
namespace {

using validation::Case;
using validation::Values;
using validation::WantedTable;

/// Names of everything that may be mapped; `with_uncertainty`: that may have an uncertainty.
std::vector<std::string> known_columns(const std::vector<WantedTable>& wanted, bool with_uncertainty) {
  std::vector<std::string> names;
  for (const WantedTable& table : wanted) {
    if (table.group && !with_uncertainty) names.push_back(table.group->name);
    if (table.abscissa) names.push_back(table.abscissa->name);
    for (const validation::WantedQuantity& q : table.quantities) names.push_back(q.column.name);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void require_known(const std::string& option, const Case& one, const std::string& name,
                   const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw std::invalid_argument(fmt::format("{}: case {} has no quantity {}: must be one of {}", option, one.name, name,
                                            fmt::join(known, ", ")));
  }
}

validation::ColumnNames column_names(const Case& one, const std::vector<WantedTable>& wanted,
                                     const std::vector<std::string>& map) {
  validation::ColumnNames renamed;
  for (const auto& [in_file, quantity] : split_settings("--map", map)) {
    require_known("--map", one, quantity, known_columns(wanted, false));
    if (!renamed.emplace(quantity, in_file).second) {
      throw std::invalid_argument(fmt::format("--map: quantity {} is given twice", quantity));
    }
  }
  return renamed;
}

std::map<std::string, validation::StatedUncertainty> uncertainties(const Case& one,
                                                                   const std::vector<WantedTable>& wanted,
                                                                   const std::vector<std::string>& texts) {
  std::map<std::string, validation::StatedUncertainty> stated;
  for (const auto& [quantity, text] : split_settings("--uncertainty", texts)) {
    require_known("--uncertainty", one, quantity, known_columns(wanted, true));
    stated[quantity] = validation::uncertainty_from(quantity, text);
  }
  return stated;
}

/// The table of that name; throws where the case has none.
const WantedTable& table_named(const std::vector<WantedTable>& wanted, const std::string& name) {
  std::vector<std::string> names;
  for (const WantedTable& table : wanted) {
    if (table.name == name) return table;
    names.push_back(table.name);
  }
  throw std::invalid_argument(fmt::format("--table {}: must be one of {}", name, fmt::join(names, ", ")));
}

int print_template(const Case& one, const std::vector<WantedTable>& wanted, const std::string& name) {
  if (name.empty() && wanted.size() > 1) {
    std::vector<std::string> names;
    for (const WantedTable& table : wanted) names.push_back(table.name);
    throw std::invalid_argument(fmt::format("--template: case {} takes several tables: add --table with one of {}",
                                            one.name, fmt::join(names, ", ")));
  }
  fmt::print("{}", validation::template_of(
                       name.empty() ? wanted.front() : table_named(wanted, name),
                       fmt::format("# {}: {}\n# Fill in the values, then: seiche score {} --data FILE --solver "
                                   "NAME\n",
                                   one.name, one.title, one.name)));
  return 0;
}

/// The distance from what is expected, as a share of it where the limit is less than it: "-0.08 %", "0.3 m".
std::string error_text(const evidence::JudgedClaim& claim) {
  const evidence::Judgement& j = claim.judgement;
  const double error = j.measured - j.expected;
  if (j.limit < std::abs(j.expected)) {
    return fmt::format("error {:+.3g} %, limit {:.3g} %", 100 * error / std::abs(j.expected),
                       100 * j.limit / std::abs(j.expected));
  }
  const std::string& unit = claim.claim.unit;
  return fmt::format("error {:+.3g}, limit {:.3g}{}", error, j.limit, unit == "1" || unit.empty() ? "" : " " + unit);
}

void print(const evidence::Record& record, const std::vector<validation::Finding>& findings) {
  for (const auto& [quantity, value] : record.measurements()) fmt::print("  {:<28} {:.6g}\n", quantity, value);
  for (const evidence::JudgedClaim& claim : record.claims()) {
    const evidence::Judgement& j = claim.judgement;
    fmt::print("  {:<12} {} ({}; {}{}{})\n", evidence::name(j.verdict), claim.claim.text, error_text(claim),
               j.resolution, j.note.empty() ? "" : "; ", j.note);
  }
  for (const evidence::ClaimLeftOut& left : record.left_out()) {
    fmt::print("  {:<12} {} ({})\n", "not judged", left.claim.text, left.reason);
  }
  for (const validation::Finding& one : findings)
    fmt::print("  {:<12} {}: your result {}\n", "look", one.where, one.words);
  const bool met = record.as_declared();
  fmt::print("{}: {}\n", record.name, met ? "every claim is met" : "not every claim is met");
}

void require_solver_name(const std::string& name) {
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  if (!plain || name == "seiche") {
    throw std::invalid_argument(fmt::format("--solver {}: must be letters, digits, '-' and '_', and not seiche", name));
  }
}

validation::SolverFacts facts_of(const ScoreOptions& options,
                                 std::map<std::string, validation::StatedUncertainty> uncertainty) {
  validation::SolverFacts facts;
  facts.uncertainty = std::move(uncertainty);
  if (options.cell > 0) facts.cell = options.cell;
  if (options.seconds > 0) facts.seconds = options.seconds;
  if (options.threads > 0) facts.threads = options.threads;
  return facts;
}

std::vector<validation::ResultFile> files_of(const ScoreOptions& options, const std::vector<std::string>& wanted) {
  const std::vector<std::string>& known = validation::solver_formats();
  if (options.format != "auto" && std::find(known.begin(), known.end(), options.format) == known.end()) {
    throw std::invalid_argument(
        fmt::format("--format {}: must be auto or one of {}", options.format, fmt::join(known, ", ")));
  }
  validation::Reading how{.format = options.format, .wanted = wanted};
  std::istringstream names(options.columns);
  for (std::string name; std::getline(names, name, ',');) how.columns.push_back(name);
  for (const auto& [gauge, position] : split_settings("--gauges", options.gauges)) {
    how.gauges[gauge] = finite_number("--gauges " + gauge, position);
  }
  std::vector<validation::ResultFile> files;
  for (const std::string& file : options.data) {
    const std::vector<validation::ResultFile> read = validation::read_results(file, how);
    files.insert(files.end(), read.begin(), read.end());
  }
  return files;
}

/// Keeps what was judged: the checksum of every file, of a folder that of its files' checksums.
void note_files(const std::vector<std::string>& data, const std::vector<validation::ResultFile>& files,
                evidence::Record& record) {
  auto next = files.begin();
  for (const std::string& path : data) {
    while (next != files.end() && next->files.empty()) ++next;
    if (!std::filesystem::is_directory(path)) {
      record.reference_data[path] = evidence::sha256_of_file(path);
    } else {
      std::string all;
      for (const auto& file : next->files) all += evidence::sha256_of_file(file);
      record.reference_data[path] = evidence::sha256(all);
    }
    ++next;
  }
}

/// What was understood of files that are not our own kind.
void print_reading(const std::vector<validation::ResultFile>& files) {
  for (const validation::ResultFile& file : files) {
    if (file.format == "csv" || file.format == "hdf5") continue;
    fmt::print("  {:<12} {}: {}, columns {}{}\n", "read", file.table.source, file.format,
               fmt::join(file.table.names, ", "),
               file.replaced > 0 ? fmt::format("; {} rows are replaced by a restart", file.replaced) : "");
  }
}

}  // namespace

int score(const ScoreOptions& options) {
  const Case& one = validation::find_case(options.name);
  if (!one.submission) {
    throw std::invalid_argument(
        fmt::format("score: case {} does not score others: 'seiche list' shows which do", one.name));
  }
  const Values values = values_for(one, validation::Tier::quick, options.config, options.settings);
  std::vector<WantedTable> wanted = one.submission.tables(values);
  if (options.template_only) return print_template(one, wanted, options.table);
  if (options.data.empty()) throw std::invalid_argument("score: --data FILE is missing (or --template)");
  require_solver_name(options.solver);
  const validation::ColumnNames renamed = column_names(one, wanted, options.map);
  const auto uncertainty = uncertainties(one, wanted, options.uncertainty);

  evidence::Record record = validation::Job{&one, values}.blank_record();
  record.solver = options.solver;
  if (!options.table.empty()) {
    const WantedTable alone = table_named(wanted, options.table);
    for (const WantedTable& table : wanted) {
      if (table.name != alone.name) {
        validation::leave_out(table, fmt::format("--table {} asks for that table alone", alone.name), record);
      }
    }
    wanted = {alone};
  }
  const std::vector<validation::ResultFile> files = files_of(options, validation::names_in_files(wanted, renamed));
  note_files(options.data, files, record);
  const validation::Submitted submitted = validation::submitted_from(validation::joined(files), wanted, renamed);
  std::vector<validation::Finding> findings;
  try {
    validation::score(wanted, submitted, uncertainty, record);
    if (one.submission.judge) one.submission.judge(values, submitted, facts_of(options, uncertainty), record);
    const bool shift_fitted = record.measurements().contains("time_shift");
    findings = validation::diagnosis(wanted, submitted, shift_fitted);
    validation::show_diagnosis(findings, record);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", fmt::join(options.data, ", "), wrong.what()));
  }
  record.wall_time = options.seconds;  // of the solver's run: how long the scoring took is nobody's business
  if (options.cell > 0) record.measure("cell_size", options.cell);
  if (options.threads > 0) record.measure("threads", static_cast<double>(options.threads));
  evidence::write(record, options.out);
  evidence::write_junit(options.out);
  print_reading(files);
  print(record, findings);
  fmt::print("record: {}\n", (std::filesystem::path(options.out) / (record.stem() + ".json")).string());
  return record.as_declared() ? 0 : 1;
}

}  // namespace seiche::command
