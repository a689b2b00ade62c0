// The tiers of the clouds as data: assets/clouds/NAME.json says how exactly a tier marches through a layer.
// What it says lies right above the defaults, below the quality's preset, which chooses the tier.
#pragma once

#include <filesystem>
#include <string>

#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

struct CloudTierFile {
  std::string description;
  std::string file;
  std::string settingsJson;  // rows of clouds.march and nothing else
};

std::filesystem::path cloudTierPath(clouds::CloudTier tier);

// Throws core::DataError.
CloudTierFile readCloudTier(const std::filesystem::path& file);

// Of a table of app::Settings. Throws core::DataError, and then changes nothing.
void applyCloudTier(const core::SettingsTable& table, const CloudTierFile& tier);

// The row that picks a tier, and whether another follows when it is picked.
inline constexpr std::string_view kCloudTierRow = "clouds.tier";
bool belongsToCloudTier(std::string_view path);

}  // namespace skydrop::app
