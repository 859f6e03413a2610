#include <cmath>
#include <limits>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/exact/shallow_water/simple_wave.hpp"
#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/exact/shallow_water/thacker.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "validation/instruments/manufactured/lagrangian_manufactured.hpp"
#include "verification/check.hpp"

namespace seiche::verification::exact_solutions_test {

using namespace exact;
using validation::LagrangianManufactured;

TEST_CASE("exact solutions reject parameters that have no solution", "[robustness]") {
  constexpr double g = 9.81;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  using Bad = std::invalid_argument;
  const auto one = [](double) { return 1.0; };

  CHECK_THROWS_AS(Riemann(0, {1, 0}, {1, 0}), Bad);
  CHECK_THROWS_AS(Riemann(g, {-1, 0}, {1, 0}), Bad);
  CHECK_THROWS_AS(Riemann(g, {0, 0}, {0, 0}), Bad);
  CHECK_THROWS_AS(Riemann(g, {1, nan}, {1, 0}), Bad);
  CHECK_THROWS_AS(Riemann(g, {inf, 0}, {1, 0}), Bad);
  CHECK_THROWS_AS(Riemann(g, {1, 0}, {1e-200, 0}), Bad);
  CHECK_THROWS_AS(Riemann(g, {1e-200, 0}, {1e-201, 0}), Bad);
  for (const Riemann& thin : {Riemann(g, {1, 0}, {1e-31, 0}), Riemann(g, {1e-99, 0}, {1e-100, 0})}) {
    for (const Identity& identity : thin.self_test()) CHECK(identity.defect <= identity.accuracy);
  }
  CHECK_THROWS_AS(Riemann(g, {1, 0}, {0.5, 0}).at(0, -1), Bad);
  CHECK_THROWS_AS(Riemann(g, {1, 0}, {0.5, 0}).at(nan, 1), Bad);

  CHECK_THROWS_AS(Ritter(g, 0), Bad);
  CHECK_THROWS_AS(Stoker(g, 1, 0), Bad);
  CHECK_THROWS_AS(Stoker(g, 0.5, 1), Bad);
  CHECK_THROWS_AS(Stoker(g, 1, 1), Bad);

  // A fall of depth as a jump would gain energy.
  CHECK_THROWS_AS(Bore(g, 2, 1), Bad);
  CHECK_THROWS_AS(Bore(g, 1, 1), Bad);
  CHECK_THROWS_AS(Bore::from_velocity(g, 1, 0), Bad);
  CHECK_THROWS_AS(StationaryJump(g, 2, 1), Bad);
  CHECK_THROWS_AS(BoreReflection(Bore(g, 1, 2, 0, 10), 5), Bad);
  CHECK_THROWS_AS(BoreReflection(Bore(g, 1, 2, 0.5), 10), Bad);
  CHECK_THROWS_AS(BoreReflection(Bore(g, 1, 2, 0, 5), 10).at(10.1, 0), Bad);
  CHECK_THROWS_AS(CollidingBores(g, 2, 1, 1.5, 70, 30), Bad);
  CHECK_THROWS_AS(CollidingBores(g, 1, 1, 1.5, 30, 70), Bad);

  CHECK_THROWS_AS(SimpleWave::hump(g, 1, -1.5, 6, 6), Bad);
  CHECK_THROWS_AS(SimpleWave::hump(g, 1, 0.2, 6, 0), Bad);
  CHECK_THROWS_AS(SimpleWave(g, 1, {[](double) { return 1.5; }, [](double) { return 0.0; }, 0, 1}), Bad);
  CHECK_THROWS_AS(SimpleWave(g, 1, {}), Bad);

  // Outflow supercritical; jump swept off the bump.
  CHECK_THROWS_AS(SteadyBump(g, 1.53, 0.5), Bad);
  CHECK_THROWS_AS(SteadyBump(g, 0.18, 0.2), Bad);
  CHECK_THROWS_AS(SteadyBump(g, -1, 1), Bad);
  CHECK_THROWS_AS(SteadyBump(g, 0.18, 0.33, {0.2, 1, 2, 25}), Bad);
  CHECK_THROWS_AS(SteadyBump(g, 0.18, 0.33).at(26), Bad);

  CHECK_THROWS_AS(MacDonald::smooth_rise(g, 0), Bad);
  const auto rising = [](double x) { return x - 5; };
  CHECK_THROWS_AS(MacDonald(g, rising, one, 1, 0, 10), Bad);
  // A kink of the slope inside a panel cannot be integrated to 1e-12.
  const auto kinked = [](double x) { return 1 + 0.1 * std::abs(x - 0.501); };
  const auto slope = [](double x) { return x > 0.501 ? 0.1 : -0.1; };
  CHECK_THROWS_AS(MacDonald(g, kinked, slope, 1, 0.03, 1), Bad);

  CHECK_THROWS_AS(Thacker(g, 1, 0.5, 1.9), Bad);
  CHECK_THROWS_AS(Thacker(g, 1, 0.5, 4, 1.1), Bad);
  CHECK_THROWS_AS(Thacker(g, 1, 0.5, 4, 0), Bad);
  CHECK_THROWS_AS(LagrangianManufactured(g, 1, 1, 0.2), Bad);
  CHECK_THROWS_AS(LagrangianManufactured().at(1.1, 0), Bad);
}

}  // namespace seiche::verification::exact_solutions_test
