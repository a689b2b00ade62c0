// A list of rays that a later dispatch marches, 64 a group. For groups of any size.
#include "clouds/tiles.glsl"

layout(std430, binding = 3) buffer Rays {
  uvec4 groups;  // of the dispatch; w: rays in the list
  uint texels[];
} rays;

shared uint listedInGroup;
shared uint firstOfGroup;

// Reserves `count` places in a row for an invocation and returns the first. All invocations of a group call it.
uint placesInList(uint invocation, uint count) {
  if (invocation == 0u) listedInGroup = 0u;
  barrier();
  uint slot = 0u;
  if (count > 0u) slot = atomicAdd(listedInGroup, count);
  barrier();
  if (invocation == 0u && listedInGroup > 0u) {
    firstOfGroup = atomicAdd(rays.groups.w, listedInGroup);
    uint lastGroup = (firstOfGroup + listedInGroup - 1u) / 64u;
    atomicMax(rays.groups.x, min(lastGroup + 1u, kGroupsARow));
    atomicMax(rays.groups.y, lastGroup / kGroupsARow + 1u);
  }
  barrier();
  return firstOfGroup + slot;
}
