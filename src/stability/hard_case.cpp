#include "skydrop/stability/hard_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"
#include "stability/record_json.h"

namespace skydrop::stability {
namespace {

constexpr double kMost = 1e300;

std::string textOf(const nlohmann::json& of, const char* name, std::string_view file,
                   const std::string& place) {
  return core::jsonText(of.value(name, nlohmann::json()), file, place + name);
}

HeldFigure heldOf(const nlohmann::json& of, std::string_view file, const std::string& place) {
  HeldFigure held;
  held.unit = textOf(of, "unit", file, place);
  held.test = textOf(of, "test", file, place);
  const std::optional<Sense> sense = senseOf(textOf(of, "sense", file, place));
  if (!sense) throw core::DataError(file, place + "sense", "is none of < <= > >= =");
  held.limit.sense = *sense;
  held.limit.value =
      core::jsonNumber(of.value("limit", nlohmann::json()), file, place + "limit", -kMost, kMost);
  const nlohmann::json figure = of.value("figure", nlohmann::json());
  held.figure = figure.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                 : core::jsonNumber(figure, file, place + "figure", -kMost, kMost);
  return held;
}

}  // namespace

HardCaseRecord parseHardCases(std::string_view text, std::string_view file) {
  const nlohmann::json json = core::parseJson(text, file);
  if (!json.is_object()) throw core::DataError(file, "", "is not an object");
  core::jsonWhole(json.value("schema", nlohmann::json()), file, "schema", kHardCaseSchema, kHardCaseSchema);
  HardCaseRecord record;
  record.program = textOf(json, "program", file, "");
  record.machine = textOf(json, "machine", file, "");
  record.renderer = textOf(json, "renderer", file, "");
  record.date = textOf(json, "date", file, "");
  const auto cases = json.find("cases");
  if (cases == json.end() || !cases->is_array()) throw core::DataError(file, "cases", "is not a list");
  for (std::size_t i = 0; i < cases->size(); ++i) {
    const nlohmann::json& of = (*cases)[i];
    const std::string place = "cases." + std::to_string(i) + ".";
    if (!of.is_object()) throw core::DataError(file, "cases." + std::to_string(i), "is not an object");
    HardCase row;
    row.id = textOf(of, "id", file, place);
    row.area = textOf(of, "area", file, place);
    row.input = textOf(of, "input", file, place);
    row.mustHold = textOf(of, "mustHold", file, place);
    if (of.contains("reason")) row.reason = textOf(of, "reason", file, place);
    row.figures = static_cast<int>(
        core::jsonWhole(of.value("figures", nlohmann::json(0)), file, place + "figures", 0, 1e6));
    if (of.contains("held")) {
      if (!of["held"].is_object()) throw core::DataError(file, place + "held", "is not an object");
      row.held = heldOf(of["held"], file, place + "held.");
    }
    record.cases.push_back(std::move(row));
  }
  return record;
}

HardCaseRecord loadHardCases() {
  const std::string file = core::assetPath("stability/hard_cases.json");
  return parseHardCases(core::readTextFile(file), file);
}

nlohmann::ordered_json jsonOf(const HardCaseRecord& record) {
  nlohmann::ordered_json json;
  json["schema"] = kHardCaseSchema;
  json["about"] =
      "What the suite measured of every hard case; written by tests/margins, see docs/contributing.md.";
  json["program"] = record.program;
  json["machine"] = record.machine;
  json["renderer"] = record.renderer;
  json["date"] = record.date;
  json["cases"] = nlohmann::ordered_json::array();
  for (const HardCase& row : record.cases) {
    nlohmann::ordered_json of = {
        {"id", row.id}, {"area", row.area}, {"input", row.input}, {"mustHold", row.mustHold}};
    if (!row.reason.empty()) of["reason"] = row.reason;
    if (row.held) {
      of["figures"] = row.figures;
      of["held"] = {{"figure", row.held->figure},
                    {"sense", signOf(row.held->limit.sense)},
                    {"limit", row.held->limit.value},
                    {"unit", row.held->unit},
                    {"test", row.held->test}};
    }
    json["cases"].push_back(std::move(of));
  }
  return json;
}

std::string hardCasesText(const HardCaseRecord& record) { return jsonOf(record).dump(1) + "\n"; }

std::vector<HardCase> sortedByMargin(std::vector<HardCase> cases) {
  const auto rank = [](const HardCase& row) {
    if (!row.held) return std::pair(2, 0.0);
    return std::pair(row.held->limit.sense == Sense::none && row.held->figure == 0 ? 1 : 0,
                     row.held->margin());
  };
  std::ranges::stable_sort(cases, {}, rank);
  return cases;
}

}  // namespace skydrop::stability
