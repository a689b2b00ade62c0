// What clouds leave of the light at a place (include/skydrop/render/clouds/cloud_shadow_map.h).
#include "frame.glsl"
#include "shared/cloud_light.glsl"
#include "shared/cloud_form.glsl"

// CLOUD_LAYERS: so many layers, a channel of the maps for each.
layout(binding = 12) uniform sampler2D skyShareMap;  // of the light of the sky, below the layer
#ifdef CLOUD_LAYERS
uniform vec4 skySharePlaces[CLOUD_LAYERS];  // as below, of each layer
uniform vec4 shadowMapBases;                // as below, of each layer
uniform vec4 shadowMapThicknesses;          // 1 / m
uniform vec2 overcastSky;                   // how overcast it is, [0, 1]; sine of the sun's elevation

vec4 layersAbove(vec3 relative) {
  return vec4(1.0) - clamp((vec4(relative.y) - shadowMapBases) * shadowMapThicknesses, vec4(0.0), vec4(1.0));
}

float skyThroughClouds(vec3 relative) {
  vec4 above = layersAbove(relative) * cloudFade(length(relative), skySharePlaces[0].w);
  float share = 1.0;
  for (int i = 0; i < CLOUD_LAYERS; ++i) {
    float below = texture(skyShareMap, skySharePlaces[i].xy + relative.xz * skySharePlaces[i].z)[i];
    share *= 1.0 - (1.0 - below) * above[i];
  }
  return share;
}

float depthAbove(vec3 relative, vec4 depths) { return dot(depths, layersAbove(relative)); }
#else
uniform vec4 skySharePlace;   // the eye in that texture; its coordinates a metre; where clouds have faded (m)
uniform vec2 shadowMapLayer;  // base above the eye (m), 1 / thickness

// Share of the layer above a place: within it the clouds below do not shade. Taken as even from base to top.
float layerAbove(vec3 relative) { return 1.0 - saturate((relative.y - shadowMapLayer.x) * shadowMapLayer.y); }

float skyThroughClouds(vec3 relative) {
  float below = texture(skyShareMap, skySharePlace.xy + relative.xz * skySharePlace.z).x;
  return 1.0 - (1.0 - below) * (layerAbove(relative) * cloudFade(length(relative), skySharePlace.w));
}

float depthAbove(vec3 relative, vec4 depths) { return depths.x * layerAbove(relative); }
#endif

#ifdef SUN_SHADOW
layout(binding = 10) uniform sampler3D fineShadowMap;  // one layer: optical depth of the clouds along a sun ray
layout(binding = 11) uniform sampler3D coarseShadowMap;
uniform vec4 inFineShadowMap[2];  // rows: a place relative to the eye, and 1, to the texture
uniform vec4 inCoarseShadowMap[2];
uniform vec2 shadowRadii;  // how far the fine and the coarse map reach for certain (m)

vec2 placeInShadowMap(vec4 rows[2], vec3 relative) {
  return vec2(dot(rows[0], vec4(relative, 1.0)), dot(rows[1], vec4(relative, 1.0)));
}

// 1 inside a map, 0 at its radius and beyond, along the map's axes. Counted along the sun's rays from the ground below
// the eye, not from the texture's edges: those move in steps of eight columns, and shadows would change with them.
float insideShadowMap(vec4 rows[2], vec3 relative, float radiusM) {
  vec3 fromGround = relative + vec3(0.0, frame.eye.x, 0.0);
  float along = dot(rows[0].xyz, fromGround) * inversesqrt(dot(rows[0].xz, rows[0].xz));
  float across = dot(rows[1].xyz, fromGround) * inversesqrt(dot(rows[1].xz, rows[1].xz));
  return smoothstep(0.0, 0.12, 1.0 - max(abs(along), abs(across)) / radiusM);
}

// Optical depth of the clouds between a place and the sun (x), and what of it counts there (y, [0, 1]): none beyond the maps.
vec2 sunDepthInClouds(vec3 relative) {
  vec2 fine = placeInShadowMap(inFineShadowMap, relative);
  vec2 coarse = placeInShadowMap(inCoarseShadowMap, relative);
  vec4 depths = mix(texture(coarseShadowMap, vec3(coarse, 0.5)), texture(fineShadowMap, vec3(fine, 0.5)),
                    insideShadowMap(inFineShadowMap, relative, shadowRadii.x));
  return vec2(depthAbove(relative, depths), insideShadowMap(inCoarseShadowMap, relative, shadowRadii.y));
}

float sunBelow(float depth) {
#ifdef CLOUD_LAYERS
  return sunBelowLayers(depth, overcastSky.y, overcastSky.x);
#else
  return sunBelowCloud(depth);
#endif
}

// Straight and scattered together.
float sunThroughClouds(vec3 relative) {
  vec2 depth = sunDepthInClouds(relative);
  return mix(1.0, sunBelow(depth.x), depth.y);
}

// Of the sun straight (x) and scattered (z), of the sky (y): as frame.glsl has them.
vec3 lightThroughClouds(vec3 relative) {
  vec2 depth = sunDepthInClouds(relative);
  float straight = sunStraightThroughCloud(depth.x);
  return vec3(mix(1.0, straight, depth.y), skyThroughClouds(relative), max(sunBelow(depth.x) - straight, 0.0) * depth.y);
}
#else
float sunThroughClouds(vec3 relative) { return 1.0; }  // it is below the horizon
vec3 lightThroughClouds(vec3 relative) { return vec3(1.0, skyThroughClouds(relative), 0.0); }
#endif
