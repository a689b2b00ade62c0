// Cloud planes in frames: from below, from above, on the plane itself and far from the origin.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "skydrop/render/clouds/cloud_plane.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/cloud_rows.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;

class CloudPlanesGLTest : public test::CloudRowsGLTest {
 protected:
  void SetUp() override {
    CloudRowsGLTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::LightProbe>(light_));
    addSky();
    for (clouds::CloudPlaneSettings& layer : planes_.layers) layer.textureSide = 256;
    planes_.layers[0].cutoff = planes_.layers[1].cutoff = planes_.layers[2].cutoff = 0.5;
    settings_.sun.elevationDegrees = 40;
  }

  void addPlanes() {
    auto pass = std::make_unique<CloudPlanes>(context(), nullptr, planes_, wind_);
    pass_ = pass.get();
    renderer().add(std::move(pass));
  }
  Light frame(const View& view) {
    pass_->apply(planes_, wind_);
    pass_->waitForNoise();
    draw(view);
    return light_;
  }
  Light sky(const View& view) {
    const std::int64_t kept = std::exchange(planes_.count, 0);
    const Light light = frame(view);
    planes_.count = kept;
    return light;
  }
  std::optional<std::string> reason(const View& view) {
    pass_->apply(planes_, wind_);
    return pass_->skipReason(gameFrame(snapshot_, view, features_));
  }
  static double meanDifference(const Light& a, const Light& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const glm::vec3 apart = glm::abs(shown(a[i]) - shown(b[i])) * 255.0f;
      sum += (apart.x + apart.y + apart.z) / 3;
    }
    return sum / static_cast<double>(a.size());
  }

  clouds::CloudPlanesSettings planes_;
  CloudPlanes* pass_ = nullptr;
  Light light_;
};

TEST_F(CloudPlanesGLTest, areSeenFromBelowFromAboveAndBetweenLayers) {
  // Frames that look towards a layer differ from the sky by 3 of 255 and more in the mean; all are finite.
  addPlanes();
  for (const View& view : {small({0, 300, 0}, 40, 14), small({0, 4000, 0}, 40, -20),
                           small({0, 1050, 0}, 40, 10), small({0, 1050, 0}, 40, -30)}) {
    const Light with = frame(view);
    EXPECT_TRUE(areFinite(with));
    EXPECT_GT(meanDifference(with, sky(view)), 3) << view.position.y;
  }
}

TEST_F(CloudPlanesGLTest, whatCannotTouchTheFrameSaysWhy) {
  // No layer, no cloud left, nothing in view: each has its reason, and none draws.
  addPlanes();
  const View up = small({0, 300, 0}, 40, 14);
  EXPECT_EQ(reason(up), std::nullopt);
  EXPECT_EQ(reason(small({0, 300, 0}, 40, -60)), "the layers are out of view");
  EXPECT_EQ(reason(small({0, 5000, 0}, 40, 60)), "the layers are out of view");
  planes_.count = 0;
  EXPECT_EQ(reason(up), "no layers");
  planes_.count = 3;
  for (clouds::CloudPlaneSettings& layer : planes_.layers) layer.cutoff = 1;
  EXPECT_EQ(reason(up), "the cutoff leaves no cloud");
}

TEST_F(CloudPlanesGLTest, aViewWithACloudInItIsNeverLeftOut) {
  // Where a reason is given, a frame without it would have shown the sky alone: 200 views around the edge
  // where the rim comes into view. A layer that is all cloud, so that nothing is missed.
  planes_.count = 1;
  planes_.variation = 0;
  planes_.layers[0].cutoff = 0;
  addPlanes();
  int seen = 0, left = 0;
  for (int i = 0; i < 200; ++i) {
    const View view = pose({0, 300, 0}, 7.0 * i, -52 + 0.2 * i, 3.0 * (i % 30), 64, 36);
    if (!reason(view)) {
      ++seen;
      continue;
    }
    ++left;
    double highest = -1;
    for (int y = 0; y <= 36; ++y) {
      for (int x = 0; x <= 64; ++x)
        highest = std::max(highest, rayDirection(view, {static_cast<double>(x), static_cast<double>(y)}).y);
    }
    EXPECT_LE(highest, 1100.0 / 60000) << i;
  }
  EXPECT_GT(seen, 20);
  EXPECT_GT(left, 20);
}

