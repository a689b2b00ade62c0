#include "skydrop/render/gl/vertex_array.h"

#include "render/gl/created.h"
#include "render/gl/owned_functions.h"

namespace skydrop::render::gl {
namespace {

GLuint createVertexArray(Context& context) {
  GLuint id = 0;
  context.owned().CreateVertexArrays(1, &id);
  return created(id, "vertex array");
}

}  // namespace

VertexArray::VertexArray(Context& context, std::string_view label)
    : Object(context, ObjectKind::vertexArray, createVertexArray(context)) {
  setLabel(label);
}

void VertexArray::setVertexBuffer(GLuint binding, const Buffer& buffer, std::size_t offset,
                                  GLsizei strideBytes, GLuint divisor) {
  const Functions& gl = context().api();
  gl.VertexArrayVertexBuffer(id(), binding, buffer.id(), static_cast<GLintptr>(offset), strideBytes);
  gl.VertexArrayBindingDivisor(id(), binding, divisor);
}

void VertexArray::setIndexBuffer(const Buffer& buffer) {
  context().api().VertexArrayElementBuffer(id(), buffer.id());
}

void VertexArray::setAttribute(GLuint location, GLuint binding, GLint components, GLenum type, GLuint offset,
                               bool normalised) {
  const Functions& gl = context().api();
  gl.EnableVertexArrayAttrib(id(), location);
  gl.VertexArrayAttribFormat(id(), location, components, type, normalised ? GL_TRUE : GL_FALSE, offset);
  gl.VertexArrayAttribBinding(id(), location, binding);
}

void VertexArray::setIntegerAttribute(GLuint location, GLuint binding, GLint components, GLenum type,
                                      GLuint offset) {
  const Functions& gl = context().api();
  gl.EnableVertexArrayAttrib(id(), location);
  gl.VertexArrayAttribIFormat(id(), location, components, type, offset);
  gl.VertexArrayAttribBinding(id(), location, binding);
}

void VertexArray::bind() const { context().api().BindVertexArray(id()); }

}  // namespace skydrop::render::gl
