// Grass, flowers, reeds and stones in frames: on the land that is drawn, the same from everywhere, without
// pops, as bright as the ground, bent by the wind, and absent where nothing can be seen of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "render/ground_cover/cover_tiles.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/ground_cover/ground_cover_pass.h"
#include "support/margin.h"
#include "support/row_steps.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{192, 108};
constexpr double kDegree = std::numbers::pi / 180;
constexpr glm::dvec2 kMeadow(4420, -530), kScree(3000, -3000), kShore(2746, 2630);
constexpr std::size_t kLists = render::GroundCoverPass::kLists;

class GroundCoverGLTest : public test::SceneGLTest {
 protected:
  void begin(std::vector<std::string> set = {}) {
    beginScene(
        lineOf("lowlevel", {"effects.groundCover=true", "effects.targets=false", "effects.hud=false"}, set),
        1);
    snapshot_ = simulation_->world().now();
    snapshot_.aircraft.present = false;
    sceneRenderer_->camera().setMode(render::CameraMode::free);
  }

  // So high above the land at a place; yaw 0 looks along +x.
  void look(const glm::dvec2& at, double above, double yawDeg, double pitchDeg) {
    const double ground = simulation_->ground()->height(at);
    sceneRenderer_->camera().setPose({at.x, ground + above, at.y}, yawDeg * kDegree, pitchDeg * kDegree, 0);
  }
  core::Image frame() {
    sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }
  std::vector<float> light() {
    frame();
    return sceneRenderer_->renderer().readRadiance();
  }
  const render::GroundCoverPass& pass() {
    return *sceneRenderer_->renderer().find<render::GroundCoverPass>();
  }
  std::uint32_t drawn() {
    frame();
    const auto counts = pass().drawn();
    return std::accumulate(counts.begin(), counts.end(), 0u);
  }
  // All feet of a frame (world, m), and heights.
  std::vector<std::pair<glm::dvec3, double>> feet() {
    frame();
    const glm::dvec3 eye = sceneRenderer_->view(snapshot_, kSize).position;
    std::vector<std::pair<glm::dvec3, double>> all;
    for (std::size_t list = 0; list < kLists; ++list) {
      for (const glm::vec4& foot : pass().feet(list)) all.emplace_back(eye + glm::dvec3(foot), foot.w);
    }
    return all;
  }
  std::string reason() {
    frame();
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    for (const auto& [name, row] : statistics.passes)
      if (name == "groundCover") return row.skipped;
    return "absent";
  }
  static double meanDifference(const core::Image& a, const core::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
    return sum / static_cast<double>(a.rgba.size());
  }

  game::Snapshot snapshot_;
};

TEST_F(GroundCoverGLTest, Q01_theSameThingsStandWhereverTheFrameCountsFrom) {
  // Half a metre to both sides of a chunk's corner, from which positions are counted, the same things stand
  // within 4 m: feet within 2 cm, near the origin and 1e9 m out.
  begin();
  for (const glm::dvec2& corner : {glm::dvec2(4320, -960), glm::dvec2(960e6 + 960 * 41666, 960e6)}) {
    const auto around = [&](double aside, double radius, double least) {
      look(corner + glm::dvec2(aside, aside), 9, 45, -89.9);
      std::vector<std::pair<glm::dvec3, double>> near;
      for (const auto& [foot, height] : feet()) {
        if (glm::length(glm::dvec2(foot.x, foot.z) - corner) < radius && height > least)
          near.emplace_back(foot, height);
      }
      return near;
    };
    const auto one = around(-0.4, 4, 0.1), other = around(0.4, 5, 0);
    EXPECT_GT(one.size(), corner.x < 1e6 ? 20u : 0u);
    double farthest = 0;
    for (const auto& [foot, height] : one) {
      double nearest = 1e9;
      for (const auto& [twin, twinHeight] : other)
        nearest = std::min(nearest, glm::length(glm::dvec2(foot.x - twin.x, foot.z - twin.z)));
      farthest = std::max(farthest, nearest);
    }
    std::printf("[ bases ] %zu and %zu things, apart %.4f m\n", one.size(), other.size(), farthest);
    EXPECT_TRUE(test::holds("Q01", farthest, test::below(0.02), "m"));
  }
}

