// An instance as vertex attributes (ground_cover/instance.glsl).
layout(location = 1) in vec4 coverFoot;
layout(location = 2) in vec4 coverForm;
layout(location = 3) in vec4 coverNormal;
layout(location = 4) in vec4 coverSun;
layout(location = 5) in vec4 coverAbove;
layout(location = 6) in vec4 coverBelow;
layout(location = 7) in vec4 coverAir;
layout(location = 8) in vec4 coverAlbedo;
layout(location = 9) in vec4 coverBend;

// Radiance of a white matt surface of a unit normal.
vec3 coverIrradiance(vec3 normal) {
  return coverSun.xyz * max(dot(normal, frame.toSun.xyz), 0.0) + mix(coverBelow.xyz, coverAbove.xyz, 0.5 + 0.5 * normal.y);
}
