// Drawn over the land with dual-source blending: color + what is there * passed.
#include "terrain/sea.glsl"

layout(location = 0, index = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 passed;

void main() {
  SeaLight light = seaAsSeen(seaSightOf(gl_FragCoord.xyz));
  color = vec4(light.own, 1.0);
  passed = vec4(light.passed, 0.0);
}
