#include "ui/sky_section.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace skydrop::ui {
namespace {

constexpr double kMinuteMs = 60e3, kHourMs = 60 * kMinuteMs, kDayMs = 24 * kHourMs;

// The next button goes into a line of its own where this one has no room for it.
void sameLineIfRoom(const std::string& label) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * style.FramePadding.x;
  const float end = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
  if (end < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x) ImGui::SameLine();
}

bool litButton(const std::string& label, const std::string& name, ItemPlaces& places, bool lit) {
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool clicked = placedButton((label + "###" + name).c_str(), name, places);
  if (lit) ImGui::PopStyleColor();
  return clicked;
}

// "goldenSunset" as "golden sunset".
std::string words(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') text += ' ';
    text += (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

}  // namespace

std::optional<double> drawChoiceButtons(const core::Field& choice, ItemPlaces& places) {
  std::optional<double> clicked;
  const auto chosen = static_cast<std::size_t>(choice.get());
  for (std::size_t i = 1; i < choice.names.size(); ++i) {
    const std::string label = words(choice.names[i]);
    if (i > 1) sameLineIfRoom(label);
    if (litButton(label, "mood " + choice.names[i], places, i == chosen))
      clicked = i == chosen ? 0 : static_cast<double>(i);
  }
  return clicked;
}

ClockRequest drawClock(double nowMs, double speed, const core::WrittenForm& form, ItemPlaces& places) {
  ClockRequest request;
  const double day = std::floor(nowMs / kDayMs) * kDayMs;
  ImGui::TextDisabled("%s", form.write(std::floor(nowMs / 1000) * 1000).c_str());
  const auto before = static_cast<float>((nowMs - day) / kHourMs);
  float hours = before;
  std::array<char, 16> shown{};
  const int minutes = static_cast<int>(std::floor((nowMs - day) / kMinuteMs));
  std::snprintf(shown.data(), shown.size(), "%02d:%02d", minutes / 60, minutes % 60);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("###clock", &hours, 0, 23.999f, shown.data(), ImGuiSliderFlags_NoInput) &&
      hours != before)
    request.turnedMs = std::round((static_cast<double>(hours) - static_cast<double>(before)) * kHourMs);
  request.held = ImGui::IsItemActive();
  places.insert_or_assign("clock", lastItemRect());

  struct Step {
    const char* label;
    double ms;
  };
  constexpr std::array<Step, 6> kSteps = {{{"-1 d", -kDayMs},
                                           {"-1 h", -kHourMs},
                                           {"-10 min", -10 * kMinuteMs},
                                           {"+10 min", 10 * kMinuteMs},
                                           {"+1 h", kHourMs},
                                           {"+1 d", kDayMs}}};
  for (const Step& step : kSteps) {
    if (&step != kSteps.data()) sameLineIfRoom(step.label);
    if (litButton(step.label, "clock " + std::string(step.label), places, false)) request.turnedMs = step.ms;
  }
  constexpr std::array<int, 5> kSpeeds = {0, 1, 60, 600, 3600};
  for (const int to : kSpeeds) {
    const std::string label = "x" + std::to_string(to);
    if (to != kSpeeds.front()) sameLineIfRoom(label);
    if (litButton(label, "speed " + std::to_string(to), places, speed == to)) request.speed = to;
  }
  return request;
}

}  // namespace skydrop::ui
