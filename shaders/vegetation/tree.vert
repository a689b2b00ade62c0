#include "vegetation/tree_mesh.glsl"
#include "sea_cut.glsl"

out vec3 crownPlace;  // of the unit tree
out vec3 surfaceNormal;
out vec2 surfaceLight;  // open to the sky; to the sun
out float bark;
out vec3 toTree;
flat out vec3 lightSun, lightAbove, lightBelow, lightAir;
flat out vec4 fade;  // share that is drawn; its own dither; size of the leaves' noise; snow

#include "vegetation/crown_light.glsl"

void main() {
  TreeVertex vertex = treeVertex();
  gl_Position = frame.viewProjection * vec4(vertex.relative, 1.0);
  cutBelowSea(vertex.relative);
  crownPlace = unitPlace;
  surfaceNormal = vertex.normal;
  bark = unitSurface.y;
  toTree = vertex.relative;
  surfaceLight = crownLight(unitSurface.x, unitPlace.y, treeAbove.w);
  lightSun = treeSun.xyz;
  lightAbove = treeAbove.xyz;
  lightBelow = treeBelow.xyz;
  lightAir = treeAir.xyz;
  fade = vec4(treeForm.w, treeBelow.w, floor(treeSun.w), 2.0 * fract(treeSun.w));
}
