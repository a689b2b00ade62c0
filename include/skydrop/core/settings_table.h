// A described settings struct (settings.h) as a flat table of fields, reached by path: "aircraft.rollFactor",
// "layers.0.base". JSON, --set, the menu and accuracy studies all work on this table, so that a range or a
// name is defined in one place. The table refers to the struct: it must not outlive it, nor the struct move.
// One thread at a time.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skydrop/core/settings.h"

namespace skydrop::core {

enum class FieldKind { number, integer, flag, choice };

struct Field {
  std::string path;   // "aircraft.rollFactor"
  std::string name;   // "rollFactor"
  std::string group;  // "aircraft"; empty at the top
  FieldKind kind = FieldKind::number;
  std::string unit;
  std::string help;
  double min = 0, max = 0;              // of a choice: 0 .. names - 1; of a flag: 0 .. 1
  double sliderMin = 0, sliderMax = 0;  // the part of it that a slider covers
  double defaultValue = 0;
  TakesEffect takesEffect = TakesEffect::live;
  bool logarithmic = false;
  bool powersOfTwo = false;              // what a slider stops at
  std::vector<std::string> names;        // of a choice
  std::string aliases;                   // "HG, g", or empty
  FieldNote note;                        // may be empty
  const WrittenForm* written = nullptr;  // of a number that is not written in digits

  // Every kind as a double: a flag is 0 or 1, a choice its index. set() does no check: see setField().
  std::function<double()> get;
  std::function<void(double)> set;

  bool isDefault() const { return get() == defaultValue; }
  void reset() const { set(defaultValue); }
};

struct GroupInfo {
  std::string path;
  std::string help;
};

class SettingsTable {
 public:
  // Settings must be default-constructible: its defaults are the fields' defaults.
  template <class Settings>
  explicit SettingsTable(Settings& settings) {
    Settings defaults{};
    const auto visit = [](SettingsVisitor& visitor, void* object) {
      describe(visitor, *static_cast<Settings*>(object));
    };
    build(visit, &settings, &defaults);
  }

  const std::vector<Field>& fields() const { return fields_; }
  const std::vector<GroupInfo>& groups() const { return groups_; }
  // Whether fields lie below this path, or did in an earlier version.
  bool isGroup(std::string_view path) const;
  // By its path, or by one that it had in an earlier version. Null when there is none.
  const Field* find(std::string_view path) const;
  // Whether earlier versions had a field at this path that there is none for now.
  bool isRemoved(std::string_view path) const;
  // The paths that the field at this path had in earlier versions.
  std::vector<std::string> formerPaths(std::string_view path) const;
  // find(), or RangeError: "unknown setting 'x'", with the nearest known paths as a hint; of a removed one,
  // that it is gone.
  const Field& at(std::string_view path) const;
  // Those paths: "; the nearest are 'a', 'b' and 'c'". They are found by aliases and former paths too.
  std::string nearestText(std::string_view path) const;

  // From now on the defaults are the values that `base` has, a table of the same description: what a reset
  // goes back to.
  void takeDefaults(const SettingsTable& base);

 private:
  using Visit = void (*)(SettingsVisitor&, void*);
  void build(Visit visit, void* settings, void* defaults);

  std::vector<Field> fields_;
  std::vector<GroupInfo> groups_;
  std::vector<std::pair<std::string, std::string>> renamed_;  // former path, path
  std::vector<std::string> removed_;                          // paths of former fields
};

// The door: throws RangeError naming path, value and range, and changes nothing, unless the value is finite,
// in range and (integer, choice, flag) whole.
void setField(const Field& field, double value);

// From text as it stands after --set PATH=: a number, true or false, a choice's name, or the field's own
// written form.
void setField(const Field& field, std::string_view text);
// "aircraft.rollFactor=.8"
void setField(const SettingsTable& table, std::string_view assignment);

// The value as setField(text) reads it; numbers with the fewest digits that read back to the same bits.
std::string fieldText(const Field& field);
// A value of the field in its written form, or nothing where it has none.
std::string writtenText(const Field& field, double value);

// Nested JSON of all fields, or of those that differ from their defaults.
nlohmann::json toJson(const SettingsTable& table, bool onlyChanged = false);

// Applies a partial nested object. All or nothing: an unknown name, a wrong type or a value out of range
// throws DataError(file, path, reason) and leaves every field as it was.
void applyJson(const SettingsTable& table, const nlohmann::json& json, std::string_view file);

// The same for a file that the player edits and that another version may have written: what fits is applied,
// and what does not comes back, a line each ("aircraft.mass: -1 is out of range 100 to 20000 kg").
std::vector<std::string> applyJsonWhereItFits(const SettingsTable& table, const nlohmann::json& json);

}  // namespace skydrop::core
