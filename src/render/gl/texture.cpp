#include "skydrop/render/gl/texture.h"

#include <algorithm>
#include <cassert>

#include "render/gl/created.h"
#include "render/gl/owned_functions.h"

namespace skydrop::render::gl {
namespace {

GLuint createTexture(Context& context, GLenum target) {
  GLuint id = 0;
  context.owned().CreateTextures(target, 1, &id);
  return created(id, "texture");
}

GLuint createSampler(Context& context) {
  GLuint id = 0;
  context.owned().CreateSamplers(1, &id);
  return created(id, "sampler");
}

bool isFilterable(GLenum format) {
  switch (format) {
    case GL_DEPTH_COMPONENT32F:
    case GL_DEPTH_COMPONENT24:
    case GL_R8UI:
    case GL_R16UI:
    case GL_R32UI:
    case GL_RG16UI:
    case GL_RG32UI:
    case GL_RGBA8UI:
    case GL_RGBA16UI:
    case GL_RGBA32UI:
    case GL_R32I:
      return false;
    default:
      return true;
  }
}

}  // namespace

std::uint64_t texelBytes(GLenum internalFormat) {
  switch (internalFormat) {
    case GL_R8:
    case GL_R8UI:
      return 1;
    case GL_R16:
    case GL_R16F:
    case GL_R16UI:
    case GL_RG8:
      return 2;
    case GL_R32F:
    case GL_R32UI:
    case GL_R32I:
    case GL_RG16:
    case GL_RG16F:
    case GL_RG16UI:
    case GL_RGBA8:
    case GL_RGBA8UI:
    case GL_SRGB8_ALPHA8:
    case GL_RGB10_A2:
    case GL_R11F_G11F_B10F:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32F:
      return 4;
    case GL_RG32F:
    case GL_RG32UI:
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_RGBA16UI:
      return 8;
    case GL_RGBA32F:
    case GL_RGBA32UI:
      return 16;
    default:
      assert(false && "a format without a size here");
      return 0;
  }
}

namespace {

// Bytes of one texel as the CPU hands it over; 0 for a combination that the game does not use.
[[maybe_unused]] std::size_t transferBytes(GLenum format, GLenum type) {  // asserted on only
  std::size_t components = 0;
  switch (format) {
    case GL_RED:
    case GL_RED_INTEGER:
    case GL_DEPTH_COMPONENT:
      components = 1;
      break;
    case GL_RG:
    case GL_RG_INTEGER:
      components = 2;
      break;
    case GL_RGB:
      components = 3;
      break;
    case GL_RGBA:
    case GL_RGBA_INTEGER:
      components = 4;
      break;
    default:
      return 0;
  }
  switch (type) {
    case GL_UNSIGNED_BYTE:
      return components;
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT:
      return components * 2;
    case GL_FLOAT:
    case GL_UNSIGNED_INT:
      return components * 4;
    default:
      return 0;
  }
}

}  // namespace

GLsizei mipLevels(GLsizei width, GLsizei height) {
  GLsizei levels = 1;
  for (GLsizei side = std::max(width, height); side > 1; side /= 2) ++levels;
  return levels;
}

Texture::Texture(Context& context, GLenum target, GLenum internalFormat, GLsizei width, GLsizei height,
                 GLsizei depth, GLsizei levels, std::string_view label, GLsizei samples)
    : Object(context, ObjectKind::texture, createTexture(context, target)),
      target_(target),
      format_(internalFormat),
      width_(width),
      height_(height),
      depth_(depth),
      levels_(levels) {
  assert(width > 0 && height > 0 && depth > 0 && levels > 0);
  const Functions& gl = context.api();
  if (target == GL_TEXTURE_2D_MULTISAMPLE) {
    gl.TextureStorage2DMultisample(id(), samples, internalFormat, width, height, GL_TRUE);
  } else if (target == GL_TEXTURE_2D) {
    gl.TextureStorage2D(id(), levels, internalFormat, width, height);
  } else {
    gl.TextureStorage3D(id(), levels, internalFormat, width, height, depth);
  }
  std::uint64_t texels = 0;
  for (GLint level = 0; level < levels; ++level) texels += texelCount(level);
  setBytes(texels * texelBytes(internalFormat) * static_cast<std::uint64_t>(samples));
  setLabel(label);
  if (target == GL_TEXTURE_2D_MULTISAMPLE) return;  // it is not filtered
  const GLenum magnify = isFilterable(internalFormat) ? GL_LINEAR : GL_NEAREST;
  setFilter(levels > 1 && magnify == GL_LINEAR ? GL_LINEAR_MIPMAP_LINEAR : magnify, magnify);
  setWrap(GL_CLAMP_TO_EDGE);
}

std::uint64_t Texture::texelCount(GLint level) const {
  const auto side = [level](GLsizei full) { return static_cast<std::uint64_t>(std::max(full >> level, 1)); };
  return side(width_) * side(height_) *
         (target_ == GL_TEXTURE_3D ? side(depth_) : static_cast<std::uint64_t>(depth_));
}

Texture Texture::make2D(Context& context, GLenum internalFormat, GLsizei width, GLsizei height,
                        std::string_view label, GLsizei levels) {
  return Texture(context, GL_TEXTURE_2D, internalFormat, width, height, 1, levels, label);
}

Texture Texture::make2DMultisample(Context& context, GLenum internalFormat, GLsizei width, GLsizei height,
                                   GLsizei samples, std::string_view label) {
  return Texture(context, GL_TEXTURE_2D_MULTISAMPLE, internalFormat, width, height, 1, 1, label, samples);
}

Texture Texture::make2DArray(Context& context, GLenum internalFormat, GLsizei width, GLsizei height,
                             GLsizei layers, std::string_view label, GLsizei levels) {
  return Texture(context, GL_TEXTURE_2D_ARRAY, internalFormat, width, height, layers, levels, label);
}

Texture Texture::make3D(Context& context, GLenum internalFormat, GLsizei width, GLsizei height, GLsizei depth,
                        std::string_view label, GLsizei levels) {
  return Texture(context, GL_TEXTURE_3D, internalFormat, width, height, depth, levels, label);
}

void Texture::upload(GLenum format, GLenum type, std::span<const std::byte> texels, GLint level) {
  assert(level < levels_);
  assert(texels.size() == texelCount(level) * transferBytes(format, type));
  const GLsizei width = std::max(width_ >> level, 1), height = std::max(height_ >> level, 1);
  if (target_ == GL_TEXTURE_2D) {
    context().api().TextureSubImage2D(id(), level, 0, 0, width, height, format, type, texels.data());
  } else {
    const GLsizei depth = target_ == GL_TEXTURE_3D ? std::max(depth_ >> level, 1) : depth_;
    context().api().TextureSubImage3D(id(), level, 0, 0, 0, width, height, depth, format, type,
                                      texels.data());
  }
}

void Texture::uploadLayer(GLint layer, GLenum format, GLenum type, std::span<const std::byte> texels,
                          GLint level) {
  assert(target_ == GL_TEXTURE_2D_ARRAY && layer < depth_ && level < levels_);
  assert(texels.size() * static_cast<std::size_t>(depth_) == texelCount(level) * transferBytes(format, type));
  context().api().TextureSubImage3D(id(), level, 0, 0, layer, std::max(width_ >> level, 1),
                                    std::max(height_ >> level, 1), 1, format, type, texels.data());
}

void Texture::uploadSlices(GLint first, GLsizei count, GLenum format, GLenum type,
                           std::span<const std::byte> texels) {
  assert(target_ == GL_TEXTURE_3D && first >= 0 && count > 0 && first + count <= depth_);
  assert(texels.size() == static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                              static_cast<std::size_t>(count) * transferBytes(format, type));
  context().api().TextureSubImage3D(id(), 0, 0, 0, first, width_, height_, count, format, type,
                                    texels.data());
}

void Texture::generateMipmaps() { context().api().GenerateTextureMipmap(id()); }

void Texture::read(GLenum format, GLenum type, std::span<std::byte> texels, GLint level) const {
  context().api().GetTextureImage(id(), level, format, type, static_cast<GLsizei>(texels.size()),
                                  texels.data());
}

void Texture::setFilter(GLenum minify, GLenum magnify) {
  context().api().TextureParameteri(id(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
  context().api().TextureParameteri(id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnify));
}

void Texture::setWrap(GLenum wrap) {
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    context().api().TextureParameteri(id(), axis, static_cast<GLint>(wrap));
  }
}

void Texture::bind(GLuint unit) const { context().api().BindTextureUnit(unit, id()); }

void Texture::bindImage(GLuint unit, GLenum access, GLint level) const {
  context().api().BindImageTexture(unit, id(), level, GL_TRUE, 0, access, format_);
}

Sampler::Sampler(Context& context, GLenum minify, GLenum magnify, GLenum wrap, std::string_view label)
    : Object(context, ObjectKind::sampler, createSampler(context)) {
  const Functions& gl = context.api();
  gl.SamplerParameteri(id(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
  gl.SamplerParameteri(id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnify));
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    gl.SamplerParameteri(id(), axis, static_cast<GLint>(wrap));
  }
  setLabel(label);
}

void Sampler::bind(GLuint unit) const { context().api().BindSampler(unit, id()); }

void Sampler::unbind(Context& context, GLuint unit) { context.api().BindSampler(unit, 0); }

}  // namespace skydrop::render::gl
