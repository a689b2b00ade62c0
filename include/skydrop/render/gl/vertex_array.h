#pragma once

#include <cstddef>
#include <string_view>

#include "skydrop/render/gl/buffer.h"

namespace skydrop::render::gl {

// Which buffers feed which attributes of a vertex shader. On the context's thread; it must go before its
// context. It does not own the buffers, which must live whenever it is drawn with. Attributes that are not
// set are off; an array without any is drawn by a shader that computes its vertices from gl_VertexID.
//
// Locations and binding points are below 16, strides at most 2048 bytes (what every OpenGL 4.5 offers).
// Beyond that the driver reports an error (Context::debugErrors) and the call does nothing.
class VertexArray : public Object {
 public:
  VertexArray() = default;  // no object: may be assigned to and destroyed, nothing else
  // `label` names it in the driver's debug messages.
  VertexArray(Context& context, std::string_view label);

  // Binds `buffer`, from byte `offset` on, to a binding point that attributes name, in place of the one
  // before. divisor 0 advances by strideBytes for each vertex, n > 0 for each n instances.
  void setVertexBuffer(GLuint binding, const Buffer& buffer, std::size_t offset, GLsizei strideBytes,
                       GLuint divisor = 0);
  // Of Context::drawElements, which says the type of the indices.
  void setIndexBuffer(const Buffer& buffer);
  // `components` (1 to 4) numbers of `type`, `offset` bytes into the vertex, as floats for the shader.
  // normalised: integers become 0..1 (unsigned) or -1..1, else their value.
  void setAttribute(GLuint location, GLuint binding, GLint components, GLenum type, GLuint offset,
                    bool normalised = false);
  // The same for an attribute that is int, uint or a vector of them in the shader.
  void setIntegerAttribute(GLuint location, GLuint binding, GLint components, GLenum type, GLuint offset);

  // Makes it the one that Context's draws use, until another is bound.
  void bind() const;
};

}  // namespace skydrop::render::gl
