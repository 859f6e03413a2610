#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <ranges>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "reports/evidence/record_files.hpp"
#include "reports/evidence/record_lock.hpp"
#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_table.hpp"
#include "seiche/io/text_table.hpp"
#include "seiche/wording.hpp"
#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"
#include "validation/scoring/baseline.hpp"
#include "validation/scoring/conservation.hpp"
#include "validation/scoring/diagnosis.hpp"
#include "validation/scoring/first_look.hpp"
#include "validation/scoring/ladder.hpp"
#include "validation/scoring/ranks.hpp"
#include "validation/scoring/repeats.hpp"
#include "validation/scoring/resolving_power.hpp"
#include "validation/scoring/score.hpp"
#include "validation/scoring/solver_files.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::command {
namespace {

namespace fs = std::filesystem;
using validation::Case;
using validation::ColumnNames;
using validation::Finding;
using validation::Resolved;
using validation::StatedUncertainty;
using validation::Values;
using validation::WantedTable;
using Json = nlohmann::ordered_json;

/// Names of everything that may be mapped; `with_uncertainty`: that may have an uncertainty.
std::set<std::string> known_columns(const std::vector<WantedTable>& wanted, bool with_uncertainty) {
  std::set<std::string> names;
  for (const WantedTable& table : wanted) {
    for (const validation::Column& column : validation::columns_of(table)) {
      if (!with_uncertainty || !table.group || column.name != table.group->name) names.insert(column.name);
    }
  }
  if (with_uncertainty) return names;
  for (const std::string& name : validation::history_names(wanted, {})) names.insert(name);
  return names;
}

void require_known(const std::string& option, const Case& one, const std::string& name,
                   const std::set<std::string>& known) {
  if (known.contains(name)) return;
  fail("{}: case {} has no quantity {}: must be one of {}", option, one.name, name, fmt::join(known, ", "));
}

ColumnNames column_names(const Case& one, const std::vector<WantedTable>& wanted, const std::vector<std::string>& map) {
  ColumnNames renamed;
  for (const auto& [in_file, quantity] : split_settings("--map", map)) {
    require_known("--map", one, quantity, known_columns(wanted, false));
    if (!renamed.emplace(quantity, in_file).second) fail("--map: quantity {} is given twice", quantity);
  }
  return renamed;
}

std::map<std::string, StatedUncertainty> uncertainties(const Case& one, const std::vector<WantedTable>& wanted,
                                                       const std::vector<std::string>& texts) {
  std::map<std::string, StatedUncertainty> stated;
  for (const auto& [quantity, text] : split_settings("--uncertainty", texts)) {
    require_known("--uncertainty", one, quantity, known_columns(wanted, true));
    stated[quantity] = validation::uncertainty_from(quantity, text);
  }
  return stated;
}

auto names_of(const std::vector<WantedTable>& wanted) {
  return wanted | std::views::transform(&WantedTable::name);
}

/// The table of that name; throws where the case has none.
const WantedTable& table_named(const std::vector<WantedTable>& wanted, const std::string& name) {
  const auto found = std::ranges::find(wanted, name, &WantedTable::name);
  if (found == wanted.end()) fail("--table {}: must be one of {}", name, fmt::join(names_of(wanted), ", "));
  return *found;
}

int print_template(const Case& one, const std::vector<WantedTable>& wanted, const std::string& name) {
  if (name.empty() && wanted.size() > 1) {
    fail("--template: case {} takes several tables: add --table with one of {}", one.name,
         fmt::join(names_of(wanted), ", "));
  }
  fmt::print("{}", validation::template_of(
                       name.empty() ? wanted.front() : table_named(wanted, name),
                       fmt::format("# {}: {}\n# Fill in the values, then: seiche score {} --data FILE --solver "
                                   "NAME\n",
                                   one.name, one.title, one.name)));
  return 0;
}

/// Status 1 where a right result does not pass.
int print_power(const Case& one, const Values& values, const std::vector<WantedTable>& wanted, bool as_json) {
  const std::vector<Resolved> rows = validation::resolving_power(one, values);
  auto json = Json::array();
  const auto print_shapes = [&](const std::string& table) {
    for (const Resolved& row : rows) {
      if (row.table != table || !row.quantity.empty() || !std::isnan(row.smallest)) continue;
      fmt::print("  {:<14} {}\n", row.change, row.by.empty() ? "passes" : row.by);
    }
  };
  for (const Resolved& row : rows) {
    json.push_back({{"table", row.table},
                    {"quantity", row.quantity},
                    {"change", row.change},
                    {"smallest", row.smallest},
                    {"amount", row.amount},
                    {"unit", row.unit},
                    {"by", row.by}});
  }
  if (as_json) {
    const bool exact = std::ranges::all_of(
        wanted, [](const WantedTable& table) { return table.reference_role == evidence::Role::exact; });
    fmt::print("{}\n", Json{{"exact", exact}, {"changes", json}}.dump(1));
  } else {
    fmt::print("{}: {}\n", one.name, validation::told_by(rows, "", ""));
    print_shapes("");
    for (const WantedTable& table : wanted) {
      fmt::print("{}\n", table.name);
      for (const validation::WantedQuantity& q : table.quantities)
        fmt::print("  {}\n", validation::told_by(rows, table.name, q.column.name));
      print_shapes(table.name);
    }
  }
  const auto wrong = [](const Resolved& row) { return row.right_result() && !row.by.empty(); };
  return std::ranges::any_of(rows, wrong) ? 1 : 0;
}

/// The distance from what is expected, as a share of it where the limit is less than it: "-0.08 %", "0.3 m".
std::string error_text(const evidence::JudgedClaim& claim) {
  const evidence::Judgement& j = claim.judgement;
  const double error = j.measured - j.expected;
  const double size = std::abs(j.expected);
  if (!std::isfinite(error)) return "not measured";
  if (j.limit < size) return fmt::format("error {:+.3g} %, limit {:.3g} %", 100 * error / size, 100 * j.limit / size);
  return fmt::format("error {:+.3g}, limit {:.3g}{}", error, j.limit, validation::after_number(claim.claim.unit));
}

void print(const evidence::Record& record, const std::vector<Finding>& findings, const validation::FirstLook& look) {
  for (const auto& [question, answer] : look) fmt::print("{}: {}\n", question, answer);
  for (const auto& [quantity, value] : record.measurements()) {
    if (!std::isnan(value)) fmt::print("  {:<28} {:.6g}\n", quantity, value);  // a plateau has no shift
  }
  for (const evidence::JudgedClaim& claim : record.claims()) {
    const evidence::Judgement& j = claim.judgement;
    fmt::print("  {:<12} {} ({}; {}{}{})\n", evidence::name(j.verdict), claim.claim.text, error_text(claim),
               j.resolution, j.note.empty() ? "" : "; ", j.note);
  }
  for (const evidence::ClaimLeftOut& left : record.left_out()) {
    fmt::print("  {:<12} {} ({})\n", "not scored", left.claim.text, left.reason);
  }
  for (const Finding& one : findings) fmt::print("  {:<12} {}: your result {}\n", "look", one.where, one.words);
  const bool met = record.as_declared();
  fmt::print("{}: {}\n", record.name, met ? "every claim is met" : "not every claim is met");
}

/// The number of the smallest size; 0 without any.
std::size_t finest_of(const std::vector<double>& sizes) {
  return static_cast<std::size_t>(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
}

void require_as_many(const ScoreOptions& options, std::size_t blocks, const char* several, const char* one) {
  if (options.data.size() % blocks == 0) return;
  fail("--data: got {0} files for {1} {2}; give the same number for each {3}, all files of the first {3} first",
       options.data.size(), blocks, several, one);
}

/// @throws std::invalid_argument for what does not go together
void require_valid(const ScoreOptions& options) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (options.solver.empty() || options.solver == "seiche" || !std::ranges::all_of(options.solver, is_plain))
    fail("--solver {}: must be letters, digits, '-' and '_', and not seiche", options.solver);
  const std::vector<std::string>& formats = validation::solver_formats();
  if (options.format != "auto" && std::ranges::find(formats, options.format) == formats.end())
    fail("--format {}: must be auto or one of {}", options.format, fmt::join(formats, ", "));
  const std::size_t sizes = options.sizes.size();
  if (!options.seconds.empty() && options.seconds.size() != std::max<std::size_t>(sizes, 1))
    fail("--seconds {}: must be one number, or one for each of the {} --sizes", fmt::join(options.seconds, ","), sizes);
  if (sizes > 0 && options.cell > 0) fail("--dx: --sizes say how large the cells are");
  if (sizes > 0) require_as_many(options, sizes, "cell sizes", "size");
  if (sizes > 0 && options.repeats > 1) fail("--repeats and --sizes: leave one of the two out");
  require_as_many(options, options.repeats, "repeats", "run");
}

validation::SolverFacts facts_of(const ScoreOptions& options, std::map<std::string, StatedUncertainty> uncertainty) {
  validation::SolverFacts facts{.cell = {}, .seconds = {}, .uncertainty = std::move(uncertainty)};
  if (options.cell > 0) facts.cell = options.cell;
  if (!options.sizes.empty()) facts.cell = options.sizes[finest_of(options.sizes)];
  if (!options.seconds.empty()) facts.seconds = options.seconds.at(finest_of(options.sizes));
  return facts;
}

/// What was read of some of the files: the case's tables, and a history of what is conserved.
struct Read {
  std::vector<validation::ResultFile> files;
  validation::Submitted submitted;
  validation::History history;
  std::vector<std::string> notes;
};

Read read(const ScoreOptions& options, const std::vector<std::string>& data, const std::vector<WantedTable>& wanted,
          const ColumnNames& renamed) {
  validation::Reading how{.format = options.format, .wanted = validation::names_in_files(wanted, renamed)};
  std::ranges::move(validation::history_names(wanted, renamed), std::back_inserter(how.wanted));
  std::istringstream given(options.columns);
  for (std::string name; std::getline(given, name, ',');) how.columns.push_back(name);
  validation::Understanding understood{.renamed = renamed};
  for (const auto& [name, gauge] : split_settings("--gauges", options.gauges)) {
    understood.gauges[name] = gauge;
    how.wanted.push_back(name);
  }
  Read result;
  std::vector<io::Table> tables;
  for (const std::string& file : data) {
    for (const validation::ResultFile& one : validation::read_results(file, how)) {
      result.files.push_back(one);
      tables.push_back(one.table);
    }
  }
  result.history = validation::take_history(tables, wanted, renamed);
  if (tables.empty()) {
    fail("{}: contains only a volume, energy or momentum history; the case also needs one of its tables",
         fmt::join(data, ", "));
  }
  result.submitted = validation::submitted_from(tables, wanted, understood);
  result.notes = understood.notes;
  return result;
}

/// Every size's files, coarse or fine first, or every repeat's.
std::vector<Read> read_all(const ScoreOptions& options, const std::vector<WantedTable>& wanted,
                           const ColumnNames& renamed) {
  const std::size_t blocks = std::max<std::size_t>(options.sizes.size(), options.repeats);
  const std::size_t each = options.data.size() / blocks;
  std::vector<Read> all;
  for (std::size_t k = 0; k < blocks; ++k) {
    const auto first = options.data.begin() + static_cast<std::ptrdiff_t>(k * each);
    all.push_back(read(options, {first, first + static_cast<std::ptrdiff_t>(each)}, wanted, renamed));
  }
  return all;
}

std::optional<validation::Ladder> ladder_of(const ScoreOptions& options, const std::vector<WantedTable>& wanted,
                                            const std::vector<Read>& all) {
  if (options.sizes.empty()) return std::nullopt;
  std::vector<validation::Rung> rungs;
  for (std::size_t k = 0; k < all.size(); ++k) {
    rungs.push_back({.size = options.sizes[k],
                     .seconds = options.seconds.empty() ? std::nullopt : std::optional(options.seconds[k]),
                     .submitted = all[k].submitted});
  }
  return validation::ladder_of(wanted, std::move(rungs));
}

/// The mean of several runs in the place of the first, where there are several.
std::optional<validation::Repeats> repeats_of(const ScoreOptions& options, std::vector<Read>& all) {
  if (options.repeats == 1) return std::nullopt;
  std::vector<validation::Submitted> runs;
  for (const Read& one : all) runs.push_back(one.submitted);
  validation::Repeats repeats = validation::repeats_of(runs);
  all.front().submitted = repeats.mean;
  return repeats;
}

/// The baseline, read before this score is written; none where this is to be the first.
std::optional<evidence::Summary> read_baseline(const ScoreOptions& options, const evidence::Record& record) {
  if (options.baseline.empty()) return std::nullopt;
  if (fs::weakly_canonical(fs::path(options.baseline) / "") == fs::weakly_canonical(fs::path(options.out) / ""))
    fail("--baseline {}: is --out, must be another folder", options.baseline);
  const fs::path kept = fs::path(options.baseline) / (record.stem() + ".json");
  std::string why = fmt::format("has no {}", kept.filename().string());
  if (fs::is_regular_file(kept)) {
    evidence::Summary before = evidence::read_summary(kept);
    why = validation::unlike(before, record);
    if (why.empty()) return before;
  }
  if (options.bless) return std::nullopt;
  fail("--baseline {}: {}: --bless makes this score the baseline", options.baseline, why);
}

/// Tells what changed since the baseline; with --bless, makes the record the baseline. Returns whether anything is
/// worse.
bool compare_with_baseline(const ScoreOptions& options, const std::string& stem,
                           const std::optional<evidence::Summary>& before, std::vector<std::string>& told) {
  const fs::path written = fs::path(options.out) / (stem + ".json");
  const fs::path kept = fs::path(options.baseline) / (stem + ".json");
  bool worse = false;
  if (before) {
    for (const validation::Since& one : validation::changes_since(*before, evidence::read_summary(written))) {
      using Kind = validation::Since::Kind;
      const char* kind = one.kind == Kind::worse             ? "WORSE"
                         : one.kind == Kind::unexpected_pass ? "unexpected pass"
                                                             : "changed";
      told.push_back(fmt::format("  {:<15} {}: {}", kind, one.claim, one.words));
      worse = worse || one.kind == Kind::worse;
    }
    told.push_back(fmt::format("baseline {}: {}", kept.string(), worse ? "something got worse" : "nothing got worse"));
  }
  if (!options.bless) return worse;
  fs::create_directories(options.baseline);
  for (const char* extension : {".h5", ".xdmf", ".json"}) {
    const fs::path from = fs::path(options.out) / (stem + extension);
    const fs::path to = fs::path(options.baseline) / (stem + extension);
    if (fs::is_regular_file(from)) io::write_file(to, io::read_file(from));
  }
  told.push_back(fmt::format("baseline {}: is this score now", kept.string()));
  return false;
}

/// Keeps what was judged: the checksum of every file, of a folder that of its files' checksums.
void note_files(const std::vector<validation::ResultFile>& files, evidence::Record& record) {
  for (const validation::ResultFile& file : files) {
    if (file.files.empty()) continue;
    std::string all;
    for (const auto& part : file.files) all += evidence::sha256_of_file(part);
    record.reference_data[file.path.string()] = file.files.size() > 1 ? evidence::sha256(all) : all;
  }
}

/// What was understood of files that are not our own kind.
void print_reading(const Read& read) {
  for (const validation::ResultFile& file : read.files) {
    if (file.format == "hdf5" && !io::has_checksums(file.path)) {
      fmt::print("  {:<12} {}: carries no checksums (Fletcher32): damage to its numbers would not be seen\n", "read",
                 printable(file.path.string()));
    }
    if (file.format == "csv" || file.format == "hdf5") continue;
    fmt::print("  {:<12} {}: {}, columns {}\n", "read", printable(file.table.source), file.format,
               printable(fmt::format("{}", fmt::join(file.table.names, ", "))));
  }
  for (const std::string& note : read.notes) fmt::print("  {:<12} {}\n", "read", printable(note));
}

/// As reports/schema/score.schema.json says.
Json as_json(const std::vector<Read>& all, const evidence::Record& record, const std::vector<Finding>& findings,
             const validation::FirstLook& look, const std::string& written) {
  Json notes = Json::array();
  for (const Read& read : all) {
    for (const std::string& note : read.notes) notes.push_back(printable(note));
  }
  Json diagnosis = Json::array();
  for (const Finding& one : findings) diagnosis.push_back({{"where", one.where}, {"finding", one.words}});
  Json summary = Json::object();
  for (const auto& [question, answer] : look) summary[question] = answer;
  return {{"verdict", record.as_declared() ? "pass" : "fail"},
          {"summary", summary},
          {"diagnosis", diagnosis},
          {"notes", notes},
          {"record", Json::parse(io::read_file(written))}};
}

}  // namespace

