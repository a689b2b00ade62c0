// The mesh of the land: how the level of detail depends on distance and how heights morph between two levels.
// C++ tests and the vertex shader share it; include/skydrop/terrain/lod.h describes the scheme.
#ifndef __cplusplus
#include "shared/terrain_grid.glsl"
#endif

// Level of detail at a distance from the eye, metres: 0 up to morph[0], l at morph[l], linear between, below 10.
FN Real lodLambda(Real distanceM, Real morph[kTopPatchLevel + 1]) {
  Real lambda = Real(0.0);
  for (int l = 0; l < kTopPatchLevel; ++l) {
    lambda += clamp((distanceM - morph[l]) / (morph[l + 1] - morph[l]), Real(0.0), Real(1.0));
  }
  return lambda < Real(9.999) ? lambda : Real(9.999);
}

// The index on the grid of a neighbour that is `levels` coarser: downwards along z, upwards along x. With quads cut
// from (x + 1, z) to (x, z + 1) the triangles of a border then stay in the planes of the coarser mesh.
FN int snapDown(int index, int levels) { return (index >> levels) << levels; }
FN int snapUp(int index, int levels) { return -((-index >> levels) << levels); }

// Height of a mesh inside a cell, from its four corners (h10: east, h01: south) and the position in it, [0, 1). On
// the west and north border the other corners do not count, not even by rounding.
FN Real meshHeight(Real h00, Real h10, Real h01, Real h11, Real fx, Real fz) {
  if (fx + fz <= Real(1.0)) return h00 + (h10 - h00) * fx + (h01 - h00) * fz;
  return h11 + (h01 - h11) * (Real(1.0) - fx) + (h10 - h11) * (Real(1.0) - fz);
}
