#pragma once

#include <string_view>

#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/models/mesh_data.h"

namespace skydrop::render {

// Triangles on the GPU: VBO, EBO and VAO. Attribute locations: 0 position (vec3), 1 normal (vec3), 2 uv
// (vec2).
class Mesh {
 public:
  Mesh() = default;
  // `data` must not be empty.
  Mesh(gl::Context& context, const MeshData& data, std::string_view label);

  explicit operator bool() const { return static_cast<bool>(vertexArray_); }
  GLsizei indexCount() const { return indexCount_; }
  const gl::VertexArray& vertexArray() const { return vertexArray_; }

  void draw() const;

 private:
  gl::Buffer vertices_, indices_;
  gl::VertexArray vertexArray_;
  GLsizei indexCount_ = 0;
};

}  // namespace skydrop::render