TEST_F(CloudPlanesGLTest, aLayerExactlyAtTheEyeIsInvisibleAndFinite) {
  // Seen edge-on it has no area: the frame is the sky, to the last bit, and finite. Likewise looking along
  // it, at any bank.
  planes_.count = 1;
  addPlanes();
  for (const double pitch : {0.0, 20.0, -35.0, 90.0}) {
    const View view = small({123, planes_.layers[0].height, -77}, 40, pitch);
    const Light with = frame(view);
    EXPECT_TRUE(areFinite(with)) << pitch;
    EXPECT_LT(difference(with, sky(view)), 1) << pitch;
  }
}

TEST_F(CloudPlanesGLTest, flyingThroughALayerDoesNotCut) {
  // From 10 m below to 10 m above in steps of 0.2 m, a frame of a climb at 12 m/s, looking 12 degrees up and
  // down: from one frame to the next the picture changes by at most 2 of 255 in the mean, of 20 and more that
  // a sheet takes away that ends at the eye.
  planes_.count = 1;
  planes_.variation = 0;
  planes_.layers[0].cutoff = 0.3;
  addPlanes();
  for (const double pitch : {12.0, -12.0}) {
    Light before;
    for (double rise = -10; rise <= 10; rise += 0.2) {
      const Light now = frame(small({0, planes_.layers[0].height + rise, 0}, 40, pitch));
      if (!before.empty()) {
        EXPECT_LT(meanDifference(before, now), 2) << rise;
      }
      before = now;
    }
  }
}

TEST_F(CloudPlanesGLTest, aFrameFarFromTheOriginIsTheSameFrame) {
  // 1e12 m away (111 111 111 periods), without variation and detail, which have other periods: within 1.5 of
  // 255.
  planes_.count = 1;
  planes_.variation = planes_.detail = 0;
  addPlanes();
  const Light here = frame(small({1000, 300, 500}, 40, 14));
  const double away = planes_.layers[0].period * 111111111;
  EXPECT_LT(difference(here, frame(small({1000 + away, 300, 500 - away}, 40, 14))), 1.5);
}

TEST_F(CloudPlanesGLTest, cloudsStayWhereTheyAreWhileTheEyeMoves) {
  // Straight up, four pixels' width to the side: what was seen at a pixel is seen four pixels on, in the mean
  // four times as nearly as at the pixel itself.
  planes_.count = 1;
  addPlanes();
  View view = pose({0, 400, 0}, 0, 90, 0, 64, 36);
  const Light first = frame(view);
  const double pixelM = view.pixelAngleRad() * (planes_.layers[0].height - 400);
  view.position += view.right() * (4 * pixelM);
  const Light moved = frame(view);
  double shifted = 0, still = 0;
  for (int y = 0; y < 36; ++y) {
    for (int x = 4; x < 64; ++x) {
      const auto at = [&](const Light& light, int column) {
        return shown(light[static_cast<std::size_t>(y * 64 + column)]);
      };
      shifted += static_cast<double>(glm::length(at(first, x) - at(moved, x - 4)));
      still += static_cast<double>(glm::length(at(first, x) - at(moved, x)));
    }
  }
  // The sky behind, the light and the way through the sheet change a little with the direction.
  EXPECT_GT(still, 4 * shifted);
}

TEST_F(CloudPlanesGLTest, layersAtOneHeightAreAllDrawn) {
  // Three of them are more opaque than one, the same from frame to frame.
  for (clouds::CloudPlaneSettings& layer : planes_.layers) layer.height = 1000;
  addPlanes();
  const View view = small({0, 300, 0}, 40, 20);
  const Light three = frame(view);
  EXPECT_EQ(difference(three, frame(view)), 0);
  const Light without = sky(view);
  planes_.count = 1;
  EXPECT_GT(meanDifference(three, without), meanDifference(frame(view), without));
}

