// Rills: lines that running water has cut down slopes of soil and debris, finer than the land's samples can carry. Each
// corner of a lattice has a wave whose crests run down the fall line, with a phase of its own; between corners the
// waves blend, and their sum is brought back to a wave of full height by that of their quadratures.
// Sources: Clay John, "Eroded Terrain Noise", 2020 (noise whose stripes follow the slope); Rune Skovbo Johansen, "Phacelle
// noise", 2025 (blends of waves that do not cancel).
#ifndef __cplusplus
#include "shared/lattice_noise.glsl"
#include "shared/land_material.glsl"
#endif

CONST int kErosionOctaves = 3;
CONST Real kErosionTurns = Real(1.5);       // of a wave to a cell
CONST Real kErosionFloor = Real(0.10);      // what the power of waves that cancel is taken for
CONST Real kErosionMeanCut = Real(0.277);   // measured (K09); of the profile alone, ((1 - cos) / 2)^3, 5/16

// Of an octave, the coarsest first: cells to the side of a chunk of level 0, and the depth of its rills, m.
FN int erosionCells(int octave) { return octave == 0 ? 12 : octave == 1 ? 36 : 108; }
FN Real erosionDepthM(int octave) { return octave == 0 ? Real(3.0) : octave == 1 ? Real(1.3) : Real(0.5); }

// Sums of the waves of a cell's corners, sine and cosine of their phase.
FN Vec2 erosionCorner(Uint bits, Vec2 offset, Vec2 across, Real weight) {
  Real phase = kErosionTurns * dot(offset, across) + Real(bits >> Uint(8u)) * Real(5.9604644775390625e-8);
  return Vec2(bandWave(phase).x, bandWave(phase + Real(0.25)).x) * weight;
}

// How deep a rill is cut at a position [0, 1] in a cell, from 0 on crests to 1 at its floor (x), and how that changes
// along `across`, 1 per cell (y). across: horizontal, of length 1 at most, at right angles to the fall line.
FN Vec2 erosionCut(Uvec2 cell, Vec2 inside, Vec2 across, Uint salt) {
  Uint west = cell.x * Uint(0x9e3779b1u) + salt;
  Uint east = west + Uint(0x9e3779b1u);
  Uint north = cell.y * Uint(0x85ebca77u);
  Uint south = north + Uint(0x85ebca77u);
  Real u = smoothStep5(inside.x), v = smoothStep5(inside.y);
  Vec2 back = inside - Vec2(Real(1.0), Real(1.0));
  Vec2 sum = erosionCorner(latticeBits(west, north), inside, across, (Real(1.0) - u) * (Real(1.0) - v)) +
             erosionCorner(latticeBits(east, north), Vec2(back.x, inside.y), across, u * (Real(1.0) - v)) +
             erosionCorner(latticeBits(west, south), Vec2(inside.x, back.y), across, (Real(1.0) - u) * v) +
             erosionCorner(latticeBits(east, south), back, across, u * v);
  sum = sum / sqrt(dot(sum, sum) + kErosionFloor);
  Real t = Real(0.5) - Real(0.5) * sum.y;
  // d/dphase of (1 - cos) / 2 is pi sin.
  return Vec2(t * t * t, Real(9.42477796) * t * t * sum.x * kErosionTurns);
}

// What of an octave is drawn where a pixel covers footprintM, [0, 1]: none where that is half a rill's spacing.
FN Real erosionShown(Real cellM, Real footprintM) {
  return saturate(Real(1.5) - Real(3.0) * footprintM * kErosionTurns / cellM);
}

// How strongly a slope is cut, [0, 1]: not on level ground, nor on cliffs, here more and there less. normalUp: upward part
// of the land's normal, [0, 1].
FN Real erosionStrength(Real normalUp, LandNoise noise) {
  return smoothRise(Real(0.985), Real(0.90), normalUp) * smoothRise(Real(0.45), Real(0.68), normalUp) *
         saturate(Real(0.62) + Real(0.9) * noise.grove + Real(0.5) * noise.tuft);
}

// What the octaves up to one add.
struct Erosion {
  Vec2 slope;  // of the surface along x and z, 1
  Vec2 fall;   // the way that water takes on the land with them: its downward slope along x and z
  Real cut;    // how deep the place lies in its rills, mean 0
};

// Of land whose downward slope along x and z is `fall`, without rills.
FN Erosion uneroded(Vec2 fall) {
  Erosion erosion;
  erosion.slope = Vec2(Real(0.0), Real(0.0));
  erosion.fall = fall;
  erosion.cut = Real(0.0);
  return erosion;
}

// With one octave more, whose rills run into those of the octaves before it. cell, inside: of its lattice; cellM: its
// side; footprintM: what a pixel covers; strength: [0, 1].
FN Erosion eroded(Erosion erosion, int octave, Uvec2 cell, Vec2 inside, Real cellM, Real footprintM, Real strength) {
  Vec2 fall = erosion.fall;
  Vec2 across = Vec2(-fall.y, fall.x) / sqrt(dot(fall, fall) + Real(1e-6));
  Vec2 cut = erosionCut(cell, inside, across, Uint(octave) * Uint(0x68bc21ebu));
  Real shown = erosionShown(cellM, footprintM) * strength;
  Vec2 rise = across * (-erosionDepthM(octave) * shown * cut.y / cellM);
  erosion.slope = erosion.slope + rise;
  erosion.fall = fall - rise;
  erosion.cut = erosion.cut + (cut.x - kErosionMeanCut) * shown;
  return erosion;
}
