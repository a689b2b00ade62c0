#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::terrain {
namespace {

TEST(NoiseLand, boundsHoldEverySample) {
  // Rectangles of 1 m to 300 km, anywhere: no height of 400 random points lies outside.
  const auto land = makeNoiseHeightSource({}, 3);
  core::RandomStream random{1, 0};
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 lo((random.nextUnit() - 0.5) * 1e6, (random.nextUnit() - 0.5) * 1e6);
    const double size = std::exp(random.nextUnit() * std::log(3e5));
    const glm::dvec2 extent(size, size * (0.1 + random.nextUnit()));
    const HeightBounds bounds = land->bounds(lo, lo + extent);
    for (int n = 0; n < 40; ++n) {
      const double height = land->height(lo + extent * glm::dvec2(random.nextUnit(), random.nextUnit()));
      ASSERT_GE(height, bounds.lowest) << size;
      ASSERT_LE(height, bounds.highest) << size;
    }
  }
}

TEST(NoiseLand, boundsHoldEveryStoredSample) {
  // What is culled by the bounds of a chunk's square is not drawn: they hold its stored heights too, whose
  // rounding is half a step.
  const auto land = makeNoiseHeightSource({}, 3);
  for (std::int64_t i = 0; i < 60; ++i) {
    const ChunkKey key{i * 37 - 900, i * 11 - 300, static_cast<std::int32_t>(i % 6)};
    const ChunkData chunk = makeChunk(*land, key);
    const glm::dvec2 lo = chunkOrigin(key);
    const HeightBounds bounds = land->bounds(lo, lo + glm::dvec2(chunkMetres(key.level)));
    EXPECT_GE(chunk.bounds.lowest, bounds.lowest - chunk.heightRange.step() / 2);
    EXPECT_LE(chunk.bounds.highest, bounds.highest + chunk.heightRange.step() / 2);
  }
}

TEST(NoiseLand, boundsAreTightEnoughToCullWith) {
  // Over a full-detail chunk they are wider than the land by 280 m on average: a seventh of the range.
  const auto land = makeNoiseHeightSource({}, 3);
  double excess = 0;
  constexpr int kChunks = 100;
  for (std::int64_t i = 0; i < kChunks; ++i) {
    const ChunkKey key{i * 37 - 900, i * 11 - 300, 0};
    const ChunkData chunk = makeChunk(*land, key);
    const HeightBounds bounds = land->bounds(chunkOrigin(key), chunkOrigin(key) + glm::dvec2(kChunkMetres));
    excess += (bounds.highest - bounds.lowest) - (chunk.bounds.highest - chunk.bounds.lowest);
  }
  EXPECT_LT(excess / kChunks, 350.0);  // metres; chunks differ
  RecordProperty("meanExcessMetres", std::to_string(excess / kChunks));
}

TEST(NoiseLand, mostLandCanBeFlownOver) {
  // Of land, nine tenths are under 35 degrees and half under 10; peaks reach beyond 1280 m.
  const auto land = makeNoiseHeightSource({}, 3);
  core::RandomStream random{2, 0};
  int onLand = 0, gentle = 0, flat = 0;
  double highest = 0;
  for (int i = 0; i < 100000; ++i) {
    const HeightSample s = land->sample({(random.nextUnit() - 0.5) * 2e6, (random.nextUnit() - 0.5) * 2e6});
    if (s.height < 0) continue;
    ++onLand;
    const double slope = std::sqrt(s.gradient.x * s.gradient.x + s.gradient.y * s.gradient.y);
    gentle += slope < 0.70021;  // tan 35 degrees
    flat += slope < 0.17633;    // tan 10 degrees
    highest = std::max(highest, s.height);
  }
  EXPECT_GT(gentle, 0.9 * onLand);
  EXPECT_GT(flat, 0.5 * onLand);
  EXPECT_GT(highest, 1280);
}

TEST(NoiseLand, aFlightMayBeginAtTheOriginOfAnySeed) {
  // Gentle dry land at the origin, dry land around it, and a mountain within 8.5 km.
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto land = makeNoiseHeightSource({}, seed);
    const HeightSample origin = land->sample({0, 0});
    EXPECT_GT(origin.height, 0) << seed;
    EXPECT_LT(origin.gradient.x * origin.gradient.x + origin.gradient.y * origin.gradient.y, 0.0401) << seed;
    int dry = 0;
    double highest = 0;
    for (int i = 0; i < 49; ++i) {
      const double height = land->height({2000.0 * (i % 7 - 3), 2000.0 * (i / 7 - 3)});
      dry += height > 0;
      highest = std::max(highest, height);
    }
    EXPECT_GE(dry, 40) << seed;
    EXPECT_GT(highest, 500) << seed;
  }
}

TEST(NoiseLand, settingsOutOfRangeAreRefused) {
  // At the door, with the setting's name.
  TerrainSettings settings;
  settings.seaDepth = std::nan("");
  EXPECT_THROW(makeNoiseHeightSource(settings, 1), core::RangeError);
  settings = {};
  settings.finestWavelength = 1;
  EXPECT_THROW(makeNoiseHeightSource(settings, 1), core::RangeError);
}

TEST(NoiseLand, aStopEndsAChunkBetweenRows) {
  // A cancelled job returns nothing that could be mistaken for land.
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(makeChunk(*makeNoiseHeightSource({}, 1), {0, 0, 0}, stop.get_token()).empty());
}

}  // namespace
}  // namespace skydrop::terrain
