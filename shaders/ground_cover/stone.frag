#include "ground_cover/stone_look.glsl"

in vec3 relative;
in vec3 inStone;
flat in vec3 lightSun, lightAbove, lightBelow, lightAir, stoneAlbedo;
flat in vec3 stoneOwn;
out vec4 color;

void main() {
  color = vec4(stoneColor(StoneLight(lightSun, lightAbove, lightBelow, lightAir), stoneAlbedo, relative, inStone, stoneOwn), 1.0);
}
