#include "ui/frame_graph.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "skydrop/core/quantile.h"

namespace skydrop::ui {
namespace {

constexpr float kHeight = 3;       // lines of text
constexpr double kHeadroom = 1.3;  // over the 99th of a hundred; what is higher is cut off
constexpr double kLeastTopMs = 1;  // of the scale: noise under a millisecond is not blown up
const ImVec4 kBarColor{0.62f, 0.72f, 0.80f, 0.8f}, kSlowColor{0.95f, 0.62f, 0.20f, 1};
const ImVec4 kLineColor{1, 1, 1, 0.55f};

}  // namespace

void drawFrameGraph(std::span<const double> frameMs) {
  if (frameMs.empty()) return;
  const double median = core::quantileOf(frameMs, 0.5), p99 = core::quantileOf(frameMs, 0.99),
               worst = core::quantileOf(frameMs, 1);
  ImGui::Text("Frame %.1f ms", median);
  ImGui::TextDisabled("99 %% under %.1f, worst %.1f", p99, worst);

  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, kHeight * ImGui::GetFontSize());
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high(low.x + size.x, low.y + size.y);
  list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg));
  const double top = std::max(p99 * kHeadroom, kLeastTopMs);
  const auto heightOf = [&](double ms) { return static_cast<float>(std::min(ms / top, 1.0)) * size.y; };
  const float width = size.x / static_cast<float>(frameMs.size());
  const ImU32 plain = ImGui::GetColorU32(kBarColor), slow = ImGui::GetColorU32(kSlowColor);
  for (std::size_t i = 0; i < frameMs.size(); ++i) {
    const float left = low.x + width * static_cast<float>(i);
    list.AddRectFilled({left, high.y - heightOf(frameMs[i])}, {left + std::max(width - 0.5f, 0.5f), high.y},
                       frameMs[i] > p99 ? slow : plain);
  }
  for (const double ms : {median, p99}) {
    const float y = std::floor(high.y - heightOf(ms));
    list.AddRectFilled({low.x, y}, {high.x, y + 1}, ImGui::GetColorU32(kLineColor));
  }
}

}  // namespace skydrop::ui
