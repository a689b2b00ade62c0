// Rills on the slopes (groundDetail): included with GROUND_DETAIL on rich land alone.
#include "shared/erosion_lines.glsl"

uniform float erosionDepth;  // of the rills, in units of the shipped one

// How many octaves a place shows, 1 at least.
int erosionCount(float strength, float footprint) {
  int count = 1;
  for (int i = 1; i < kErosionOctaves; ++i)
    count += strength > 0.0 && erosionShown(kChunkMetres / float(erosionCells(i)), footprint) > 0.0 ? 1 : 0;
  return count;
}

// wide: the land's normal over some metres, which a sample's own bumps do not turn.
Erosion erosionAt(LandSight sight, vec3 wide, LandNoise noise) {
  Erosion erosion = uneroded(wide.xz / max(wide.y, 0.1));
  float strength = erosionStrength(sight.normal.y, noise) * erosionDepth;
  int count = erosionCount(strength, sight.footprint);
  int i = 0;
  do {
    uvec2 cell;
    vec2 inside;
    int cells = erosionCells(i);
    latticeOf(sight.place, cells, cell, inside);
    erosion = eroded(erosion, i, cell, inside, kChunkMetres / float(cells), sight.footprint, strength);
    ++i;
  } while (i < count);
  return erosion;
}

// Water finds soft rock, and snow stays in its lines: the strata's hardness at a place, [-1, 1].
float erodedStrata(float strata, Erosion erosion) { return clamp(strata - 1.2 * erosion.cut, -1.0, 1.0); }

const vec3 kEarth = vec3(0.115, 0.092, 0.062);  // below grass

// Earth and stones lie bare where rills are cut, and less of the sky is seen from there. cut: mean 0, as the changes are.
LandSurface withRills(LandSurface land, float cut) {
  float bare = land.scree + land.rock;
  float grass = max(1.0 - bare - land.litter - land.sand - land.snow, 0.0) * (1.0 - land.wooded);
  land.albedo += (kEarth - land.albedo) * (0.7 * cut * grass);
  land.albedo *= 1.0 - 0.35 * cut * bare;
  land.open *= 1.0 - 0.35 * cut;
  land.scree += grass * 0.6 * saturate(cut);
  return land;
}
