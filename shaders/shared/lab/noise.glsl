// Random numbers and noise as the laboratory takes them apart. What the game uses whole (gradient_noise.glsl,
// cloud_noise.glsl) is used here too; what is here is what they are compared with, and their parts.
// Sources: Vivo and Lowe, "The Book of Shaders", 2015 (the fraction of a sine); Perlin, "Improving Noise", 2002; Worley,
// "A Cellular Texture Basis Function", 1996; Thomann, "Procedural Cloud Shader", BFH 2020, section 4.
#ifndef __cplusplus
#include "shared/hash.glsl"
#include "shared/gradient_noise.glsl"
#include "shared/cloud_noise.glsl"
#endif

// The fraction of a stretched sine, in [0, 1): as random as the sine is exact, which differs between processors.
FN Real sineRandom1(Real x, Real scale) { return fract(sin(x) * scale); }
FN Real sineRandom2(Vec2 p) {
  return sineRandom1(dot(p, Vec2(Real(12.9898), Real(78.233))), Real(43758.5453123));
}
FN Real sineRandom3(Vec3 p) {
  return sineRandom1(dot(p, Vec3(Real(12.9898), Real(78.233), Real(37.719))), Real(43758.5453123));
}

// The same by integer hashes of cells: the same bits everywhere.
FN Real hashRandom2(Uvec2 cell) { return unitOf(hash2(cell).x); }
FN Real hashRandom3(Uvec3 cell) { return unitOf(hash3(cell).x); }

// Perlin's noise of the plane in its parts. The gradient at a node, as gradientNoise2 has it.
FN Vec2 nodeGradient(Uvec2 node, Uint salt) {
  Uint bits = latticeBits(node.x * kColumnStride, node.y * kRowStride + salt);
  return Vec2(planeGradientX(bits), planeGradientY(bits));
}

// The dot products of the four corners' gradients with the ways from them: (0,0), (1,0), (0,1), (1,1).
FN Vec4 cornerInfluences(Uvec2 cell, Vec2 inside, Uint cells, Uint salt) {
  Uint x = cellAfter(cell.x, cells);
  Uint y = cellAfter(cell.y, cells);
  Vec2 back = inside - Vec2(Real(1.0), Real(1.0));
  return Vec4(dot(nodeGradient(cell, salt), inside), dot(nodeGradient(Uvec2(x, cell.y), salt), Vec2(back.x, inside.y)),
              dot(nodeGradient(Uvec2(cell.x, y), salt), Vec2(inside.x, back.y)),
              dot(nodeGradient(Uvec2(x, y), salt), back));
}

// How much each corner counts; they add up to 1.
FN Vec4 cornerWeights(Vec2 inside, bool faded) {
  Real u = faded ? smoothStep5(inside.x) : inside.x;
  Real v = faded ? smoothStep5(inside.y) : inside.y;
  Real a = Real(1.0) - u;
  Real b = Real(1.0) - v;
  return Vec4(a * b, u * b, a * v, u * v);
}

FN Real perlinOfParts(Uvec2 cell, Vec2 inside, Uint cells, Uint salt, bool faded) {
  return dot(cornerInfluences(cell, inside, cells, salt), cornerWeights(inside, faded));
}

// The same in space without the fade: seven interpolations between eight corners.
FN Real spaceNode(Uvec3 node, Vec3 way, Uint salt) {
  Uint bits = latticeBits(node.x * kColumnStride, node.y * kRowStride + salt + node.z * kSliceStride);
  return spaceGradientX(bits) * way.x + spaceGradientY(bits) * way.y + spaceGradientZ(bits) * way.z;
}
FN Real perlinInSpaceOfParts(Uvec3 cell, Vec3 inside, Uint cells, Uint salt, bool faded) {
  Vec3 weight = inside;
  if (faded) weight = Vec3(smoothStep5(inside.x), smoothStep5(inside.y), smoothStep5(inside.z));
  Real sum = Real(0.0);
  for (Uint i = Uint(0u); i < Uint(8u); ++i) {
    bool x = (i & Uint(1u)) != Uint(0u);
    bool y = (i & Uint(2u)) != Uint(0u);
    bool z = (i & Uint(4u)) != Uint(0u);
    Uvec3 node = Uvec3(x ? cellAfter(cell.x, cells) : cell.x, y ? cellAfter(cell.y, cells) : cell.y,
                       z ? cellAfter(cell.z, cells) : cell.z);
    Vec3 way = inside - Vec3(x ? Real(1.0) : Real(0.0), y ? Real(1.0) : Real(0.0), z ? Real(1.0) : Real(0.0));
    Real share = (x ? weight.x : Real(1.0) - weight.x) * (y ? weight.y : Real(1.0) - weight.y) *
                 (z ? weight.z : Real(1.0) - weight.z);
    sum += share * spaceNode(node, way, salt);
  }
  return sum;
}

