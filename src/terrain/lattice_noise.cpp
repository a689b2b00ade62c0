#include "terrain/lattice_noise.h"

namespace skydrop::terrain {

Lattice makeLattice(double cell, std::uint64_t seed) {
  const std::uint64_t bits = core::mix64(seed ^ 0x6f63746176650000ull);
  const auto fraction = [](std::uint64_t b) { return static_cast<double>(b & 0xfffff) * 0x1p-20; };
  return {cell, fraction(bits), fraction(bits >> 32), seed};
}

Jet<double> noiseAt(const Lattice& lattice, double x, double z) {
  const double px = x / lattice.cell + lattice.offsetX;
  const double pz = z / lattice.cell + lattice.offsetZ;
  const double cellX = std::floor(px), cellZ = std::floor(pz);
  const double u = px - cellX, w = pz - cellZ;
  const auto i = static_cast<std::int64_t>(cellX), j = static_cast<std::int64_t>(cellZ);
  const std::uint64_t upper = lattice.rowSeed(j), lower = lattice.rowSeed(j + 1);
  const NodeGradient g00 = Lattice::node(upper, i), g10 = Lattice::node(upper, i + 1);
  const NodeGradient g01 = Lattice::node(lower, i), g11 = Lattice::node(lower, i + 1);

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
