#include "models/scene_depth.glsl"
#include "models/propeller.glsl"

in vec3 relative;
in vec3 surfaceNormal;
in vec2 surfaceUv;
out vec4 color;

void main() {
  discardIfHidden();
  vec4 veil = propellerOpacity(surfaceUv.y, surfaceUv.x);
  vec3 light = shadeLambert(veil.rgb, normalize(surfaceNormal), lightShares);
  color = vec4(applyAerialPerspective(light, relative) * veil.a, veil.a);
}
