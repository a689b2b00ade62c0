#include "terrain/land_point.h"

namespace skydrop::terrain {

Jet<double> landAt(const TerrainSettings& settings, const LandShape<double>& shape,
                   const LandOctaves& octaves, glm::dvec2 xz) {
  const auto sum = [&](const std::vector<Lattice>& lattices) {
    Jet<double> total;
    double share = 1;
    for (const Lattice& lattice : lattices) {
      total = total + noiseAt(lattice, xz.x, xz.y) * share;
      share *= 0.5;
    }
    return total;
  };
  LandState<Jet<double>> state =
      shape.begin(LandFields<Jet<double>>{sum(octaves.continent), sum(octaves.range), sum(octaves.valley)});
  for (std::size_t i = 0; i < octaves.relief.size(); ++i) {
    const int index = static_cast<int>(i);
    shape.octave(noiseAt(octaves.relief[i], xz.x, xz.y), ridgeShare(settings, index),
                 detailShare(settings, index), state);
  }
  return shape.finish(state);
}

}  // namespace skydrop::terrain
