// Noise at places of the land and the sea.
#include "shared/lattice_noise.glsl"
#include "terrain/surface.glsl"

// What lattice and position a place has; `perChunk` cells to the side of a chunk of level 0.
void latticeOf(vec2 place, int perChunk, out uvec2 cell, out vec2 inside) {
  vec2 scaled = place * (float(perChunk) / kChunkMetres);
  vec2 whole = floor(scaled);
  inside = scaled - whole;
  cell = uvec2(baseChunk * perChunk + ivec2(whole));
}

vec2 noiseAt(vec2 place, int perChunk) {
  uvec2 cell;
  vec2 inside;
  latticeOf(place, perChunk, cell, inside);
  return latticeNoise(cell, inside);
}

// Cells a fifth as wide.
vec2 turnedNoiseAt(vec2 place, int perChunk) {
  uvec2 cell;
  vec2 inside;
  latticeOf(place, perChunk, cell, inside);
  return turnedLatticeNoise(cell, inside);
}

// Noise in space at a place and a height above the sea: slope per metre and value. `perChunk` is a multiple of 3, so
// that chunk corners are corners of the skewed lattice.
vec4 spaceNoiseAt(vec2 place, float heightM, int perChunk) {
  float scale = float(perChunk) / kChunkMetres;
  ivec2 base = baseChunk * perChunk;
  int skew = (baseChunk.x + baseChunk.y) * (perChunk / 3);
  vec4 noise = simplexNoise(uvec3(ivec3(base.x, 0, base.y) + skew), vec3(place.x, heightM, place.y) * scale);
  return vec4(noise.xyz * scale, noise.w);
}

// How much of detail of a size is left where a pixel covers `footprint`, both metres.
float resolved(float size, float footprint) { return clamp(1.5 - 2.0 * footprint / size, 0.0, 1.0); }
