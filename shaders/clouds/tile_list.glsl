// The tiles that shaders/clouds/classify.glsl has listed.
#include "clouds/tiles.glsl"

layout(std430, binding = 0) readonly buffer Tiles {
  uvec4 groups;        // of a dispatch with a group for each tile; w: tiles in the list
  uvec4 groupsOfFour;  // of a dispatch with a group for four
  Task tasks[];
} tiles;
