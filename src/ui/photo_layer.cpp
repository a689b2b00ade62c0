#include "skydrop/ui/photo_layer.h"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "ui/texture_id.h"

namespace skydrop::ui {
namespace {

// Corners of a cell, clockwise from the upper left.
struct Cell {
  PhotoVertex corners[4];
};

// Cut to the photograph: the mesh is so fine that a cell is linear along its sides.
bool cutTo(Cell& cell, bool goesRound) {
  PhotoVertex& a = cell.corners[0];
  PhotoVertex& c = cell.corners[2];
  const auto cut = [](float PhotoVertex::*place, float PhotoVertex::*of, PhotoVertex& low,
                      PhotoVertex& high) {
    const float from = low.*of, to = high.*of;
    if (!(to != from)) return from >= 0 && from <= 1;
    const float t0 = std::clamp((from < to ? 0 - from : 1 - from) / (to - from), 0.0F, 1.0F);
    const float t1 = std::clamp((from < to ? 1 - from : 0 - from) / (to - from), 0.0F, 1.0F);
    if (!(t0 < t1)) return false;
    const float begin = low.*place, length = high.*place - begin;
    low.*place = begin + t0 * length;
    high.*place = begin + t1 * length;
    low.*of = from + t0 * (to - from);
    high.*of = from + t1 * (to - from);
    return true;
  };
  if (goesRound) {
    // Its top and bottom are curves: cells beyond them are left out whole.
    return std::all_of(std::begin(cell.corners), std::end(cell.corners),
                       [](const PhotoVertex& v) { return v.v >= 0 && v.v <= 1; });
  }
  if (!cut(&PhotoVertex::x, &PhotoVertex::u, a, c) || !cut(&PhotoVertex::y, &PhotoVertex::v, a, c))
    return false;
  cell.corners[1] = {c.x, a.y, c.u, a.v};
  cell.corners[3] = {a.x, c.y, a.u, c.v};
  return true;
}

}  // namespace

void drawPhotoLayer(const PhotoLayer& photo, float width, float height) {
  assert(photo.columns >= 2 && photo.rows >= 2 &&
         photo.vertices.size() ==
             static_cast<std::size_t>(photo.columns) * static_cast<std::size_t>(photo.rows));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 from(photo.left * width, photo.top * height), to(photo.right * width, photo.bottom * height);
  if (photo.hasGround) list.AddRectFilled(from, to, IM_COL32_BLACK);
  list.PushClipRect(from, to);
  const ImU32 tint = IM_COL32(255, 255, 255, static_cast<int>(std::lround(255 * photo.opacity)));
  for (int row = 0; row + 1 < photo.rows; ++row) {
    for (int column = 0; column + 1 < photo.columns; ++column) {
      const auto at = [&](int c, int r) {
        return photo.vertices[static_cast<std::size_t>(r) * static_cast<std::size_t>(photo.columns) +
                              static_cast<std::size_t>(c)];
      };
      Cell cell{{at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)}};
      if (photo.goesRound) {
        for (PhotoVertex& corner : cell.corners) corner.u += std::round(cell.corners[0].u - corner.u);
      }
      if (!cutTo(cell, photo.goesRound)) continue;
      const auto place = [&](int i) { return ImVec2(cell.corners[i].x * width, cell.corners[i].y * height); };
      const auto texel = [&](int i) { return ImVec2(cell.corners[i].u, cell.corners[i].v); };
      list.AddImageQuad(textureId(photo.texture), place(0), place(1), place(2), place(3), texel(0), texel(1),
                        texel(2), texel(3), tint);
    }
  }
  list.PopClipRect();
}

}  // namespace skydrop::ui