TEST_F(GroundCoverGLTest, Q02_feetStandOnTheLand) {
  // On a meadow, on scree 30 degrees steep and at a shore, from 5 m: 98 of 100 feet lie within half a metre
  // of the exact land, and each kind is seen.
  begin();
  std::array<std::uint32_t, kLists> seen{};
  for (const glm::dvec2& at : {kMeadow, kScree, kShore}) {
    look(at, 5, 40, -12);
    const auto all = feet();
    const auto counts = pass().drawn();
    for (std::size_t i = 0; i < kLists; ++i) seen[i] += counts[i];
    EXPECT_GT(all.size(), 50u);
    std::size_t off = 0;
    for (const auto& [foot, height] : all)
      off += std::abs(simulation_->ground()->height({foot.x, foot.z}) - foot.y) > 0.5;
    EXPECT_TRUE(test::holds("Q02", static_cast<double>(off) / static_cast<double>(all.size()),
                            test::atMost(0.02), "of the feet"))
        << off << " of " << all.size();
  }
  // Stones of more pixels, and boulders of many, are where one stands before them.
  for (int i = 0; i < 120 && (seen[kLists - 2] == 0 || seen[kLists - 1] == 0); ++i) {
    look(kScree + glm::dvec2(1.5 * i, 0), 0.7, 40, -30);
    frame();
    const auto counts = pass().drawn();
    for (std::size_t list = kLists - 2; list < kLists; ++list) seen[list] += counts[list];
  }
  for (std::size_t i = 0; i < kLists; ++i) EXPECT_GT(seen[i], 0u) << i;
}

TEST_F(GroundCoverGLTest, Q03_nothingComesOrGoesAtOnce) {
  // At 70 m/s and 60 frames a second all comes 1.17 m nearer in a frame. The same picture with the reach of
  // the nearest things moved by that, and of all others by more, differs by at most 1/255 in the mean, and no
  // thing grows by 30 cm.
  begin();
  for (const double above : {3.0, 8.0, 20.0}) {
    look(kMeadow, above, 40, -12);
    const auto heights = [&] {
      std::map<std::pair<long, long>, double> of;  // by place, to 5 mm
      for (const auto& [foot, height] : feet())
        of[{std::lround(200 * foot.x), std::lround(200 * foot.z)}] = height;
      return of;
    };
    set("groundCover.density=1"), set("groundCover.reachM=150");
    const core::Image before = frame();
    const auto heightsBefore = heights();
    set("groundCover.density=1.12"), set("groundCover.reachM=151.17");
    const double change = meanDifference(before, frame());
    double mostGrown = 0;
    for (const auto& [place, height] : heights()) {
      const auto same = heightsBefore.find(place);
      mostGrown = std::max(mostGrown, height - (same == heightsBefore.end() ? 0 : same->second));
    }
    std::printf("[ border ] %.0f m: %.4f / 255 a frame, %.2f m at most\n", above, change, mostGrown);
    EXPECT_TRUE(test::holds("Q03", change, test::atMost(1), "of 255"));
    EXPECT_LT(mostGrown, 0.3) << "something came at once";
    EXPECT_GT(change, 0) << "nothing grew";
  }
}

TEST_F(GroundCoverGLTest, Q04_whereNothingCanBeSeenNothingIsDone) {
  // Each reason; without the effect there is no pass and the picture is that of no density, bit for bit.
  begin();
  look(kMeadow, 5, 40, -12);
  EXPECT_EQ(reason(), "");
  EXPECT_GT(drawn(), 100u);
  set("groundCover.density=0");
  EXPECT_EQ(reason(), "nothing is to stand on the ground");
  const core::Image idle = frame();
  set("groundCover.density=1"), set("groundCover.reachM=0");
  EXPECT_EQ(reason(), "nothing is to stand on the ground");
  set("groundCover.reachM=150");
  sceneRenderer_->camera().setPose({kMeadow.x, 4000, kMeadow.y}, 0, -1, 0);
  EXPECT_EQ(reason(), "the ground is too far below");
  sceneRenderer_->camera().setPose({4400, 5, 4300}, 0, -0.1, 0);
  EXPECT_EQ(reason(), "there is deep water alone near by");
  begin({"effects.groundCover=false"});
  look(kMeadow, 5, 40, -12);
  EXPECT_EQ(reason(), "absent");
  EXPECT_EQ(frame().rgba, idle.rgba);
  test::noFaults("Q04", "things");
}

TEST_F(GroundCoverGLTest, Q05_lightStaysWithinHalfFloats) {
  // An eye in the grass, on the ground, below it, in a reed bed and at the end of the reach, towards a low
  // sun and straight down, in a storm: finite, none below 0, none above what is kept.
  begin({"render.sun.elevationDegrees=3", "render.sun.azimuthDegrees=90", "groundCover.density=3",
         "groundCover.sway=3"});
  test::noFaults("Q05", "lights");
  snapshot_.wind = {40, 0, 25};
  float brightest = 0;
  for (const glm::dvec2& at : {kMeadow, kScree, kShore}) {
    for (const double above : {0.05, 0.0, -3.0, 149.9}) {
      for (const double pitch : {2.0, -90.0}) {
        look(at, above, 0, pitch);
        for (const float value : light()) {
          ASSERT_TRUE(value >= 0) << above;
          brightest = std::max(brightest, value);
        }
      }
    }
  }
  EXPECT_LT(brightest, 65504) << "where drivers cut what a half float does not keep";
}

