// Fills a grid of the optical depth from the base of the layer to its top, towards the sun: each column is a sum along one
// sun ray. The clouds' block has the grid's first node for an eye.
// LAYERS: a channel for each layer, along one sun ray through all; samples are shared out over the shell of each.
#include "clouds/field.glsl"

#ifdef LAYERS
layout(binding = 0, rgba32f) uniform writeonly image3D depths;
#else
layout(binding = 0, r32f) uniform writeonly image3D depths;
#endif

uniform vec3 along;          // from a node to the next, metres
uniform vec3 across;
uniform vec3 sunward;        // to the next layer of nodes
uniform ivec3 nodes;
uniform int samplesALayer;

#ifdef LAYERS
uniform vec4 samplesOfLayers;  // of each, whole numbers; 0: the layer is not there

float depthIn(const int i, vec3 foot, vec3 aMetreUp) {
  vec4 shell = clouds.layers[i].shell;
  float count = samplesOfLayers[i];
  float part = shell.y / max(count, 1.0);
  float depth = 0.0;
  for (float k = 0.0; k < count; k += 1.0) {
    depth += extinctionAt(clouds.layers[i], foot + aMetreUp * (shell.x - foot.y + (k + 0.5) * part));
  }
  return depth * part * length(aMetreUp);
}

void fillColumn(ivec2 column) {
  if (column.x >= nodes.x || column.y >= nodes.y) return;
  vec3 foot = along * float(column.x) + across * float(column.y);
  vec3 aMetreUp = sunward / sunward.y;
  vec4 depth = vec4(0.0);
#define DEPTH(i) depth[i] = depthIn(i, foot, aMetreUp);
  EACH_LAYER(DEPTH)
#undef DEPTH
  imageStore(depths, ivec3(column, 0), depth);
}
#else
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
#endif
