// Gradient noise on an integer lattice (Perlin: Improving Noise, 2002, with its quintic fade), hashed with
// integers: no permutation table, no period within 2^63 cells, the same bits on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "skydrop/core/hash.h"
#include "terrain/jet.h"

namespace skydrop::terrain {

// The gradient that stands on a lattice node: a unit vector.
struct NodeGradient {
  float x, z;
};

// A direction from 64 random bits, uniform in angle within 0.05 %. Three bits pick the octant; within it the
// half-angle tangent parametrises the circle by rational functions, so no libm is needed.
SKYDROP_INLINE NodeGradient directionOf(std::uint64_t bits) {
  const float p = static_cast<float>(static_cast<std::int32_t>(bits >> 40) & 0xffffff) * 0x1p-24f;
  const float t = p * (0.392699f + p * p * 0.0215f);  // tan(p * pi / 8)
  const float scale = 1.0f / (1.0f + t * t);
  const float big = (1.0f - t * t) * scale;
  const float small = 2.0f * t * scale;
  const bool swap = (bits & 1) != 0;
  const float x = swap ? small : big;
  const float z = swap ? big : small;
  return {(bits & 2) != 0 ? -x : x, (bits & 4) != 0 ? -z : z};
}

// One octave's lattice. Cells are squares of `cell` metres (a power of two); the lattice is shifted so that
// octaves share no nodes. Positions of chunk samples in cells are then exact in double out to
// kWorldLimitMetres: a sample gets the same bits in whatever chunk and level it lies.
struct Lattice {
  double cell = 0;
  double offsetX = 0, offsetZ = 0;  // cells, multiples of 1/64 in [0, 1)
  std::uint64_t seed = 0;

  // The gradient of node (i, j) is directionOf(nodeBits(rowSeed(j), i)).
  std::uint64_t rowSeed(std::int64_t j) const {
    return core::hashCombine(seed, static_cast<std::uint64_t>(j));
  }
};

SKYDROP_INLINE std::uint64_t nodeBits(std::uint64_t rowSeed, std::int64_t i) {
  return core::hashCombine(rowSeed, static_cast<std::uint64_t>(i));
}

// The lattice of octave `index` (0 is the coarsest) in a chain in which each cell is half the one before.
Lattice makeLattice(double cell, int index, std::uint64_t seed);

// Largest absolute value of gradient noise with unit gradients: sqrt(1/2), reached in the middle of a cell
// whose four gradients point there. Noise is scaled by kNoiseScale to fill [-1, 1].
inline constexpr double kNoiseScale = 1.4142135623730951;

// Bounds over all positions and all choices of unit gradients (maximised on a grid of 400 x 400 positions and
// 36 directions; the true maxima are 2.927 and 13.07), for one cell of side 1 and kNoiseScale included.
inline constexpr double kNoiseSlopeLimit = 3.0;       // length of the gradient
inline constexpr double kNoiseCurvatureLimit = 13.5;  // second derivative in any direction

template <class R>
SKYDROP_INLINE R fade(R t) {
  return t * t * t * (t * (t * R(6) - R(15)) + R(10));
}
template <class R>
SKYDROP_INLINE R fadeSlope(R t) {
  const R s = t * (t - R(1));
  return R(30) * s * s;
}

// The noise of one octave at a point, in [-1, 1], with its gradient per metre.
Jet<double> noiseAt(const Lattice& lattice, double x, double z);

}  // namespace skydrop::terrain
