#pragma once

namespace skydrop::app {

inline constexpr int kMaxSide = 16384;  // what images (core/image.h) and GL 4.5 targets can hold

struct Size {
  int width = 0, height = 0;  // pixels, 1 .. kMaxSide
};

}  // namespace skydrop::app
