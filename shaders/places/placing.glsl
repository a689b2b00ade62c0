// What placing buildings and hedges has in common: light, view, lists.
#include "terrain/placing.glsl"  // compiled with PLACES
#include "terrain/drawn_height.glsl"
#include "places/instance.glsl"

layout(std430, binding = 1) writeonly buffer Instances { PlaceInstance instances[]; };
layout(std430, binding = 2) buffer Commands { DrawCommand commands[kPlaceLists]; };

uniform vec4 placeReach;  // metres: buildings fade between x and y, hedges between z and w
uniform vec2 placeRoom;   // instances of the two lists
uniform float windowShare;  // of the windows that are lit

// Light of an instance whose foot, form and turn are set.
PlaceInstance lit(PlaceInstance made, vec3 middle, uint bits, float drawn) {
  vec3 shares = sharesAt(middle);
  vec3 hazeAlone = endingLandThroughAir(vec3(0.0), middle, leftOfLight(middle));
  vec3 passed = endingLandThroughAir(vec3(1.0), middle, leftOfLight(middle)) - hazeAlone;
  made.sun = vec4(frame.sunLight.xyz * shares.x * passed / kPi, float(bits >> 8));
  vec3 lamps = lampsAt(middle);
  made.above = vec4((frame.skyLight.xyz * shares.y + diffuseSun(shares) + lamps) * passed / kPi, drawn);
  made.below = vec4((frame.groundLight.xyz * shares.y + lamps) * passed / kPi, windowShare);
  made.air = vec4(hazeAlone, passed.y);
  return made;
}

void put(uint list, PlaceInstance made) {
  uint slot = atomicAdd(commands[list].instanceCount, 1u);
  if (float(slot) < placeRoom[list]) instances[commands[list].baseInstance + slot] = made;
}
