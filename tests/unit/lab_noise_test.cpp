// The parts of noise that the laboratory shows, against the noise that the game uses whole.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "skydrop/lab/noise_measure.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

glm::dvec3 insideOf(int i) {
  const auto part = [i](double step) { return std::fmod(0.37 + step * i, 1.0); };
  return {part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703)};
}

TEST(LabNoise, thePartsOfPerlinNoiseAddUpToTheGamesNoise) {
  // In the plane and in space, with the fade: to the rounding of sums in another order.
  constexpr std::uint32_t kCells = 7, kSalt = 12345;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 inside = insideOf(i);
    const glm::u32vec3 cell(i % 7, (i / 7) % 7, (i / 49) % 7);
    EXPECT_NEAR(f64::perlinOfParts(glm::u32vec2(cell), glm::dvec2(inside), kCells, kSalt, true),
                f64::gradientNoise2(glm::u32vec2(cell), glm::dvec2(inside), kCells, kSalt), 1e-14);
    EXPECT_NEAR(f64::perlinInSpaceOfParts(cell, inside, kCells, kSalt, true),
                f64::gradientNoise3(cell, inside, kCells, kSalt), 1e-14);
    EXPECT_NEAR(f32::perlinOfParts(glm::u32vec2(cell), glm::vec2(inside), kCells, kSalt, true),
                f64::gradientNoise2(glm::u32vec2(cell), glm::dvec2(inside), kCells, kSalt), 5e-6);
  }
}

TEST(LabNoise, weightsAreSharesAndNodesAreZero) {
  for (int i = 0; i < 200; ++i) {
    for (const bool faded : {false, true}) {
      const glm::dvec4 weights = f64::cornerWeights(glm::dvec2(insideOf(i)), faded);
      EXPECT_NEAR(weights.x + weights.y + weights.z + weights.w, 1, 1e-15);
      EXPECT_GE(std::min({weights.x, weights.y, weights.z, weights.w}), 0);
      EXPECT_EQ(f64::perlinOfParts({i % 5, i % 3}, {0, 0}, 5, 1, faded), 0);
    }
  }
}

TEST(LabNoise, theFadeTakesTheGridOutOfTheSlope) {
  const auto noise = [](bool faded) {
    return [faded](double x, double y) {
      const glm::dvec2 at = glm::dvec2(x, y) * 10.0, whole = glm::floor(at);
      return f64::perlinOfParts(glm::u32vec2(whole), at - whole, 10, 3, faded);
    };
  };
  EXPECT_GT(smoothnessOf(noise(false), 10).largestSlopeJump, 5);
  EXPECT_LT(smoothnessOf(noise(true), 10).largestSlopeJump, 1e-3);
  EXPECT_LT(smoothnessOf(noise(false), 10).largestJump, 1e-4);
}

TEST(LabNoise, nineCellsHoldTheNearestSeedAndOneDoesNot) {
  // Against all seeds of the period, by brute force.
  constexpr std::uint32_t kCells = 6, kSalt = 2;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 place(insideOf(i));
    double nearest = 9;
    for (int y = -1; y <= 6; ++y) {
      for (int x = -1; x <= 6; ++x) {
        const glm::dvec2 seed = f64::voronoiSeed(static_cast<std::uint32_t>((x + 6) % 6),
                                                 static_cast<std::uint32_t>((y + 6) % 6), kSalt);
        nearest = std::min(nearest, glm::length(glm::dvec2(x, y) + seed - place * 6.0));
      }
    }
    EXPECT_NEAR(f64::nearVoronoi(place, kCells, kSalt), nearest, 1e-14);
    EXPECT_GE(f64::ownVoronoi(place, kCells, kSalt), nearest - 1e-14);
  }
  const OwnCellError own = ownCellError({});
  EXPECT_GT(own.wrongShare, 0.2);
  EXPECT_GT(own.meanError, 0.02);
}

TEST(LabNoise, octavesAreAWeightedMeanOfTheFirst) {
  // One octave is the noise itself; more stay within its range and lose of its deviation; a gain of 0 adds
  // nothing.
  const glm::dvec2 place(0.317, 0.743);
  EXPECT_EQ(f64::perlinFractal(place, 5, 1, 0.5, 9), f64::perlinPlane(place, 5, 9));
  EXPECT_EQ(f64::perlinFractal(place, 5, 10, 0, 9), f64::perlinPlane(place, 5, 9));
  EXPECT_NEAR(f64::perlinFractal(place, 5, 2, 0.5, 9),
              (f64::perlinPlane(place, 5, 9) + 0.5 * f64::perlinPlane(place, 10, 10)) / 1.5, 1e-15);
  EXPECT_EQ(f64::perlinFractal(place, 5, 0, 0.5, 9), 0);
  EXPECT_EQ(f64::voronoiFractal(place, 5, 1, 0.5, 9), f64::nearVoronoi(place, 5, 9));
}

TEST(LabNoise, theSpectrumOfASineIsOneLine) {
  const Curve lines = spectrumOf([](double x, double) { return std::sin(2 * 3.14159265358979 * 2 * x); });
  // Three of the places round to a frequency of 2; beside them there is nothing.
  EXPECT_NEAR(std::accumulate(lines.begin(), lines.end(), 0.0f), 3, 1e-3);
  EXPECT_EQ(*std::max_element(lines.begin(), lines.end()), 1);
  for (const std::size_t place : {3, 4, 5}) EXPECT_GT(lines[place], 0.99f);
  const Curve flat = histogramOf([](double x, double) { return x; }, 0, 1);
  EXPECT_GT(*std::min_element(flat.begin(), flat.end()), 0.8f);
}

}  // namespace
}  // namespace skydrop::lab
