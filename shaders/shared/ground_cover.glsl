// What stands on the ground near the eye: tufts, flowers, reeds, stones and boulders, by hash of the place. Four lattices,
// each with cells twice as wide as the one before, whose things are seen twice as far: so as many are in view at any distance.
// Pure functions of the place. Included after shared/woods.glsl.
#ifndef __cplusplus
#include "shared/woods.glsl"
#endif

CONST int kCoverLevels = 4;             // lattices
CONST Real kCoverCellM = Real(0.6);     // of the finest; one thing to a cell at most
CONST int kCoverCellsPerChunk = 1600;   // of the finest, along a side of a chunk of level 0
CONST Real kCoverCellsSeen = Real(34.0);  // from so many cells' widths a lattice is seen at density 1
CONST Real kTallestCoverM = Real(2.4);  // above the ground
CONST Real kWidestCoverM = Real(1.5);   // from the middle

CONST int kNoCover = -1;
CONST int kTuft = 0;
CONST int kFlowers = 1;
CONST int kReeds = 2;
CONST int kStone = 3;
CONST int kBoulder = 4;

// One of them.
struct Cover {
  int kind;      // kTuft ..
  Real heightM;  // above the ground
  Real radiusM;
  Real turn;     // about its middle, in turns, [0, 1)
  Real tint;     // its own, [0, 1)
  Real dry;      // from green to straw, [0, 1]
};

// What it grows on.
struct CoverSite {
  LandSurface land;  // without crowns and strata
  Real heightM;      // above the sea
  Real normalUp;     // upward part of the land's normal, [0, 1]
  Real wooded;       // forestDensity, [0, 1]
  Real region;       // noise of the land (LandNoise): over kilometres
  Real tuft;         // of tens of metres
  Vec2 patches;      // two of 8 m, each [-1, 1]
};

FN Real coverCellM(int level) {
  return kCoverCellM * Real(1 << level);
}

// How far the things of a lattice are seen, m. reachM: at most; density: GroundCoverSettings::density.
FN Real coverReach(int level, Real reachM, Real density) {
  return min(reachM, kCoverCellsSeen * sqrt(max(density, Real(0.0))) * coverCellM(level));
}

// The share of its size that a thing has at a distance, [0, 1]: each shrinks into the ground over a part of the reach of
// its lattice, at a distance of its own (own: [0, 1)).
FN Real coverGrown(Real distanceM, Real reachM, Real own) {
  Real end = reachM * (Real(0.55) + Real(0.45) * own);
  return smoothRise(end, end - max(Real(0.35) * reachM, Real(1e-6)), distanceM);
}

// Of a cell of a lattice, counted from anywhere as long as all count alike (wrapped at 2^32).
FN Uint coverBits(Uvec2 cell, int level) {
  return latticeBits(cell.x * Uint(0x9e3779b1u) + Uint(level) * Uint(0x632be59bu), cell.y * Uint(0x85ebca77u));
}

// Where in its cell it stands, in shares of the cell along x and z.
FN Vec2 coverStem(Uint bits) {
  return Vec2(Real(bits & Uint(0xffu)), Real((bits >> Uint(8u)) & Uint(0xffu))) * Real(0.0035) +
         Vec2(Real(0.05), Real(0.05));
}

// The share of a place on which reeds stand: in patches of the wet strip of gentle shores.
FN Real reedShare(CoverSite site) {
  return smoothRise(Real(-0.60), Real(-0.25), site.heightM) * smoothRise(Real(0.85), Real(0.35), site.heightM) *
         smoothRise(Real(0.965), Real(0.988), site.normalUp) *
         smoothRise(Real(0.02), Real(0.30), site.tuft * Real(0.6) + site.patches.x * Real(0.4));
}

// The share of a place that is meadow or heath.
FN Real grassShare(CoverSite site) {
  Real others = site.land.litter + site.land.scree + site.land.rock + site.land.sand + site.land.snow;
  return smoothRise(Real(0.35), Real(0.95), Real(1.0) - others) * smoothRise(Real(0.45), Real(0.10), site.wooded) *
         smoothRise(Real(0.62), Real(0.76), site.normalUp) * smoothRise(Real(0.4), Real(1.2), site.heightM);
}

