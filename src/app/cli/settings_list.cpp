#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "app/settings/settings.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kKinds = {"number", "integer", "flag", "choice"};
constexpr std::array<std::string_view, 5> kEffects = {"live", "liveRebuild", "variant", "rebuild", "restart"};

// As JSON has the value in a settings file.
Json valueJson(const core::Field& field, double value) {
  if (field.kind == core::FieldKind::flag) return value != 0;
  if (field.kind == core::FieldKind::choice) return field.names.at(static_cast<std::size_t>(value));
  if (const std::string text = core::writtenText(field, value); !text.empty()) return text;
  if (field.kind == core::FieldKind::integer) return static_cast<std::int64_t>(value);
  return value;
}

Json fieldJson(const core::Field& field) {
  Json json = {{"path", field.path},
               {"kind", kKinds.at(static_cast<std::size_t>(field.kind))},
               {"default", valueJson(field, field.defaultValue)},
               {"takesEffect", kEffects.at(static_cast<std::size_t>(field.takesEffect))},
               {"help", field.help}};
  if (!field.unit.empty()) json["unit"] = field.unit;
  if (field.kind == core::FieldKind::choice) json["names"] = field.names;
  if (field.kind == core::FieldKind::number || field.kind == core::FieldKind::integer) {
    json["min"] = valueJson(field, field.min);
    json["max"] = valueJson(field, field.max);
  }
  if (!field.aliases.empty()) json["aliases"] = field.aliases;
  return json;
}

std::string rangeText(const core::Field& field) {
  if (field.kind == core::FieldKind::flag) return "true or false";
  std::string text;
  if (field.kind == core::FieldKind::choice) {
    for (const std::string& name : field.names) text += (text.empty() ? "" : " ") + name;
    return text;
  }
  const auto number = [&](double value) {
    const Json json = valueJson(field, value);
    return json.is_string() ? json.get<std::string>() : json.dump();
  };
  text = number(field.min) + " to " + number(field.max);
  return field.unit.empty() || field.unit == "1" ? text : text + " " + field.unit;
}

std::string defaultText(const core::Field& field) {
  const Json json = valueJson(field, field.defaultValue);
  return json.is_string() ? json.get<std::string>() : json.dump();
}

// All of them, or the one of this path and those below it.
std::vector<const core::Field*> chosen(const core::SettingsTable& table, const std::string& path) {
  std::vector<const core::Field*> fields;
  for (const core::Field& field : table.fields()) {
    if (path.empty() || field.path == path || field.path.starts_with(path + ".")) fields.push_back(&field);
  }
  if (!fields.empty()) return fields;
  try {
    return {&table.at(path)};
  } catch (const core::RangeError& error) {
    throw core::UsageError(std::string("settings: ") + error.what());
  }
}

}  // namespace

int listSettings(const CommandLine& line) {
  Settings settings;
  const core::SettingsTable table(settings);
  const std::vector<const core::Field*> fields = chosen(table, line.settingsPath);
  if (line.asJson) {
    Json list = Json::array();
    for (const core::Field* field : fields) list.push_back(fieldJson(*field));
    print("%s\n", Json{{"schema", 1}, {"settings", list}}.dump(1).c_str());
    return 0;
  }
  for (const core::Field* field : fields) {
    print("%s\t%s\t%s\t%s\n", field->path.c_str(), defaultText(*field).c_str(), rangeText(*field).c_str(),
          field->help.c_str());
  }
  return 0;
}

}  // namespace skydrop::app
