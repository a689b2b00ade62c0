#include "skydrop/core/settings_table.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/nearest_names.h"

namespace skydrop::core {
namespace {

// Collects the fields of one walk.
class TableBuilder final : public SettingsVisitor {
 public:
  using Renamed = std::vector<std::pair<std::string, std::string>>;

  TableBuilder(std::vector<Field>& fields, std::vector<GroupInfo>& groups, Renamed& renamed,
               std::vector<std::string>& removed)
      : fields_(fields), groups_(groups), renamed_(renamed), removed_(removed) {}

  void number(std::string_view name, double& value, const NumberInfo& info) override {
    Field& field = add(name, FieldKind::number, info);
    field.get = [&value] { return value; };
    field.set = [&value](double v) { value = v; };
  }

  void integer(std::string_view name, std::int64_t& value, const NumberInfo& info) override {
    Field& field = add(name, FieldKind::integer, info);
    field.get = [&value] { return static_cast<double>(value); };
    field.set = [&value](double v) { value = static_cast<std::int64_t>(v); };
  }

  void flag(std::string_view name, bool& value, const ChoiceInfo& info) override {
    Field& field = add(name, FieldKind::flag, whole(1, info));
    field.get = [&value] { return value ? 1.0 : 0.0; };
    field.set = [&value](double v) { value = v != 0; };
  }

  void choiceByIndex(std::string_view name, std::function<int()> get, std::function<void(int)> set,
                     std::span<const std::string_view> names, const ChoiceInfo& info) override {
    Field& field = add(name, FieldKind::choice, whole(static_cast<double>(names.size()) - 1, info));
    field.names.assign(names.begin(), names.end());
    field.get = [get = std::move(get)] { return static_cast<double>(get()); };
    field.set = [set = std::move(set)](double v) { set(static_cast<int>(v)); };
  }

  void enterGroup(std::string_view name, std::string_view help) override {
    prefixLengths_.push_back(prefix_.size());
    if (!prefix_.empty()) prefix_ += '.';
    prefix_ += name;
    groups_.push_back({prefix_, std::string(help)});
  }

  void leaveGroup() override {
    prefix_.resize(prefixLengths_.back());
    prefixLengths_.pop_back();
  }

  void renamed(std::string_view formerly, std::string_view now) override {
    renamed_.emplace_back(pathOf(formerly), pathOf(now));
  }

  void removed(std::string_view name) override { removed_.push_back(pathOf(name)); }

 private:
  std::string pathOf(std::string_view name) const {
    return prefix_.empty() ? std::string(name) : prefix_ + "." + std::string(name);
  }

  static NumberInfo whole(double max, const ChoiceInfo& info) {
    NumberInfo number{"", 0, max, info.help, info.takesEffect};
    number.aliases = info.aliases;
    number.note = info.note;
    return number;
  }

  Field& add(std::string_view name, FieldKind kind, const NumberInfo& info) {
    Field field;
    field.name = name;
    field.group = prefix_;
    field.path = pathOf(name);
    field.kind = kind;
    field.unit = info.unit;
    field.help = info.help;
    field.min = info.min;
    field.max = info.max;
    const Range slider = info.slider.value_or(Range{info.min, info.max});
    field.sliderMin = slider.min;
    field.sliderMax = slider.max;
    field.takesEffect = info.takesEffect;
    field.logarithmic = info.logarithmic;
    field.powersOfTwo = info.powersOfTwo;
    field.aliases = info.aliases;
    field.note = info.note;
    field.written = info.written;
    return fields_.emplace_back(std::move(field));
  }

