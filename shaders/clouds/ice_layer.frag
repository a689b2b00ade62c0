#include "clouds/ice.glsl"

uniform float pixelsAlong;  // pixels of the picture that share a ray, along a side

in vec2 ndc;
out vec4 color;

void main() {
  color = iceLight(normalize((frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz), pixelsAlong * frame.depthToSea.w);
}
