// What every shader of a frame may read: the block of include/skydrop/render/frame/frame_uniforms.h and what follows from
// it. Light is multiplied by exposure; positions are relative to the eye, in world axes (metres).
#include "shared/depth.glsl"
#include "shared/atmosphere.glsl"
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
} frame;

Atmosphere frameAtmosphere() {
  Atmosphere air;
  air.rayleigh = frame.airRayleigh.xyz;
  air.rayleighHeight = frame.airRayleigh.w;
  air.haze = frame.airHaze.x;
  air.hazeHeight = frame.airHaze.y;
  air.hazeAlbedo = frame.airHaze.z;
  air.hazeAnisotropy = frame.airHaze.w;
  return air;
}

// The air above the eye; its light is the sun's own, so radiances come out of it without another factor.
SkyColumn frameColumn() {
  SkyColumn column;
  column.depth = frame.columnDepth.xyz;
  column.sunMass = frame.columnDepth.w;
  column.airHere = frame.columnHere.xyz;
  column.hazeHere = frame.columnHere.w;
  column.airLight = frame.airLight.xyz;
  column.hazeLight = frame.hazeLight.xyz;
  column.overhead = frame.overhead.xyz;
  return column;
}

// Light that a matt surface sends out: albedo in [0, 1], unit normal, share of the sun that is not in shadow.
vec3 shadeLambert(vec3 albedo, vec3 normal, float sunShare) {
  float up = 0.5 + 0.5 * normal.y;
  vec3 light = frame.sunLight.xyz * (max(dot(normal, frame.toSun.xyz), 0.0) * sunShare) +
               mix(frame.groundLight.xyz, frame.skyLight.xyz, up);
  return albedo / kPi * light;
}

// Radiance of the sky at the horizon below a direction: what haze sends towards the eye.
vec3 horizonRadiance(vec3 direction) {
  float c = dot(direction, frame.toSun.xyz);
  return frame.horizonRayleigh.xyz * rayleighPhase(c) + frame.horizonHaze.xyz * henyeyGreenstein(c, frame.airHaze.w) +
         frame.horizonIsotropic.xyz;
}

// A surface's light as it reaches the eye from a place `relative` to it. Without the feature: as it is.
vec3 applyAerialPerspective(vec3 light, vec3 relative) {
#ifdef HAZE
  float distanceM = length(relative);
  vec3 direction = relative / max(distanceM, 1e-6);
  vec3 transmittance =
      exp(-opticalDepthBetween(frameAtmosphere(), frame.eye.x, frame.eye.x + relative.y, distanceM));
  return light * transmittance + horizonRadiance(direction) * (1.0 - transmittance);
#else
  return light;
#endif
}