  std::vector<Field>& fields_;
  std::vector<GroupInfo>& groups_;
  Renamed& renamed_;
  std::vector<std::string>& removed_;
  std::string prefix_;
  std::vector<std::size_t> prefixLengths_;
};

std::string numberText(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string valueText(const Field& field, double value) {
  return field.written && std::isfinite(value) ? field.written->write(value) : numberText(value);
}

// Why the field cannot take the value; empty when it can.
std::string refusal(const Field& field, double value) {
  if (!std::isfinite(value)) return "is not a finite number";
  if (value < field.min || value > field.max) {
    return "is out of range " + valueText(field, field.min) + " to " + valueText(field, field.max) +
           (field.unit.empty() || field.unit == "1" ? "" : " " + field.unit);
  }
  if (field.kind != FieldKind::number && value != std::floor(value)) return "is not a whole number";
  return "";
}

// Reads a value, or returns why it cannot be read.
std::string parseValue(const Field& field, std::string_view text, double& value) {
  if (field.kind == FieldKind::flag) {
    if (text != "true" && text != "false") return "is not true or false";
    value = text == "true" ? 1 : 0;
    return "";
  }
  if (field.kind == FieldKind::choice) {
    const auto found = std::find(field.names.begin(), field.names.end(), text);
    if (found == field.names.end()) {
      std::string reason = "is not one of";
      for (const std::string& name : field.names) reason += " " + name;
      return reason;
    }
    value = static_cast<double>(found - field.names.begin());
    return "";
  }
  if (field.written) {
    const std::string reason = field.written->read(text, value);
    return reason.empty() ? refusal(field, value) : reason;
  }
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return "is not a number";
  return refusal(field, value);
}

struct Change {
  const Field* field;
  double value;
  bool byFormerName;
};

// Those by a current name last, so that they count.
void apply(const std::vector<Change>& changes) {
  for (const bool byFormerName : {true, false}) {
    for (const Change& change : changes) {
      if (change.byFormerName == byFormerName) change.field->set(change.value);
    }
  }
}

const std::string kUnknown = "unknown setting";

// What becomes of a value that does not fit: a place and a reason.
using Complain = std::function<void(const std::string&, const std::string&)>;

void collectChanges(const SettingsTable& table, const nlohmann::json& json, const std::string& prefix,
                    const Complain& complain, std::vector<Change>& changes) {
  if (!json.is_object()) return complain(prefix.empty() ? "settings" : prefix, "is not an object");
  for (const auto& [name, value] : json.items()) {
    const std::string path = prefix.empty() ? name : prefix + "." + name;
    const Field* field = table.find(path);
    if (!field) {
      if (table.isRemoved(path)) continue;
      if (!table.isGroup(path)) {
        complain(path, kUnknown);
      } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
          collectChanges(table, nlohmann::json{{std::to_string(i), value[i]}}, path, complain, changes);
        }
      } else {
        collectChanges(table, value, path, complain, changes);
      }
      continue;
    }
    double number = 0;
    std::string reason;
    switch (field->kind) {
      case FieldKind::number:
      case FieldKind::integer:
        if (field->written) {
          reason = value.is_string() ? parseValue(*field, value.get<std::string>(), number)
                                     : "is not a text in quotes";
        } else if (!value.is_number()) {
          reason = "is not a number";
        } else {
          number = value.get<double>();
          reason = refusal(*field, number);
        }
        break;
      case FieldKind::flag:
        if (!value.is_boolean())
          reason = "is not true or false";
        else
          number = value.get<bool>() ? 1 : 0;
        break;
      case FieldKind::choice:
        if (!value.is_string())
          reason = "is not a name in quotes";
        else
          reason = parseValue(*field, value.get<std::string>(), number);
        break;
    }
    if (reason.empty()) {
      changes.push_back({field, number, field->path != path});
    } else {
      complain(path, value.dump() + " " + reason);
    }
  }
}

nlohmann::json valueJson(const Field& field) {
  const double value = field.get();
  if (field.written) return field.written->write(value);
  switch (field.kind) {
    case FieldKind::integer:
      return static_cast<std::int64_t>(value);
    case FieldKind::flag:
      return value != 0;
    case FieldKind::choice:
      return field.names[static_cast<std::size_t>(value)];
    case FieldKind::number:
      break;
  }
  return value;
}

}  // namespace

void SettingsTable::build(Visit visit, void* settings, void* defaults) {
  TableBuilder builder(fields_, groups_, renamed_, removed_);
  visit(builder, settings);
  std::vector<Field> defaultFields;
  std::vector<GroupInfo> ignoredGroups;
  TableBuilder::Renamed ignoredNames;
  std::vector<std::string> ignoredRemoved;
  TableBuilder defaultBuilder(defaultFields, ignoredGroups, ignoredNames, ignoredRemoved);
  visit(defaultBuilder, defaults);
  for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i].defaultValue = defaultFields[i].get();
  for (const auto& [formerly, now] : renamed_) {
    const auto field = std::ranges::find(fields_, now, &Field::path);
    assert(field != fields_.end() && std::ranges::find(fields_, formerly, &Field::path) == fields_.end());
    const std::string name = formerly.substr(formerly.rfind('.') + 1);
    if (name != field->name) field->aliases += (field->aliases.empty() ? "" : ", ") + name;
  }
}

