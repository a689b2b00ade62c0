// A line of text on a dark plate, readable over any picture.
#pragma once

#include <imgui.h>

#include <string>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

inline constexpr ImU32 kPlateText = IM_COL32(245, 247, 250, 255);

float textWidth(const Typeface& face, const std::string& text);
float plateWidth(const Typeface& face, const std::string& text);
float plateHeight(const Typeface& face);

// `at` is its upper left corner.
void drawPlate(ImDrawList& list, const Typeface& face, ImVec2 at, const std::string& text,
               ImU32 color = kPlateText);

}  // namespace skydrop::ui
