#include "skydrop/render/gl/object.h"

#include <cassert>
#include <utility>

#include "render/gl/owned_functions.h"

namespace skydrop::render::gl {

Object::Object(Context& context, ObjectKind kind, GLuint id) : context_(&context), id_(id), kind_(kind) {
  assert(context.isCurrent());
  owner_ = context.resources().created(kind);
}

void Object::setBytes(std::uint64_t bytes) {
  bytes_ = bytes;
  context_->resources().allocated(bytes, owner_);
}

void Object::setLabel(std::string_view label) {
  GLenum type = GL_BUFFER;
  switch (kind_) {
    case ObjectKind::buffer:
      type = GL_BUFFER;
      break;
    case ObjectKind::texture:
      type = GL_TEXTURE;
      break;
    case ObjectKind::vertexArray:
      type = GL_VERTEX_ARRAY;
      break;
    case ObjectKind::program:
      type = GL_PROGRAM;
      break;
    case ObjectKind::frameBuffer:
      type = GL_FRAMEBUFFER;
      break;
    case ObjectKind::sampler:
      type = GL_SAMPLER;
      break;
    case ObjectKind::query:
      type = GL_QUERY;
      break;
  }
  context_->api().ObjectLabel(type, id_, static_cast<GLsizei>(label.size()), label.data());
}

void Object::swap(Object& other) noexcept {
  std::swap(context_, other.context_);
  std::swap(id_, other.id_);
  std::swap(kind_, other.kind_);
  std::swap(owner_, other.owner_);
  std::swap(bytes_, other.bytes_);
}

void Object::destroy() noexcept {
  if (!id_) return;
  const Context::Scope scope(*context_);
  const OwnedFunctions& gl = context_->owned();
  switch (kind_) {
    case ObjectKind::buffer:
      gl.DeleteBuffers(1, &id_);
      break;
    case ObjectKind::texture:
      gl.DeleteTextures(1, &id_);
      break;
    case ObjectKind::vertexArray:
      gl.DeleteVertexArrays(1, &id_);
      break;
    case ObjectKind::program:
      gl.DeleteProgram(id_);
      break;
    case ObjectKind::frameBuffer:
      gl.DeleteFramebuffers(1, &id_);
      break;
    case ObjectKind::sampler:
      gl.DeleteSamplers(1, &id_);
      break;
    case ObjectKind::query:
      gl.DeleteQueries(1, &id_);
      break;
  }
  context_->resources().deleted(kind_, bytes_, owner_);
}

}  // namespace skydrop::render::gl
