// The history of the clouds: a frame that follows another marches a share of its rays and takes the rest from
// there, and nothing that was there before shows where it is no longer.
#include "render/clouds/cloud_history.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "support/cloud_rows.h"
#include "support/margin.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

using clouds::CloudTier, clouds::MarchHistory;

constexpr int kWidth = 96, kHeight = 54, kRound = 16;
constexpr double kFrameS = 1.0 / 60;

class CloudHistoryGLTest : public test::CloudRowsGLTest {
 protected:
  void SetUp() override {
    CloudRowsGLTest::SetUp();
    clouds_.march = test::rowsOf(CloudTier::high);
    clouds_.march.history = MarchHistory::sixteenth;
    wind_.speed = 10;
  }
  View sight(const glm::dvec3& position, double yaw, double pitch, double roll = 0) const {
    return pose(position, yaw, pitch, roll, kWidth, kHeight);
  }
  // On a flight straight on below the clouds.
  View onTheWay(int frame) const { return sight({70 * kFrameS * frame, 700, 0}, 0, 14); }
  std::vector<glm::vec4> raysOf(const View& view, double seconds, bool follows = true) {
    system_->apply(clouds_, wind_);
    FrameInput input = gameFrame(snapshot_, view, features_);
    input.simulatedSeconds = seconds;
    input.followsLast = follows;
    draw(input);
    const gl::Texture& light = system_->light();
    std::vector<glm::vec4> texels(static_cast<std::size_t>(light.width() * light.height()));
    light.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
    return texels;
  }
  std::vector<glm::vec4> fly(int frames, int first = 0) {
    std::vector<glm::vec4> rays;
    for (int frame = first; frame < first + frames; ++frame) rays = raysOf(onTheWay(frame), frame * kFrameS);
    return rays;
  }
  void writeTexel(const gl::Texture& texture, const glm::ivec2& at, GLenum format, const glm::vec4& value) {
    context().api().TextureSubImage2D(texture.id(), 0, at.x, at.y, 1, 1, format, GL_FLOAT, &value);
  }
};

TEST_F(CloudHistoryGLTest, C26_damagedTexelsAreGoneAfterOneFrame) {
  // Light and distances that are no numbers, infinite or out of range in the picture that a frame leaves
  // behind: the next one is finite everywhere, and differs from that of the same flight without damage by
  // what rays marched there at once differ, less than 3 of 255 in the mean of a pixel and only around there.
  addClouds(test::sharedNoise());
  const std::vector<glm::vec4> undamaged = fly(7);
  raysOf(onTheWay(0), 0, false);
  fly(6);
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::array<float, 4> bad = {nan, inf, -1.0f, -inf};
  for (int y = 3; y < kHeight; y += 9) {
    for (int x = 3; x < kWidth - 2; x += 7) {
      const float value = bad[static_cast<std::size_t>(x + y) % bad.size()];
      writeTexel(system_->rays()[0].light, {x, y}, GL_RGBA, glm::vec4(value));
      writeTexel(system_->rays()[0].distances, {x + 2, y}, GL_RED, glm::vec4(value));
    }
  }
  const std::vector<glm::vec4> next = fly(1, 6);
  EXPECT_TRUE(areFinite(next));
  EXPECT_TRUE(test::holds("C26", meanDifference(next, undamaged), test::below(3), "of 255"));
}

TEST_F(CloudHistoryGLTest, atRestThePictureBecomesThatOfTighterTolerances) {
  // After a round of frames every ray has been marched from here, and the picture is, bit for bit, that of a
  // quarter of the tolerances without history; and it stays.
  addClouds(test::sharedNoise());
  const View view = onTheWay(0);
  std::vector<glm::vec4> rays;
  for (int frame = 0; frame < 3 * kRound; ++frame) rays = raysOf(view, 0);
  const std::vector<glm::vec4> later = raysOf(view, 0);
  const CloudSystem::Work work = system_->lastWork();
  clouds_.march.coarseTolerance /= 4;
  clouds_.march.fineTolerance /= 4;
  const std::vector<glm::vec4> whole = raysOf(view, 0, false);
  EXPECT_TRUE(rays == later);
  EXPECT_TRUE(rays == whole) << difference(rays, whole);
  EXPECT_LT(work.finestRays, system_->lastWork().finestRays / 8);
}

TEST_F(CloudHistoryGLTest, framesThatFollowNoneHaveNoHistory) {
  // Whatever the row says, they hold as many bytes, compile as many programs and show the same bits as with
  // history off; what frames that follow have made is given up in the first that does not.
  clouds_.march.history = MarchHistory::off;
  addClouds(test::sharedNoise());
  const std::vector<glm::vec4> off = raysOf(onTheWay(0), 0, true);
  const std::uint64_t bytes = context().resources().bytes();
  const std::size_t programs = renderer().shaders().size();
  clouds_.march.history = MarchHistory::sixteenth;
  EXPECT_TRUE(raysOf(onTheWay(0), 0, false) == off);
  EXPECT_EQ(context().resources().bytes(), bytes);
  EXPECT_EQ(renderer().shaders().size(), programs);
  EXPECT_EQ(system_->history(), nullptr);
  fly(3);
  EXPECT_GT(context().resources().bytes(), bytes);
  EXPECT_TRUE(raysOf(onTheWay(0), 0, false) == off);
  EXPECT_EQ(context().resources().bytes(), bytes);
}

