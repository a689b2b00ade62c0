// Fills a light grid: optical depth from its nodes to the top of the layer, towards the sun. Nodes stand on sun rays,
// so that each column is a running sum along one ray. The clouds' block has the grid's first node for an eye. BASE_ALONE: only the depth at the base of the layer is kept.
#include "clouds/field.glsl"

layout(binding = 0, r32f) uniform writeonly image3D depths;

uniform vec3 along;          // from a node to the next, metres
uniform vec3 across;
uniform vec3 sunward;        // to the next layer of nodes
uniform ivec3 nodes;
uniform int samplesALayer;

void fillColumn(ivec2 column) {
  if (column.x >= nodes.x || column.y >= nodes.y) return;
  vec3 foot = along * float(column.x) + across * float(column.y);
  float part = length(sunward) / float(samplesALayer);
  float depth = 0.0;
#ifndef BASE_ALONE
  imageStore(depths, ivec3(column, nodes.z - 1), vec4(0.0));
#endif
  for (int layer = nodes.z - 2; layer >= 0; --layer) {
    for (int i = 0; i < samplesALayer; ++i) {
      float upwards = float(layer) + (float(i) + 0.5) / float(samplesALayer);
      depth += extinctionAt(foot + sunward * upwards) * part;
    }
#ifndef BASE_ALONE
    imageStore(depths, ivec3(column, layer), vec4(depth));
#endif
  }
#ifdef BASE_ALONE
  imageStore(depths, ivec3(column, 0), vec4(depth));
#endif
}
