#include "reports/evidence/evidence_of_record.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "seiche/io/atomic_file.hpp"

namespace seiche::evidence {
namespace {

constexpr std::string_view header = "case,set,claim,kind,measured,uncertainty,expected,limit,band,verdict";
constexpr std::size_t columns = 10;

auto key(const RecordedClaim& claim) {
  return std::tie(claim.name, claim.set, claim.claim);
}

std::string place(const RecordedClaim& claim) {
  return fmt::format("{}{}{} {}", claim.name, claim.set.empty() ? "" : "@", claim.set, claim.claim);
}

/// What tells one value of a claim from another: its limit, or the band in which it is declared to fail.
double scale(const RecordedClaim& claim) {
  return std::isnan(claim.band) ? claim.limit : std::max(claim.limit, claim.band);
}

std::string text(double value, int digits) {
  return std::isnan(value) ? "" : fmt::format("{:.{}g}", value, digits);
}

/// A measured or expected value.
std::string value_text(double value, const RecordedClaim& claim) {
  const int fewest = claim.kind == "roundoff" ? 3 : 6;
  constexpr int all = 17;
  if (value == 0 || !(scale(claim) > 0)) return text(value, all);
  const double needed = std::ceil(std::log10(std::abs(value) / scale(claim))) + 3;
  return text(value, static_cast<int>(std::clamp<double>(needed, fewest, all)));
}

std::string verdict_of(const Summary::Outcome& claim) {
  if (claim.as_declared)
    return claim.declared == claim.verdict && claim.verdict != "pass" ? "declared " + claim.verdict : claim.verdict;
  return claim.verdict == claim.declared ? claim.verdict + " outside its band"
         : claim.verdict == "pass"       ? "undeclared pass"
                                         : claim.verdict;
}

double number(std::string_view cell, const std::filesystem::path& file, std::size_t line) {
  double value = RecordedClaim::none;
  if (cell.empty()) return value;
  const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (failure != std::errc() || end != cell.data() + cell.size()) {
    throw std::runtime_error(fmt::format("{}: line {}: '{}' is not a number", file.string(), line, cell));
  }
  return value;
}

/// What rounding on another machine may move, of the limit or the band.
double share_of_limit(const RecordedClaim& before, const RecordedClaim& after) {
  return (after.kind == "roundoff" ? 1 : moved_share) * std::max(scale(before), scale(after));
}

/// Which values are as good as the one before.
double allowance(const RecordedClaim& before, const RecordedClaim& after) {
  const auto known = [](double uncertainty) { return std::isnan(uncertainty) ? 0 : uncertainty; };
  return std::hypot(known(before.uncertainty), known(after.uncertainty)) + share_of_limit(before, after);
}

/// Neither is the same NaN as the other.
bool apart(double a, double b, double allowed) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) != std::isnan(b);
  return !(std::abs(a - b) <= allowed);
}

/// Whether an uncertainty came, went, or is another than before: a value could move behind it unseen.
bool is_another_uncertainty(const RecordedClaim& before, const RecordedClaim& after) {
  const auto [less, more] = std::minmax(before.uncertainty, after.uncertainty);
  return apart(before.uncertainty, after.uncertainty, share_of_limit(before, after)) &&
         (std::isnan(less) || std::isnan(more) || more > uncertainty_grown * less);
}

