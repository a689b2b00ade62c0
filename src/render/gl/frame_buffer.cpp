#include "skydrop/render/gl/frame_buffer.h"

#include <algorithm>
#include <cassert>

#include "render/gl/created.h"
#include "render/gl/owned_functions.h"
#include "skydrop/core/error.h"

namespace skydrop::render::gl {
namespace {

GLuint createFrameBuffer(Context& context) {
  GLuint id = 0;
  context.owned().CreateFramebuffers(1, &id);
  return created(id, "frame buffer");
}

}  // namespace

FrameBuffer::FrameBuffer(Context& context, GLsizei width, GLsizei height, FrameBufferFormat format,
                         std::string_view label)
    : Object(context, ObjectKind::frameBuffer, createFrameBuffer(context)), format_(format), label_(label) {
  setLabel(label);
  resize(width, height);
}

FrameBuffer::FrameBuffer(Context& context, const Texture* color, const Texture* depth, std::string_view label)
    : Object(context, ObjectKind::frameBuffer, createFrameBuffer(context)), format_{0, 0, 1}, label_(label) {
  assert(color || depth);
  setLabel(label);
  width_ = (color ? color : depth)->width();
  height_ = (color ? color : depth)->height();
  attach(color, depth);
}

void FrameBuffer::resize(GLsizei width, GLsizei height) {
  assert(format_.color || format_.depth);
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  const auto make = [&](GLenum format, const char* part) {
    return format_.samples > 1
               ? Texture::make2DMultisample(context(), format, width, height, format_.samples, label_ + part)
               : Texture::make2D(context(), format, width, height, label_ + part);
  };
  if (format_.color) color_ = make(format_.color, ".color");
  if (format_.depth) depth_ = make(format_.depth, ".depth");
  attach(format_.color ? &color_ : nullptr, format_.depth ? &depth_ : nullptr);
}

void FrameBuffer::attach(const Texture* color, const Texture* depth) {
  const Functions& gl = context().api();
  if (color) gl.NamedFramebufferTexture(id(), GL_COLOR_ATTACHMENT0, color->id(), 0);
  if (depth) gl.NamedFramebufferTexture(id(), GL_DEPTH_ATTACHMENT, depth->id(), 0);
  gl.NamedFramebufferDrawBuffer(id(), color ? GL_COLOR_ATTACHMENT0 : GL_NONE);
  gl.NamedFramebufferReadBuffer(id(), color ? GL_COLOR_ATTACHMENT0 : GL_NONE);
  const GLenum status = gl.CheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw core::GraphicsUnavailable("frame buffer " + label_ + " of " + std::to_string(width_) + "x" +
                                    std::to_string(height_) + " is not complete (status " +
                                    std::to_string(status) + ")");
  }
}

void FrameBuffer::bind(Clear clearing) {
  const Functions& gl = context().api();
  GLint before = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  targetBefore_ = static_cast<GLuint>(before);
  gl.GetIntegerv(GL_VIEWPORT, viewportBefore_.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, id());
  gl.Viewport(0, 0, width_, height_);
  if (clearing == Clear::yes) clear();
}

void FrameBuffer::unBind() {
  const Functions& gl = context().api();
  gl.BindFramebuffer(GL_FRAMEBUFFER, targetBefore_);
  gl.Viewport(viewportBefore_[0], viewportBefore_[1], viewportBefore_[2], viewportBefore_[3]);
}

void FrameBuffer::clear() {
  // Masks and the scissor box apply to clears as well.
  const Functions& gl = context().api();
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_TRUE);
  gl.ClearNamedFramebufferfv(id(), GL_COLOR, 0, clearColor_.data());
  gl.ClearNamedFramebufferfv(id(), GL_DEPTH, 0, &clearDepth_);
}

void FrameBuffer::blit(GLuint target, GLsizei width, GLsizei height) const {
  context().api().Disable(GL_SCISSOR_TEST);  // it applies to copies as well
  const GLenum filter = width == width_ && height == height_ ? GL_NEAREST : GL_LINEAR;
  context().api().BlitNamedFramebuffer(id(), target, 0, 0, width_, height_, 0, 0, width, height,
                                       GL_COLOR_BUFFER_BIT, filter);
}

// Drivers look for a new size of the window when its frame buffer is bound and the viewport is set. A copy by
// name alone never makes Mesa's software renderer look under X11: it would go on drawing into the first size.
void FrameBuffer::drawToScreen(GLsizei screenWidth, GLsizei screenHeight) const {
  const Functions& gl = context().api();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, screenWidth, screenHeight);
  blit(0, screenWidth, screenHeight);
}

void FrameBuffer::copyTo(const FrameBuffer& target, GLint left, GLint bottom) const {
  const GLint width = std::min(width_, target.width() - left),
              height = std::min(height_, target.height() - bottom);
  if (left < 0 || bottom < 0 || width <= 0 || height <= 0) return;
  context().api().Disable(GL_SCISSOR_TEST);
  context().api().BlitNamedFramebuffer(id(), target.id(), 0, 0, width, height, left, bottom, left + width,
                                       bottom + height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void FrameBuffer::drawTo(const FrameBuffer& target) const {
  blit(target.id(), target.width(), target.height());
}

}  // namespace skydrop::render::gl
