// A declared range is a promise: with parameters at the ends of their ranges, and anywhere between, every exact
// solution is refused in a sentence that names one of them or keeps its own identities.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "seiche/exact/catalogue.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/robustness/fuzzing.hpp"

namespace seiche::verification::catalogue_corners_test {

using namespace exact;

/// How many members of a family are drawn. Solutions that integrate a motion or solve for a surface take up to seconds
/// each: few of them, and some only in longer runs.
long members_of(const ExactSolution& solution) {
  double usual = 100;
  for (const auto& [name, few] :
       {std::pair("overturning_wave", 0.1), std::pair("pressure_forced_wave", 3.0), std::pair("waves_in_tank", 1.0),
        std::pair("released_column", 4.0), std::pair("wavemaker_start", 4.0), std::pair("solitary_runup", 2.0),
        std::pair("slope_runup", 1.0), std::pair("wall_runup", 1.0), std::pair("wall_load", 1.0),
        std::pair("standing", 10.0), std::pair("stokes", 20.0), std::pair("solitary", 20.0)}) {
    if (solution.name == name) usual = few;
  }
  return std::lround(std::floor(usual * static_cast<double>(verification::fuzz_factor())));
}

/// A parameter that says how finely the solution is computed: what its highest value costs only longer runs can pay.
bool costly(const Parameter& p) {
  return p.name == "markers" || p.name == "points";
}

double uniform(Xorshift& random) {
  return static_cast<double>(random.below(1UL << 53)) / static_cast<double>(1UL << 53);
}

/// An end of the range, the default, or a number between: evenly by magnitude where the range spans several.
double drawn(const Parameter& p, Xorshift& random) {
  const double highest = std::isinf(p.maximum) ? 1e9 : p.maximum;
  const bool whole = !p.choices.empty();
  switch (random.below(4)) {
    case 0:
      return p.minimum;
    case 1:
      return costly(p) && verification::fuzz_factor() < 10 ? p.minimum : p.maximum;
    case 2:
      return p.default_value;
    default:
      if (costly(p)) return p.default_value;
  }
  double value = p.minimum + (highest - p.minimum) * uniform(random);
  if (whole) return std::round(value);
  const double least = p.minimum > 0 ? p.minimum : 1e-9 * highest;
  if (highest > 1e3 * least && random.below(2) == 0) {
    value = least * std::pow(highest / least, uniform(random));
    if (p.minimum < 0 && random.below(2) == 0) value = std::max(p.minimum, -value);
  }
  return std::clamp(value, p.minimum, p.maximum);
}

/// Three parameters at most leave their defaults half of the time: what one does alone is seldom seen among ten.
std::map<std::string, double> member(const ExactSolution& solution, Xorshift& random) {
  std::map<std::string, double> values;
  const bool few = random.below(2) == 0;
  const std::size_t count = solution.parameters.size();
  for (const Parameter& p : solution.parameters) {
    if (!few || random.below(count) < 3) values[p.name] = drawn(p, random);
  }
  return values;
}

bool names_a_parameter(const std::string& sentence, const ExactSolution& solution) {
  const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return std::any_of(solution.parameters.begin(), solution.parameters.end(), [&](const Parameter& p) {
    for (auto at = sentence.find(p.name); at != std::string::npos; at = sentence.find(p.name, at + 1)) {
      const auto end = at + p.name.size();
      if ((at == 0 || !letter(sentence[at - 1])) && (end == sentence.size() || !letter(sentence[end]))) return true;
    }
    return false;
  });
}

/// The command that shows it again.
std::string command(const ExactSolution& solution, const std::map<std::string, double>& values) {
  std::string words = "seiche exact " + solution.name + " --self-test";
  for (const auto& [name, value] : values) words += fmt::format(" --set {}={:.17g}", name, value);
  return words;
}

/// What became of one member of a family.
struct Outcome {
  bool refused = false;
  std::string nameless{};  ///< a refusal that names no parameter, or a breakdown that does not say which to change
  std::string broken{};    ///< an identity that does not hold
};

Outcome outcome(const ExactSolution& solution, const std::map<std::string, double>& values) {
  try {
    const exact::Evaluator evaluator = solution.evaluator(values);
    for (const exact::Identity& identity : evaluator.self_test()) {
      if (!(identity.defect <= identity.accuracy)) {  // NaN does not hold
        return {.broken = fmt::format("{}: residual {:.3g}, accuracy {:.3g}", identity.name, identity.defect,
                                      identity.accuracy)};
      }
    }
  } catch (const std::exception& refusal) {
    return {.refused = true, .nameless = names_a_parameter(refusal.what(), solution) ? "" : refusal.what()};
  }
  return {};
}

/// The catalogue without the solutions that take longest, or these alone.
void try_members(bool longest) {
  static const std::set<std::string> takes_long{"slope_runup",          "wall_runup",    "wall_load",
                                                "pressure_forced_wave", "waves_in_tank", "released_column",
                                                "wavemaker_start",      "solitary_runup"};
  Check check(
      "exact_corners", "Exact solutions at the corners of their ranges",
      "A declared range is a promise. The parameters of every solution of the catalogue are drawn: an end of the "
      "range, the default, or a number between, evenly or by magnitude; the same in every run, more of them where "
      "`SEICHE_FUZZ` says how many times as many, others where `SEICHE_FUZZ_SEED` says so. Accepted parameters must "
      "pass the self-test; rejected ones must be rejected in a sentence that names a parameter.");
  Count refused, nameless, broken;
  const auto is = [](double found) { return found > 0; };
  for (const ExactSolution& solution : exact::catalogue()) {
    if (takes_long.contains(solution.name) != longest) continue;
    Xorshift random(verification::fuzz_seed(0x9E3779B97F4A7C15U));
    Count accepted;
    for (long k = 0; k < members_of(solution); ++k) {
      const auto values = member(solution, random);
      const Outcome became = outcome(solution, values);
      accepted.add(became.refused ? 0 : 1, is);
      refused.add(became.refused ? 1 : 0, is);
      nameless.add(became.nameless.empty() ? 0 : 1, is);
      broken.add(became.broken.empty() ? 0 : 1, is);
      INFO(command(solution, values));
      CHECK(became.nameless.empty());
      CHECK(became.broken.empty());
    }
    INFO(solution.name);
    CHECK((accepted.value() > 0 || members_of(solution) < 10));
  }
  const auto members = static_cast<double>(refused.samples());
  check.holds("Every accepted parameter set satisfies the identities of the solution.", {broken.value()},
              Bound{0, "a declared range is a promise"});
  check.holds("Every rejection names a parameter of the solution.", {nameless.value()},
              Bound{0, "the user needs the parameter to change"});
  if (longest) return;
  check.holds("The share of rejected parameter sets lies between 5 % and 95 %, so that both ways are tried.",
              {refused.value() / members}, Bound{0.45, "between 5 % and 95 %", 0.5});
}

TEST_CASE("exact solutions satisfy their identities over their whole ranges, or name the parameter to change",
          "[exact]") {
  try_members(false);
}

TEST_CASE("so do those that take longest", "[exact][full]") {
  try_members(true);
}

}  // namespace seiche::verification::catalogue_corners_test
