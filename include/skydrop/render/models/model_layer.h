// Models with smooth edges: they are drawn into a layer of their own with four samples a pixel, as large as
// the part of the picture that they cover, and laid over the scene by coverage and depth. Land and sky need
// no such thing and do not pay for it.
#pragma once

#include <optional>

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/gl/shader_cache.h"

namespace skydrop::render {

// Pixels from the lower left corner, [low, high).
struct PixelBox {
  int lowX = 0, lowY = 0, highX = 0, highY = 0;

  int width() const { return highX - lowX; }
  int height() const { return highY - lowY; }
  bool empty() const { return width() <= 0 || height() <= 0; }
};
PixelBox unite(const PixelBox& a, const PixelBox& b);

class ModelLayer {
 public:
  // Makes the layer the target for what lies within `box`; positions and viewport are those of the whole
  // picture, so shaders must not ask for gl_FragCoord. False if the box is larger than the layer may grow
  // (kMostPixels): the models are then to be drawn into the scene itself.
  bool begin(gl::Context& context, const PixelBox& box, int pictureWidth, int pictureHeight);
  // Lays it over the scene, whose buffer with colour and depth is bound.
  void compose(gl::Context& context, gl::ShaderCache& shaders);

  static constexpr int kMostPixels = 1 << 20;  // 48 MiB

 private:
  gl::FrameBuffer target_;
  std::optional<FullscreenTriangle> triangle_;
  PixelBox box_;
};

}  // namespace skydrop::render
