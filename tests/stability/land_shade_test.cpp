// The shade that land throws, against rays in double.
#include "skydrop/terrain/land_shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <ostream>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/hills_source.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

constexpr double kRadiusDegrees = core::shared::f64::kSunRadius * 180 / std::numbers::pi;
constexpr ShadeLayout kSmall{2, 256};  // 16 m; 1.5 km with the finest level

LandShade shadeOf(const std::shared_ptr<const HeightSource>& land, glm::dvec2 eye, const glm::dvec3& toSun,
                  const ShadeLayout& layout = kSmall) {
  ShadeHeights heights(land);
  return LandShade::make(heights, shadeKey(layout, eye, toSun));
}

double heightOf(const HeightSource& land, glm::dvec2 xz) { return std::max(land.height(xz), 0.0); }

// Whether the middle of the sun can be seen from the surface at a place: a ray in steps of a quarter of a
// texel at first, which grow with the way.
bool isInSun(const HeightSource& land, glm::dvec2 xz, const glm::dvec3& toSun, double texelM) {
  const double top = land.range().highest, level = std::hypot(toSun.x, toSun.z), rise = toSun.y / level;
  const glm::dvec2 way = glm::dvec2(toSun.x, toSun.z) / level;
  const double from = heightOf(land, xz);
  for (double t = texelM / 4; from + rise * t <= top && t < 1e5; t += texelM / 4 + t / 1000) {
    if (heightOf(land, xz + way * t) > from + rise * t) return false;
  }
  return true;
}

struct Agreement {
  int places = 0, shaded = 0, differ = 0, farOff = 0;  // farOff: no such place within a texel
};

std::ostream& operator<<(std::ostream& out, const Agreement& a) {
  return out << a.places << " places, " << a.shaded << " in shade, " << a.differ << " differ, " << a.farOff
             << " by more than a texel";
}

// At random places that a level shows: does the land there see the sun, and if not so, is there an edge of
// the rays' shadow within a texel?
Agreement compare(const HeightSource& land, const LandShade& shade, int level, glm::dvec2 eye, int places) {
  const ShadeLayout& layout = shade.key().layout;
  const double texel = layout.texelM(level), reach = layout.reachM(level) / 1.5;  // the lattice is sheared
  core::RandomStream random{11, static_cast<std::uint64_t>(level)};
  const auto uniform = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53 * 2 - 1; };
  Agreement result;
  for (int n = 0; n < places; ++n) {
    const glm::dvec2 xz = eye + glm::dvec2(uniform(), uniform()) * reach;
    const bool lit = shade.clearanceAt(level, xz) > 0;
    ++result.places;
    result.shaded += lit ? 0 : 1;
    if (isInSun(land, xz, shade.key().toSun, texel) == lit) continue;
    ++result.differ;
    bool isNear = false;
    for (int k = 0; k < 16 && !isNear; ++k) {
      const double angle = k * std::numbers::pi / 8;
      for (const double share : {0.5, 1.0}) {
        const glm::dvec2 beside = xz + glm::dvec2(std::cos(angle), std::sin(angle)) * (texel * share);
        isNear = isNear || isInSun(land, beside, shade.key().toSun, texel) == lit;
      }
    }
    result.farOff += isNear ? 0 : 1;
  }
  return result;
}

