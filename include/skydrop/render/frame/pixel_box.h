#pragma once

#include <algorithm>

namespace skydrop::render {

// Pixels from the lower left corner, [low, high).
struct PixelBox {
  int lowX = 0, lowY = 0, highX = 0, highY = 0;

  int width() const { return highX - lowX; }
  int height() const { return highY - lowY; }
  bool empty() const { return width() <= 0 || height() <= 0; }
};

// The smallest box that holds both; an empty one holds nothing.
inline PixelBox unite(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.lowX, b.lowX), std::min(a.lowY, b.lowY), std::max(a.highX, b.highX),
          std::max(a.highY, b.highY)};
}

}  // namespace skydrop::render
