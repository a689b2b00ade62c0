#include "ui/preset_section.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/key_press.h"

namespace skydrop::ui {
namespace {

constexpr const char* kEverything = "every setting";

}  // namespace

std::optional<PresetRequest> PresetSection::draw(std::span<const PresetEntry> presets,
                                                 std::span<const MenuSection> sections, ItemPlaces& places) {
  std::optional<PresetRequest> request;
  const float saveWidth = ImGui::CalcTextSize("Save").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(-saveWidth - ImGui::GetStyle().ItemSpacing.x);
  ImGui::InputTextWithHint("##preset name", "Name of a new preset", name_, sizeof name_);
  places.insert_or_assign("preset name", lastItemRect());
  const bool entered =
      ImGui::IsItemDeactivated() && (isPressed(MenuKey::enter) || isPressed(MenuKey::keypadEnter));
  ImGui::SameLine();
  const bool save = placedButton("Save", "save preset", places, name_[0] != '\0');
  tooltip("Keeps the values that differ from their defaults. A preset of this name is replaced.");
  const auto chosen = std::ranges::find(sections, group_, &MenuSection::group);
  if (chosen == sections.end()) group_.clear();
  if ((save || entered) && name_[0] != '\0') {
    request = PresetRequest{PresetRequest::Kind::save, name_};
    if (!group_.empty()) {
      request->groups = chosen->moreGroups;
      request->groups.insert(request->groups.begin(), group_);
    }
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("It holds");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##holds", group_.empty() ? kEverything : chosen->title.c_str())) {
    if (ImGui::Selectable(kEverything, group_.empty())) group_.clear();
    for (const MenuSection& section : sections) {
      if (!section.group.empty() && ImGui::Selectable(section.title.c_str(), section.group == group_)) {
        group_ = section.group;
      }
    }
    ImGui::EndCombo();
  }

  for (const PresetEntry& preset : presets) {
    ImGui::PushID(preset.name.c_str());
    if (placedButton("Load", "load " + preset.name, places, preset.usable)) {
      request = PresetRequest{PresetRequest::Kind::load, preset.name};
    }
    tooltip(preset.usable ? "Sets what it holds, and leaves the rest. It can be undone." : preset.holds);
    ImGui::SameLine();
    const bool confirming = confirmation_ == preset.name;
    if (placedButton(confirming ? "Really?###delete" : "Delete###delete", "delete " + preset.name, places)) {
      if (confirming) request = PresetRequest{PresetRequest::Kind::remove, preset.name};
      confirmation_ = confirming ? "" : preset.name;
    } else if (confirming && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
      if (!ImGui::IsItemHovered()) confirmation_.clear();  // a click elsewhere is a no
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(preset.name.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", preset.usable ? preset.holds.c_str() : "broken");
    tooltip(preset.holds);
    ImGui::PopID();
  }
  return request;
}

}  // namespace skydrop::ui