TEST(LandShade, S20_edgesAreWithinATexelOfRays) {
  // Over hills of three sizes, the sun at 1 to 40 degrees, on the lattice's axes, its diagonals and between:
  // where the map and a ray in double disagree (2 % of places), the ray's own shadow has an edge within a
  // texel, for all but one place in 500: at 1 and 3 degrees, where the ray grazes the land. Both levels that
  // resolve the hills.
  const auto land = test::makeHillsSource();
  Agreement all;
  for (const double elevation : {1.0, 3.0, 10.0, 25.0, 40.0}) {
    for (const double azimuth : {0.0, 20.0, 45.0, 90.0, 135.0, 200.0, 265.0, 315.0}) {
      const glm::dvec3 toSun = sky::directionToSun(elevation, azimuth);
      const LandShade shade = shadeOf(land, {700, -900}, toSun);
      for (const int level : {0, 1}) {
        const Agreement here = compare(*land, shade, level, {700, -900}, 60);
        EXPECT_TRUE(test::holds("S20", here.differ, test::atMost(9), "places"))
            << elevation << " up, " << azimuth << ", level " << level << ": " << here;
        all.places += here.places, all.shaded += here.shaded;
        all.differ += here.differ, all.farOff += here.farOff;
      }
    }
  }
  EXPECT_TRUE(test::holds("S20", all.farOff, test::atMost(all.places / 500), "places")) << all;
  EXPECT_TRUE(test::holds("S20", all.differ, test::atMost(all.places / 25), "places")) << all;
  EXPECT_GT(all.shaded, all.places / 5) << all;
}

TEST(LandShade, edgesOnTheShippedLandAreWithinATexelAboveThreeDegrees) {
  // Of all three levels, whose texels of 256 m leave much of the land out: from 6 degrees on no place differs
  // from its ray by more than a texel; at 3 and 1 degrees, where rays graze, 1 and 3 % of places do.
  const auto land = makeNoiseHeightSource({}, 1);
  const glm::dvec2 eye{2500, -1200};
  ShadeHeights heights(land);
  for (const auto& [elevation, most] :
       {std::pair(1.0, 11), std::pair(3.0, 4), std::pair(6.0, 0), std::pair(15.0, 0)}) {
    Agreement all;
    for (const double azimuth : {110.0, 265.0}) {
      const glm::dvec3 toSun = sky::directionToSun(elevation, azimuth);
      const LandShade shade = LandShade::make(heights, shadeKey({2, 512}, eye, toSun));
      for (int level = 0; level < kShadeLevels; ++level) {
        const Agreement here = compare(*land, shade, level, eye, 60);
        all.places += here.places, all.shaded += here.shaded;
        all.differ += here.differ, all.farOff += here.farOff;
      }
    }
    EXPECT_LE(all.farOff, most) << elevation << ": " << all;
    EXPECT_LE(all.differ, all.places / 15) << elevation << ": " << all;
  }
}

TEST(LandShade, S21_aSunAtTheHorizonOrOverheadHasAShade) {
  // Exactly at the horizon, half sunk, at its last edge, in the zenith (no azimuth), and a hair beside all of
  // them: shares are shares. At the horizon all but the highest land of the ray is dark, overhead none is.
  const auto land = test::makeHillsSource();
  for (const double elevation : {-kRadiusDegrees, -0.1, -1e-9, 0.0, 1e-9, 0.1, kRadiusDegrees, 89.9, 90.0}) {
    for (const double azimuth : {0.0, 90.0, 225.0}) {
      glm::dvec3 toSun = sky::directionToSun(elevation, azimuth);
      if (elevation == 90) toSun = {0, 1, 0};
      const LandShade shade = shadeOf(land, {0, 0}, toSun);
      int dark = 0, count = 0;
      for (double x = -1000; x <= 1000; x += 100) {
        for (const double above : {1.0, 100.0, 2000.0}) {
          const double share = shade.sunShare({x, heightOf(*land, {x, 300}) + above, 300});
          ASSERT_TRUE(share >= 0 && share <= 1) << elevation << ' ' << azimuth << ' ' << share;
          if (above == 1) ++count, dark += share < 0.01;
          if (above == 2000) {
            EXPECT_TRUE(test::holds("S21", test::apart(share, 1), test::atMost(1e-6), "share of the sun"))
                << elevation << ' ' << x;
          }
        }
      }
      if (std::abs(elevation) < 0.01) {
        EXPECT_GT(dark, count * 2 / 3) << elevation << ' ' << azimuth;
      }
      if (elevation > 80) {
        EXPECT_TRUE(shade.shaded().empty()) << elevation;
      }
    }
  }
}

