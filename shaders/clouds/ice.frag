#include "clouds/ice.glsl"

in vec2 ndc;
out vec4 color;

void main() {
  vec3 ray = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
  color = iceOverScene(iceLight(normalize(ray), frame.depthToSea.w), ray);
}
