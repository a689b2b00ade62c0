#include <algorithm>

#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/land_shade.h"

namespace skydrop::terrain {
namespace {

constexpr int kKeptUses = 4;  // an eye that turns back finds its land

constexpr std::int64_t floorDivided(std::int64_t value, std::int64_t by) {
  const std::int64_t quotient = value / by;
  return value % by < 0 ? quotient - 1 : quotient;
}

}  // namespace

const ShadeHeights::Chunk* ShadeHeights::chunk(const ChunkKey& key, const std::stop_token& stop) {
  const auto [found, isNew] = chunks_.try_emplace(key);
  Chunk& chunk = found->second;
  chunk.lastUse = use_;
  if (!isNew) return &chunk;
  const glm::dvec2 origin = chunkOrigin(key);
  if (source_->bounds(origin, origin + chunkMetres(key.level)).highest <= 0) return &chunk;
  chunk.codes = makeChunk(*source_, key, stop).heights;
  if (!chunk.codes.empty()) return &chunk;
  chunks_.erase(found);
  return nullptr;
}

bool ShadeHeights::read(std::int32_t detail, bool lineOfX, std::int64_t line, std::int64_t first, int count,
                        float* out, const std::stop_token& stop) {
  const std::int32_t level = std::min(detail, kMaxChunkLevel);
  const std::int64_t stride = std::int64_t{1} << (detail - level);
  const HeightRange range = source_->storedRange();
  const auto lowest = static_cast<float>(range.lowest), step = static_cast<float>(range.step());
  const std::int64_t lineChunk = floorDivided(line * stride, kChunkCells);
  const auto lineSample = static_cast<int>(line * stride - lineChunk * kChunkCells);
  for (int done = 0; done < count;) {
    const std::int64_t sample = (first + done) * stride;
    const std::int64_t other = floorDivided(sample, kChunkCells);
    const auto begin = static_cast<int>(sample - other * kChunkCells);
    const int most = (kChunkCells - 1 - begin) / static_cast<int>(stride) + 1;
    const int run = std::min(count - done, most);
    const Chunk* from =
        chunk(lineOfX ? ChunkKey{lineChunk, other, level} : ChunkKey{other, lineChunk, level}, stop);
    if (!from) return false;
    if (from->codes.empty()) {
      std::fill_n(out + done, run, 0.0f);
    } else {
      const int start = lineOfX ? sampleIndex(lineSample, begin) : sampleIndex(begin, lineSample);
      const int apart = static_cast<int>(stride) * (lineOfX ? kChunkSamples : 1);
      const std::uint16_t* codes = from->codes.data() + start;
      for (int i = 0; i < run; ++i)
        out[done + i] = std::max(lowest + static_cast<float>(codes[i * apart]) * step, 0.0f);
    }
    done += run;
  }
  return true;
}

void ShadeHeights::endUse() {
  std::erase_if(chunks_, [this](const auto& entry) { return entry.second.lastUse + kKeptUses <= use_; });
  ++use_;
}

std::size_t ShadeHeights::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [key, chunk] : chunks_) bytes += chunk.codes.size() * sizeof(chunk.codes[0]);
  return bytes;
}

}  // namespace skydrop::terrain
