#include "terrain/land_point.h"

#include <vector>

namespace skydrop::terrain {
namespace {

Jet<double> sumAt(const std::vector<Lattice>& lattices, glm::dvec2 xz) {
  Jet<double> total;
  double share = 1;
  for (const Lattice& lattice : lattices) {
    total = total + noiseAt(lattice, xz.x, xz.y) * share;
    share *= 0.5;
  }
  return total;
}

LandState<Jet<double>> uncarvedAt(const LandShape<double>& shape, const LandOctaves& octaves, glm::dvec2 xz) {
  LandFields<Jet<double>> fields{sumAt(octaves.continent, xz),
                                 sumAt(octaves.range, xz),
                                 sumAt(octaves.crest, xz),
                                 sumAt(octaves.valley, xz),
                                 {}};
  for (std::size_t i = 0; i < kHillOctaves; ++i) fields.hills[i] = noiseAt(octaves.hills[i], xz.x, xz.y);
  return shape.begin(fields);
}

Jet<double> gullyAt(const LandShape<double>& shape, const LandOctaves& octaves, std::size_t octave,
                    glm::dvec2 xz) {
  const Lattice& lattice = octaves.gullies[octave];
  const double x = xz.x / lattice.cell + lattice.offsetX, z = xz.y / lattice.cell + lattice.offsetZ;
  const double cellX = std::floor(x), cellZ = std::floor(z), u = x - cellX, w = z - cellZ;
  const auto i = static_cast<std::int64_t>(cellX), j = static_cast<std::int64_t>(cellZ);
  const auto corner = [&](bool east, bool south) {
    return gullyCorner(gullyNodeAt(shape, octaves, octave, i + (east ? 1 : 0), j + (south ? 1 : 0)), east,
                       south, w);
  };
  const Jet<double> cells =
      gullyBlend(corner(false, false), corner(true, false), corner(false, true), corner(true, true),
                 FadePlace<double>{u, fade(u), fadeSlope(u)}, FadePlace<double>{w, fade(w), fadeSlope(w)});
  const double metres = kGullies[octave].metres, perMetre = metres / lattice.cell;
  return {cells.v * metres, cells.x * perMetre, cells.z * perMetre};
}

// A thread's memory of nodes: the last one met of each slot. It belongs to the thread and not to a land,
// because it is used from const functions that any thread may call; what it holds is named by its land and is
// what would be made again, so that no result depends on it. 512 nodes take 60 KiB a thread.
struct KnownNode {
  std::uint64_t land = 0;  // LandOctaves::id; 0 is none
  std::size_t octave = 0;
  std::int64_t i = 0, j = 0;
  GullyNode<double> node{};
};
constexpr std::size_t kKnownNodes = 512;

}  // namespace

GullyNode<double> gullyNodeAt(const LandShape<double>& shape, const LandOctaves& octaves, std::size_t octave,
                              std::int64_t i, std::int64_t j) {
  thread_local std::vector<KnownNode> known(kKnownNodes);
  const std::size_t slot = (static_cast<std::size_t>(i & 7) | static_cast<std::size_t>(j & 7) << 3 |
                            octave << 6 | (octaves.id & 1) << 8) %
                           kKnownNodes;
  const KnownNode& k = known[slot];
  if (k.land == octaves.id && k.octave == octave && k.i == i && k.j == j) return k.node;

  const Lattice& lattice = octaves.gullies[octave];
  const glm::dvec2 xz{(static_cast<double>(i) - lattice.offsetX) * lattice.cell,
                      (static_cast<double>(j) - lattice.offsetZ) * lattice.cell};
  const LandState<Jet<double>> land = uncarvedAt(shape, octaves, xz);
  Jet<double> height = land.height;
  for (std::size_t coarser = 0; coarser < octave; ++coarser)
    height = height + gullyAt(shape, octaves, coarser, xz);
  const GullyNode<double> node =
      gullyNode(nodeBits(lattice.rowSeed(j), i), height.x, height.z, land.strength.v);
  known[slot] = {octaves.id, octave, i, j, node};
  return node;
}

Jet<double> landAt(const LandShape<double>& shape, const LandOctaves& octaves, glm::dvec2 xz) {
  LandState<Jet<double>> state = uncarvedAt(shape, octaves, xz);
  for (std::size_t octave = 0; octave < kGullies.size(); ++octave)
    state.height = state.height + gullyAt(shape, octaves, octave, xz);
  state.detail = sumAt(octaves.details, xz);
  return shape.finish(state);
}

}  // namespace skydrop::terrain
