#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/evidence/record_files.hpp"
#include "reports/evidence/seal.hpp"
#include "reports/evidence/standing.hpp"
#include "seiche/io/atomic_file.hpp"

namespace seiche::evidence {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity: null stands for a number that is not there.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <class... Types>
Json any(const std::variant<Types...>& value) {
  return std::visit(
      [](const auto& v) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, double>) {
          return number(v);
        } else {
          return Json(v);
        }
      },
      value);
}

/// The caps beyond which the claim says nothing.
Json caps_of(std::initializer_list<std::pair<const char*, Amount>> amounts) {
  Json caps = Json::object();
  for (const auto& [name_of, amount] : amounts) {
    if (amount.capped()) caps[name_of] = number(amount.cap());
  }
  return caps;
}

Json describe(const Roundoff& c) {
  return {{"kind", "roundoff"},
          {"reason", c.reason},
          {"operations", number(c.operations.value())},
          {"scale", number(c.scale.value())},
          {"caps", caps_of({{"operations", c.operations}, {"scale", c.scale}, {"expected", c.expected}})}};
}
Json describe(const Order& c) {
  return {{"kind", "order"}, {"reason", c.reason}, {"theory", c.theory}, {"tolerance", c.tolerance}};
}
Json describe(const Bound& c) {
  return {{"kind", "bound"},
          {"reason", c.reason},
          {"relative", c.relative},
          {"caps", caps_of({{"limit", c.limit}, {"expected", c.expected}})}};
}
Json describe(const Uncertainty& c) {
  return {{"kind", "uncertainty"},
          {"reason", c.reason},
          {"data", number(c.data.value())},
          {"input", number(c.input.value())},
          {"coverage", c.coverage},
          {"useful", number(c.useful)},
          {"caps", caps_of({{"expected", c.expected}, {"data", c.data}, {"input", c.input}})}};
}
Json describe(const Qualitative& c) {
  return {{"kind", "qualitative"}, {"reason", c.reason}, {"detector", c.detector}};
}

Json describe(const JudgedClaim& judged) {
  const Judgement& j = judged.judgement;
  Json criterion = std::visit([](const auto& c) { return describe(c); }, judged.criterion);
  criterion["limit"] = number(j.limit);
  return {{"id", judged.claim.id},
          {"text", judged.claim.text},
          {"quantity", judged.claim.quantity},
          {"unit", judged.claim.unit},
          {"source", judged.claim.source},
          {"resolution", j.resolution},
          {"measured", number(j.measured)},
          {"uncertainty", j.uncertainty ? number(*j.uncertainty) : Json(nullptr)},
          {"expected", number(j.expected)},
          {"criterion", criterion},
          {"verdict", name(j.verdict)},
          {"declared", name(judged.declared())},
          {"declared_reason", judged.known_failure ? judged.known_failure->reason : ""},
          {"declared_band", judged.known_failure && std::isfinite(judged.known_failure->width)
                                ? Json::array({judged.known_failure->value, judged.known_failure->width})
                                : Json(nullptr)},
          {"as_declared", judged.as_declared()},
          {"note", j.note}};
}

Json describe(const Table& table) {
  Json columns = Json::array();
  for (const auto& [title, unit] : table.columns) columns.push_back({{"name", title}, {"unit", unit}});
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const auto& cell : row) cells.push_back(any(cell));
    rows.push_back(std::move(cells));
  }
  return {{"id", table.id},     {"title", table.title}, {"caption", table.caption},
          {"columns", columns}, {"rows", rows},         {"atlas", table.atlas}};
}

Json describe(const Provenance& p, const std::map<std::string, std::string>& reference_data) {
  return {{"version", p.version},
          {"commit", p.commit},
          {"dirty", p.dirty},
          {"compiler", p.compiler},
          {"flags", p.flags},
          {"build_type", p.build_type},
          {"libraries", p.libraries},
          {"processor", p.processor},
          {"cores", p.cores},
          {"threads", p.threads},
          {"system", p.system},
          {"date", p.date},
          {"reference_data", Json(reference_data.empty() ? Json::object() : Json(reference_data))}};
}

