#pragma once

#include <array>
#include <string>
#include <string_view>

#include "skydrop/render/gl/texture.h"

namespace skydrop::render::gl {

struct FrameBufferFormat {
  GLenum color = GL_RGBA16F;             // 0: no colour texture
  GLenum depth = GL_DEPTH_COMPONENT32F;  // 0: no depth texture
  GLsizei samples = 1;                   // a pixel; with more the textures cannot be filtered
};

// A target to draw into whose colour and depth are textures that later passes read. Sizes in pixels, 1 to
// 16384, resizable. On the context's thread; it must go before its context. At least one of colour and depth
// must be there (asserted); what the driver cannot give is reported by its debug messages
// (Context::debugErrors).
class FrameBuffer : public Object {
 public:
  enum class Clear { no, yes };

  FrameBuffer() = default;
  FrameBuffer(Context& context, GLsizei width, GLsizei height, FrameBufferFormat format,
              std::string_view label);
  // A target over textures that another object owns and keeps alive; level 0 of each, either may be null.
  FrameBuffer(Context& context, const Texture* color, const Texture* depth, std::string_view label);

  GLsizei width() const { return width_; }
  GLsizei height() const { return height_; }
  const Texture& colorTexture() const { return color_; }
  const Texture& depthTexture() const { return depth_; }

  // Makes this the target and sets the viewport to all of it; clearing sets colour to `clearColor` and depth
  // to `clearDepth` (0, the far end of reversed depth). unBind() restores the target and viewport found by
  // bind().
  void bind(Clear clear = Clear::yes);
  void unBind();
  void clear();
  void setClearColor(float r, float g, float b, float a) { clearColor_ = {r, g, b, a}; }
  void setClearDepth(float depth) { clearDepth_ = depth; }

  // Reallocates both textures (their content is lost). Nothing happens if the size is the same.
  void resize(GLsizei width, GLsizei height);

  // Copies colour to a target of any size, filtered linearly where the sizes differ: the screen, which is the
  // bound target afterwards, or another buffer.
  void drawToScreen(GLsizei screenWidth, GLsizei screenHeight) const;
  void drawTo(const FrameBuffer& target) const;
  // Copies its colour as it is into the target, its lower left corner there; what does not fit is left out.
  void copyTo(const FrameBuffer& target, GLint left, GLint bottom) const;

 private:
  void attach(const Texture* color, const Texture* depth);
  void blit(GLuint target, GLsizei width, GLsizei height) const;

  FrameBufferFormat format_;
  std::string label_;
  Texture color_, depth_;
  GLsizei width_ = 0, height_ = 0;
  std::array<float, 4> clearColor_{0, 0, 0, 0};
  float clearDepth_ = 0;
  GLuint targetBefore_ = 0;
  std::array<GLint, 4> viewportBefore_{};
};

}  // namespace skydrop::render::gl
