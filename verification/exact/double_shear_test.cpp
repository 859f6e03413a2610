#include <cmath>
#include <stdexcept>

#include "validation/instruments/manufactured/double_shear.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::double_shear_test {

using validation::DoubleShear;

TEST_CASE("the manufactured double shear conserves areas and obeys the forced equations of motion", "[exact]") {
  Check check(
      "exact_double_shear", "Manufactured motion of a free square: two shears",
      "Areas, velocities and the equations of motion by finite differences of the values that the solution returns.");
  const DoubleShear motion;
  self_test_holds(check, "standard", motion);
  self_test_holds(check, "other", DoubleShear({0.5, -0.4, 0.8, 1.4, 2}));
  for (const double s : {-1.0, -0.3, 0.7}) {
    CHECK(motion.at(1, s, 0.4).pressure == 0);
    CHECK(motion.at(s, -1, 0.4).pressure == 0);
    CHECK(motion.at(s, 0.2, 0).x == s);
    CHECK(motion.at(s, 0.2, 0).y == 0.2);
  }
  CHECK_THROWS_AS(DoubleShear({.first_wavenumber = 0}), std::invalid_argument);
  CHECK_THROWS_AS(DoubleShear({.pressure = std::nan("")}), std::invalid_argument);
}

}  // namespace seiche::verification::double_shear_test
