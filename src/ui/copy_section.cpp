#include "ui/copy_section.h"

#include <imgui.h>

namespace skydrop::ui {
namespace {

void drawRow(const char* label, const char* button, const std::string& name, std::string text,
             ItemPlaces& places) {
  ImGui::TextDisabled("%s", label);
  const float width = ImGui::CalcTextSize("Copy").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(-width - ImGui::GetStyle().ItemSpacing.x);
  // Read only: the buffer is not written to, and its zero byte is in reach.
  ImGui::InputText(("##" + name).c_str(), text.data(), text.size() + 1,
                   ImGuiInputTextFlags_ReadOnly | ImGuiInputTextFlags_AutoSelectAll);
  places.insert_or_assign(name + " text", lastItemRect());
  ImGui::SameLine();
  if (placedButton(button, name, places, !text.empty())) ImGui::SetClipboardText(text.c_str());
}

}  // namespace

void drawCopySection(const std::string& flags, std::string_view pose, ItemPlaces& places) {
  drawRow(flags.empty() ? "Settings: nothing differs from the scene's" : "Settings, to start with again",
          "Copy###flags", "copy flags", flags, places);
  if (!pose.empty()) drawRow("The present view", "Copy###pose", "copy pose", std::string(pose), places);
}

}  // namespace skydrop::ui
