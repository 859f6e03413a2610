// What cases ask of others, and what they refuse: too few points, and instants at which a wrong result looks right.
// Which wrong results are detected is tried by ci/tests/test_resolving_power.py.
#include <stdexcept>

#include "validation/case/registry.hpp"
#include "verification/check.hpp"
#include "verification/evidence/submissions.hpp"

namespace seiche::verification::foreign_flows_test {

using namespace validation;

TEST_CASE("too few points of a foreign flow are rejected", "[evidence]") {
  for (const char* name : {"riemann", "moving_bore", "bore_reflection", "colliding_bores", "steady_bump",
                           "macdonald_channel", "wave_kinematics", "synolakis_beach"}) {
    INFO(name);
    const Case& one = find_case(name);
    const Values values = one.values(Tier::quick);
    WantedTable ends = one.submission.tables(values).front();
    ends.points = [all = ends.points](double group) {
      return std::vector<double>{all(group).front(), all(group).back()};
    };
    const Submitted few = submission({ends}, [](const WantedQuantity& q, Place p) { return q.reference(p); });
    evidence::Record record;
    CHECK_THROWS_AS(one.submission.judge(values, few, {}, record), std::invalid_argument);
  }
}

TEST_CASE("a periodic wave is not requested at times at which the initial state would be correct", "[evidence]") {
  Values values = find_case("wave_kinematics").values(Tier::quick);
  for (const double way : {16.0, 16.7, 23.3}) {
    INFO(way);
    values.set("way", way);
    CHECK_THROWS_AS(find_case("wave_kinematics").submission.tables(values), std::invalid_argument);
  }
}

}  // namespace seiche::verification::foreign_flows_test
