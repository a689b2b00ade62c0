// What the land's material takes from one chunk along a line, a place a pixel: in row 0 the normal and the
// curvature, in row 1 the texel's size and the slope.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/land_material.glsl"
#include "terrain/surface.glsl"
#include "terrain/noise.glsl"
#include "terrain/land.glsl"

uniform ivec2 chunk;  // of level 0
uniform vec2 start;   // of the line: metres from the chunk's corner
uniform vec2 stride;  // from a place to the next
uniform int level;

out vec4 color;

void main() {
  LandTexel texel = texelInChunk(chunk, start + stride * floor(gl_FragCoord.x), level);
  vec3 normal = normalAt(texel, vec2(0.0));
  color = gl_FragCoord.y < 1.0 ? vec4(normal, landForm(texel).curvature) : vec4(texel.metres, normal.y, 0.0, 0.0);
}