void SettingsTable::takeDefaults(const SettingsTable& base) {
  for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i].defaultValue = base.fields_[i].get();
}

const Field* SettingsTable::find(std::string_view path) const {
  for (const Field& field : fields_) {
    if (field.path == path) return &field;
  }
  for (const auto& [formerly, now] : renamed_) {
    if (formerly == path) return find(now);
  }
  return nullptr;
}

bool SettingsTable::isGroup(std::string_view path) const {
  const std::string below = std::string(path) + ".";
  return std::ranges::any_of(groups_, [&](const GroupInfo& group) { return group.path == path; }) ||
         std::ranges::any_of(renamed_, [&](const auto& names) { return names.first.starts_with(below); });
}

bool SettingsTable::isRemoved(std::string_view path) const {
  return std::ranges::find(removed_, path) != removed_.end();
}

std::vector<std::string> SettingsTable::formerPaths(std::string_view path) const {
  std::vector<std::string> paths;
  for (const auto& [formerly, now] : renamed_) {
    if (now == path) paths.push_back(formerly);
  }
  return paths;
}

const Field& SettingsTable::at(std::string_view path) const {
  if (const Field* field = find(path)) return *field;
  if (isRemoved(path)) throw RangeError("'" + std::string(path) + "' is no setting any more");
  throw RangeError("unknown setting '" + std::string(path) + "'" + nearestText(path));
}

std::string SettingsTable::nearestText(std::string_view path) const {
  std::vector<KnownName> known;
  known.reserve(fields_.size() + renamed_.size());
  for (const Field& field : fields_) known.push_back({field.path, field.aliases});
  for (const auto& [formerly, now] : renamed_) known.push_back({formerly, {}, now});
  return core::nearestText(path, known);
}

void setField(const Field& field, double value) {
  const std::string reason = refusal(field, value);
  if (!reason.empty()) throw RangeError(field.path + ": " + numberText(value) + " " + reason);
  field.set(value);
}

void setField(const Field& field, std::string_view text) {
  double value = 0;
  const std::string reason = parseValue(field, text, value);
  if (!reason.empty()) throw RangeError(field.path + ": '" + std::string(text) + "' " + reason);
  field.set(value);
}

void setField(const SettingsTable& table, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw RangeError("'" + std::string(assignment) + "' is not of the form PATH=VALUE");
  }
  setField(table.at(assignment.substr(0, equals)), assignment.substr(equals + 1));
}

std::string writtenText(const Field& field, double value) {
  return field.written ? field.written->write(value) : "";
}

std::string fieldText(const Field& field) {
  const double value = field.get();
  if (field.written) return field.written->write(value);
  switch (field.kind) {
    case FieldKind::flag:
      return value != 0 ? "true" : "false";
    case FieldKind::choice:
      return field.names[static_cast<std::size_t>(value)];
    case FieldKind::number:
    case FieldKind::integer:
      break;
  }
  return numberText(value);
}

nlohmann::json toJson(const SettingsTable& table, bool onlyChanged) {
  nlohmann::json json = nlohmann::json::object();
  for (const Field& field : table.fields()) {
    if (onlyChanged && field.isDefault()) continue;
    nlohmann::json* node = &json;
    std::string_view rest = field.path;
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      node = &(*node)[std::string(rest.substr(0, dot))];
      rest.remove_prefix(dot + 1);
    }
    (*node)[std::string(rest)] = valueJson(field);
  }
  return json;
}

void applyJson(const SettingsTable& table, const nlohmann::json& json, std::string_view file) {
  std::vector<Change> changes;
  const auto refuse = [&](const std::string& place, const std::string& reason) {
    throw DataError(file, place, reason == kUnknown ? reason + table.nearestText(place) : reason);
  };
  collectChanges(table, json, "", refuse, changes);
  apply(changes);
}

std::vector<std::string> applyJsonWhereItFits(const SettingsTable& table, const nlohmann::json& json) {
  std::vector<Change> changes;
  std::vector<std::string> complaints;
  const auto note = [&](const std::string& place, const std::string& reason) {
    complaints.push_back(place + ": " + reason);
  };
  collectChanges(table, json, "", note, changes);
  apply(changes);
  return complaints;
}

}  // namespace skydrop::core
