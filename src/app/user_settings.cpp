#include "app/user_settings.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/settings.h"
#include "app/xdg_folder.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

void applyFile(const core::SettingsTable& table, Bindings& bindings, const std::filesystem::path& file) {
  const nlohmann::json json = core::readSettingsFile(file);
  Bindings changed = Bindings::fromJson(json.value("bindings", nlohmann::json::object()), file.string());
  core::applyJson(table, json["settings"], file.string());
  bindings = std::move(changed);
}

}  // namespace

std::filesystem::path userSettingsFile(const std::filesystem::path& folder) {
  return folder / "settings.json";
}

void readUserSettings(const core::SettingsTable& table, Bindings& bindings,
                      const std::filesystem::path& folder) {
  applyFile(table, bindings, userSettingsFile(folder));
}

std::filesystem::path defaultUserFolder() { return xdgFolder("XDG_CONFIG_HOME", ".config"); }

std::optional<std::string> loadOrSetAside(const std::filesystem::path& file,
                                          const std::function<void()>& load) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    load();
    return std::nullopt;
  } catch (const core::DataError& refusal) {
    const std::filesystem::path aside = file.string() + ".bad";
    std::filesystem::rename(file, aside, error);
    return std::string(refusal.what()) + "; defaults are used" +
           (error ? "" : ", the file is kept as " + aside.string());
  }
}

std::optional<std::string> loadUserSettings(const core::SettingsTable& table, Bindings& bindings,
                                            const std::filesystem::path& folder) {
  const std::filesystem::path file = userSettingsFile(folder);
  return loadOrSetAside(file, [&] { applyFile(table, bindings, file); });
}

nlohmann::json changedJson(const core::SettingsTable& table, const core::SettingsTable& base) {
  nlohmann::json changed = nlohmann::json::object();
  const nlohmann::json all = core::toJson(table);
  for (std::size_t i = 0; i < table.fields().size(); ++i) {
    if (table.fields()[i].get() == base.fields()[i].get() || !isKept(table.fields()[i].path)) continue;
    std::string pointer = "/" + table.fields()[i].path;
    for (char& c : pointer) {
      if (c == '.') c = '/';
    }
    const nlohmann::json::json_pointer place(pointer);
    changed[place] = all[place];
  }
  return changed;
}

void saveUserSettings(const core::SettingsTable& table, const core::SettingsTable& base,
                      const Bindings& bindings, const std::filesystem::path& folder) {
  const std::filesystem::path file = userSettingsFile(folder);
  nlohmann::json json = {{"settings", changedJson(table, base)}};
  if (nlohmann::json changed = bindings.toJson(); !changed.empty()) json["bindings"] = std::move(changed);
  std::error_code ignored;
  if (json["settings"].empty() && !json.contains("bindings") && !std::filesystem::exists(file, ignored))
    return;
  core::writeSettingsFile(file, std::move(json));
}

}  // namespace skydrop::app
