#include "precipitation/splashes.glsl"
#include "precipitation/drops_seen.glsl"

in vec2 aside;
in vec3 stage;
out vec4 color;

void main() {
  color = vec4(splashLight.xyz, 1.0) * (splashOpacity(aside, stage) * shareSeen(frame.eye.y * gl_FragCoord.w));
}
