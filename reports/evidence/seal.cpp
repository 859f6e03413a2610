#include "reports/evidence/seal.hpp"

#include <stdexcept>

#include "reports/evidence/provenance.hpp"

namespace seiche::evidence {
namespace {

constexpr std::string_view end_of_object = "\n}\n";
constexpr std::string_view before = R"("digest": ")";
constexpr std::string_view after = "\"\n}\n";
constexpr std::size_t digits = 64;

}  // namespace

std::string sealed(std::string text) {
  if (!text.ends_with(end_of_object)) throw std::logic_error("only an object of several lines can be sealed");
  text.resize(text.size() - end_of_object.size());
  text.append(",\n ").append(before);
  return text.append(sha256(text)).append(after);
}

bool is_sealed(std::string_view text) {
  const std::size_t tail = before.size() + digits + after.size();
  if (text.size() < tail || !text.ends_with(after)) return false;
  if (text.substr(text.size() - tail, before.size()) != before) return false;
  const std::size_t first_digit = text.size() - after.size() - digits;
  return text.substr(first_digit, digits) == sha256(text.substr(0, first_digit));
}

}  // namespace seiche::evidence
