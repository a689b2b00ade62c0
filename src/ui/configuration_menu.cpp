#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/flag_text.h"
#include "skydrop/ui/menu.h"
#include "ui/copy_section.h"
#include "ui/effect_table_view.h"
#include "ui/field_label.h"
#include "ui/key_press.h"
#include "ui/menu_item.h"
#include "ui/preset_section.h"
#include "ui/row_editor.h"
#include "ui/row_filter.h"
#include "ui/sky_section.h"
#include "ui/statistics_view.h"
#include "ui/weather_section.h"

namespace skydrop::ui {
namespace {

using core::Field;
using core::FieldKind;
using core::SettingsTable;

// Sizes in lines of text and shares of the window. The menu leaves the score above, the instruments below and
// the aircraft beside it free: a wing of the aircraft that the chase camera follows ends at a third of the
// width.
constexpr float kTop = 2.8f, kMargin = 0.5f, kBottomOfHeight = 0.2f, kAboveBottom = 1.2f;
constexpr float kWidthOfWindow = 0.325f, kMinWidth = 18, kMinHeight = 8;
constexpr float kNameShare = 0.49f;
constexpr int kRefusalLines = 2;   // kept free for a line that says what went wrong
constexpr int kFramesToFocus = 3;  // Dear ImGui hands the keyboard over a frame later
const ImVec4 kChangedColor{0.98f, 0.72f, 0.36f, 1};

bool belongsTo(const std::string& fieldGroup, const std::string& group) {
  return fieldGroup == group || (!group.empty() && fieldGroup.starts_with(group + "."));
}

// What is written above the rows of a group within a section. Nothing for the section's own group, and for an
// array with a single element, whose number says nothing.
std::string headingOf(const std::string& group, const MenuSection& section, const SettingsTable& table) {
  if (group == section.group) return "";
  if (group.ends_with(".0") && !table.isGroup(group.substr(0, group.size() - 1) + "1")) return "";
  const bool isBelow = !section.group.empty() && belongsTo(group, section.group);
  return humanName(group.substr(isBelow ? section.group.size() + 1 : 0));
}

}  // namespace

struct ConfigurationMenu::Parts {
  UndoHistory history;
  RowEditor rows;
  PresetSection presets;
  MenuState state;
  char search[128] = {};
  bool changedOnly = false;
  std::set<std::string> kept;  // rows that the filter has shown since it was set
  std::string keptFor;         // the filter that they were kept for
  std::string refusal;         // of what was typed last
  bool held = false;           // a widget may go on with the step that is open
  int framesToSearch = 0;      // while the search field is to get the keyboard
  // Of the last frame.
  std::map<std::string, MenuRowPlace> places;
  ItemPlaces items;
  std::vector<const MenuSection*> homes;  // the section of each field of the table
  std::vector<const Field*> typedRows;    // numbers, in their order, for Tab
  BindingsPlaces bindings;
  ScreenRect window;
  float titleHeight = 0;
  int placedWidth = 0, placedHeight = 0;  // the window size that the menu was last placed in

  void set(const Field& field, double value, MenuResult& result);
  void setText(const Field& field, std::string_view text, MenuResult& result);
  void setAll(const SettingsTable& table, std::span<const SettingValue> values,
              std::vector<std::string>& changed);
  void resetSection(const MenuContent& content, const MenuSection& section, MenuResult& result);

