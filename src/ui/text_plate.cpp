#include "ui/text_plate.h"

#include <cmath>

namespace skydrop::ui {
namespace {

constexpr float kPadding = 0.35f;  // lines of text
constexpr ImU32 kPlate = IM_COL32(8, 12, 16, 150), kHalo = IM_COL32(0, 0, 0, 180);

float padding(const Typeface& face) { return std::floor(kPadding * face.pixels); }

}  // namespace

float textWidth(const Typeface& face, const std::string& text) {
  return face.face->CalcTextSizeA(face.pixels, 1e9f, 0, text.c_str()).x;
}

float plateWidth(const Typeface& face, const std::string& text) {
  return textWidth(face, text) + 2 * padding(face);
}

float plateHeight(const Typeface& face) { return face.pixels + padding(face); }

void drawPlate(ImDrawList& list, const Typeface& face, ImVec2 at, const std::string& text, ImU32 color) {
  const float pad = padding(face);
  const ImVec2 high(at.x + plateWidth(face, text), at.y + plateHeight(face));
  list.AddRectFilled(at, high, kPlate, 0.2f * face.pixels);
  const ImVec2 inside(at.x + pad, std::floor(at.y + pad / 2));
  list.AddText(face.halo, face.pixels, inside, kHalo, text.c_str());
  list.AddText(face.face, face.pixels, inside, color, text.c_str());
}

}  // namespace skydrop::ui