TEST(LandShade, S22_levelLandAndTheSeaShadeNothing) {
  // Plains, a plain below the sea, and a sea floor with steps: no texel is dimmed, however low the sun; 1 m
  // over the land all of the sun is left.
  test::noFaults("S22", "violations");
  for (const auto& land :
       {makeFlatSource(300), makeFlatSource(0), makeFlatSource(-100), makeStepSource(0, -200, -20)}) {
    for (const double elevation : {0.0, 0.2, 1.0, 45.0}) {
      const LandShade shade = shadeOf(land, {0, 0}, sky::directionToSun(elevation, 300));
      const double ground = std::max(land->height({5, 5}), 0.0);
      EXPECT_EQ(shade.sunShare({5, ground + 1, 5}), 1) << elevation;
      if (elevation > 0.5) {
        EXPECT_TRUE(shade.shaded().empty()) << elevation;
      }
    }
  }
}

TEST(LandShade, S23_farFromTheOriginTheShadeIsTheSame) {
  // The hills repeat every 61440 m: 1e9 m out, where floats are 64 m apart, the map has the same bits for a
  // sun on the lattice's axes and diagonals, and elsewhere, where its rays fall between others, edges are
  // within a texel.
  test::noFaults("S23", "differences");
  const auto land = test::makeHillsSource();
  const double away = 61440.0 * 16384;
  for (const double azimuth : {0.0, 90.0, 270.0}) {
    const glm::dvec3 toSun = sky::directionToSun(5, azimuth);
    const LandShade here = shadeOf(land, {700, -900}, toSun);
    const LandShade there = shadeOf(land, {700 + away, -900 - away}, toSun);
    for (int level = 0; level < kShadeLevels; ++level) {
      const auto& a = here.clearances(level);
      const auto& b = there.clearances(level);
      int largest = 0;
      for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(int{a[i]} - int{b[i]}));
      EXPECT_EQ(largest, 0) << azimuth << ", level " << level;
    }
  }
  const glm::dvec2 eye(700 + away, -900 - away);
  const LandShade there = shadeOf(land, eye, sky::directionToSun(5, 200));
  const Agreement agreement = compare(*land, there, 0, eye, 300);
  EXPECT_EQ(agreement.farOff, 0) << agreement;
}

TEST(LandShade, S24_thePenumbraWidensWithTheDistance) {
  // Behind a ridge across the sun's way, in the air and on the ground: the height over which a quarter to
  // three quarters of the disc are hidden grows as the disc's width seen from the crest, within 2 %.
  const auto land = makeRidgeSource(0, 900, 1.5, 0);
  int count = 0;
  for (const double elevation : {3.0, 8.0, 20.0}) {
    const LandShade shade = shadeOf(land, {-1000, 0}, sky::directionToSun(elevation, 90), {2, 512});
    for (const double distance : {700.0, 1500.0, 3000.0}) {
      const auto at = [&](double y) { return shade.sunShare({-distance, y, 13}); };
      const auto heightOfShare = [&](double share) {
        double low = -4000, high = 4000;
        for (int i = 0; i < 60; ++i) (at((low + high) / 2) < share ? low : high) = (low + high) / 2;
        return low;
      };
      const auto top = [&](double degrees) { return 900 - distance * std::tan(glm::radians(degrees)); };
      const double umbra = top(elevation + kRadiusDegrees), lit = top(elevation - kRadiusDegrees);
      if (umbra < 20) continue;  // the shadow ends before
      ++count;
      EXPECT_TRUE(test::holds("S24", test::apart(heightOfShare(0.5), (umbra + lit) / 2),
                              test::atMost(0.02 * (lit - umbra) + 0.1), "m"))
          << elevation << ' ' << distance;
      // Of a disc, a quarter is hidden where the edge is 0.404 radii from its middle.
      EXPECT_TRUE(test::holds("S24",
                              test::apart(heightOfShare(0.75) - heightOfShare(0.25), 0.404 * (lit - umbra)),
                              test::atMost(0.02 * (lit - umbra)), "m"))
          << elevation << ' ' << distance;
    }
  }
  EXPECT_EQ(count, 8);
}