TEST_F(CloudHistoryGLTest, theSameFlightHasTheSameBits) {
  addClouds(test::sharedNoise());
  const std::vector<glm::vec4> first = fly(12);
  raysOf(onTheWay(0), 0, false);
  EXPECT_TRUE(fly(12) == first);
}

TEST_F(CloudHistoryGLTest, afterACutNothingIsLeftOfTheFramesBefore) {
  // A leap of the eye, of time or of the view's size: bit for bit the picture of a first frame.
  addClouds(test::sharedNoise());
  const View elsewhere = sight({3000, 900, 500}, 130, 12);
  const View smaller = pose({0, 700, 0}, 0, 14, 0, 70, 40);
  for (const View& view : {elsewhere, smaller}) {
    raysOf(onTheWay(0), 0, false);
    const std::vector<glm::vec4> fresh = raysOf(view, 0.1);
    raysOf(onTheWay(0), 0, false);
    fly(5);
    EXPECT_TRUE(raysOf(view, 0.1) == fresh);
  }
  raysOf(onTheWay(0), 0, false);
  const std::vector<glm::vec4> later = raysOf(onTheWay(5), 900);
  raysOf(onTheWay(0), 0, false);
  fly(5);
  EXPECT_TRUE(raysOf(onTheWay(5), 900) == later);
}

TEST_F(CloudHistoryGLTest, aSurfaceThatGoesLeavesNoGhost) {
  // A plain in the middle of the layer that hides the clouds below it, and in the next frame is gone: around
  // where it was the picture is that of a frame without history, within 2 of 255 in the mean.
  addClouds(test::sharedNoise());
  addPlains();
  const auto seen = [&](bool follows) { return raysOf(sight({0, 4500, 0}, 40, -25), 0, follows); };
  const std::vector<glm::vec4> without = seen(false);
  const std::vector<test::Plain> high = {{2600, {0.2f, 0.3f, 0.1f}}};
  plains_ = high;
  const std::vector<glm::vec4> hidden = seen(false);
  EXPECT_GT(meanDifference(hidden, without), 10) << "the plain hides nothing";
  for (int frame = 0; frame < 4; ++frame) seen(true);
  plains_.clear();
  EXPECT_LT(meanDifference(seen(true), without), 2);
  // And one that comes hides what it has to at once.
  for (int frame = 0; frame < 20; ++frame) seen(true);
  plains_ = high;
  EXPECT_LT(meanDifference(seen(true), hidden), 2);
}

TEST_F(CloudHistoryGLTest, inFlightThePictureStaysNearThatWithout) {
  // Straight on, in a turn at 60 degrees of bank (14 degrees a second) and past edges at 120 m/s, in a
  // picture so coarse that a pixel is 80 m of a cloud 8 km away: the mean difference from the same frame
  // without history stays below 3 of 255, and some rays are saved.
  addClouds(test::sharedNoise());
  const auto on = [&](int path, int frame) {
    const double t = frame * kFrameS;
    if (path == 0) return onTheWay(frame);
    if (path == 1) return sight({70 * t, 700, 0}, -14 * t, 14, 60);
    return sight({120 * t, 2300, 600}, 0, 0);
  };
  for (int path = 0; path < 3; ++path) {
    raysOf(on(path, 0), 0, false);
    const CloudSystem::Work whole = system_->lastWork();
    std::vector<glm::vec4> rays;
    for (int frame = 0; frame <= 30; ++frame) rays = raysOf(on(path, frame), frame * kFrameS);
    const CloudSystem::Work some = system_->lastWork();
    const double apart = meanDifference(rays, raysOf(on(path, 30), 30 * kFrameS, false));
    EXPECT_LT(apart, 3) << path;
    EXPECT_LT(some.finestRays + some.raysBetween, (whole.finestRays + whole.raysBetween) * 3 / 4) << path;
    RecordProperty("difference" + std::to_string(path), std::to_string(apart));
  }
}

TEST(CloudFrame, aFrameAfterACutContinuesNothing) {
  // Every way in which a frame may show something else than the one before it, one at a time.
  const CloudFrame past;
  CloudFrame next = past;
  next.seconds = kFrameS;
  next.view.position = next.eyeInField = {2, 0, 0};
  EXPECT_TRUE(continues(past, next));
  const auto refuses = [&](const std::function<void(CloudFrame&)>& change) {
    CloudFrame other = next;
    change(other);
    return !continues(past, other);
  };
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.seconds = -kFrameS; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.seconds = 0.3; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.seconds = std::nan(""); }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.view.position.x = 15; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.eyeInField.z = 15; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.view.width += 1; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.view.worldToView = glm::dmat3(0, 0, 1, 0, 1, 0, -1, 0, 0); }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.toSun = {1, 0, 0}; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.atmosphere.visibilityM = 2000; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.settings.layers[0].coverage = 0.9; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.settings.march.stepM = 9; }));
  EXPECT_TRUE(refuses([](CloudFrame& f) { f.defines = {"HAZE"}; }));
}

}  // namespace
}  // namespace skydrop::render
