#include "skydrop/ui/weather_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/menu_item.h"

namespace skydrop::ui {
namespace {

constexpr double kHourMs = 3.6e6, kDayMs = 24 * kHourMs;
// In lines of text.
constexpr float kPadding = 0.3f, kRow = 1.35f, kStrip = 1.9f, kStatus = 1.15f, kGap = 0.2f;
constexpr float kFullRain = 4;  // mm/h that fill the strip's lowest lane
constexpr ImU32 kSky = IM_COL32(46, 82, 128, 255), kCloud = IM_COL32(245, 247, 250, 255),
                kRain = IM_COL32(92, 170, 255, 255), kNow = IM_COL32(255, 191, 69, 255),
                kDay = IM_COL32(0, 0, 0, 150), kShade = IM_COL32(20, 24, 28, 150);

ImU32 faded(ImU32 color, float share) {
  return (color & ~IM_COL32_A_MASK) |
         (static_cast<ImU32>(255 * std::clamp(share, 0.0f, 1.0f)) << IM_COL32_A_SHIFT);
}

bool litButton(const char* label, const std::string& name, ItemPlaces& places, bool lit) {
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool clicked = placedButton(label, name, places);
  if (lit) ImGui::PopStyleColor();
  return clicked;
}

// Cover of the hours, high clouds uppermost and rain below: a column of at least a pixel each, where several
// hours share one the most of them.
void drawHours(ImDrawList& list, const ScreenRect& in, std::span<const StripHour> hours, double firstMs,
               double lastMs) {
  const float height = in.bottom - in.top, lane = std::floor(height * 0.28f);
  const auto x = [&](double ms) {
    return in.left +
           (in.right - in.left) * static_cast<float>((ms - firstMs) / std::max(lastMs - firstMs, 1.0));
  };
  for (std::size_t i = 0; i < hours.size();) {
    const float left = x(hours[i].utcMs - kHourMs / 2);
    StripHour most = hours[i];
    std::size_t next = i + 1;
    for (; next < hours.size() && x(hours[next].utcMs + kHourMs / 2) < left + 1; ++next) {
      for (std::size_t l = 0; l < most.cover.size(); ++l)
        most.cover[l] = std::max(most.cover[l], hours[next].cover[l]);
      most.rain = std::max(most.rain, hours[next].rain);
    }
    const double end = next < hours.size() ? hours[next].utcMs - kHourMs / 2 : lastMs;
    const float right = std::min(std::max(x(end), left + 1), in.right), from = std::max(left, in.left);
    for (std::size_t l = 0; l < most.cover.size(); ++l) {
      const float top = in.top + lane * static_cast<float>(most.cover.size() - 1 - l);
      if (most.cover[l] > 0)
        list.AddRectFilled({from, top}, {right, top + lane}, faded(kCloud, 0.95f * most.cover[l]));
    }
    const float drop = std::min(most.rain / kFullRain, 1.0f) * (height - 3 * lane);
    if (drop > 0) list.AddRectFilled({from, in.bottom - std::max(drop, 1.0f)}, {right, in.bottom}, kRain);
    i = next;
  }
  for (double day = std::ceil(firstMs / kDayMs) * kDayMs; day < lastMs; day += kDayMs)
    list.AddLine({x(day), in.top}, {x(day), in.bottom}, kDay);
}

// Returns where it was dragged to.
std::optional<double> strip(const WeatherBarContent& content, float height, ItemPlaces& places) {
  const std::vector<StripHour>& hours = content.sites[content.site].hours;
  const double firstMs = hours.front().utcMs, lastMs = std::max(hours.back().utcMs, firstMs + kHourMs);
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f);
  ImGui::InvisibleButton("##strip", {width, height});
  const ScreenRect place = lastItemRect();
  places.insert_or_assign("strip", place);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({place.left, place.top}, {place.right, place.bottom}, kSky);
  drawHours(list, place, hours, firstMs, lastMs);
  if (!content.live) list.AddRectFilled({place.left, place.top}, {place.right, place.bottom}, kShade);
  const auto share = static_cast<float>(std::clamp((content.nowMs - firstMs) / (lastMs - firstMs), 0.0, 1.0));
  const float now = place.left + share * width, half = std::max(1.0f, std::floor(0.08f * height));
  list.AddRectFilled({now - half, place.top}, {now + half, place.bottom}, kNow);
  if (!content.live || !ImGui::IsItemActive()) return std::nullopt;
  const double to =
      std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - place.left) / width), 0.0, 1.0);
  return firstMs + to * (lastMs - firstMs);
}

