// The land wears an aerial image: included with GROUND_PICTURE alone.
#include "shared/ground_picture.glsl"

layout(binding = 5) uniform sampler2D groundPicture;  // rgb: linear; a: the share that it has at the place
uniform vec4 groundPlace;    // xy: of the base, in shares of the image; zw: shares a metre
uniform vec4 groundWorn;     // share, nearShare, nearM, gain
uniform float groundTexelM;  // metres that a texel of the first level covers

LandSurface worn(LandSurface land, LandSight sight, float distanceM) {
  vec2 at = groundPlace.xy + sight.place * groundPlace.zw;
  vec4 seen = textureLod(groundPicture, at, groundPictureLevel(sight.footprint, groundTexelM));
  vec2 inside = step(vec2(0.0), at) * step(at, vec2(1.0));
  float share = groundPictureShare(seen.a * inside.x * inside.y, distanceM, groundWorn.x, groundWorn.y, groundWorn.z);
  land.albedo = pictured(land.albedo, seen.rgb, share, groundWorn.w);
  return land;
}
