#include "skydrop/core/settings_file.h"

#include <algorithm>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"
#include "skydrop/core/output_file.h"

namespace skydrop::core {

nlohmann::json parseSettings(std::string_view text, std::string_view file,
                             std::initializer_list<std::string_view> members, UnknownMembers unknown) {
  nlohmann::json json = parseJson(text, file, {.bytes = kMostSettingsBytes});
  if (!json.is_object()) throw DataError(file, "JSON", "is not an object");
  if (json.value("schema", nlohmann::json()) != kSettingsSchema)
    throw DataError(file, "schema", "is not " + std::to_string(kSettingsSchema));
  for (const auto& [name, value] : json.items()) {
    const bool known =
        name == "schema" || name == "settings" || std::ranges::find(members, name) != members.end();
    if (!known && unknown == UnknownMembers::refuse) throw DataError(file, name, "unknown member");
  }
  if (!json.contains("settings")) json["settings"] = nlohmann::json::object();
  if (!json["settings"].is_object()) throw DataError(file, "settings", "is not an object");
  return json;
}

nlohmann::json readSettingsFile(const std::filesystem::path& file,
                                std::initializer_list<std::string_view> members, UnknownMembers unknown) {
  return parseSettings(readTextFile(file, kMostSettingsBytes), file.string(), members, unknown);
}

void writeSettingsFile(const std::filesystem::path& file, const nlohmann::json& members) {
  nlohmann::json json = members;
  json["schema"] = kSettingsSchema;
  makeFolder(file.parent_path());
  const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  OutputFile(file).write(text, Survives::powerLoss);
}

}  // namespace skydrop::core
