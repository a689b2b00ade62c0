// Presets of the player, qualities and tiers.
#include "app/settings/cloud_tier.h"
#include "app/settings/preset_store.h"
#include "app/settings/quality_preset.h"
#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static app::Settings settings;
  static const core::SettingsTable table(settings);
  const std::filesystem::path file = fuzz::inputFile("a.json", data, size);
  fuzz::accepts("a.json", [&] { app::readPreset(file); });
  fuzz::accepts("a.json", [&] { app::applyPreset(table, app::readQualityPreset(file)); });
  fuzz::accepts("a.json", [&] { app::applyCloudTier(table, app::readCloudTier(file)); });
  return 0;
}
