// The interface's own typeface: letters are strokes on a grid, as in a real head-up display, so they are
// sharp at every size from one short table and need no font file. Pure functions, no Dear ImGui.
//
// Units of a glyph: baseline y = 0, capitals reach y = 6, small letters 4.2, descenders -1.9; a line of text
// is kLineUnits high. A font of size s pixels therefore has s / kLineUnits pixels in a unit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace skydrop::ui {

inline constexpr double kLineUnits = 10.0;
inline constexpr double kAscentUnits = 7.4;  // from the top of the line to the baseline

// Coverage of one glyph, row 0 on top; (offsetX, offsetY) is its top left corner in pixels from the pen
// position at the top of the line, y down. Empty for a space.
struct GlyphBitmap {
  int width = 0, height = 0;
  int offsetX = 0, offsetY = 0;
  int advance = 0;
  std::vector<std::uint8_t> coverage;
};

// All code points that the typeface has, ascending: printable ASCII, some signs and the four arrows.
std::span<const char32_t> strokeFontCodePoints();

// Draws a glyph for a font of sizePixels (at least 1). `halo` (pixels, at least 0) widens every stroke on all
// sides: the dark rim under a letter that keeps it readable over bright ground; it does not change the
// advance. Strokes are fitted to the pixel grid, so horizontals and verticals are crisp. Unknown code points
// give the glyph of '?'.
GlyphBitmap rasterizeGlyph(char32_t codePoint, int sizePixels, double halo);

}  // namespace skydrop::ui
