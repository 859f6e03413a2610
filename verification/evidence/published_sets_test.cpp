#include <fstream>
#include <map>
#include <set>

#include "validation/case/reference_source.hpp"
#include "validation/case/registry.hpp"
#include "verification/check.hpp"

namespace seiche::verification::published_sets_test {

using namespace validation;
using Catch::Matchers::Contains;

const NamedValues theirs{{"particles", 10}, {"time_step", 1}, {"scheme", "H2"}};

Case with_sets(std::vector<Published> sets) {
  Case c;
  c.name = "made_up";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {integer("particles", {10, 100, 1000}, {4, 1000}, "particles"),
                  real("time_step", {1.0, 0.1, 0.01}, "s", {1e-3, 10}, "time step"),
                  choice("scheme", std::string("H2"), {"H2", "M2"}, "scheme")};
  c.published = std::move(sets);
  return c;
}

std::vector<std::string> names_of_runs(const Case& one, Tier tier) {
  std::vector<std::string> names;
  for (const Values& values : one.runs_of(tier)) names.push_back(values.set_name());
  return names;
}

/// Ids of the tiles, in the order of the file.
std::vector<std::string> tiles_of_atlas() {
  std::ifstream file(reference_folder().parent_path() / "atlas.toml");
  std::vector<std::string> tiles;
  bool in_tile = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("[[")) in_tile = line == "[[source.tile]]";
    constexpr std::string_view id = "id = \"";
    if (in_tile && line.starts_with(id)) tiles.push_back(line.substr(id.size(), line.size() - id.size() - 1));
  }
  return tiles;
}

/// Tiles that no case fills: of models that the suite has not, and a sketch that a verification draws.
const std::set<std::string> without_case{"frank-fig-4"};

TEST_CASE("every figure of the atlas has the parameters of its source", "[evidence]") {
  std::map<std::string, std::vector<std::string>> cases;
  for (const Case& one : all_cases()) {
    for (const Published& set : one.published) {
      for (const std::string& tile : set.tiles) cases[tile].push_back(one.name);
    }
  }
  const std::vector<std::string> tiles = tiles_of_atlas();
  REQUIRE(tiles.size() > 50);
  for (const std::string& tile : tiles) {
    INFO(tile);
    CHECK(cases[tile].empty() == (without_case.count(tile) == 1));
    cases.erase(tile);
  }
  for (const auto& [tile, names] : cases) {
    INFO(tile << " of " << names.front() << " is no figure of the atlas");
    CHECK(false);
  }
}

TEST_CASE("an as-published set starts from the defaults of its tier", "[evidence]") {
  const Case c = with_sets({{.tiles = {"a", "b"}, .values = {{"time_step", 2}}, .tier = Tier::full}});
  const Values values = c.values(c.published_set("b"));
  CHECK(values.tier() == Tier::full);
  CHECK(values.integer("particles") == 100);
  CHECK(values.real("time_step") == 2);
  CHECK(values.set_name() == "a");
  CHECK(values.as_published("a"));
  CHECK_THROWS_AS(values.as_published("c"), std::logic_error);
  CHECK_THROWS_WITH(c.published_set("c"), Contains("must be one of a, b"));
}

TEST_CASE("a parameter of an as-published set is stated, chosen or different", "[evidence]") {
  const Published set{.tiles = {"a"}, .stated = {"particles"}, .different = {{"scheme", "M3"}}};
  CHECK(set.origin("particles") == "stated");
  CHECK(set.origin("scheme") == "different");
  CHECK(set.origin("time_step") == "chosen");
}

TEST_CASE("values are an as-published set by their numbers, in its tier or a longer one", "[evidence]") {
  const Case c = with_sets({{.tiles = {"small"}}, {.tiles = {"large"}, .tier = Tier::full}});
  const Values quick = c.values(Tier::quick);
  CHECK(quick.as_published("small"));
  CHECK_FALSE(quick.as_published("large"));
  CHECK(quick.set_name().empty());  // the tier's own run needs no other name
  Values set = quick;
  set.set("particles", Value(100L));
  set.set("time_step", Value(0.1));
  CHECK_FALSE(set.as_published("large"));  // what a case does may depend on the tier
  Values back = c.values(Tier::full);
  CHECK(back.as_published("large"));
  for (const auto& [name, value] : theirs) back.set(name, value);
  CHECK(back.are(theirs));
  CHECK(back.as_published("small"));
  back.set("scheme", Value("M2"));
  CHECK_FALSE(back.as_published("small"));
  CHECK_FALSE(back.are(theirs));
}

TEST_CASE("a tier runs its defaults and the sets that differ from them", "[evidence]") {
  const Case c = with_sets({{.tiles = {"same"}},
                            {.tiles = {"other"}, .values = {{"scheme", "M2"}}},
                            {.tiles = {"again"}, .values = {{"scheme", "M2"}, {"particles", 10}}},
                            {.tiles = {"long"}, .tier = Tier::paper}});
  CHECK(names_of_runs(c, Tier::quick) == std::vector<std::string>{"", "other"});
  CHECK(names_of_runs(c, Tier::full) == std::vector<std::string>{""});
  CHECK(names_of_runs(c, Tier::paper).size() == 1);  // no tier of the case, but its set's
}

TEST_CASE("an as-published set that cannot be run is rejected", "[evidence]") {
  CHECK_NOTHROW(with_sets({{.tiles = {"a"}, .values = theirs}}).check_published());
  const auto refused = [](std::vector<Published> sets, const std::string& word) {
    CHECK_THROWS_WITH(with_sets(std::move(sets)).check_published(), Contains(word));
  };
  refused({{.tiles = {}}}, "names no figure");
  refused({{.tiles = {"a"}}, {.tiles = {"b", "a"}}}, "figure a has two as-published sets");
  refused({{.tiles = {"a"}, .values = {{"particle", 10}}}}, "parameter particle is unknown");
  refused({{.tiles = {"a"}, .stated = {"particle"}}}, "names no parameter particle");
  refused({{.tiles = {"a"}, .different = {{"particle", "11"}}}}, "names no parameter particle");
  refused({{.tiles = {"a"}, .values = {{"particles", 1001}}}}, "an integer in [4, 1000]");
  refused({{.tiles = {"a"}, .values = {{"scheme", "X"}}}}, "one of H2, M2");
  refused({{.tiles = {"a"}, .values = {{"particles", 10.5}}}}, "particles");
}

}  // namespace seiche::verification::published_sets_test
