#include "ui/statistics_view.h"

#include <imgui.h>

#include <cinttypes>
#include <string>

namespace skydrop::ui {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;

void number(const char* format, double value) {
  ImGui::TableNextColumn();
  ImGui::Text(format, value);
}

void drawPasses(const core::FrameStatistics& statistics) {
  if (!ImGui::BeginTable("passes", 4, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerH)) return;
  ImGui::TableSetupColumn("Pass", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("ms");
  ImGui::TableSetupColumn("Draws");
  ImGui::TableSetupColumn("Disp.");
  ImGui::TableHeadersRow();
  for (const auto& [name, pass] : statistics.passes) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    if (!pass.skipped.empty()) {
      ImGui::SameLine();
      ImGui::TextDisabled("%s", pass.skipped.c_str());
    }
    number("%.2f", pass.ms);
    number("%.0f", static_cast<double>(pass.draws));
    number("%.0f", static_cast<double>(pass.dispatches));
  }
  ImGui::EndTable();
}

}  // namespace

void drawStatistics(const core::FrameStatistics& statistics) {
  ImGui::Text("Frame %.1f ms   99 %% under %.1f   worst %.1f", statistics.medianMs, statistics.p99Ms,
              statistics.maxMs);
  drawPasses(statistics);
  if (!statistics.clock.empty()) ImGui::TextDisabled("Clock: %s", statistics.clock.c_str());
  const core::TerrainStatistics& terrain = statistics.terrain;
  ImGui::Text("Terrain: %" PRId64 " chunks, %" PRId64 " triangles, %" PRId64 " waiting, %.0f MiB",
              terrain.chunksDrawn, terrain.triangles, terrain.queue,
              static_cast<double>(terrain.bytes) / kMebibyte);
  ImGui::Text("GPU: %" PRId64 " textures, %" PRId64 " buffers, %.0f MiB", statistics.gl.textures,
              statistics.gl.buffers, static_cast<double>(statistics.gl.bytes) / kMebibyte);
  std::string effects;
  for (const std::string& effect : statistics.effects) effects += (effects.empty() ? "" : ", ") + effect;
  if (!effects.empty()) ImGui::TextWrapped("Effects: %s", effects.c_str());
  if (!statistics.renderer.empty()) ImGui::TextWrapped("%s", statistics.renderer.c_str());
}

}  // namespace skydrop::ui
