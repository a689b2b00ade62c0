// What stands on the ground at places that no land has.
#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/core/shared_ground_cover.h"
#include "support/margin.h"

namespace skydrop {
namespace {

using core::shared::f32::CoverSite;
namespace f32 = core::shared::f32;

TEST(Stability, Q07_whatStandsIsBoundedAnywhere) {
  // Heights from the deep sea to 1e5 m, slopes up to vertical, noise of either sign: sizes are finite, none
  // is below 0 or above what culling counts with; nothing grows on a vertical slope or in deep water.
  test::noFaults("Q07", "sizes");
  for (const float height : {-1e5f, -2.0f, -0.3f, 0.0f, 0.5f, 40.0f, 900.0f, 1e5f}) {
    for (const float up : {0.0f, 0.5f, 0.9f, 1.0f}) {
      for (const float noise : {-1.0f, 0.0f, 1.0f}) {
        const f32::LandNoise land{noise, noise, noise, noise, noise};
        const f32::Crowns crowns{{0, 0}, 0, 0};
        CoverSite site;
        site.land = f32::landSurface(height, up, 0, land, 0, crowns, 0);
        site.heightM = height, site.normalUp = up;
        site.wooded = f32::forestDensity(height, up, 0, land);
        site.region = noise, site.tuft = noise, site.patches = {noise, -noise};
        for (std::uint32_t i = 0; i < 400; ++i) {
          const int level = static_cast<int>(i) % f32::kCoverLevels;
          const std::uint32_t bits = f32::coverBits({i * 7919u, i}, level);
          const f32::Cover cover = f32::coverOf(bits, level, site);
          ASSERT_TRUE(cover.heightM >= 0 && cover.heightM <= f32::kTallestCoverM) << height << ' ' << up;
          ASSERT_TRUE(cover.radiusM >= 0 && cover.radiusM <= f32::kWidestCoverM) << height << ' ' << up;
          const bool isBare = up <= 0.5f || height <= -2;
          ASSERT_TRUE(!isBare || cover.kind == f32::kNoCover) << height << ' ' << up;
          ASSERT_EQ(cover.kind != f32::kNoCover, cover.heightM > 0);
        }
      }
    }
  }
}

TEST(Stability, Q08_thingsGrowInsideTheirReachAlone) {
  // At any reach and density, 0 and the most among them: the share that is grown falls with the distance from
  // 1 near the eye to 0 at the reach of the lattice.
  for (const double reach : {0.0, 1e-3, 150.0, 300.0}) {
    for (const double density : {0.0, 1e-6, 1.0, 3.0}) {
      for (int level = 0; level < core::shared::f64::kCoverLevels; ++level) {
        const double far = core::shared::f64::coverReach(level, reach, density);
        ASSERT_LE(far, reach);
        if (far <= 0) continue;
        for (const double own : {0.0, 0.5, 0.999}) {
          double before = 1;
          for (int i = 0; i <= 100; ++i) {
            const double grown = core::shared::f64::coverGrown(0.01 * i * far, far, own);
            EXPECT_TRUE(test::holds("Q08", grown - before, test::atMost(1e-12), "of the size"));
            before = grown;
          }
          if (far > 1e-3) {
            EXPECT_EQ(before, 0);
            EXPECT_EQ(core::shared::f64::coverGrown(0.19 * far, far, own), 1);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace skydrop
