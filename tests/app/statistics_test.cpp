#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/frame_times.h"
#include "app/statistics_json.h"

namespace skydrop::app {
namespace {

TEST(Statistics, theFileHasTheMembersOfTheContract) {
  core::FrameStatistics statistics;
  statistics.passes = {{"sky", {1.5, 1, 0, ""}}, {"clouds", {0, 0, 0, "no ray meets the layer"}}};
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
  for (const char* name : {"score", "drops", "position", "targets"}) EXPECT_TRUE(json["game"].contains(name)) << name;
  EXPECT_EQ(json["stateHash"], "0000000000000abc");
  EXPECT_EQ(json["effects"][0], "sky");
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

}  // namespace
}  // namespace skydrop::app
