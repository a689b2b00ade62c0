// What a vertex belongs to (ground_cover/instance.glsl), by its number.
#include "ground_cover/instance.glsl"

layout(location = 1) in uint coverNumber;
layout(std430, binding = 1) readonly buffer Instances { CoverInstance instances[]; };

#define coverFoot instances[coverNumber].foot
#define coverForm instances[coverNumber].form
#define coverNormal instances[coverNumber].normal
#define coverSun instances[coverNumber].sun
#define coverAbove instances[coverNumber].above
#define coverBelow instances[coverNumber].below
#define coverAir instances[coverNumber].air
#define coverAlbedo instances[coverNumber].albedo
#define coverBend instances[coverNumber].bend

// Radiance of a white matt surface of a unit normal.
vec3 coverIrradiance(vec3 normal) {
  return coverSun.xyz * max(dot(normal, frame.toSun.xyz), 0.0) + mix(coverBelow.xyz, coverAbove.xyz, 0.5 + 0.5 * normal.y);
}