void steps(const WeatherBarContent& content, ItemPlaces& places, WeatherBarResult& result) {
  struct Step {
    const char* label;
    double ms;
  };
  constexpr std::array<Step, 4> kSteps = {
      {{"-1 d", -kDayMs}, {"-1 h", -kHourMs}, {"+1 h", kHourMs}, {"+1 d", kDayMs}}};
  for (const Step& step : kSteps) {
    ImGui::SameLine();
    if (placedButton(step.label, step.label, places, content.live)) result.moveToMs = content.nowMs + step.ms;
  }
  for (const double speed : kBarSpeeds) {
    std::array<char, 16> label{}, name{};
    std::snprintf(label.data(), label.size(), "x%.0f", speed);
    std::snprintf(name.data(), name.size(), "speed %.0f", speed);
    ImGui::SameLine();
    if (litButton(label.data(), name.data(), places, content.speed == speed)) result.speed = speed;
  }
}

}  // namespace

float WeatherBar::height(const Interface& context) {
  const float line = context.text().pixels;
  return std::floor((2 * kPadding + kRow + kStrip + kStatus + 2 * kGap) * line);
}

WeatherBarResult WeatherBar::draw(const Interface& context, const WeatherBarContent& content) {
  WeatherBarResult result;
  places_.clear();
  const float line = context.text().pixels, high = height(context);
  ImGui::SetNextWindowPos({0, static_cast<float>(context.height()) - high});
  ImGui::SetNextWindowSize({static_cast<float>(context.width()), high});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPadding * line, kPadding * line});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap * line, kGap * line});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.25f * line, 0.5f * (kRow - 1) * line});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("##weather bar", nullptr, kFlags)) {
    if (litButton("Live", "live", places_, content.live)) result.live = true;
    ImGui::SameLine();
    if (litButton("Play", "play", places_, !content.live)) result.live = false;
    ImGui::SameLine();
    // What is typed counts when Enter is pressed; otherwise the field shows the time.
    if (!isTyping_)
      std::snprintf(typed_.data(), typed_.size(), "%.*s", static_cast<int>(content.clock.size()),
                    content.clock.data());
    ImGui::SetNextItemWidth(ImGui::CalcTextSize("0000-00-00 00:00 ").x +
                            2 * ImGui::GetStyle().FramePadding.x);
    if (ImGui::InputText("##clock", typed_.data(), typed_.size(), ImGuiInputTextFlags_EnterReturnsTrue))
      result.typed = typed_.data();
    isTyping_ = ImGui::IsItemActive();
    places_.insert_or_assign("clock", lastItemRect());
    tooltip("UTC; Enter goes there");
    steps(content, places_, result);
    if (const auto to = strip(content, kStrip * line, places_)) result.moveToMs = to;
    if (content.sites.size() > 1) {
      if (ImGui::SmallButton(content.sites[content.site].name.c_str()))
        result.site = (content.site + 1) % content.sites.size();
      places_.insert_or_assign("site", lastItemRect());
      tooltip("whose hours are shown");
      ImGui::SameLine();
    }
    const std::string words = (content.live ? "" : "Weather by hand (F1, Weather)   ") +
                              std::string(content.place) + "   " + std::string(content.status);
    const std::string text = fittingText(words, ImGui::GetContentRegionAvail().x);
    if (content.isWrong)
      ImGui::TextColored({1, 0.6f, 0.4f, 1}, "%s", text.c_str());
    else
      ImGui::TextDisabled("%s", text.c_str());
    if (text != words) tooltip(words);
  }
  ImGui::End();
  ImGui::PopStyleVar(4);
  return result;
}

}  // namespace skydrop::ui
