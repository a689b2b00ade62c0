// Vertices of a piece of a hedge: a lumpy ridge of leaves that follows the ground.
#include "frame.glsl"
#include "places/attributes.glsl"

layout(location = 0) in vec4 unitCorner;  // x, y up, z: across in [-1, 1], height in [0, 1], along in [-1, 1]; dent
layout(location = 1) in vec4 unitNormal;  // and how open to the sky

struct HedgeVertex {
  vec3 relative;
  vec3 normal;
  vec3 unit;
};

HedgeVertex hedgeVertex() {
  float own = fract(placeSun.w * 0.6180339);
  float lump = 1.0 + 0.22 * sin(6.2831853 * (own + unitCorner.z * 2.3 + unitCorner.x * 0.2)) + unitCorner.w;
  vec3 local = vec3(unitCorner.x * 0.5 * placeForm.x * lump, unitCorner.y * placeForm.z * lump - (unitCorner.y <= 0.0 ? placeFoot.w : 0.0),
                    unitCorner.z * 0.5 * placeForm.y);
  // A tree's crown is round, over a stem.
  float crown = mix(0.16, 1.0, smoothstep(0.24, 0.46, unitCorner.y) * (1.0 - 0.35 * smoothstep(0.75, 1.0, unitCorner.y)));
  local.xz *= placeTurn.w > 0.5 ? crown : 1.0;
  vec3 at = ofPlace(local);
  at.y += 0.5 * unitCorner.z * placeForm.w;
  HedgeVertex made;
  made.relative = placeFoot.xyz + at;
  made.normal = ofPlace(unitNormal.xyz);
  made.unit = vec3(local.x, local.y, local.z);
  return made;
}
