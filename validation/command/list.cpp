#include <map>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "reports/evidence/build_facts.hpp"
#include "seiche/exact/catalogue.hpp"
#include "seiche/io/atomic_file.hpp"
#include "validation/case/data_folder.hpp"
#include "validation/case/registry.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"
#include "validation/scoring/resolving_power.hpp"
#include "validation/scoring/submitted.hpp"

namespace seiche::command {
namespace {

using validation::Case;
using validation::Parameter;
using validation::Tier;
using Json = nlohmann::ordered_json;

std::vector<std::string> tiers_of(const Case& one) {
  std::vector<std::string> names;
  for (const Tier tier : one.tiers) names.emplace_back(name(tier));
  return names;
}

Json to_json(const validation::Value& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json to_json(const Case& one, const validation::Published& set) {
  Json values = Json::object();
  Json origins = Json::object();
  const validation::Values chosen = one.values(set);
  for (const auto& [name, value] : chosen.all()) {
    values[name] = to_json(value);
    origins[name] = set.origin(name);
  }
  return {{"tiles", set.tiles},
          {"tier", name(set.tier)},
          {"values", values},
          {"origins", origins},
          {"different", set.different},
          {"differs", set.differs},
          {"contradicted", set.contradicted}};
}

Json to_json(const Parameter& p) {
  Json json = {{"name", p.name},
               {"unit", p.unit},
               {"meaning", p.meaning},
               {"default",
                {{"quick", to_json(p.standard.quick)},
                 {"full", to_json(p.standard.full)},
                 {"paper", to_json(p.standard.paper)}}},
               {"range", p.range()}};
  if (!p.choices.empty()) {
    json["choices"] = p.choices;
  } else if (!std::holds_alternative<bool>(p.standard.quick)) {
    json["lowest"] = p.lowest;
    json["highest"] = p.highest;
  }
  return json;
}

/// What a case takes from others, with the files of an experiment.
Json tables_of(const Case& one) {
  Json tables = Json::object();
  if (!one.submission) return tables;
  for (const validation::WantedTable& table : one.submission.tables(one.values(Tier::quick))) {
    Json columns = Json::object();
    for (const validation::Column& column : validation::columns_of(table)) columns[column.name] = column.unit;
    Json files = Json::array();
    for (const std::string& reference : *table.exact) {
      const std::string folder = "reference_data/";
      if (!reference.starts_with(folder)) continue;
      files.push_back((validation::data_folder("reference_data") / reference.substr(folder.size())).string());
    }
    tables[table.name] = {{"columns", columns}, {"files", files}};
  }
  return tables;
}

void print_json() {
  Json cases = Json::array();
  for (const Case& one : validation::all_cases()) {
    Json parameters = Json::array();
    for (const Parameter& p : one.parameters) parameters.push_back(to_json(p));
    Json published = Json::array();
    for (const validation::Published& set : one.published) published.push_back(to_json(one, set));
    cases.push_back({{"name", one.name},
                     {"phenomenon", one.phenomenon},
                     {"title", one.title},
                     {"source", one.source},
                     {"tiers", tiers_of(one)},
                     {"atlas", one.atlas},
                     {"scores", static_cast<bool>(one.submission)},
                     {"tables", tables_of(one)},
                     {"parameters", parameters},
                     {"published", published}});
  }
  Json solutions = Json::array();
  for (const exact::ExactSolution& s : exact::catalogue()) {
    solutions.push_back({{"name", s.name}, {"title", s.title}, {"citation", s.citation}});
  }
  fmt::print("{}\n", Json{{"cases", cases}, {"exact", solutions}}.dump(2));
}

void print_table() {
  std::string phenomenon;
  for (const Case& one : validation::all_cases()) {
    if (one.phenomenon != phenomenon) fmt::print("\n{}\n", phenomenon = one.phenomenon);
    fmt::print("  {:<28} {:<17} {}\n  {:<28} {:<17} {}\n", one.name, fmt::format("{}", fmt::join(tiers_of(one), " ")),
               one.title, "", one.submission ? "scores others" : "", one.source);
    const auto sets = one.published | std::views::transform(&validation::Published::name);
    if (!sets.empty()) fmt::print("  {:<28} {:<17} --as {}\n", "", "", fmt::join(sets, ", "));
  }
  fmt::print("\nexact solutions (seiche exact NAME)\n");
  for (const exact::ExactSolution& s : exact::catalogue()) {
    fmt::print("  {:<28} {}\n  {:<28} {}\n", s.name, s.title, "", s.citation);
  }
  fmt::print("\n'seiche run CASE --help-parameters' lists the parameters of a case.\n");
}

/// Every tile with its word, the case, the tier and the parameters that show it as its source did.
void print_published() {
  // The words of the baseline results by the report's rule (reports/render/atlas.py).
  const Json words = Json::parse(io::read_file(validation::data_folder("record") / "tiles.json"));
  for (const Case& one : validation::all_cases()) {
    for (const validation::Published& set : one.published) {
      fmt::print("seiche run {} --as {}\n  tier {}\n", one.name, set.name(), name(set.tier));
      for (const std::string& tile : set.tiles) {
        fmt::print("  {:<20} {}\n", tile, words.at(one.name).at(tile).get<std::string>());
      }
      const validation::Values run = one.values(set);
      std::map<std::string, std::vector<std::string>> by_origin;
      for (const auto& [name, value] : run.all()) {
        const std::string text = std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
        const auto theirs = set.different.find(name);
        by_origin[set.origin(name)].push_back(
            fmt::format("{} = {}{}", name, text,
                        theirs == set.different.end() ? "" : fmt::format(" (source: {})", theirs->second)));
      }
      for (const auto& [origin, values] : by_origin) fmt::print("  {}: {}\n", origin, fmt::join(values, ", "));
      if (!set.differs.empty()) fmt::print("  method differs from the source: {}\n", set.differs);
    }
  }
}

/// The comparison of a tier's evidence with that of record, after all that makes it. The record is that of a release
/// build: others round differently.
std::string record_tests(const std::string& program, const std::string& evidence) {
  std::string text;
  if (build_facts::build_type != "Release") return text;
  for (const Tier tier : {Tier::quick, Tier::full, Tier::paper}) {
    if (!std::filesystem::exists(validation::data_folder("record") / fmt::format("{}.csv", name(tier)))) continue;
    text += fmt::format(
        "if(\";${{seiche_tiers}};\" MATCHES \";{0};\")\n"
        "  add_test([=[record.{0}]=] [=[{1}]=] compare [=[{2}]=] --record --whole --tier {0})\n"
        "  set_tests_properties([=[record.{0}]=] PROPERTIES LABELS \"{0};project\" TIMEOUT 60\n"
        "    FIXTURES_REQUIRED evidence.{0})\n"
        "endif()\n",
        name(tier), program, evidence);
  }
  return text;
}

/// CMake code with an add_test entry per case and run of a tier; `seiche_tiers` is set by the file that ctest reads
/// before.
void write_ctest(const ListOptions& options) {
  const std::string& evidence = options.evidence;
  const std::string program = validation::running_program().string();
  const std::string limit = options.most_seconds > 0 ? fmt::format(" --most-seconds {}", options.most_seconds) : "";
  const std::string skipped = options.most_seconds > 0 ? "SKIP_REGULAR_EXPRESSION \"stopped at its time limit\"" : "";
  std::string text = "# Written by 'seiche list --ctest' after every build.\n";
  for (const Case& one : validation::all_cases()) {
    for (const Tier tier : {Tier::quick, Tier::full, Tier::paper}) {
      for (const validation::Values& values : one.runs_of(tier)) {
        const std::string set = values.set_name();
        text += fmt::format(
            "if(\";${{seiche_tiers}};\" MATCHES \";{0};\")\n"
            "  add_test([=[{1}]=] [=[{2}]=] run {3} {7} --jobs 1 --threads 1{8} --out [=[{4}]=])\n"
            "  set_tests_properties([=[{1}]=] PROPERTIES LABELS \"{0};validation;{5}\" TIMEOUT {6}\n"
            "    FIXTURES_SETUP evidence.{0} {9})\n"
            "endif()\n",
            name(tier), fmt::format("{}.{}.{}", one.phenomenon, one.name, set.empty() ? name(tier) : set), program,
            one.name, evidence, one.phenomenon, one.time_limit.at(tier).count() + 30,
            set.empty() ? fmt::format("--tier {}", name(tier)) : fmt::format("--as {}", set), limit, skipped);
      }
    }
  }
  io::write_file(options.ctest, text + record_tests(program, evidence));
}

/// A case whose data cannot tell a fifth of an amplitude says so.
std::string dull(const std::vector<validation::Resolved>& rows) {
  std::string quantities;
  for (const validation::Resolved& row : rows) {
    if (row.change == "amplitude" && !(row.smallest <= 0.2))
      quantities += fmt::format("{}{}", quantities.empty() ? "; does not detect 20 % of " : ", ", row.quantity);
  }
  return quantities;
}

/// Every case that scores others: its tables with their columns, what to type, and what it can tell.
void print_scores() {
  auto power = validation::recorded_power();
  for (const Case& one : validation::all_cases()) {
    if (!one.submission) continue;
    const std::vector<validation::Resolved>& rows = power[one.name];
    const auto print_power = [&](const std::string& table, const std::string& quantity) {
      const std::string told = validation::told_by(rows, table, quantity);
      if (!told.empty()) fmt::print("  {:<12} {}\n", "", told);
    };
    const std::vector<validation::WantedTable> wanted = one.submission.tables(one.values(Tier::quick));
    fmt::print("{}: {}{}\n", one.name, one.title, dull(rows));
    for (const validation::WantedTable& table : wanted) {
      std::vector<std::string> columns;
      for (const validation::Column& column : validation::columns_of(table)) {
        columns.push_back(fmt::format("{} [{}]", column.name, column.unit));
      }
      fmt::print("  {:<12} {}\n  {:<12} seiche score {} --template{}\n", table.name, fmt::join(columns, ", "), "",
                 one.name, wanted.size() > 1 ? " --table " + table.name : "");
      for (const validation::WantedQuantity& q : table.quantities) print_power(table.name, q.column.name);
    }
    print_power("", "");
  }
}

std::string text_of(const evidence::Amount& amount) {
  if (amount.stated()) {
    return fmt::format("{:g}{}", amount.value(), amount.capped() ? fmt::format(" (at most {:g})", amount.cap()) : "");
  }
  return fmt::format("at most {:g} (set by the run)", amount.cap());
}

/// The criterion in one line, with what it states beforehand.
std::string text_of(const evidence::Criterion& criterion) {
  struct Describe {
    std::string operator()(const evidence::Roundoff& c) const {
      return fmt::format("{} within round-off of {} operations on numbers of size {}", text_of(c.expected),
                         text_of(c.operations), text_of(c.scale));
    }
    std::string operator()(const evidence::Order& c) const {
      return fmt::format("order {:g} +- {:g}", c.theory, c.tolerance);
    }
    std::string operator()(const evidence::Bound& c) const {
      return fmt::format("{} within {}{}", text_of(c.expected), text_of(c.limit), c.relative ? ", relative" : "");
    }
    std::string operator()(const evidence::Uncertainty& c) const {
      return fmt::format("{} within {:g} u, u_data = {}, u_input = {}, at most {:g}", text_of(c.expected), c.coverage,
                         text_of(c.data), text_of(c.input), c.useful);
    }
    std::string operator()(const evidence::Qualitative& c) const {
      return fmt::format("{} ({})", c.expected ? "seen" : "not seen", c.detector);
    }
  };
  return std::visit(Describe{}, criterion);
}

std::string reason_of(const evidence::Criterion& criterion) {
  return std::visit([](const auto& c) { return c.reason; }, criterion);
}

/// What a case will claim with these settings.
void print_claims(const ListOptions& options) {
  const Case& one = validation::find_case(options.claims);
  const validation::Values values =
      values_for(one, tier_from(options.tier.empty() ? "quick" : options.tier), {}, options.settings);
  Json all = Json::array();
  for (const validation::DeclaredClaim& declared : one.study.claims(values)) {
    const evidence::Claim& claim = declared.claim;
    if (options.json) {
      all.push_back({{"id", claim.id},
                     {"text", claim.text},
                     {"quantity", claim.quantity},
                     {"unit", claim.unit},
                     {"criterion", text_of(declared.criterion)},
                     {"reason", reason_of(declared.criterion)},
                     {"fails", declared.known_failure ? declared.known_failure->reason : ""},
                     {"left_out", declared.left_out}});
      continue;
    }
    fmt::print("{}\n  {}\n  {} [{}]: {}\n  because {}\n", claim.id, claim.text, claim.quantity, claim.unit,
               text_of(declared.criterion), reason_of(declared.criterion));
    if (declared.known_failure) {
      fmt::print("  declared to fail at {:g} +- {:g}: {}\n", declared.known_failure->value,
                 declared.known_failure->width, declared.known_failure->reason);
    }
    if (!declared.left_out.empty()) fmt::print("  does not apply: {}\n", declared.left_out);
  }
  if (options.json) fmt::print("{}\n", all.dump(2));
}

}  // namespace

int list(const ListOptions& options) {
  if (options.claims.empty() && !(options.settings.empty() && options.tier.empty())) {
    fail("list: --tier and --set belong to --claims CASE");
  }
  if (options.json && (options.scores || options.published)) {
    fail("list: --json lists everything: leave out --scores or --published");
  }
  if (!options.ctest.empty()) {
    write_ctest(options);
  } else if (!options.claims.empty()) {
    print_claims(options);
  } else if (options.scores) {
    print_scores();
  } else if (options.published) {
    print_published();
  } else if (options.json) {
    print_json();
  } else {
    print_table();
  }
  return 0;
}

}  // namespace seiche::command
