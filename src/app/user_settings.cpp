#include "app/user_settings.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::app {
namespace {

constexpr int kSchema = 1;

void applyFile(const core::SettingsTable& table, const std::filesystem::path& file) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(core::readTextFile(file, std::size_t{1} << 20));
  } catch (const nlohmann::json::exception& error) {
    throw core::DataError(file.string(), "JSON", error.what());
  }
  if (!json.is_object() || json.value("schema", nlohmann::json()) != kSchema) {
    throw core::DataError(file.string(), "schema", "is not " + std::to_string(kSchema));
  }
  core::applyJson(table, json.value("settings", nlohmann::json::object()), file.string());
}

}  // namespace

std::filesystem::path userSettingsFile(const std::filesystem::path& folder) { return folder / "settings.json"; }

void readUserSettings(const core::SettingsTable& table, const std::filesystem::path& folder) {
  applyFile(table, userSettingsFile(folder));
}

std::filesystem::path defaultUserFolder() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && *config == '/') {
    return std::filesystem::path(config) / "skydrop";
  }
  if (const char* home = std::getenv("HOME"); home && *home) {
    return std::filesystem::path(home) / ".config" / "skydrop";
  }
  return {};
}

std::optional<std::string> loadUserSettings(const core::SettingsTable& table, const std::filesystem::path& folder) {
  const std::filesystem::path file = userSettingsFile(folder);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    applyFile(table, file);
    return std::nullopt;
  } catch (const core::DataError& refusal) {
    const std::filesystem::path aside = file.string() + ".bad";
    std::filesystem::rename(file, aside, error);
    return std::string(refusal.what()) + "; defaults are used" +
           (error ? "" : ", the file is kept as " + aside.string());
  }
}

void saveUserSettings(const core::SettingsTable& table, const core::SettingsTable& base,
                      const std::filesystem::path& folder) {
  nlohmann::json changed = nlohmann::json::object();
  const nlohmann::json all = core::toJson(table);
  for (std::size_t i = 0; i < table.fields().size(); ++i) {
    if (table.fields()[i].get() == base.fields()[i].get()) continue;
    std::string pointer = "/" + table.fields()[i].path;
    for (char& c : pointer) {
      if (c == '.') c = '/';
    }
    const nlohmann::json::json_pointer place(pointer);
    changed[place] = all[place];
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw core::DataError(folder.string(), "cannot make the folder", error.message());
  core::writeFileAtomically(userSettingsFile(folder),
                            nlohmann::json{{"schema", kSchema}, {"settings", changed}}.dump(2) + "\n");
}

}  // namespace skydrop::app
