#include "vegetation/tree_look.glsl"

in vec3 crownPlace;
in vec3 surfaceNormal;
in vec2 surfaceLight;
in float bark;
in vec3 toTree;
flat in vec3 lightSun, lightAbove, lightBelow, lightAir;
flat in vec4 fade;
out vec4 color;

void main() {
  Leaves leaves = leavesAt(crownPlace, fade.z, bark, rimOf(surfaceNormal, toTree));
  if (leaves.opaque < 0.0 || ditherOf(gl_FragCoord.xy, fade.y) >= fade.x) discard;
  color = vec4(treeColor(TreeLight(lightSun, lightAbove, lightBelow, lightAir), normalize(surfaceNormal), surfaceLight,
                         bark, fade.w, leaves), 1.0);
}
