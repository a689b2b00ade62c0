#include "skydrop/core/settings_file.h"

#include <nlohmann/json.hpp>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/output_file.h"

namespace skydrop::core {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

}  // namespace

nlohmann::json readSettingsFile(const std::filesystem::path& file) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(readTextFile(file, kMostBytes));
  } catch (const nlohmann::json::exception& error) {
    throw DataError(file.string(), "JSON", error.what());
  }
  if (!json.is_object() || json.value("schema", nlohmann::json()) != kSettingsSchema) {
    throw DataError(file.string(), "schema", "is not " + std::to_string(kSettingsSchema));
  }
  if (!json.contains("settings")) json["settings"] = nlohmann::json::object();
  if (!json["settings"].is_object()) throw DataError(file.string(), "settings", "is not an object");
  return json;
}

void writeSettingsFile(const std::filesystem::path& file, const nlohmann::json& members) {
  nlohmann::json json = members;
  json["schema"] = kSettingsSchema;
  makeFolder(file.parent_path());
  OutputFile(file).write(json.dump(2) + "\n", Survives::powerLoss);
}

}  // namespace skydrop::core