int score(const ScoreOptions& options) {
  const Case& one = validation::find_case(options.name);
  if (!one.submission) fail("score: case {} does not score others: 'seiche list' shows which do", one.name);
  const Values values = values_for(one, validation::Tier::quick, options.config, options.settings);
  std::vector<WantedTable> wanted = one.submission.tables(values);
  if (options.template_only) return print_template(one, wanted, options.table);
  if (options.resolving_power) return print_power(one, values, wanted, options.json);
  if (options.data.empty()) fail("score: --data FILE is missing (or --template)");
  require_valid(options);
  const ColumnNames renamed = column_names(one, wanted, options.map);
  auto uncertainty = uncertainties(one, wanted, options.uncertainty);

  evidence::Record record = validation::Job{&one, values}.blank_record();
  record.solver = options.solver;
  const std::optional<evidence::Summary> baseline = read_baseline(options, record);
  if (!options.table.empty()) {
    const WantedTable alone = table_named(wanted, options.table);
    for (const WantedTable& table : wanted) {
      if (table.name != alone.name)
        validation::leave_out(table, fmt::format("--table {} asks for that table alone", alone.name), record);
    }
    wanted = {alone};
  }
  std::vector<Read> all = read_all(options, wanted, renamed);
  const std::vector<WantedTable> asked = wanted;
  for (const Read& read : all) wanted = validation::given_of(wanted, read.submitted);
  const std::optional<validation::Ladder> ladder = ladder_of(options, wanted, all);
  if (ladder) validation::add_numerical(*ladder, uncertainty);
  const std::optional<validation::Repeats> repeats = repeats_of(options, all);
  if (repeats) validation::add_scatter(*repeats, uncertainty);
  const Read& judged = all[finest_of(options.sizes)];
  for (const Read& read : all) note_files(read.files, record);
  std::vector<Finding> findings;
  validation::FirstLook look;
  const validation::SolverFacts facts = facts_of(options, uncertainty);
  try {
    validation::score(asked, judged.submitted, uncertainty, record);
    if (one.submission.judge) one.submission.judge(values, judged.submitted, facts, record);
    validation::judge_history(one.phenomenon, judged.history, record);
    const bool shift_fitted = record.measurements().contains("time_shift");
    findings = validation::diagnosis(wanted, judged.submitted, shift_fitted);
    validation::show_diagnosis(findings, record);
    if (ladder) validation::show_ladder(*ladder, record);
    if (repeats) validation::show_repeats(*repeats, record);
    look = validation::first_look(wanted, judged.submitted, record, findings, ladder);
    if (const std::string rank = validation::rank(record); !rank.empty()) {
      look.insert(look.begin() + 1, {"rank", rank});
    }
    validation::show_first_look(look, record);
  } catch (const std::invalid_argument& wrong) {
    fail("{}: {}", fmt::join(options.data, ", "), wrong.what());
  }
  record.wall_time = facts.seconds.value_or(0);  // of the solver's run: how long the scoring took is nobody's business
  if (facts.cell) record.measure("cell_size", *facts.cell);
  if (options.threads > 0) record.measure("threads", static_cast<double>(options.threads));
  {
    const evidence::RecordLock alone(options.out, record.stem());
    evidence::write(record, options.out);
  }
  evidence::write_junit(options.out);
  const std::string written = (std::filesystem::path(options.out) / (record.stem() + ".json")).string();
  std::vector<std::string> since;
  const bool worse = !options.baseline.empty() && compare_with_baseline(options, record.stem(), baseline, since);
  if (options.json) {
    auto json = as_json(all, record, findings, look, written);
    if (!since.empty()) json["baseline"] = since;
    fmt::print("{}\n", json.dump(1));
  } else {
    for (const Read& read : all) print_reading(read);
    print(record, findings, look);
    fmt::print("record: {}\n", written);
    for (const std::string& line : since) fmt::print("{}\n", line);
  }
  if (!options.baseline.empty()) return worse ? 1 : 0;
  return record.as_declared() ? 0 : 1;
}

}  // namespace seiche::command
