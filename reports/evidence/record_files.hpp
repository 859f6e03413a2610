#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"

namespace seiche::evidence {

/// The record as JSON text; its form is reports/schema/record.schema.json.
/// @param digests  SHA-256 of the files beside it, by name
std::string to_json(const Record& record, const std::map<std::string, std::string>& digests = {});

/// Writes `<stem>.h5` (and `<stem>.xdmf` where the record has snapshots), then `<stem>.json`, which carries their
/// digests and its own (seal.hpp). Each appears whole; where the last of them is missing, the digests tell.
void write(const Record& record, const std::filesystem::path& directory);

/// What a later run or a summary needs of a written record.
struct Summary {
  struct Outcome {
    std::string id;
    std::string text;
    std::string unit;
    std::string resolution;
    std::string kind;  ///< of the criterion
    std::string verdict;
    std::string declared;
    std::string declared_reason;
    std::string note;
    bool as_declared = false;
    double measured = 0;
    double uncertainty = 0;  ///< NaN: not estimated
    double limit = 0;
    double expected = 0;
    double band = 0;  ///< half-width of the band in which a failure is declared; NaN where none is
  };
  std::string name;
  std::string kind;
  std::string group;
  std::string tier;
  std::string set;        ///< the published set that it ran with, where that is not the tier's defaults
  std::string shows;      ///< a published set that it is equal to, empty if none
  bool standard = false;  ///< the parameters are the tier's defaults or those of `set`
  std::string solver;
  std::string error;    ///< why it did not finish, or that the file is not the one that was written
  bool sealed = false;  ///< carries its digest, so that a change would be seen
  std::string fingerprint;
  std::string commit;  ///< of the program that wrote the record; "-dirty" after it for uncommitted changes
  std::string date;    ///< ISO 8601
  double wall_time = 0;
  std::map<std::string, Scalar> parameters;
  std::vector<Outcome> claims;
  std::map<std::string, double> measurements;
  std::map<std::string, std::string> reference_data;
  std::map<std::string, std::string> files;  ///< digests of those beside it

  [[nodiscard]] bool as_declared() const;
  [[nodiscard]] std::string stem() const { return stem_of(name, set, tier, solver); }
};

/// Gives a written record another article, where it has not this one: the text decides no number.
void refresh_article(const std::filesystem::path& json_file, const std::string& article);

/// Which of a record's files are looked at: those beside the JSON may hold many numbers.
enum class Reading { json, all_files };
/// Reads a record back. What was changed since it was written reads as a run that did not finish, for that reason.
/// Words of the record are printable.
/// @throws std::runtime_error naming the file when it is not a record.
Summary read_summary(const std::filesystem::path& json_file, Reading reading = Reading::json);
/// All JSON files of a directory, sorted by name.
std::vector<std::filesystem::path> record_files(const std::filesystem::path& directory);
/// All records of a directory, in that order. A file that is not a record is an error naming it.
std::vector<Summary> read_summaries(const std::filesystem::path& directory, Reading reading = Reading::json);

/// Writes junit.xml over all records of a directory, in the form that CI systems read: a test suite per record with
/// totals, in it a test case `run` (did it finish, in what time) and one per claim with what was measured as
/// properties. A JSON file that is no record is a suite whose `run` is an error.
///
/// | verdict                                | test case                                        |
/// |----------------------------------------|--------------------------------------------------|
/// | pass, as declared                      | passed                                           |
/// | fail or inconclusive, as declared      | skipped, with the measured value and the reason  |
/// | fail outside its declared band,        |                                                  |
/// | fail, inconclusive, an undeclared pass | failure of that type                             |
/// | error, or the run did not finish       | error                                            |
void write_junit(const std::filesystem::path& directory);

}  // namespace seiche::evidence
