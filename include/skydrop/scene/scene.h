// Scene files: what there is to see, hear and do, from which start, with which settings. JSON, schema 1:
//
//   {
//     "schema": 1,
//     "description": "Endless land to fly over, and packages to drop.",
//     "seed": 1,                                  whole number, 0 .. 2^53; --seed overrides it
//     "effects": ["sky", "terrain", ...],         names of effect.h
//     "start": {"position": [x, y, z],            metres; with terrain, y is above the ground or the sea
//               "heading": 90,                    compass degrees
//               "speed": 70,                      m/s
//               "strip": "standing"},             at the grass strip nearest to the position: "standing" at
//               its
//                                                 beginning, or on its "final"; where there is none, as above
//     "weatherFile": "bern.json",                 forecast or report, or several of one place
//     "farWeatherFile": ["a.json", "b.json"],     those of a second site; both for the effect weather
//     "elevationFile": ["a.tif", "b.tif"],        elevation data, for the effect terrain
//     "imageFile": ["a.tif", "b.jpg"],            aerial images, for the effect terrain
//     "imageCorners": [west, south, east, north], of the one image, where its file says nothing of its place
//     "settings": {"aircraft": {...}, ...}        overrides of described settings (app checks them)
//   }
//
// Files are named from the folder of the scene's file. Only `schema` must be there. Unknown members are
// refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/scene/effect.h"

namespace skydrop::scene {

enum class StripStart { none, standing, final };

struct Start {
  glm::dvec3 position{0, 600, 0};       // m; y above the surface where there is terrain
  double headingDegrees = 90;           // compass, [0, 360]
  double speedMps = 70;                 // [0, 300]
  StripStart strip = StripStart::none;  // in place of position and heading
};

struct Scene {
  std::string name;  // the file's stem
  std::filesystem::path file;
  std::string source;  // what loadScene finds it by again, from any folder: a name or an absolute path
  std::string text;    // the content of the file
  std::string description;
  std::uint64_t seed = 1;
  EffectSet effects;
  Start start;
  std::string settingsJson = "{}";  // checked JSON text of an object
  // Weather from files (module forecast); empty for none. A far one only with a near one.
  std::vector<std::filesystem::path> weatherFiles, farWeatherFiles;
  std::vector<std::filesystem::path> elevationFiles;  // of the land (module elevation); empty for none
  std::vector<std::filesystem::path> imageFiles;      // of the ground's colours (module elevation)
  std::optional<std::array<double, 4>> imageCorners;  // west, south, east, north; with one image alone
};

inline constexpr std::size_t kMostSceneBytes = std::size_t{1} << 20;

// A name from assets/scenes, or a path (anything with a slash or ending in .json). Throws DataError.
Scene loadScene(std::string_view nameOrFile);
Scene parseScene(std::string_view text, const std::filesystem::path& file);

// Names in assets/scenes, sorted, whether they can be read or not; and the file of one. Throws DataError.
std::vector<std::string> listScenes();
std::filesystem::path sceneFile(std::string_view name);

// The effects that the scene needs, those included that others rest on: targets need an aircraft and a ground
// to land on, haze needs something to veil. A pure function of the scene.
EffectSet requiredEffects(const Scene& scene);

}  // namespace skydrop::scene
