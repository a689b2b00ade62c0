#include "ui/statistics_view.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "skydrop/core/joined.h"
#include "ui/frame_graph.h"
#include "ui/menu_item.h"

namespace skydrop::ui {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;
const ImVec4 kShareColor{0.95f, 0.62f, 0.20f, 0.30f};

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// "1 234 567"
std::string grouped(std::int64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && digits[i - 1] != '-' && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

void row(const char* name, const std::string& value) {
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name);
  rightCell(value);
}

// The same rows whatever a frame did: what stands below must not move under the mouse.
void drawPasses(const core::FrameStatistics& statistics) {
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("passes", 4, kFlags)) return;
  const float figure = ImGui::CalcTextSize("000.00").x;
  ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
  for (const char* name : {"ms", "draws", "disp."}) {
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, figure);
  }
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Pass");
  for (const char* title : {"ms", "draws", "disp."}) rightCell(title);
  double sum = 0, most = 0;
  for (const auto& [name, pass] : statistics.passes) {
    sum += pass.skipped.empty() ? pass.ms : 0;
    most = std::max(most, pass.ms);
  }
  const bool timed = most > 0;
  for (const auto& [name, pass] : statistics.passes) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (!pass.skipped.empty()) {
      ImGui::TextDisabled("%s", name.c_str());
      tooltip("Idle: " + pass.skipped);
      rightCell("idle");
      tooltip("Idle: " + pass.skipped);
      continue;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (timed) {
      const auto share = static_cast<float>(pass.ms / most);
      ImGui::GetWindowDrawList()->AddRectFilled(
          at, {at.x + share * ImGui::GetContentRegionAvail().x, at.y + ImGui::GetFontSize()},
          ImGui::GetColorU32(kShareColor));
    }
    ImGui::TextUnformatted(name.c_str());
    rightCell(timed ? formatted("%.2f", pass.ms) : "–");
    rightCell(std::to_string(pass.draws));
    rightCell(std::to_string(pass.dispatches));
  }
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("together");
  rightCell(timed ? formatted("%.2f", sum) : "–");
  ImGui::EndTable();
}

// "42 of 128 MiB"
std::string megabytes(std::int64_t bytes, const core::Field* budget) {
  const double used = static_cast<double>(bytes) / kMebibyte;
  char text[64];
  if (budget) {
    std::snprintf(text, sizeof text, "%.0f of %.0f MiB", used, budget->get());
  } else {
    std::snprintf(text, sizeof text, "%.0f MiB", used);
  }
  return text;
}

void drawResidency(const core::FrameStatistics& statistics, const core::SettingsTable& table) {
  if (!ImGui::BeginTable("residency", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_PadOuterX)) return;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed);
  const core::TerrainStatistics& terrain = statistics.terrain;
  if (terrain.chunksDrawn > 0 || terrain.bytes > 0) {
    row("Land: chunks drawn", grouped(terrain.chunksDrawn));
    row("triangles", grouped(terrain.triangles));
    row("chunks waiting", grouped(terrain.queue));
    row("made, found in the cache", grouped(terrain.generated) + ", " + grouped(terrain.cacheHits));
    row("chunks on the CPU", megabytes(terrain.bytes, table.find("streaming.cacheMiB")));
    row("coarser than wanted: budget full", grouped(terrain.coarsened));
  }
  row("GPU: everything", megabytes(statistics.gl.bytes, nullptr));
  row("textures, buffers", grouped(statistics.gl.textures) + ", " + grouped(statistics.gl.buffers));
  ImGui::EndTable();
}

// Of all guards, in the same place whether or not they fired.
void drawGuards(const core::FrameStatistics& statistics) {
  if (statistics.guards.empty()) return;
  if (!ImGui::BeginTable("guards", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_PadOuterX)) return;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Guards");
  rightCell("fired");
  for (const auto& [name, count] : statistics.guards) row(name.c_str(), grouped(count));
  ImGui::EndTable();
}

}  // namespace

void drawStatistics(const core::FrameStatistics& statistics, std::span<const double> frameMs,
                    const core::SettingsTable& table) {
  if (frameMs.empty()) {
    ImGui::Text("Frame %.1f ms", statistics.medianMs);
  } else {
    drawFrameGraph(frameMs);
  }
  drawPasses(statistics);
  if (!statistics.clock.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("Clock of the passes: %s", statistics.clock.c_str());
    ImGui::PopTextWrapPos();
  }
  drawResidency(statistics, table);
  drawGuards(statistics);
  const std::string effects = core::joined(statistics.effects);
  if (!effects.empty()) ImGui::TextWrapped("Effects: %s", effects.c_str());
  if (!statistics.renderer.empty()) ImGui::TextWrapped("%s", statistics.renderer.c_str());
}

}  // namespace skydrop::ui
