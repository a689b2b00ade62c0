// The clouds' pass: when it has work, and what its frames promise.
#include "skydrop/render/clouds/cloud_system.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>

#include "skydrop/core/settings_table.h"
#include "support/frame_test.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

class CloudSystemGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    auto pass = std::make_unique<CloudSystem>(context(), test::sharedNoise(), clouds_, wind_);
    system_ = pass.get();
    renderer().add(std::move(pass));
    clouds_.light = clouds::CloudLight::octaves;
    renderer().add(std::make_unique<test::LightProbe>(light_));
  }

  std::vector<glm::vec4> lightFrom(const View& view) {
    system_->apply(clouds_, wind_);
    draw(view);
    return light_;
  }
  std::string skipReasonOf(const View& view) {
    system_->apply(clouds_, wind_);
    return system_->skipReason(gameFrame(snapshot_, view, features_)).value_or("");
  }
  View below() const { return pose({0, 600, 0}, 40, 12, 0, 160, 90); }

  clouds::CloudSettings clouds_;
  core::WindSettings wind_;
  CloudSystem* system_ = nullptr;

 private:
  std::vector<glm::vec4> light_;
};

TEST_F(CloudSystemGLTest, marchesOnlyTilesThatMayShowCloud) {
  // Some of the picture is open sky: fewer tiles than there are, more than none.
  lightFrom(below());
  const unsigned all = (160 / 2 + 7) / 8 * ((90 / 2 + 7) / 8);
  EXPECT_GT(system_->lastWork().tiles, 0u);
  EXPECT_LT(system_->lastWork().tiles, all);
}

TEST_F(CloudSystemGLTest, C34_theLayerIsInViewWhereTheEarthBringsItThere) {
  // In the distance the layer is 282 m lower. From 200 m below the base, a view of a degree whose upper edge
  // lies .05 degrees below the horizon sees it; one that lies .5 degrees below does not. From 200 m over the
  // top a view just below the horizon sees none (it would of a flat layer); from 10 m it does.
  test::noFaults("C34", "violations");
  settings_.camera.fovDegrees = 1;
  clouds_.layers[0].coverage = 1;
  const auto reasonAt = [&](double height, double pitch) {
    return skipReasonOf(pose({0, height, 0}, 40, pitch, 0, 64, 64));
  };
  const double base = clouds_.layers[0].cloudHeight, top = base + clouds_.layers[0].thickness;
  EXPECT_EQ(reasonAt(base - 200, -0.55), "");
  EXPECT_EQ(reasonAt(base - 200, -1), "the layer is out of view");
  EXPECT_EQ(reasonAt(base - 400, -0.55), "the layer is out of view");
  EXPECT_EQ(reasonAt(top + 200, 0.2), "the layer is out of view");
  EXPECT_EQ(reasonAt(top + 10, 0.2), "");
  clouds_.fadeDistance = 24000;
  EXPECT_EQ(reasonAt(base - 200, -0.55), "the layer is out of view");
}

TEST_F(CloudSystemGLTest, C31_dispatchesNothingWhereNoCloudCanBeSeen) {
  // A clear sky, a layer outside the picture or faded, and the tier off: no dispatch at all, and a reason.
  test::noFaults("C31", "violations");
  const auto dispatches = [&](const View& view) {
    lightFrom(view);
    const auto& passes = context().resources().passes();
    const auto row = passes.find("clouds");
    return row == passes.end() ? 0 : row->second.dispatches;
  };
  EXPECT_GT(dispatches(below()), 0u);
  EXPECT_EQ(skipReasonOf(below()), "");
  const View down = pose({0, 600, 0}, 40, -45, 0, 160, 90);
  EXPECT_EQ(dispatches(down), 0u);
  EXPECT_EQ(skipReasonOf(down), "the layer is out of view");
  EXPECT_EQ(skipReasonOf(pose({0, 600 + 1e5, 0}, 40, -45, 0)), "the layer is out of view");
  clouds_.layers[0].coverage = 0;
  EXPECT_EQ(dispatches(below()), 0u);
  EXPECT_EQ(skipReasonOf(below()), "no cloud anywhere");
  clouds_.layers[0].coverage = 0.5;
  clouds_.tier = clouds::CloudTier::off;
  EXPECT_EQ(dispatches(below()), 0u);
  EXPECT_EQ(skipReasonOf(below()), "switched off");
}

TEST_F(CloudSystemGLTest, everyEndOfEverySliderDrawsFiniteLight) {
  // Whatever row of the weather or the march is moved to an end, and each choice: all light is finite and not
  // negative, from below and from inside.
  core::SettingsTable table(clouds_);
  const std::array views = {pose({0, 600, 0}, 40, 12, 0, 32, 18), pose({600, 2300, 600}, 40, 0, 0, 32, 18)};
  for (const core::Field& field : table.fields()) {
    const double before = field.get();
    for (const double end : {field.min, field.max}) {
      field.set(end);
      for (const View& view : views) {
        const bool sound = std::ranges::all_of(lightFrom(view), [](const glm::vec4& light) {
          return glm::all(glm::greaterThanEqual(light, glm::vec4(0))) &&
                 glm::all(glm::lessThan(light, glm::vec4(65504)));
        });
        EXPECT_TRUE(sound) << field.path << " = " << end;
      }
    }
    field.set(before);
  }
}

TEST_F(CloudSystemGLTest, C28_repeatedFramesAreBitIdentical) {
  // A hundred frames of one view equal the first: no missing barrier, nothing read before it was written.
  test::noFaults("C28", "differences");
  const std::vector<glm::vec4> first = lightFrom(below());
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(lightFrom(below()) == first) << "frame " << i;
}

}  // namespace
}  // namespace skydrop::render
