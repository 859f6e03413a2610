#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/evidence/record_files.hpp"
#include "seiche/io/table.hpp"
#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/case/score.hpp"
#include "validation/case/submitted.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"

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

int print_template(const Case& one, const std::vector<WantedTable>& wanted, const std::string& name) {
  std::vector<std::string> names;
  for (const WantedTable& table : wanted) names.push_back(table.name);
  if (name.empty() && wanted.size() > 1) {
    throw std::invalid_argument(fmt::format("--template: case {} takes several tables: add --table with one of {}",
                                            one.name, fmt::join(names, ", ")));
  }
  const auto chosen = name.empty() ? names.begin() : std::find(names.begin(), names.end(), name);
  if (chosen == names.end()) {
    throw std::invalid_argument(fmt::format("--table {}: must be one of {}", name, fmt::join(names, ", ")));
  }
  const WantedTable& table = wanted[static_cast<std::size_t>(chosen - names.begin())];
  fmt::print("{}", validation::template_of(
                       table, fmt::format("# {}: {}\n# Fill in the values, then: seiche score {} --data FILE --solver "
                                          "NAME\n",
                                          one.name, one.title, one.name)));
  return 0;
}

void print(const evidence::Record& record) {
  for (const auto& [quantity, value] : record.measurements()) fmt::print("  {:<28} {:.6g}\n", quantity, value);
  for (const evidence::JudgedClaim& claim : record.claims()) {
    const evidence::Judgement& j = claim.judgement;
    fmt::print("  {:<12} {} (measured {:.3g}, expected {:.3g} within {:.3g}; {})\n", evidence::name(j.verdict),
               claim.claim.text, j.measured, j.expected, j.limit, j.resolution);
  }
}

void require_solver_name(const std::string& name) {
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  if (!plain || name == "seiche") {
    throw std::invalid_argument(fmt::format("--solver {}: must be letters, digits, '-' and '_', and not seiche", name));
  }
}

validation::SolverFacts facts_of(const ScoreOptions& options) {
  validation::SolverFacts facts;
  if (options.cell > 0) facts.cell = options.cell;
  if (options.seconds > 0) facts.seconds = options.seconds;
  if (options.threads > 0) facts.threads = options.threads;
  return facts;
}

}  // namespace

int score(const ScoreOptions& options) {
  const Case& one = validation::find_case(options.name);
  if (!one.submission) {
    throw std::invalid_argument(
        fmt::format("score: case {} does not score others: 'seiche list' shows which do", one.name));
  }
  const Values values = values_for(one, validation::Tier::quick, options.config, options.settings);
  const std::vector<WantedTable> wanted = one.submission.tables(values);
  if (options.template_only) return print_template(one, wanted, options.table);
  if (options.data.empty()) throw std::invalid_argument("score: --data FILE is missing (or --template)");
  require_solver_name(options.solver);
  const validation::ColumnNames renamed = column_names(one, wanted, options.map);
  const auto uncertainty = uncertainties(one, wanted, options.uncertainty);

  evidence::Record record = validation::Job{&one, values}.blank_record();
  record.solver = options.solver;
  std::vector<io::Table> files;
  for (const std::string& file : options.data) {
    files.push_back(io::read_table(file, validation::names_in_files(wanted, renamed)));
    record.reference_data[file] = evidence::sha256_of_file(file);
  }
  const validation::Submitted submitted = validation::submitted_from(files, wanted, renamed);
  try {
    validation::score(wanted, submitted, uncertainty, record);
    if (one.submission.judge) one.submission.judge(values, submitted, facts_of(options), record);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", fmt::join(options.data, ", "), wrong.what()));
  }
  record.wall_time = options.seconds;  // of the solver's run: how long the scoring took is nobody's business
  if (options.cell > 0) record.measure("cell_size", options.cell);
  evidence::write(record, options.out);
  evidence::write_junit(options.out);
  print(record);
  fmt::print("record: {}\n", (std::filesystem::path(options.out) / (record.stem() + ".json")).string());
  return record.as_declared() ? 0 : 1;
}

}  // namespace seiche::command
