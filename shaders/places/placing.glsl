// What placing buildings and hedges has in common: light, view, lists.
#include "terrain/land.glsl"  // compiled with PLACES
#include "shared/cloud_light.glsl"  // before what is conditional: a file is included once
#include "terrain/drawn_height.glsl"
#include "places/instance.glsl"
#ifdef CLOUD_SHADE
#include "clouds/shadow_map.glsl"
#endif
#ifdef LAND_SHADE
#include "shadow/land_shadow_map.glsl"
#endif
#ifdef ICE_SHADE
#include "clouds/ice_shade_map.glsl"
#endif

layout(std430, binding = 1) writeonly buffer Instances { PlaceInstance instances[]; };
struct DrawCommand {
  uint count;
  uint instanceCount;
  uint firstIndex;
  int baseVertex;
  uint baseInstance;
};
layout(std430, binding = 2) buffer Commands { DrawCommand commands[kPlaceLists]; };

uniform vec4 placeReach;  // metres: buildings fade between x and y, hedges between z and w
uniform vec2 placeRoom;   // instances of the two lists
uniform float windowShare;  // of the windows that are lit

vec3 sharesAt(vec3 relative) {
  vec3 shares = kOpenSky;
#ifdef CLOUD_SHADE
  shares = lightThroughClouds(relative);
#endif
#ifdef LAND_SHADE
  shares.x *= sunPastLand(relative);
#endif
#ifdef ICE_SHADE
  shares *= lightBelowIce(relative).xyx;
#endif
  return shares;
}

bool isInView(vec3 middle, float radiusM) {
  vec4 clip = frame.viewProjection * vec4(middle, 1.0);
  vec2 slack = radiusM * vec2(length(vec3(frame.viewProjection[0].x, frame.viewProjection[1].x, frame.viewProjection[2].x)),
                              length(vec3(frame.viewProjection[0].y, frame.viewProjection[1].y, frame.viewProjection[2].y))) +
               radiusM;
  return clip.w > -radiusM && all(lessThan(abs(clip.xy), vec2(clip.w) + slack));
}

// Light of an instance whose foot, form and turn are set.
PlaceInstance lit(PlaceInstance made, vec3 middle, uint bits, float drawn) {
  vec3 shares = sharesAt(middle);
  vec3 hazeAlone = endingLandThroughAir(vec3(0.0), middle, leftOfLight(middle));
  vec3 passed = endingLandThroughAir(vec3(1.0), middle, leftOfLight(middle)) - hazeAlone;
  made.sun = vec4(frame.sunLight.xyz * shares.x * passed / kPi, float(bits >> 8));
  made.above = vec4((frame.skyLight.xyz * shares.y + diffuseSun(shares)) * passed / kPi, drawn);
  made.below = vec4(frame.groundLight.xyz * shares.y * passed / kPi, windowShare);
  made.air = vec4(hazeAlone, passed.y);
  return made;
}

void put(uint list, PlaceInstance made) {
  uint slot = atomicAdd(commands[list].instanceCount, 1u);
  if (float(slot) < placeRoom[list]) instances[commands[list].baseInstance + slot] = made;
}