TEST_F(GroundCoverGLTest, Q06_whatThereIsMostOfIsBounded) {
  // With the most density and reach, from all heights and sides: no more things than cells of the squares
  // that room is made for, and no more squares.
  begin({"groundCover.density=64", "groundCover.reachM=300"});
  test::noFaults("Q06", "numbers of things");
  const render::CoverReaches reaches = render::coverReaches(300, 64);
  const std::size_t most = render::mostCoverTiles(reaches);
  for (const double above : {0.5, 5.0, 60.0}) {
    for (const double pitch : {-3.0, -45.0, -90.0}) {
      look(kMeadow, above, 130, pitch);
      EXPECT_LE(drawn(), 64 * most);
      const render::View view = sceneRenderer_->view(snapshot_, kSize);
      EXPECT_LE(render::coverTiles(view, {3840, -960}, *simulation_->ground(), reaches).size(), most);
    }
  }
}

TEST_F(GroundCoverGLTest, aMeadowStaysAsBrightAsItWas) {
  // The ground half of pictures from 5 and 20 m has the same mean of light within 6 % with the effect as
  // without.
  begin();
  for (const double above : {5.0, 20.0}) {
    look(kMeadow, above, 40, -25);
    const auto mean = [&] {
      const std::vector<float> all = light();
      const std::size_t half = all.size() / 2;  // the lowest row first
      return std::accumulate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(half), 0.0);
    };
    set("groundCover.density=0");
    const double without = mean();
    set("groundCover.density=1");
    const double ratio = mean() / without;
    std::printf("[ mean ] %.0f m: %.3f of the light\n", above, ratio);
    EXPECT_NEAR(ratio, 1, 0.06);
  }
}

TEST_F(GroundCoverGLTest, windBendsGrassAndCalmDoesNot) {
  // In wind a later moment is another picture, and the same moment the same one; in calm nothing moves.
  begin();
  look(kMeadow, 2, 40, -8);
  const auto at = [&](double wind, double seconds) {
    snapshot_.wind = {wind, 0, 0};
    snapshot_.simulatedSeconds = seconds;
    return frame();
  };
  EXPECT_GT(meanDifference(at(12, 1), at(12, 1.6)), 0.1);
  EXPECT_EQ(meanDifference(at(12, 1), at(12, 1)), 0);
  EXPECT_LT(meanDifference(at(0, 1), at(0, 1.6)), 0.02);
}

TEST_F(GroundCoverGLTest, nothingStandsOnAStrip) {
  // Of the things around the start of a grass strip none has its foot on what is mown.
  beginScene(lineOf("airstrip", {"effects.groundCover=true", "effects.clouds=false", "effects.hud=false"}),
             1);
  snapshot_ = simulation_->world().now();
  sceneRenderer_->camera().setMode(render::CameraMode::free);
  const auto strip = simulation_->ground()->strips()->nearest(
      {snapshot_.aircraft.position.x, snapshot_.aircraft.position.z}, 5000);
  ASSERT_TRUE(strip);
  look(strip->middle, 4, 10, -12);
  std::size_t beside = 0;
  for (const auto& [foot, height] : feet()) {
    const glm::dvec2 at = strip->local({foot.x, foot.z});
    EXPECT_FALSE(std::abs(at.x) < strip->halfLength && std::abs(at.y) < strip->halfWidth)
        << at.x << ' ' << at.y;
    ++beside;
  }
  EXPECT_GT(beside, 20u);
}

TEST_F(GroundCoverGLTest, everyTenthOfEveryRowMakesADifference) {
  begin();
  snapshot_.wind = {9, 0, 4};
  snapshot_.simulatedSeconds = 3.3;
  const int rows = test::expectNoIdleSteps(run_->table, {"groundCover."}, [&] {
    sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
    core::StateHasher h;
    for (const double above : {3.0, 15.0}) {
      look(kMeadow, above, 40, -10);
      for (const auto byte : frame().rgba) h.add(std::uint64_t{byte});
    }
    return h.value();
  });
  EXPECT_EQ(rows, 3);
}

}  // namespace
}  // namespace skydrop::app
