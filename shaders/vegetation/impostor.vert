#include "vegetation/impostor.glsl"
#include "sea_cut.glsl"
#include "vegetation/crown_light.glsl"

out vec2 inView;
out vec2 surfaceLight;
flat out vec2 views;
flat out vec2 turn;
flat out vec3 lightSun, lightAbove, lightBelow, lightAir;
flat out vec4 fade;  // drawn from and up to; its own dither; kind

void main() {
  ImpostorCorner corner = impostorCorner(gl_VertexID);
  gl_Position = frame.viewProjection * vec4(corner.relative, 1.0);
  cutBelowSea(corner.relative);
  inView = corner.inView;
  views = corner.views;
  turn = corner.turn;
  surfaceLight = crownLight(1.0, 0.5 + 0.55 * corner.inView.y, treeAbove.w);
  lightSun = treeSun.xyz;
  lightAbove = treeAbove.xyz;
  lightBelow = treeBelow.xyz;
  lightAir = treeAir.xyz;
  fade = vec4(treeForm.w, treeAir.w, treeBelow.w, floor(treeSun.w));
}
