#include "skydrop/ui/bindings_view.h"

#include <imgui.h>

#include "ui/menu_item.h"

namespace skydrop::ui {
namespace {

using Kind = BindingRequest::Kind;

constexpr const char* kHowTo =
    "Click, then press a key or a button or push a stick. A click with the right button takes it away.";
constexpr int kNoteLines = 3;  // kept free for what is waited for, or what a change did
constexpr const char* kWaiting = "Press a key or a button, or push a stick. Esc leaves it as it was.";

// Buttons side by side, on a new line where the next one has no room.
class Flow {
 public:
  Flow() : left_(ImGui::GetCursorPosX()), right_(left_ + ImGui::GetContentRegionAvail().x) {}

  // As wide as its label, whatever it shows instead.
  bool button(const std::string& label, const std::string& shown) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2 * style.FramePadding.x;
    if (next_ > left_ && next_ + width <= right_) ImGui::SameLine(0, style.ItemInnerSpacing.x);
    const float start = next_ > left_ && next_ + width <= right_ ? next_ : left_;
    next_ = start + width + style.ItemInnerSpacing.x;
    return ImGui::Button(shown.c_str(), {width, 0});
  }

 private:
  float left_, right_;
  float next_ = 0;
};

class Section {
 public:
  Section(const BindingsContent& content, BindingsPlaces& places) : content_(content), places_(places) {}

  BindingRequest draw() {
    const std::string gamepad = content_.gamepad.empty() ? "No gamepad." : "Gamepad: " + content_.gamepad;
    ImGui::TextUnformatted(fittingText(gamepad, ImGui::GetContentRegionAvail().x).c_str());
    tooltip(gamepad);
    textInPlace(content_.waiting ? kWaiting : content_.note, kNoteLines, TextRole::note);
    if (ImGui::Button("Reset all controls")) request_.kind = Kind::resetAll;
    places_.resetAll = lastItemRect();
    if (ImGui::BeginTable("bindings", 3, ImGuiTableFlags_SizingStretchProp)) {
      ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch, 0.36f);
      ImGui::TableSetupColumn("inputs", ImGuiTableColumnFlags_WidthStretch, 0.64f);
      ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed,
                              ImGui::CalcTextSize("Reset").x + ImGui::GetFontSize());
      for (std::size_t row = 0; row < content_.rows.size(); ++row) drawRow(row);
      ImGui::EndTable();
    }
    return request_;
  }

 private:
  void drawRow(std::size_t index) {
    const BindingRow& row = content_.rows[index];
    BindingsPlaces::Row& place = places_.rows[row.name];
    ImGui::PushID(row.name.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.meaning.c_str());
    tooltip(kHowTo);
    ImGui::TableNextColumn();
    Flow flow;
    for (std::size_t slot = 0; slot < row.inputs.size(); ++slot) {
      drawInput(flow, {index, slot}, row.inputs[slot], kHowTo);
      place.inputs.push_back(lastItemRect());
    }
    if (row.canAdd) {
      drawInput(flow, {index, row.inputs.size()}, "+", "Adds a key, a button or a stick.");
      place.add = lastItemRect();
    }
    ImGui::TableNextColumn();
    if (!row.isDefault) {
      if (ImGui::Button("Reset")) request_ = {Kind::reset, {index, 0}};
      place.reset = lastItemRect();
    }
    ImGui::PopID();
  }

  void drawInput(Flow& flow, BindingSlot at, const std::string& label, const char* help) {
    const bool waiting = content_.waiting == at;
    if (waiting) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const std::string id = "###" + std::to_string(at.slot);
    if (flow.button(label + id, (waiting ? "\u2026" : label) + id))
      request_ = {waiting ? Kind::cancel : Kind::capture, at};
    if (waiting) ImGui::PopStyleColor();
    const bool isThere = at.slot < content_.rows[at.row].inputs.size();
    if (isThere && ImGui::IsItemClicked(ImGuiMouseButton_Right)) request_ = {Kind::remove, at};
    if (!content_.waiting) tooltip(help);
  }

  const BindingsContent& content_;
  BindingsPlaces& places_;
  BindingRequest request_;
};

}  // namespace

BindingRequest drawBindings(const BindingsContent& content, BindingsPlaces& places) {
  places = {};
  return Section(content, places).draw();
}

}  // namespace skydrop::ui
