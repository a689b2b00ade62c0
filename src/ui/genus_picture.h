// Pictures of the ten genera of clouds, drawn with lines and discs: as sharp in 4K as in a small window.
#pragma once

#include <string_view>

#include "skydrop/ui/imgui_context.h"

struct ImDrawList;

namespace skydrop::ui {

// Fills the rectangle: a sky, and the genus of this name before it; nothing but the sky for another name. One
// that is lit has a bright frame.
void drawGenusPicture(ImDrawList& list, std::string_view genus, const ScreenRect& place, bool lit);

}  // namespace skydrop::ui
