// One change of settings as a value: from whoever made it (menu, key, file, log) it goes one way, to whoever
// depends on what it touches. Main thread.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings_table.h"

namespace skydrop::app {

class SettingsChange {
 public:
  SettingsChange() = default;
  // Paths as the fields of the table of app::Settings have them, each counted once, in this order.
  SettingsChange(std::initializer_list<std::string> paths);
  explicit SettingsChange(const std::vector<std::string>& paths);
  // The fields whose values differ; both are tables of app::Settings.
  static SettingsChange between(const core::SettingsTable& before, const core::SettingsTable& now);
  // Of every field: for dependents that have seen nothing yet.
  static SettingsChange ofAll(const core::SettingsTable& table);

  bool empty() const { return paths_.empty(); }
  const std::vector<std::string>& paths() const { return paths_; }
  void add(const std::string& path);
  void add(const SettingsChange& other);

  // Whether the field at this path changed, or one in the group at this path or below it; "" is all groups.
  bool touches(std::string_view path) const;
  // Whether a field changed that takes effect by this (core/settings.h), as the table describes it.
  bool needs(core::TakesEffect effect, const core::SettingsTable& table) const;

 private:
  std::vector<std::string> paths_;
};

// Who is told of a change, by groups of settings; registered once. What a dependent rebuilds is its own to
// decide.
class SettingsDependencies {
 public:
  using Apply = std::function<void(const SettingsChange&)>;

  // `paths`: groups or fields, as SettingsChange::touches() takes them.
  void add(std::vector<std::string> paths, Apply apply);

  // Calls those that the change touches, each once, in the order in which they were added.
  void apply(const SettingsChange& change) const;

 private:
  struct Dependent {
    std::vector<std::string> paths;
    Apply apply;
  };
  std::vector<Dependent> dependents_;
};

}  // namespace skydrop::app