TEST_F(CloudPlanesGLTest, rimIsNotSeen) {
  // A layer that is all cloud, without haze: towards the rim opacity falls to nothing, by at most a tenth of
  // the range from one row of pixels to the next.
  planes_.count = 1;
  planes_.variation = 0;
  planes_.radiusM = 5000;
  planes_.layers[0].cutoff = 0;
  addPlanes();
  const View view = small({0, 200, 0}, 0, 14);
  const Light with = frame(view), without = sky(view);
  double before = 0, most = 0, all = 0;
  for (int y = 0; y < 36; ++y) {
    const std::size_t i = static_cast<std::size_t>(y * 64 + 32);
    const double apart = static_cast<double>(glm::length(shown(with[i]) - shown(without[i])));
    if (y > 0) most = std::max(most, std::abs(apart - before));
    all = std::max(all, apart);
    if (rayDirection(view, {32.5, y + 0.5}).y < 0.19) {
      EXPECT_LT(apart, 0.02) << y;
    }
    before = apart;
  }
  EXPECT_GT(all, 0.1);
  EXPECT_LT(most, 0.6 * all);
}

TEST_F(CloudPlanesGLTest, mountainsHideWhatIsBehindAndPierceWhatIsNot) {
  // A plain above the layer hides it from above; one below it does not.
  planes_.count = 1;
  planes_.layers[0].cutoff = 0.3;
  addPlains();
  addPlanes();
  const View view = small({0, 3000, 0}, 40, -40);
  plains_ = {{2000, glm::vec3(0.1f)}};
  EXPECT_EQ(difference(frame(view), sky(view)), 0);
  plains_ = {{500, glm::vec3(0.1f)}};
  EXPECT_GT(meanDifference(frame(view), sky(view)), 3);
}

// What is left of a picture in blocks of so many pixels along a side: their means, with the four around a
// pixel mixed. No picture of so few values that is mixed like this is nearer to it by much.
Light inBlocks(const Light& picture, int width, int height, int pixels) {
  const int across = width / pixels, up = height / pixels;
  Light means(static_cast<std::size_t>(across * up));
  for (int y = 0; y < up * pixels; ++y) {
    for (int x = 0; x < across * pixels; ++x) {
      means[static_cast<std::size_t>(y / pixels * across + x / pixels)] +=
          picture[static_cast<std::size_t>(y * width + x)] / static_cast<float>(pixels * pixels);
    }
  }
  const auto at = [&](int x, int y) {
    return means[static_cast<std::size_t>(std::clamp(y, 0, up - 1) * across + std::clamp(x, 0, across - 1))];
  };
  Light mixed(picture.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / pixels - 0.5, v = (y + 0.5) / pixels - 0.5;
      const int left = static_cast<int>(std::floor(u)), low = static_cast<int>(std::floor(v));
      const auto s = static_cast<float>(u - left), t = static_cast<float>(v - low);
      mixed[static_cast<std::size_t>(y * width + x)] =
          glm::mix(glm::mix(at(left, low), at(left + 1, low), s),
                   glm::mix(at(left, low + 1), at(left + 1, low + 1), s), t);
    }
  }
  return mixed;
}

TEST_F(CloudPlanesGLTest, fewerPixelsShowTheSameCloudsSofter) {
  // The picture of half and of a quarter of the resolution is at most half again as far from the full one as
  // the best picture of so few values (one sample stands for a block here, its mean there); the mean
  // brightness of what is shown stays within 1 %.
  planes_.count = 1;
  planes_.layers[0].textureSide = 512;
  addPlanes();
  const View view = pose({0, 300, 0}, 220, 20, 0, 320, 180);
  const Light full = frame(view);
  const auto brightness = [](const Light& light) {
    double sum = 0;
    for (const glm::vec4& pixel : light) sum += static_cast<double>(glm::dot(shown(pixel), glm::vec3(1)));
    return sum;
  };
  const double clouds = meanDifference(full, sky(view));
  double before = 0;
  for (const auto resolution : {clouds::SheetResolution::half, clouds::SheetResolution::quarter}) {
    planes_.resolution = resolution;
    const Light fewer = frame(view);
    const double off = meanDifference(fewer, full);
    RecordProperty(std::string(clouds::kSheetResolutionNames[static_cast<std::size_t>(resolution)]),
                   std::to_string(off / clouds));
    EXPECT_GT(off, before);
    EXPECT_LT(off, 1.5 * meanDifference(inBlocks(full, 320, 180, clouds::pixelsAlong(resolution)), full));
    EXPECT_NEAR(brightness(fewer) / brightness(full), 1, 0.01);
    before = off;
  }
}

