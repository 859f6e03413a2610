#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "reports/evidence/evidence_of_record.hpp"
#include "seiche/io/atomic_file.hpp"
#include "validation/case/data_folder.hpp"
#include "validation/case/registry.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"

namespace seiche::command {
namespace {

using evidence::Summary;
using validation::Job;
using validation::Tier;

/// Our own records of a tier in a folder, without those that only an optional library makes.
std::vector<Summary> records_of(Tier tier, const std::string& directory) {
  std::vector<Summary> records = evidence::read_summaries(directory, evidence::Reading::all_files);
  std::erase_if(records, [&](const Summary& one) {
    return one.tier != name(tier) || one.solver != "seiche" || one.group == "distributed";
  });
  if (records.empty()) fail("folder {} holds no record of tier {}", directory, name(tier));
  return records;
}

/// Sentences about records with other parameters than the tier's.
std::vector<std::string> not_standard(const std::vector<Summary>& records) {
  std::vector<std::string> found;
  for (const Summary& one : records) {
    if (!one.standard)
      found.push_back(fmt::format("{}: parameters differ from the defaults of the test level; not usable as a baseline",
                                  one.stem()));
  }
  return found;
}

std::vector<Job> jobs_of(Tier tier) {
  std::vector<Job> jobs;
  for (const validation::Case& one : validation::all_cases()) {
    for (const validation::Values& values : one.runs_of(tier)) jobs.push_back({&one, values});
  }
  return jobs;
}

/// Sentences about what the tier needs and the folder has not, or has with other parameters. A longer tier may come in
/// parts: of it, what is there is asked for alone.
std::vector<std::string> gaps(Tier tier, const std::string& directory, const std::vector<Summary>& records) {
  std::vector<std::string> found = not_standard(records);
  for (const Job& job : jobs_of(tier)) {
    const bool asked = tier == Tier::quick || std::ranges::find(records, job.stem(), &Summary::stem) != records.end();
    if (asked && !validation::is_done(job, directory))
      found.push_back(fmt::format("{}: no finished record of this program", job.stem()));
  }
  return found;
}

/// Without what no run of the tier makes any more.
std::vector<Summary> current(Tier tier, std::vector<Summary> records) {
  std::set<std::string> stems;
  for (const Job& job : jobs_of(tier)) stems.insert(job.stem());
  std::erase_if(records, [&](const Summary& one) { return one.kind == "validation" && !stems.contains(one.stem()); });
  return records;
}

using Run = std::pair<std::string, std::string>;  ///< case and published set

std::set<Run> runs_in(const std::vector<evidence::RecordedClaim>& claims) {
  std::set<Run> runs;
  for (const evidence::RecordedClaim& one : claims) runs.emplace(one.name, one.set);
  return runs;
}

/// Drops the claims of runs that `now` has not; returns how many.
std::size_t drop_others(std::vector<evidence::RecordedClaim>& before, const std::vector<evidence::RecordedClaim>& now) {
  return std::erase_if(before, [runs = runs_in(now)](const evidence::RecordedClaim& one) {
    return !runs.contains({one.name, one.set});
  });
}

/// Adds the claims that the file has of other runs which the tier still makes.
void keep_others(Tier tier, const std::filesystem::path& file, std::vector<evidence::RecordedClaim>& claims) {
  if (!std::filesystem::is_regular_file(file)) return;
  std::set<Run> kept;
  for (const validation::Case& one : validation::all_cases()) {
    if (one.runs_of(tier).empty()) continue;
    kept.emplace(one.name, "");
    for (const validation::Published& set : one.published) kept.emplace(one.name, set.name());
  }
  for (const Run& run : runs_in(claims)) kept.erase(run);
  for (evidence::RecordedClaim& one : evidence::read_recorded_claims(file)) {
    if (kept.contains({one.name, one.set})) claims.push_back(std::move(one));
  }
  evidence::sort(claims);
}

/// A row of every run of a longer tier: the commit that ran it, the day, what it took.
void note_runs(Tier tier, const std::filesystem::path& file, const std::vector<Summary>& records,
               const std::set<Run>& runs) {
  constexpr std::string_view header = "tier,case,set,commit,date,seconds";
  std::map<std::string, std::string> rows;  // by tier, case and set
  const auto key = [](std::string_view level, const Run& run) {
    return fmt::format("{},{},{}", level, run.first, run.second);
  };
  std::set<std::string> known;
  for (const Run& run : runs) known.insert(key(name(tier), run));
  if (std::filesystem::is_regular_file(file)) {
    std::istringstream lines(io::read_file(file));
    for (std::string line; std::getline(lines, line);) {
      const auto third = line.find(',', line.find(',', line.find(',') + 1) + 1);
      const std::string place = line.substr(0, third);
      if (line != header && (known.contains(place) || !place.starts_with(name(tier)))) rows[place] = line;
    }
  }
  for (const Summary& one : records) {
    const std::string place = key(name(tier), {one.name, one.shows});
    rows[place] = fmt::format("{},{:.8}{},{:.10},{:.0f}", place, one.commit,
                              one.commit.ends_with("-dirty") ? "-dirty" : "", one.date, one.wall_time);
  }
  std::string csv = fmt::format("{}\n", header);
  for (const auto& [place, row] : rows) csv += row + "\n";
  io::write_file(file, csv);
}

std::filesystem::path file_of(Tier tier, const std::string& chosen) {
  return chosen.empty() ? validation::data_folder("record") / fmt::format("{}.csv", name(tier))
                        : std::filesystem::path(chosen);
}

}  // namespace

int record(const RecordOptions& options) {
  const Tier tier = tier_from(options.tier);
  const std::vector<Summary> records = current(tier, records_of(tier, options.evidence));
  const std::vector<std::string> missing = gaps(tier, options.evidence, records);
  if (!missing.empty()) {
    for (const std::string& one : missing) fmt::print(stderr, "  {}\n", one);
    throw std::runtime_error(
        fmt::format("record: {} cannot become the baseline of tier {}: 'seiche run --tier {} --resume --out {}'",
                    options.evidence, options.tier, options.tier, options.evidence));
  }
  auto claims = evidence::recorded_claims(records);
  const std::filesystem::path file = file_of(tier, options.out);
  if (tier != Tier::quick) {
    keep_others(tier, file, claims);
    note_runs(tier, file.parent_path() / "long_runs.csv", records, runs_in(claims));
  }
  io::write_file(file, evidence::to_csv(claims));
  fmt::print("{}: {} claims, {} runs written anew\n", file.string(), claims.size(), records.size());
  return 0;
}

int compare_with_record(const CompareOptions& options) {
  const Tier tier = tier_from(options.tier);
  const std::filesystem::path file = file_of(tier, options.after);
  if (!std::filesystem::is_regular_file(file)) {
    fail("compare --record: no baseline {}", file.string());
  }
  const std::vector<Summary> records = records_of(tier, options.before);
  std::vector<std::string> changed = not_standard(records);
  const auto now = evidence::recorded_claims(records);
  std::vector<evidence::RecordedClaim> before = evidence::read_recorded_claims(file);
  const std::size_t left_out = options.whole ? 0 : drop_others(before, now);
  std::ranges::move(evidence::changes(before, now), std::back_inserter(changed));
  for (const std::string& change : changed) fmt::print("  {}\n", change);
  fmt::print("{} claims, {} changed from {}\n", now.size(), changed.size(), file.string());
  if (left_out > 0) fmt::print("{} claims of other runs not compared; --whole asks for them\n", left_out);
  if (!changed.empty())
    fmt::print("where the changes are meant, 'ci/checks/record {}' makes them the new record\n", options.tier);
  return changed.empty() ? 0 : 1;
}

}  // namespace seiche::command
