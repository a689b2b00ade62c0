// Move-only owners of GL textures and samplers. On the context's thread; they must go before their context.
// Sizes in texels, up to what images and targets of OpenGL 4.5 can hold (16384). Wrong sizes and formats are
// programming errors and asserted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "skydrop/render/gl/object.h"

namespace skydrop::render::gl {

// Bytes of one texel of a sized internal format; asserts on a format that the game does not use.
std::uint64_t texelBytes(GLenum internalFormat);
// 1 + log2 of the longest side.
GLsizei mipLevels(GLsizei width, GLsizei height);

// A texture with immutable storage, counted by the context's resource tracker with all its levels: 2D, an
// array of 2D layers, or 3D. New textures clamp to the edge and filter linearly (nearest where the format
// cannot be filtered: depth and integers), without mip levels unless asked for.
class Texture : public Object {
 public:
  Texture() = default;  // no object: may be assigned to and destroyed, nothing else
  // internalFormat is a sized one (GL_RGBA16F); `label` names it in the driver's debug messages. Texels are
  // undefined until written.
  static Texture make2D(Context& context, GLenum internalFormat, GLsizei width, GLsizei height,
                        std::string_view label, GLsizei levels = 1);
  // Several samples a texel, at fixed places: to be drawn into, and read by texelFetch.
  static Texture make2DMultisample(Context& context, GLenum internalFormat, GLsizei width, GLsizei height,
                                   GLsizei samples, std::string_view label);
  static Texture make2DArray(Context& context, GLenum internalFormat, GLsizei width, GLsizei height,
                             GLsizei layers, std::string_view label, GLsizei levels = 1);
  static Texture make3D(Context& context, GLenum internalFormat, GLsizei width, GLsizei height, GLsizei depth,
                        std::string_view label, GLsizei levels = 1);

  GLenum target() const { return target_; }
  GLenum format() const { return format_; }
  GLsizei width() const { return width_; }
  GLsizei height() const { return height_; }
  GLsizei depth() const { return depth_; }  // layers of an array, 1 of a 2D texture
  GLsizei levels() const { return levels_; }

  // Replaces a whole level of a 2D or 3D texture, or one layer of an array. The first row is the one at v = 0
  // (the bottom of an image that was drawn). `texels` must hold exactly what format and type ask for.
  void upload(GLenum format, GLenum type, std::span<const std::byte> texels, GLint level = 0);
  void uploadLayer(GLint layer, GLenum format, GLenum type, std::span<const std::byte> texels,
                   GLint level = 0);
  // Replaces so many slices of the first level of a 3D texture.
  void uploadSlices(GLint first, GLsizei count, GLenum format, GLenum type,
                    std::span<const std::byte> texels);
  void generateMipmaps();  // of all levels below the first
  // Reads a whole level back, tightly packed, first row at v = 0. Waits for the GPU: for tests and pictures.
  void read(GLenum format, GLenum type, std::span<std::byte> texels, GLint level = 0) const;

  void setFilter(GLenum minify, GLenum magnify);  // GL_LINEAR, GL_NEAREST, GL_LINEAR_MIPMAP_LINEAR ...
  void setWrap(GLenum wrap);                      // in all directions: GL_CLAMP_TO_EDGE, GL_REPEAT ...

  void bind(GLuint unit) const;  // to be sampled by `layout(binding = unit)`
  void bindImage(GLuint unit, GLenum access, GLint level = 0) const;  // all layers

 private:
  Texture(Context& context, GLenum target, GLenum internalFormat, GLsizei width, GLsizei height,
          GLsizei depth, GLsizei levels, std::string_view label, GLsizei samples = 1);

  std::uint64_t texelCount(GLint level) const;  // of all layers

  GLenum target_ = 0, format_ = 0;
  GLsizei width_ = 0, height_ = 0, depth_ = 0, levels_ = 0;
};

// Filtering and wrapping apart from a texture.
class Sampler : public Object {
 public:
  Sampler() = default;
  Sampler(Context& context, GLenum minify, GLenum magnify, GLenum wrap, std::string_view label);
  void bind(GLuint unit) const;
  static void unbind(Context& context, GLuint unit);
};

}  // namespace skydrop::render::gl
