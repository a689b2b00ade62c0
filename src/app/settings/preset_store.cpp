#include "app/settings/preset_store.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/joined.h"
#include "skydrop/core/output_file.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kLongestName = 64;
constexpr std::string_view kEnding = ".json";
constexpr std::string_view kPlayersOwn[] = {"audio", "effects", "view"};

bool isWithin(std::string_view path, std::string_view group) {
  return path.starts_with(group) && (path.size() == group.size() || path[group.size()] == '.');
}

std::string requireName(const std::string& name) {
  const std::string refusal = presetNameRefusal(name);
  if (!refusal.empty()) throw core::RangeError("preset '" + name + "': the name " + refusal);
  return name;
}

bool isGroup(const core::SettingsTable& table, const std::string& path) {
  return std::ranges::find(table.groups(), path, &core::GroupInfo::path) != table.groups().end();
}

std::vector<std::string> groupsOf(const core::SettingsTable& table, const std::vector<std::string>& chosen) {
  for (const std::string& group : chosen) {
    if (!isGroup(table, group)) throw core::RangeError("preset: there is no group '" + group + "'");
  }
  if (!chosen.empty()) return chosen;
  std::vector<std::string> groups;
  for (const core::GroupInfo& info : table.groups()) {
    const bool isTop = info.path.find('.') == std::string::npos;
    const bool isPlayersOwn = std::ranges::find(kPlayersOwn, info.path) != std::end(kPlayersOwn);
    if (isTop && !isPlayersOwn) groups.push_back(info.path);
  }
  return groups;
}

std::vector<std::string> readGroups(const nlohmann::json& json, const std::string& file,
                                    const core::SettingsTable& table) {
  std::vector<std::string> groups;
  const nlohmann::json list = json.value("groups", nlohmann::json());
  if (!list.is_array() || list.empty()) throw core::DataError(file, "groups", "is not a list of groups");
  for (const nlohmann::json& group : list) {
    const std::string path = group.is_string() ? group.get<std::string>() : "";
    if (!isGroup(table, path)) {
      throw core::DataError(file, "groups", group.dump() + " is no group of settings");
    }
    groups.push_back(path);
  }
  return groups;
}

struct Preset {
  std::vector<std::string> groups;
  std::vector<ui::SettingValue> values;
};

Preset readWhole(const std::filesystem::path& path) {
  const std::string file = core::inputName(path);
  const nlohmann::json json =
      core::parseSettings(core::readTextInput(path, core::kMostSettingsBytes), file, {"groups"});
  Settings settings;
  const core::SettingsTable table(settings);
  Preset preset{readGroups(json, file, table), {}};
  core::applyJson(table, json["settings"], file);
  for (const core::Field& field : table.fields()) {
    const auto isHeld = [&](const std::string& place) {
      const auto holds = [&](const std::string& group) { return isWithin(place, group); };
      return std::ranges::any_of(preset.groups, holds);
    };
    // A field that has moved out of the groups since the preset was saved is still set, but not reset.
    const bool wasHeld = !field.isDefault() && std::ranges::any_of(table.formerPaths(field.path), isHeld);
    if (isHeld(field.path) || wasHeld) {
      preset.values.push_back({field.path, field.get()});
    } else if (!field.isDefault()) {
      throw core::DataError(file, field.path, "belongs to no group of this preset");
    }
  }
  return preset;
}

// What cannot be read may be a preset with one slip of the hand: it is not written over.
std::optional<std::filesystem::path> setAsideIfBroken(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  try {
    readWhole(file);
    return std::nullopt;
  } catch (const core::DataError&) {
    return core::setAside(file);
  }
}

}  // namespace

std::string presetNameRefusal(std::string_view name) {
  if (name.empty()) return "is empty";
  if (name.size() > kLongestName) return "is longer than " + std::to_string(kLongestName) + " letters";
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view(" -_.()").find(c) != std::string_view::npos;
  };
  if (!std::ranges::all_of(name, fits)) return "may hold letters, digits, spaces and -_.() only";
  const auto isEdge = [](char c) { return c == ' ' || c == '.'; };
  if (isEdge(name.front()) || isEdge(name.back())) return "begins or ends with a space or a dot";
  return "";
}

std::vector<ui::SettingValue> readPreset(const std::filesystem::path& file) { return readWhole(file).values; }

std::vector<ui::PresetEntry> PresetStore::list() const {
  std::vector<ui::PresetEntry> entries;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder_, error), end; !error && at != end;
       at.increment(error)) {
    if (at->path().extension() != kEnding) continue;
    const std::string name = at->path().stem().string();
    if (!presetNameRefusal(name).empty()) continue;
    ui::PresetEntry entry{name, "", true};
    try {
      entry.holds = core::joined(readWhole(at->path()).groups);
    } catch (const core::DataError& refusal) {
      entry.holds = refusal.what();
      entry.usable = false;
    }
    entries.push_back(std::move(entry));
  }
  std::ranges::sort(entries, {}, &ui::PresetEntry::name);
  return entries;
}

std::filesystem::path PresetStore::file(const std::string& name) const {
  return folder_ / (requireName(name) + std::string(kEnding));
}

std::optional<std::filesystem::path> PresetStore::save(const std::string& name,
                                                       const core::SettingsTable& table,
                                                       const std::vector<std::string>& chosen) const {
  const std::filesystem::path target = file(name);
  const std::vector<std::string> groups = groupsOf(table, chosen);
  // The values of the groups over the program's own defaults, whatever the table takes for its.
  Settings held;
  const core::SettingsTable heldTable(held);
  for (const core::Field& field : table.fields()) {
    const bool isHeld =
        std::ranges::any_of(groups, [&](const std::string& path) { return isWithin(field.path, path); });
    if (isHeld) heldTable.at(field.path).set(field.get());
  }
  std::optional<std::filesystem::path> aside = setAsideIfBroken(target);
  core::writeSettingsFile(target, {{"groups", groups}, {"settings", core::toJson(heldTable, true)}});
  return aside;
}

std::vector<ui::SettingValue> PresetStore::load(const std::string& name) const {
  return readPreset(file(name));
}

void PresetStore::remove(const std::string& name) const {
  const std::filesystem::path target = file(name);
  std::error_code error;
  if (!std::filesystem::remove(target, error)) {
    throw core::DataError(target.string(), "cannot be deleted",
                          error ? error.message() : "there is no such file");
  }
}

std::filesystem::path presetFolder(const std::filesystem::path& userFolder) { return userFolder / "presets"; }

std::vector<std::string> presetOfCommandLine(const std::string& word, const std::filesystem::path& folder) {
  const bool isFile =
      core::isStandardInput(word) || word.find('/') != std::string::npos || word.ends_with(kEnding);
  if (const std::string refusal = presetNameRefusal(word); !isFile && !refusal.empty()) {
    throw core::UsageError("--preset: the name '" + word + "' " + refusal);
  }
  Settings settings;
  const core::SettingsTable table(settings);
  std::vector<std::string> assignments;
  for (const ui::SettingValue& value : isFile ? readPreset(word) : PresetStore(folder).load(word)) {
    const core::Field& field = table.at(value.path);
    field.set(value.value);
    assignments.push_back(value.path + "=" + core::fieldText(field));
  }
  return assignments;
}

}  // namespace skydrop::app
