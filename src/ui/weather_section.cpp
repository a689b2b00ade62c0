#include "ui/weather_section.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "ui/genus_picture.h"

namespace skydrop::ui {
namespace {

// Of a button, in lines of text.
constexpr float kWidth = 3.1f, kHeight = 2.2f;

bool isShown(const core::SettingsTable& table, const GenusButton& genus) {
  return std::ranges::all_of(genus.values, [&](const SettingValue& value) {
    const core::Field* field = table.find(value.path);
    return field && field->get() == value.value;
  });
}

}  // namespace

std::vector<SettingValue> drawGenusButtons(const core::SettingsTable& table,
                                           std::span<const GenusButton> genera, ItemPlaces& places) {
  std::vector<SettingValue> clicked;
  const ImVec2 size(kWidth * ImGui::GetFontSize(), kHeight * ImGui::GetFontSize());
  for (const GenusButton& genus : genera) {
    const bool lit = isShown(table, genus);
    const std::string name = "genus " + std::string(genus.name);
    if (&genus != genera.data()) {
      const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + size.x;
      if (end < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x) ImGui::SameLine();
    }
    if (ImGui::Button(("###" + name).c_str(), size)) clicked = lit ? genus.away : genus.values;
    const ScreenRect place = lastItemRect();
    places.insert_or_assign(name, place);
    tooltip(genus.name);
    drawGenusPicture(*ImGui::GetWindowDrawList(), genus.name, place, lit);
  }
  return clicked;
}

}  // namespace skydrop::ui
