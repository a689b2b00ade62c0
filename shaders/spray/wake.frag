// Drawn over the sea with dual-source blending: added + what is there * left.
#include "spray/wake_look.glsl"

layout(location = 0, index = 0) out vec4 added;
layout(location = 0, index = 1) out vec4 left;

void main() {
  WakeLight light = wakeSeen(gl_FragCoord.xyz);
  added = vec4(light.added, 0.0);
  left = vec4(light.left, 1.0);
}
