#include "app/settings/quality_preset.h"

#include <algorithm>
#include <utility>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

// Of all that it sets: "streaming.pixelError".
std::vector<std::string> pathsOf(const QualityPreset& preset) {
  std::vector<std::string> paths;
  const auto json = core::parseJson(preset.settingsJson, preset.file).flatten();
  for (const auto& [pointer, value] : json.items()) {
    std::string path = pointer.substr(std::min<std::size_t>(1, pointer.size()));
    std::replace(path.begin(), path.end(), '/', '.');
    if (!path.empty()) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace

Quality qualityFor(Quality chosen, bool softwareRenderer) {
  if (chosen != Quality::automatic) return chosen;
  return softwareRenderer ? Quality::low : Quality::high;
}

QualityPreset readQualityPreset(Quality quality) {
  const std::string name(kQualityNames[static_cast<std::size_t>(quality)]);
  return readQualityPreset(core::assetPath("presets/" + name + ".json"));
}

QualityPreset readQualityPreset(const std::filesystem::path& file) {
  QualityPreset preset;
  preset.file = file.string();
  const nlohmann::json json = core::readSettingsFile(file, {"description", "window"});
  preset.description =
      core::jsonText(json.value("description", nlohmann::json()), preset.file, "description");
  const nlohmann::json window = json.value("window", nlohmann::json());
  if (!window.is_array() || window.size() != 2)
    throw core::DataError(preset.file, "window", "is not a list of width and height");
  const auto side = [&](std::size_t i) {
    return static_cast<int>(core::jsonWhole(window[i], preset.file, "window", 1, kMaxSide));
  };
  preset.window = {side(0), side(1)};
  preset.settingsJson = json["settings"].dump();
  for (const std::string& path : pathsOf(preset)) {
    if (decidesSimulation(path))
      throw core::DataError(preset.file, path, "a quality leaves the simulation alone");
  }
  return preset;
}

void applyPreset(const core::SettingsTable& table, const QualityPreset& preset) {
  core::applyJson(table, core::parseJson(preset.settingsJson, preset.file), preset.file);
}

std::vector<std::string> presetPaths() {
  std::vector<std::string> paths;
  for (const Quality quality : {Quality::low, Quality::medium, Quality::high, Quality::ultra}) {
    for (std::string& path : pathsOf(readQualityPreset(quality))) {
      if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(std::move(path));
    }
  }
  return paths;
}

}  // namespace skydrop::app
