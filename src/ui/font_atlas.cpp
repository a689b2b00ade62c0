#include "ui/font_atlas.h"

#include <imgui.h>
#if IMGUI_VERSION_NUM >= 19200
#include <imgui_internal.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ui/stroke_font.h"

namespace skydrop::ui {
namespace {

constexpr char32_t kLastAscii = U'~';
constexpr double kHaloOfLine = 0.09;  // rim around a stroke; thinner ones drown in bright ground
constexpr double kMinHaloPx = 1;

double haloPixels(int linePixels) { return std::max(kHaloOfLine * linePixels, kMinHaloPx); }

#if IMGUI_VERSION_NUM >= 19200

// From 1.93 on glyphs have an index, before it was the code point: ours is the code point in either.
template <class Loader>
void setIndexFunction(Loader& loader) {
  if constexpr (requires { loader.FontSrcGetGlyphIndexFromCodepoint; }) {
    loader.FontSrcGetGlyphIndexFromCodepoint = [](ImFontAtlas*, ImFontConfig*, ImWchar codePoint) {
      return static_cast<int>(codePoint);
    };
  }
}

// From 1.92 on, Dear ImGui asks a loader for glyphs.
template <bool kHalo>
const ImFontLoader& strokeLoader() {
  static const ImFontLoader kLoader = [] {
    ImFontLoader loader;
    loader.Name = "strokes";
    setIndexFunction(loader);
    loader.FontSrcContainsGlyph = [](ImFontAtlas*, ImFontConfig*, auto codePoint) {
      return std::ranges::binary_search(strokeFontCodePoints(), static_cast<char32_t>(codePoint));
    };
    loader.FontBakedInit = [](ImFontAtlas*, ImFontConfig*, ImFontBaked* baked, void*) {
      baked->Ascent = baked->Size * static_cast<float>(kAscentUnits / kLineUnits);
      baked->Descent = baked->Ascent - baked->Size;
      return true;
    };
    loader.FontBakedLoadGlyph = [](ImFontAtlas* atlas, ImFontConfig* source, ImFontBaked* baked, void*,
                                   auto index, ImFontGlyph* glyph, float* advance) {
      const auto codePoint = static_cast<ImWchar>(index);
      if (!std::ranges::binary_search(strokeFontCodePoints(), static_cast<char32_t>(codePoint))) return false;
      const int pixels = static_cast<int>(baked->Size);
      const GlyphBitmap bitmap = rasterizeGlyph(codePoint, pixels, kHalo ? haloPixels(pixels) : 0);
      if (!glyph) {
        *advance = static_cast<float>(bitmap.advance);
        return true;
      }
      glyph->Codepoint = codePoint;
      glyph->AdvanceX = static_cast<float>(bitmap.advance);
      if (bitmap.coverage.empty()) return true;
      const ImFontAtlasRectId id = ImFontAtlasPackAddRect(atlas, bitmap.width, bitmap.height);
      if (id == ImFontAtlasRectId_Invalid) return false;
      glyph->X0 = static_cast<float>(bitmap.offsetX);
      glyph->Y0 = static_cast<float>(bitmap.offsetY);
      glyph->X1 = static_cast<float>(bitmap.offsetX + bitmap.width);
      glyph->Y1 = static_cast<float>(bitmap.offsetY + bitmap.height);
      glyph->Visible = true;
      glyph->PackId = id;
      ImFontAtlasBakedSetFontGlyphBitmap(atlas, baked, source, glyph, ImFontAtlasPackGetRect(atlas, id),
                                         bitmap.coverage.data(), ImTextureFormat_Alpha8, bitmap.width);
      return true;
    };
    return loader;
  }();
  return kLoader;
}

const ImWchar* glyphRanges(bool asciiOnly) {
  static const std::vector<ImWchar> kAll = [] {
    std::vector<ImWchar> ranges;
    for (const char32_t c : strokeFontCodePoints()) {
      if (ranges.empty() || ranges.back() + 1 != static_cast<ImWchar>(c))
        ranges.insert(ranges.end(), 2, static_cast<ImWchar>(c));
      ranges.back() = static_cast<ImWchar>(c);
    }
    ranges.push_back(0);
    return ranges;
  }();
  static constexpr ImWchar kAscii[] = {' ', kLastAscii, 0};
  return asciiOnly ? kAscii : kAll.data();
}

Typeface addTypeface(ImFontAtlas& atlas, int pixels, bool asciiOnly) {
  const auto add = [&](const ImFontLoader& loader) {
    ImFontConfig config;
    config.SizePixels = static_cast<float>(pixels);
    config.FontLoader = &loader;
    config.GlyphRanges = glyphRanges(asciiOnly);
    return atlas.AddFont(&config);
  };
  ImFont* face = add(strokeLoader<false>());
  return {face, add(strokeLoader<true>()), static_cast<float>(pixels)};
}

#else

struct PendingGlyph {
  int rectangle;
  GlyphBitmap bitmap;
};

// Before 1.92 glyphs are custom rectangles of a font, which itself must come from somewhere: ImGui's built-in
// one, of which the space is kept alone.
ImFont* addFont(ImFontAtlas& atlas, int pixels, bool asciiOnly, bool halo,
                std::vector<PendingGlyph>& pending) {
  static constexpr ImWchar kSpace[] = {' ', ' ', 0};
  ImFontConfig config;
  config.SizePixels = static_cast<float>(pixels);
  config.GlyphRanges = kSpace;
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  ImFont* font = atlas.AddFontDefault(&config);
  for (const char32_t c : strokeFontCodePoints()) {
    if (asciiOnly && c > kLastAscii) continue;
    GlyphBitmap bitmap = rasterizeGlyph(c, pixels, halo ? haloPixels(pixels) : 0);
    if (bitmap.coverage.empty()) {  // a rectangle may not be empty
      bitmap.width = bitmap.height = 1;
      bitmap.coverage.assign(1, 0);
    }
    const ImVec2 offset(static_cast<float>(bitmap.offsetX), static_cast<float>(bitmap.offsetY));
    const int rectangle =
        atlas.AddCustomRectFontGlyph(font, static_cast<ImWchar>(c), bitmap.width, bitmap.height,
                                     static_cast<float>(bitmap.advance), offset);
    pending.push_back({rectangle, std::move(bitmap)});
  }
  return font;
}

Typeface addTypeface(ImFontAtlas& atlas, int pixels, bool asciiOnly, std::vector<PendingGlyph>& pending) {
  ImFont* face = addFont(atlas, pixels, asciiOnly, false, pending);
  return {face, addFont(atlas, pixels, asciiOnly, true, pending), static_cast<float>(pixels)};
}

#endif

}  // namespace

InterfaceFonts buildFonts(ImFontAtlas& atlas, int linePixels) {
  InterfaceFonts fonts;
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
#if IMGUI_VERSION_NUM >= 19200
  fonts.text = addTypeface(atlas, linePixels, false);
  fonts.large = addTypeface(atlas, 2 * linePixels, true);
  atlas.Build();
#else
  std::vector<PendingGlyph> pending;
  fonts.text = addTypeface(atlas, linePixels, false, pending);
  fonts.large = addTypeface(atlas, 2 * linePixels, true, pending);
  atlas.Build();
  unsigned char* texels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&texels, &width, &height);
  for (const PendingGlyph& glyph : pending) {
    const ImFontAtlasCustomRect& place = *atlas.GetCustomRectByIndex(glyph.rectangle);
    for (int y = 0; y < glyph.bitmap.height; ++y) {
      std::copy_n(glyph.bitmap.coverage.data() + y * glyph.bitmap.width, glyph.bitmap.width,
                  texels + (place.Y + y) * width + place.X);
    }
  }
#endif
  return fonts;
}

}  // namespace skydrop::ui
