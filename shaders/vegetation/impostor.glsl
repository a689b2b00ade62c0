// Trees far away: a rectangle each that faces the eye, with the nearest views of the atlas.
#include "frame.glsl"
#include "shared/impostor.glsl"
#include "vegetation/tree_attributes.glsl"

uniform vec4 impostorShapes[3];  // of each kind: radius over height, half the view's side over height
uniform float impostorViews;     // along a side of the atlas

const float kCrownMargin = 1.12;  // over the crown's radius: lumps reach 1.08, and texels are filtered

struct ImpostorCorner {
  vec3 relative;
  vec2 inView;  // [-1, 1]
  vec2 views;   // place in the grid of views, in views
  vec2 turn;
};

ImpostorCorner impostorCorner(int vertex) {
  float heightM = treeFoot.w;
  vec4 shape = impostorShapes[int(treeSun.w)];
  // A view is no wider than the crown, whatever side it shows: beyond it its square is empty.
  float wideShare = min(kCrownMargin * shape.x / shape.y, 1.0);
  vec2 corner = vec2((vertex & 1) == 0 ? -wideShare : wideShare, (vertex & 2) == 0 ? -1.0 : 1.0);
  vec3 middle = treeFoot.xyz + vec3(0.0, 0.5 * heightM, 0.0);
  vec3 towards = -normalize(middle);
  vec3 level = vec3(-towards.z, 0.0, towards.x);
  vec3 right = level / max(length(level), 1e-4);
  right = dot(right, right) > 0.5 ? right : vec3(1.0, 0.0, 0.0);
  vec3 up = cross(towards, right);
  up = up.y < 0.0 ? -up : up;
  float wide = treeForm.x / (shape.x * heightM);
  ImpostorCorner result;
  result.inView = corner;
  result.relative = middle + (right * (corner.x * wide) + up * corner.y) * (shape.y * heightM);
  // Blown as its mesh is, whose top has the whole way: a rectangle leans instead of bending.
  float share = clamp((result.relative.y - treeFoot.y) / max(heightM, 1e-3), 0.0, 1.1);
  result.relative.xz += treeBend.xy * share;
  vec2 turn = treeForm.yz;
  vec3 own = vec3(towards.x * turn.x - towards.z * turn.y, max(towards.y, 0.0), towards.z * turn.x + towards.x * turn.y);
  result.views = hemiOctOf(normalize(own + vec3(0.0, 1e-4, 0.0))) * (impostorViews - 1.0);
  result.turn = turn;
  return result;
}
