#include "ui/genus_picture.h"

#include <imgui.h>

#include <array>
#include <cmath>

namespace skydrop::ui {
namespace {

constexpr ImU32 kHigh = IM_COL32(52, 104, 172, 255), kLow = IM_COL32(150, 186, 220, 255);
constexpr ImU32 kGrey = IM_COL32(96, 108, 124, 255), kPale = IM_COL32(158, 168, 180, 255);
constexpr ImU32 kWhite = IM_COL32(248, 250, 252, 255), kVeil = IM_COL32(235, 240, 246, 150);
constexpr ImU32 kShade = IM_COL32(190, 200, 212, 255), kDark = IM_COL32(70, 80, 98, 255);
constexpr ImU32 kRain = IM_COL32(170, 196, 226, 255), kFlash = IM_COL32(255, 240, 170, 255);
constexpr ImU32 kFrame = IM_COL32(255, 214, 120, 255);

// The picture is a unit square, y down.
class Canvas {
 public:
  Canvas(ImDrawList& list, const ScreenRect& place)
      : list_(list), place_(place), width_(place.right - place.left), height_(place.bottom - place.top) {}

  ImVec2 at(float x, float y) const { return {place_.left + x * width_, place_.top + y * height_}; }
  void sky(ImU32 above, ImU32 below) const {
    list_.AddRectFilledMultiColor(at(0, 0), at(1, 1), above, above, below, below);
  }
  // Radius as a share of the height.
  void disc(float x, float y, float radius, ImU32 color) const {
    list_.AddCircleFilled(at(x, y), radius * height_, color, 20);
  }
  void band(float top, float bottom, ImU32 color, float left = 0, float right = 1) const {
    list_.AddRectFilled(at(left, top), at(right, bottom), color);
  }
  void line(float x, float y, float toX, float toY, ImU32 color, float width = 0.05f) const {
    list_.AddLine(at(x, y), at(toX, toY), color, width * height_);
  }
  void ring(float x, float y, float radius, ImU32 color) const {
    list_.AddCircle(at(x, y), radius * height_, color, 32, 0.04f * height_);
  }
  // A heap of discs on a level base.
  void heap(float left, float right, float base, float height, ImU32 color) const {
    const float width = right - left, disc = 0.55f * height;
    for (const auto& [x, rise] : {std::array{0.15f, 0.3f}, {0.38f, 0.7f}, {0.62f, 0.55f}, {0.85f, 0.25f}})
      this->disc(left + x * width, base - rise * height * 0.7f, disc * (0.6f + 0.5f * rise), color);
    band(base - 0.3f * height, base, color, left + 0.05f * width, right - 0.05f * width);
  }

 private:
  ImDrawList& list_;
  ScreenRect place_;
  float width_, height_;
};

void flakes(const Canvas& canvas, int columns, int rows, float top, float bottom, float radius) {
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float aside = (j % 2 == 0 ? 0.25f : 0.75f);
      const float x = (static_cast<float>(i) + aside) / static_cast<float>(columns);
      const float y = top + (bottom - top) * (static_cast<float>(j) + 0.5f) / static_cast<float>(rows);
      canvas.disc(x, y + 0.3f * radius, radius, kShade);
      canvas.disc(x, y, radius * 0.9f, kWhite);
    }
  }
}

void drawClouds(const Canvas& canvas, std::string_view genus) {
  if (genus == "stratus") {
    canvas.sky(kPale, kPale);
    canvas.band(0.45f, 0.8f, kGrey);
    canvas.band(0.5f, 0.6f, kPale, 0.1f, 0.7f);
  } else if (genus == "stratocumulus") {
    canvas.band(0.3f, 0.5f, kPale);
    for (const float x : {0.05f, 0.3f, 0.55f, 0.8f, 1.0f}) canvas.disc(x, 0.5f, 0.2f, kShade);
    for (const float x : {0.18f, 0.45f, 0.7f, 0.95f}) canvas.disc(x, 0.56f, 0.17f, kGrey);
  } else if (genus == "cumulus") {
    canvas.heap(0.2f, 0.8f, 0.75f, 0.5f, kWhite);
    canvas.band(0.68f, 0.75f, kShade, 0.24f, 0.76f);
  } else if (genus == "altostratus") {
    canvas.sky(kGrey, kPale);
    canvas.disc(0.6f, 0.4f, 0.2f, kVeil);
    canvas.disc(0.6f, 0.4f, 0.11f, kWhite);
  } else if (genus == "altocumulus") {
    flakes(canvas, 4, 3, 0.1f, 0.85f, 0.13f);
  } else if (genus == "cirrus") {
    for (const float y : {0.2f, 0.4f, 0.6f, 0.75f}) {
      const float left = 0.08f + 0.5f * std::abs(y - 0.45f);
      canvas.line(left, y + 0.08f, left + 0.45f, y - 0.05f, kVeil, 0.04f);
      canvas.line(left + 0.45f, y - 0.05f, left + 0.58f, y - 0.16f, kWhite, 0.05f);
    }
  } else if (genus == "cirrostratus") {
    canvas.band(0, 1, IM_COL32(235, 240, 246, 90));
    canvas.disc(0.5f, 0.5f, 0.12f, kWhite);
    canvas.ring(0.5f, 0.5f, 0.36f, kWhite);
  } else if (genus == "cirrocumulus") {
    flakes(canvas, 8, 5, 0.1f, 0.9f, 0.055f);
  } else if (genus == "nimbostratus") {
    canvas.sky(kDark, kGrey);
    canvas.band(0, 0.5f, kDark);
    for (int i = 0; i < 9; ++i) {
      const float x = 0.08f + 0.105f * static_cast<float>(i);
      canvas.line(x, 0.52f, x - 0.04f, 0.95f, kRain, 0.03f);
    }
  } else if (genus == "cumulonimbus") {
    canvas.heap(0.22f, 0.78f, 0.78f, 0.45f, kShade);
    canvas.heap(0.32f, 0.68f, 0.55f, 0.45f, kWhite);
    canvas.band(0.12f, 0.26f, kWhite, 0.12f, 0.9f);
    canvas.band(0.7f, 0.78f, kDark, 0.25f, 0.75f);
    canvas.line(0.5f, 0.78f, 0.44f, 0.87f, kFlash);
    canvas.line(0.44f, 0.87f, 0.5f, 0.87f, kFlash);
    canvas.line(0.5f, 0.87f, 0.43f, 0.98f, kFlash);
  }
}

}  // namespace

void drawGenusPicture(ImDrawList& list, std::string_view genus, const ScreenRect& place, bool lit) {
  const ImVec2 low(place.left, place.top), high(place.right, place.bottom);
  // Smaller than the button, whose rim shows where the keyboard and the mouse are.
  const float rim = 0.06f * (place.bottom - place.top);
  const ScreenRect inner{place.left + rim, place.top + rim, place.right - rim, place.bottom - rim};
  list.PushClipRect({inner.left, inner.top}, {inner.right, inner.bottom}, true);
  const Canvas canvas(list, inner);
  canvas.sky(kHigh, kLow);
  drawClouds(canvas, genus);
  list.PopClipRect();
  if (lit) list.AddRect(low, high, kFrame, 0, 0, 1.5f * rim);
}

}  // namespace skydrop::ui
