#pragma once

#include <cstddef>
#include <string_view>

#include "skydrop/render/gl/buffer.h"

namespace skydrop::render::gl {

// Which buffers feed which attributes. Does not own the buffers.
class VertexArray : public Object {
 public:
  VertexArray() = default;
  VertexArray(Context& context, std::string_view label);

  // Binds `buffer` to a binding point; divisor 0 advances for each vertex, 1 for each instance.
  void setVertexBuffer(GLuint binding, const Buffer& buffer, std::size_t offset, GLsizei strideBytes,
                       GLuint divisor = 0);
  void setIndexBuffer(const Buffer& buffer);
  // `components` numbers of `type`, `offset` bytes into the vertex. normalised: integers become 0..1 or
  // -1..1.
  void setAttribute(GLuint location, GLuint binding, GLint components, GLenum type, GLuint offset,
                    bool normalised = false);
  void setIntegerAttribute(GLuint location, GLuint binding, GLint components, GLenum type, GLuint offset);

  void bind() const;
};

}  // namespace skydrop::render::gl
