#include "app/settings/mood.h"

#include <algorithm>
#include <string>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

// What a mood may set: pictures alone.
constexpr std::array<std::string_view, 6> kGroups = {
    "render.sun.", "render.atmosphere.", "render.picture.exposureStops", "clouds.", "cloudPlanes.", "stars."};

std::string fileOf(Mood mood) {
  const std::string name(kMoodNames[static_cast<std::size_t>(mood)]);
  return core::assetPath("moods/" + name + ".json").string();
}

nlohmann::json readRows(const std::string& file) {
  const nlohmann::json json = core::readSettingsFile(file, {"description"});
  core::jsonText(json.value("description", nlohmann::json()), file, "description");
  return json["settings"];
}

std::vector<std::string> pathsOf(const nlohmann::json& rows) {
  std::vector<std::string> paths;
  const nlohmann::json flat = rows.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    std::string path = pointer.substr(std::min<std::size_t>(1, pointer.size()));
    std::replace(path.begin(), path.end(), '/', '.');
    if (!path.empty()) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace

void describe(core::SettingsVisitor& visitor, MoodSettings& settings) {
  visitor.choice(
      "mood", settings.mood, kMoodNames,
      {.help = "Sets time, place, air and clouds together, from dawn to a night of stars; rows that "
               "are set after it stay as they are.",
       .aliases = "time of day, sunrise, sunset, weather, preset"});
}

void applyMood(const core::SettingsTable& table, Mood mood) {
  if (mood == Mood::none) return;
  const std::string file = fileOf(mood);
  const nlohmann::json rows = readRows(file);
  for (const std::string& path : pathsOf(rows)) {
    const auto holds = [&](std::string_view group) { return path.starts_with(group); };
    if (std::ranges::none_of(kGroups, holds) || path == "clouds.tier" || path.starts_with("clouds.march."))
      throw core::DataError(file, path, "a mood sets rows of sun, air, clouds and stars only");
  }
  core::applyJson(table, rows, file);
}

std::vector<std::string> moodPaths() {
  std::vector<std::string> all;
  for (std::size_t i = 1; i < kMoodNames.size(); ++i) {
    for (std::string& path : pathsOf(readRows(fileOf(static_cast<Mood>(i))))) {
      if (std::ranges::find(all, path) == all.end()) all.push_back(std::move(path));
    }
  }
  return all;
}

}  // namespace skydrop::app
