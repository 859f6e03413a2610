/// Evidence of record: what the released code measures, claim by claim, in a table that a diff can be read of.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "reports/evidence/record_files.hpp"

namespace seiche::evidence {

/// One claim of one run. No times, machines or commits: what differs has changed.
struct RecordedClaim {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string name;  ///< of the case or check
  std::string set;   ///< the published set that the run shows, empty if none
  std::string claim;
  std::string kind;           ///< of the criterion
  double measured = none;     ///< NaN: not measured
  double uncertainty = none;  ///< NaN: not estimated
  double expected = none;
  double limit = none;
  double band = none;  ///< half-width of the band in which a failure is declared; NaN where none is
  std::string verdict;
};

/// The claims of finished and unfinished records, sorted. A record that did not finish has a claim `run` besides.
std::vector<RecordedClaim> recorded_claims(const std::vector<Summary>& records);

/// By case, set and claim.
void sort(std::vector<RecordedClaim>& claims);

/// CSV with a header. A number has as many digits as tell a thousandth of its claim's limit; at least six (of a
/// round-off, three).
std::string to_csv(const std::vector<RecordedClaim>& claims);

/// @throws std::runtime_error naming file and line
std::vector<RecordedClaim> read_recorded_claims(const std::filesystem::path& csv_file);

/// What differs, one sentence each with the claim in front: verdicts, limits, claims that came or went, and measured
/// values that moved by more than
///
///     sqrt(u1^2 + u2^2) + s limit,
///
/// with the uncertainties u of both; s = 1 for a claim of round-off, whose limit says how far rounding can move it, and
/// otherwise s = `moved_share`. Of a declared failure the band stands in place of the limit. An uncertainty that
/// appears or vanishes has changed; one that grew or shrank, when by more than a factor `uncertainty_grown` and by more
/// than s limit: an inflated one would hide that the value moved.
std::vector<std::string> changes(const std::vector<RecordedClaim>& before, const std::vector<RecordedClaim>& after);

/// Another processor rounds differently, and flows that amplify roundings (particles in a breaking wave) then end
/// elsewhere within their scatter. A limit has to be several times that scatter, or its verdict would be chance.
inline constexpr double moved_share = 0.1;

/// Estimates of uncertainty rest on few points and scatter by some ten percent: this is another estimate.
inline constexpr double uncertainty_grown = 1.5;

}  // namespace seiche::evidence
