// Histories of volume, energy and momentum that come with a result.
#include <fmt/format.h>

#include "validation/scoring/conservation.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"
#include "verification/evidence/submissions.hpp"
#include "verification/message_of.hpp"

namespace seiche::verification::conservation_test {

using namespace validation;

/// What is found of a history among files, in a case that asks for a gauge.
History taken(std::vector<io::Table>& files, const ColumnNames& renamed = {}) {
  return take_history(files, {wanted_elevation("gauge", WantedTable::Kind::series, [](Place) { return 0; }, {0, 1})},
                      renamed);
}

/// Verdict of a claim about a history, by phenomenon; "not scored" where it is left out.
std::string verdict(const std::string& phenomenon, const std::string& quantity, const std::vector<double>& values) {
  History history{{quantity, values}};
  for (std::size_t k = 0; k < values.size(); ++k) history["t"].push_back(static_cast<double>(k));
  evidence::Record record;
  judge_history(phenomenon, history, record);
  return record.left_out().empty() ? verdict_of(record, "conserved-" + quantity) : "not scored";
}

std::string refusal(const std::string& text) {
  return message_of([&] {
    std::vector<io::Table> files{file_of(text, "mine.csv")};
    taken(files);
  });
}

TEST_CASE("histories of volume, energy and momentum are assessed by the invariants of the flow", "[evidence]") {
  Check check("conservation_scores", "What a result conserves",
              "Histories that are constant, decrease, increase, or return, in flows that conserve them and in flows "
              "that do not.");
  const auto is = [&](const auto&... words) { says(check, words...); };
  is("A constant volume passes the conservation score.", verdict("dam_break", "volume", {5, 5.004, 4.996}), "pass");
  is("A volume loss of 0.15 % fails the conservation score.", verdict("dam_break", "volume", {5, 5, 4.9925}), "fail");
  is("A volume gain of 0.15 % fails the conservation score.", verdict("dam_break", "volume", {5, 5.0075}), "fail");
  is("A temporary loss fails the conservation score.", verdict("bore", "volume", {5, 4.9, 5}), "fail");
  is("The volume is not scored in flows with inflow and outflow.", verdict("steady_flow", "volume", {5, 7}),
     "not scored");
  is("A decaying wave fails the conservation score.", verdict("periodic_wave", "energy", {2, 1.9, 1.7}), "fail");
  is("A wave that retains 90 % of its energy passes the conservation score.",
     verdict("periodic_wave", "energy", {2, 1.9, 1.85}), "pass");
  is("An energy loss passes if the reference wave breaks.", verdict("dam_break", "energy", {2, 1, 0.5}), "pass");
  is("An energy gain fails if the reference wave breaks.", verdict("dam_break", "energy", {2, 1, 2.05}), "fail");
  is("A negative energy counts by its magnitude.", verdict("dam_break", "energy", {-2, -1.9}), "fail");
  is("The energy of forced flows is not scored.", verdict("wavemaker", "energy", {1, 5}), "not scored");
  is("A change of momentum without walls fails the conservation score.", verdict("periodic_wave", "momentum", {1, 0.8}),
     "fail");
  is("The momentum between walls is not scored.", verdict("standing_wave", "momentum", {1, -1}), "not scored");
  is("The momentum of water started from rest is not scored.", verdict("standing_wave", "momentum", {0, 1}),
     "not scored");

  std::vector<io::Table> files{file_of("t,eta\n0,0\n1,0\n", "gauge.csv"),
                               file_of("t,volume\n0,3\n1,3\n", "volume.csv")};
  const History found = taken(files);
  is("A conservation history is separated from the other files.",
     fmt::format("{} file, {} columns", files.size(), found.size()), "1 file, 2 columns");
  std::vector<io::Table> one{file_of("t,eta,energy\n0,0,1\n1,0,1\n", "both.csv")};
  const History beside = taken(one);
  is("A file with the columns of the case is not taken for a history.",
     fmt::format("{} {}", one.size(), beside.count("energy")), "1 1");
  std::vector<io::Table> named{file_of("time,mass\n0,3\n1,3\n", "m.csv")};
  is("Conservation columns with other names are read when they are mapped.",
     fmt::format("{}", taken(named, {{"t", "time"}, {"volume", "mass"}}).count("volume")), "1");
  is("A missing value is rejected.", refusal("t,volume\n0,1\n1,\n"), "mine.csv: line 3: column volume");
  is("A conservation history of one row is rejected.", refusal("t,volume\n0,1\n"), "1 rows, must be at least two");
  is("A change relative to zero cannot be scored.", message_of([] {
       verdict("bore", "energy", {0, 1});
     }),
     "column energy: is 0 at t = 0");
}

}  // namespace seiche::verification::conservation_test
