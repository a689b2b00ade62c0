#include "skydrop/terrain/noise_height_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skydrop/core/settings_table.h"
#include "terrain/land_bounds.h"
#include "terrain/land_point.h"
#include "terrain/noise_chunk.h"
#include "terrain/noise_source.h"

namespace skydrop::terrain {
namespace {

// NaN becomes 0.
double insideWorld(double metres) {
  if (!(metres > -kWorldLimitMetres)) return metres == metres ? -kWorldLimitMetres : 0.0;
  return metres < kWorldLimitMetres ? metres : kWorldLimitMetres;
}
glm::dvec2 insideWorld(glm::dvec2 xz) { return {insideWorld(xz.x), insideWorld(xz.y)}; }

class NoiseHeightSource final : public HeightSource {
 public:
  NoiseHeightSource(const TerrainSettings& settings, LandOctaves octaves, const RowKernels& kernels)
      : shape_(settings), rowShape_(settings), octaves_(std::move(octaves)), kernels_(kernels) {}

  HeightSample sample(glm::dvec2 position) const override {
    const Jet<double> height = landAt(shape_, octaves_, insideWorld(position));
    return {height.v, {height.x, height.z}};
  }

  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    return landBounds(shape_, octaves_, insideWorld(lo), insideWorld(hi));
  }
  HeightBounds range() const override { return {storedRange().lowest, storedRange().highest}; }
  HeightRange storedRange() const override { return {}; }  // row_kernels.inl encodes over it

  bool fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const override {
    return fillNoiseChunk(rowShape_, octaves_, kernels_, key, stop, out, nullptr);
  }
  bool fillWideChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out,
                     std::vector<std::uint16_t>& wideHeights) const override {
    return fillNoiseChunk(rowShape_, octaves_, kernels_, key, stop, out, &wideHeights);
  }

 private:
  LandShape<double> shape_;
  LandShape<float> rowShape_;
  LandOctaves octaves_;
  const RowKernels& kernels_;
};

void requireInRange(TerrainSettings settings) {
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) core::setField(field, field.get());
}

}  // namespace

std::shared_ptr<const HeightSource> makeNoiseHeightSource(const TerrainSettings& settings, std::uint64_t seed,
                                                          const RowKernels& kernels) {
  requireInRange(settings);
  return std::make_shared<NoiseHeightSource>(settings, makeLandOctaves(settings, seed), kernels);
}

std::shared_ptr<const HeightSource> makeNoiseHeightSource(const TerrainSettings& settings,
                                                          std::uint64_t seed) {
  return makeNoiseHeightSource(settings, seed, bestRowKernels());
}

std::shared_ptr<const HeightSource> makeCoarsenedNoiseHeightSource(const TerrainSettings& settings,
                                                                   std::uint64_t seed,
                                                                   std::size_t detailOctaves) {
  requireInRange(settings);
  LandOctaves octaves = makeLandOctaves(settings, seed);
  octaves.details.resize(std::min(octaves.details.size(), detailOctaves));
  return std::make_shared<NoiseHeightSource>(settings, std::move(octaves), bestRowKernels());
}

}  // namespace skydrop::terrain
