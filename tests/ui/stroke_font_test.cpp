#include "ui/stroke_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace skydrop::ui {
namespace {

constexpr int kSizes[] = {9, 10, 11, 12, 13, 16, 18, 27, 54};  // pixels; 10 is the smallest line of Interface

int coverageAt(const GlyphBitmap& glyph, int x, int y) {
  const int column = x - glyph.offsetX, row = y - glyph.offsetY;
  if (column < 0 || row < 0 || column >= glyph.width || row >= glyph.height) return 0;
  return glyph.coverage[static_cast<std::size_t>(row * glyph.width + column)];
}

// Sum over all pixels, in fully covered pixels.
double difference(const GlyphBitmap& a, const GlyphBitmap& b, int size) {
  int sum = 0;
  for (int y = -size; y < 2 * size; ++y) {
    for (int x = -size; x < 2 * size; ++x) sum += std::abs(coverageAt(a, x, y) - coverageAt(b, x, y));
  }
  return sum / 255.0;
}

TEST(StrokeFont, noTwoFiguresLookAlikeAtAnySize) {
  // A speed of 63 must not read as 83. Two pixels are what the eye needs: 6 and 8 once differed by 1.3 at the
  // smallest size and were mistaken for each other.
  for (const int size : kSizes) {
    for (char32_t a = U'0'; a <= U'9'; ++a) {
      for (char32_t b = a + 1; b <= U'9'; ++b) {
        EXPECT_GT(difference(rasterizeGlyph(a, size, 0), rasterizeGlyph(b, size, 0), size), 2)
            << static_cast<char>(a) << " and " << static_cast<char>(b) << " at " << size << " px";
      }
    }
  }
}

TEST(StrokeFont, figuresShareOneAdvance) {
  // A number does not jitter while it counts.
  for (const int size : kSizes) {
    for (char32_t figure = U'1'; figure <= U'9'; ++figure) {
      EXPECT_EQ(rasterizeGlyph(figure, size, 0).advance, rasterizeGlyph(U'0', size, 0).advance);
    }
  }
}

TEST(StrokeFont, everyGlyphHasInkAndStaysWithinItsLine) {
  // Apart from the space; half a pen's width may reach over the line, by a row and a faint edge.
  for (const int size : kSizes) {
    for (const char32_t c : strokeFontCodePoints()) {
      if (c == U' ') continue;
      const GlyphBitmap glyph = rasterizeGlyph(c, size, 0);
      EXPECT_GT(std::ranges::max(glyph.coverage), 128) << static_cast<unsigned>(c) << " at " << size;
      for (int y = glyph.offsetY; y < glyph.offsetY + glyph.height; ++y) {
        if (y >= -1 && y <= size) continue;
        for (int x = glyph.offsetX; x < glyph.offsetX + glyph.width; ++x) {
          EXPECT_LT(coverageAt(glyph, x, y), 128)
              << static_cast<unsigned>(c) << " at " << size << ", row " << y;
        }
      }
    }
  }
}

TEST(StrokeFont, aHaloSurroundsTheLetterAndKeepsItsAdvance) {
  for (const int size : kSizes) {
    for (const char32_t c : strokeFontCodePoints()) {
      const GlyphBitmap face = rasterizeGlyph(c, size, 0), halo = rasterizeGlyph(c, size, 2);
      EXPECT_EQ(halo.advance, face.advance);
      for (int y = -size; y < 2 * size; ++y) {
        for (int x = -size; x < 2 * size; ++x) ASSERT_GE(coverageAt(halo, x, y), coverageAt(face, x, y));
      }
    }
  }
}

TEST(StrokeFont, anUnknownCharacterIsAQuestionMark) {
  EXPECT_EQ(rasterizeGlyph(U'\u4e2d', 18, 0).coverage, rasterizeGlyph(U'?', 18, 0).coverage);
}

}  // namespace
}  // namespace skydrop::ui
