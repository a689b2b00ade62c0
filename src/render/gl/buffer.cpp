#include "skydrop/render/gl/buffer.h"

#include <algorithm>
#include <cassert>

#include "render/gl/created.h"
#include "render/gl/owned_functions.h"

namespace skydrop::render::gl {
namespace {

GLuint createBuffer(Context& context) {
  GLuint id = 0;
  context.owned().CreateBuffers(1, &id);
  return created(id, "buffer");
}

}  // namespace

Buffer::Buffer(Context& context, std::size_t size, Use use, std::string_view label)
    : Object(context, ObjectKind::buffer, createBuffer(context)) {
  // OpenGL has no buffer of zero bytes.
  const std::size_t stored = std::max<std::size_t>(size, 4);
  context.api().NamedBufferStorage(id(), static_cast<GLsizeiptr>(stored), nullptr,
                                   use == Use::write ? GL_DYNAMIC_STORAGE_BIT : 0);
  setBytes(stored);
  setLabel(label);
}

Buffer::Buffer(Context& context, std::span<const std::byte> content, Use use, std::string_view label)
    : Object(context, ObjectKind::buffer, createBuffer(context)) {
  assert(!content.empty());
  context.api().NamedBufferStorage(id(), static_cast<GLsizeiptr>(content.size()), content.data(),
                                   use == Use::write ? GL_DYNAMIC_STORAGE_BIT : 0);
  setBytes(content.size());
  setLabel(label);
}

void Buffer::write(std::size_t offset, std::span<const std::byte> content) {
  assert(offset + content.size() <= size());
  if (content.empty()) return;
  context().api().NamedBufferSubData(id(), static_cast<GLintptr>(offset),
                                     static_cast<GLsizeiptr>(content.size()), content.data());
}

void Buffer::read(std::size_t offset, std::span<std::byte> content) const {
  assert(offset + content.size() <= size());
  context().api().GetNamedBufferSubData(id(), static_cast<GLintptr>(offset),
                                        static_cast<GLsizeiptr>(content.size()), content.data());
}

void Buffer::bind(GLenum target) const { context().api().BindBuffer(target, id()); }

void Buffer::bindBase(GLenum target, GLuint index) const {
  context().api().BindBufferBase(target, index, id());
}

}  // namespace skydrop::render::gl
