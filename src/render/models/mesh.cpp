#include "skydrop/render/models/mesh.h"

#include <cassert>
#include <cstddef>
#include <span>

namespace skydrop::render {

Mesh::Mesh(gl::Context& context, const MeshData& data, std::string_view label)
    : vertices_(
          gl::Buffer::of(context, std::span<const MeshVertex>(data.vertices), gl::Buffer::Use::fixed, label)),
      indices_(gl::Buffer::of(context, std::span<const std::uint32_t>(data.indices), gl::Buffer::Use::fixed,
                              label)),
      vertexArray_(context, label),
      indexCount_(static_cast<GLsizei>(data.indices.size())) {
  vertexArray_.setVertexBuffer(0, vertices_, 0, sizeof(MeshVertex));
  vertexArray_.setIndexBuffer(indices_);
  vertexArray_.setAttribute(0, 0, 3, GL_FLOAT, offsetof(MeshVertex, position));
  vertexArray_.setAttribute(1, 0, 3, GL_FLOAT, offsetof(MeshVertex, normal));
  vertexArray_.setAttribute(2, 0, 2, GL_FLOAT, offsetof(MeshVertex, uv));
}

void Mesh::draw() const {
  vertexArray_.bind();
  vertexArray_.context().drawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT);
}

}  // namespace skydrop::render
