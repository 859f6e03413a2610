// Solitary waves behind a change of depth: depths known from the literature, limits, refusals.
#include <cmath>
#include <string>

#include "seiche/exact/mach_reflection.hpp"
#include "verification/check.hpp"

namespace seiche::verification::soliton_fission_test {

using seiche::exact::SolitonFission;

TEST_CASE("a solitary wave falls apart into whole numbers of waves at the depths that are known", "[exact]") {
  const std::string johnson = "Johnson, Proc. Camb. Phil. Soc. 73 (1973) 183";
  Check check("soliton_fission", "Solitary waves behind a change of depth",
              "On a gentle slope exactly n waves and no other motion arrive where h^(-9/4) = n (n + 1)/2: at the "
              "depths 0.614 and 0.451 for n = 2 and 3, which Johnson gives. There the waves' squared rates of decay "
              "are whole numbers. Without a change of depth the wave is unchanged.",
              johnson);
  for (const auto& [n, depth] : {std::pair{2, 0.614}, {3, 0.451}}) {
    const std::string id = std::to_string(n);
    const double exact = std::pow(2.0 / (n * (n + 1)), 4.0 / 9);
    const SolitonFission there(exact, SolitonFission::Passage::gradual);
    check.that("depth-" + id, "The depth behind the step for " + id + " waves equals Johnson's.", "depth", {exact},
               Bound{5e-4, "half a unit of the last digit", depth});
    check.that("order-" + id, "The depth gives exactly " + id + " solitary waves.", "order nu", {there.order()},
               Roundoff{10, 4.0, "two powers and a root", 1.0 * n});
    check.that("second-" + id, "The second wave is to the first as (n - 1)^2 to n^2.", "a_2/a_1",
               {there.amplitude(2) / there.amplitude(1)},
               Roundoff{20, 4.0, "squares of the order, which is rounded", std::pow((n - 1.0) / n, 2)});
  }
  const SolitonFission flat(1);
  check.from("identity")
      .that("flat", "The wave height on a flat bed is constant.", "a_1/a_0", {flat.amplitude(1)},
            Roundoff{10, 2.0, "a root and a square", 1.0});
  CHECK(flat.solitons() == 1);
  CHECK(flat.reflection() == 0);
  CHECK(flat.amplitude(2) == 0);
  const SolitonFission step(0.5);
  CHECK(step.solitons() == 3);
  check.from("Landau & Lifshitz, Quantum mechanics, section 23")
      .that("sum-of-levels", "The decay rates of successive waves at a step onto half the depth differ by one.",
            "sqrt(a_1/a_0)/h - sqrt(a_2/a_0)/h", {(std::sqrt(step.amplitude(1)) - std::sqrt(step.amplitude(2))) / 0.5},
            Roundoff{10, 4.0, "roots of squares", 1.0});
}

}  // namespace seiche::verification::soliton_fission_test
