#include "validation/scoring/units.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "seiche/io/date.hpp"

namespace seiche::validation {
namespace {

/// A multiple of m^a s^b kg^c rad^d.
struct Unit {
  double factor = 1;
  std::array<int, 4> powers{};
};

const Unit* base_unit(const std::string& name) {
  constexpr double foot = 0.3048;
  constexpr double hour = 3600;
  constexpr double degree = std::numbers::pi / 180;
  static const std::map<std::string, Unit> units = [] {
    std::map<std::string, Unit> all{{"1", {}}, {"-", {}}, {"%", {0.01, {}}}};
    const auto add = [&](double factor, std::array<int, 4> powers, std::initializer_list<const char*> names) {
      for (const char* one : names) all[one] = {factor, powers};
    };
    add(1, {1}, {"m", "M", "meter", "metre", "meters", "metres"});
    add(0.01, {1}, {"cm", "centimeter", "centimetre", "centimeters", "centimetres"});
    add(0.001, {1}, {"mm", "millimeter", "millimetre", "millimeters", "millimetres"});
    add(0.1, {1}, {"dm"});
    add(1000, {1}, {"km", "kilometer", "kilometre", "kilometers", "kilometres"});
    add(foot, {1}, {"ft", "foot", "feet"});
    add(foot / 12, {1}, {"in", "inch", "inches"});
    add(1, {0, 1}, {"s", "S", "sec", "secs", "second", "seconds"});
    add(0.001, {0, 1}, {"ms", "msec", "milliseconds"});
    add(60, {0, 1}, {"min", "mins", "minute", "minutes"});
    add(hour, {0, 1}, {"h", "hr", "hrs", "hour", "hours"});
    add(24 * hour, {0, 1}, {"d", "day", "days"});
    add(1852 / hour, {1, -1}, {"kn", "kt", "knot", "knots"});
    add(1, {0, -1}, {"Hz"});
    add(1, {0, 0, 1}, {"kg"});
    add(1, {1, -2, 1}, {"N"});
    add(1, {2, -2, 1}, {"J"});
    add(1, {-1, -2, 1}, {"Pa"});
    add(100, {-1, -2, 1}, {"hPa", "mbar"});
    add(1000, {-1, -2, 1}, {"kPa"});
    add(1e5, {-1, -2, 1}, {"bar"});
    add(1, {0, 0, 0, 1}, {"rad", "radian", "radians"});
    add(degree, {0, 0, 0, 1}, {"deg", "degree", "degrees", "\u00b0"});
    return all;
  }();
  const auto found = units.find(name);
  return found == units.end() ? nullptr : &found->second;
}

/// A name, a power behind it, and what joins it to the one before.
std::optional<Unit> unit_of(const std::string& text) {
  Unit unit;
  int sign = 1;
  for (std::size_t k = 0; k < text.size();) {
    if (text[k] == ' ' || text[k] == '*' || text[k] == '.' || text[k] == '/') {
      sign = text[k] == '/' ? -1 : sign;
      ++k;
      continue;
    }
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; };
    std::size_t end = k + 1;
    while (is_letter(text[k]) && end < text.size() && is_letter(text[end])) ++end;
    const Unit* base = base_unit(text.substr(k, end - k));
    if (base == nullptr) return {};
    k = end;
    int power = 1;
    std::size_t digits = text.find_first_not_of("^*", k);
    if (digits == std::string::npos) digits = k;
    int length = 0;
    if (std::sscanf(text.c_str() + digits, "%1d%n", &power, &length) == 1 ||
        std::sscanf(text.c_str() + digits, "%2d%n", &power, &length) == 1) {
      k = digits + static_cast<std::size_t>(length);
    } else {
      power = 1;
    }
    unit.factor *= std::pow(base->factor, sign * power);
    for (std::size_t d = 0; d < unit.powers.size(); ++d) unit.powers[d] += sign * power * base->powers[d];
    sign = 1;
  }
  return unit;
}

}  // namespace

std::optional<double> conversion(const std::string& from, const std::string& to) {
  if (from == to) return 1;
  const std::optional<Unit> given = unit_of(from);
  const std::optional<Unit> wanted = unit_of(to);
  if (!given || !wanted || given->powers != wanted->powers) return {};
  return given->factor / wanted->factor;
}

std::optional<Epoch> epoch_of(const std::string& unit) {
  const std::size_t since = unit.find(" since ");
  if (since == std::string::npos) return {};
  const std::optional<double> origin = io::date_in(unit.substr(since + 7));
  return origin ? std::optional(Epoch{unit.substr(0, since), *origin}) : std::nullopt;
}

}  // namespace seiche::validation
