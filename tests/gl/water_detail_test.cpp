// Water close by in frames: as bright as the sea that is statistics alone, the same far out, without shimmer,
// mirroring what the processor's rays meet, and nothing where it is absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "support/lagoon_gl_test.h"
#include "support/margin.h"
#include "support/mirrored_rays.h"
#include "support/row_steps.h"

namespace skydrop::app {
namespace {

class WaterDetailGLTest : public test::LagoonGLTest {
 protected:
  // Mean light of the picture's lower half.
  double seaLight() {
    const std::vector<float> of = light();
    double sum = 0;
    for (std::size_t i = of.size() / 2; i < of.size(); ++i) sum += static_cast<double>(of[i]);
    return sum / static_cast<double>(of.size() / 2);
  }
  std::string reasonOf(std::string_view pass) {
    frame();
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    for (const auto& [name, row] : statistics.passes)
      if (name == pass) return row.skipped;
    return "absent";
  }
  static double meanDifference(const core::Image& a, const core::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
    return sum / static_cast<double>(a.rgba.size());
  }
};

TEST_F(WaterDetailGLTest, O05_meanLightIsThatOfTheSeaAsStatistics) {
  // Waves that are drawn take their slope out of the statistics: over deep water without foam, in a wind of
  // 7 m/s (which the sea without them has), the mean light of the sea is the same within 16 % from 5 to 400
  // m, towards the sun and away from it.
  begin({"waterDetail.foam=0", "wind.speed=7", "waterDetail.reflection=off", "render.sun.elevationDegrees=40",
         "render.sun.azimuthDegrees=110"});
  struct Mean {
    double above, yaw, light;
  };
  std::vector<Mean> with;
  const std::vector<std::pair<double, double>> looks = {{5, 20},   {5, 200},   {20, 20},
                                                        {20, 200}, {150, 200}, {400, 200}};
  const auto lightAt = [&](double above, double yaw) {
    double sum = 0;
    // Low down a picture shows a few of the long waves: more places count.
    const int places = above < 50 ? 10 : 3;
    for (int i = 0; i < places; ++i) {
      snapshot_.simulatedSeconds = 7.3 * i;
      look(kOpenSea + glm::dvec2(37, -21) * static_cast<double>(i - places / 2), above, yaw, -18);
      sum += seaLight() / places;
    }
    return sum;
  };
  for (const auto& [above, yaw] : looks) with.push_back({above, yaw, lightAt(above, yaw)});
  begin({"effects.waterDetail=false", "render.sun.elevationDegrees=40", "render.sun.azimuthDegrees=110"});
  for (const Mean& m : with) {
    const double plain = lightAt(m.above, m.yaw);
    std::printf("[ sea ] %.0f m, yaw %.0f: %.4f of %.4f\n", m.above, m.yaw, m.light, plain);
    EXPECT_TRUE(test::holds("O05", std::abs(m.light / plain - 1), test::below(0.16), "of the light"));
  }
}

TEST_F(WaterDetailGLTest, O06_theSeaIsTheSameFarOutAndLate) {
  // 1e8 m out and a year late the sea still has waves as steep, moving as fast: two moments differ as much as
  // at the origin within a third, and the same moment not at all.
  begin({"waterDetail.foam=0", "render.land.detail=plain"});
  const auto change = [&](const glm::dvec2& at, double from) {
    look(at, 12, 20, -25);
    snapshot_.simulatedSeconds = from;
    const core::Image first = frame();
    snapshot_.simulatedSeconds = from + 0.5;
    return meanDifference(first, frame());
  };
  // The next sea of the same land far out.
  const auto seaNear = [&](glm::dvec2 at) {
    for (int i = 0; i < 4000; ++i, at.x += 400) {
      double highest = -1e9;
      for (const double dx : {-150.0, 0.0, 150.0})
        for (const double dz : {-150.0, 0.0, 150.0})
          highest = std::max(highest, simulation_->ground()->height(at + glm::dvec2(dx, dz)));
      if (highest < -12) return at;
    }
    ADD_FAILURE() << "no sea";
    return at;
  };
  const double here = change(kOpenSea, 100);
  const double there = change(seaNear({1e8, -1e8}), 365.0 * 86400 + 100);
  std::printf("[ sea ] half a second: %.2f here, %.2f far out\n", here, there);
  EXPECT_GT(here, 1);
  EXPECT_TRUE(test::holds("O06", std::abs(there / here - 1), test::below(0.5), "of the change"));
  const core::Image once = frame();
  EXPECT_EQ(meanDifference(once, frame()), 0);
}

TEST_F(WaterDetailGLTest, O07_nothingShimmersWhereWavesAreFinerThanPixels) {
  // From 3 km up no wave is shown: in half a second the picture changes by less than half a step in the mean.
  begin({"waterDetail.foam=1", "render.land.detail=plain"});
  look(kOpenSea, 3000, 20, -80);
  const core::Image first = frame();
  snapshot_.simulatedSeconds += 0.5;
  const double change = meanDifference(first, frame());
  EXPECT_TRUE(test::holds("O07", change, test::below(0.5), "of 255"));
}

TEST_F(WaterDetailGLTest, O08_waterMirrorsWhatRaysMeet) {
  // A calm sea mirrors land where rays from its surface meet the land of the processor.
  begin({"wind.speed=0", "waterDetail.reflection=full", "waterDetail.reflectionSteps=256",
         "waterDetail.reflectionRays=1", "waterDetail.foam=0", "effects.haze=false",
         "render.sun.elevationDegrees=50", "render.sun.azimuthDegrees=290"});
  look(kOpenSea, 4, 20, -4);
  frame();
  const std::vector<float> with = sceneRenderer_->renderer().readRadiance();
  const render::View view = sceneRenderer_->view(snapshot_, kSize);
  set("waterDetail.reflection=off");
  frame();
  const test::MirrorAgreement found = test::mirrorAgreement(view, *simulation_->ground(), with,
                                                            sceneRenderer_->renderer().readRadiance(), 16);
  std::printf("[ mirror ] %d of %d agree; %d of %d that meet land\n", found.agree, found.asked, found.found,
              found.meet);
  EXPECT_GE(found.found, 0.9 * found.meet);
  EXPECT_GT(found.meet, 20);
  EXPECT_GT(found.asked - found.meet, 100);
  EXPECT_TRUE(test::holds("O08", found.missed(), test::below(0.12), "of the pixels"));
}

TEST_F(WaterDetailGLTest, passesSayWhyTheyAreIdle) {
  begin();
  look(kShore, 8, 75, -4);
  EXPECT_EQ(reasonOf("waterReflection"), "");
  set("waterDetail.reflection=off");
  EXPECT_EQ(reasonOf("waterReflection"), "water mirrors the sky alone");
  set("waterDetail.reflection=half");
  look(kShore, 8, 75, 60);
  EXPECT_EQ(reasonOf("waterReflection"), "the view shows no water");
  look(kShore, 9000, 75, -20);
  EXPECT_EQ(reasonOf("waterReflection"), "the view is too high for what water mirrors");
}

TEST_F(WaterDetailGLTest, everyTenthOfEveryRowMakesADifference) {
  begin({"wind.speed=14", "waterDetail.mirror=plane"});
  const int rows = test::expectNoIdleSteps(run_->table, {"waterDetail."}, [&] {
    sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
    core::StateHasher h;
    for (const double above : {2.5, 12.0}) {
      look(kShore + glm::dvec2(20, 75), above, 75, above > 5 ? -12 : -30);
      for (const auto byte : frame().rgba) h.add(std::uint64_t{byte});
    }
    return h.value();
  });
  EXPECT_EQ(rows, 11);
}

}  // namespace
}  // namespace skydrop::app
