#include "support/patch_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/shared.h"

namespace skydrop::test {

namespace shared = core::shared::f32;
using terrain::PatchEdge;

float PatchMesher::storedHeight(const glm::dvec2& xz) {
  const terrain::ChunkKey place{static_cast<std::int64_t>(xz.x), static_cast<std::int64_t>(xz.y), 0};
  const auto known = heights_.find(place);
  if (known != heights_.end()) return known->second;
  const terrain::HeightRange range = source_.storedRange();
  const auto height = static_cast<float>(range.decode(range.encode(source_.height(xz))));
  return heights_[place] = height;
}

std::array<glm::dvec3, PatchMesher::kSide * PatchMesher::kSide> PatchMesher::vertices(
    const terrain::TerrainFrame& frame, const terrain::PatchDraw& patch, const glm::dvec3& eye) {
  float morph[11];
  for (std::size_t l = 0; l < frame.lod.morph.size(); ++l) morph[l] = static_cast<float>(frame.lod.morph[l]);
  const int step = patch.level - patch.chunkLevel;
  const double sample = terrain::cellMetres(patch.chunkLevel);
  const glm::dvec2 chunk =
      frame.base + glm::dvec2(patch.x, patch.z) - glm::dvec2(patch.sampleX, patch.sampleZ) * sample;
  const auto coarser = [&](PatchEdge edge) {
    return static_cast<int>(patch.coarser[static_cast<std::size_t>(edge)]);
  };
  const auto heightAt = [&](int x, int z) {
    return storedHeight(
        chunk + glm::dvec2(std::min(x, terrain::kChunkCells), std::min(z, terrain::kChunkCells)) * sample);
  };
  std::array<glm::dvec3, kSide * kSide> result;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      int x = (patch.sampleX >> step) + column, z = (patch.sampleZ >> step) + row;
      if (column == 0) z = shared::snapDown(z, coarser(PatchEdge::west));
      if (column == kSide - 1) z = shared::snapDown(z, coarser(PatchEdge::east));
      if (row == 0) x = shared::snapUp(x, coarser(PatchEdge::north));
      if (row == kSide - 1) x = shared::snapUp(x, coarser(PatchEdge::south));
      x <<= step;
      z <<= step;
      const glm::dvec2 world = chunk + glm::dvec2(x, z) * sample;
      const glm::dvec3 exact{world.x, heightAt(x, z), world.y};
      const float lambda = shared::lodLambda(static_cast<float>(glm::distance(eye, exact)), morph);
      const int level = std::max(static_cast<int>(lambda), patch.chunkLevel);
      float heights[2];
      for (int up = 0; up < 2; ++up) {
        const int stride = 1 << (level + up - patch.chunkLevel);
        const int x0 = x / stride * stride, z0 = z / stride * stride;
        heights[up] = shared::meshHeight(heightAt(x0, z0), heightAt(x0 + stride, z0),
                                         heightAt(x0, z0 + stride), heightAt(x0 + stride, z0 + stride),
                                         static_cast<float>(x - x0) / static_cast<float>(stride),
                                         static_cast<float>(z - z0) / static_cast<float>(stride));
      }
      const float height =
          heights[0] + (heights[1] - heights[0]) * std::max(lambda - static_cast<float>(level), 0.0f);
      result[static_cast<std::size_t>(row * kSide + column)] = {world.x, height, world.y};
    }
  }
  return result;
}

const std::vector<std::array<int, 3>>& patchTriangles() {
  static const std::vector<std::array<int, 3>> triangles = [] {
    std::vector<std::array<int, 3>> all;
    for (int z = 0; z < terrain::kPatchCells; ++z) {
      for (int x = 0; x < terrain::kPatchCells; ++x) {
        const int nw = z * PatchMesher::kSide + x, ne = nw + 1, sw = nw + PatchMesher::kSide, se = sw + 1;
        all.push_back({nw, sw, ne});
        all.push_back({ne, sw, se});
      }
    }
    return all;
  }();
  return triangles;
}

}  // namespace skydrop::test
