// The cloud dome in frames.
#include "skydrop/render/clouds/cloud_dome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "skydrop/render/sky/sky_pass.h"
#include "support/cloud_rows.h"

namespace skydrop::render {
namespace {

using Light = std::vector<glm::vec4>;

class CloudDomeGLTest : public test::CloudRowsGLTest {
 protected:
  void SetUp() override {
    CloudRowsGLTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::LightProbe>(light_));
    addSky();
    dome_.textureSide = 64;
    auto pass = std::make_unique<CloudDome>(context(), nullptr, dome_);
    pass_ = pass.get();
    renderer().add(std::move(pass));
  }

  Light frame(const View& view) {
    pass_->apply(dome_);
    pass_->waitForNoise();
    draw(view);
    return light_;
  }
  Light sky(const View& view) {
    const double kept = std::exchange(dome_.bias, 0.0);
    const Light light = frame(view);
    dome_.bias = kept;
    return light;
  }
  std::optional<std::string> reason(const View& view) {
    pass_->apply(dome_);
    return pass_->skipReason(gameFrame(snapshot_, view, features_));
  }

  clouds::CloudDomeSettings dome_;
  CloudDome* pass_ = nullptr;
  Light light_;
};

TEST_F(CloudDomeGLTest, lowerCutoffsCoverMore) {
  // From .85 to .3 clouds form: each step changes more of the sky than the one before, by the mean.
  const View view = small({0, 300, 0}, 40, 40);
  const Light without = sky(view);
  double before = -1;
  for (const double cutoff : {0.85, 0.7, 0.6, 0.5, 0.4}) {
    dome_.cutoff = cutoff;
    const Light with = frame(view);
    EXPECT_TRUE(areFinite(with));
    double sum = 0;
    for (std::size_t i = 0; i < with.size(); ++i)
      sum += static_cast<double>(glm::length(shown(with[i]) - shown(without[i])));
    EXPECT_GE(sum, before) << cutoff;
    before = sum;
  }
  EXPECT_GT(before, 100);
}

TEST_F(CloudDomeGLTest, directionsAreAllThatCounts) {
  // Two eyes at one height and 1e12 m apart see the same pixels, to the last bit.
  const Light here = frame(small({0, 300, 0}, 40, 30));
  EXPECT_EQ(difference(here, frame(small({1e12, 300, -3e11}, 40, 30))), 0);
}

TEST_F(CloudDomeGLTest, landHidesIt) {
  // A plain above the eye covers all of the sky: with and without the dome the frame is the same.
  addPlains();
  const View view = small({0, 300, 0}, 40, 50);
  EXPECT_GT(difference(frame(view), sky(view)), 5);
  plains_ = {{500, glm::vec3(0.1f)}};
  EXPECT_EQ(difference(frame(view), sky(view)), 0);
}

TEST_F(CloudDomeGLTest, fadesIntoTheHorizonWithoutAnEdge) {
  // All cloud: at the horizon the frame is the sky within 2 of 255, and neighbouring rows of pixels differ by
  // less than a quarter of what the cloud adds.
  dome_.cutoff = 0;
  const View view = pose({0, 300, 0}, 220, 10, 0, 64, 144);
  const Light with = frame(view), without = sky(view);
  double before = 0, most = 0, all = 0;
  for (int y = 0; y < 144; ++y) {
    const std::size_t i = static_cast<std::size_t>(y * 64 + 32);
    const double apart = 255 * static_cast<double>(glm::length(shown(with[i]) - shown(without[i])));
    const double sine = rayDirection(view, {32.5, y + 0.5}).y;
    if (sine < 0.004) {
      EXPECT_LT(apart, 2) << y;
    }
    most = std::max(most, std::abs(apart - before));
    all = std::max(all, apart);
    before = apart;
  }
  EXPECT_GT(all, 20);
  EXPECT_LT(most, all / 4);
}

TEST_F(CloudDomeGLTest, whatCannotTouchTheFrameSaysWhy) {
  // No sky in view, no cloud left, no opacity: each has its reason.
  const View up = small({0, 300, 0}, 40, 14);
  EXPECT_EQ(reason(up), std::nullopt);
  EXPECT_EQ(reason(small({0, 300, 0}, 40, -60)), "no sky above the horizon in view");
  dome_.cutoff = 1;
  EXPECT_EQ(reason(up), "the cutoff leaves no cloud");
  dome_.cutoff = 0.5;
  dome_.bias = 0;
  EXPECT_EQ(reason(up), "the bias leaves no cloud");
}

TEST_F(CloudDomeGLTest, aViewDoesNotShowItsNoiseTwice) {
  // Autocorrelation of the opacity over a view of 64 x 64 pixels straight up, at the smallest clouds that the
  // slider gives: away from the middle no shift of 12 pixels and more correlates by 0.6 or more. (A copy of
  // the noise would by nearly 1.)
  dome_.scale = 0.8;
  const View view = pose({0, 300, 0}, 0, 90, 0, 64, 64);
  const Light with = frame(view), without = sky(view);
  std::vector<double> cover(64 * 64);
  double mean = 0;
  for (std::size_t i = 0; i < cover.size(); ++i) {
    cover[i] = static_cast<double>(glm::length(shown(with[i]) - shown(without[i])));
    mean += cover[i] / static_cast<double>(cover.size());
  }
  double worst = 0;
  for (int dy = 0; dy <= 40; ++dy) {
    for (int dx = -40; dx <= 40; ++dx) {
      if (dx * dx + dy * dy < 144) continue;
      double ab = 0, aa = 0, bb = 0;
      for (int y = 0; y + dy < 64; ++y) {
        for (int x = std::max(0, -dx); x < 64 && x + dx < 64; ++x) {
          const double a = cover[static_cast<std::size_t>(y * 64 + x)] - mean,
                       b = cover[static_cast<std::size_t>((y + dy) * 64 + x + dx)] - mean;
          ab += a * b, aa += a * a, bb += b * b;
        }
      }
      worst = std::max(worst, ab / std::sqrt(aa * bb + 1e-12));
    }
  }
  EXPECT_LT(worst, 0.6);
}

TEST_F(CloudDomeGLTest, fewerPixelsShowTheSameCloudsSofter) {
  // Half the resolution changes the picture by less than a tenth of what the clouds do in the mean, a quarter
  // by less than a fifth.
  dome_.cutoff = 0.5;
  const View view = pose({0, 300, 0}, 40, 40, 0, 320, 180);
  const auto meanDifference = [](const Light& a, const Light& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += static_cast<double>(glm::length(shown(a[i]) - shown(b[i])));
    return sum / static_cast<double>(a.size());
  };
  const Light full = frame(view);
  const double clouds = meanDifference(full, sky(view));
  double before = 0;
  for (const auto& [resolution, most] :
       {std::pair(clouds::SheetResolution::half, 0.1), std::pair(clouds::SheetResolution::quarter, 0.2)}) {
    dome_.resolution = resolution;
    const double off = meanDifference(frame(view), full) / clouds;
    RecordProperty(std::string(clouds::kSheetResolutionNames[static_cast<std::size_t>(resolution)]),
                   std::to_string(off));
    EXPECT_GT(off, before);
    EXPECT_LT(off, most);
    before = off;
  }
}

TEST_F(CloudDomeGLTest, landCutsItAtEveryPixelInAnyResolution) {
  // A plain below the eye, banked: each pixel that it fills is to the last bit that of a frame without the
  // dome.
  dome_.cutoff = 0.2;
  addPlains();
  plains_ = {{200, glm::vec3(0.1f)}};
  const View view = pose({0, 300, 0}, 40, 3, 33, 65, 37);
  for (const auto resolution :
       {clouds::SheetResolution::full, clouds::SheetResolution::half, clouds::SheetResolution::quarter}) {
    dome_.resolution = resolution;
    const Light with = frame(view), without = sky(view);
    for (int y = 0; y < 37; ++y) {
      for (int x = 0; x < 65; ++x) {
        const std::size_t i = static_cast<std::size_t>(y * 65 + x);
        if (rayDirection(view, {x + 0.5, y + 0.5}).y < 0) {
          EXPECT_EQ(with[i], without[i]) << x << ", " << y;
        }
      }
    }
    EXPECT_GT(difference(with, without), 10);
  }
}

TEST_F(CloudDomeGLTest, newNoiseReplacesTheOldWhenItIsReady) {
  // Drawing never waits: until the noise of a changed row is there the picture is the one before, exactly.
  const View view = small({0, 300, 0}, 40, 40);
  const Light before = frame(view);
  dome_.textureSide = 256;
  dome_.seed = 99;
  pass_->apply(dome_);
  draw(view);
  EXPECT_EQ(difference(light_, before), 0) << "or 100 million samples were made within a frame";
  dome_.textureSide = 64;
  EXPECT_GT(difference(frame(view), before), 5);
}

}  // namespace
}  // namespace skydrop::render
