// Smooth noise on an integer lattice for colours and ripples: exact far from the origin, because a place is a cell
// (whole numbers, wrapped at 2^32) and a position inside it.

// The last rounds of lowbias32 (Wellons, "Prospecting for Hash Functions", 2018) over the sum of both coordinates'
// products: half of the work of hash2, which matters in a shader that runs it sixteen times a pixel.
FN Uint latticeBits(Uint column, Uint row) {
  Uint bits = column + row;
  bits = bits ^ (bits >> Uint(16u));
  bits = bits * Uint(0x7feb352du);
  bits = bits ^ (bits >> Uint(15u));
  bits = bits * Uint(0x846ca68bu);
  return bits ^ (bits >> Uint(16u));
}

// Two values in [-1, 1] from 32 bits.
FN Vec2 signedPair(Uint bits) {
  return Vec2(Real(bits & Uint(0xffffu)), Real(bits >> Uint(16u))) * Real(3.0518043793392844e-5) -
         Vec2(Real(1.0), Real(1.0));
}

FN Real smoothStep5(Real t) { return t * t * t * (t * (t * Real(6.0) - Real(15.0)) + Real(10.0)); }

// Two independent values in [-1, 1] (value noise, mean 0) at a position [0, 1] in a cell.
FN Vec2 latticeNoise(Uvec2 cell, Vec2 inside) {
  Uint west = cell.x * Uint(0x9e3779b1u);
  Uint east = west + Uint(0x9e3779b1u);
  Uint north = cell.y * Uint(0x85ebca77u);
  Uint south = north + Uint(0x85ebca77u);
  Real u = smoothStep5(inside.x);
  Real v = smoothStep5(inside.y);
  return mix(mix(signedPair(latticeBits(west, north)), signedPair(latticeBits(east, north)), u),
             mix(signedPair(latticeBits(west, south)), signedPair(latticeBits(east, south)), u), v);
}

// The same on a lattice turned by the angle of the 3-4-5 triangle, whose cells are a fifth as wide: sums of both
// show no grid, and whole numbers stay whole.
FN Vec2 turnedLatticeNoise(Uvec2 cell, Vec2 inside) {
  Vec2 at = Vec2(Real(3.0) * inside.x + Real(4.0) * inside.y, Real(3.0) * inside.y - Real(4.0) * inside.x + Real(4.0));
  Vec2 whole = floor(at);
  Uvec2 turned = Uvec2(cell.x * Uint(3u) + cell.y * Uint(4u), cell.y * Uint(3u) - cell.x * Uint(4u));
  return latticeNoise(turned + Uvec2(Uint(whole.x), Uint(whole.y)), at - whole);
}