TEST(LandShade, S25_anEdgeBeforeTheLowerLimbLeavesTheRestOfTheDisc) {
  // A far ridge whose crest stands before the sun's lower part, over level ground at which the upper limb's
  // rays meet nothing but the ground itself: the share is that of the disc above the crest, from all of it to
  // none, for every detail, on the ground and in the air above it.
  const double height = 900, elevation = 2;
  const auto land = makeRidgeSource(0, height, 1.5, 40);
  const glm::dvec3 toSun = sky::directionToSun(elevation, 90);
  for (const ShadeLayout& layout : {ShadeLayout{3, 256}, ShadeLayout{2, 512}, ShadeLayout{0, 2048}}) {
    int partly = 0;
    for (double away = 18000; away <= 30000; away += 1500) {
      const LandShade shade = shadeOf(land, {-away, 0}, toSun, layout);
      for (const double above : {0.0, 30.0, 200.0}) {
        const double edge = glm::degrees(std::atan((height - 40 - above) / away));
        const double expected = shareOfDisc((elevation - edge) / kRadiusDegrees);
        const double found = above > 0 ? shade.sunShare({-away, 40 + above, 13})
                                       : shareOfDisc(shade.clearanceAt(0, {-away, 13}));
        EXPECT_TRUE(test::holds("S25", test::apart(found, expected), test::atMost(0.02), "share of the sun"))
            << layout.side << ' ' << away << ' ' << above;
        partly += expected > 0.1 && expected < 0.9 ? 1 : 0;
      }
    }
    EXPECT_GE(partly, 5) << layout.side;
  }
}

TEST(LandShade, theShareOfADiscIsThatOfItsSegment) {
  for (double q = -1.5; q <= 1.5; q += 0.01) {
    const double x = std::clamp(q, -1.0, 1.0);
    const double exact = 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
    EXPECT_NEAR(shareOfDisc(q), exact, 0.0013) << q;
  }
}

TEST(LandShade, aPlaceHasTheSameShadeWhereverTheEyeIs) {
  // The eye moves 2 km in uneven steps; shares of the sun at places in the finest level's reach are the same
  // bits.
  const auto land = test::makeHillsSource();
  const glm::dvec3 toSun = sky::directionToSun(4, 130);
  std::vector<double> before;
  for (double eye = -500; eye <= 500; eye += 93) {
    const LandShade shade = shadeOf(land, {eye, 0.3 * eye}, toSun, {2, 512});
    std::vector<double> now;
    for (double x = -1000; x <= 1000; x += 37) now.push_back(shade.clearanceAt(0, {x, 0.7 * x}));
    if (!before.empty()) {
      for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], before[i], 0.05) << eye << ' ' << i;
    }
    before = now;
  }
}

TEST(LandShade, boxesHoldAllThatIsShaded) {
  const auto land = test::makeHillsSource();
  const LandShade shade = shadeOf(land, {0, 0}, sky::directionToSun(8, 200));
  int shaded = 0;
  for (double x = -1000; x <= 1000; x += 50) {
    for (double z = -1000; z <= 1000; z += 50) {
      if (shade.clearanceAt(0, {x, z}) >= 1) continue;
      ++shaded;
      const glm::dvec3 place(x, heightOf(*land, {x, z}), z);
      EXPECT_TRUE(std::ranges::any_of(shade.shaded(),
                                      [&](const Box& box) {
                                        return glm::all(glm::lessThanEqual(box.lo, place)) &&
                                               glm::all(glm::lessThanEqual(place, box.hi));
                                      }))
          << x << ' ' << z;
    }
  }
  EXPECT_GT(shaded, 200);
}

}  // namespace
}  // namespace skydrop::terrain
