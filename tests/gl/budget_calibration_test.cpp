// The fronts of a frame budget as `skydrop accuracy calibrate` measures them, in a scene and a study that are
// small enough for a test.
#include "app/studies/budget_calibration.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "skydrop/accuracy/budget_ladder.h"
#include "skydrop/accuracy/result_file.h"
#include "skydrop/scene/scene.h"
#include "support/gl_test.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

class BudgetCalibrationGLTest : public test::GLTest {
 protected:
  void SetUp() override {
    setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1);
    test::GLTest::SetUp();
  }
  test::TemporaryFolder folder_;
};

TEST_F(BudgetCalibrationGLTest, measuresErrorsThatFallAndTimesOfItsSizeAndAFlightFindsThem) {
  const std::string sceneFile =
      folder_.write("small.json", R"({"schema": 1, "effects": ["sky", "haze", "terrain"]})");
  Calibration calibration;
  calibration.scene = sceneFile;
  calibration.key = BudgetFrontKey::of(scene::loadScene(sceneFile), context().renderer(), {64, 36});
  calibration.set = {"quality=low"};
  calibration.errorSize = {32, 18};
  calibration.repeats = 2;
  accuracy::Study study = budgetStudy();
  std::erase_if(study.points,
                [](const accuracy::StudyPoint& point) { return !point.label.ends_with("clouds low"); });
  study.reference = {"render.picture.scale=1", "clouds.tier=medium"};  // clouds that are not there
  study.cases.resize(1);
  std::size_t told = 0, all = 0;
  const accuracy::Results results = calibrated(study, calibration, [&](std::size_t done, std::size_t of) {
    EXPECT_EQ(done, told + 1);
    told = done, all = of;
  });
  EXPECT_EQ(told, all);
  ASSERT_EQ(results.cases.size(), 1u);
  const auto& points = results.cases[0].points;
  ASSERT_EQ(points.size(), 5u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].ms.size(), 2u) << points[i].label;
  }
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LT(points[i].errors[0], points[i - 1].errors[0]) << points[i].label;
  EXPECT_EQ(points.back().errors[0], 0) << "all of the pixels are the reference";
  keepBudgetFronts(results, calibration.key, folder_.path());
  const BudgetFronts found = findBudgetFronts(calibration.key, folder_.path());
  EXPECT_TRUE(found.measured) << found.warning;
  EXPECT_EQ(accuracy::resultText(found.results), accuracy::resultText(results));
  context().makeCurrent();
}

}  // namespace
}  // namespace skydrop::app