TEST_F(CloudPlanesGLTest, surfacesCutTheirCloudsAtEveryPixelInAnyResolution) {
  // The eye between a plain below it and the layer above it, banked: each pixel that the plain fills is to
  // the last bit that of a frame without clouds. No odd row or column is lost.
  planes_.count = 1;
  planes_.variation = 0;
  planes_.layers[0].cutoff = 0.2;
  planes_.layers[0].height = 3000;
  addPlains();
  plains_ = {{2000, glm::vec3(0.1f)}};
  addPlanes();
  const View view = pose({0, 2500, 0}, 40, 3, 33, 65, 37);
  for (const auto resolution :
       {clouds::SheetResolution::full, clouds::SheetResolution::half, clouds::SheetResolution::quarter}) {
    planes_.resolution = resolution;
    const Light with = frame(view), without = sky(view);
    int covered = 0, clouded = 0;
    for (int y = 0; y < 37; ++y) {
      for (int x = 0; x < 65; ++x) {
        const std::size_t i = static_cast<std::size_t>(y * 65 + x);
        const double sine = rayDirection(view, {x + 0.5, y + 0.5}).y;
        if (sine < 0) {
          EXPECT_EQ(with[i], without[i]) << x << ", " << y;
          ++covered;
        } else if (sine > 0.1) {
          clouded += with[i] != without[i];
        }
      }
    }
    EXPECT_GT(covered, 500);
    EXPECT_GT(clouded, 500);
  }
}

TEST_F(CloudPlanesGLTest, onlyFewerPixelsHoldALayerOfTheirOwn) {
  planes_.count = 1;
  addPlanes();
  const View view = small({0, 300, 0}, 40, 20);
  frame(view);
  const auto held = [&] {
    return std::pair(context().resources().live(gl::ObjectKind::texture),
                     context().resources().live(gl::ObjectKind::frameBuffer));
  };
  const auto full = held();
  planes_.resolution = clouds::SheetResolution::half;
  frame(view);
  EXPECT_EQ(held(), std::pair(full.first + 1, full.second + 1));
  planes_.resolution = clouds::SheetResolution::full;
  frame(view);
  EXPECT_EQ(held(), full);
}

TEST_F(CloudPlanesGLTest, newNoiseReplacesTheOldWhenItIsReady) {
  // Drawing never waits: until the noise of a changed row is there the picture is the one before, exactly.
  planes_.count = 1;
  addPlanes();
  const View view = small({0, 300, 0}, 40, 20);
  const Light before = frame(view);
  planes_.layers[0].textureSide = 1024;
  planes_.layers[0].seed = 77;
  pass_->apply(planes_, wind_);
  draw(view);
  EXPECT_EQ(difference(light_, before), 0) << "or 10 million samples were made within a frame";
  EXPECT_GT(meanDifference(frame(view), before), 1);
}

TEST_F(CloudPlanesGLTest, onlyLayersThatAreDrawnHoldTextures) {
  // One layer holds one texture less than two.
  const auto textures = [&] { return context().resources().live(gl::ObjectKind::texture); };
  planes_.count = 1;
  addPlanes();
  const View view = small({0, 300, 0}, 40, 20);
  frame(view);
  const std::int64_t one = textures();
  planes_.count = 2;
  frame(view);
  EXPECT_EQ(textures(), one + 1);
}

TEST_F(CloudPlanesGLTest, evenWithoutWindAndAfterAYearTheyAreDrawn) {
  // Simulated times from 0 to a year, in no wind and in a storm: finite, and in no wind the same picture.
  planes_.count = 1;
  addPlanes();
  const View view = small({0, 300, 0}, 40, 20);
  wind_.speed = 0;
  const Light still = frame(view);
  snapshot_.simulatedSeconds = 3.2e7;
  EXPECT_EQ(difference(frame(view), still), 0);
  wind_.speed = 60;
  EXPECT_TRUE(areFinite(frame(view)));
  EXPECT_GT(meanDifference(light_, still), 1);
}

}  // namespace
}  // namespace skydrop::render
