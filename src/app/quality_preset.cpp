#include "app/quality_preset.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {

Quality qualityFor(Quality chosen, bool softwareRenderer) {
  if (chosen != Quality::automatic) return chosen;
  return softwareRenderer ? Quality::low : Quality::high;
}

QualityPreset readQualityPreset(Quality quality) {
  const std::string name(kQualityNames[static_cast<std::size_t>(quality)]);
  QualityPreset preset;
  preset.file = core::assetPath("presets/" + name + ".json").string();
  const nlohmann::json json = core::readSettingsFile(preset.file);
  try {
    preset.description = json.at("description").get<std::string>();
    preset.window = {json.at("window").at(0).get<int>(), json.at("window").at(1).get<int>()};
  } catch (const nlohmann::json::exception& error) {
    throw core::DataError(preset.file, "preset", error.what());
  }
  preset.settingsJson = json["settings"].dump();
  return preset;
}

void applyPreset(const core::SettingsTable& table, const QualityPreset& preset) {
  core::applyJson(table, nlohmann::json::parse(preset.settingsJson), preset.file);
}

std::vector<std::string> presetPaths() {
  std::vector<std::string> paths;
  for (const Quality quality : {Quality::low, Quality::medium, Quality::high, Quality::ultra}) {
    const auto json = nlohmann::json::parse(readQualityPreset(quality).settingsJson).flatten();
    for (const auto& [pointer, value] : json.items()) {
      std::string path = pointer.substr(std::min<std::size_t>(1, pointer.size()));
      std::replace(path.begin(), path.end(), '/', '.');
      if (!path.empty() && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
    }
  }
  return paths;
}

}  // namespace skydrop::app
