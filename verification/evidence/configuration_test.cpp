// What a configuration file sets: every value in its place, and what it may not say.
#include "validation/case/configuration.hpp"

#include "validation/case/registry.hpp"
#include "verification/check.hpp"

namespace seiche::verification::configuration_test {

using namespace validation;
using Catch::Matchers::Contains;

Values configured(const std::string& text, const std::string& name = "riemann") {
  const Case& one = find_case(name);
  Values values = one.values(Tier::quick);
  apply_configuration(text, "waves.toml", one, values);
  return values;
}

TEST_CASE("a parameter of any type has the default of the test level", "[evidence]") {
  const std::vector<Parameter> all{real("length", {1.5, 2.5, 3.5}, "m", {0, 9}, ""),
                                   integer("cells", {1, 2, 3}, {1, 9}, ""),
                                   choice("scheme", ByTier<std::string>{"a", "b", "c"}, {"a", "b", "c"}, ""),
                                   toggle("walls", {false, true, false}, ""), toggle("bed", {true, true, false}, "")};
  const Values quick(all, Tier::quick), full(all, Tier::full), paper(all, Tier::paper);
  CHECK((quick.real("length") == 1.5 && full.real("length") == 2.5 && paper.real("length") == 3.5));
  CHECK((quick.integer("cells") == 1 && full.integer("cells") == 2 && paper.integer("cells") == 3));
  CHECK((quick.text("scheme") == "a" && full.text("scheme") == "b" && paper.text("scheme") == "c"));
  CHECK((!quick.toggle("walls") && full.toggle("walls") && !paper.toggle("walls")));
  CHECK((quick.toggle("bed") && full.toggle("bed") && !paper.toggle("bed")));
}

TEST_CASE("a configuration sets the parameters it names, and a case's own table overrides the top level",
          "[evidence]") {
  const Values plain = configured("");
  CHECK(plain.standard());
  const Values set = configured("particles = 77\nright_depth = 1\n[riemann]\nright_depth = 0.5\n");
  CHECK(set.integer("particles") == 77);
  CHECK(set.real("right_depth") == 0.5);
  CHECK(set.real("left_depth") == plain.real("left_depth"));
  CHECK(configured("right_velocity = -0.25").real("right_velocity") == -0.25);
  CHECK(configured("scheme = 'M2'").text("scheme") == "M2");
}

TEST_CASE("a case ignores the table of another case", "[evidence]") {
  CHECK(configured("[moving_bore]\nparticles = 77\nright_depth = 0.37\n").standard());
}

TEST_CASE("an integer is accepted as a real number, a real number not as an integer", "[evidence]") {
  CHECK(configured("time = 2").real("time") == 2.0);
  CHECK_THROWS_WITH(configured("particles = 50.5"), Contains("particles"));
}

TEST_CASE("a configuration's mistake is named by file, line and parameter, in one line", "[evidence]") {
  CHECK_THROWS_WITH(configured("time = 2\n\nparticles = -1\n"), Contains("waves.toml: line 3: parameter particles"));
  CHECK_THROWS_WITH(configured("time = 2\n[riemann]\ndepht = 1\n"), Contains("line 3") && Contains("depht"));
  CHECK_THROWS_WITH(configured("time = 2\n[riemnan]\n"), Contains("line 2") && Contains("riemnan"));
  CHECK_THROWS_WITH(configured("time =\n"), Contains("waves.toml: line 1"));
  CHECK_THROWS_WITH(configured("particles = [1, 2]\n"), Contains("parameter particles must be a number"));
  CHECK_THROWS_WITH(configured("\"a\\nb\" = 1\n"), !Contains("\n"));
}

}  // namespace seiche::verification::configuration_test