  bool section(const std::string& name, const std::string& group, const std::string& title, bool openAtFirst);
  void drawTop(const MenuContent& content, MenuResult& result);
  void drawTools(const MenuContent& content, MenuResult& result);
  void drawSection(const MenuContent& content, const MenuSection& section, const RowFilter& filter,
                   MenuResult& result);
  void drawHead(const MenuContent& content, const MenuSection& section, MenuResult& result);
  void drawFields(const SettingsTable& table, const MenuSection& section, std::span<const Field* const> shown,
                  MenuResult& result);
  void drawRow(const SettingsTable& table, const Field& field, MenuResult& result);
  void takeKeys(const SettingsTable& table, MenuResult& result);
  void placeWindow(const Interface& context);
  void keepPlace(const Interface& context, bool placed);
};

namespace {

void remember(std::vector<std::string>& paths, const std::string& path) {
  if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
}

}  // namespace

const MenuSection* sectionOf(std::span<const MenuSection> sections, const Field& field) {
  const MenuSection* deepest = nullptr;
  for (const MenuSection& section : sections) {
    const auto holds = [&](const std::string& group) { return belongsTo(field.group, group); };
    if (std::ranges::any_of(section.moreGroups, holds)) return &section;
    if (!holds(section.group)) continue;
    if (!deepest || section.group.size() > deepest->group.size()) deepest = &section;
  }
  return deepest;
}

// Of a widget: clamped to the range. (A slider keeps to its part of it by itself.)
void ConfigurationMenu::Parts::set(const Field& field, double value, MenuResult& result) {
  if (field.kind != FieldKind::number) value = std::round(value);
  value = std::clamp(value, field.min, field.max);
  const double before = field.get();
  if (!std::isfinite(value) || value == before) return;
  core::setField(field, value);
  history.note(field.path, before, value);
  remember(result.changedPaths, field.path);
  refusal.clear();
}

// Of a typed text: as it stands, or refused.
void ConfigurationMenu::Parts::setText(const Field& field, std::string_view text, MenuResult& result) {
  const double before = field.get();
  try {
    core::setField(field, withoutUnit(field, text));
    refusal.clear();
  } catch (const core::RangeError& error) {
    refusal = error.what();
    return;
  }
  if (field.get() == before) return;
  history.note(field.path, before, field.get());
  remember(result.changedPaths, field.path);
}

void ConfigurationMenu::Parts::setAll(const SettingsTable& table, std::span<const SettingValue> values,
                                      std::vector<std::string>& changed) {
  for (const SettingValue& value : values) {
    const Field* field = table.find(value.path);
    if (!field || field->get() == value.value) continue;
    field->set(value.value);
    remember(changed, value.path);
  }
}

void ConfigurationMenu::Parts::resetSection(const MenuContent& content, const MenuSection& section,
                                            MenuResult& result) {
  const std::vector<Field>& fields = content.table.fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (homes[i] == &section) set(fields[i], fields[i].defaultValue, result);
  }
}

// A header that opens and closes, and remembers it.
bool ConfigurationMenu::Parts::section(const std::string& name, const std::string& group,
                                       const std::string& title, bool openAtFirst) {
  const auto known = state.open.find(group);
  const bool before = known == state.open.end() ? openAtFirst : known->second;
  ImGui::SetNextItemOpen(before, ImGuiCond_Always);
  const bool open = ImGui::CollapsingHeader((title + "###" + name).c_str());
  items.insert_or_assign(name, lastItemRect());
  if (open != before) state.open[group] = open;
  return open;
}

void ConfigurationMenu::Parts::drawRow(const SettingsTable& table, const Field& field, MenuResult& result) {
  ImGui::PushID(field.path.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool changed = !field.isDefault();
  if (changed) ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fittingText(humanName(field.name), ImGui::GetContentRegionAvail().x).c_str());
  if (changed) ImGui::PopStyleColor();
  tooltip(tooltipText(field));

  ImGui::TableNextColumn();
  MenuRowPlace place;
  const RowOutcome outcome = rows.draw(field, place.value);
  tooltip(ImGui::IsItemActive() ? noteText(field) : tooltipText(field));
  held |= outcome.held;
  if (outcome.before && *outcome.before != field.get()) {
    setAll(table, history.dropLastStep(), result.changedPaths);
  }
  if (outcome.value) set(field, *outcome.value, result);
  if (outcome.typed) setText(field, *outcome.typed, result);
  if (outcome.wantsToType) rows.type(field);
  if (outcome.nextRow != 0) {
    const auto here = std::ranges::find(typedRows, &field);
    const auto at = (here - typedRows.begin()) + outcome.nextRow;
    if (here != typedRows.end() && at >= 0 && at < std::ssize(typedRows)) {
      rows.type(*typedRows[static_cast<std::size_t>(at)]);
    }
  }

  ImGui::TableNextColumn();
  if (changed) {
    if (ImGui::Button("\u21a9")) set(field, field.defaultValue, result);
    place.reset = lastItemRect();
    tooltip("Back to its default.");
  }
  ImGui::PopID();
  places.insert_or_assign(field.path, place);
}

