#include "app/settings/user_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/settings/settings.h"
#include "app/settings/xdg_folder.h"

namespace skydrop::app {
namespace {

// The place of a path of settings in their JSON.
nlohmann::json::json_pointer pointerTo(std::string path) {
  std::ranges::replace(path, '.', '/');
  return nlohmann::json::json_pointer("/" + path);
}

// What was written under a name of an earlier version would count again where nothing is chosen any more.
void eraseUnderAnyName(nlohmann::json& settings, const core::SettingsTable& table, const std::string& path) {
  eraseAt(settings, path);
  for (const std::string& formerly : table.formerPaths(path)) eraseAt(settings, formerly);
}

nlohmann::json bindingsOf(const nlohmann::json& content) {
  return content.value("bindings", nlohmann::json::object());
}

// The entries of a file's bindings, changed to what is wanted; those that are not understood stay, unless the
// menu has set their action.
nlohmann::json bindingsJson(const nlohmann::json& inFile, const Bindings::Read& read,
                            const Bindings& wanted) {
  nlohmann::json merged = inFile.is_object() ? inFile : nlohmann::json::object();
  for (std::size_t i = 0; i < kActions; ++i) {
    const auto action = static_cast<Action>(i);
    const bool isChanged = wanted.inputsOf(action) != read.bindings.inputsOf(action);
    if (read.used.contains(action) || isChanged) merged.erase(std::string(actionName(action)));
  }
  const nlohmann::json changed = wanted.toJson();
  for (const auto& [name, inputs] : changed.items()) {
    if (!merged.contains(name)) merged[name] = inputs;
  }
  return merged;
}

}  // namespace

std::filesystem::path userSettingsFile(const std::filesystem::path& folder) {
  return folder / "settings.json";
}

std::filesystem::path defaultUserFolder() { return xdgFolder("XDG_CONFIG_HOME", ".config"); }

Bindings mergedBindings(const Bindings& into, const Bindings& before, const Bindings& after) {
  Bindings merged = into;
  // Twice: on the way one action may need what another has not given away yet.
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < kActions; ++i) {
      const auto action = static_cast<Action>(i);
      if (after.inputsOf(action) != before.inputsOf(action)) merged.assign(action, after.inputsOf(action));
    }
  }
  return merged;
}

std::optional<std::string> UserSettings::load() {
  std::optional<std::string> broken = file_.load();
  std::optional<std::string> complaint = take();
  return broken ? broken : complaint;
}

std::optional<std::string> UserSettings::reload() {
  file_.reload();
  return take();
}

// What the file says that does not fit.
std::optional<std::string> UserSettings::take() {
  Settings scratch;
  std::vector<std::string> complaints =
      core::applyJsonWhereItFits(core::SettingsTable(scratch), file_.content()["settings"]);
  Bindings::Read read = Bindings::fromJson(bindingsOf(file_.content()));
  complaints.insert(complaints.end(), read.complaints.begin(), read.complaints.end());
  bindings_ = std::move(read.bindings);
  return file_.complaintLine(complaints);
}

void UserSettings::applyTo(const core::SettingsTable& table) const {
  nlohmann::json settings = file_.content()["settings"];
  for (const auto& [path, value] : chosen_) eraseUnderAnyName(settings, table, path);
  core::applyJsonWhereItFits(table, settings);
  for (const auto& [path, value] : chosen_) {
    if (value) table.at(path).set(*value);
  }
}

void UserSettings::choose(const std::string& path, std::optional<double> value) { chosen_[path] = value; }

std::optional<std::string> UserSettings::save(const core::SettingsTable& table, const Bindings& bindings) {
  if (file_.path().empty()) return std::nullopt;
  const nlohmann::json values = core::toJson(table);
  std::optional<std::string> line = file_.save([&](nlohmann::json& content) {
    for (const auto& [path, value] : chosen_) {
      if (!isKept(path)) continue;
      eraseUnderAnyName(content["settings"], table, path);
      if (value) setAt(content["settings"], path, values[pointerTo(path)]);
    }
    if (bindings == bindings_) return;
    const Bindings::Read read = Bindings::fromJson(bindingsOf(content));
    const Bindings wanted = mergedBindings(read.bindings, bindings_, bindings);
    content["bindings"] = bindingsJson(bindingsOf(content), read, wanted);
    if (content["bindings"].empty()) content.erase("bindings");
  });
  std::erase_if(chosen_, [](const auto& choice) { return isKept(choice.first); });
  bindings_ = bindings;
  return line;
}

}  // namespace skydrop::app
