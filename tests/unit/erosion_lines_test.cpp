// Rills on slopes (shaders/shared/erosion_lines.glsl): where they run, how deep, and what they leave as it
// was.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared_erosion_lines.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f32;
namespace exact = core::shared::f64;

constexpr double kChunkM = 960;

// Of land that falls everywhere alike, at a place (m from the corner of a chunk), with so many octaves.
exact::Erosion erosionAt(std::int64_t chunkX, std::int64_t chunkZ, const glm::dvec2& place,
                         const glm::dvec2& fall, double footprintM = 0.05,
                         int octaves = shared::kErosionOctaves) {
  exact::Erosion erosion = exact::uneroded(fall);
  for (int i = 0; i < octaves; ++i) {
    const double cellM = kChunkM / shared::erosionCells(i);
    const glm::dvec2 whole = glm::floor(place / cellM);
    const auto cellOf = [i](std::int64_t chunk, double in) {
      return static_cast<std::uint32_t>(chunk * shared::erosionCells(i) + static_cast<std::int64_t>(in));
    };
    erosion = exact::eroded(erosion, i, {cellOf(chunkX, whole.x), cellOf(chunkZ, whole.y)},
                            place / cellM - whole, cellM, footprintM, 1);
  }
  return erosion;
}

// The height that the rills take from the land there, m.
double depthAt(const glm::dvec2& place, const glm::dvec2& fall, int octave) {
  const double before = octave == 0 ? 0 : erosionAt(3, -4, place, fall, 0.05, octave).cut;
  return (erosionAt(3, -4, place, fall, 0.05, octave + 1).cut - before) * exact::erosionDepthM(octave);
}

glm::dvec2 randomPlace(core::RandomStream& random) {
  return {random.nextUnit() * 5000, random.nextUnit() * 5000};
}

TEST(ErosionLines, runDownTheSlope) {
  // Along the fall line the depth of the coarsest rills changes by a third of what it does across, and the
  // smaller ones, which run into them at an angle, by less than half. (Noise without a direction: as much.)
  core::RandomStream random{11, 0};
  for (const double turn : {0.0, 0.4, 1.1, 2.9}) {
    const glm::dvec2 down(std::cos(turn), std::sin(turn)), across(-down.y, down.x);
    for (int octave = 0; octave < shared::kErosionOctaves; ++octave) {
      const double stepM = 0.08 * kChunkM / shared::erosionCells(octave);
      double along = 0, aside = 0;
      for (int i = 0; i < 4000; ++i) {
        const glm::dvec2 place = randomPlace(random);
        const double here = depthAt(place, 0.5 * down, octave);
        along += std::abs(depthAt(place + stepM * down, 0.5 * down, octave) - here);
        aside += std::abs(depthAt(place + stepM * across, 0.5 * down, octave) - here);
      }
      std::printf("[ rills ] octave %d towards %.1f: %.2f\n", octave, turn, along / aside);
      EXPECT_LT(along / aside, octave == 0 ? 1.0 / 3 : 0.5) << turn;
    }
  }
}

TEST(ErosionLines, haveTheirSlope) {
  // What is drawn as slope is that of the depth: of the coarsest octave, where the waves' blend alone is left
  // out, correlated by .95 with differences over 20 cm across the rills, and as large within a tenth.
  core::RandomStream random{12, 0};
  const glm::dvec2 fall(0.3, 0.4), across(-0.8, 0.6);
  double ab = 0, aa = 0, bb = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 place = randomPlace(random);
    const double drawn = glm::dot(glm::dvec2(erosionAt(3, -4, place, fall, 0.05, 1).slope), across);
    const double is =
        -(depthAt(place + 0.1 * across, fall, 0) - depthAt(place - 0.1 * across, fall, 0)) / 0.2;
    ab += drawn * is, aa += drawn * drawn, bb += is * is;
  }
  EXPECT_GT(ab / std::sqrt(aa * bb), 0.95);
  EXPECT_NEAR(std::sqrt(aa / bb), 1, 0.1);
}