void ConfigurationMenu::Parts::drawSection(const MenuContent& content, const MenuSection& section,
                                           const RowFilter& filter, MenuResult& result) {
  std::vector<const Field*> shown;
  int changed = 0;
  for (std::size_t i = 0; i < homes.size(); ++i) {
    if (homes[i] != &section) continue;
    const Field& field = content.table.fields()[i];
    changed += field.isDefault() ? 0 : 1;
    // A row that goes back to its default while only changed ones are shown keeps its place until the filter
    // is set again: the next row must not come under the mouse.
    const bool matches = filter.matches(field, section.title);
    if (matches) kept.insert(field.path);
    if (matches || kept.contains(field.path)) shown.push_back(&field);
  }
  if (filter.isActive()) {
    if (shown.empty()) return;
    ImGui::TextDisabled("%s", section.title.c_str());
  } else {
    const bool open = this->section("section " + section.group, section.group, section.title, section.open);
    if (changed > 0) {
      const std::string note = std::to_string(changed) + " changed";
      const ScreenRect header = lastItemRect();
      const float width = ImGui::CalcTextSize(note.c_str()).x, padding = ImGui::GetStyle().FramePadding.x;
      ImGui::GetWindowDrawList()->AddText(
          {header.right - width - padding, header.top + ImGui::GetStyle().FramePadding.y},
          ImGui::GetColorU32(kChangedColor), note.c_str());
    }
    if (!open) return;
  }
  if (!filter.isActive() && section.group == kEffectsGroup) {
    if (const Field* switched = drawEffectTable(shown, content.statistics, places))
      set(*switched, switched->get() != 0 ? 0 : 1, result);
  } else {
    if (!filter.isActive()) drawHead(content, section, result);
    drawFields(content.table, section, shown, result);
  }
  // At the end, and always there: rows must not move under the mouse while a slider leaves its default.
  if (!filter.isActive()) {
    ImGui::PushID(section.group.c_str());
    if (placedButton("Reset this section", "reset " + section.group, items, changed > 0)) {
      resetSection(content, section, result);
    }
    ImGui::PopID();
  }
}

void ConfigurationMenu::Parts::drawHead(const MenuContent& content, const MenuSection& section,
                                        MenuResult& result) {
  const auto row = [&](const char* path) -> const Field& { return content.table.at(path); };
  ImGui::PushID(("head " + section.group).c_str());
  const bool isWeather = section.head == MenuSection::Head::weather;
  if (section.head == MenuSection::Head::choiceButtons || isWeather) {
    const std::vector<Field>& fields = content.table.fields();
    const auto choice = std::ranges::find(fields, section.group, &Field::group);
    if (choice != fields.end()) {
      if (const auto clicked = drawChoiceButtons(*choice, items)) set(*choice, *clicked, result);
    }
    if (isWeather) {
      for (const SettingValue& value : drawGenusButtons(content.table, content.tools.genera, items))
        set(row(value.path.c_str()), value.value, result);
    }
  } else if (section.head == MenuSection::Head::clock && content.tools.clockMs) {
    const Field& utc = row("render.sun.utc");
    const ClockRequest request =
        drawClock(*content.tools.clockMs, row("render.sun.timeScale").get(), *utc.written, items);
    held |= request.held;
    if (request.turnedMs != 0 || request.speed) set(row("render.sun.source"), 1, result);
    if (request.turnedMs != 0) set(utc, utc.get() + request.turnedMs, result);
    if (request.speed) set(row("render.sun.timeScale"), *request.speed, result);
  }
  ImGui::PopID();
}

void ConfigurationMenu::Parts::drawFields(const SettingsTable& table, const MenuSection& section,
                                          std::span<const Field* const> shown, MenuResult& result) {
  if (!ImGui::BeginTable(("fields " + section.group).c_str(), 3, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, kNameShare);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1 - kNameShare);
  ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed,
                          ImGui::CalcTextSize("\u21a9").x + 2 * ImGui::GetStyle().FramePadding.x);
  std::string group = section.group;
  for (const Field* field : shown) {
    if (field->group != group) {
      group = field->group;
      if (const std::string heading = headingOf(group, section, table); !heading.empty()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", heading.c_str());
      }
    }
    drawRow(table, *field, result);
  }
  ImGui::EndTable();
}

