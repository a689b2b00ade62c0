#pragma once

#include <string_view>

#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/models/mesh_data.h"

namespace skydrop::render {

// Triangles on the GPU, a copy of a MeshData: 32 bytes a vertex and 4 an index, never changed. Attribute
// locations: 0 position (vec3, m, model space), 1 normal (vec3, unit), 2 uv (vec2). On the context's thread;
// a mesh owns its buffers and must go before its context.
class Mesh {
 public:
  Mesh() = default;  // empty: false, indexCount() 0; must not be drawn
  // `data`: at least one vertex and one index (asserted), three indices a triangle, each below the number of
  // vertices (not checked here). It is not needed afterwards. `label` names the GL objects in the driver's
  // debug messages.
  Mesh(gl::Context& context, const MeshData& data, std::string_view label);

  explicit operator bool() const { return static_cast<bool>(vertexArray_); }
  GLsizei indexCount() const { return indexCount_; }
  const gl::VertexArray& vertexArray() const { return vertexArray_; }

  // One draw call of all triangles, with the program, target and state that are set. Leaves the vertex array
  // bound.
  void draw() const;

 private:
  gl::Buffer vertices_, indices_;
  gl::VertexArray vertexArray_;
  GLsizei indexCount_ = 0;
};

}  // namespace skydrop::render
