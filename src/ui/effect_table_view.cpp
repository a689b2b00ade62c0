#include "ui/effect_table_view.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "ui/field_label.h"
#include "ui/menu_item.h"

namespace skydrop::ui {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

const core::EffectStatistics* billOf(const core::FrameStatistics* statistics, const std::string& name) {
  if (!statistics) return nullptr;
  const auto found = std::ranges::find(statistics->bill, name, &core::EffectStatistics::name);
  return found == statistics->bill.end() ? nullptr : &*found;
}

// Everything about one effect, for its tooltip.
std::string detailsOf(const core::EffectStatistics& bill) {
  std::string text = bill.idle.empty() ? "" : "Idle: " + bill.idle + ".\n";
  text += formatted("%.2f ms a frame", bill.ms);
  if (bill.simulationMs > 0) text += formatted(", %.3f ms of simulation", bill.simulationMs);
  text += "; " + std::to_string(bill.draws) + " draws, " + std::to_string(bill.dispatches) + " dispatches\n";
  text += std::to_string(bill.objects) +
          formatted(" objects, %.1f MiB on the GPU", static_cast<double>(bill.gpuBytes) / kMebibyte);
  if (bill.cpuBytes > 0)
    text += formatted(", %.1f MiB beside it", static_cast<double>(bill.cpuBytes) / kMebibyte);
  if (bill.threads > 0)
    text += ", " + std::to_string(bill.threads) + (bill.threads == 1 ? " thread" : " threads");
  return text + formatted("; made in %.0f ms", bill.startMs);
}

}  // namespace

const core::Field* drawEffectTable(std::span<const core::Field* const> fields,
                                   const core::FrameStatistics* statistics,
                                   std::map<std::string, MenuRowPlace>& places) {
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("effects", 4, kFlags)) return nullptr;
  const float figure = ImGui::CalcTextSize("000.00").x;
  ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch);
  for (const char* name : {"ms", "calls", "MiB"})
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, figure);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Effect");
  for (const char* title : {"ms", "calls", "MiB"}) rightCell(title);
  const core::Field* switched = nullptr;
  for (const core::Field* field : fields) {
    const core::EffectStatistics* bill = billOf(statistics, field->name);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    bool on = field->get() != 0;
    if (ImGui::Checkbox((humanName(field->name) + "###" + field->path).c_str(), &on)) switched = field;
    places.insert_or_assign(field->path, MenuRowPlace{lastItemRect(), std::nullopt});
    tooltip(tooltipText(*field) + (bill && bill->on ? "\n" + detailsOf(*bill) : ""));
    if (!on || !bill || !bill->on) {
      rightCell(on ? "..." : "off");
      rightCell("");
      rightCell("");
      continue;
    }
    rightCell(!bill->idle.empty() ? "idle" : bill->ms > 0 ? formatted("%.2f", bill->ms) : "\u2013");
    if (!bill->idle.empty()) tooltip("Idle: " + bill->idle);
    rightCell(std::to_string(bill->draws + bill->dispatches));
    rightCell(formatted("%.1f", static_cast<double>(bill->gpuBytes) / kMebibyte));
  }
  ImGui::EndTable();
  return switched;
}

}  // namespace skydrop::ui
