// Fills a grid of the optical depth from the base of the layer to its top, towards the sun: each column is a sum along one
// sun ray. The clouds' block has the grid's first node for an eye.
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
  for (int layer = nodes.z - 2; layer >= 0; --layer) {
    for (int i = 0; i < samplesALayer; ++i) {
      float upwards = float(layer) + (float(i) + 0.5) / float(samplesALayer);
      depth += extinctionAt(foot + sunward * upwards) * part;
    }
  }
  imageStore(depths, ivec3(column, 0), vec4(depth));
}
