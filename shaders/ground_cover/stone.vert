#include "ground_cover/stone.glsl"
#include "sea_cut.glsl"

out vec3 relative;
out vec3 inStone;
flat out vec3 lightSun, lightAbove, lightBelow, lightAir, stoneAlbedo;
flat out vec3 stoneOwn;  // tint; bits of its noise; whether moss may grow

void main() {
  StoneVertex vertex = stoneVertex();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  cutBelowSea(vertex.relative);
  relative = vertex.relative;
  inStone = vertex.inStone;
  lightSun = coverSun.xyz;
  lightAbove = coverAbove.xyz;
  lightBelow = coverBelow.xyz;
  lightAir = coverAir.xyz;
  stoneAlbedo = coverAlbedo.rgb;
  stoneOwn = vec3(coverAbove.w, coverForm.w, coverFoot.y);
}
