#include "precipitation/veil_seen.glsl"

noperspective in vec4 depths;
noperspective in vec4 lightAndDistance;
noperspective in vec2 rayScaleAndReach;
out vec4 color;

void main() {
  Veil veil = Veil(depths, lightAndDistance.xyz, lightAndDistance.w, rayScaleAndReach.y);
  color = veilBefore(veil, rayScaleAndReach.x);
}
