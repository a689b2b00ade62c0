#include "skydrop/scene/scene.h"

#include <algorithm>
#include <system_error>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/joined.h"
#include "skydrop/core/json.h"
#include "skydrop/core/nearest_names.h"
#include "skydrop/flight/environment.h"

namespace skydrop::scene {
namespace {

using core::DataError;
using nlohmann::json;

constexpr int kSchema = 1;
constexpr std::string_view kEnding = ".json";
constexpr double kFarthestStartM = 1e12;  // where doubles still resolve a tenth of a millimetre

class SceneReader {
 public:
  explicit SceneReader(const std::filesystem::path& file) : file_(file.string()) {}

  Scene read(const json& root) {
    if (!root.is_object()) fail("scene", "is not an object");
    Scene scene;
    checkSchema(root);
    for (const auto& [name, value] : root.items()) {
      if (name == "schema") continue;
      if (name == "description")
        scene.description = text(value, name);
      else if (name == "seed")
        scene.seed = static_cast<std::uint64_t>(whole(value, name, 0, 0x1p53));
      else if (name == "effects")
        readEffects(value, scene.effects);
      else if (name == "start")
        readStart(value, scene.start);
      else if (name == "settings")
        scene.settingsJson = settings(value);
      else if (name == "weatherFile")
        scene.weatherFiles = filesBeside(value, name);
      else if (name == "farWeatherFile")
        scene.farWeatherFiles = filesBeside(value, name);
      else if (name == "elevationFile")
        scene.elevationFiles = filesBeside(value, name, kMostElevationFiles);
      else if (name == "imageFile")
        scene.imageFiles = filesBeside(value, name, kMostElevationFiles);
      else if (name == "imageCorners")
        scene.imageCorners = corners(value, name);
      else
        fail(name, "unknown member");
    }
    if (scene.weatherFiles.empty() && !scene.farWeatherFiles.empty())
      fail("farWeatherFile", "there is no weatherFile");
    if (!scene.weatherFiles.empty() && !scene.effects.contains(Effect::weather))
      fail("weatherFile", "the scene does not name the effect weather");
    if (!scene.elevationFiles.empty() && !scene.effects.contains(Effect::terrain))
      fail("elevationFile", "the scene does not name the effect terrain");
    if (!scene.imageFiles.empty() && !scene.effects.contains(Effect::terrain))
      fail("imageFile", "the scene does not name the effect terrain");
    if (scene.imageCorners && scene.imageFiles.size() != 1)
      fail("imageCorners", "there is not one imageFile");
    return scene;
  }

 private:
  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw DataError(file_, place, reason);
  }

  void checkSchema(const json& root) const {
    if (!root.contains("schema")) fail("schema", "is missing");
    if (root["schema"] != kSchema)
      fail("schema", root["schema"].dump() + " is not " + std::to_string(kSchema));
  }

  std::string text(const json& value, std::string_view place) const {
    return core::jsonText(value, file_, place);
  }

  double number(const json& value, std::string_view place, double least, double most) const {
    return core::jsonNumber(value, file_, place, least, most);
  }

  double whole(const json& value, std::string_view place, double least, double most) const {
    return core::jsonWhole(value, file_, place, least, most);
  }

  void readEffects(const json& value, EffectSet& effects) const {
    if (!value.is_array()) fail("effects", "is not a list");
    for (const json& entry : value) {
      const std::string effect = text(entry, "effects");
      const auto found = std::find(kEffectNames.begin(), kEffectNames.end(), effect);
      if (found == kEffectNames.end())
        fail("effects", "unknown effect " + entry.dump() + core::nearestText(effect, kEffectNames));
      effects.insert(static_cast<Effect>(found - kEffectNames.begin()));
    }
  }

  void readStart(const json& value, Start& start) const {
    if (!value.is_object()) fail("start", "is not an object");
    for (const auto& [name, member] : value.items()) {
      const std::string place = "start." + name;
      if (name == "position") {
        if (!member.is_array() || member.size() != 3) fail(place, "is not a list of three numbers");
        for (int i = 0; i < 3; ++i) {
          start.position[i] = number(member[static_cast<std::size_t>(i)], place, -kFarthestStartM,
                                     i == 1 ? flight::kCeiling : kFarthestStartM);
        }
      } else if (name == "heading") {
        start.headingDegrees = number(member, place, 0, 360);
      } else if (name == "speed") {
        start.speedMps = number(member, place, 0, 300);
      } else if (name == "strip") {
        const std::string where = text(member, place);
        if (where != "standing" && where != "final") fail(place, "is neither \"standing\" nor \"final\"");
        start.strip = where == "standing" ? StripStart::standing : StripStart::final;
      } else {
        fail(place, "unknown member");
      }
    }
  }

  // A text, or a list of them.
  static constexpr std::size_t kMostWeatherFiles = 100, kMostElevationFiles = 1000;
  std::vector<std::filesystem::path> filesBeside(const json& value, std::string_view place,
                                                 std::size_t most = kMostWeatherFiles) const {
    std::vector<std::filesystem::path> files;
    for (const json& entry : value.is_array() ? value : json::array({value})) {
      const std::string name = text(entry, place);
      if (name.empty()) fail(place, "is empty");
      if (files.size() == most) fail(place, "names more than " + std::to_string(most) + " files");
      files.push_back(std::filesystem::path(file_).parent_path() / name);
    }
    return files;
  }

  std::array<double, 4> corners(const json& value, std::string_view place) const {
    if (!value.is_array() || value.size() != 4) fail(place, "is not a list of four numbers");
    std::array<double, 4> all{};
    for (std::size_t i = 0; i < 4; ++i) all[i] = number(value[i], place, -1e9, 1e9);
    return all;
  }

  std::string settings(const json& value) const {
    if (!value.is_object()) fail("settings", "is not an object");
    return value.dump();
  }

  std::string file_;
};

}  // namespace

Scene parseScene(std::string_view text, const std::filesystem::path& file) {
  Scene scene = SceneReader(file).read(core::parseJson(text, file.string()));
  scene.file = file;
  scene.name = file.stem().string();
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(file, error);
  scene.source = (error ? file : absolute).string();
  scene.text = text;
  return scene;
}

Scene loadScene(std::string_view nameOrFile) {
  const bool isPath = nameOrFile.find('/') != std::string_view::npos || nameOrFile.ends_with(kEnding);
  const std::filesystem::path file = isPath ? std::filesystem::path(nameOrFile) : sceneFile(nameOrFile);
  std::error_code ignored;
  if (!isPath && !std::filesystem::exists(file, ignored)) {
    throw DataError(nameOrFile, "scene",
                    "there is none of this name; there are: " + core::joined(listScenes()));
  }
  Scene scene = parseScene(core::readTextFile(file, kMostSceneBytes), file);
  if (!isPath) scene.source = nameOrFile;
  return scene;
}

std::filesystem::path sceneFile(std::string_view name) {
  return core::assetPath("scenes") / (std::string(name) + std::string(kEnding));
}

std::vector<std::string> listScenes() {
  const std::filesystem::path folder = core::assetPath("scenes");
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == kEnding) names.push_back(at->path().stem().string());
  }
  if (error) throw DataError(folder.string(), "scenes", error.message());
  std::sort(names.begin(), names.end());
  return names;
}

EffectSet requiredEffects(const Scene& scene) { return effective(withNeeds(scene.effects)); }

}  // namespace skydrop::scene
