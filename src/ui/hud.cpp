#include "skydrop/ui/hud.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace skydrop::ui {
namespace {

ImU32 color(int red, int green, int blue, double opacity) {
  return IM_COL32(red, green, blue, static_cast<int>(std::clamp(opacity, 0.0, 1.0) * 255 + 0.5));
}

ImU32 toneColor(HudText::Tone tone, double opacity) {
  switch (tone) {
    case HudText::Tone::normal:
      return color(245, 247, 250, opacity);
    case HudText::Tone::dim:
      return color(196, 205, 214, opacity);
    case HudText::Tone::accent:
      return color(255, 190, 70, opacity);
    case HudText::Tone::warning:
      return color(255, 120, 90, opacity);
  }
  return 0;
}

ImVec2 vec(glm::dvec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

void drawText(ImDrawList& list, const Interface& context, const HudText& text) {
  const Typeface& typeface = text.large ? context.large() : context.text();
  const ImVec2 at(text.position.x, text.position.y);
  list.AddText(typeface.halo, typeface.pixels, at, color(0, 0, 0, 0.7 * text.opacity), text.text.c_str());
  list.AddText(typeface.face, typeface.pixels, at, toneColor(text.tone, text.opacity), text.text.c_str());
}

// Lengths as shares of the circle's radius.
constexpr double kArrowReach = 0.86, kHeadLength = 0.34, kHeadHalfWidth = 0.19, kShaftHalfWidth = 0.07;
constexpr double kDotRadius = 0.13, kMinDotPixels = 2.5;
constexpr int kCircleSegments = 64;

void drawArrow(ImDrawList& list, glm::dvec2 centre, double radius, glm::dvec2 arrow) {
  const double length = std::hypot(arrow.x, arrow.y);
  const glm::dvec2 along = arrow / length, across(-along.y, along.x);
  // A short arrow keeps its head, so that the direction of slow flight can be read.
  const double head = kHeadLength * radius, tip = std::max(length * kArrowReach * radius, head);
  const glm::dvec2 point = centre + along * tip, neck = centre + along * (tip - head);
  const ImU32 black = color(0, 0, 0, 1);
  const double half = std::max(kShaftHalfWidth * radius, 0.75);
  // Clockwise: Dear ImGui smooths the edges of such shapes only.
  if (tip > head) {
    list.AddQuadFilled(vec(centre - across * half), vec(neck - across * half), vec(neck + across * half),
                       vec(centre + across * half), black);
  }
  list.AddTriangleFilled(vec(point), vec(neck + across * (kHeadHalfWidth * radius)),
                         vec(neck - across * (kHeadHalfWidth * radius)), black);
}

void drawNavigationBar(ImDrawList& list, const Interface& context, const NavigationBar& bar, glm::vec2 middle,
                       float radius) {
  const glm::dvec2 centre(middle);
  const float rim = std::max(1.0f, std::floor(radius * 0.06f));
  const ImVec2 at(middle.x, middle.y);
  list.AddCircleFilled(at, radius, color(0, 0, 0, 0.55), kCircleSegments);
  list.AddCircleFilled(at, radius - rim, color(235, 240, 245, 0.72), kCircleSegments);
  // North on top, and the other quarters as ticks.
  const double inside = radius - rim;
  for (int quarter = 1; quarter < 4; ++quarter) {
    const glm::dvec2 direction = quarter == 2 ? glm::dvec2(0, 1) : glm::dvec2(quarter == 1 ? 1 : -1, 0);
    list.AddLine(vec(centre + direction * inside), vec(centre + direction * (inside * 0.86)),
                 color(0, 0, 0, 0.6), 1);
  }
  const Typeface& text = context.text();
  const float width = text.face->CalcTextSizeA(text.pixels, radius, 0, "N").x;
  list.AddText(text.face, text.pixels,
               {std::floor(middle.x - width / 2), std::floor(middle.y - static_cast<float>(inside) + 1)},
               color(150, 20, 20, 0.9), "N");

  if (bar.arrow) drawArrow(list, centre, inside, *bar.arrow);
  if (bar.dot && bar.dotLit) {
    const double dot = std::max(kDotRadius * radius, kMinDotPixels);
    const ImVec2 place = vec(centre + *bar.dot * (inside - dot));  // wholly inside, on the rim too
    list.AddCircleFilled(place, static_cast<float>(dot), color(255, 255, 255, 1), 24);
    list.AddCircleFilled(place, static_cast<float>(dot - std::max(1.0, dot * 0.2)), color(20, 80, 255, 1),
                         24);
  }
}

void drawThrottle(ImDrawList& list, const ScreenRect& bar, double throttle) {
  if (bar.right <= bar.left || bar.bottom <= bar.top) return;
  list.AddRectFilled({bar.left, bar.top}, {bar.right, bar.bottom}, color(255, 255, 255, 0.22));
  const float end = bar.left + (bar.right - bar.left) * static_cast<float>(throttle);
  list.AddRectFilled({bar.left, bar.top}, {end, bar.bottom}, toneColor(HudText::Tone::accent, 1));
}

// Lengths in lines of text.
constexpr float kMarkRadius = 0.7f, kAimRadius = 0.35f, kArrowLength = 1.3f, kArrowHalf = 0.8f;

// Over the picture, under the plates: dark below and bright above, so that it shows on snow and on forest.
void drawMark(ImDrawList& list, const Interface& context, const HudMark& mark) {
  const float line = context.text().pixels, thick = std::max(1.0f, line * 0.12f);
  const ImU32 dark = color(0, 0, 0, 0.75);
  const ImU32 bright = mark.isInTarget ? color(120, 255, 140, 1) : toneColor(HudText::Tone::accent, 1);
  const ImVec2 at = vec(mark.place);
  if (mark.kind == HudMark::Kind::toTarget) {
    const float side = mark.place.x <= 0 ? 1.0f : -1.0f, edge = at.x + side * line * 0.5f;
    const auto arrow = [&](float grow, ImU32 colour) {
      const ImVec2 tip(edge - side * grow, at.y),
          up(edge + side * (kArrowLength * line + grow), at.y - kArrowHalf * line - 1.5f * grow),
          down(up.x, at.y + kArrowHalf * line + 1.5f * grow);
      // Clockwise.
      if (side > 0)
        list.AddTriangleFilled(tip, up, down, colour);
      else
        list.AddTriangleFilled(tip, down, up, colour);
    };
    arrow(1.5f * thick, dark);
    arrow(0, color(60, 130, 255, 1));
    return;
  }
  const float radius = line * (mark.kind == HudMark::Kind::landing ? kMarkRadius : kAimRadius);
  list.AddCircle(at, radius, dark, 32, thick * 2.5f);
  list.AddCircle(at, radius, bright, 32, thick);
  if (mark.kind == HudMark::Kind::aim) return;
  for (const auto& [x, y] : {std::pair{1.0f, 0.0f}, {-1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, -1.0f}}) {
    const ImVec2 from(at.x + x * radius * 0.55f, at.y + y * radius * 0.55f),
        to(at.x + x * radius * 1.5f, at.y + y * radius * 1.5f);
    list.AddLine(from, to, dark, thick * 2.5f);
    list.AddLine(from, to, bright, thick);
  }
  if (!mark.text.empty())
    drawText(list, context, {mark.text, {at.x + radius * 1.8f, at.y - line / 2}, HudText::Tone::normal});
}

}  // namespace

void drawHud(const Interface& context, const HudData& data, const HudLayout& layout) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float rounding = context.text().pixels * 0.2f;
  if (!data.panel)
    for (const HudMark& mark : data.marks) drawMark(list, context, mark);
  if (const ScreenRect& p = layout.picture; p.right > p.left)
    list.AddRect({p.left - 1, p.top - 1}, {p.right + 1, p.bottom + 1}, color(8, 12, 16, 0.8), 0, 0, 2);
  for (const HudItem& item : layout.items) {
    // A plate fades with the text on it.
    double opacity = item.texts.empty() ? 0 : 1;
    if (item.name == "messages" || item.name == "warning") {
      opacity = 0;
      for (const HudText& text : item.texts) opacity = std::max(opacity, text.opacity);
    }
    if (item.plateOpacity > 0) {
      list.AddRectFilled({item.rect.left, item.rect.top}, {item.rect.right, item.rect.bottom},
                         color(8, 12, 16, item.plateOpacity * opacity), rounding);
    }
    for (const HudText& text : item.texts) drawText(list, context, text);
  }
  drawThrottle(list, layout.throttleBar, data.throttle);
  if (layout.instruments && data.instruments)
    drawInstruments(context, *data.instruments, *layout.instruments);
  if (layout.circleRadius > 0) {
    drawNavigationBar(list, context, data.navigation, layout.circleCentre, layout.circleRadius);
  }
}

}  // namespace skydrop::ui
