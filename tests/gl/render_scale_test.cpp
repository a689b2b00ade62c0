// A scene that is drawn in fewer pixels than the picture has (render.picture.scale).
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/session/observed_picture.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/frame_test.h"
#include "support/plains_pass.h"

namespace skydrop::render {
namespace {

// Notes the size of the picture that it is asked to draw.
class SizePass final : public Pass {
 public:
  SizePass(RenderStage stage, std::vector<std::string>& log) : stage_(stage), log_(log) {}
  std::string_view name() const override { return "size"; }
  RenderStage stage() const override { return stage_; }
  void draw(FrameContext& context) override {
    const View& view = context.frame.view;
    log_.push_back(std::to_string(view.width) + "x" + std::to_string(view.height));
  }

 private:
  RenderStage stage_;
  std::vector<std::string>& log_;
};

class RenderScaleGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<SkyPass>(context()));
    renderer().add(std::make_unique<ToneMapPass>(context()));
  }
};

TEST_F(RenderScaleGLTest, theSceneHasFewerPixelsAndWhatIsOverItHasAll) {
  std::vector<std::string> log;
  renderer().add(std::make_unique<SizePass>(RenderStage::clouds, log));
  renderer().add(std::make_unique<SizePass>(RenderStage::hud, log));
  settings_.scale = 0.35;
  const core::Image image = draw(pose({0, 500, 0}, 30, 10, 0));
  EXPECT_THAT(log, ::testing::ElementsAre("112x63", "320x180"));
  EXPECT_EQ(renderer().sceneColor().width(), 112);
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 180);
  EXPECT_EQ(renderer().readRadiance().size(), 3u * 320 * 180);
}

TEST_F(RenderScaleGLTest, thePictureIsTheScenesLightStretchedAndThenToneMapped) {
  // Within a level of 255 for the dither and one for the filter's rounding.
  settings_.scale = 0.5;
  const core::Image image = draw(pose({0, 500, 0}, 30, 10, 0));
  const core::Image expected = app::seenPicture(renderer().readRadiance(), image.width, image.height);
  int largest = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    largest = std::max(largest, std::abs(image.rgba[i] - expected.rgba[i]));
  EXPECT_LE(largest, 2);
}

TEST_F(RenderScaleGLTest, ofMorePixelsThePictureShowsTheMeanOfWhatTheyShow) {
  // The same in C++ (Stretch), but for the dither and the filter's rounding.
  std::vector<std::string> log;
  renderer().add(std::make_unique<SizePass>(RenderStage::clouds, log));
  settings_.scale = 4;
  const core::Image image = draw(pose({0, 500, 0}, 30, 10, 0, 80, 45));
  EXPECT_THAT(log, ::testing::ElementsAre("320x180"));
  EXPECT_EQ(image.width, 80);
  const core::Image expected = app::seenPicture(renderer().readRadiance(), image.width, image.height);
  int largest = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    largest = std::max(largest, std::abs(image.rgba[i] - expected.rgba[i]));
  EXPECT_LE(largest, 2);
  settings_.scale = 1;
  const core::Image whole = draw(pose({0, 500, 0}, 30, 10, 0, 80, 45));
  double sum = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); ++i) sum += std::abs(whole.rgba[i] - image.rgba[i]);
  EXPECT_LT(sum / static_cast<double>(whole.rgba.size()), 0.5) << "a smooth sky";
}

TEST_F(RenderScaleGLTest, aSmoothSkyLooksTheSameInAQuarterOfThePixelsAndAllOfThemComeBack) {
  // The mean difference is within the dither's level; of a picture that is shifted by a pixel of the scene,
  // or upside down, it is not.
  const View view = pose({0, 500, 0}, 30, 10, 0);
  const core::Image whole = draw(view);
  settings_.scale = 0.5;
  const core::Image half = draw(view);
  const auto meanDifference = [&](std::size_t shift) {
    double sum = 0;
    for (std::size_t i = shift; i < whole.rgba.size(); ++i)
      sum += std::abs(whole.rgba[i - shift] - half.rgba[i]);
    return sum / static_cast<double>(whole.rgba.size());
  };
  EXPECT_LT(meanDifference(0), 0.5);
  EXPECT_GT(meanDifference(8 * 320 * 4), 0.7) << "eight rows lower the sky is another";
  settings_.scale = 1;
  EXPECT_EQ(draw(view).rgba, whole.rgba);
}

TEST_F(RenderScaleGLTest, picturesThatNobodySeesHaveTheSizeOfTheirView) {
  settings_.scale = 0.25;
  renderer().apply(settings_);
  std::optional<std::vector<float>> radiance;
  while (!radiance)
    radiance =
        renderer().drawUnseen(render::gameFrame(snapshot_, pose({0, 500, 0}, 0, 0, 0, 64, 32), features_));
  EXPECT_EQ(radiance->size(), 3u * 64 * 32);
}

}  // namespace
}  // namespace skydrop::render
