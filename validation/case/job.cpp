#include "validation/case/job.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/evidence/provenance.hpp"
#include "reports/evidence/record_files.hpp"
#include "seiche/io/hdf5_table.hpp"

namespace seiche::validation {
namespace {

std::string in_words(const evidence::JudgedClaim& claim) {
  const evidence::Judgement& j = claim.judgement;
  if (j.verdict == evidence::Verdict::error) return fmt::format("{}: error, {}", claim.claim.id, j.note);
  return fmt::format("{}: {}, measured {:.6g}, expected {:.6g} within {:.3g}{}{}", claim.claim.id,
                     evidence::name(j.verdict), j.measured, j.expected, j.limit, j.note.empty() ? "" : ", ", j.note);
}

/// Every tile that a record fills has the parameters of its source, and with them all tiles of the set are filled.
/// @throws std::logic_error
void check_tiles(const evidence::Record& record) {
  std::set<std::string> shown(record.atlas.begin(), record.atlas.end());
  for (const auto& figure : record.figures()) shown.insert(figure.atlas.begin(), figure.atlas.end());
  for (const auto& table : record.tables()) shown.insert(table.atlas.begin(), table.atlas.end());
  std::set<std::string> published;
  for (const evidence::PublishedSet& set : record.published) {
    published.insert(set.tiles.begin(), set.tiles.end());
    if (!set.here) continue;
    for (const std::string& tile : set.tiles) {
      if (shown.contains(tile)) continue;
      throw std::logic_error(
          fmt::format("as-published set {} must show figure {}: no figure or table does", set.tiles.front(), tile));
    }
  }
  const auto alone = std::ranges::find_if(shown, [&](const std::string& tile) { return !published.contains(tile); });
  if (alone != shown.end())
    throw std::logic_error(fmt::format("figure {} is shown without an as-published set", *alone));
}

/// The earlier record of a run that is refused now stands aside, lest it be taken for this one's. Returns a sentence.
std::string set_aside(const std::filesystem::path& json_file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(json_file, failure)) return {};
  std::filesystem::path aside = json_file;
  aside += ".earlier";
  std::filesystem::rename(json_file, aside, failure);
  return failure ? "" : fmt::format("; the earlier record is now {}", aside.string());
}

/// @param claims  of the case; none where they cannot be declared
evidence::Record error_record(const Job& job, const std::string& reason, double wall_time,
                              const std::vector<DeclaredClaim>& claims) {
  evidence::Record record = job.blank_record();
  record.error = reason;
  record.wall_time = wall_time;
  fail_all(claims, reason, record);
  return record;
}

}  // namespace

std::string Job::fingerprint() const {
  return evidence::sha256(fmt::format("{}\n{}\n{}\n{}", definition->fingerprint, definition->name, name(values.tier()),
                                      values.canonical()));
}

std::string Job::stem() const {
  return blank_record().stem();
}

evidence::Record Job::blank_record() const {
  evidence::Record record;
  record.name = definition->name;
  record.kind = "validation";
  record.group = definition->phenomenon;
  record.tier = name(values.tier());
  record.title = definition->title;
  record.source = definition->source;
  record.article = definition->article;
  record.atlas = definition->atlas;
  record.set = values.set_name();
  for (const Published& set : values.sets()) {
    const Values as = definition->values(set);
    std::map<std::string, evidence::Scalar> chosen(as.all().begin(), as.all().end());
    std::map<std::string, std::string> origins;
    for (const auto& [parameter, value] : chosen) origins[parameter] = set.origin(parameter);
    record.published.push_back({.tiles = set.tiles,
                                .tier = std::string(name(set.tier)),
                                .values = std::move(chosen),
                                .origins = std::move(origins),
                                .different = set.different,
                                .differs = set.differs,
                                .contradicted = set.contradicted,
                                .here = values.are(set)});
  }
  record.fingerprint = fingerprint();
  for (const Parameter& p : values.declared()) {
    record.parameters[p.name] = {.value = values.all().at(p.name),
                                 .standard = p.standard.at(values.tier()),
                                 .unit = p.unit,
                                 .meaning = p.meaning};
  }
  return record;
}

Ending run_job(const Job& job, const std::filesystem::path& directory, const Keeping& keeping,
               const Run::Progress& progress) {
  evidence::Record record = job.blank_record();
  const auto checkpoints =
      std::make_shared<Checkpoints>(directory / ".checkpoints" / record.stem(), record.fingerprint, keeping);
  const Run run(job.values, progress, checkpoints);
  try {
    job.definition->study.run(run, record);
    check_tiles(record);
  } catch (const std::invalid_argument& refused) {
    // A case that refuses its own parameters is broken, and an older record must not stand for it.
    if (!run.standard()) {
      return {Outcome::wrong_input, fmt::format("{}: {}{}", job.definition->name, refused.what(),
                                                set_aside(directory / (record.stem() + ".json")))};
    }
    record.error = refused.what();
  } catch (const std::exception& failure) {
    record.error = failure.what();
  }
  record.reference_data.merge(std::map(run.tables_read()));
  record.wall_time = checkpoints->seconds();
  try {
    evidence::write(record, directory);
  } catch (const std::exception& failure) {
    return {Outcome::unfinished, failure.what()};
  }
  if (!record.error.empty()) return {Outcome::unfinished, record.error};
  checkpoints->remove_all();
  const std::string notes = fmt::format("{}", fmt::join(checkpoints->notes(), "; "));
  if (record.as_declared()) return {Outcome::as_declared, notes};
  std::string undeclared = notes;
  for (const evidence::JudgedClaim& claim : record.claims()) {
    if (!claim.as_declared()) undeclared += (undeclared.empty() ? "" : "; ") + in_words(claim);
  }
  return {Outcome::failed, undeclared};
}

void write_error_record(const Job& job, const std::filesystem::path& directory, const std::string& reason,
                        double wall_time) {
  constexpr unsigned most_seconds = 10;
  try {
    io::isolated(
        [&] {
          const std::vector<DeclaredClaim> claims = job.definition->study.claims(job.values);
          evidence::write(error_record(job, reason, wall_time, claims), directory);
          return std::string();
        },
        most_seconds);
  } catch (const std::exception& failure) {
    const std::string more = fmt::format("{}; its claims could not be listed: {}", reason, failure.what());
    evidence::write(error_record(job, more, wall_time, {}), directory);
  }
}

bool is_done(const Job& job, const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / (job.stem() + ".json");
  if (!std::filesystem::exists(file)) return false;
  try {
    const evidence::Summary old = evidence::read_summary(file, evidence::Reading::all_files);
    if (!old.sealed || !old.error.empty() || old.fingerprint != job.fingerprint()) return false;
    for (const auto& [table, digest] : old.reference_data) {
      if (evidence::sha256_of_file(table) != digest) return false;
    }
    return true;
  } catch (const std::exception&) {
    return false;  // unreadable is not done
  }
}

}  // namespace seiche::validation
