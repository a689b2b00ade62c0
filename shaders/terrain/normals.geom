// A stroke along the normal from each vertex, a fixed share of its distance long.
#include "frame.glsl"
#include "terrain/stroke.glsl"

layout(points) in;
layout(line_strip, max_vertices = 2) out;

in VertexOut {
  vec3 relative;
  vec3 normal;
} vertexIn[];

void main() {
  gl_Position = frame.viewProjection * vec4(vertexIn[0].relative, 1.0);
  EmitVertex();
  gl_Position = frame.viewProjection * vec4(strokeEnd(vertexIn[0].relative, vertexIn[0].normal), 1.0);
  EmitVertex();
  EndPrimitive();
}
