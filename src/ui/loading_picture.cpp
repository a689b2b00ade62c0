#include "skydrop/ui/loading_picture.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace skydrop::ui {
namespace {

// Shares of the window's size.
constexpr float kHorizon = 0.62f, kTitleAt = 0.40f, kBarAt = 0.74f, kBarWidth = 0.36f;
constexpr float kBarLines = 0.3f;  // height of the bar in lines of text

// A sky above a darker haze: the colours of the game before its first frame.
constexpr ImU32 kZenith = IM_COL32(38, 84, 138, 255), kHaze = IM_COL32(176, 198, 214, 255);
constexpr ImU32 kGroundFar = IM_COL32(104, 126, 132, 255), kGroundNear = IM_COL32(38, 52, 50, 255);
constexpr ImU32 kWhite = IM_COL32(245, 247, 250, 255), kHalo = IM_COL32(0, 0, 0, 170);
constexpr ImU32 kTrack = IM_COL32(0, 0, 0, 110), kAccent = IM_COL32(255, 190, 70, 255);

void centred(ImDrawList& list, const Typeface& typeface, const std::string& text, float width, float top) {
  const float length = typeface.face->CalcTextSizeA(typeface.pixels, width, 0, text.c_str()).x;
  const ImVec2 at(std::floor((width - length) / 2), std::floor(top));
  list.AddText(typeface.halo, typeface.pixels, at, kHalo, text.c_str());
  list.AddText(typeface.face, typeface.pixels, at, kWhite, text.c_str());
}

}  // namespace

void drawLoadingPicture(const Interface& context, const LoadingProgress& progress) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto width = static_cast<float>(context.width()), height = static_cast<float>(context.height());
  const float line = context.text().pixels, horizon = std::floor(kHorizon * height);
  list.AddRectFilledMultiColor({0, 0}, {width, horizon}, kZenith, kZenith, kHaze, kHaze);
  list.AddRectFilledMultiColor({0, horizon}, {width, height}, kGroundFar, kGroundFar, kGroundNear,
                               kGroundNear);
  centred(list, context.large(), "SKYDROP", width, kTitleAt * height - line);

  const float half = kBarWidth * width / 2, top = std::floor(kBarAt * height);
  const float left = std::floor(width / 2 - half), right = std::floor(width / 2 + half);
  const float bottom = top + std::max(2.0f, std::floor(kBarLines * line));
  // Written so that NaN ends at 0.
  const double share = progress.share > 0 ? std::min(progress.share, 1.0) : 0;
  list.AddRectFilled({left, top}, {right, bottom}, kTrack);
  list.AddRectFilled({left, top}, {left + (right - left) * static_cast<float>(share), bottom}, kAccent);
  centred(list, context.text(), progress.what, width, bottom + line / 2);
}

}  // namespace skydrop::ui
