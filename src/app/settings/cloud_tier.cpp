#include "app/settings/cloud_tier.h"

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

// Refuses what a tier has no say in, at the first level that is not of clouds.march.
void requireMarchOnly(const nlohmann::json& settings, const std::string& file) {
  const nlohmann::json* level = &settings;
  std::string path;
  for (const char* group : {"clouds", "march"}) {
    for (const auto& [name, value] : level->items()) {
      if (name != group) throw core::DataError(file, path + name, "a tier sets rows of clouds.march only");
    }
    if (!level->contains(group)) return;
    level = &(*level)[group];
    path += std::string(group) + ".";
    if (!level->is_object()) return;  // applyJson() says what is wrong with it
  }
}

}  // namespace

std::filesystem::path cloudTierPath(clouds::CloudTier tier) {
  const std::string name(clouds::kCloudTierNames[static_cast<std::size_t>(tier)]);
  return core::assetPath("clouds/" + name + ".json");
}

CloudTierFile readCloudTier(const std::filesystem::path& file) {
  CloudTierFile tier;
  tier.file = file.string();
  const nlohmann::json json = core::readSettingsFile(file, {"description"});
  tier.description = core::jsonText(json.value("description", nlohmann::json()), tier.file, "description");
  requireMarchOnly(json["settings"], tier.file);
  tier.settingsJson = json["settings"].dump();
  return tier;
}

void applyCloudTier(const core::SettingsTable& table, const CloudTierFile& tier) {
  core::applyJson(table, core::parseJson(tier.settingsJson, tier.file), tier.file);
}

bool belongsToCloudTier(std::string_view path) { return path.starts_with("clouds.march."); }

}  // namespace skydrop::app
