#include <limits>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::finite_volume_test {

using shallow_water_finite_volume::End, shallow_water_finite_volume::FiniteVolumeFlow;
using shallow_water_finite_volume::Scheme;

TEST_CASE("finite-volume flow rejects bad input", "[robustness]") {
  using Bad = std::invalid_argument;
  const std::vector<double> h(8, 1.0), q(8, 0.0);
  const FiniteVolumeFlow::Settings good;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_NOTHROW(FiniteVolumeFlow(good, 0, 1, h, q));
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 1, 0, h, q), Bad);
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, nan, h, q), Bad);
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, std::vector<double>(3, 1.0), std::vector<double>(3, 0.0)), Bad);
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, h, std::vector<double>(7, 0.0)), Bad);
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, std::vector<double>(8, -1.0), q), Bad);
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, h, std::vector<double>(8, nan)), Bad);
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, std::vector<double>(8, 0.0), h), Bad);
  Check check("finite_volume_bad_settings", "Bad settings of finite volumes", "Each number outside of its range.");
  Refusals(check).outside_ranges("Settings",
                                 "gravity positive and finite; courant in [1e-06, 1]; viscosity in [0.001, 1]; theta "
                                 "in [1, 2]; manning non-negative and finite; dry_depth positive and finite",
                                 good, [&](const FiniteVolumeFlow::Settings& s) { FiniteVolumeFlow(s, 0, 1, h, q); });
  using Settings = FiniteVolumeFlow::Settings;
  CHECK_THROWS_AS(FiniteVolumeFlow(Settings{.left = End::inflow({-1, 0})}, 0, 1, h, q), Bad);
  const Bed slope{[](double x) { return x; }, [](double x) { return x * x / 2; }};
  CHECK_THROWS_AS(FiniteVolumeFlow(Settings{.scheme = Scheme::roe}, 0, 1, h, q, slope), Bad);
  const Bed wrong{[](double x) { return x; }, [](double x) { return x; }};
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, h, q, wrong), Bad);
  const Bed wrong_and_small{[](double x) { return 1e-7 * x; }, [](double x) { return 1e-7 * x; }};
  CHECK_THROWS_AS(FiniteVolumeFlow(good, 0, 1, h, q, wrong_and_small), Bad);
  // What flows in counts before it has come in.
  const Settings fast{.left = End::inflow({1, 4})};
  FiniteVolumeFlow onto_dry_bed(fast, 0, 1, q, q);
  CHECK(std::abs(onto_dry_bed.courant_number(0.125) - (4 + std::sqrt(fast.gravity))) < 1e-14);
  CHECK_NOTHROW(march(onto_dry_bed, 0.05));
  FiniteVolumeFlow flow(good, 0, 1, h, q);
  CHECK_THROWS_AS(flow.advance(1), Bad);
  flow.advance(flow.stable_step());
  CHECK_THROWS_AS(flow.advance(1), Divergence);
  CHECK(shallow_water_finite_volume::name(Scheme::muscl_hll) == "muscl_hll");
}

TEST_CASE("on a dry bed MacCormack's scheme breaks down and the others do not", "[robustness]") {
  Check check("finite_volume_dry_bed", "Dam break onto a dry bed: which schemes survive",
              "The velocity of a predicted state of depth zero is 0/0: MacCormack's scheme ends in "
              "`seiche::Divergence` with time and position. The others keep every depth non-negative.");
  std::vector<double> h(60, 0.0);
  std::fill_n(h.begin(), 20, 1.0);
  const std::vector<double> q(60, 0.0);
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    FiniteVolumeFlow flow({.scheme = scheme}, 0, 60, h, q);
    bool diverged = false;
    try {
      march(flow, 5);
    } catch (const Divergence& divergence) {
      diverged = true;
      CHECK(std::string(divergence.what()).find("mac_cormack") != std::string::npos);
      CHECK(divergence.place() > 19);
    }
    const std::string id(shallow_water_finite_volume::name(scheme));
    check.holds(
        "Scheme " + id + (scheme == Scheme::mac_cormack ? " breaks down on a dry bed." : " survives a dry bed."),
        {diverged ? 1.0 : 0.0},
        Qualitative{"seiche::Divergence thrown before t = 5 s", "a depth that is negative or not finite ends the run",
                    scheme == Scheme::mac_cormack});
    for (const double depth : flow.depth()) CHECK((diverged || depth >= 0));
  }
}

}  // namespace seiche::verification::finite_volume_test