void add_changes(const RecordedClaim& before, const RecordedClaim& after, std::vector<std::string>& found) {
  const auto add = [&](const std::string& what) { found.push_back(fmt::format("{}: {}", place(after), what)); };
  constexpr double noticed = 0.01;  ///< of a limit that the run tells: it counts steps, or measures a scale
  if (before.verdict != after.verdict) add(fmt::format("verdict {} -> {}", before.verdict, after.verdict));
  if (before.kind != after.kind) add(fmt::format("criterion {} -> {}", before.kind, after.kind));
  if (apart(before.limit, after.limit, noticed * before.limit)) {
    add(fmt::format("limit {:.6g} -> {:.6g}", before.limit, after.limit));
  }
  if (apart(before.band, after.band, noticed * before.band)) {
    add(fmt::format("band {:.6g} -> {:.6g}", before.band, after.band));
  }
  if (is_another_uncertainty(before, after)) {
    const auto known = [](double value) { return std::isnan(value) ? "none" : fmt::format("{:.3g}", value); };
    add(fmt::format("uncertainty {} -> {}", known(before.uncertainty), known(after.uncertainty)));
  }
  const double allowed = allowance(before, after);
  for (const auto& [what, from, to] : {std::tuple("measured", before.measured, after.measured),
                                       std::tuple("expected", before.expected, after.expected)}) {
    if (apart(from, to, allowed)) add(fmt::format("{} {:.6g} -> {:.6g}, allowed {:.2g}", what, from, to, allowed));
  }
}

}  // namespace

std::vector<RecordedClaim> recorded_claims(const std::vector<Summary>& records) {
  std::vector<RecordedClaim> claims;
  for (const Summary& record : records) {
    if (!record.error.empty()) {
      claims.push_back({.name = record.name, .set = record.shows, .claim = "run", .kind = "", .verdict = "error"});
    }
    for (const Summary::Outcome& one : record.claims) {
      claims.push_back({.name = record.name,
                        .set = record.shows,
                        .claim = one.id,
                        .kind = one.kind,
                        .measured = one.measured,
                        .uncertainty = one.uncertainty,
                        .expected = one.expected,
                        .limit = one.limit,
                        .band = one.band,
                        .verdict = verdict_of(one)});
    }
  }
  sort(claims);
  return claims;
}

void sort(std::vector<RecordedClaim>& claims) {
  std::sort(claims.begin(), claims.end(), [](const auto& a, const auto& b) { return key(a) < key(b); });
}

std::string to_csv(const std::vector<RecordedClaim>& claims) {
  std::string csv = fmt::format("{}\n", header);
  for (const RecordedClaim& c : claims) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", c.name, c.set, c.claim, c.kind, value_text(c.measured, c),
                       text(c.uncertainty, 3), value_text(c.expected, c), text(c.limit, 6), text(c.band, 6), c.verdict);
  }
  return csv;
}

std::vector<RecordedClaim> read_recorded_claims(const std::filesystem::path& csv_file) {
  std::istringstream lines(io::read_file(csv_file));
  std::string line;
  if (!std::getline(lines, line) || line != header) {
    throw std::runtime_error(fmt::format("{}: line 1: must be '{}'", csv_file.string(), header));
  }
  std::vector<RecordedClaim> claims;
  for (std::size_t row = 2; std::getline(lines, line); ++row) {
    std::vector<std::string> cells{""};
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    if (cells.size() != columns) {
      throw std::runtime_error(
          fmt::format("{}: line {}: {} entries, must be {}", csv_file.string(), row, cells.size(), columns));
    }
    const auto at = [&](std::size_t column) { return number(cells[column], csv_file, row); };
    claims.push_back({.name = cells[0],
                      .set = cells[1],
                      .claim = cells[2],
                      .kind = cells[3],
                      .measured = at(4),
                      .uncertainty = at(5),
                      .expected = at(6),
                      .limit = at(7),
                      .band = at(8),
                      .verdict = cells[9]});
  }
  return claims;
}

std::vector<std::string> changes(const std::vector<RecordedClaim>& before, const std::vector<RecordedClaim>& after) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, const RecordedClaim*> old;
  for (const RecordedClaim& claim : before) old.emplace(key(claim), &claim);
  std::vector<std::string> found;
  for (const RecordedClaim& claim : after) {
    const auto was = old.find(Key(key(claim)));
    if (was == old.end()) {
      found.push_back(fmt::format("{}: new, {}", place(claim), claim.verdict));
      continue;
    }
    add_changes(*was->second, claim, found);
    old.erase(was);
  }
  for (const auto& [gone, claim] : old) found.push_back(fmt::format("{}: no longer there", place(*claim)));
  return found;
}

}  // namespace seiche::evidence
