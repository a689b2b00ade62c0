#include "skydrop/terrain/chunk_data.h"

#include <algorithm>
#include <cmath>

namespace skydrop::terrain {

glm::dvec3 normalOf(const HeightSample& sample) {
  const double scale =
      1.0 / std::sqrt(sample.gradient.x * sample.gradient.x + sample.gradient.y * sample.gradient.y + 1.0);
  return {-sample.gradient.x * scale, scale, -sample.gradient.y * scale};
}

std::uint16_t encodeNormal(glm::dvec2 gradient) {
  // With the normal (-gx, 1, -gz): s scales with it, so it need not be normalised.
  const double x = -gradient.x, z = -gradient.y;
  const double scale = 127.0 / (std::abs(x) + 1.0 + std::abs(z));
  // Both are above 0, where a cast rounds down.
  const auto low = static_cast<unsigned>((x + z) * scale + 128.5);
  const auto high = static_cast<unsigned>((x - z) * scale + 128.5);
  return static_cast<std::uint16_t>(low | high << 8);
}

glm::dvec3 decodeNormal(std::uint16_t code) {
  const double e0 = ((code & 0xff) - 128) / 127.0, e1 = ((code >> 8) - 128) / 127.0;
  const double x = 0.5 * (e0 + e1), z = 0.5 * (e0 - e1);
  const double y = 1.0 - std::abs(x) - std::abs(z);
  const double scale = 1.0 / std::sqrt(x * x + y * y + z * z);
  return {x * scale, y * scale, z * scale};
}

bool HeightSource::fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const {
  const glm::dvec2 origin = chunkOrigin(key);
  const double cell = cellMetres(key.level);
  const int reach = normalReach(key.level);
  const auto isInside = [](int i) { return i >= 0 && i < kChunkSamples; };
  for (int row = -reach; row < kChunkSamples + reach; ++row) {
    if (stop.stop_requested()) return false;
    for (int column = -reach; column < kChunkSamples + reach; ++column) {
      const HeightSample s = sample(origin + glm::dvec2(column, row) * cell);
      out.normals[static_cast<std::size_t>(normalIndex(column, row))] = encodeNormal(s.gradient);
      if (!isInside(row) || !isInside(column)) continue;
      out.heights[static_cast<std::size_t>(sampleIndex(column, row))] = out.heightRange.encode(s.height);
    }
  }
  return true;
}

bool HeightSource::fillWideChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out,
                                 std::vector<std::uint16_t>& wideHeights) const {
  if (!fillChunk(key, stop, out)) return false;
  const glm::dvec2 origin = chunkOrigin(key);
  const double cell = cellMetres(key.level);
  const int reach = normalReach(key.level), side = kChunkSamples + 2 * reach;
  wideHeights.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  auto* code = wideHeights.data();
  for (int row = -reach; row < kChunkSamples + reach; ++row) {
    if (stop.stop_requested()) return false;
    const bool isInRow = row >= 0 && row < kChunkSamples;
    for (int column = -reach; column < kChunkSamples + reach; ++column, ++code) {
      const bool isInside = isInRow && column >= 0 && column < kChunkSamples;
      *code = isInside ? out.heights[static_cast<std::size_t>(sampleIndex(column, row))]
                       : out.heightRange.encode(height(origin + glm::dvec2(column, row) * cell));
    }
  }
  return true;
}

ChunkData makeChunk(const HeightSource& source, const ChunkKey& key, std::stop_token stop) {
  ChunkData chunk;
  chunk.key = key;
  chunk.heightRange = source.storedRange();
  chunk.heights.resize(static_cast<std::size_t>(kChunkSamples) * kChunkSamples);
  chunk.normals.resize(static_cast<std::size_t>(kNormalSide) * kNormalSide);
  if (!source.fillChunk(key, stop, chunk)) {
    chunk.heights.clear();
    chunk.normals.clear();
    return chunk;
  }
  const auto [lowest, highest] = std::minmax_element(chunk.heights.begin(), chunk.heights.end());
  chunk.bounds = {chunk.heightRange.decode(*lowest), chunk.heightRange.decode(*highest)};
  return chunk;
}

std::size_t byteSize(const ChunkData& chunk) {
  return sizeof(ChunkData) + (chunk.heights.capacity() + chunk.normals.capacity()) * sizeof(std::uint16_t);
}

}  // namespace skydrop::terrain
