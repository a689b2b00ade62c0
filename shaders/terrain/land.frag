#include "terrain/land.glsl"

in vec2 ndc;
out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float viewZ = landViewZ(pixel);
  color = vec4(landAsSeen((frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz * viewZ, pixel), 1.0);
}
