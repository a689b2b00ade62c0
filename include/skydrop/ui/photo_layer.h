// A photograph over the picture and under everything else of the interface.
#pragma once

#include <cstdint>
#include <span>

namespace skydrop::ui {

struct PhotoVertex {
  float x = 0, y = 0;  // of the picture, shares of its width and height from the upper left corner
  float u = 0, v = 0;  // of the photograph, likewise; what lies outside of [0, 1] it does not show, but for u
                       // of one that goes round
};

// Row after row of a mesh over the picture.
struct PhotoLayer {
  std::uint32_t texture = 0;  // an OpenGL texture, first row on top
  int columns = 0, rows = 0;  // of vertices, at least 2
  std::span<const PhotoVertex> vertices;
  float opacity = 1;          // [0, 1]
  float left = 0, right = 1;  // of the picture: where it is shown
  float top = 0, bottom = 1;
  bool goesRound = false;
  bool hasGround = false;  // black behind it
};

// Into the background of the frame that Dear ImGui builds now, of that size in pixels.
void drawPhotoLayer(const PhotoLayer& photo, float width, float height);

}  // namespace skydrop::ui
