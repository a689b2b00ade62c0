// The moon's disc: seas and highlands under the sun, and a little of the earth's light.
#include "frame.glsl"

uniform vec4 moonPlace;  // direction; angular radius, rad
uniform vec3 moonNorth;  // unit, across the disc
uniform vec3 moonToSun;  // unit
uniform vec2 moonLight;  // radiance of what the sun lights as steeply as it is seen; of what the earth lights

// The seas, as circles on the near side: direction of the middle (x east, y north, z towards the earth) and radius, rad.
// By their selenographic places: Imbrium, Serenitatis, Tranquillitatis, Crisium, Fecunditatis, Nectaris, Procellarum
// (three), Humorum, Nubium, Cognitum, Frigoris (two), Vaporum.
const vec4 kSeas[14] = vec4[14](
    vec4(-0.223, 0.542, 0.810, 0.320), vec4(0.266, 0.469, 0.842, 0.190), vec4(0.512, 0.148, 0.846, 0.230),
    vec4(0.820, 0.292, 0.492, 0.120), vec4(0.780, -0.136, 0.611, 0.200), vec4(0.545, -0.262, 0.796, 0.100),
    vec4(-0.800, 0.310, 0.514, 0.250), vec4(-0.720, 0.060, 0.691, 0.270), vec4(-0.560, 0.250, 0.790, 0.180),
    vec4(-0.570, -0.410, 0.712, 0.115), vec4(-0.270, -0.360, 0.893, 0.210), vec4(-0.380, -0.174, 0.908, 0.130),
    vec4(-0.120, 0.830, 0.545, 0.110), vec4(0.062, 0.230, 0.971, 0.070));

// Reflectance against the mean, of a unit direction on the near side.
float seaShade(vec3 place) {
  float sea = 0.0;
  for (int i = 0; i < 14; ++i) {
    float away = length(place - kSeas[i].xyz) / kSeas[i].w;
    sea = max(sea, 1.0 - smoothstep(0.7, 1.15, away));
  }
  return 1.15 - 0.5 * sea;
}

vec3 moonEast() { return normalize(cross(moonPlace.xyz, moonNorth)); }

// Corner i of two triangles around the disc, as a direction.
vec3 moonCorner(int i) {
  vec2 corner = vec2((0x34 >> i) & 1, (0x26 >> i) & 1) * 2.0 - 1.0;
  float reach = tan(moonPlace.w) + 2.0 * frame.depthToSea.w;
  return moonPlace.xyz + reach * (corner.x * moonEast() + corner.y * moonNorth);
}

// Of the disc in a direction, against its light where it is lit as steeply as it is seen; 0 beside it.
vec2 moonShade(vec3 direction) {
  vec2 aside = vec2(dot(direction, moonEast()), dot(direction, moonNorth)) / sin(moonPlace.w);
  float beside = 1.0 - dot(aside, aside);
  if (beside <= 0.0 || direction.y < seaEndsSine()) return vec2(0.0);
  float seen = sqrt(beside);
  vec3 normal = aside.x * moonEast() + aside.y * moonNorth - seen * moonPlace.xyz;
  float lit = max(dot(normal, moonToSun), 0.0);
  return seaShade(vec3(aside, seen)) * vec2(2.0 * lit / max(lit + seen, 1e-3), 1.0);
}

// The mean over a pixel (its sides as directions), which may be as large as the disc: of 8 x 8 places.
vec3 moonInPixel(vec3 middle, vec3 right, vec3 up) {
  vec2 shade = vec2(0.0);
  for (int i = 0; i < 64; ++i) {
    vec2 at = (vec2(i % 8, i / 8) - 3.5) / 8.0;
    shade += moonShade(normalize(middle + at.x * right + at.y * up));
  }
  const vec3 kColor = vec3(1.05, 1.0, 0.91);
  vec3 light = kColor * (dot(shade, moonLight) / 64.0) * airTransmittanceTowards(normalize(middle));
  return min(light, vec3(kBrightest));
}