/// Text from outside (a path, a message) may not be UTF-8; it is shown with replacement characters, not refused.
std::string text_of(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void refresh_article(const std::filesystem::path& json_file, const std::string& article) {
  Json json = Json::parse(io::read_file(json_file));
  if (json.at("article") == article) return;
  json["article"] = article;
  json.erase("digest");
  io::write_file(json_file, sealed(text_of(json)));
}

std::string to_json(const Record& record, const std::map<std::string, std::string>& digests) {
  Json parameters = Json::object();
  for (const auto& [name_of, p] : record.parameters) {
    parameters[name_of] = {
        {"value", any(p.value)}, {"unit", p.unit}, {"default", any(p.standard)}, {"meaning", p.meaning}};
  }
  Json published = Json::array();
  for (const PublishedSet& set : record.published) {
    Json values = Json::object();
    for (const auto& [name_of, value] : set.values) values[name_of] = any(value);
    published.push_back({{"tiles", set.tiles},
                         {"tier", set.tier},
                         {"values", values},
                         {"origins", set.origins},
                         {"different", set.different},
                         {"differs", set.differs},
                         {"contradicted", set.contradicted},
                         {"here", set.here}});
  }
  std::map<std::string, int> uses;  // a sentence that several claims share is completed by the id: each stands alone
  for (const JudgedClaim& judged : record.claims()) ++uses[judged.claim.text];
  Json claims = Json::array();
  for (JudgedClaim judged : record.claims()) {
    std::string& text = judged.claim.text;
    if (uses[text] > 1) text = fmt::format("{} ({}).", text.substr(0, text.find_last_not_of('.') + 1), judged.claim.id);
    claims.push_back(describe(judged));
  }
  Json left_out = Json::array();
  for (const ClaimLeftOut& one : record.left_out()) {
    left_out.push_back({{"id", one.claim.id}, {"text", one.claim.text}, {"reason", one.reason}});
  }
  Json measurements = Json::object();
  for (const auto& [quantity, value] : record.measurements()) measurements[quantity] = number(value);
  const Standing standing = standing_of(record);
  Json errors = Json::object();
  for (const auto& [quantity, error] : standing.errors) errors[quantity] = number(error);
  Json figures = Json::array();
  for (const Figure& f : record.figures()) {
    figures.push_back(
        {{"id", f.id}, {"title", f.title}, {"caption", f.caption}, {"drawing", f.drawing}, {"atlas", f.atlas}});
  }
  Json tables = Json::array();
  for (const Table& t : record.tables()) tables.push_back(describe(t));
  const bool has_data = !(record.figures().empty() && record.arrays().empty() && record.snapshots().empty());

  const Json json = {{"schema", 3},
                     {"case", record.name},
                     {"kind", record.kind},
                     {"group", record.group},
                     {"tier", record.tier},
                     {"solver", record.solver},
                     {"title", record.title},
                     {"source", record.source},
                     {"article", record.article},
                     {"status", record.error.empty() ? "finished" : "error"},
                     {"error", record.error},
                     {"parameters", parameters},
                     {"set", record.set},
                     {"published", published},
                     {"claims", claims},
                     {"left_out", left_out},
                     {"measurements", measurements},
                     {"standing", {{"settings", standing.settings}, {"errors", errors}}},
                     {"figures", figures},
                     {"tables", tables},
                     {"atlas", record.atlas},
                     {"data", has_data ? record.stem() + ".h5" : ""},
                     {"fields", record.snapshots().empty() ? "" : record.stem() + ".xdmf"},
                     {"wall_time", number(record.wall_time)},
                     {"fingerprint", record.fingerprint},
                     {"provenance", describe(provenance(), record.reference_data)},
                     {"files", digests.empty() ? Json::object() : Json(digests)}};
  return sealed(text_of(json));
}

}  // namespace seiche::evidence