// What stays in sight whatever is scrolled: lines, search, undo.
void ConfigurationMenu::Parts::drawTop(const MenuContent& content, MenuResult& result) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float box = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize("changed").x;
  ImGui::SetNextItemWidth(-box - style.ItemSpacing.x);
  if (framesToSearch > 0) ImGui::SetKeyboardFocusHere();
  const bool found = isControlHeld() && isPressed(MenuKey::find);
  const auto selectAll = [](ImGuiInputTextCallbackData* data) {
    if (*static_cast<const bool*>(data->UserData)) data->SelectAll();
    return 0;
  };
  bool again = found;  // the field has the keyboard already
  ImGui::InputTextWithHint("##search", "Search, or PATH=VALUE", search, sizeof search,
                           ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackAlways, selectAll,
                           &again);
  items.insert_or_assign("search", lastItemRect());
  framesToSearch = ImGui::IsItemActive() ? 0 : std::max(framesToSearch - 1, 0);
  const bool entered =
      ImGui::IsItemDeactivated() && (isPressed(MenuKey::enter) || isPressed(MenuKey::keypadEnter));
  tooltip(
      "Shows the rows of all sections in whose name, path, other names or description every word stands. "
      "Ctrl+F comes "
      "here. "
      "PATH=VALUE and Enter sets a value.");
  if (const std::string_view text = search; entered && text.find('=') != std::string_view::npos) {
    const std::size_t equals = text.find('=');
    try {
      setText(content.table.at(text.substr(0, equals)), text.substr(equals + 1), result);
      if (refusal.empty()) search[0] = '\0';
    } catch (const core::RangeError& error) {
      refusal = error.what();
    }
  }
  ImGui::SameLine();
  ImGui::Checkbox("changed", &changedOnly);
  items.insert_or_assign("changed only", lastItemRect());
  tooltip("Shows only what is not at its default.");

  const auto step = [&](const char* label, const char* name, std::size_t steps, const char* keys,
                        bool pressed, auto take) {
    const bool clicked = placedButton(label, name, items, steps > 0);
    tooltip(std::string(keys) + ", " + std::to_string(steps) + (steps == 1 ? " step" : " steps"));
    if (clicked || pressed) {
      refusal.clear();
      setAll(content.table, take(), result.changedPaths);
    }
  };
  const bool keys = !ImGui::GetIO().WantTextInput && isControlHeld();
  const bool redoKey = keys && (isPressed(MenuKey::redo) || (isShiftHeld() && isPressed(MenuKey::undo)));
  const bool undoKey = keys && !isShiftHeld() && isPressed(MenuKey::undo);
  step("Undo", "undo", history.undoSteps(), "Ctrl+Z", undoKey, [&] { return history.undo(); });
  ImGui::SameLine();
  step("Redo", "redo", history.redoSteps(), "Ctrl+Y", redoKey, [&] { return history.redo(); });
  ImGui::SameLine();
  if (placedButton("Reset all", "reset all", items)) {
    for (const MenuSection& section : content.sections) resetSection(content, section, result);
  }
  tooltip("Sets every row of this menu to its default. It can be undone.");
  const std::string_view line = refusal.empty() ? content.error : refusal;
  textInPlace(line, kRefusalLines, TextRole::refusal);
  if (!line.empty()) items.insert_or_assign("refusal", lastItemRect());
  if (found) {
    framesToSearch = kFramesToFocus;
    ImGui::SetWindowFocus();
  }
}

void ConfigurationMenu::Parts::drawTools(const MenuContent& content, MenuResult& result) {
  const MenuTools& tools = content.tools;
  if (content.statistics && section("costs", "#costs", "What accuracy costs", false)) {
    drawStatistics(*content.statistics, tools.frameMs, content.table);
  }
  if (content.bindings && section("controls", "#controls", "Controls", false)) {
    result.binding = drawBindings(*content.bindings, bindings);
  }
  if (tools.presets && section("presets", "#presets", "Presets", false)) {
    result.preset = presets.draw(*tools.presets, content.sections, items);
  }
  if ((!tools.bases.empty() || !tools.pose.empty()) &&
      section("copy", "#copy", "Copy for a command line", false)) {
    drawCopySection(core::setFlags(content.table, tools.bases), tools.pose, items);
  }
}

// A new window size places the menu again, so that it is never left outside.
void ConfigurationMenu::Parts::placeWindow(const Interface& context) {
  const float line = context.text().pixels;
  const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
  ScreenRect place;
  if (state.place) {
    place = {state.place->left * width, state.place->top * height, state.place->right * width,
             state.place->bottom * height};
  } else {
    const float margin = kMargin * line;
    place.left = margin;
    place.top = kTop * line;
    place.right =
        margin + std::min(std::max(kWidthOfWindow * width - margin, kMinWidth * line), width - 2 * margin);
    place.bottom =
        std::max(height * (1 - kBottomOfHeight) - kAboveBottom * line, place.top + kMinHeight * line);
  }
  const float wide = std::clamp(place.right - place.left, std::min(kMinWidth * line, width), width);
  const float high = std::clamp(place.bottom - place.top, std::min(kMinHeight * line, height), height);
  ImGui::SetNextWindowPos(
      {std::clamp(place.left, 0.0f, width - wide), std::clamp(place.top, 0.0f, height - high)},
      ImGuiCond_Always);
  ImGui::SetNextWindowSize({wide, high}, ImGuiCond_Always);
}

