#include "terrain/lattice_noise.h"

namespace skydrop::terrain {

namespace {

// Gradient noise is 0 at its nodes and has least variance around them. These offsets, in 64ths of a cell,
// were searched so that at the nodes of any octave of a chain the sum of the others has the variance that it
// has elsewhere, within 0.3 % (hard case T22). From the sixth octave on, two take turns.
struct Offset {
  int x, z;
};
constexpr Offset kOffsets[] = {{21, 43}, {21, 15}, {63, 37}, {41, 3}, {39, 13}, {57, 19}, {7, 45}};

}  // namespace

Lattice makeLattice(double cell, int index, std::uint64_t seed) {
  const Offset& offset = kOffsets[index < 7 ? index : 5 + (index + 1) % 2];
  return {cell, offset.x / 64.0, offset.z / 64.0, seed};
}

Jet<double> noiseAt(const Lattice& lattice, double x, double z) {
  const double px = x / lattice.cell + lattice.offsetX;
  const double pz = z / lattice.cell + lattice.offsetZ;
  const double cellX = std::floor(px), cellZ = std::floor(pz);
  const double u = px - cellX, w = pz - cellZ;
  const auto i = static_cast<std::int64_t>(cellX), j = static_cast<std::int64_t>(cellZ);
  const std::uint64_t upper = lattice.rowSeed(j), lower = lattice.rowSeed(j + 1);
  const NodeGradient g00 = directionOf(nodeBits(upper, i)), g10 = directionOf(nodeBits(upper, i + 1));
  const NodeGradient g01 = directionOf(nodeBits(lower, i)), g11 = directionOf(nodeBits(lower, i + 1));

  const double fx = fade(u), fz = fade(w), dfx = fadeSlope(u), dfz = fadeSlope(w);
  // Left and right lattice column at this z: value a + slope b along x, and their derivatives by z.
  const auto column = [&](NodeGradient g0, NodeGradient g1, double& a, double& b, double& az, double& bz) {
    const double top = g0.z * w, bottom = g1.z * (w - 1);
    a = top + fz * (bottom - top);
    b = g0.x + fz * (double{g1.x} - g0.x);
    az = g0.z + fz * (double{g1.z} - g0.z) + dfz * (bottom - top);
    bz = dfz * (double{g1.x} - g0.x);
  };
  double a0, b0, az0, bz0, a1, b1, az1, bz1;
  column(g00, g01, a0, b0, az0, bz0);
  column(g10, g11, a1, b1, az1, bz1);
  const double left = a0 + b0 * u, right = a1 + b1 * (u - 1);
  const double leftZ = az0 + bz0 * u, rightZ = az1 + bz1 * (u - 1);
  const double perMetre = kNoiseScale / lattice.cell;
  return {kNoiseScale * (left + fx * (right - left)), perMetre * (b0 + fx * (b1 - b0) + dfx * (right - left)),
          perMetre * (leftZ + fx * (rightZ - leftZ))};
}

}  // namespace skydrop::terrain
