// Where trees stand, and which: by hash of the cell, woods by forestDensity (land_material.glsl). The lattice and its
// bits are those of the crowns that are painted on the ground (crownsAt), so a tree stands where its crown is painted.
// Pure functions of the place: drawing, shading and collision ask them.
#ifndef __cplusplus
#include "shared/land_material.glsl"
#include "shared/terrain_grid.glsl"
#endif

CONST Real kTreeCellM = Real(8.0);      // one tree to a cell at most
CONST int kTreeCellsPerChunk = 120;     // along a side of a chunk of level 0
CONST Real kTallestTreeM = Real(26.0);  // no tree is taller
CONST Real kWidestCrownM = Real(5.4);   // no crown's radius is wider
CONST Real kStemReachM = Real(2.56);    // of a stem from its cell's north-west corner, along each axis

CONST int kSpruce = 0;
CONST int kBroadleaf = 1;
CONST int kDwarfPine = 2;
CONST int kTreeKinds = 3;

// One tree.
struct Tree {
  int kind;      // kSpruce ..
  Real heightM;  // of the top above the foot; 0: none stands here
  Real radiusM;  // of the crown where it is widest
  Real turn;     // about its stem, in turns, [0, 1)
  Real leafy;    // from dark conifers to light leaves, [0, 1]: the hue
  Real tint;     // [0, 1): its own, the same as Crowns::tree
};

// Of a cell of the lattice, counted from anywhere as long as all count alike (wrapped at 2^32).
FN Uint treeBits(Uvec2 cell) {
  return latticeBits(cell.x * Uint(0x9e3779b1u), cell.y * Uint(0x85ebca77u));
}

// Where the stem is, metres from the cell's north-west corner along x and z.
FN Vec2 treeStem(Uint bits) {
  return (Vec2(Real(bits & Uint(0xffu)), Real((bits >> Uint(8u)) & Uint(0xffu))) * Real(0.0025) -
          Vec2(Real(0.32), Real(0.32))) * kTreeCellM;
}

// Noise on a lattice of so many cells to the side of a chunk. chunk: of level 0, wrapped to 20 bits with sign; insideM:
// metres from its corner, any sign, below 1e5.
FN Vec2 chunkNoise(Uvec2 chunk, Vec2 insideM, int perChunk) {
  Vec2 scaled = insideM * (Real(perChunk) / kChunkMetres);
  Vec2 whole = floor(scaled);
  return latticeNoise(chunk * Uint(perChunk) + Uvec2(Uint(int(whole.x)), Uint(int(whole.y))), scaled - whole);
}

FN Vec2 turnedChunkNoise(Uvec2 chunk, Vec2 insideM, int perChunk) {
  Vec2 scaled = insideM * (Real(perChunk) / kChunkMetres);
  Vec2 whole = floor(scaled);
  return turnedLatticeNoise(chunk * Uint(perChunk) + Uvec2(Uint(int(whole.x)), Uint(int(whole.y))), scaled - whole);
}

// What decides about woods at a place: the land's noise (terrain/land.glsl) without what is finer.
FN LandNoise woodNoise(Uvec2 chunk, Vec2 insideM) {
  Vec2 wide = chunkNoise(chunk, insideM, 1);
  Vec2 middle = turnedChunkNoise(chunk, insideM, 1);
  Vec2 fine = chunkNoise(chunk, insideM, 24);
  LandNoise noise;
  noise.region = wide.x * Real(0.7) + middle.y * Real(0.3);
  noise.grove = middle.x * Real(0.65) + fine.y * Real(0.35);
  noise.tuft = fine.x;
  noise.clod = Real(0.0);
  noise.grain = Real(0.0);
  return noise;
}

// The tree of a cell: heightM, normalUp and noise at its foot, as of forestDensity; share: of the woods' trees that there
// are, [0, 1]. The land's curvature does not count: the GPU has it from normals of 8 bits, which would make trees of a tenth
// of all edges grow or shrink. At the edge of woods trees are young, so a density that changes a little (a coarser level of
// detail) changes their size a little; none comes or goes at once.
FN Tree treeOf(Uint bits, Real heightM, Real normalUp, LandNoise noise, Real share) {
  Tree tree;
  tree.tint = Real(bits >> Uint(24u)) * Real(3.90625e-3);
  Real size = Real((bits >> Uint(16u)) & Uint(0xffu)) * Real(3.9215686e-3);
  Uint more = (bits ^ Uint(0x5bd1e995u)) * Uint(0x27d4eb2fu);
  more = more ^ (more >> Uint(15u));
  Real chance = Real(more & Uint(0xffu)) * Real(3.90625e-3);
  Real kept = Real((more >> Uint(8u)) & Uint(0xffu)) * Real(3.90625e-3);
  tree.turn = Real((more >> Uint(16u)) & Uint(0xffu)) * Real(3.90625e-3);
  Real broad = Real(more >> Uint(24u)) * Real(3.90625e-3);

  Real density = forestDensity(heightM, normalUp, Real(0.0), noise);
  Real margin = saturate((density * Real(1.1) - Real(0.05) - tree.tint) * Real(8.0));
  Real stands = kept < share ? margin * (Real(2.0) - margin) : Real(0.0);

  Real belt = beltHeight(heightM, noise);
  Real hue = leafiness(belt, noise);
  Real leaves = smoothRise(Real(0.20), Real(0.70), hue - Real(1.2) * (Real(1.0) - normalUp));
  bool isHigh = belt + Real(220.0) * (chance - Real(0.5)) > Real(640.0);
  bool isLeafy = broad < leaves;
  tree.kind = isHigh ? kDwarfPine : (isLeafy ? kBroadleaf : kSpruce);
  Real stunted = Real(1.0) - Real(0.5) * smoothRise(Real(330.0), Real(720.0), belt);
  Real tall = isHigh ? mix(Real(1.6), Real(4.2), size)
                     : (isLeafy ? mix(Real(8.0), Real(17.0), size) : mix(Real(11.0), Real(26.0), size)) * stunted;
  Real wide = isHigh ? mix(Real(0.42), Real(0.62), chance)
                     : (isLeafy ? mix(Real(0.27), Real(0.33), chance) : mix(Real(0.15), Real(0.20), chance));
  tree.heightM = tall * stands;
  tree.radiusM = min(tall * wide, kWidestCrownM) * stands;
  tree.leafy = mix(hue, isHigh ? Real(0.15) : (isLeafy ? Real(0.95) : Real(0.05)), Real(0.6));
  return tree;
}

// How wide a tree is at a height above its foot: what an aircraft would meet, m.
FN Real treeWidthAt(Tree tree, Real upM) {
  Real at = upM / max(tree.heightM, Real(1e-3));
  Real trunk = Real(0.02) * tree.heightM;
  Real t = (at - Real(0.62)) / Real(0.38);
  Real low = (at - Real(0.62)) / Real(0.36);
  Real dome = tree.radiusM * sqrt(max(Real(1.0) - (at > Real(0.62) ? t * t : low * low), Real(0.0)));
  Real cone = at > Real(0.12) ? tree.radiusM * (Real(1.0) - at) / Real(0.88) : Real(0.0);
  Real crown = tree.kind == kSpruce ? cone : dome;
  return at < Real(0.0) || at > Real(1.0) ? Real(0.0) : max(crown, trunk);
}