// What stands in a cell. A share that changes a little changes its size a little: nothing comes or goes at once but for
// what turns from one kind to the next.
FN Cover coverOf(Uint bits, int level, CoverSite site) {
  Real size = Real((bits >> Uint(16u)) & Uint(0xffu)) * Real(3.9215686e-3);
  Uint more = (bits ^ Uint(0x5bd1e995u)) * Uint(0x27d4eb2fu);
  more = more ^ (more >> Uint(15u));
  Real chance = Real(more & Uint(0xffffu)) * Real(1.52587890625e-5);
  Cover cover;
  cover.turn = Real((more >> Uint(16u)) & Uint(0xffu)) * Real(3.90625e-3);
  cover.tint = Real(more >> Uint(24u)) * Real(3.90625e-3);

  Real grass = grassShare(site);
  Real larger = level == 0 ? Real(1.0) : (level == 1 ? Real(1.35) : (level == 2 ? Real(1.8) : Real(2.4)));
  Real wider = Real(1.0) + Real(0.40) * Real(level);  // the wide lattices have fewer that cover more
  Real stable = smoothRise(Real(0.50), Real(0.68), site.normalUp) *
                smoothRise(Real(-1.5), Real(-0.3), site.heightM);  // below that the water hides stones
  Real aside = smoothRise(Real(0.10), Real(0.50), site.patches.y);  // stones of a meadow lie together
  cover.dry = saturate(Real(0.36) + Real(0.40) * site.region + Real(0.30) * site.tuft + Real(0.30) * site.patches.y +
                       Real(0.55) * (cover.tint - Real(0.5)));

  Real reeds = Real(0.92) * reedShare(site);
  Real boulders = level < 2 ? Real(0.0)
                            : stable * (Real(0.26) * site.land.scree + Real(0.20) * site.land.rock +
                                        Real(0.05) * aside * grass);
  Real stones = stable * (Real(0.60) * site.land.scree + Real(0.34) * site.land.rock + Real(0.05) * site.land.sand +
                          (Real(0.006) + Real(0.06) * aside) * grass);
  Real flowers = grass * (level > 2 ? Real(0.0) : Real(0.55)) *
                 smoothRise(Real(0.02), Real(0.42), site.patches.x + Real(0.35) * site.tuft) *
                 (Real(1.0) - Real(0.7) * site.land.scree);
  Real tufts = grass * (Real(0.30) + Real(0.70) * smoothRise(Real(-0.55), Real(0.25), site.patches.y + Real(0.5) * site.tuft));

  Real a = reeds, b = a + boulders, c = b + stones * (Real(1.0) - a);
  Real d = c + flowers * (Real(1.0) - a), e = d + tufts * (Real(1.0) - a);
  cover.kind = chance < a ? kReeds : (chance < b ? kBoulder : (chance < c ? kStone : (chance < d ? kFlowers : kTuft)));
  Real upper = cover.kind == kReeds ? a
               : (cover.kind == kBoulder ? b : (cover.kind == kStone ? c : (cover.kind == kFlowers ? d : e)));
  Real margin = saturate((upper - chance) * Real(14.0));
  Real stands = margin * (Real(2.0) - margin);
  cover.kind = stands > Real(0.0) ? cover.kind : kNoCover;

  // Lush patches are taller; few are much taller than most.
  Real lush = saturate(Real(0.5) + Real(0.7) * site.patches.x + Real(0.3) * site.tuft);
  Real tuft = mix(Real(0.17), Real(0.46), size * size) * mix(Real(0.65), Real(1.40), lush);
  Real height = cover.kind == kReeds     ? mix(Real(1.0), Real(2.0), size)
                : cover.kind == kBoulder ? mix(Real(0.35), Real(0.95), size * size)
                : cover.kind == kStone   ? mix(Real(0.09), Real(0.30), size * size) * larger
                : cover.kind == kFlowers ? mix(Real(0.22), Real(0.46), size)
                                         : tuft * larger;
  Real wide = cover.kind == kReeds     ? mix(Real(0.20), Real(0.34), cover.tint)
              : cover.kind == kBoulder ? mix(Real(0.65), Real(1.0), cover.tint)
              : cover.kind == kStone   ? mix(Real(0.60), Real(0.95), cover.tint)
              : cover.kind == kFlowers ? mix(Real(0.9), Real(1.6), cover.tint) * wider
                                       : mix(Real(0.95), Real(1.40), cover.tint) * wider;
  cover.heightM = height * stands;
  cover.radiusM = min(height * wide, kWidestCoverM) * stands;
  return cover;
}
