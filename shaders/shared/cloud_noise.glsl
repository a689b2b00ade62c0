// The noise that clouds are made of: three periodic textures of values in [0, 1]. One definition for the compute
// shader and for C++; noise_scripts/ repeats it in Python and a test holds the three together. A place is in periods,
// [0, 1) in each direction; lattice cells are counted modulo an octave's number of cells, so every texture tiles. Only
// + - * /, floor and sqrt: the same bits wherever arithmetic is IEEE's.
// Sources: Worley, "A Cellular Texture Basis Function", 1996; Perlin, "Improving Noise", 2002; Schneider and Vos, "The
// Real-Time Volumetric Cloudscapes of Horizon Zero Dawn", 2015 (Perlin-Worley, and what the channels hold).
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/lattice_noise.glsl"
#endif

// Keep the textures, and the worlds of different seeds, apart.
CONST Uint kShapeSalt = Uint(0x5f3759dfu);
CONST Uint kDetailSalt = Uint(0x2545f491u);
CONST Uint kWeatherSalt = Uint(0x9e3779b9u);
CONST Uint kSeedStride = Uint(0x85ebca6bu);

FN Vec3 units(Uvec3 bits) { return Vec3(unitOf(bits.x), unitOf(bits.y), unitOf(bits.z)); }

// Random bits of a lattice point; its coordinates lie in a period already.
FN Uvec3 pointBits(Uint x, Uint y, Uint z, Uint salt) {
  return hash3(Uvec3(x + salt, y + salt * Uint(3u), z + salt * Uint(7u)));
}

// The next cell, counted modulo a period.
FN Uint nextCell(Uint cell, Uint cells) { return cell + Uint(1u) == cells ? Uint(0u) : cell + Uint(1u); }
FN Uint cellBefore(Real whole, Uint cells) { return whole < Real(0.5) ? cells - Uint(1u) : Uint(whole) - Uint(1u); }

// Worley noise, inverted: 1 at the feature points (one to a cell), 0 a cell's diagonal away from the nearest.
FN Real worley3(Vec3 place, Uint cells, Uint salt) {
  Vec3 at = place * Real(cells);
  Vec3 whole = floor(at);
  Vec3 inside = at - whole + Vec3(Real(1.0), Real(1.0), Real(1.0));
  Real nearest = Real(3.0);
  Uint z = cellBefore(whole.z, cells);
  for (Uint k = Uint(0u); k < Uint(3u); ++k) {
    Uint y = cellBefore(whole.y, cells);
    for (Uint j = Uint(0u); j < Uint(3u); ++j) {
      Uint x = cellBefore(whole.x, cells);
      for (Uint i = Uint(0u); i < Uint(3u); ++i) {
        Vec3 apart = Vec3(Real(i), Real(j), Real(k)) + units(pointBits(x, y, z, salt)) - inside;
        nearest = min(nearest, dot(apart, apart));
        x = nextCell(x, cells);
      }
      y = nextCell(y, cells);
    }
    z = nextCell(z, cells);
  }
  return Real(1.0) - sqrt(nearest / Real(3.0));
}

FN Real worley2(Vec2 place, Uint cells, Uint salt) {
  Vec2 at = place * Real(cells);
  Vec2 whole = floor(at);
  Vec2 inside = at - whole + Vec2(Real(1.0), Real(1.0));
  Real nearest = Real(2.0);
  Uint y = cellBefore(whole.y, cells);
  for (Uint j = Uint(0u); j < Uint(3u); ++j) {
    Uint x = cellBefore(whole.x, cells);
    for (Uint i = Uint(0u); i < Uint(3u); ++i) {
      Uvec3 bits = pointBits(x, y, Uint(0u), salt);
      Vec2 apart = Vec2(Real(i) + unitOf(bits.x), Real(j) + unitOf(bits.y)) - inside;
      nearest = min(nearest, dot(apart, apart));
      x = nextCell(x, cells);
    }
    y = nextCell(y, cells);
  }
  return Real(1.0) - sqrt(nearest / Real(2.0));
}

// The product of a lattice point's gradient (components in [-1, 1]) and the way from it.
FN Real slopeFrom(Uvec3 bits, Real x, Real y, Real z) {
  Vec3 gradient = units(bits) * Real(2.0) - Vec3(Real(1.0), Real(1.0), Real(1.0));
  return dot(gradient, Vec3(x, y, z));
}

