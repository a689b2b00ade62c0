// Smooth noise on an integer lattice for colours and ripples: exact far from the origin, because a place is a cell
// (whole numbers, wrapped at 2^32) and a position inside it.
#ifndef __cplusplus
#include "shared/hash.glsl"
#include "shared/lattice.glsl"
#endif

// Two gradients from 32 bits, each along `offset` (from the node, in cells): the components are bytes in [-1, 1].
FN Vec2 gradientPair(Uint bits, Vec2 offset) {
  Vec2 first = Vec2(Real(bits & Uint(0xffu)), Real((bits >> Uint(8u)) & Uint(0xffu)));
  Vec2 second = Vec2(Real((bits >> Uint(16u)) & Uint(0xffu)), Real(bits >> Uint(24u)));
  Vec2 sums = Vec2(dot(first, offset), dot(second, offset)) * Real(7.843137254901961e-3);
  Real middle = offset.x + offset.y;
  return sums - Vec2(middle, middle);
}

// Two independent values (gradient noise: Perlin, "Improving Noise", 2002) at a position [0, 1] in a cell: mean 0,
// standard deviation about .3, nearly always inside [-1, 1]. Noise of values instead of gradients shows its squares.
FN Vec2 latticeNoise(Uvec2 cell, Vec2 inside) {
  Uint west = cell.x * Uint(0x9e3779b1u);
  Uint east = west + Uint(0x9e3779b1u);
  Uint north = cell.y * Uint(0x85ebca77u);
  Uint south = north + Uint(0x85ebca77u);
  Real u = smoothStep5(inside.x);
  Real v = smoothStep5(inside.y);
  Vec2 back = inside - Vec2(Real(1.0), Real(1.0));
  Vec2 northSide = mix(gradientPair(latticeBits(west, north), inside),
                       gradientPair(latticeBits(east, north), Vec2(back.x, inside.y)), u);
  Vec2 southSide = mix(gradientPair(latticeBits(west, south), Vec2(inside.x, back.y)),
                       gradientPair(latticeBits(east, south), back), u);
  return mix(northSide, southSide, v) * Real(1.6);
}

// The same on a lattice turned by the angle of the 3-4-5 triangle, whose cells are a fifth as wide: sums of both
// show no grid, and whole numbers stay whole.
FN Vec2 turnedLatticeNoise(Uvec2 cell, Vec2 inside) {
  Vec2 at = Vec2(Real(3.0) * inside.x + Real(4.0) * inside.y, Real(3.0) * inside.y - Real(4.0) * inside.x + Real(4.0));
  Vec2 whole = floor(at);
  Uvec2 turned = Uvec2(cell.x * Uint(3u) + cell.y * Uint(4u), cell.y * Uint(3u) - cell.x * Uint(4u));
  return latticeNoise(turned + Uvec2(Uint(whole.x), Uint(whole.y)), at - whole);
}

// What one corner of a simplex gives to simplexNoise: slope along x, y, z and value. `offset` is from the corner.
FN Vec4 simplexCorner(Uint bits, Vec3 offset) {
  Vec3 gradient = Vec3(Real(bits & Uint(0xffu)), Real((bits >> Uint(8u)) & Uint(0xffu)),
                       Real((bits >> Uint(16u)) & Uint(0xffu))) * Real(7.843137254901961e-3) -
                  Vec3(Real(1.0), Real(1.0), Real(1.0));
  Real t = max(Real(0.5) - dot(offset, offset), Real(0.0));
  Real t3 = t * t * t;
  Real along = dot(gradient, offset);
  Vec3 slope = gradient * (t3 * t) - offset * (Real(8.0) * t3 * along);
  return Vec4(slope.x, slope.y, slope.z, t3 * t * along);
}

// Noise in space with its slope, for surfaces of any inclination: Perlin's simplex noise (after Gustavson, "Simplex
// noise demystified", 2005), four corners where a cubic lattice has eight. `corner` is a point of the skewed lattice
// (place + sum of place / 3 along each axis), `place` the position from there in cells, any sign, below 1e5. Slope
// (xyz, per cell) and value (w): mean 0, standard deviation of the value about .3, within [-1.2, 1.2].
FN Vec4 simplexNoise(Uvec3 corner, Vec3 place) {
  Real skew = (place.x + place.y + place.z) / Real(3.0);
  Vec3 cell = floor(place + Vec3(skew, skew, skew));
  Real back = (cell.x + cell.y + cell.z) / Real(6.0);
  Vec3 a = place - cell + Vec3(back, back, back);
  // The axes by size: the longest is walked first.
  Real xy = a.x >= a.y ? Real(1.0) : Real(0.0);
  Real yz = a.y >= a.z ? Real(1.0) : Real(0.0);
  Real zx = a.z > a.x ? Real(1.0) : Real(0.0);
  Vec3 first = Vec3(xy * (Real(1.0) - zx), yz * (Real(1.0) - xy), zx * (Real(1.0) - yz));
  Vec3 second = Vec3(max(xy, Real(1.0) - zx), max(yz, Real(1.0) - xy), max(zx, Real(1.0) - yz));
  Uint px = Uint(0x9e3779b1u);
  Uint py = Uint(0xc2b2ae3du);
  Uint pz = Uint(0x85ebca77u);
  Uint none = Uint(0u);
  Uint root = (corner.x + Uint(int(cell.x))) * px + (corner.y + Uint(int(cell.y))) * py;
  Uint row = (corner.z + Uint(int(cell.z))) * pz;
  Uint toFirst = (first.x > Real(0.5) ? px : none) + (first.y > Real(0.5) ? py : none) +
                 (first.z > Real(0.5) ? pz : none);
  Uint toSecond = (second.x > Real(0.5) ? px : none) + (second.y > Real(0.5) ? py : none) +
                  (second.z > Real(0.5) ? pz : none);
  Vec3 sixth = Vec3(Real(1.0), Real(1.0), Real(1.0)) / Real(6.0);
  Vec4 sum = simplexCorner(latticeBits(root, row), a) +
             simplexCorner(latticeBits(root + toFirst, row), a - first + sixth) +
             simplexCorner(latticeBits(root + toSecond, row), a - second + sixth * Real(2.0)) +
             simplexCorner(latticeBits(root + px + py + pz, row), a - sixth * Real(3.0));
  return sum * Real(75.0);
}
