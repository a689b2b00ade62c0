// The stroke font as fonts of Dear ImGui: every glyph is rasterised once for the wanted sizes into the atlas.
#pragma once

#include "skydrop/ui/imgui_context.h"

struct ImFontAtlas;

namespace skydrop::ui {

struct InterfaceFonts {
  Typeface text, large;
};

// Replaces the atlas's fonts and its texels. Not between beginFrame and endFrame.
InterfaceFonts buildFonts(ImFontAtlas& atlas, int linePixels);

}  // namespace skydrop::ui
