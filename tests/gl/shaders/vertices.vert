// Each vertex of each patch as a pixel: column = vertex, row = patch.
#include "frame.glsl"
#include "shared/terrain_lod.glsl"
#include "terrain/patch.glsl"

uniform vec2 targetSize;
flat out vec3 relative;

void main() {
  relative = patchVertex(gl_VertexID);
  vec2 pixel = vec2(gl_VertexID, gl_InstanceID) + 0.5;
  gl_Position = vec4(pixel / targetSize * 2.0 - 1.0, 0.5, 1.0);
}