TEST(ErosionLines, K08_patternStaysPutFarOut) {
  // The same ground seen from two bases a chunk apart, near the origin and 1e9 m out, in float: the depth of
  // the cut is the same within a hundredth. Level ground, where no way is down, has finite rills.
  core::RandomStream random{13, 0};
  const auto cutAt = [](std::int64_t chunkX, std::int64_t chunkZ, const glm::dvec2& place,
                        const glm::dvec2& fall) {
    shared::Erosion erosion = shared::uneroded(shared::Vec2(fall));
    for (int i = 0; i < shared::kErosionOctaves; ++i) {
      const int cells = shared::erosionCells(i);
      const glm::vec2 scaled = glm::vec2(place) * (static_cast<float>(cells) / static_cast<float>(kChunkM));
      const glm::vec2 whole = glm::floor(scaled);
      const auto cellOf = [cells](std::int64_t chunk, float in) {
        return static_cast<std::uint32_t>(chunk * cells + static_cast<std::int64_t>(in));
      };
      erosion = shared::eroded(erosion, i, {cellOf(chunkX, whole.x), cellOf(chunkZ, whole.y)}, scaled - whole,
                               static_cast<float>(kChunkM) / static_cast<float>(cells), 0.05f, 1);
    }
    return erosion;
  };
  double worst = 0;
  for (const std::int64_t far : {0, 1041666, -1041666}) {  // 1e9 m / 960 m
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec2 place(random.nextUnit() * 1900, random.nextUnit() * 1900);
      const double turn = random.nextUnit() * 6.283, steep = random.nextUnit() < 0.1 ? 0 : random.nextUnit();
      const glm::dvec2 fall(steep * std::cos(turn), steep * std::sin(turn));
      const shared::Erosion here = cutAt(far, far, place, fall);
      const shared::Erosion there = cutAt(far + 1, far - 2, place - glm::dvec2(kChunkM, -2 * kChunkM), fall);
      ASSERT_TRUE(std::isfinite(here.slope.x + here.slope.y + here.cut));
      worst = std::max(worst, test::apart(here.cut, there.cut));
    }
  }
  EXPECT_TRUE(test::holds("K08", worst, test::atMost(0.02), "of the depth"));
}

TEST(ErosionLines, K09_meanOfTheLandStays) {
  // Over kilometres the cut has the mean 0 within a hundredth of a rill's depth, near by and where rills
  // fade, so colour and snow line stay where they were.
  double worst = 0;
  for (const double footprintM : {0.05, 3.0, 20.0}) {
    core::RandomStream random{14, 0};
    double sum = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
      const double turn = random.nextUnit() * 6.283;
      sum +=
          erosionAt(3, -4, randomPlace(random), {0.5 * std::cos(turn), 0.5 * std::sin(turn)}, footprintM).cut;
    }
    worst = std::max(worst, std::abs(sum / kCount));
  }
  EXPECT_TRUE(test::holds("K09", worst, test::atMost(0.02), "of the depth"));
}

TEST(ErosionLines, fadeWhereAPixelCannotShowThem) {
  // Of a rill's spacing a pixel may cover a sixth; where it covers half of it nothing is left.
  for (int octave = 0; octave < shared::kErosionOctaves; ++octave) {
    const float cellM = static_cast<float>(kChunkM) / static_cast<float>(shared::erosionCells(octave));
    const float spacingM = cellM / shared::kErosionTurns;
    EXPECT_EQ(shared::erosionShown(cellM, spacingM / 6.1f), 1);
    EXPECT_EQ(shared::erosionShown(cellM, spacingM / 1.99f), 0);
  }
  const glm::dvec2 fall(0.5, 0);
  EXPECT_EQ(erosionAt(0, 0, {100, 200}, fall, 30).cut, 0);
}

TEST(ErosionLines, neitherOnLevelGroundNorOnCliffs) {
  const shared::LandNoise none{};
  EXPECT_EQ(shared::erosionStrength(1, none), 0);
  EXPECT_EQ(shared::erosionStrength(0.99f, none), 0);     // 8 degrees
  EXPECT_GT(shared::erosionStrength(0.85f, none), 0.5f);  // 32 degrees
  EXPECT_EQ(shared::erosionStrength(0.44f, none), 0);     // 64 degrees
  EXPECT_EQ(shared::erosionStrength(0, none), 0);
}

}  // namespace
}  // namespace skydrop::terrain
