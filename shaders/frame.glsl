// What every shader of a frame may read: the block of include/skydrop/render/frame/frame_uniforms.h and what follows from
// it. Light is multiplied by exposure; positions are relative to the eye, in world axes (metres).
#include "shared/atmosphere.glsl"
#include "shared/atmosphere_shell.glsl"
#include "shared/depth.glsl"
#include "shared/half_float.glsl"

layout(std140, binding = 0) uniform Frame {
  mat4 viewProjection;
  mat4 ndcToRay;
  vec4 eye;
  vec4 viewport;
  vec4 toSun;
  vec4 sunLight;
  vec4 skyLight;
  vec4 groundLight;
  vec4 sunDisc;
  vec4 nightRadiance;
  vec4 airRayleigh;
  vec4 airHaze;
  vec4 columnDepth;
  vec4 columnHere;
  vec4 airLight;
  vec4 hazeLight;
  vec4 overhead;
  vec4 depthToSea;
  vec4 horizonRayleigh;
  vec4 horizonHaze;
  vec4 horizonIsotropic;
  vec4 skySun;
  vec4 skyTable;
  vec4 skyGlow;
  vec4 overcast;
} frame;

#include "sky/atmosphere.glsl"

// What dims light arrives as shares of it: of the sun's light, what comes straight (x) and what clouds have scattered,
// which comes from all of the sky (z); of the light of sky and ground (y).
const vec3 kOpenSky = vec3(1.0, 1.0, 0.0);

// Irradiance of a level surface by the sun's light that clouds have scattered.
vec3 diffuseSun(vec3 shares) { return frame.sunLight.xyz * (max(frame.toSun.y, 0.0) * shares.z); }

// The same as radiance in an upward direction, for mirrors: as of an overcast sky (CIE S 011: at the zenith three times
// that of the horizon) in the share of the sky that clouds hide.
vec3 diffuseSunTowards(vec3 direction, vec3 shares) {
  float shape = (1.0 + 2.0 * max(direction.y, 0.0)) * (3.0 / 7.0);
  return diffuseSun(shares) * (shape * saturate(1.0 - shares.y) / kPi);
}

// Irradiance of a surface of a unit normal; `open`: share of the half space that nothing near hides.
vec3 irradianceOf(vec3 normal, float open, vec3 shares) {
  float up = 0.5 + 0.5 * normal.y;
  return frame.sunLight.xyz * (max(dot(normal, frame.toSun.xyz), 0.0) * shares.x) +
         mix(frame.groundLight.xyz, frame.skyLight.xyz, up) * (open * shares.y) + diffuseSun(shares) * (open * up);
}

// Light that a matt surface sends out: albedo in [0, 1], unit normal.
vec3 shadeLambert(vec3 albedo, vec3 normal, vec3 shares) { return albedo / kPi * irradianceOf(normal, 1.0, shares); }
