// A stone of few pixels: a light for each of its faces, that of one of their corners.
#include "ground_cover/stone.glsl"
#include "ground_cover/stone_light.glsl"

vec3 lightOfFarStone(StoneVertex vertex) {
  StoneLight light = StoneLight(coverSun.xyz, coverAbove.xyz, coverBelow.xyz, coverAir.xyz);
  return stoneLit(light, coverAlbedo.rgb, vertex.outwards, 0.0, coverAbove.w, vertex.relative.y - coverFoot.y);
}
