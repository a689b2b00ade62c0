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
} frame;

#include "sky/atmosphere.glsl"

// Light that a matt surface sends out: albedo in [0, 1], unit normal, shares of the light of the sun, and of sky and
// ground, that reach it.
vec3 shadeLambert(vec3 albedo, vec3 normal, vec2 shares) {
  float up = 0.5 + 0.5 * normal.y;
  vec3 light = frame.sunLight.xyz * (max(dot(normal, frame.toSun.xyz), 0.0) * shares.x) +
               mix(frame.groundLight.xyz, frame.skyLight.xyz, up) * shares.y;
  return albedo / kPi * light;
}