// A place in periods, [0, 1), as a cell and what is inside it.
FN Real perlinPlane(Vec2 place, Uint cells, Uint salt) {
  Vec2 at = place * Real(cells);
  Vec2 whole = floor(at);
  return gradientNoise2(Uvec2(Uint(whole.x), Uint(whole.y)), at - whole, cells, salt);
}
FN Real perlinSpace(Vec3 place, Uint cells, Uint salt) {
  Vec3 at = place * Real(cells);
  Vec3 whole = floor(at);
  return gradientNoise3(Uvec3(Uint(whole.x), Uint(whole.y), Uint(whole.z)), at - whole, cells, salt);
}

// The seed of a Voronoi cell, in [0, 1) of it: as worley2 has it.
FN Vec2 voronoiSeed(Uint x, Uint y, Uint salt) {
  Uvec3 bits = pointBits(x, y, Uint(0u), salt);
  return Vec2(unitOf(bits.x), unitOf(bits.y));
}

// Distance to a seed, in cells: to that of the place's own cell alone, which leaves the grid to be seen, and to the
// nearest of nine (worley2, turned over).
FN Real ownVoronoi(Vec2 place, Uint cells, Uint salt) {
  Vec2 at = place * Real(cells);
  Vec2 whole = floor(at);
  return length(at - whole - voronoiSeed(Uint(whole.x), Uint(whole.y), salt));
}
FN Real nearVoronoi(Vec2 place, Uint cells, Uint salt) {
  return (Real(1.0) - worley2(place, cells, salt)) * Real(1.4142135623730951);
}

// What is left of a cell's number by a period: truncated, as most processors divide, it is negative for negative cells and
// no longer that of the cell a period further on; floored it is within the period.
FN int truncatedRemainder(int cell, int period) { return cell - period * int(Real(cell) / Real(period)); }
FN int flooredRemainder(int cell, int period) {
  int left = truncatedRemainder(cell, period);
  return left < 0 ? left + period : left;
}

// Voronoi noise that repeats after `period` cells, of any sign. |place| below 1e6.
FN Real tiledVoronoi(Vec2 at, int period, Uint salt, bool mended) {
  Vec2 whole = floor(at);
  Real nearest = Real(9.0);
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      int x = int(whole.x) + i;
      int y = int(whole.y) + j;
      Vec2 seed = mended ? voronoiSeed(Uint(flooredRemainder(x, period)), Uint(flooredRemainder(y, period)), salt)
                         : voronoiSeed(Uint(truncatedRemainder(x, period)), Uint(truncatedRemainder(y, period)), salt);
      Vec2 apart = Vec2(Real(i), Real(j)) + seed - (at - whole);
      nearest = min(nearest, dot(apart, apart));
    }
  }
  return sqrt(nearest);
}

// Sums of octaves, each of twice the frequency and `gain` times the weight, over the sum of the weights. Of Perlin noise
// around 0, of Voronoi noise the distance.
FN Real perlinFractal(Vec2 place, Uint cells, Uint octaves, Real gain, Uint salt) {
  Real sum = Real(0.0);
  Real weights = Real(0.0);
  Real weight = Real(1.0);
  for (Uint i = Uint(0u); i < octaves; ++i) {
    sum += weight * perlinPlane(place, cells, salt + i);
    weights += weight;
    weight *= gain;
    cells = cells * Uint(2u);
  }
  return weights > Real(0.0) ? sum / weights : Real(0.0);
}
FN Real voronoiFractal(Vec2 place, Uint cells, Uint octaves, Real gain, Uint salt) {
  Real sum = Real(0.0);
  Real weights = Real(0.0);
  Real weight = Real(1.0);
  for (Uint i = Uint(0u); i < octaves; ++i) {
    sum += weight * nearVoronoi(place, cells, salt + i);
    weights += weight;
    weight *= gain;
    cells = cells * Uint(2u);
  }
  return weights > Real(0.0) ? sum / weights : Real(0.0);
}
