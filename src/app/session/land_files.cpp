#include "app/session/land_files.h"

#include <array>
#include <cstdio>
#include <optional>

#include "app/session/recorded_files.h"
#include "skydrop/core/error.h"
#include "skydrop/elevation/projection.h"

namespace skydrop::app {
namespace {

std::optional<elevation::ImageCorners> cornersOf(const CommandLine& line, const scene::Scene& scene) {
  if (!line.imageFiles.empty()) return line.imageCorners;
  if (!scene.imageCorners) return std::nullopt;
  const auto& [west, south, east, north] = *scene.imageCorners;
  return elevation::ImageCorners{west, south, east, north};
}

}  // namespace

LandFiles openLandFiles(const CommandLine& line, const scene::Scene& scene, const game::InputLog* log,
                        const std::string& logFile) {
  LandFiles land;
  for (const auto& file : line.imageFiles.empty() ? scene.imageFiles : line.imageFiles)
    land.images.push_back(elevation::openAerialImage(file, cornersOf(line, scene)));
  std::vector<std::filesystem::path> files = line.elevationFiles;
  if (files.empty()) files = log ? sourcesOf(log->elevation) : scene.elevationFiles;
  if (log && log->elevation.size() != files.size())
    throw core::DataError(logFile, "elevation",
                          "was flown over " + std::to_string(log->elevation.size()) +
                              " elevation files, and not over the " + std::to_string(files.size()) +
                              " that are given");
  for (const std::filesystem::path& file : files) land.elevation.push_back(elevation::openRaster(file));
  if (files.empty() || !(log || line.record)) return land;
  std::vector<std::uint64_t> digests;
  for (const std::filesystem::path& file : files) digests.push_back(elevation::contentDigest(file));
  land.records = recordsOf(files, digests, log ? &log->elevation : nullptr, logFile);
  return land;
}

std::vector<std::filesystem::path> filesOfLand(const CommandLine& line, const scene::Scene& scene) {
  std::vector<std::filesystem::path> files;
  const auto add = [&files](const std::vector<std::filesystem::path>& named) {
    for (const std::filesystem::path& file : named) {
      files.push_back(file);
      const std::vector<std::filesystem::path> beside = elevation::filesBeside(file);
      files.insert(files.end(), beside.begin(), beside.end());
    }
  };
  add(line.elevationFiles.empty() ? scene.elevationFiles : line.elevationFiles);
  add(line.imageFiles.empty() ? scene.imageFiles : line.imageFiles);
  return files;
}

bool namesOtherLand(const CommandLine& line, const scene::Scene& before, const scene::Scene& after) {
  const bool otherHeights = line.elevationFiles.empty() && before.elevationFiles != after.elevationFiles;
  const bool otherImages = line.imageFiles.empty() && (before.imageFiles != after.imageFiles ||
                                                       before.imageCorners != after.imageCorners);
  return otherHeights || otherImages;
}

std::vector<std::string> rowsOfLand(const LandFiles& files, const Settings& settings,
                                    const core::SettingsTable& table) {
  std::vector<std::string> rows;
  if (files.elevation.empty() && files.images.empty()) return rows;
  Settings unset;
  const core::SettingsTable defaults(unset);
  const auto put = [&](const std::string& path, double value) {
    if (table.at(path).get() != defaults.at(path).get()) return;  // somebody has said where
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "=%.9f", value);
    rows.push_back(path + text.data());
  };
  elevation::GeoPlace origin{settings.elevation.latitude, settings.elevation.longitude};
  if (settings.elevation.atCentre) {
    origin = files.elevation.empty() ? elevation::centreOf(*files.images[0])
                                     : elevation::centreOf(*files.elevation[0]);
    put("elevation.latitude", origin.latitude);
    put("elevation.longitude", origin.longitude);
  }
  put("render.sun.latitudeDegrees", origin.latitude);
  put("render.sun.longitudeDegrees", origin.longitude);
  return rows;
}

}  // namespace skydrop::app
