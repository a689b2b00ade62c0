#include "skydrop/ui/guard_list.h"

#include <algorithm>
#include <cmath>

#include "ui/text_plate.h"

namespace skydrop::ui {
namespace {

constexpr ImU32 kNow = IM_COL32(255, 190, 60, 255), kEarlier = IM_COL32(190, 196, 204, 255);
constexpr float kBelowTop = 0.3f;  // of the window: under the score and the help

}  // namespace

std::vector<GuardLine> guardLines(std::span<const core::FiredGuard> fired) {
  std::vector<GuardLine> lines = {{"Guards of this frame", false},
                                  {"yellow: light cut   cyan: negative   magenta: no number", false}};
  if (fired.empty()) lines.push_back({"none on the processor", false});
  for (const core::FiredGuard& of : fired) {
    lines.push_back({std::string(core::guardName(of.guard)) + " " + std::to_string(of.now) + ", " +
                         std::to_string(of.all) + " in all",
                     of.now > 0});
  }
  return lines;
}

void drawGuardList(const Interface& context, std::span<const GuardLine> lines) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const Typeface& face = context.text();
  ImVec2 at(std::floor(0.5f * face.pixels), std::floor(kBelowTop * static_cast<float>(context.height())));
  for (const GuardLine& line : lines) {
    drawPlate(list, face, at, line.text, line.isNow ? kNow : kEarlier);
    at.y += plateHeight(face) + 1;
  }
}

}  // namespace skydrop::ui
