#include "terrain/land.glsl"
#ifdef WATER_DETAIL
#include "terrain/below_water.glsl"
#endif

in vec2 ndc;
out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float viewZ = landViewZ(pixel);
  vec3 relative = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz * viewZ;
#ifdef WATER_DETAIL
  color = vec4(groundAsSeen(relative, pixel), 1.0);
#else
  color = vec4(landAsSeen(relative, pixel), 1.0);
#endif
}