// Gradient noise with the fade 6 t^5 - 15 t^4 + 10 t^3: mean 0, standard deviation about .3.
FN Real perlin3(Vec3 place, Uint cells, Uint salt) {
  Vec3 at = place * Real(cells);
  Vec3 whole = floor(at);
  Vec3 a = at - whole;
  Vec3 b = a - Vec3(Real(1.0), Real(1.0), Real(1.0));
  Uint x0 = Uint(whole.x);
  Uint y0 = Uint(whole.y);
  Uint z0 = Uint(whole.z);
  Uint x1 = nextCell(x0, cells);
  Uint y1 = nextCell(y0, cells);
  Uint z1 = nextCell(z0, cells);
  Real u = smoothStep5(a.x);
  Real v = smoothStep5(a.y);
  Real south = mix(slopeFrom(pointBits(x0, y0, z0, salt), a.x, a.y, a.z),
                   slopeFrom(pointBits(x1, y0, z0, salt), b.x, a.y, a.z), u);
  Real north = mix(slopeFrom(pointBits(x0, y1, z0, salt), a.x, b.y, a.z),
                   slopeFrom(pointBits(x1, y1, z0, salt), b.x, b.y, a.z), u);
  Real low = mix(south, north, v);
  south = mix(slopeFrom(pointBits(x0, y0, z1, salt), a.x, a.y, b.z),
              slopeFrom(pointBits(x1, y0, z1, salt), b.x, a.y, b.z), u);
  north = mix(slopeFrom(pointBits(x0, y1, z1, salt), a.x, b.y, b.z),
              slopeFrom(pointBits(x1, y1, z1, salt), b.x, b.y, b.z), u);
  return mix(low, mix(south, north, v), smoothStep5(a.z));
}

// Four octaves of halving weight, in [0, 1] with mean .5.
FN Real perlinFbm3(Vec3 place, Uint cells, Uint salt) {
  Real sum = perlin3(place, cells, salt) + Real(0.5) * perlin3(place, cells * Uint(2u), salt) +
             Real(0.25) * perlin3(place, cells * Uint(4u), salt) + Real(0.125) * perlin3(place, cells * Uint(8u), salt);
  return saturate(Real(0.5) + Real(0.75) * sum);
}

// Perlin noise lifted onto Worley's billows: remap(perlin, 0, 1, worley, 1).
FN Real perlinWorley(Real perlin, Real worley) { return worley + perlin * (Real(1.0) - worley); }

// A range that noise fills, stretched to [0, 1]: bytes are not wasted on values that never occur.
FN Real filled(Real x, Real low, Real high) { return saturate((x - low) / (high - low)); }

// Low frequency: Perlin-Worley, and Worley fBm at 8, 16 and 32 cells.
FN Vec4 cloudShapeNoise(Vec3 place, Uint seed) {
  Uint salt = kShapeSalt + seed * kSeedStride;
  Real w4 = worley3(place, Uint(4u), salt);
  Real w8 = worley3(place, Uint(8u), salt);
  Real w16 = worley3(place, Uint(16u), salt);
  Real w32 = worley3(place, Uint(32u), salt);
  Real w64 = worley3(place, Uint(64u), salt);
  Real billows = Real(0.625) * w4 + Real(0.25) * w8 + Real(0.125) * w16;
  return Vec4(filled(perlinWorley(perlinFbm3(place, Uint(4u), salt), billows), Real(0.66), Real(1.0)),
              filled(Real(0.625) * w8 + Real(0.25) * w16 + Real(0.125) * w32, Real(0.5), Real(0.9)),
              filled(Real(0.625) * w16 + Real(0.25) * w32 + Real(0.125) * w64, Real(0.5), Real(0.9)),
              filled(Real(0.75) * w32 + Real(0.25) * w64, Real(0.5), Real(0.9)));
}

// High frequency: Worley fBm at 2, 4 and 8 cells; the fourth channel is 1.
FN Vec4 cloudDetailNoise(Vec3 place, Uint seed) {
  Uint salt = kDetailSalt + seed * kSeedStride;
  Real w2 = worley3(place, Uint(2u), salt);
  Real w4 = worley3(place, Uint(4u), salt);
  Real w8 = worley3(place, Uint(8u), salt);
  Real w16 = worley3(place, Uint(16u), salt);
  return Vec4(filled(Real(0.625) * w2 + Real(0.25) * w4 + Real(0.125) * w8, Real(0.5), Real(0.9)),
              filled(Real(0.625) * w4 + Real(0.25) * w8 + Real(0.125) * w16, Real(0.5), Real(0.9)),
              filled(Real(0.75) * w8 + Real(0.25) * w16, Real(0.5), Real(0.9)), Real(1.0));
}

// The weather map: coverage, precipitation, type (0 stratus, .5 stratocumulus, 1 cumulus); the fourth channel is 1.
FN Vec4 cloudWeatherNoise(Vec2 place, Uint seed) {
  Uint salt = kWeatherSalt + seed * kSeedStride;
  Vec3 level = Vec3(place.x, place.y, Real(0.0));
  Real cells = Real(0.625) * worley2(place, Uint(12u), salt) + Real(0.25) * worley2(place, Uint(24u), salt) +
               Real(0.125) * worley2(place, Uint(48u), salt);
  Real wide = perlinFbm3(level, Uint(5u), salt);
  Real coverage = filled(Real(0.55) * wide + Real(0.45) * cells, Real(0.4), Real(0.8));
  Real type = filled(perlinFbm3(level, Uint(3u), salt + Uint(101u)), Real(0.19), Real(0.81));
  Real wet = filled(coverage + Real(0.5) * wide, Real(0.8), Real(1.3));
  return Vec4(coverage, wet, type, Real(1.0));
}
