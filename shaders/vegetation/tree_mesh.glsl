// Vertices of a tree's mesh: a unit tree (height 1, crown's radius 1) made as large as its instance and bent by the wind.
#include "frame.glsl"
#include "vegetation/tree_attributes.glsl"

layout(location = 0) in vec3 unitPlace;
layout(location = 1) in vec3 unitNormal;
layout(location = 2) in vec2 unitSurface;  // share of the sky that is open; 1: bark, 0: leaves

vec3 turned(vec3 v, vec2 turn) { return vec3(v.x * turn.x + v.z * turn.y, v.y, v.z * turn.x - v.x * turn.y); }

// How far a part of a tree at a height (share of its own) is blown, metres: as a beam that is held below, the tips of twigs a
// little by themselves.
vec3 blown(float height, vec3 at) {
  float twig = treeBend.z * (1.0 - height) * sin(treeBend.w + 17.0 * at.x + 11.0 * at.z);
  return vec3(treeBend.x, 0.0, treeBend.y) * (height * height) + vec3(0.0, twig, 0.0);
}

struct TreeVertex {
  vec3 relative;
  vec3 normal;
};

TreeVertex treeVertex() {
  vec2 turn = treeForm.yz;
  float heightM = treeFoot.w, radiusM = treeForm.x;
  vec3 at = vec3(unitPlace.x * radiusM, unitPlace.y * heightM, unitPlace.z * radiusM);
  TreeVertex result;
  result.normal = turned(unitNormal, turn);
  result.relative = treeFoot.xyz + turned(at, turn) + blown(max(unitPlace.y, 0.0), unitPlace);
  return result;
}
