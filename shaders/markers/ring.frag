#include "frame.glsl"
#include "models/scene_depth.glsl"
#include "markers/marker.glsl"
#include "markers/ground.glsl"

uniform vec3 middle;
uniform vec3 extent;
uniform float radiusM;
uniform float widthM;

out vec4 color;

void main() {
  vec3 place = placeBehindPixel();
  vec3 fromMiddle = place - middle;
  if (abs(fromMiddle.y) > extent.y) discard;
  float distanceM = length(fromMiddle.xz);
  // How far apart neighbouring pixels lie on the ground, across the ring's edge.
  float pixelM = length(place) * frame.depthToSea.w * length(place) / max(abs(place.y), 1.0);
  color = markerGlow(ringShare(distanceM, radiusM, widthM, min(pixelM, 40.0)), place);
}
