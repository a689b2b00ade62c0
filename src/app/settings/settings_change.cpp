#include "app/settings/settings_change.h"

#include <algorithm>
#include <utility>

namespace skydrop::app {

SettingsChange::SettingsChange(std::initializer_list<std::string> paths)
    : SettingsChange(std::vector<std::string>(paths)) {}

SettingsChange::SettingsChange(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) add(path);
}

SettingsChange SettingsChange::between(const core::SettingsTable& before, const core::SettingsTable& now) {
  SettingsChange change;
  for (std::size_t i = 0; i < now.fields().size(); ++i) {
    const core::Field& field = now.fields()[i];
    if (field.get() != before.fields()[i].get()) change.paths_.push_back(field.path);
  }
  return change;
}

SettingsChange SettingsChange::ofAll(const core::SettingsTable& table) {
  SettingsChange change;
  for (const core::Field& field : table.fields()) change.paths_.push_back(field.path);
  return change;
}

void SettingsChange::add(const std::string& path) {
  if (std::ranges::find(paths_, path) == paths_.end()) paths_.push_back(path);
}

void SettingsChange::add(const SettingsChange& other) {
  for (const std::string& path : other.paths_) add(path);
}

bool SettingsChange::touches(std::string_view path) const {
  if (path.empty()) return !empty();
  return std::ranges::any_of(paths_, [&](std::string_view changed) {
    return changed.starts_with(path) && (changed.size() == path.size() || changed[path.size()] == '.');
  });
}

bool SettingsChange::needs(core::TakesEffect effect, const core::SettingsTable& table) const {
  return std::ranges::any_of(paths_,
                             [&](const std::string& path) { return table.at(path).takesEffect == effect; });
}

void SettingsDependencies::add(std::vector<std::string> paths, Apply apply) {
  dependents_.push_back({std::move(paths), std::move(apply)});
}

void SettingsDependencies::apply(const SettingsChange& change) const {
  for (const Dependent& dependent : dependents_) {
    const bool isTouched =
        std::ranges::any_of(dependent.paths, [&](const std::string& path) { return change.touches(path); });
    if (isTouched) dependent.apply(change);
  }
}

}  // namespace skydrop::app