// Notes where the player has put the menu.
void ConfigurationMenu::Parts::keepPlace(const Interface& context, bool placed) {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const ScreenRect now{low.x, low.y, low.x + size.x, low.y + size.y};
  const bool moved = now.left != window.left || now.top != window.top || now.right != window.right ||
                     now.bottom != window.bottom;
  if (moved && !placed) {
    const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
    state.place = ScreenRect{now.left / width, now.top / height, now.right / width, now.bottom / height};
  }
  window = now;
}

ConfigurationMenu::ConfigurationMenu() : parts_(std::make_unique<Parts>()) {}
ConfigurationMenu::~ConfigurationMenu() = default;

MenuResult ConfigurationMenu::draw(const Interface& context, const MenuContent& content) {
  Parts& parts = *parts_;
  MenuResult result;
  parts.places.clear();
  parts.items.clear();
  parts.bindings = {};
  parts.held = false;
  parts.homes.clear();
  for (const Field& field : content.table.fields()) {
    parts.homes.push_back(sectionOf(content.sections, field));
  }
  const float line = context.text().pixels;
  const bool placed = parts.placedWidth != context.width() || parts.placedHeight != context.height();
  parts.placedWidth = context.width();
  parts.placedHeight = context.height();
  if (placed) parts.placeWindow(context);
  ImGui::SetNextWindowSizeConstraints(
      {std::min(kMinWidth * line, static_cast<float>(context.width())), kMinHeight * line},
      {static_cast<float>(context.width()), static_cast<float>(context.height())});
  bool open = true;
  if (ImGui::Begin("Configuration", &open, ImGuiWindowFlags_NoCollapse)) {
    parts.keepPlace(context, placed);
    parts.titleHeight = ImGui::GetFrameHeight();
    parts.drawTop(content, result);
    if (ImGui::BeginChild("rows")) {
      const RowFilter filter(parts.search, parts.changedOnly);
      const std::string asked = (parts.changedOnly ? "changed " : "all ") + std::string(parts.search);
      if (std::exchange(parts.keptFor, asked) != asked) parts.kept.clear();
      if (!filter.isActive()) parts.drawTools(content, result);
      for (const MenuSection& section : content.sections) parts.drawSection(content, section, filter, result);
      if (filter.isActive() && parts.places.empty()) ImGui::TextDisabled("No row is like that.");
    }
    ImGui::EndChild();
    parts.typedRows.clear();
    for (const Field& field : content.table.fields()) {
      if (parts.places.contains(field.path) && RowEditor::isTyped(field)) parts.typedRows.push_back(&field);
    }
  }
  ImGui::End();
  if (!parts.held) parts.history.closeStep();
  result.closed = !open;
  return result;
}

std::vector<std::string> ConfigurationMenu::change(const SettingsTable& table,
                                                   std::span<const SettingValue> values) {
  for (const SettingValue& value : values) {
    const Field& field = table.at(value.path);
    const double before = field.get();
    core::setField(field, value.value);  // the door
    field.set(before);
  }
  parts_->history.closeStep();
  for (const SettingValue& value : values) {
    const double before = table.at(value.path).get();
    if (before != value.value) parts_->history.note(value.path, before, value.value);
  }
  parts_->history.closeStep();
  parts_->refusal.clear();
  std::vector<std::string> changed;
  parts_->setAll(table, values, changed);
  return changed;
}

void ConfigurationMenu::takeBack() { parts_->history.takeBack(); }

const MenuState& ConfigurationMenu::state() const { return parts_->state; }

void ConfigurationMenu::setState(MenuState state) {
  parts_->state = std::move(state);
  parts_->placedWidth = parts_->placedHeight = 0;
}

bool ConfigurationMenu::showsCosts() const {
  const auto isOpen = [&](std::string_view group) {
    const auto section = parts_->state.open.find(std::string(group));
    return section != parts_->state.open.end() && section->second;
  };
  return isOpen("#costs") || isOpen(kEffectsGroup);
}

const std::map<std::string, MenuRowPlace>& ConfigurationMenu::places() const { return parts_->places; }
const BindingsPlaces& ConfigurationMenu::bindingPlaces() const { return parts_->bindings; }
const ScreenRect& ConfigurationMenu::place() const { return parts_->window; }

const ScreenRect* ConfigurationMenu::place(std::string_view what) const {
  const auto found = parts_->items.find(what);
  return found == parts_->items.end() ? nullptr : &found->second;
}

ScreenRect ConfigurationMenu::crossPlace() const {
  const ScreenRect& window = parts_->window;
  return {window.right - parts_->titleHeight, window.top, window.right, window.top + parts_->titleHeight};
}

}  // namespace skydrop::ui
