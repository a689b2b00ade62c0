#include "skydrop/ui/cost_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "ui/frame_graph.h"
#include "ui/menu_item.h"

namespace skydrop::ui {
namespace {

// In lines of text, or as shares of the window.
constexpr float kWidth = 0.44f, kLeastWidth = 24, kTop = 1.2f, kHeight = 0.82f, kGraphWidth = 7,
                kPlotHeight = 4;
constexpr int kBars = 60;  // of a graph: each the longest of the frames that fall on it
const ImVec4 kBarColor{0.62f, 0.72f, 0.80f, 0.9f}, kMarkColor{1.0f, 0.75f, 0.27f, 1},
    kFrontColor{0.62f, 0.80f, 0.95f, 0.9f}, kPointColor{0.7f, 0.7f, 0.7f, 0.8f};

constexpr std::array<const char*, 3> kTitles = {"Passes", "Simulation (CPU)", "Updates (CPU)"};

void number(const char* format, double value) {
  char text[32];
  const int length = std::snprintf(text, sizeof text, format, value);
  const float width = ImGui::CalcTextSize(text, text + length).x;
  ImGui::TableNextColumn();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
  ImGui::TextUnformatted(text, text + length);
}

// Bars from the oldest to the newest; full height is the 99th of a hundred and a little more.
void graph(const CostRow& row) {
  ImGui::TableNextColumn();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize());
  ImGui::Dummy(size);
  if (row.ms.empty() || row.p99Ms <= 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = ImGui::GetColorU32(kBarColor);
  const auto count = row.ms.size();
  const float top = static_cast<float>(row.p99Ms * 1.15), width = size.x / kBars, bottom = low.y + size.y;
  list.PrimReserve(6 * kBars, 4 * kBars);
  for (std::size_t bar = 0; bar < kBars; ++bar) {
    const std::size_t first = bar * count / kBars, end = std::max((bar + 1) * count / kBars, first + 1);
    float most = 0;
    for (std::size_t i = first; i < std::min(end, count); ++i) most = std::max(most, row.ms[i]);
    const float left = low.x + width * static_cast<float>(bar);
    list.PrimRect({left, bottom - size.y * std::min(most / top, 1.0f)}, {left + width * 0.8f, bottom}, color);
  }
}

void rows(const CostPanelContent& content) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("costs", 5, kFlags)) return;
  const float figure = ImGui::CalcTextSize("0000.00").x;
  ImGui::TableSetupColumn("part", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("graph", ImGuiTableColumnFlags_WidthFixed, kGraphWidth * ImGui::GetFontSize());
  for (const char* name : {"median", "p99", "share"})
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, figure);
  for (std::size_t kind = 0; kind < kTitles.size(); ++kind) {
    bool titled = false;
    for (const CostRow& row : content.rows) {
      if (static_cast<std::size_t>(row.kind) != kind) continue;
      if (!std::exchange(titled, true)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", kTitles[kind]);
        ImGui::TableNextColumn();
        for (const char* title : {"ms", "p99", "share"}) rightCell(title);
      }
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(row.name.c_str());
      graph(row);
      number("%.2f", row.medianMs);
      number("%.2f", row.p99Ms);
      number("%.1f %%", 100 * row.share);
    }
  }
  ImGui::EndTable();
}

// Error over time, both on log axes: the front as a line, the present value as a mark.
void plot(const KnobStand& knob) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, kPlotHeight * ImGui::GetFontSize());
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  double leastMs = std::numeric_limits<double>::max(), mostMs = 0, leastError = leastMs, mostError = 0;
  for (const KnobStand::Point& point : knob.points) {
    leastMs = std::min(leastMs, point.ms), mostMs = std::max(mostMs, point.ms);
    leastError = std::min(leastError, point.error), mostError = std::max(mostError, point.error);
  }
  const auto along = [](double value, double least, double most) {
    return most > least ? static_cast<float>(std::log(value / least) / std::log(most / least)) : 0.5f;
  };
  const float margin = 0.5f * ImGui::GetFontSize();
  const auto place = [&](const KnobStand::Point& point) {
    return ImVec2(
        low.x + margin + (size.x - 2 * margin) * along(point.ms, leastMs, mostMs),
        low.y + size.y - margin - (size.y - 2 * margin) * along(point.error, leastError, mostError));
  };
  const KnobStand::Point* before = nullptr;
  for (const KnobStand::Point& point : knob.points) {
    if (point.onFront && before)
      list.AddLine(place(*before), place(point), ImGui::GetColorU32(kFrontColor), 1.5f);
    if (point.onFront) before = &point;
    list.AddCircleFilled(place(point), 0.14f * ImGui::GetFontSize(), ImGui::GetColorU32(kPointColor), 8);
  }
  if (knob.present < 0) return;
  const ImVec2 mark = place(knob.points[static_cast<std::size_t>(knob.present)]);
  list.AddCircle(mark, 0.4f * ImGui::GetFontSize(), ImGui::GetColorU32(kMarkColor), 16, 2);
}

void wrapped(std::string_view text) {
  if (text.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
}

void knobs(const CostPanelContent& content) {
  ImGui::Spacing();
  ImGui::TextDisabled("Error against time, as measured");
  for (const KnobStand& knob : content.knobs) {
    ImGui::TextUnformatted(knob.title.c_str());
    wrapped(knob.text);
    if (!knob.points.empty()) plot(knob);
  }
  wrapped(content.note);
}

}  // namespace

bool drawCostPanel(const Interface& context, const CostPanelContent& content) {
  const float line = context.text().pixels;
  const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
  const float wide = std::min(std::max(kWidth * width, kLeastWidth * line), width);
  ImGui::SetNextWindowPos({width - wide - 0.5f * line, kTop * line}, ImGuiCond_Appearing);
  ImGui::SetNextWindowSize({wide, kHeight * height}, ImGuiCond_Appearing);
  bool open = true;
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
  if (ImGui::Begin("What a frame costs###cost panel", &open, kFlags)) {
    drawFrameGraph(content.frameMs);
    wrapped(content.budget);
    rows(content);
    if (!content.clock.empty()) {
      ImGui::PushTextWrapPos(0);
      ImGui::TextDisabled("Clock of the passes: %.*s", static_cast<int>(content.clock.size()),
                          content.clock.data());
      ImGui::PopTextWrapPos();
    }
    knobs(content);
  }
  ImGui::End();
  return open;
}

}  // namespace skydrop::ui
