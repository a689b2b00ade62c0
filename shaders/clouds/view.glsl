// Rays of the march.
#include "frame.glsl"

layout(binding = 6) uniform sampler2D sceneDepth;

// Not normalised: its component along the view axis is 1. `at`: in pixels from the lower left corner.
vec3 rayThrough(vec2 at) {
  vec2 ndc = at * frame.viewport.zw * 2.0 - 1.0;
  return (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
}

ivec2 viewSize() { return ivec2(frame.viewport.xy); }

// Depth of the farthest surface in a square of pixels. Reversed depth: the least value.
float farthestDepth(ivec2 corner, int side) {
  float depth = 1.0;
  ivec2 last = viewSize() - 1;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      depth = min(depth, texelFetch(sceneDepth, min(corner + ivec2(x, y), last), 0).x);
    }
  }
  return depth;
}

float depthAt(ivec2 pixel) { return texelFetch(sceneDepth, min(pixel, viewSize() - 1), 0).x; }

float sceneDistance(float depth, vec3 ray) { return distanceOfDepth(depth, frame.eye.y, length(ray)); }
