// Lists that later dispatches go through: words that hold steps, and pixels that the other side of an edge has a part of. A
// dispatch over a list has the groups that it begins with, 64 invocations each.
#include "listed.glsl"

layout(std430, binding = 0) buffer Words {
  uvec4 groups;  // w: words in the list
  uint at[];     // the first pixel's x / 32, and its y in the upper half; the steps' direction in the highest bit
} listedWords;

layout(std430, binding = 1) buffer Pixels {
  uvec4 groups;
  uint at[];
} listedPixels;

const uint kIsRightward = 0x80000000u;

uint indexInList(uvec3 group, uint invocation) { return (group.y * kGroupsARow + group.x) * 64u + invocation; }

void listWord(ivec2 pixel, uint direction) {
  uint slot = atomicAdd(listedWords.groups.w, 1u);
  listedWords.at[slot] = packedPlace(ivec2(pixel.x >> 5, pixel.y)) | direction;
  if ((slot & 63u) != 0u) return;  // not the first of its group
  atomicMax(listedWords.groups.x, min(slot / 64u + 1u, kGroupsARow));
  atomicMax(listedWords.groups.y, slot / 64u / kGroupsARow + 1u);
}

void listPixel(ivec2 pixel) {
  uint slot = atomicAdd(listedPixels.groups.w, 1u);
  listedPixels.at[slot] = packedPlace(pixel);
  if ((slot & 63u) != 0u) return;
  atomicMax(listedPixels.groups.x, min(slot / 64u + 1u, kGroupsARow));
  atomicMax(listedPixels.groups.y, slot / 64u / kGroupsARow + 1u);
}

ivec2 pixelInList(uint index) { return unpackedPlace(listedPixels.at[index]); }
