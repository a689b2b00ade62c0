#include <array>
#include <cmath>

#include "app/studies/light_scenes.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::app {
namespace {

constexpr int kSchema = 1;
constexpr double kUnit = 1e-5;  // of the file's whole numbers
constexpr double kMostUnits = 1e9;
constexpr std::size_t kPixels = std::size_t{kLightViewWidth} * kLightViewHeight;

struct Column {
  const char* name;
  double clouds::TracedLight::*of;
  clouds::TracedLight clouds::TracedPixel::*in;
};
constexpr std::array<Column, 8> kColumns = {{
    {"sun", &clouds::TracedLight::sun, &clouds::TracedPixel::mean},
    {"sky", &clouds::TracedLight::sky, &clouds::TracedPixel::mean},
    {"ground", &clouds::TracedLight::ground, &clouds::TracedPixel::mean},
    {"transmittance", &clouds::TracedLight::transmittance, &clouds::TracedPixel::mean},
    {"sunError", &clouds::TracedLight::sun, &clouds::TracedPixel::error},
    {"skyError", &clouds::TracedLight::sky, &clouds::TracedPixel::error},
    {"groundError", &clouds::TracedLight::ground, &clouds::TracedPixel::error},
    {"transmittanceError", &clouds::TracedLight::transmittance, &clouds::TracedPixel::error},
}};

std::string digestText(const LightScene& scene) { return std::to_string(scene.digest()); }

const nlohmann::json& memberOf(const nlohmann::json& object, const char* name, const std::string& file,
                               const std::string& place) {
  if (!object.is_object() || !object.contains(name))
    throw core::DataError(file, place, std::string("'") + name + "' is missing");
  return object[name];
}

const nlohmann::json& listOf(const nlohmann::json& object, const char* name, std::size_t size,
                             const std::string& file, const std::string& place) {
  const nlohmann::json& list = memberOf(object, name, file, place);
  if (!list.is_array() || list.size() != size)
    throw core::DataError(file, place,
                          std::string("'") + name + "' has to be a list of " + std::to_string(size));
  return list;
}

}  // namespace

std::filesystem::path judgedFile(const LightScene& scene) {
  return core::assetPath("judged_clouds/" + scene.name + ".json");
}

std::string judgedText(const LightScene& scene, const JudgedLight& judged) {
  std::string text = "{\n \"schema\": " + std::to_string(kSchema) + ",\n \"scene\": \"" + scene.name +
                     "\",\n \"digest\": \"" + digestText(scene) +
                     "\",\n \"paths\": " + std::to_string(judged.paths) + ",\n \"unit\": \"1e-5 /sr\"" +
                     ",\n \"views\": [";
  for (std::size_t v = 0; v < judged.views.size(); ++v) {
    text += v == 0 ? "\n  {" : ",\n  {";
    for (const Column& column : kColumns) {
      text += column.name == kColumns[0].name ? "\n" : ",\n";
      text += std::string("   \"") + column.name + "\": [";
      for (std::size_t i = 0; i < kPixels; ++i) {
        text += (i == 0 ? "" : ",") +
                std::to_string(std::lround(judged.views[v][i].*column.in.*column.of / kUnit));
      }
      text += "]";
    }
    text += "\n  }";
  }
  return text + "\n ]\n}\n";
}

JudgedLight readJudged(const LightScene& scene, const std::filesystem::path& path) {
  const std::string file = path.string();
  const nlohmann::json json = core::readJson(path);
  core::jsonWhole(memberOf(json, "schema", file, ""), file, "schema", kSchema, kSchema);
  if (core::jsonText(memberOf(json, "digest", file, ""), file, "digest") != digestText(scene))
    throw core::DataError(file, "digest", "is of another scene: skydrop accuracy judge makes it again");
  JudgedLight judged;
  judged.paths = static_cast<int>(core::jsonWhole(memberOf(json, "paths", file, ""), file, "paths", 2, 1e9));
  const std::size_t views = lightViews(scene).size();
  for (const nlohmann::json& view : listOf(json, "views", views, file, "")) {
    const std::string place = "views." + std::to_string(judged.views.size());
    std::vector<clouds::TracedPixel>& pixels = judged.views.emplace_back(kPixels);
    for (const Column& column : kColumns) {
      const nlohmann::json& list = listOf(view, column.name, kPixels, file, place);
      for (std::size_t i = 0; i < kPixels; ++i)
        pixels[i].*column.in.*column.of =
            kUnit * core::jsonWhole(list[i], file, place + "." + column.name, -kMostUnits, kMostUnits);
    }
  }
  return judged;
}

}  // namespace skydrop::app
