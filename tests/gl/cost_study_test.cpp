// The study of what effects cost: its form, and that what is off costs nothing.
#include "app/studies/cost_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/measure/bill.h"
#include "app/studies/scene_bill.h"
#include "support/gl_test.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr CostEffort kLittle{{64, 36}, 2, 1};

class CostStudyGLTest : public test::GLTest {
 protected:
  void SetUp() override {
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
    test::GLTest::SetUp();
    sceneFile_ = (folder_.path() / "small.json").string();
    std::ofstream(sceneFile_) << R"({"schema": 1, "effects": ["sky", "haze", "aircraft", "hud"]})";
  }

  test::TemporaryFolder folder_;
  std::string sceneFile_;
};

const CostRow& rowOf(const CostTable& result, const std::string& label) {
  const auto found = std::ranges::find(result.rows, label, &CostRow::label);
  EXPECT_NE(found, result.rows.end()) << label;
  return *found;
}

TEST_F(CostStudyGLTest, everyEffectHasARowAndThoseThatAreOffHaveZeros) {
  int games = 0;
  const CostTable result = costOfScene(sceneFile_, kLittle, [&] { ++games; });
  ASSERT_EQ(result.rows.size(), scene::kEffectNames.size() + 2) << "the effects, the frame and the whole";
  EXPECT_EQ(games, 5) << "the scene, and the scene without each of its effects";
  EXPECT_FALSE(result.machine.empty());
  EXPECT_NE(result.clock.find("glFinish"), std::string::npos) << result.clock;
  const std::vector<std::string> on = {"sky", "haze", "aircraft", "hud"};
  for (const std::string_view name : scene::kEffectNames) {
    const CostRow& row = rowOf(result, std::string(name));
    ASSERT_EQ(row.values.size(), result.columns.size());
    const bool isOn = std::ranges::find(on, name) != on.end();
    EXPECT_EQ(row.note == "off", !isOn) << name;
    if (isOn) {
      EXPECT_GT(row.values[10], 0) << name << ": no frame without it";
      continue;
    }
    for (const double value : row.values)
      EXPECT_TRUE(value == 0 || std::isnan(value)) << name << ' ' << value;
  }
  EXPECT_GT(rowOf(result, "sky").values[0], 0);
  EXPECT_GT(rowOf(result, "aircraft").values[2], 0) << "simulation";
  EXPECT_GT(rowOf(result, "hud").values[3], 0) << "building the interface";
  EXPECT_GT(rowOf(result, "frame").values[0], 0) << "targets cleared, tone map";
}

TEST_F(CostStudyGLTest, theRowsAddUpToWhatThePassesAndTheTrackerSay) {
  // Nothing is paid twice and nothing outside the bill: draws, dispatches and times of all passes, and the
  // GPU's objects and bytes, are those of the rows together.
  MeasuredGame game({sceneFile_, kLittle.size});
  const SceneBill bill = billOf(game, 1);
  const core::FrameStatistics& frame = bill.frames.back();
  core::EffectStatistics rows, passes;
  for (const core::EffectStatistics& row : frame.bill) {
    rows.ms += row.ms, rows.draws += row.draws, rows.objects += row.objects, rows.gpuBytes += row.gpuBytes;
  }
  for (const auto& [name, pass] : frame.passes) {
    if (pass.skipped.empty()) passes.ms += pass.ms, passes.draws += pass.draws;
  }
  EXPECT_NEAR(rows.ms, passes.ms + frame.beginMs, 1e-9) << "ms; sums in another order";
  EXPECT_EQ(rows.draws, passes.draws);
  EXPECT_EQ(rows.gpuBytes, frame.gl.bytes);
  EXPECT_GT(frame.beginMs, 0);
  EXPECT_GT(bill.paidShare(), 0.5) << "most of the frame is in its rows";
  EXPECT_LT(bill.paidShare(), 1.1);
}

TEST_F(CostStudyGLTest, theTableOfTheSourceHasTheKindsThatTheProgramHas) {
  const std::vector<SkyKind> kinds = skyKinds();
  ASSERT_GE(kinds.size(), 2u);
  EXPECT_EQ(kinds.front().label, "empty sky");
  EXPECT_EQ(kinds.front().sourceFps, 83);
  const auto has = [&](const std::string& label) {
    return std::ranges::find(kinds, label, &SkyKind::label) != kinds.end();
  };
  const bool hasPlanes =
      std::ranges::find(scene::kEffectNames, std::string_view("cloudPlanes")) != scene::kEffectNames.end();
  EXPECT_EQ(has("three planes"), hasPlanes);
  for (const char* tier : {"off", "low", "medium", "high", "ultra"})
    EXPECT_TRUE(has(std::string("clouds, ") + tier)) << tier;
  EXPECT_FALSE(has("clouds, reference"));
  EXPECT_TRUE(has("hud"));
  const SkyKind* hud = &*std::ranges::find(kinds, "hud", &SkyKind::label);
  const CostTable result = costOfSkies({kinds.front(), *hud}, kLittle);
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_GT(result.rows[0].values[0], 0) << "frames per second of the empty sky";
  EXPECT_EQ(result.rows[0].values[1], 0) << "drop";
  EXPECT_EQ(result.rows[0].values[4], 83) << "the source's";
  EXPECT_TRUE(std::isnan(result.rows[1].values[4])) << "the source has no such row";
  EXPECT_NEAR(result.rows[1].values[1], 100 * (1 - result.rows[1].values[0] / result.rows[0].values[0]),
              1e-6);
}

}  // namespace
}  // namespace skydrop::app
