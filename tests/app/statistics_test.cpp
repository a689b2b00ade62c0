#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/measure/frame_times.h"
#include "app/measure/statistics_json.h"

namespace skydrop::app {
namespace {

TEST(Statistics, theFileHasTheMembersOfTheContract) {
  core::FrameStatistics statistics;
  statistics.passes = {{"sky", {1.5, 1, 0}}, {"clouds", {0, 0, 0, "clouds", "no ray meets the layer"}}};
  statistics.effects = {"sky"};
  statistics.stateHash = 0xabc;
  const auto json = nlohmann::json::parse(statisticsJson(statistics));
  EXPECT_EQ(json["schema"], kStatisticsSchema);
  EXPECT_TRUE(json["frame"]["ms"].contains("p99"));
  EXPECT_EQ(json["passes"]["sky"]["ms"], 1.5);
  EXPECT_FALSE(json["passes"]["sky"].contains("skipped"));
  EXPECT_EQ(json["passes"]["clouds"]["skipped"], "no ray meets the layer");
  for (const char* name : {"textures", "buffers", "programs", "framebuffers", "bytes", "errors"}) {
    EXPECT_TRUE(json["gl"].contains(name)) << name;
  }
  for (const char* name : {"chunksDrawn", "triangles", "generated", "cacheHits", "queue", "bytes"}) {
    EXPECT_TRUE(json["terrain"].contains(name)) << name;
  }
  for (const char* name : {"score", "drops", "position", "targets"})
    EXPECT_TRUE(json["game"].contains(name)) << name;
  EXPECT_EQ(json["stateHash"], "0000000000000abc");
  EXPECT_EQ(json["effects"][0], "sky");
}

TEST(Statistics, aComparedPictureHasItsErrorAndOthersHaveNone) {
  core::FrameStatistics statistics;
  EXPECT_FALSE(nlohmann::json::parse(statisticsJson(statistics)).contains("split"));
  statistics.split = {"clouds=reference", 0.25, 0.5, 0.125};
  const auto json = nlohmann::json::parse(statisticsJson(statistics))["split"];
  EXPECT_EQ(json["reference"], "clouds=reference");
  EXPECT_EQ(json["rmse"], 0.25);
  EXPECT_EQ(json["relativeRmse"], 0.5);
  EXPECT_EQ(json["flip"], 0.125);
}

TEST(Statistics, theBillHasARowOfEachEffectAndTheReasonWhereItIsIdle) {
  core::FrameStatistics statistics;
  core::EffectStatistics clouds;
  clouds.name = "clouds";
  clouds.on = true;
  clouds.idle = "no ray meets the layer";
  clouds.ms = 1.5, clouds.simulationMs = 2.5, clouds.updateMs = 0.5, clouds.startMs = 30;
  clouds.draws = 2, clouds.dispatches = 3, clouds.objects = 4, clouds.threads = 5;
  clouds.gpuBytes = std::int64_t{1} << 40, clouds.cpuBytes = 6;
  core::EffectStatistics haze;
  haze.name = "haze";
  statistics.bill = {clouds, haze};
  const auto json = nlohmann::json::parse(statisticsJson(statistics))["bill"];
  const nlohmann::json expected = {
      {"on", true},    {"ms", 1.5},       {"simulationMs", 2.5}, {"updateMs", 0.5},
      {"draws", 2},    {"dispatches", 3}, {"objects", 4},        {"gpuBytes", std::int64_t{1} << 40},
      {"cpuBytes", 6}, {"threads", 5},    {"startMs", 30.0},     {"idle", "no ray meets the layer"}};
  EXPECT_EQ(json["clouds"], expected);
  EXPECT_EQ(json["haze"]["on"], false);
  EXPECT_FALSE(json["haze"].contains("idle"));
  EXPECT_EQ(json.size(), 2u);
}

TEST(Statistics, quantilesAreNearestRanks) {
  FrameTimes times;
  EXPECT_EQ(times.quantile(0.5), 0);
  for (int i = 100; i >= 1; --i) times.add(i);
  EXPECT_EQ(times.quantile(0.5), 50);
  EXPECT_EQ(times.quantile(0.99), 99);
  EXPECT_EQ(times.quantile(1), 100);
  EXPECT_EQ(times.quantile(0), 1);
}

TEST(Statistics, quantilesOfALongRunKeepTheirStatedError) {
  // A week of frames at 60 Hz would be 36 million: memory must not grow with them. Against all values sorted,
  // the quantiles of 200 000 frames from 0.3 to 3000 ms lie within the bound; count and extremes are exact.
  FrameTimes times;
  std::vector<double> all;
  std::uint32_t state = 1;
  for (int i = 0; i < 200000; ++i) {
    state = state * 1664525u + 1013904223u;
    const double ms = 0.3 * std::pow(10.0, 4.0 * static_cast<double>(state >> 8) / (1 << 24));
    times.add(ms);
    all.push_back(ms);
  }
  const std::vector<double> newest(all.end() - 240, all.end());
  EXPECT_TRUE(std::ranges::equal(times.newest(240), newest));
  std::ranges::sort(all);
  for (const double share : {0.001, 0.1, 0.5, 0.9, 0.99, 0.999}) {
    const double exact = all[static_cast<std::size_t>(std::ceil(share * 200000) - 1)];
    EXPECT_NEAR(times.quantile(share) / exact, 1, FrameTimes::kRelativeError) << share;
  }
  core::FrameStatistics statistics;
  times.writeTo(statistics);
  EXPECT_EQ(statistics.frames, 200000);
  EXPECT_EQ(statistics.maxMs, all.back());
  EXPECT_LE(times.newest(1000000).size(), FrameTimes::kKept);
  EXPECT_LE(sizeof(FrameTimes) + 2 * FrameTimes::kKept * sizeof(double), 128u << 10);
}

TEST(Statistics, timesBeyondTheRangeOfTheBinsAreCounted) {
  FrameTimes times;
  for (std::size_t i = 0; i <= FrameTimes::kKept; ++i) times.add(i % 2 == 0 ? 0 : 1e9);
  EXPECT_EQ(times.quantile(0), 0) << "the shortest that there was";
  EXPECT_GE(times.quantile(1), FrameTimes::kLongestMs);
}

}  // namespace
}  // namespace skydrop::app
